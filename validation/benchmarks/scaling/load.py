#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""How evenly a jet's work is divided among ranks, before and after decomposition by weight: quickJet (mesh, steady flow, coupled run on one rank
until grains are all along the jet), then decomposed in several ways at its last time and continued for some fluid steps.

    source environment; validation/benchmarks/scaling/load.py FOLDER [--time 0.05] [--steps 4]

FOLDER: made if it does not exist; what is there is not made again. Counts only: largest over mean of cells, of grains by the rank that owns them
(mesh) and that holds them (LIGGGHTS), and of both with their costs; grains that are remote, and bytes per exchange.
"""

import argparse
import pathlib
import re
import shutil

import numpy
import grainjet
from grainjet import coupled_box, dictionaries, fields
from grainjet.mpi_counts import many
from grainjet.programs import done

COST = 7.3      # grainCost: 5 exchanges of 1.81 us and 50 DEM steps of 95 ns, over 1.90 us of a cell (validation/cases/report.md)
# name: how decomposePar cuts along x, y, z, whether by weight; grid of LIGGGHTS
WAYS = {
    "slices": ((1, 1, 4), False, "1 1 *"),
    "slices, weights": ((1, 1, 4), True, "1 1 *"),
    "quarters": ((2, 2, 1), False, "2 2 1 map xyz"),
    "quarters, weights": ((2, 2, 1), True, "2 2 1 map xyz"),
    "halves of halves": ((1, 2, 2), False, "1 2 2 map xyz"),
    "halves of halves, weights": ((1, 2, 2), True, "1 2 2 map xyz"),
    "quarters, ranks of LIGGGHTS in its own order": ((2, 2, 1), False, "2 2 1"),
}
RANKS = 4


def prepare(folder, time):
    """The jet on one rank, its grains along all of it."""
    shutil.copytree(grainjet.ROOT/"cases/quickJet", folder, ignore=shutil.ignore_patterns("tests", "processor*", "results", "[1-9]*"))
    grainjet.run(["./Allclean"], folder)
    dictionaries.put(folder/"system/parameters", ranks=1)
    options = folder/"system/fvOptions"
    options.write_text(options.read_text().replace(
        "    turbulenceSources none;", f"    turbulenceSources none;\n\n    decompositionWeights {{ grainCost {COST}; }}"))
    job = f". {grainjet.ROOT}/cases/common/job.sh; set -eu; root={grainjet.ROOT}"
    done(["bash", "-c", f"{job}; mesh_stage"], folder, "log.mesh")
    # not before: nothing is sampled, and particleInput wants a time of sampling in the run
    dictionaries.put(folder/"system/parameters", endTime=time, writeInterval=time/5)
    done(["bash", "-c", f"{job}; steady_stage; pimpleFoam > log.pimpleFoam"], folder, "log.stages")


def ratio(values):
    values = numpy.asarray(values, float)
    return values.max()/values.mean()


def held(folder, time, ranks, grid):
    """Grains of each rank of LIGGGHTS, whose ranks divide the box into equal bricks."""
    _, places, _ = fields.grains_at(folder/"postProcessing/grains", time)
    numbers = [int(n) if n != "*" else None for n in grid.split()[:3]]
    known = numpy.prod([n for n in numbers if n])
    numbers = [n or int(ranks//known) for n in numbers]
    script = (folder/"constant/particles/parameters").read_text()
    value = lambda name: float(re.search(rf"variable\s+{name}\s+\w+\s+(\S+)", script).group(1))     # noqa: E731
    low = numpy.array([-value("boxRadius"), -value("boxRadius"), value("zInlet")])
    high = numpy.array([value("boxRadius"), value("boxRadius"), value("zEnd")])
    brick = numpy.clip(((places - low)/(high - low)*numbers).astype(int), 0, numpy.array(numbers) - 1)
    index = (brick[:, 2]*numbers[1] + brick[:, 1])*numbers[0] + brick[:, 0]
    return numpy.bincount(index, minlength=ranks)


def way(folder, name, time, steps):
    """Decompose at the last time, continue, and count."""
    cut, weighted, grid = WAYS[name]
    ranks = RANKS
    case = folder.parent/f"{folder.name}-{re.sub('[^a-z0-9]+', '-', name.lower())}"
    shutil.rmtree(case, ignore_errors=True)
    shutil.copytree(folder, case, symlinks=True, ignore=shutil.ignore_patterns("spinUp", "processor*", "log.*"))
    (case/"system/decomposeParDict").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\n"
        f"numberOfSubdomains {ranks}; method simple; simpleCoeffs {{ n ({cut[0]} {cut[1]} {cut[2]}); delta 0.001; }}\n"
        + ("weightField decompositionWeights;\n" if weighted else ""))
    options = case/"system/fvOptions"
    options.write_text(re.sub(r"grainCost [^;]*;", f"grainCost {COST};", options.read_text()))
    script = case/"constant/in.particles"
    script.write_text(re.sub(r"(?m)^processors .*$", f"processors {grid}", script.read_text()))
    control = case/"system/controlDict"
    control.write_text(re.sub(r"(?m)^writeFormat .*$", "writeFormat ascii;", control.read_text()))
    fluid_step = float(re.search(r"fluidStep\s+([\d.e-]+)", (case/"system/parameters").read_text()).group(1))
    dictionaries.put(case/"system/parameters", endTime=f"{time + steps*fluid_step:.8g}", writeInterval=f"{steps*fluid_step:.8g}")
    output = done(["decomposePar", "-latestTime"], case, "log.decomposePar")
    cells = [int(n) for n in re.findall(r"Number of cells = (\d+)", output)][:ranks]
    done([*many(ranks), "pimpleFoam", "-parallel"], case, "log.pimpleFoam")
    end = next(p.name for p in sorted((case/"processor0").iterdir(), key=lambda p: p.stat().st_mtime, reverse=True)
               if re.fullmatch(r"[\d.e-]+", p.name))
    owned = []
    for rank in range(ranks):
        weights = dictionaries.internal(case/f"processor{rank}/{end}/decompositionWeights")
        owned.append((numpy.asarray(weights) - 1).sum()/COST)
    grains = held(case, float(end), ranks, grid)
    balance = coupled_box.read_balance(case, f"{time:g}")
    exchanges = (len(balance["bytes"]) - 1)*5
    work = numpy.asarray(cells) + COST*numpy.asarray(owned)
    print(f"| {name} | {ratio(cells):.2f} | {ratio(owned):.2f} | {ratio(grains):.2f} | {ratio(work):.2f} | {balance['remote'][-1]/balance['present'][-1]:.2f} | "
          f"{(balance['bytes'][-1] - balance['bytes'][0])/exchanges/1e3:.0f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--time", type=float, default=0.06)
    parser.add_argument("--steps", type=int, default=4)
    options = parser.parse_args()
    folder = options.folder.resolve()
    if not folder.exists():
        prepare(folder, options.time)
    print("| decomposition | cells | grains, by owner | grains, by LIGGGHTS' rank | cells + grainCost grains | remote/all | kB per exchange, all ranks |\n"
          + 7*"|---" + "|")
    for name in WAYS:
        way(folder, name, options.time, options.steps)


if __name__ == "__main__":
    main()
