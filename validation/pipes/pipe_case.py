# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes and runs a periodic pipe with grains: pimpleFoam with k-epsilon and wall functions, a force that holds the bulk
velocity, LIGGGHTS periodic along the axis. The axis is z, the flow goes along +z; `up`: gravity along -z, `horizontal`: along -y."""

import math
import shutil
import subprocess

import grainjet
from grainjet import dictionaries

SCHEMES = """
ddtSchemes { default %(ddt)s; }
gradSchemes { default Gauss linear; limited cellLimited Gauss linear 1; }
divSchemes
{
    default none;
    div(phi,U) %(bounded)sGauss linearUpwind grad(U);
    div(phi,k) %(bounded)sGauss upwind;
    div(phi,epsilon) %(bounded)sGauss upwind;
    div((nuEff*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
wallDist { method meshWave; }
"""

SOLUTION = """
solvers
{
    p { solver PCG; preconditioner DIC; tolerance 1e-7; relTol 0.01; }
    pFinal { solver PCG; preconditioner DIC; tolerance 1e-7; relTol %(relTol)g; }
    "(U|k|epsilon).*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0.01; }
}
cache { grad(U); grad(p); }
PIMPLE { nOuterCorrectors 1; nCorrectors %(correctors)d; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }
SIMPLE { nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; residualControl { "(U|k|epsilon)" 1e-6; } }
relaxationFactors { fields { p 0.3; } equations { U 0.7; "(k|epsilon)" 0.7; ".*Final" 1; } }
"""

CONTROL = """
application {solver};
libs ("libliggghtsCoupling.so");
startFrom startTime; startTime 0; stopAt endTime; endTime {end!r}; deltaT {step!r};
writeControl {writeControl}; writeInterval {end!r}; writeFormat ascii; writePrecision 10; timePrecision 10; runTimeModifiable no;
functions {{ {functions} }}
"""

FUNCTIONS = """
profiles
{{
    type particleSamplingPlanes; libs ("libparticleSamplingPlanes.so"); cloud liggghts;
    origin (0 0 0); axis (0 0 1); diameter {D!r}; planes ({plane!r}); radialBins {rings}; maxRadius 0.5;
    timeStart {sampleStart!r}; events {events}; writeControl onEnd;
}}
mean
{{
    type fieldAverage; libs ("libfieldFunctionObjects.so"); writeControl onEnd; timeStart {sampleStart!r};
    fields (U {{ mean on; prime2Mean off; base time; }} k {{ mean on; prime2Mean off; base time; }});
}}
centres {{ type writeCellCentres; libs ("libfieldFunctionObjects.so"); writeControl onEnd; executeControl onEnd; }}
"""

SCRIPT = """# The grains of a periodic pipe; run by the coupling
plugin load hertzcgplugin.so
plugin load fluidforceplugin.so
plugin load wallroughnessplugin.so
units si
soft_particles yes
atom_style granular
atom_modify map array sort 200 {bin!r}
newton off
processors 1 1 *
boundary f f p
communicate single vel yes
if "${{continued}}" then "jump SELF continued"
region domain block {minus!r} {plus!r} {minus!r} {plus!r} 0 {length!r} units box
create_box 1 domain
jump SELF ready
label continued
read_restart ${{restart}}
label ready
neighbor {skin!r} bin
neigh_modify delay 0
timestep {demStep!r}
coarsegraining {cg} model_check warn
fix m1 all property/global youngsModulus peratomtype {youngsModulus!r}
fix m2 all property/global poissonsRatio peratomtype {poissonsRatio!r}
fix m3 all property/global coefficientRestitution peratomtypepair 1 {restitution!r}
fix m4 all property/global coefficientFriction peratomtypepair 1 {friction!r}
{contact}
fix wall all wall/gran model hertz tangential history primitive type 1 zcylinder {radius!r} 0. 0.
{templates}
region inside cylinder z 0 0 {inner!r} 0 {length!r} units box
fix pack all insert/pack seed {seed} distributiontemplate mixture insert_every once overlapcheck yes all_in no &
    vel constant 0 0 {start!r} region inside particles_in_region {grains} ntry_mc 10000
fix gravity all gravity {gravity!r} vector {direction}
fix fluid all fluid/force coupled
{extra}
fix motion all nve/sphere
thermo 2000
thermo_modify lost ignore norm no
if "${{continued}} == 0" then "run 1"
unfix pack
"""


def mesh(s):
    """blockMeshDict of an O-grid: a core with bulged sides in a ring, as the pipe of quickJet."""
    R, core, side = s["D"]/2, 0.54*s["D"]/2, 0.44*s["D"]/2
    vertices, edges, blocks = [], [], []
    corners = [(math.cos(a), math.sin(a)) for a in (math.pi/4 + k*math.pi/2 for k in range(4))]
    middles = [(0, 1), (-1, 0), (0, -1), (1, 0)]
    for level, z in enumerate((0, s["length"])):
        for ring, (r, middle) in enumerate(((core, side), (R, R))):
            base = 8*level + 4*ring
            vertices += [f"({r*x!r} {r*y!r} {z!r})" for x, y in corners]
            edges += [f"arc {base + k} {base + (k + 1) % 4} ({middle*x!r} {middle*y!r} {z!r})"
                      for k, (x, y) in enumerate(middles)]
    n, m, axial = s["nSide"], s["nRing"], s["nAxial"]
    blocks.append(f"hex (0 1 2 3 8 9 10 11) ({n} {n} {axial}) simpleGrading (1 1 1)")
    ends, wall = ["(0 1 2 3)"], []
    for a in range(4):
        b = (a + 1) % 4
        blocks.append(f"hex ({a} {a + 4} {b + 4} {b} {a + 8} {a + 12} {b + 12} {b + 8}) ({m} {n} {axial}) simpleGrading (1 1 1)")
        ends.append(f"({a} {a + 4} {b + 4} {b})")
        wall.append(f"({a + 4} {b + 4} {b + 12} {a + 12})")
    upper = [" ".join(["(" + " ".join(str(int(v) + 8) for v in face.strip("()").split()) + ")"]) for face in ends]
    lists = {name: "\n".join(lines) for name, lines in (("vertices", vertices), ("edges", edges), ("blocks", blocks))}
    return ("".join(f"{name}\n(\n{text}\n);\n" for name, text in lists.items())
            + f"boundary\n(\ninlet {{ type cyclic; neighbourPatch outlet; faces ({' '.join(ends)}); }}\n"
            f"outlet {{ type cyclic; neighbourPatch inlet; faces ({' '.join(upper)}); }}\n"
            f"wall {{ type wall; faces ({' '.join(wall)}); }}\n);\n")


def fields(case, s):
    k = 1.5*(0.05*s["Ubulk"])**2
    epsilon = 0.09**0.75*k**1.5/(0.07*s["D"])
    for name, dimensions, value, wall in (
            ("U", "0 1 -1", f"(0 0 {s['Ubulk']})", "type noSlip;"),
            ("p", "0 2 -2", "0", "type zeroGradient;"),
            ("k", "0 2 -2", repr(k), "type kqRWallFunction; value $internalField;"),
            ("epsilon", "0 2 -3", repr(epsilon), "type epsilonWallFunction; value $internalField;"),
            ("nut", "0 2 -1", "0", "type nutUSpaldingWallFunction; value $internalField;")):
        dictionaries.write_field(case, name, dimensions, value, {"wall": wall, "inlet|outlet": "type cyclic;"})


def options(s, model):
    """fvOptions: the force that drives the flow, and the grains."""
    forces = ["pressureGradient", "viscous", "buoyancy", *model["forces"]]
    entries = {"type": "liggghtsCoupling", "script": '"constant/in.particles"', "couplingInterval": s["couplingInterval"],
               "forces": "{ drag { model Gidaspow; } " + " ".join(f"{name} {{}}" for name in forces) + " }",
               "interpolation": "cellPoint", **model["options"]}
    return f"{drive(s)}\nparticles\n{{\n{dictionaries.entries(entries)}}}\n"


def drive(s):
    return ("drive { type meanVelocityForce; selectionMode all; fields (U); "
            f"Ubar (0 0 {s['Ubulk']}); relaxation 0.9; }}")


def script(s, model):
    """The input script of LIGGGHTS."""
    radius, grain = s["D"]/2, s["cg"]*max(s["diameters"])
    seeds = (15485863, 15485867, 15485917, 15485927, 15485933, 15485941, 15485959)
    templates = [f"fix size{i} all particletemplate/sphere {seed} atom_type 1 density constant {s['rhoParticle']!r} "
                 f"radius constant {d/2:.10g} volume_limit 1e-17" for i, (d, seed) in enumerate(zip(s["diameters"], seeds), 1)]
    mixture = "".join(f" size{i} {share:.10g}" for i, share in enumerate(s["massFractions"], 1))
    templates.append(f"fix mixture all particledistribution/discrete 32452843 {len(templates)}{mixture}")
    contact = "fix contact all hertz/cg tangential history rolling off" if model["collisions"] else ""
    return SCRIPT.format(**s, bin=4*grain, skin=2*grain, radius=radius, minus=-1.05*radius, plus=1.05*radius,
                         inner=radius - 1.01*grain/2, start=s["Ubulk"]*(1 - s["slip"]), contact=contact,
                         templates="\n".join(templates), seed=s.get("insertSeed", 86028121),
                         extra="\n".join(line.format(**s) for line in model["script"]),
                         direction={"up": "0 0 -1", "horizontal": "0 -1 0"}[s["flow"]])


def write(case, s, model):
    """All files of a run."""
    n = s["ranks"]
    dictionaries.write_all(case, {
        "system/blockMeshDict": mesh(s),
        "system/fvSolution": SOLUTION % {"correctors": s.get("correctors", 1), "relTol": 0.0 if "correctors" in s else 0.01},
        "system/decomposeParDict": f"numberOfSubdomains {n}; method simple; simpleCoeffs {{ n (1 1 {n}); delta 1e-6; }}",
        "constant/transportProperties": f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {s['nu']!r};\n"
                                        f"rho [1 -3 0 0 0 0 0] {s['rhoFluid']!r};",
        "constant/turbulenceProperties": "simulationType RAS;\nRAS { RASModel kEpsilon; turbulence on; printCoeffs on; }"})
    fields(case, s)
    (case/"constant/in.particles").write_text(script(s, model))


def execute(case, *command, ranks=1):
    """Run a program in the case; output goes to log.<program>. Behind other work of the machine."""
    log = case/f"log.{command[0]}"
    parallel = ["-parallel"] if ranks > 1 else []
    with log.open("w") as output:
        code = subprocess.run(["nice", "-n", "10", *(grainjet.mpirun(ranks) if ranks > 1 else []), *command, *parallel],
                              cwd=case, env=grainjet.ENV, stdout=output, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, check=False).returncode
    if code:
        lines = log.read_text(errors="replace").splitlines()
        start = next((i for i, line in enumerate(lines) if "ERROR" in line), len(lines) - 10)
        raise RuntimeError(f"{command[0]} failed, see {log}:\n" + "\n".join(lines[start:start + 12]))


def run(case, s, model):
    """From nothing to the results: the steady flow without grains, then both."""
    if case.exists():
        shutil.rmtree(case)
    write(case, s, model)
    dictionaries.write(case/"system/fvSchemes", SCHEMES % {"ddt": "steadyState", "bounded": "bounded "})
    dictionaries.write(case/"constant/fvOptions", drive(s))
    dictionaries.write(case/"system/controlDict", CONTROL.format(
        solver="simpleFoam", end=s["spinUpIterations"], step=1, writeControl="runTime", functions=""))
    execute(case, "blockMesh")
    execute(case, "simpleFoam")
    steady = max((d for d in case.iterdir() if d.name.isdigit()), key=lambda d: int(d.name))
    for name in ("U", "p", "k", "epsilon", "nut"):
        shutil.copy(steady/name, case/"0"/name)
    shutil.rmtree(steady)

    dictionaries.write(case/"system/fvSchemes", SCHEMES % {"ddt": "Euler", "bounded": ""})
    dictionaries.write(case/"constant/fvOptions", options(s, model))
    dictionaries.write(case/"system/controlDict", CONTROL.format(
        solver="pimpleFoam", end=s["endTime"], step=s["fluidStep"], writeControl="runTime",
        functions=FUNCTIONS.format(**s, plane=0.5*s["pipeLength"], events="yes" if s["flow"] == "horizontal" else "no")))
    if s["ranks"] > 1:
        execute(case, "decomposePar")
    execute(case, "pimpleFoam", ranks=s["ranks"])
    if s["ranks"] > 1:
        execute(case, "reconstructPar", "-latestTime")
