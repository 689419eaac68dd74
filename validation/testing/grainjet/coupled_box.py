# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A small box of fluid with grains: the case that the tests of the coupling run.

The box is 20 mm x 20 mm x 40 mm, 10 x 10 x 20 cells, periodic in all directions unless
walls or a flow through are asked for; laminar, so that nothing hides what the grains do.
"""

import pathlib
import random

from grainjet import dictionaries, dumps, scripts, tables
from grainjet.case import Case

# columns of a dump that tell how grains move
MOTION = "id x y z vx vy vz"

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
{move}
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
           box="0 0.02 0 0.02 0 0.04", boundary="p p p", end="", name="in.particles", move="fix move all nve/sphere"):
    """Write the input script of LIGGGHTS into constant/."""
    constant = pathlib.Path(folder) / "constant"
    (constant / "new.grains").write_text(NEW.format(box=box, grains=grains))
    (constant / name).write_text(SCRIPT.format(
        dt=dt, gravity=gravity, fixes=fixes, plugins=plugins, processors=processors,
        boundary=boundary, end=end, move=move))


def void_fraction(equations, model="divided", minimum=0.3):
    """The entry voidFraction of the coupling."""
    return f"{{ model {model}; minimum {minimum}; equations {equations}; }}"


def fv_options(folder, text="", **entries):
    """Write constant/fvOptions; entries replace the defaults, None removes one. The solver's equations are
    without void fraction, unless an entry says otherwise."""
    values = {
        "type": "liggghtsCoupling",
        "script": '"constant/in.particles"',
        "couplingInterval": "10",
        "coupling": "twoWay",
        "voidFraction": void_fraction("neglected"),
        "drag": "Gidaspow",
        "forces": "(pressureGradient viscous)",
        "interpolation": "cellPoint",
        "momentum": "implicit",
    }
    values.update(entries)
    dictionaries.write(pathlib.Path(folder) / "constant/fvOptions",
                       f"particles\n{{\n{dictionaries.entries(values)}{text}\n}}\n")


def write(folder, *, velocity="(0 0 0)", walls=False, delta_t=1e-4, steps=20, write_every=None,
          rho="rho [1 -3 0 0 0 0 0] 1.2;", nu=1.5e-5, functions="", control="", correctors="",
          libs='("libliggghtsCoupling.so")', decomposition="(1 1 2)", ranks=2,
          cells="10 10 20", size=(20, 20, 40), through=False, convection="linear"):
    """Write the fluid side of the case; size in mm. through: the fluid enters at zlo with the given
    velocity and leaves at zhi."""
    folder = pathlib.Path(folder)
    for part in ("system", "constant", "0"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    other = {"lo": "hi", "hi": "lo"}

    def kind(side):
        if through and side[0] == "z":
            return "patch"
        return "wall" if walls else f"cyclic; neighbourPatch {side[0]}{other[side[1:]]}"

    dictionaries.write(folder / "system/blockMeshDict", dictionaries.block(
        (0, 0, 0), size, cells, {side: (kind(side), side) for side in dictionaries.SIDES}, scale=0.001))
    dictionaries.write(folder / "system/controlDict", f"""
application pimpleFoam;
libs {libs};
startFrom latestTime; stopAt endTime; endTime {delta_t * steps!r};
deltaT {delta_t!r}; writeControl timeStep; writeInterval {write_every or steps};
writeFormat ascii; writePrecision 17; timePrecision 10; runTimeModifiable no;
{control}
functions {{ {functions} }}
""")
    dictionaries.write(folder / "system/fvSchemes", f"""
ddtSchemes {{ default Euler; }}
gradSchemes {{ default Gauss linear; }}
divSchemes {{ default Gauss linear; div(phi,U) Gauss {convection}; }}
laplacianSchemes {{ default Gauss linear corrected; }}
interpolationSchemes {{ default linear; }}
snGradSchemes {{ default corrected; }}
""")
    dictionaries.write(folder / "system/fvSolution", f"""
solvers
{{
    "p.*" {{ solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0; }}
    "U.*" {{ solver PBiCGStab; preconditioner DILU; tolerance 1e-14; relTol 0; }}
}}
PIMPLE {{ {correctors or 'nOuterCorrectors 1; nCorrectors 2;'} nNonOrthogonalCorrectors 0;
          pRefCell 0; pRefValue 0; }}
