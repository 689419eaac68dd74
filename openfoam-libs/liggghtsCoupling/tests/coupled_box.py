"""A small box of fluid with grains: the case that the tests of the coupling run.

The box is 20 mm x 20 mm x 40 mm, 10 x 10 x 20 cells, periodic in all directions unless
walls or a flow through are asked for; laminar, so that nothing hides what the grains do.
"""

import pathlib

HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"

# what a solver prints after the momentum equation: an error that comes before has cost no time
SOLVED = "Solving for (U|p,|p_rgh,)"

# what a new run begins with, and a continued one finds in its restart file
NEW = """
region box block {box} units box
create_box 1 box
{grains}
"""

SCRIPT = """
plugin load fluidforceplugin.so
{plugins}
units si
atom_style granular
atom_modify map array sort 0 0
boundary {boundary}
newton off
communicate single vel yes
{processors}
if "${{continued}}" then "jump SELF continued"
include constant/new.grains
jump SELF ready
label continued
read_restart ${{restart}}
label ready
neighbor 0.0005 bin
neigh_modify delay 0 binsize 0.002
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.2
timestep {dt}
fix move all nve/sphere
{gravity}
{fixes}
fix fluid all fluid/force coupled
thermo 1000
{end}
"""


def grains(positions, velocities, diameter=2e-4, density=2500.0):
    """Commands that create single grains with given positions and velocities."""
    lines = []
    for i, (x, v) in enumerate(zip(positions, velocities), start=1):
        lines.append("create_atoms 1 single {} {} {} units box".format(*map(repr, map(float, x))))
        lines.append(
            "set atom {} diameter {!r} density {!r} vx {!r} vy {!r} vz {!r}".format(
                i, diameter, density, *map(float, v)))
    return "\n".join(lines)


def script(folder, *, grains, dt=1e-5, gravity="", fixes="", plugins="", processors="",
           box="0 0.02 0 0.02 0 0.04", boundary="p p p", end="", name="in.particles"):
    """Write the input script of LIGGGHTS into constant/."""
    constant = pathlib.Path(folder) / "constant"
    (constant / "new.grains").write_text(NEW.format(box=box, grains=grains))
    (constant / name).write_text(SCRIPT.format(
        dt=dt, gravity=gravity, fixes=fixes, plugins=plugins, processors=processors,
        boundary=boundary, end=end))


def fv_options(folder, text="", **entries):
    """Write constant/fvOptions; entries replace the defaults, None removes one."""
    values = {
        "type": "liggghtsCoupling",
        "script": '"constant/in.particles"',
        "couplingInterval": "10",
        "coupling": "twoWay",
        "voidFraction": "{ model divided; minimum 0.3; }",
        "drag": "Gidaspow",
        "forces": "(pressureGradient viscous)",
        "interpolation": "cellPoint",
        "momentum": "implicit",
    }
    values.update(entries)
    lines = [f"    {k} {v}{'' if str(v).startswith('{') else ';'}"
             for k, v in values.items() if v is not None]
    body = "particles\n{\n" + "\n".join(lines) + "\n" + text + "\n}\n"
    (pathlib.Path(folder) / "constant" / "fvOptions").write_text(
        HEADER.format("dictionary", "fvOptions") + body)


