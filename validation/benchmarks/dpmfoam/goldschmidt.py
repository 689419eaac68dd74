#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM's tutorial DPMFoam/Goldschmidt, a bubbling bed of 24,750 spheres, by DPMFoam and by pimpleFoam with LIGGGHTS.

    source environment; validation/benchmarks/dpmfoam/goldschmidt.py [--end 0.25] [--from 0.1] [--state 0.15] [--turns 3]
        [--steps 40] [--tutorial FOLDER] [--only NAME ...] [--work FOLDER] [--output FOLDER]

First the bed from the tutorial's start to --end seconds in each program, with softer contacts (MODULUS), means from --from on;
then the cost: from a state of the bed (the end, and --state with the tutorial's contacts) --steps fluid steps of each program in turns.
goldschmidt.md says what is the same and what is not. With --work the folder is kept and what is complete is not run again;
--only picks runs by name (DPMFoam, full, filter, centre, neglected, cost). The tutorial's folder: --tutorial, or that of the Debian package
openfoam-examples, which is fetched into the work folder if it is not installed.
"""

import argparse
import gzip
import json
import math
import pathlib
import re
import shutil
import subprocess
import tempfile

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import dpm_case
import grainjet
from grainjet import dictionaries, done, fields, tables
from run import Measured

TUTORIAL = "usr/share/doc/openfoam-examples/examples/lagrangian/DPMFoam/Goldschmidt"

# The tutorial's numbers, SI
RHO, NU, G, VELOCITY = 1.2, 1e-5, 9.81, 1.875
DIAMETER, DENSITY = 0.0025, 2526.0
X, Y, Z = 0.0075, 0.075, 0.45           # the box is 2 X by 2 Y by Z
CELLS = (2, 30, 90)
POISSON, WALL_POISSON = 0.35, 0.23
ALPHA, WALL_ALPHA = 0.02, 0.01          # damping: sqrt(5) |ln e|/sqrt(ln^2 e + pi^2)
FRICTION, WALL_FRICTION = 0.10, 0.09
OWN_MODULUS, OWN_STEP, OWN_CYCLES = 1e8, 2e-5, 3

# Contacts 100 times softer, so that the bed is not hours of DPMFoam
MODULUS, STEP, CYCLES = 1e6, 1e-4, 3
FILTER = 4*DIAMETER
SKIPPED = 5             # fluid steps of a turn that are not timed

MEAN_PRESSURE = 24750*math.pi/6*DIAMETER**3*(DENSITY - RHO)*G/(4*X*Y)     # weight of the bed less buoyancy over its area, Pa

RUNS = {"full": "divided; equations full", "filter": f"divided; equations full; filter {{ length {FILTER:g}; }}",
        "centre": "centre; equations full", "neglected": "divided; equations neglected"}

SCRIPT = """
plugin load hertzcgplugin.so
plugin load fluidforceplugin.so
units si
soft_particles yes
atom_style granular
atom_modify map array sort 200 0.005
boundary f f f
newton off
communicate single vel yes
if "${{continued}}" then "jump SELF continued"
read_data constant/grains
jump SELF ready
label continued
read_restart ${{restart}}
label ready
neighbor 0.0005 bin
neigh_modify delay 0
timestep {step}
fix m1 all property/global youngsModulus peratomtype {modulus} {modulus}
fix m2 all property/global poissonsRatio peratomtype {poisson} {wallPoisson}
fix m3 all property/global coefficientRestitution peratomtypepair 2 {e} {wallE} {wallE} {wallE}
fix m4 all property/global coefficientFriction peratomtypepair 2 {mu} {wallMu} {wallMu} {wallMu}
fix contact all hertz/cg tangential history
{walls}
fix gravity all gravity 9.81 vector 0 0 -1
fix fluid all fluid/force coupled
fix motion all nve/sphere
thermo 10000
"""

FUNCTIONS = """
functions
{{
    grains {{ type vtkCloud; libs ("liblagrangianFunctionObjects.so"); cloud {cloud}; writeControl adjustableRunTime; writeInterval 0.01; }}
    bottom
    {{
        type probes; libs ("libsampling.so"); writeControl timeStep; writeInterval 10; fields (p); probeLocations ({places});
    }}
}}
"""


def restitution(alpha):
    """Of a damping factor; the inverse of what dpm_case.write_cloud_properties has."""
    beta = alpha/math.sqrt(5)
    return math.exp(-math.pi*beta/math.sqrt(1 - beta**2))


def tutorial(options, work):
    """The tutorial's folder."""
    for folder in (options.tutorial, pathlib.Path("/")/TUTORIAL, work/"examples"/TUTORIAL):
        if folder and (folder/"constant/kinematicCloudProperties").exists():
            return folder
    (work/"examples").mkdir(parents=True, exist_ok=True)
    for command in ("apt-get download openfoam-examples", "dpkg -x openfoam-examples_*.deb ."):
        subprocess.run(command, shell=True, cwd=work/"examples", check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return work/"examples"/TUTORIAL


class State:
    """A bed to start from: grains, and the fluid if it moves."""

    def __init__(self, positions, velocities, flux=None, velocity=None, pressure=None):
        self.positions, self.velocities = positions, velocities
        self.flux, self.velocity, self.pressure = flux, velocity, pressure


def at_rest(source):
    """The tutorial's start."""
    path = source/"constant/kinematicCloudPositions"
    text = path.read_text() if path.exists() else gzip.open(f"{path}.gz", "rt").read()
    rows = re.findall(r"^\(([-\d.e]+) ([-\d.e]+) ([-\d.e]+)\)", text, re.M)
    positions = numpy.array(rows, dtype=float)
    return State(positions, numpy.zeros_like(positions))


def reached(case, end):
    """The state at the end of a run of pimpleFoam."""
    time = case/f"{end:g}"
    _, positions, data = fields.grains_at(case/"postProcessing/grains", end)
    return State(positions, data["U"], *(dictionaries.internal(time/name) for name in ("U", "fluidVelocity", "p")))


def heights():
    """Of the centres of all cells, in the order of the mesh."""
    nx, ny, nz = CELLS
    return [(k + 0.5)*Z/nz for k in range(nz) for _ in range(nx*ny)]


def lowest():
    """Centres of the lowest layer of cells."""
    nx, ny, nz = CELLS
    return " ".join(f"({X*(2*(i + 0.5)/nx - 1):.6g} {Y*(2*(j + 0.5)/ny - 1):.6g} {0.5*Z/nz:.6g})"
                    for j in range(ny) for i in range(nx))


def mesh_and_control(case, source, application, end, step, cloud, libs=""):
    """The tutorial's mesh; its two sides let the fluid slip, and are walls for DPMFoam, so that grains touch them."""
    for folder in ("system", "constant", "0"):
        (case/folder).mkdir(parents=True)
    for name in ("blockMeshDict", "fvSchemes", "fvSolution"):
        shutil.copy(source/"system"/name, case/"system")
    mesh = case/"system/blockMeshDict"
    mesh.write_text(mesh.read_text().replace("type symmetry", "type wall"))
    for patch in ("top", "bottom", "frontAndBack"):
        mesh.write_text(re.sub(rf"({patch}\s*\{{\s*type) wall;", r"\1 patch;" if libs else r"\1 wall;", mesh.read_text()))
    dictionaries.write(case/"system/controlDict", f"""
application {application}; {libs} startFrom startTime; startTime 0; stopAt endTime; endTime {end:.10g};
deltaT {step:g}; writeControl runTime; writeInterval {end:.10g}; writeFormat ascii; writePrecision 12; timePrecision 8;
runTimeModifiable no; profiling {{ active yes; }}
{FUNCTIONS.format(cloud=cloud, places=lowest())}""")
    done(["blockMesh"], case, "log.blockMesh")


def pimple_case(case, source, state, model, end, step, modulus, cycles):
    """pimpleFoam with LIGGGHTS: the same under its names."""
    mesh_and_control(case, source, "pimpleFoam", end, step, "liggghts", 'libs ("libliggghtsCoupling.so");')
    schemes = (case/"system/fvSchemes").read_text()
    schemes = schemes.replace("div(alphaPhi.air,U.air)", "div(phi,U)").replace(
        "div(((alpha.air*nuEff.air)*dev2(T(grad(U.air)))))", "div((nuEff*dev2(T(grad(U)))))")
    (case/"system/fvSchemes").write_text(schemes)
    solution = (case/"system/fvSolution").read_text().replace("U.air", "U").replace("(p|kinematicCloud:theta)", "p")
    (case/"system/fvSolution").write_text(solution)
    dictionaries.write(case/"constant/transportProperties",
                       f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {NU:g}; rho [1 -3 0 0 0 0 0] {RHO:g};")
    dictionaries.write(case/"constant/turbulenceProperties", "simulationType laminar;")
    flux = dictionaries.nonuniform(state.flux) if state.flux else "(0 0 0)"
    pressure = dictionaries.nonuniform(state.pressure) if state.pressure else 0
    dictionaries.write_field(case, "U", "0 1 -1", flux, {
        "walls": "type noSlip;", "frontAndBack": "type slip;", "bottom": f"type fixedValue; value uniform (0 0 {VELOCITY:g});",
        "top": "type pressureInletOutletVelocity; value uniform (0 0 0);"})
    dictionaries.write_field(case, "p", "0 2 -2", pressure, {
        "(walls|frontAndBack|bottom)": "type zeroGradient;", "top": "type fixedValue; value uniform 0;"})
    dictionaries.write(case/"constant/fvOptions", f"""
particles
{{
    type liggghtsCoupling; script "constant/in.particles"; couplingInterval {cycles};
    voidFraction {{ model {model}; minimum 0.3; }}
    drag Gidaspow; forces (pressureGradient buoyancy);
}}
""".replace("; }; minimum", "; } minimum"))
    walls = "\n".join(f"fix wall{n} all wall/gran model hertz tangential history primitive type 2 {plane} {place:g}"
                      for n, (plane, place) in enumerate((("xplane", -X), ("xplane", X), ("yplane", -Y), ("yplane", Y),
                                                          ("zplane", 0), ("zplane", Z))))
    (case/"constant/in.particles").write_text(SCRIPT.format(
        step=f"{step/cycles:.17g}", modulus=modulus, poisson=POISSON, wallPoisson=WALL_POISSON, e=restitution(ALPHA),
        wallE=restitution(WALL_ALPHA), mu=FRICTION, wallMu=WALL_FRICTION, walls=walls))
    box = "".join(f"{-a:g} {a:g} {c}lo {c}hi\n" for c, a in (("x", 1.2*X), ("y", 1.02*Y)))
    (case/"constant/grains").write_text(
        f"grains\n\n{len(state.positions)} atoms\n2 atom types\n{box}-0.001 {Z + 0.001:g} zlo zhi\n\nAtoms\n\n"
        + "".join(f"{n} 1 {DIAMETER:g} {DENSITY:g} {x:.17g} {y:.17g} {z:.17g}\n" for n, (x, y, z) in enumerate(state.positions, 1))
        + "\nVelocities\n\n"
        + "".join(f"{n} {u:.17g} {v:.17g} {w:.17g} 0 0 0\n" for n, (u, v, w) in enumerate(state.velocities, 1)))


def dpm_case_of(case, source, state, end, step, modulus, cycles):
    """DPMFoam: the tutorial with another start, end and stiffness."""
    mesh_and_control(case, source, "DPMFoam", end, step, "kinematicCloud")
    for name in ("constant/kinematicCloudProperties", "constant/g", "constant/transportProperties",
                 "constant/turbulenceProperties.air", "0/U.air", "0/p"):
        shutil.copy(source/name, case/name)
    velocity = dictionaries.nonuniform(state.velocity) if state.velocity else "uniform (0 0 0)"
    pressure = dictionaries.nonuniform([p + G*(Z - z) for p, z in zip(state.pressure, heights())]) if state.pressure else "uniform 0"
    for name, value, side in (("U.air", velocity, "type slip;"),
                              ("p", pressure, "type fixedFluxPressure; phi phi.air; value uniform 0;")):
        text = (case/"0"/name).read_text().replace("$internalField", "uniform 0").replace("binary;", "ascii;")
        text = re.sub(r"internalField\s+uniform [^;]+;", lambda _: f"internalField {value};", text)
        (case/"0"/name).write_text(text.replace("type            symmetry;", side))
    properties = case/"constant/kinematicCloudProperties"
    text = re.sub(r"injectionModels\s*\{.*?\n    \}", "injectionModels {}", properties.read_text(), flags=re.S)
    text = re.sub(r"youngsModulus\s+1e8", f"youngsModulus {modulus:g}", text)
    properties.write_text(text)
    dpm_case.write_cloud(case/"0", "kinematicCloud", state.positions, {
        **dpm_case.PARCEL_FIELDS, "typeId": ("labelField", "1"),
        "U": ("vectorField", [dpm_case.vector(u) for u in state.velocities]), "d": ("scalarField", f"{DIAMETER:g}"),
        "dTarget": ("scalarField", f"{DIAMETER:g}"), "rho": ("scalarField", f"{DENSITY:g}"), "nParticle": ("scalarField", "1")})


def bed(work, source, name, state, end):
    """Run one program to the end, unless that was done. Returns the folder."""
    case = work/name
    if (case/"complete").exists():
        return case
    shutil.rmtree(case, ignore_errors=True)
    if name == "DPMFoam":
        dpm_case_of(case, source, state, end, STEP, MODULUS, CYCLES)
    else:
        pimple_case(case, source, state, RUNS[name], end, STEP, MODULUS, CYCLES)
    done(["DPMFoam" if name == "DPMFoam" else "pimpleFoam"], case, "log.solver")
    (case/"complete").touch()
    return case


def series(case):
    """(times, mean height of grains [m]), (times, pressure drop [Pa]) of a run; also of one that goes on."""
    listed = json.loads(next((case/"postProcessing/grains").glob("*.series")).read_text())["files"]
    z = [fields.grains_at(case/"postProcessing/grains", entry["time"])[1][:, 2].mean() for entry in listed]
    rows = numpy.loadtxt(case/"postProcessing/bottom/0/p", comments="#")
    # DPMFoam's pressure has the weight of the air
    weight = G*(Z - heights()[0]) if case.name == "DPMFoam" else 0
    return (numpy.array([entry["time"] for entry in listed]), numpy.array(z)), (rows[:, 0], RHO*(rows[:, 1:].mean(1) - weight))


def processor_seconds(log):
    """(number of steps after the first ones, processor time of a solver in them)."""
    times = [float(x) for x in re.findall(r"ExecutionTime = ([\d.]+) s", log)][SKIPPED:]
    return len(times) - 1, times[-1] - times[0]


def turn(work, source, state, name, contacts, steps):
    """A program for some steps from a state: (s per step, of these particles, processor s per step, DEM steps)."""
    modulus, step, cycles = contacts
    case = work/f"turn-{name}"
    shutil.rmtree(case, ignore_errors=True)
    end = step*(steps + SKIPPED)
    if name == "DPMFoam":
        dpm_case_of(case, source, state, end, step, modulus, cycles)
    else:
        pimple_case(case, source, state, RUNS[name], end, step, modulus, cycles)
    run = Measured("DPMFoam" if name == "DPMFoam" else "pimpleFoam", case, 1)
    n, processor = processor_seconds(run.log)
    if name == "DPMFoam":
        profile = (case/f"{end:.8g}/uniform/profiling").read_text()
        particles = float(re.search(r'"?cloud::solve"?;.*?totalTime\s+([\d.e+-]+)', profile, re.S)[1])/(steps + SKIPPED)
        cycles = numpy.mean([int(c) for c in re.findall(r"(\d+) move-collide subCycles", run.log)][SKIPPED:])
        dem = math.nan
    else:
        balance = tables.history(case/"postProcessing/liggghtsCoupling", "balance")
        dem = balance["secondsDEM"][SKIPPED:].mean()
        particles = dem + balance["secondsCoupling"][SKIPPED:].mean()
    return run.step, particles, processor/n, dem, cycles


def cost(work, source, options):
    """Rows of the table of times: each program in turns from a state of the bed."""
    yield ["contacts", "program", "DEM steps per fluid step", "s per fluid step", "of these particles", "processor s per step",
           "rate, all of particles", "rate, DEM alone", "DPMFoam over it: s", "smallest to largest", "particles", "smallest to largest",
           "processor s"]
    for words, contacts in (("softer", (MODULUS, STEP, CYCLES)), ("tutorial's", (OWN_MODULUS, OWN_STEP, OWN_CYCLES))):
        modulus = contacts[0]
        if modulus == MODULUS:
            first, reach = bed(work, source, "full", at_rest(source), options.end), options.end
        else:
            first, reach = work/"state", options.state
        if not (first/"complete").exists():
            shutil.rmtree(first, ignore_errors=True)
            pimple_case(first, source, at_rest(source), RUNS["full"], reach, STEP, modulus, round(CYCLES*(modulus/MODULUS)**0.4))
            done(["pimpleFoam"], first, "log.solver")
            (first/"complete").touch()
        state = reached(first, reach)
        found = {"DPMFoam": [], "full": [], "filter": []}
        for _ in range(options.turns):
            for name, rows in found.items():
                rows.append(turn(work, source, state, name, contacts, options.steps))
        theirs = found["DPMFoam"]
        for name, rows in found.items():
            seconds, particles, processor, dem, cycles = (numpy.median(part) for part in zip(*rows))
            moved = 1e-6*len(state.positions)*cycles
            ratios = [[a[i]/b[i] for a, b in zip(theirs, rows)] for i in range(3)]
            yield [words, name if name == "DPMFoam" else f"pimpleFoam + LIGGGHTS, {name}", f"{cycles:.3g}", f"{seconds:.4f}",
                   f"{particles:.4f}", f"{processor:.4f}", f"{moved/particles:.3g}", "" if math.isnan(dem) else f"{moved/dem:.3g}",
                   *(text for r in ratios[:2] for text in (f"{numpy.median(r):.2f}", f"{min(r):.2f} to {max(r):.2f}")),
                   f"{numpy.median(ratios[2]):.2f}"]


def compare(found, begin, output):
    """Tables and figure of the bed."""
    end = min(t[-1] for (t, _), _ in found.values())
    rows = [["run", "mean height of grains, mm", "at the end, mm", "pressure drop over weight", "rms change in 1 ms, %"]]
    for (t, z), (s, p) in found.values():
        seen = s <= end
        rows.append([f"{1e3*z[(t > begin) & (t <= end)].mean():.2f}", f"{1e3*numpy.interp(end, t, z):.2f}",
                     f"{p[(s > begin) & seen].mean()/MEAN_PRESSURE:.3f}", f"{100*numpy.diff(p[seen]).std()/MEAN_PRESSURE:.2f}"])
    rows[1:] = [[name, *row] for name, row in zip(found, rows[1:])]
    if "DPMFoam" in found:
        (t, z), (s, p) = found["DPMFoam"]
        t, z, s, p = t[t <= end], z[t <= end], s[s <= end], p[s <= end]
        rows[0] += ["rms from DPMFoam, mm", "drop, % of weight"]
        for row, ((x, y), (u, v)) in zip(rows[1:], found.values()):
            row += [f"{1e3*math.sqrt(((numpy.interp(t, x, y) - z)**2).mean()):.2f}",
                    f"{100*math.sqrt(((numpy.interp(s, u, v) - p)**2).mean())/MEAN_PRESSURE:.1f}"]
    tables.show(rows)
    print()
    tables.write(output/"means.csv", rows)
    columns = [(f"{name}: {words}", series[0], factor*series[1]) for name, pair in found.items()
               for words, series, factor in (("height, mm", pair[0], 1e3), ("pressure drop over weight", pair[1], 1/MEAN_PRESSURE))]
    rows = [["t, s", *(name for name, _, _ in columns)]]
    for t in next(iter(found.values()))[0][0]:
        rows.append([f"{t:.3g}", *(f"{numpy.interp(t, x, y, right=math.nan):.4g}" for _, x, y in columns)])
    tables.write(output/"series.csv", rows)
    figure, axes = plt.subplots(1, 2, figsize=(11, 4), constrained_layout=True)
    for name, ((t, z), (s, p)) in found.items():
        style = {"color": "black", "linewidth": 2} if name == "DPMFoam" else {"linewidth": 1}
        axes[0].plot(t, 1e3*z, label=name, **style)
        n = len(p)//5*5
        axes[1].plot(s[:n].reshape(-1, 5).mean(1), p[:n].reshape(-1, 5).mean(1)/MEAN_PRESSURE, label=name, **style)
    axes[0].set(xlabel="t, s", ylabel="mean height of grains, mm")
    axes[1].set(xlabel="t, s", ylabel="pressure drop over weight (5 ms)")
    axes[0].legend(fontsize=8)
    figure.savefig(output/"goldschmidt.png", dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--from", dest="begin", type=float, default=0.1)
    for name, default in (("end", 0.25), ("state", 0.15), ("turns", 3), ("steps", 40)):
        parser.add_argument(f"--{name}", type=type(default), default=default)
    parser.add_argument("--only", nargs="+", default=["DPMFoam", *RUNS, "cost"], choices=["DPMFoam", *RUNS, "cost"])
    for name in ("tutorial", "work", "output"):
        parser.add_argument(f"--{name}", type=pathlib.Path)
    options = parser.parse_args()
    work = (options.work or pathlib.Path(tempfile.mkdtemp(prefix="grainjet-goldschmidt-"))).resolve()
    work.mkdir(parents=True, exist_ok=True)
    source = tutorial(options, work)

    found = {name: series(bed(work, source, name, at_rest(source), options.end)) for name in options.only if name != "cost"}
    if found:
        compare(found, options.begin, options.output or work)
    if "cost" in options.only:
        rows = list(cost(work, source, options))
        tables.show(rows)
        print()
        if options.output:
            tables.write(options.output/"cost.csv", rows)
    if not options.work:
        shutil.rmtree(work)


if __name__ == "__main__":
    main()
