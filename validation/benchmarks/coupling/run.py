#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
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

--builds compares two or more builds of Grainjet, each a folder that ./Allwmake was run in: they take turns,
and the difference of each from the first is printed in percentage points, with that of each half; also that of
the processor time of whole runs, which other work disturbs less. On several ranks it holds their waiting.

--memory measures instead the memory of the coupling per grain: the growth of the largest rank's peak
with the number of grains, less that of the same grains without fix fluid/force.

instructions.py beside this file counts instructions, which other work on the machine does not change.

    source environment; validation/benchmarks/coupling/run.py [--grains 20000 100000] [--ranks 1 2]
        [--interval 50 10] [--repeat 6] [--outer N] [--two-way] [--builds FOLDER FOLDER...] [--output results.md]
    validation/benchmarks/coupling/run.py --memory [--grains 20000 100000] [--ranks 1 2]
"""

import argparse
import math
import os
import pathlib
import random
import re
import resource
import shutil
import statistics
import subprocess
import tempfile
import time

import grainjet
from grainjet import coupled_box as box, dictionaries

CELLS = 37                        # of 1 mm, along each side
SKIP, PIECE, PIECES = 5, 5, 7     # fluid steps before the first piece and in each; their number
STEPS = SKIP + PIECE * PIECES
DEM_STEP = 1e-6

PLUGINS = "plugin load hertzcgplugin.so"

# a rank that waits does not leave its core, as in a user's run on as many cores as ranks
ENV = {**grainjet.ENV, "OMPI_MCA_mpi_yield_when_idle": "0"}


def environment(build):
    """The environment after `source environment` in the folder of a build, and of no other one."""
    build = build.resolve()
    library = "libliggghtsCoupling.so"
    if not (build / "lib" / library).is_file():
        raise SystemExit(f"{build}/lib/{library} is missing: run {build}/Allwmake, with FOAM_USER_LIBBIN unset")
    here = {name: ":".join(part for part in value.split(":") if not part.startswith(f"{grainjet.ROOT}/"))
            if name in ("PATH", "LD_LIBRARY_PATH", "LIGGGHTS_PLUGIN_PATH") else value
            for name, value in ENV.items() if name not in ("GRAINJET_DIR", "FOAM_USER_LIBBIN")}
    printed = subprocess.run(["bash", "-c", f"source '{build}/environment' && env -0"], env=here,
                             check=True, stdout=subprocess.PIPE).stdout.decode()
    env = dict(item.split("=", 1) for item in printed.split("\0") if "=" in item)
    first = next(path for path in env["LD_LIBRARY_PATH"].split(":") if pathlib.Path(path, library).is_file())
    if pathlib.Path(first).resolve() != build / "lib":
        raise SystemExit(f"LD_LIBRARY_PATH finds {library} in {first} before {build}/lib: take that folder out")
    return env


def write_grains(folder, n, side, margin=0):
    """A data file of n grains at random places, a margin away from both ends of x."""
    rng = random.Random(1)
    with open(folder / "constant/grains.data", "w") as out:
        out.write(f"grains\n\n{n} atoms\n1 atom types\n\n"
                  + "".join(f"0 {side} {k}lo {k}hi\n" for k in "xyz") + "\nAtoms\n\n")
        for i in range(1, n + 1):
            x, y, z = (rng.uniform(low, side - low) for low in (margin, 0, 0))
            out.write(f"{i} 1 8e-5 2950 {x} {y} {z}\n")
        out.write("\nVelocities\n\n")
        for i in range(1, n + 1):
            u, v, w = (rng.gauss(m, 0.3) for m in (0, 0, 6))
            out.write(f"{i} {u} {v} {w} 0 0 0\n")


def write_vortices(folder, cells):
    """Taylor-Green vortices of 1 m/s across the stream and some shear along it, so that the linear
    solvers have their usual work."""
    k = 2 * math.pi / cells
    values = []
    for _ in range(cells):
        for j in range(cells):
            for i in range(cells):
                x, y = k * (i + 0.5), k * (j + 0.5)
                values.append(f"({math.sin(x) * math.cos(y):.9g} {-math.cos(x) * math.sin(y):.9g} "
                              f"{8 + 0.5 * math.sin(x):.9g})")
    path = folder / "0/U"
    path.write_text(path.read_text().replace(
        "uniform (0 0 8)", f"nonuniform List<vector> {len(values)}\n(\n" + "\n".join(values) + "\n)"))


def write_turbulence(folder, outer):
    """kEpsilon with the schemes and linear solvers of the main job."""
    for name in ("fvSchemes", "fvSolution"):
        text = (grainjet.ROOT / "cases/quickJet/system" / name).read_text()
        (folder / "system" / name).write_text(text.replace(
            "nOuterCorrectors 1;", f"nOuterCorrectors {outer}; pRefCell 0; pRefValue 0;"))
    dictionaries.write(folder / "constant/turbulenceProperties",
                       "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }")
    for field, dimensions, value in (("k", "0 2 -2", 0.24), ("epsilon", "0 2 -3", 18.4),
                                     ("nut", "0 2 -1", 0)):
        dictionaries.write_field(folder, field, dimensions, value, '".*" { type cyclic; }')


def write_case(folder, grains, interval, ranks, steps, coupled, two_way=False, outer=1, cells=CELLS):
    """The case; coupled or the fluid alone, and a script for the grains alone."""
    dt = interval * DEM_STEP
    box.write(folder, steps=steps, delta_t=dt, cells=" ".join([str(cells)] * 3),
              velocity="(0 0 8)", ranks=ranks, decomposition=f"(1 1 {ranks})",
              libs='("libliggghtsCoupling.so")' if coupled else "()")
    side = 1e-3 * cells
    corners = [(x * cells, y * cells, z * cells) for z in (0, 1)
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
    write_grains(folder, grains, side)
    write_vortices(folder, cells)
    if coupled:
        box.fv_options(folder, couplingInterval=interval,
                       coupling="twoWay" if two_way else "oneWay")
    (folder / "in.alone").write_text("\n".join(lines) + f"""
