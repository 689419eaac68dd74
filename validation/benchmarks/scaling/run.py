#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Messages, bytes and collective operations per rank and fluid step, and memory per rank, on 1 to 16 ranks: what more ranks than cores
can tell, since none of it depends on time. A periodic box of cubes of cells, with grains at rest in moving air, cut alike for fluid and grains:

    weak      each rank holds one cube, cut into slices, so that a rank has two neighbours however many there are
    strong    all ranks share 8 cubes, cut into blocks
    apart     as weak, with the grains' box beside the mesh by 0 to 3 mm: grains that are remote
    sites     every collective operation of the coupling by its function, with 1 and 5 sub-steps, on 2 and 4 ranks

    source environment; validation/benchmarks/scaling/run.py [weak] [strong] [apart] [sites] [--ranks 1 2 4 8 16] [--output FOLDER]
"""

import argparse
import json
import pathlib
import shutil
import tempfile

from grainjet import mpi_counts as counts

SERIES = ("weak", "strong", "apart", "sites")
HEAD = "| ranks | part | messages | kB | ranks sent to | collectives | memory of the run, MB |\n" + 7*"|---" + "|"


def line(first, part, figures):
    return (f"| {first} | {part} | {figures.messages:.1f} | {1e-3*figures.bytes:.1f} | {figures.neighbours} | "
            f"{figures.collectives:.1f} | {figures.memory/1024:.1f} |")


def series(name, ranks, work, library, found):
    print(f"\n{name}: the largest of the ranks, per fluid step of {counts.INTERVAL} DEM steps\n\n{HEAD}", flush=True)
    for n in ranks:
        cut, cubes = (counts.SLICES[n], counts.SLICES[n]) if name == "weak" else (counts.BLOCKS[n], counts.BLOCKS[8])
        for kind in counts.KINDS:
            for part, each in counts.per_step(work, kind, cut, cubes, library).items():
                found[f"{name} {n} {kind} {part}"] = [figures._asdict() for figures in each]
                label = part if kind == "coupled" else f"{kind} alone"
                print(line(n, label, counts.largest(each)), flush=True)


def apart(work, library, found):
    print("\napart: 4 ranks, weak, the coupling's part\n\n| the grains' box beside the mesh, mm | messages | kB | ranks sent to | collectives |\n"
          + 5*"|---" + "|", flush=True)
    cut = counts.SLICES[4]
    for shift in (0.0, 0.75, 1.5, 3.0):
        each = counts.per_step(work, "coupled", cut, cut, library, shift=shift)["coupling"]
        found[f"apart {shift}"] = [figures._asdict() for figures in each]
        top = counts.largest(each)
        print(f"| {shift:g} | {top.messages:.1f} | {1e-3*top.bytes:.1f} | {top.neighbours} | {top.collectives:.1f} |", flush=True)


def sites(work, library, found):
    print("\nsites: collective operations of the coupling per fluid step\n\n| function | operation | ranks | subSteps 1 | subSteps 5 |\n"
          + 5*"|---" + "|", flush=True)
    for n in (2, 4):
        by = []
        for sub_steps in (1, 5):
            cut = counts.BLOCKS[n]
            each = counts.per_step(work, "coupled", cut, cut, library, sub_steps=sub_steps, shift=0.75)["coupling"]
            found[f"sites {n} {sub_steps}"] = [figures._asdict() for figures in each]
            by.append(counts.largest(each).sites)
        for name in sorted(set().union(*by)):
            operation, site = name.split(" ", 1)
            print(f"| `{site.split('<-Foam::couplingPipeline')[0]}` | {'gather' if operation == 'up' else operation} | {n} | "
                  + " | ".join(f"{one.get(name, 0):g}" for one in by) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("series", nargs="*", default=list(SERIES), metavar="series", help=", ".join(SERIES))
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2, 4, 8, 16], choices=sorted(counts.BLOCKS))
    parser.add_argument("--output", type=pathlib.Path, help="folder for the figures of all ranks and sites, as JSON")
    options = parser.parse_args()
    unknown = set(options.series) - set(SERIES)
    if unknown:
        parser.error(f"no such series: {', '.join(sorted(unknown))}; there are {', '.join(SERIES)}")

    work = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-scaling-"))
    library = counts.build(work)
    found = {}
    for name in options.series:
        if name == "apart":
            apart(work, library, found)
        elif name == "sites":
            sites(work, library, found)
        else:
            series(name, options.ranks, work, library, found)
    if options.output:
        options.output.mkdir(parents=True, exist_ok=True)
        (options.output/"counts.json").write_text(json.dumps(found, indent=1) + "\n")
    shutil.rmtree(work)


if __name__ == "__main__":
    main()
