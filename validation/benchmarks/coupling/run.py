#!/usr/bin/env python3
"""What the coupling costs: coupled run against fluid alone and grains alone.

    overhead = (coupled - fluid - grains)/(fluid + grains)

on the same machine in one go: a periodic box of 37 x 37 x 37 cells of 1 mm with vortices in turbulent
air (kEpsilon; schemes and linear solvers of cases/quickJet) at 8 m/s and grains of 80 um at 6 m/s, `fix
hertz/cg`, cellPoint, divided, drag + pressure gradient + viscous. Coupled one way: the flow is then bit
for bit that of the fluid alone, so that its solver makes the same iterations; --two-way couples it both
ways. The grains alone run the same script, so that drag is part of them. Start-up does not count.

Other work on the machine makes a program take up to twice as long for seconds or hours, and whole runs
differ by more than the overhead. So the three programs take turns, each is timed in pieces of a few
steps, and of each piece the shortest time of all repetitions counts: the same steps with the
least disturbance. The column "scatter" is the overhead made with the repetitions of odd and of even
number, each half by itself. The coupling's own clock, its time over that of fluid and DEM in the
same run, does not see that the fluid is slower when its data has left the caches.

--memory measures instead the memory of the coupling per grain: the growth of the largest rank's peak
with the number of grains, less that of the same grains without fix fluid/force.

    source environment; validation/benchmarks/coupling/run.py [--grains 20000 100000] [--ranks 1 2]
        [--interval 50 10] [--repeat 6] [--outer N] [--two-way | --memory] [--output results.md]
"""

import argparse
import math
import os
import pathlib
import random
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "validation/testing"), str(ROOT / "openfoam-libs/liggghtsCoupling/tests")]
import coupled_box as box
import grainjet

SIDE, CELLS = 0.037, 37
SKIP, PIECE, PIECES = 5, 5, 7     # fluid steps before the first piece and in each; their number
STEPS = SKIP + PIECE * PIECES
DEM_STEP = 1e-6

PLUGINS = "plugin load hertzcgplugin.so"

# a rank that waits does not leave its core, as in a user's run on as many cores as ranks
ENV = {**grainjet.ENV, "OMPI_MCA_mpi_yield_when_idle": "0"}


def write_grains(folder, n):
    """A data file of n grains at random places."""
    rng = random.Random(1)
    with open(folder / "constant/grains.data", "w") as out:
        out.write(f"grains\n\n{n} atoms\n1 atom types\n\n"
                  + "".join(f"0 {SIDE} {k}lo {k}hi\n" for k in "xyz") + "\nAtoms\n\n")
        for i in range(1, n + 1):
            x, y, z = (rng.uniform(0, SIDE) for _ in range(3))
            out.write(f"{i} 1 8e-5 2950 {x} {y} {z}\n")
        out.write("\nVelocities\n\n")
        for i in range(1, n + 1):
            u, v, w = (rng.gauss(m, 0.3) for m in (0, 0, 6))
            out.write(f"{i} {u} {v} {w} 0 0 0\n")


def write_vortices(folder):
    """Taylor-Green vortices of 1 m/s across the stream and some shear along it, so that the linear
    solvers have their usual work."""
    k = 2 * math.pi / CELLS
    values = []
    for _ in range(CELLS):
        for j in range(CELLS):
            for i in range(CELLS):
                x, y = k * (i + 0.5), k * (j + 0.5)
                values.append(f"({math.sin(x) * math.cos(y):.9g} {-math.cos(x) * math.sin(y):.9g} "
                              f"{8 + 0.5 * math.sin(x):.9g})")
    path = folder / "0/U"
    path.write_text(path.read_text().replace(
        "uniform (0 0 8)", f"nonuniform List<vector> {len(values)}\n(\n" + "\n".join(values) + "\n)"))


def write_turbulence(folder, outer):
    """kEpsilon with the schemes and linear solvers of the main job."""
    for name in ("fvSchemes", "fvSolution"):
        text = (ROOT / "cases/quickJet/system" / name).read_text()
        (folder / "system" / name).write_text(text.replace(
            "nOuterCorrectors 1;", f"nOuterCorrectors {outer}; pRefCell 0; pRefValue 0;"))
    (folder / "constant/turbulenceProperties").write_text(
        box.HEADER.format("dictionary", "turbulenceProperties")
        + "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }\n")
    for field, dimensions, value in (("k", "0 2 -2", 0.24), ("epsilon", "0 2 -3", 18.4),
                                     ("nut", "0 2 -1", 0)):
        (folder / "0" / field).write_text(
            box.HEADER.format("volScalarField", field)
            + f"dimensions [{dimensions} 0 0 0 0]; internalField uniform {value};\n"
            'boundaryField { ".*" { type cyclic; } }\n')