thermo_style custom step cpu
thermo {PIECE * interval}
run {steps * interval}
""")


def run(command, folder, env=ENV):
    """The output of a command that must succeed, line by line with the time at which it came."""
    with subprocess.Popen([str(c) for c in command], cwd=folder, text=True,
                          env={**env, "PWD": str(folder)}, stdin=subprocess.DEVNULL,
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


def command(kind, ranks):
    """A run of one kind."""
    mpi = grainjet.mpirun(ranks if ranks > 1 else 0)
    if kind == "grains":
        return [*mpi, "liggghts-plugins", "-var", "continued", "0", "-in", "in.alone"]
    return [*mpi, "pimpleFoam", *(["-parallel"] if ranks > 1 else [])]


def remove_times(folder):
    """What a former run of the solver has written."""
    for old in [*folder.glob("processor*/[0-9]*"), *folder.glob("[0-9]*")]:
        if old.name != "0":
            shutil.rmtree(old)


def pieces(kind, folder, ranks, env):
    """Seconds of each piece of a run of one kind."""
    if kind == "grains":
        output = run(command(kind, ranks), folder, env)
        rows = (re.fullmatch(r" *\d+ +([\d.e+-]+) *\n", line) for _, line in output)
        ends = [float(row[1]) for row in rows if row][SKIP // PIECE:]
    else:
        remove_times(folder)
        output = run(command(kind, ranks), folder, env)
        # a step ends with this line, and its output is flushed there
        ends = [when for when, line in output if line.startswith("ExecutionTime")][SKIP - 1::PIECE]
    if len(ends) != PIECES + 1:
        raise SystemExit(f"{kind}: {len(ends)} times instead of {PIECES + 1}")
    return [b - a for a, b in zip(ends, ends[1:])]


def processor_time():
    """Seconds of all programs run so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def least(repetitions):
    """The sum over all pieces of the shortest time of each, per fluid step."""
    return sum(map(min, zip(*repetitions))) / (PIECE * PIECES)


def overhead(taken, choice=slice(None)):
    """(coupled - fluid - grains)/(fluid + grains) of some repetitions, in %."""
    fluid, grains, coupled = (least(taken[kind][choice]) for kind in ("fluid", "grains", "coupled"))
    return 100 * (coupled / (fluid + grains) - 1)


def latest_balance(folder):
    """The columns of the table of the latest run; a second run in a folder gets a table of another name."""
    table = max(folder.glob("postProcessing/liggghtsCoupling/*/balance*.dat"), key=lambda path: path.stat().st_mtime)
    rows = [line.split() for line in table.read_text().splitlines()]
    names = [row for row in rows if row[0] == "#"][-1][1:]
    values = [[float(cell) for cell in row] for row in rows if row[0] != "#"]
    return {name: [row[k] for row in values] for k, name in enumerate(names)}


def own_clock(balance):
    """The coupling's time over that of fluid and DEM in a coupled run, in %."""
    fluid, dem, coupling = (sum(balance["seconds" + part][SKIP:]) for part in ("Fluid", "DEM", "Coupling"))
    return 100 * coupling / (fluid + dem)


