#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Instructions of the coupling, per grain and fluid step: what other work on the machine does not change.

The case of run.py on one rank, smaller, under valgrind's callgrind:

    coupling = coupled - fluid alone - grains alone

of the difference between a run of 6 and one of 2 fluid steps, so that start-up does not count. Coupled one way,
so that the solver makes the same iterations alone. The first thread only, and without the libraries of MPI and the
dynamic linker, which look again and again whether something has come. Besides, the instructions of the libraries
themselves, without what they call; these are the same in each run. valgrind runs AVX2 but no AVX-512, and counts an
instruction that waits for memory as any other: this finds work that has been added, not the time it takes.

    source environment; validation/benchmarks/coupling/instructions.py [--grains 2000 4000] [--interval 50]
        [--cells 12] [--outer N] [--two-way] [--builds FOLDER FOLDER...]
"""

import argparse
import pathlib
import re
import shutil
import tempfile

import grainjet
import run as benchmark

OWN = ("libliggghtsCoupling.so", "fluidforceplugin.so")     # libraries counted by themselves
WAITING = re.compile("mca_|libmpi|libopen-|libevent|libpmix|ld-linux|libpsm|libinfinipath|libucp|libucs|libuct|libudev")


def count(path):
    """Instructions of a callgrind file: of all, and of each library in OWN without what it calls."""
    names, counts = {}, dict.fromkeys(OWN, 0)
    total, library, waits, call = 0, None, False, False
    with open(path) as lines:
        for line in lines:
            if line.startswith("ob="):
                number, _, name = line[3:].strip().partition(" ")
                name = names.setdefault(number, name)
                library = pathlib.Path(name).name
                waits = bool(WAITING.match(library))
            elif line.startswith("cob="):
                number, _, name = line[4:].strip().partition(" ")
                names.setdefault(number, name)
            elif line.startswith("calls="):
                call = True
            elif line[0] in "0123456789+-*":
                if not call and not waits:
                    value = int(line.split()[1])
                    total += value
                    if library in counts:
                        counts[library] += value
                call = False
    return {"all": total, **counts}


def instructions(kind, folder, env):
    """Counts of a run of one kind on one rank, of its largest process."""
    benchmark.remove_times(folder)
    for old in folder.glob("callgrind.*"):
        old.unlink()
    # quiet, since the launcher takes words on its screen for an error
    benchmark.run(["valgrind", "-q", "--tool=callgrind", "--separate-threads=yes", "--trace-children=yes",
                   "--callgrind-out-file=callgrind.%p", *benchmark.command(kind, 1)], folder, env)
    return max(map(count, folder.glob("callgrind.*-01")), key=lambda counts: counts["all"])


def measure(options, envs, work):
    """Prints a table of instructions per grain and fluid step."""
    if not shutil.which("valgrind"):
        raise SystemExit("valgrind is not installed: apt-get install valgrind")
    short, long = 2, 6      # fluid steps; what comes before the second one is start-up
    print("| build | grains | DEM steps per fluid step | fluid, millions per fluid step | grains | coupled | overhead % "
          "| coupling, per grain and fluid step | of that in libliggghtsCoupling.so itself "
          "| fluidforceplugin.so itself, coupled, per grain and DEM step |\n" + 10 * "|---" + "|", flush=True)
    for interval in options.interval:
        fluid = None
        for grains in options.grains:
            for i, env in enumerate(envs):
                counts = {}
                for kind in ("fluid", "grains", "coupled"):
                    if kind == "fluid" and fluid:
                        counts[kind] = fluid
                        continue
                    ends = []
                    for steps in (short, long):
                        folder = work / f"count-{grains}-{interval}-{steps}-{kind == 'coupled'}"
                        if not folder.exists():
                            benchmark.write_case(folder, grains, interval, 1, steps, kind == "coupled",
                                                 options.two_way, options.outer, options.cells)
                            benchmark.prepare(folder, 1)
                        ends.append(instructions(kind, folder, env))
                    counts[kind] = {name: (ends[1][name] - ends[0][name]) / (long - short) for name in ends[0]}
                fluid = counts["fluid"]
                alone = fluid["all"] + counts["grains"]["all"]
                more = counts["coupled"]["all"] - alone
                print("| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.1f} | {:.1f} | {:.2f} |".format(
                    options.builds[i].resolve().name, grains, interval, fluid["all"] / 1e6, counts["grains"]["all"] / 1e6,
                    counts["coupled"]["all"] / 1e6, 100 * more / alone, more / grains,
                    counts["coupled"][OWN[0]] / grains, counts["coupled"][OWN[1]] / grains / interval), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--grains", type=int, nargs="+", default=[2000, 4000])
    parser.add_argument("--interval", type=int, nargs="+", default=[50])
    parser.add_argument("--cells", type=int, default=12, help="along each side, of 1 mm")
    parser.add_argument("--outer", type=int, default=1, help="outer correctors of a fluid step")
    parser.add_argument("--builds", type=pathlib.Path, nargs="+", default=[grainjet.ROOT], help="built folders of Grainjet")
    parser.add_argument("--two-way", action="store_true")
    options = parser.parse_args()
    envs = [benchmark.environment(build) for build in options.builds]
    work = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-benchmark-"))
    measure(options, envs, work)
    shutil.rmtree(work)


if __name__ == "__main__":
    main()
