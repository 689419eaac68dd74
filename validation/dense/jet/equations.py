#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""quickJet with the full void-fraction equations beside those that neglect it: profiles and cost.

    source environment; validation/dense/jet/equations.py [--turns 5] [--steps 100] [--counted 6]
        [--work FOLDER] [--output FOLDER]

The standard run of cases/quickJet, on one rank, with each of both (VARIANTS). Then, from the state of each at the start of the
sampling, --steps fluid steps in turns (seconds, iterations of the linear solvers) and --counted steps under valgrind (instructions;
0: none); also with full and a filter, which goes on from the state of full. With --work the folder is kept, and what is complete is not run again.
"""

import argparse
import math
import pathlib
import re
import shutil
import statistics
import tempfile

import numpy

import grainjet
from grainjet import dictionaries, done, tables

# Entries of voidFraction behind the model. The smallest cell is 7.6 grain diameters wide, and a filter must not be smaller
VARIANTS = {"neglected": "equations neglected;", "full": "equations full;"}
FILTER = "equations full; filter { length 1.3e-3; }"
ENOUGH = 5      # crossings of a ring without which it says nothing about a mean


def job(work, name):
    """The standard run with a variant, serial. Returns its folder."""
    case = work/name
    if (case/"finished").exists():
        return case
    shutil.rmtree(case, ignore_errors=True)
    shutil.copytree(grainjet.ROOT/"cases/quickJet", case, ignore=shutil.ignore_patterns(
        "tests", "log.*", "processor*", "postProcessing", "results", "polyMesh", "particles", "0", "0.[0-9]*", "[1-9]*"))
    # full solves the fluid as often as it exchanges momentum with the grains; the other one, too, to be compared
    p = dictionaries.values(case/"system/parameters")
    dictionaries.put(case/"system/parameters", ranks=1, fluidStep=f"{p['fluidStep']/p['subSteps']:.10g}", subSteps=1)
    entries = next(path for path in (case/"constant/fvOptions", case/"system/fvOptions") if path.exists())
    text, found = re.subn(r"(minimum\s+0\.3;)", rf"\1 {VARIANTS[name]}", entries.read_text())
    if found != 1:
        raise SystemExit(f"{entries}: no entry minimum 0.3 to stand behind")
    entries.write_text(text)
    done(["./Allrun"], case, "log.Allrun")
    (case/"finished").touch()
    return case


def profiles(case):
    """{plane in D: table}"""
    return {position: tables.read(path) for position, path in tables.planes(case/"postProcessing/profiles").items()}


QUANTITIES = {"mean axial velocity": "flux_weighted_mean_axial", "number flux": "number_flux"}


def differences(a, b):
    """Rows [plane, quantity, rings, mean of z, rms of z, largest |z|] of two runs: z is the difference over its standard error."""
    for plane in a:
        for words, name in QUANTITIES.items():
            one, two = a[plane], b[plane]
            seen = (one["crossings"] >= ENOUGH) & (two["crossings"] >= ENOUGH)
            error = numpy.hypot(one[f"stderr_{name}"], two[f"stderr_{name}"])[seen]
            z = (two[name] - one[name])[seen]/error
            yield [f"{plane:g}", words, str(seen.sum()), f"{z.mean():.2f}", f"{math.sqrt((z**2).mean()):.2f}", f"{abs(z).max():.1f}"]


def axis(table):
    """(mean axial velocity, its standard error, rms) of the rings up to 0.2 D, m/s."""
    near = (table["r_outer/D"] < 0.2 + 1e-6) & (table["crossings"] > 0)
    n, mean, rms = (table[name][near] for name in ("crossings", "flux_weighted_mean_axial", "flux_weighted_rms_axial"))
    total = (n*mean).sum()/n.sum()
    spread = math.sqrt((n*(rms**2 + mean**2)).sum()/n.sum() - total**2)
    return total, spread/math.sqrt(n.sum()), spread


def window(cases, name, case, steps):
    """A case that goes on from the start of the sampling for some fluid steps."""
    source = cases["full" if name == "filter" else name]
    p = dictionaries.values(source/"system/parameters")
    state = f"{p['sampleStart']:g}"
    shutil.rmtree(case, ignore_errors=True)
    case.mkdir(parents=True)
    for part in ("constant", "system", state):
        shutil.copytree(source/part, case/part)
    end = p["sampleStart"] + steps*p["fluidStep"]
    dictionaries.put(case/"system/parameters", endTime=f"{end:.10g}", writeInterval=1)
    if name == "filter":
        dictionaries.change(next(case.glob("*/fvOptions")), (VARIANTS["full"], FILTER))
    return case


def iterations(log, field):
    return sum(int(n) for n in re.findall(rf"Solving for {field}, .*No Iterations (\d+)", log))


def seconds(case):
    """Medians over the steps of a window: of the fluid, of DEM, of the coupling."""
    balance = tables.history(case/"postProcessing/liggghtsCoupling", "balance")
    return [statistics.median(balance[f"seconds{part}"][5:]) for part in ("Fluid", "DEM", "Coupling")]


def counted(cases, name, work, steps):
    """Instructions per fluid step, in millions."""
    found = []
    for n in (2, 2 + steps):
        case = window(cases, name, work/f"counted-{name}-{n}", n)
        done(["valgrind", "--tool=callgrind", "--callgrind-out-file=callgrind.out", "pimpleFoam"], case, "log.pimpleFoam")
        text = done(["callgrind_annotate", "--threshold=100", "callgrind.out"], case, "log.annotate")
        total = int(re.search(r"([\d,]+) \(100", text)[1].replace(",", ""))
        found.append(total)
    return (found[1] - found[0])/steps*1e-6


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--counted", type=int, default=6)
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path)
    options = parser.parse_args()
    work = options.work or pathlib.Path(tempfile.mkdtemp(prefix="grainjet-equations-"))
    work.mkdir(parents=True, exist_ok=True)
    work = work.resolve()

    cases = {name: job(work, name) for name in VARIANTS}
    sampled = {name: profiles(case) for name, case in cases.items()}
    results = {"axis": [["plane, D", *(f"{name}: {what}" for name in cases for what in ("m/s", "+-", "rms, m/s"))]]}
    for plane in next(iter(sampled.values())):
        results["axis"].append([f"{plane:g}", *(f"{x:.3f}" for found in sampled.values() for x in axis(found[plane]))])
    results["differences"] = [["plane, D", "quantity", "rings", "mean z", "rms z", "largest z"]]
    results["differences"] += differences(sampled["neglected"], sampled["full"])

    if options.turns:
        times = {name: [] for name in (*VARIANTS, "filter")}
        solved = {}
        for _ in range(options.turns):
            for name, rows in times.items():
                case = window(cases, name, work/f"window-{name}", options.steps)
                log = done(["pimpleFoam"], case, "log.pimpleFoam")
                rows.append(seconds(case))
                solved[name] = [iterations(log, field)/options.steps for field in ("p", "U[xyz]", "(?:k|epsilon)")]
        results["cost"] = [["run", "s per fluid step: fluid", "DEM", "coupling", "all over neglected: median", "smallest", "largest",
                            "iterations per step: p", "U", "k and epsilon"]]
        for name, rows in times.items():
            ratios = [sum(row)/sum(base) for row, base in zip(rows, times["neglected"])]
            results["cost"].append([name, *(f"{statistics.median(part):.4f}" for part in zip(*rows)),
                                    f"{statistics.median(ratios):.3f}", f"{min(ratios):.3f}", f"{max(ratios):.3f}",
                                    *(f"{n:.1f}" for n in solved[name])])
        if options.counted:
            results["cost"][0].append("million instructions per step")
            for row in results["cost"][1:]:
                row.append(f"{counted(cases, row[0], work, options.counted):.1f}")
    for name, rows in results.items():
        tables.show(rows)
        print()
        if options.output:
            tables.write(options.output/f"{name}.csv", rows)
    if not options.work:
        shutil.rmtree(work)


if __name__ == "__main__":
    main()