def peak(kind, folder, ranks):
    """Largest resident memory of a rank in a run of one kind, in bytes."""
    with open(folder / "log.memory", "w") as log:
        run = subprocess.Popen([str(c) for c in command(kind, ranks)], cwd=folder, env=ENV,
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
            used["coupled", grains] = peak("coupled", folder, ranks)
            used["alone", grains] = peak("grains", folder, ranks)
        # per grain of the rank that is looked at
        slope = {kind: (used[kind, many] - used[kind, few]) / ((many - few) / ranks)
                 for kind in ("coupled", "alone")}
        print(f"| {ranks} | {few} to {many} | {slope['coupled']:.0f} | {slope['alone']:.0f} "
              f"| {slope['coupled'] - slope['alone']:.0f} |", flush=True)


def measure(grains, ranks, interval, options, envs, work):
    """The rows of one case: one of each build, and how the others differ from the first."""
    builds = range(len(envs))
    names = ["fluid", *(f"coupled{i}" for i in builds)]
    cases = {name: work / f"{grains}-{ranks}-{interval}-{name}" for name in names}
    for name, folder in cases.items():
        write_case(folder, grains, interval, ranks, STEPS, name != "fluid", options.two_way, options.outer)
        prepare(folder, ranks)

    # the fluid alone loads nothing of Grainjet
    fluid = []
    taken = [{"fluid": fluid, "grains": [], "coupled": []} for _ in builds]
    clock = [[] for _ in builds]
    processor = [{"fluid": [], "grains": [], "coupled": []} for _ in builds]
    balance = {}
    for repetition in range(options.repeat):
        before = processor_time()
        fluid.append(pieces("fluid", cases["fluid"], ranks, envs[0]))
        for i in builds:
            processor[i]["fluid"].append(processor_time() - before)
        for kind in ("grains", "coupled"):
            for i in builds if repetition % 2 else reversed(builds):
                folder = cases["fluid" if kind == "grains" else f"coupled{i}"]
                before = processor_time()
                taken[i][kind].append(pieces(kind, folder, ranks, envs[i]))
                processor[i][kind].append(processor_time() - before)
                if kind == "coupled":
                    balance[i] = latest_balance(folder)
                    clock[i].append(own_clock(balance[i]))

    def halves(value):
        return [value(slice(k, None, 2)) for k in (0, 1) if options.repeat > 1]

    rows = []
    for i in builds:
        wall = [least(taken[i][kind]) for kind in ("fluid", "grains", "coupled")]
        scatter = ", ".join(f"{value:.1f}" for value in halves(lambda choice: overhead(taken[i], choice)))
        row = "| {} | {} | {} | {:.4f} | {:.4f} | {:.4f} | {:.2f} | {} | {:.2f} | {:.2f} |".format(
            grains, ranks, interval, *wall, overhead(taken[i]), scatter, statistics.median(clock[i]),
            1e6 * ranks * (wall[2] - wall[0] - wall[1]) / grains)
        if len(envs) > 1:
            rows.append(f"| {options.builds[i].resolve().name} {row}")
            continue
        remote = 100 * statistics.mean(balance[i]["remote"]) / grains
        sent = (balance[i]["bytes"][-1] - balance[i]["bytes"][0]) / (STEPS - 1)
        rows.append(f"{row} {remote:.1f} | {sent:.0f} |")
    for i in builds[1:]:
        def points(choice=slice(None)):
            return overhead(taken[i], choice) - overhead(taken[0], choice)

        def processor_points(choice=slice(None)):
            least_of = [{kind: min(values[choice]) for kind, values in processor[k].items()} for k in (0, i)]
            more = [of["coupled"] - of["grains"] for of in least_of]
            return 100 * (more[1] - more[0]) / (least_of[0]["fluid"] + least_of[0]["grains"])

        def text(value):
            return f"{value():+.2f} (halves {', '.join(f'{half:+.2f}' for half in halves(value))})"

        own = [b - a for a, b in zip(clock[0], clock[i])]
        coupled, alone = (least(taken[i][kind]) / least(taken[0][kind]) for kind in ("coupled", "grains"))
        rows.append(
            f"{options.builds[i].resolve().name} less {options.builds[0].resolve().name}, in percentage points: "
            f"overhead {text(points)}, processor time of whole runs {text(processor_points)}, own clock "
            f"{statistics.median(own):+.2f} (from {min(own):+.2f} to {max(own):+.2f}); coupled x {coupled:.4f}, "
            f"grains x {alone:.4f}")
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--grains", type=int, nargs="+", default=[20000, 100000])
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--interval", type=int, nargs="+", default=[50, 10])
    parser.add_argument("--repeat", type=int, default=6)
    parser.add_argument("--outer", type=int, default=1, help="outer correctors of a fluid step")
    parser.add_argument("--builds", type=pathlib.Path, nargs="+", help="built folders of Grainjet")
    parser.add_argument("--two-way", action="store_true")
    parser.add_argument("--memory", action="store_true")
    parser.add_argument("--output")
    options = parser.parse_args()
    envs = list(map(environment, options.builds)) if options.builds else [ENV]
    work = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-benchmark-"))
    if options.memory:
        memory(options, work)
        shutil.rmtree(work)
        return

    columns = (["build"] if len(envs) > 1 else []) + [
        "grains", "ranks", "DEM steps per fluid step", "fluid s", "grains s", "coupled s", "overhead %", "scatter %",
        "own clock %", "overhead, us per grain and interval"]
    if len(envs) == 1:
        columns += ["remote grains %", "bytes sent per step"]
    rows = ["| " + " | ".join(columns) + " |", len(columns) * "|---" + "|"]
    print("\n".join(rows), flush=True)
    for grains in options.grains:
        for ranks in options.ranks:
            for interval in options.interval:
                new = measure(grains, ranks, interval, options, envs, work)
                print("\n".join(new), flush=True)
                rows += new
    shutil.rmtree(work)
    if options.output:
        pathlib.Path(options.output).write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
