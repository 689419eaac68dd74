#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a coupled run takes beyond its fluid and its DEM, each by itself.

    overhead = (coupled - fluid - DEM)/(fluid + DEM)

DEM is without any force of a fluid. The box of run.py, coupled one way, so that the solver makes the same iterations
alone. Programs: the fluid (pimpleFoam), DEM and the coupled run, the latter two with stock integration (nve/sphere, and
fix gravity if there is gravity; `fix hertz/cg`) and with `fix grain/motion`. In each round all of them take turns.
Printed are the medians over the rounds, with the smallest and the largest, of the overhead of
    motion/motion   coupled and DEM with grain/motion
    motion/stock    coupled with grain/motion, DEM with stock integration
    stock/stock     both with stock integration
by processor time, since other work on the machine disturbs the wall clock more. On several ranks it holds their waiting.
The start of a program does not count: the first steps are taken off, in the solver by its own clock, for DEM by
a run of these steps alone.

--models all: drag, pressureGradient, viscous, buoyancy, SaffmanMei, Magnus, fluidTorque, wallLaw, Langevin, as quickJet has
them, in the box of models.py (walls at both ends of x, gravity); drag: Gidaspow, pressureGradient, viscous.

--counts: instructions under valgrind, one rank, in a smaller box with as many grains per cell, instead of times: what
other work does not change.

    source environment; validation/benchmarks/coupling/overhead.py [--grains 20000 100000] [--ranks 1 2]
        [--models drag all] [--interval 50] [--steps 20] [--repeat 5] [--counts] [--cells 37]
"""

import argparse
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import tempfile

import grainjet
from grainjet import coupled_box as box, dictionaries
import instructions
import models
import run as benchmark

SKIP = 4        # fluid steps that do not count
PAIRS = (("motion", "motion"), ("motion", "stock"), ("stock", "stock"))
PROGRAMS = ("fluid", "DEM stock", "DEM motion", "coupled stock", "coupled motion")
FLUID = "fix fluid all fluid/force coupled"


def write(folder, program, grains, ranks, steps, name, options):
    """The case of a program."""
    kind, _, integrator = program.partition(" ")
    benchmark.write_case(folder, grains, options.interval, ranks, steps, kind != "fluid", cells=options.cells)
    if name == "all":
        side = 1e-3 * options.cells
        benchmark.write_grains(folder, grains, side, margin=1e-4)
        models.write_walls(folder, side)
        if kind != "fluid":
            forces = models.forces("pressureGradient { turbulentPressure yes; }", models.LIFT)
            box.fv_options(folder, couplingInterval=options.interval, coupling="oneWay", drag=None, forces=forces,
                           wallLaw="yes", turbulentDispersion="Langevin")
    dictionaries.put(folder / "system/controlDict", writeInterval=10 * steps)
    for script in (folder / "constant/in.particles", folder / "in.alone"):
        text = script.read_text()
        if integrator == "motion":
            weight = " gravity 9.81 0 0 -1" if "fix gravity" in text else ""
            text = re.sub("fix gravity .*\n", "", text)
            fluid = " fluid fluid" if kind == "coupled" else ""
            text = text.replace("fix move all nve/sphere", f"plugin load grainmotionplugin.so\nfix move all grain/motion{weight}{fluid}")
        if kind == "DEM":
            text = text.replace(FLUID + "\n", "")
        script.write_text(text)
    benchmark.prepare(folder, ranks)


def kind_of(program):
    return "grains" if program.startswith("DEM") else program.split()[0]


def processor_seconds(program, folder, ranks):
    """Processor time of a run of DEM, all ranks."""
    with open(folder / "log", "w") as log:
        process = subprocess.Popen([str(c) for c in benchmark.command("grains", ranks)], cwd=folder,
                                   env={**benchmark.ENV, "PWD": str(folder)}, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise SystemExit((folder / "log").read_text()[-3000:])
    return usage.ru_utime + usage.ru_stime


def seconds(program, folder, ranks, options):
    """Processor seconds of a fluid step of a program, of one rank."""
    if program.startswith("DEM"):
        script = (folder / "in.alone").read_text()
        taken = []
        for steps in (SKIP, options.steps):
            (folder / "in.alone").write_text(re.sub(r"run \d+\s*$", f"run {steps * options.interval}\n", script))
            taken.append(processor_seconds(program, folder, ranks))
        (folder / "in.alone").write_text(script)
        return (taken[1] - taken[0]) / (options.steps - SKIP) / ranks
    benchmark.remove_times(folder)
    output = "".join(line for _, line in benchmark.run(benchmark.command(kind_of(program), ranks), folder))
    ends = [float(value) for value in re.findall(r"^ExecutionTime = (\S+) s", output, re.M)]
    return (ends[-1] - ends[SKIP - 1]) / (options.steps - SKIP)


def overheads(taken):
    """The overhead of each pair, in %."""
    return [100 * (taken["coupled " + coupled] / (taken["fluid"] + taken["DEM " + alone]) - 1) for coupled, alone in PAIRS]


def measure(name, grains, ranks, options, work):
    folders = {program: work / f"{name}-{grains}-{ranks}-{program.replace(' ', '-')}" for program in PROGRAMS}
    for program, folder in folders.items():
        write(folder, program, grains, ranks, options.steps, name, options)
    rounds = [{program: seconds(program, folder, ranks, options) for program, folder in folders.items()}
              for _ in range(options.repeat)]
    cells = [f"{1e3 * statistics.median(taken[program] for taken in rounds):.1f}" for program in PROGRAMS]
    for values in zip(*map(overheads, rounds)):
        cells.append(f"{statistics.median(values):.1f} ({min(values):.1f} to {max(values):.1f})")
    print(f"| {name} | {grains} | {ranks} | " + " | ".join(cells) + " |", flush=True)


def count(name, grains, options, work):
    taken = {}
    for program in PROGRAMS:
        ends = []
        for steps in (2, 6):
            folder = work / f"{name}-{grains}-{program.replace(' ', '-')}-{steps}"
            write(folder, program, grains, 1, steps, name, options)
            ends.append(instructions.instructions(kind_of(program), folder, benchmark.ENV)["all"])
        taken[program] = (ends[1] - ends[0]) / 4
    cells = [f"{taken[program] / 1e6:.2f}" for program in PROGRAMS] + [f"{value:.1f}" for value in overheads(taken)]
    print(f"| {name} | {grains} | 1 | " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--grains", type=int, nargs="+")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--models", nargs="+", choices=("drag", "all"), default=["drag", "all"])
    parser.add_argument("--interval", type=int, default=50)
    parser.add_argument("--steps", type=int, default=20)
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--cells", type=int)
    parser.add_argument("--counts", action="store_true")
    options = parser.parse_args()
    options.cells = options.cells or (12 if options.counts else benchmark.CELLS)
    options.grains = options.grains or ([682, 3411] if options.counts else [20000, 100000])
    work = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-overhead-"))
    unit = "millions of instructions" if options.counts else "ms"
    heads = ["models", "grains", "ranks", *(f"{program}, {unit}" for program in PROGRAMS), *(f"{a}/{b}, %" for a, b in PAIRS)]
    print("| " + " | ".join(heads) + " |\n" + len(heads) * "|---" + "|", flush=True)
    for name in options.models:
        for grains in options.grains:
            if options.counts:
                count(name, grains, options, work)
                continue
            for ranks in options.ranks:
                measure(name, grains, ranks, options, work)
    shutil.rmtree(work)


if __name__ == "__main__":
    main()