""")
    dictionaries.write(folder / "system/decomposeParDict", f"numberOfSubdomains {ranks}; method simple;\n"
        f"simpleCoeffs {{ n {decomposition}; delta 1e-6; }}\n")
    dictionaries.write(folder / "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {nu!r};\n{rho}\n")
    dictionaries.write(folder / "constant/turbulenceProperties", "simulationType laminar;\n")

    wall_u = "type noSlip;" if walls else "type cyclic;"
    wall_p = "type zeroGradient;" if walls else "type cyclic;"
    open_u = f"zlo {{ type fixedValue; value uniform {velocity}; }} zhi {{ type zeroGradient; }}"
    open_p = "zlo { type zeroGradient; } zhi { type fixedValue; value uniform 0; }"
    dictionaries.write_field(folder, "U", "0 1 -1", velocity, f'".*" {{ {wall_u} }} {open_u if through else ""}')
    dictionaries.write_field(folder, "p", "0 2 -2", 0, f'".*" {{ {wall_p} }} {open_p if through else ""}')


def swarm(n, seed, low=(0, 0, 0), high=(0.02, 0.02, 0.04), mean=(0, 0, 1), rms=0.3):
    """Positions and velocities of n grains, spread at random."""
    rng = random.Random(seed)
    x = [[rng.uniform(a + 1e-3, b - 1e-3) for a, b in zip(low, high)] for _ in range(n)]
    v = [[rng.gauss(m, rms) for m in mean] for _ in range(n)]
    return x, v


def end_at(folder, steps):
    """Change the time at which the run ends, to a number of fluid steps of 1e-4 s."""
    dictionaries.put(pathlib.Path(folder) / "system/controlDict", endTime=f"{steps * 1e-4:.10g}")


def read_balance(folder, start="0"):
    """The columns of balance.dat of the run that began at a time: {name: [values]}."""
    table = tables.read(pathlib.Path(folder) / f"postProcessing/liggghtsCoupling/{start}/balance.dat")
    return {name: values.tolist() for name, values in table.items()}


_create = grains      # run_box has a parameter of that name


class CoupledCase(Case):
    """A test that runs the box and compares runs."""

    def run_box(self, ranks=0, steps=20, grains=None, solver="pimpleFoam", options=None,
                boundary="p p p", processors="", diameter=2e-4, ranks_in_case=2,
                box_of_grains="0 0.02 0 0.02 0 0.04", density=2500.0, fixes="", into=None,
                **fluid):
        """Run the box in a folder of its own; returns the folder with reconstructed fields. options False: the
        fluid alone."""
        folder = into or self.new_folder()
        write(folder, steps=steps, ranks=ranks_in_case, **fluid)
        if options is not False:
            x, v = grains or swarm(300, 7)
            script(folder, grains=_create(x, v, diameter, density), boundary=boundary, fixes=fixes,
                   box=box_of_grains, processors=processors, end=scripts.dump(10 * steps, "grains.dump", MOTION))
            fv_options(folder, **(options or {}))
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.result = self.foam(solver, folder, ranks)
        if ranks:
            self.foam("reconstructPar", folder)
        return folder

    def compare(self, a, b, time, tolerance):
        """Fields and grains of two runs agree relative to the largest value."""
        for field in ("U", "voidFraction", "particleVelocity", "dragCoefficient",
                      "particleMomentumSource"):
            first, second = (dictionaries.internal(run / time / field) for run in (a, b))
            self.assertEqual(len(first), len(second), field)
            flat = [_flat(first), _flat(second)]
            scale = max(abs(c) for c in flat[0])
            worst = max(abs(p - q) for p, q in zip(*flat))
            self.assertGreater(scale, 0, field)
            self.assertLessEqual(worst, tolerance * scale, field)
        one, two = dumps.last(a / "grains.dump"), dumps.last(b / "grains.dump")
        self.assertEqual(sorted(one), sorted(two))
        self.assertTrue(one, "no grain is left to compare")
        for tag in one:
            for p, q in zip(one[tag], two[tag]):
                self.assertAlmostEqual(p, q, delta=tolerance, msg=f"grain {tag}")


def _flat(values):
    return [c for v in values for c in (v if isinstance(v, tuple) else (v,))]