def write_case(folder, grains, interval, ranks, steps, coupled, two_way=False, outer=1):
    """The case; coupled or the fluid alone, and a script for the grains alone."""
    dt = interval * DEM_STEP
    box.write(folder, steps=steps, delta_t=dt, cells=" ".join([str(CELLS)] * 3),
              velocity="(0 0 8)", ranks=ranks, decomposition=f"(1 1 {ranks})",
              libs='("libliggghtsCoupling.so")' if coupled else "()")
    mm = 1000 * SIDE
    corners = [(x * mm, y * mm, z * mm) for z in (0, 1)
               for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    mesh = folder / "system/blockMeshDict"
    text = mesh.read_text()
    start, stop = text.index("vertices"), text.index("blocks")
    mesh.write_text(text[:start] + "vertices (" + " ".join(
        "({:g} {:g} {:g})".format(*c) for c in corners) + ");\n" + text[stop:])
    write_turbulence(folder, outer)
    # one script for both: alone it runs by itself
    box.script(folder, grains="", dt=DEM_STEP, plugins=PLUGINS,
               fixes="fix contacts all hertz/cg", processors=f"processors 1 1 {ranks}")
    script = folder / "constant/in.particles"
    # grains in the order of cells from the start, as they are in a run of more than a few steps
    lines = [line.replace("sort 0 0", "sort 100 0.001")
             for line in script.read_text().splitlines() if not line.startswith("neigh")]
    script.write_text("\n".join(lines) + "\n")
    (folder / "constant/new.grains").write_text("read_data constant/grains.data\n")
    write_grains(folder, grains)
    write_vortices(folder)
    if coupled:
        box.fv_options(folder, couplingInterval=interval,
                       coupling="twoWay" if two_way else "oneWay")
    (folder / "in.alone").write_text("\n".join(lines) + f"""
thermo_style custom step cpu
thermo {PIECE * interval}
run {steps * interval}
""")


def run(command, folder):
    """The output of a command that must succeed, line by line with the time at which it came."""
    with subprocess.Popen([str(c) for c in command], cwd=folder, text=True,
                          env={**ENV, "PWD": str(folder)}, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        lines = [(time.time(), line) for line in process.stdout]
    if process.returncode:
        raise SystemExit("".join(line for _, line in lines[-40:]))
    return lines


def prepare(folder, ranks):
    """Mesh and decomposition."""
    run(["blockMesh"], folder)
    if ranks > 1:
        run(["decomposePar"], folder)


def pieces(kind, folder, ranks):
    """Seconds of each piece of a run of one kind."""
    mpi = grainjet.mpirun(ranks if ranks > 1 else 0)
    if kind == "grains":
        output = run([*mpi, "liggghts-plugins", "-var", "continued", "0", "-in", "in.alone"], folder)
        rows = (re.fullmatch(r" *\d+ +([\d.e+-]+) *\n", line) for _, line in output)
        ends = [float(row[1]) for row in rows if row][SKIP // PIECE:]
    else:
        for old in [*folder.glob("processor*/[0-9]*"), *folder.glob("[0-9]*")]:
            if old.name != "0":
                shutil.rmtree(old)
        output = run([*mpi, "pimpleFoam", *(["-parallel"] if ranks > 1 else [])], folder)
        # a step ends with this line, and its output is flushed there
        ends = [when for when, line in output if line.startswith("ExecutionTime")][SKIP - 1::PIECE]
    if len(ends) != PIECES + 1:
        raise SystemExit(f"{kind}: {len(ends)} times instead of {PIECES + 1}")
    return [b - a for a, b in zip(ends, ends[1:])]


def least(repetitions):
    """The sum over all pieces of the shortest time of each, per fluid step."""
    return sum(map(min, zip(*repetitions))) / (PIECE * PIECES)


def overhead(taken, choice=slice(None)):
    """(coupled - fluid - grains)/(fluid + grains) of some repetitions, in %."""
    fluid, grains, coupled = (least(taken[kind][choice]) for kind in ("fluid", "grains", "coupled"))
    return 100 * (coupled / (fluid + grains) - 1)


def own_clock(folder):
    """The coupling's time over that of fluid and DEM in the latest run of a case, in %."""
    table = max(folder.glob("postProcessing/liggghtsCoupling/*/balance*.dat"),
                key=lambda path: path.stat().st_mtime)
    rows = [line.split() for line in table.read_text().splitlines()]
    names = [row for row in rows if row[0] == "#"][-1][1:]
    last = [[float(cell) for cell in row] for row in rows if row[0] != "#"][SKIP:]
    fluid, dem, coupling = (sum(row[names.index("seconds" + part)] for row in last)
                            for part in ("Fluid", "DEM", "Coupling"))
    return 100 * coupling / (fluid + dem)


def peak(command, folder):
    """Largest resident memory of a rank of a command that must succeed, in bytes."""
    with open(folder / "log.memory", "w") as log:
        run = subprocess.Popen([str(c) for c in command], cwd=folder, env=ENV,
                               stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        _, status, usage = os.wait4(run.pid, 0)
    if status:
        raise SystemExit((folder / "log.memory").read_text()[-3000:])
    return 1024 * usage.ru_maxrss


def memory(options, work):
    """Bytes per grain of the coupling, for each number of ranks."""
    few, many = min(options.grains), max(options.grains)
    print("| ranks | grains | coupled: bytes per grain | grains alone | the coupling |\n"
          "|---|---|---|---|---|", flush=True)
    for ranks in options.ranks:
        mpi = grainjet.mpirun(ranks if ranks > 1 else 0)
        used = {}
        for grains in (few, many):
            folder = work / f"memory-{ranks}-{grains}"
            write_case(folder, grains, 10, ranks, 5, True, options.two_way)
            control = folder / "system/controlDict"
            control.write_text(control.read_text().replace("writeInterval 5;", "writeInterval 100;"))
            prepare(folder, ranks)
            alone = (folder / "in.alone").read_text()
            (folder / "in.alone").write_text("\n".join(
                line for line in alone.splitlines() if "fluid" not in line) + "\n")
            used["coupled", grains] = peak(
                [*mpi, "pimpleFoam", *(["-parallel"] if ranks > 1 else [])], folder)
            used["alone", grains] = peak(
                [*mpi, "liggghts-plugins", "-var", "continued", "0", "-in", "in.alone"], folder)
        # per grain of the rank that is looked at
        slope = {kind: (used[kind, many] - used[kind, few]) / ((many - few) / ranks)
                 for kind in ("coupled", "alone")}
        print(f"| {ranks} | {few} to {many} | {slope['coupled']:.0f} | {slope['alone']:.0f} "
              f"| {slope['coupled'] - slope['alone']:.0f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--grains", type=int, nargs="+", default=[20000, 100000])
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--interval", type=int, nargs="+", default=[50, 10])
    parser.add_argument("--repeat", type=int, default=6)
    parser.add_argument("--outer", type=int, default=1, help="outer correctors of a fluid step")
    parser.add_argument("--two-way", action="store_true")
    parser.add_argument("--memory", action="store_true")
    parser.add_argument("--output")
    options = parser.parse_args()
    work = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-benchmark-"))
    if options.memory:
        memory(options, work)
        shutil.rmtree(work)
        return

    rows = ["| grains | ranks | DEM steps per fluid step | fluid s | grains s | coupled s | overhead % "
            "| scatter % | own clock % | overhead, us per grain and interval "
            "| remote grains % | bytes sent per step |",
            "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    print("\n".join(rows), flush=True)
    for grains in options.grains:
        for ranks in options.ranks:
            for interval in options.interval:
                cases = {kind: work / f"{grains}-{ranks}-{interval}-{kind}"
                         for kind in ("fluid", "coupled")}
                for kind, folder in cases.items():
                    write_case(folder, grains, interval, ranks, STEPS, kind == "coupled",
                               options.two_way, options.outer)
                    prepare(folder, ranks)
                cases["grains"] = cases["fluid"]
                taken = {kind: [] for kind in cases}
                clock = []
                for _ in range(options.repeat):
                    for kind in cases:
                        taken[kind].append(pieces(kind, cases[kind], ranks))
                    clock.append(own_clock(cases["coupled"]))
                wall = [least(taken[kind]) for kind in ("fluid", "grains", "coupled")]
                halves = (f"{overhead(taken, slice(i, None, 2)):.1f}" for i in (0, 1)
                          if options.repeat > 1)
                balance = box.read_balance(cases["coupled"])
                remote = 100 * statistics.mean(balance["remote"]) / grains
                sent = (balance["bytes"][-1] - balance["bytes"][0]) / (STEPS - 1)
                rows.append(
                    "| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.1f} | {} | {:.1f} | {:.2f} "
                    "| {:.1f} | {:.0f} |".format(
                        grains, ranks, interval, *wall, overhead(taken), ", ".join(halves),
                        statistics.median(clock), 1e6 * ranks * (wall[2] - wall[0] - wall[1]) / grains,
                        remote, sent))
                print(rows[-1], flush=True)
    shutil.rmtree(work)
    if options.output:
        pathlib.Path(options.output).write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