def write(folder, *, velocity="(0 0 0)", walls=False, delta_t=1e-4, steps=20, write_every=None,
          rho="rho [1 -3 0 0 0 0 0] 1.2;", nu=1.5e-5, functions="", control="", correctors="",
          libs='("libliggghtsCoupling.so")', decomposition="(1 1 2)", ranks=2,
          cells="10 10 20", size=(20, 20, 40), through=False, convection="linear"):
    """Write the fluid side of the case; size in mm. through: the fluid enters at zlo with the given
    velocity and leaves at zhi."""
    folder = pathlib.Path(folder)
    for part in ("system", "constant", "0"):
        (folder / part).mkdir(parents=True, exist_ok=True)

    def put(path, cls, body):
        (folder / path).write_text(HEADER.format(cls, path.split("/")[-1]) + body)

    faces = {"xlo": "(0 4 7 3)", "xhi": "(1 2 6 5)", "ylo": "(0 1 5 4)",
             "yhi": "(3 7 6 2)", "zlo": "(0 3 2 1)", "zhi": "(4 5 6 7)"}
    other = {"lo": "hi", "hi": "lo"}

    def kind(name):
        if through and name[0] == "z":
            return "patch"
        return "wall" if walls else f"cyclic; neighbourPatch {name[0]}{other[name[1:]]}"

    patches = "".join(f"{name} {{ type {kind(name)}; faces ({face}); }}\n"
                      for name, face in faces.items())
    x, y, z = size
    put("system/blockMeshDict", "dictionary", f"""
scale 0.001;
vertices ((0 0 0) ({x} 0 0) ({x} {y} 0) (0 {y} 0) (0 0 {z}) ({x} 0 {z}) ({x} {y} {z}) (0 {y} {z}));
blocks (hex (0 1 2 3 4 5 6 7) ({cells}) simpleGrading (1 1 1));
boundary ({patches});
""")
    put("system/controlDict", "dictionary", f"""
application pimpleFoam;
libs {libs};
startFrom latestTime; stopAt endTime; endTime {delta_t * steps!r};
deltaT {delta_t!r}; writeControl timeStep; writeInterval {write_every or steps};
writeFormat ascii; writePrecision 17; timePrecision 10; runTimeModifiable no;
{control}
functions {{ {functions} }}
""")
    put("system/fvSchemes", "dictionary", f"""
ddtSchemes {{ default Euler; }}
gradSchemes {{ default Gauss linear; }}
divSchemes {{ default Gauss linear; div(phi,U) Gauss {convection}; }}
laplacianSchemes {{ default Gauss linear corrected; }}
interpolationSchemes {{ default linear; }}
snGradSchemes {{ default corrected; }}
""")
    put("system/fvSolution", "dictionary", f"""
solvers
{{
    "p.*" {{ solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0; }}
    "U.*" {{ solver PBiCGStab; preconditioner DILU; tolerance 1e-14; relTol 0; }}
}}
PIMPLE {{ {correctors or 'nOuterCorrectors 1; nCorrectors 2;'} nNonOrthogonalCorrectors 0;
          pRefCell 0; pRefValue 0; }}
""")
    put("system/decomposeParDict", "dictionary",
        f"numberOfSubdomains {ranks}; method simple;\n"
        f"simpleCoeffs {{ n {decomposition}; delta 1e-6; }}\n")
    put("constant/transportProperties", "dictionary",
        f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {nu!r};\n{rho}\n")
    put("constant/turbulenceProperties", "dictionary", "simulationType laminar;\n")

    wall_u = "type noSlip;" if walls else "type cyclic;"
    wall_p = "type zeroGradient;" if walls else "type cyclic;"
    open_u = f"zlo {{ type fixedValue; value uniform {velocity}; }} zhi {{ type zeroGradient; }}"
    open_p = "zlo { type zeroGradient; } zhi { type fixedValue; value uniform 0; }"
    put("0/U", "volVectorField",
        f'dimensions [0 1 -1 0 0 0 0]; internalField uniform {velocity};\n'
        f'boundaryField {{ ".*" {{ {wall_u} }} {open_u if through else ""} }}\n')
    put("0/p", "volScalarField",
        'dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;\n'
        f'boundaryField {{ ".*" {{ {wall_p} }} {open_p if through else ""} }}\n')


def read_internal(path):
    """Internal field of an ascii field file as a list of floats or of 3-tuples."""
    text = pathlib.Path(path).read_text()
    start = text.index("internalField")
    rest = text[start:text.index("boundaryField", start)]
    if "nonuniform" not in rest:
        value = rest.split("uniform", 1)[1].split(";")[0].strip()
        return [_number(value)]
    body = rest[rest.index("\n(") + 2:rest.rindex(")")]
    return [_number(line) for line in body.split("\n") if line.strip()]


def _number(word):
    word = word.strip()
    if word.startswith("("):
        return tuple(float(c) for c in word.strip("()").split())
    return float(word)


def read_dump(path):
    """The last snapshot of a LIGGGHTS dump with columns id ...: {id: [values]}."""
    lines = pathlib.Path(path).read_text().splitlines()
    at = max(i for i, line in enumerate(lines) if line.startswith("ITEM: ATOMS"))
    rows = (line.split() for line in lines[at + 1:])
    return {int(row[0]): [float(c) for c in row[1:]] for row in rows}


def read_balance(folder, start="0"):
    """The columns of balance.dat of the run that began at a time: {name: [values]}."""
    path = pathlib.Path(folder) / f"postProcessing/liggghtsCoupling/{start}/balance.dat"
    lines = path.read_text().splitlines()
    names = [line for line in lines if line.startswith("#")][-1].lstrip("# ").split()
    rows = [[float(c) for c in line.split()] for line in lines if not line.startswith("#")]
    return {name: [row[k] for row in rows] for k, name in enumerate(names)}
