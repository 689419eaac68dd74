#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Messages, bytes and collective calls per rank and fluid step, and memory per rank, on 1 to 16 ranks: what more ranks
than cores can tell, since none of it depends on time.

    coupling = coupled - fluid alone - grains alone

of the difference between a run of `long` and one of `short` fluid steps. A box of cubes of cells, periodic, with grains at rest
in moving air, cut alike for fluid and grains: weak (each rank holds one cube) and strong (all ranks share what 16 of them hold).

    source environment; validation/benchmarks/scaling/run.py [weak] [strong] [--ranks 1 2 4 8 16] [--output FOLDER]
"""

import argparse
import collections
import json
import os
import pathlib
import random
import shutil
import subprocess
import tempfile

import grainjet
from grainjet import coupled_box as box, dictionaries

HERE = pathlib.Path(__file__).resolve().parent

# How ranks cut the box, along x, y, z
CUTS = {1: (1, 1, 1), 2: (1, 1, 2), 4: (1, 2, 2), 8: (2, 2, 2), 16: (2, 2, 4)}
CELLS, SIDE = 8, 8              # of the cube of a rank: cells along a side; mm
GRAINS = 512                    # in it
DIAMETER = 2e-4
FLUID_STEP, INTERVAL = 1e-4, 10
SHORT, LONG = 4, 12             # fluid steps
KINDS = ("fluid", "grains", "coupled")


def build(folder):
    """The counting library."""
    library = folder/"libcountmpi.so"
    subprocess.run(["mpicxx", "-DOMPI_SKIP_MPICXX", "-O2", "-fPIC", "-shared", HERE/"count_mpi.cpp", "-o", library, "-ldl"], check=True)
    return library


def positions(cubes, seed):
    """One grain at a random place of each cell of a lattice, as many for each cube."""
    n = round(GRAINS**(1/3))
    step = 1e-3*SIDE/n
    draw = random.Random(seed)
    return [tuple((i + 0.3 + 0.4*draw.random())*step for i in place)
            for place in ((i, j, k) for i in range(n*cubes[0]) for j in range(n*cubes[1]) for k in range(n*cubes[2]))]


def write_case(folder, kind, ranks, cubes, steps):
    cut = CUTS[ranks]
    size = tuple(SIDE*c for c in cubes)
    cells = " ".join(str(CELLS*c) for c in cubes)
    cut_text = "({} {} {})".format(*cut)
    box.write(folder, velocity="(1 0.5 2)", steps=steps, cells=cells, size=size, decomposition=cut_text, ranks=ranks, delta_t=FLUID_STEP)
    dictionaries.change(folder/"system/fvSolution", ("1e-14", "1e-6"))
    x = positions(cubes, 1)
    extent = " ".join(f"0 {1e-3*s!r}" for s in size)
    box.script(folder, grains=box.grains(x, [(0, 0, 0)]*len(x), DIAMETER), box=extent, dt=FLUID_STEP/INTERVAL,
               processors="processors {} {} {}".format(*cut), end=f"run {INTERVAL*steps}" if kind == "grains" else "")
    if kind == "coupled":
        box.fv_options(folder, couplingInterval=str(INTERVAL))
    elif kind == "grains":
        script = folder/"constant/in.particles"
        script.write_text("variable continued equal 0\n" + script.read_text())


def finish(command, case):
    result = grainjet.run(command, case, timeout=3000)
    if result.code != 0:
        raise SystemExit(f"{result}")


def counts(folder, kind, ranks, cubes, steps, library):
    """Of each rank: {"tree" or "message" or a collective: calls, bytes, ranks, by site}."""
    case = folder/f"{kind}-{ranks}-{steps}-{'x'.join(map(str, cubes))}"
    write_case(case, kind, ranks, cubes, steps)
    if kind != "grains":
        finish(["blockMesh"], case)
        if ranks > 1:
            finish(["decomposePar"], case)
    program = ["liggghts-plugins", "-in", "constant/in.particles"] if kind == "grains" else ["pimpleFoam", *(["-parallel"] if ranks > 1 else [])]
    preload = [f"LD_PRELOAD={library}:{os.environ.get('LD_PRELOAD', '')}".rstrip(":"), f"GRAINJET_MPI_COUNTS={case/'counts'}"]
    finish([*grainjet.mpirun(ranks), "env", *preload, *program], case)
    result = []
    for rank in range(ranks):
        found, memory = {}, None
        for line in (case/f"counts.{rank}").read_text().splitlines():
            words = line.split()
            if words[0] == "memory":
                memory = int(words[1])
                continue
            name, site = words[0], words[3]
            if site.startswith("tree:"):
                name = "tree"
            to = set(words[4].split(",")) if len(words) > 4 else set()
            found[name, site] = (int(words[1]), float(words[2]), to)
        result.append((found, memory))
    shutil.rmtree(case)
    return result


Figures = collections.namedtuple("Figures", "messages bytes neighbours trees collectives sites memory")


def per_step(folder, kind, ranks, cubes, library):
    """Of the rank with the largest value: messages, bytes, ranks they go to, messages of trees, collective calls per fluid step."""
    short, long = (counts(folder, kind, ranks, cubes, steps, library) for steps in (SHORT, LONG))
    each = []
    for (first, _), (second, memory) in zip(short, long):
        def rate(wanted, column):
            return sum(entry[column] - first.get(key, (0, 0))[column] for key, entry in second.items() if wanted(key[0]))/(LONG - SHORT)

        going = {key: (entry[0] - first.get(key, (0,))[0])/(LONG - SHORT) for key, entry in second.items()}
        to = set().union(*(entry[2] for key, entry in second.items() if key[0] == "message" and going[key] > 0), set())
        each.append(Figures(rate(lambda name: name == "message", 0), rate(lambda name: name == "message", 1), len(to),
                            rate(lambda name: name == "tree", 0), rate(lambda name: name not in ("message", "tree"), 0),
                            {f"{name} {site}": n for (name, site), n in going.items() if n > 0}, memory))
    return each


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("series", nargs="*", default=["weak", "strong"], choices=["weak", "strong"])
    parser.add_argument("--ranks", type=int, nargs="+", default=sorted(CUTS), choices=sorted(CUTS))
    parser.add_argument("--output", type=pathlib.Path, help="folder for the figures of all ranks and sites, as JSON")
    options = parser.parse_args()

    work = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-scaling-"))
    library = build(work)
    found = {}
    for series in options.series:
        print(f"\n{series}: the largest of the ranks, per fluid step of {INTERVAL} DEM steps\n")
        print("| ranks | program | messages | kB | ranks sent to | messages of trees | collective calls | memory, MB |\n" + 8*"|---" + "|", flush=True)
        for ranks in options.ranks:
            cubes = CUTS[ranks] if series == "weak" else CUTS[16]
            for kind in KINDS:
                each = per_step(work, kind, ranks, cubes, library)
                found[f"{series} {ranks} {kind}"] = [figures._asdict() for figures in each]
                top = [max(getattr(figures, name) for figures in each) for name in ("messages", "bytes", "neighbours", "trees", "collectives", "memory")]
                print(f"| {ranks} | {kind} | {top[0]:.1f} | {1e-3*top[1]:.1f} | {top[2]} | {top[3]:.1f} | {top[4]:.1f} | {top[5]/1024:.1f} |", flush=True)
    if options.output:
        options.output.mkdir(parents=True, exist_ok=True)
        (options.output/"counts.json").write_text(json.dumps(found, indent=1) + "\n")
    shutil.rmtree(work)


if __name__ == "__main__":
    main()
