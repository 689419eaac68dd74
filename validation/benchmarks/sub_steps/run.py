#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""quickJet with fluid steps of several sub-steps, see README.md.

    run.py prepare WORK                   mesh and steady flow without grains
    run.py run WORK SUBSTEPS OUTER        the coupled run: the length of a sub-step stays that of quickJet;
                                          OUTER: outer correctors
    run.py go-on WORK SUBSTEPS --case CASE --from TIME --length SECONDS
                                          the same for another case with sub-steps that ran on several ranks: from one
                                          of its written times on
    run.py table WORK                     what the finished runs have, as the table of the README

Built Grainjet, its environment sourced. A run takes the ranks of quickJet's parameters, or those of --ranks."""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT/"cases/common"))

import check                # noqa: E402
from grainjet import dictionaries, tables  # noqa: E402

# length of quickJet's sub-steps, s: its fluid step without them
STEP = 5e-5


def stage(folder, name, log):
    """A stage of cases/common/job.sh in a folder."""
    text = f'set -eu -o pipefail; root={ROOT}; . "$root/cases/common/job.sh"; {name}'
    with log.open("w") as out:
        subprocess.run(["bash", "-c", text], cwd=folder, check=True, stdout=out, stderr=subprocess.STDOUT)


def prepare(work, ranks):
    folder = work/"start"
    shutil.copytree(ROOT/"cases/quickJet", folder)
    if ranks:
        dictionaries.put(folder/"system/parameters", ranks=str(ranks))
    stage(folder, "mesh_stage; steady_stage", work/"start.log")


def run(work, n, outer):
    folder = work/f"n{n}o{outer}"
    shutil.copytree(work/"start", folder, symlinks=True, ignore=shutil.ignore_patterns("processor*"))
    dictionaries.put(folder/"system/parameters", fluidStep=f"{n*STEP:.10g}", subSteps=str(n), couplingInterval="10")
    dictionaries.put(folder/"system/fvSolution", nOuterCorrectors=str(outer))
    subprocess.run(["./particleInput"], cwd=folder, check=True)
    stage(folder, "coupled_stage", work/f"{folder.name}.log")


def go_on(work, n, case, begin, length):
    """From a written time of a case on, which is only read; the length of a sub-step stays the case's."""
    p = check.parameters(case)
    folder = work/f"n{n}o1"
    folder.mkdir(parents=True)
    for part in ("system", "constant"):
        shutil.copytree(case/part, folder/part, symlinks=True)
    for rank in range(int(p["ranks"])):
        there, here = case/f"processor{rank}", folder/f"processor{rank}"
        shutil.copytree(there/begin, here/begin)
        (here/"constant").symlink_to((there/"constant").resolve())
    end = float(begin) + length
    dictionaries.put(folder/"system/parameters", fluidStep=f"{n*p['fluidStep']/p['subSteps']:.10g}", subSteps=str(n),
                     sampleStart=begin, endTime=f"{end:.10g}", writeInterval=f"{length:.10g}")
    stage(folder, 'launcher; "${mpi[@]}" pimpleFoam $parallel > log.pimpleFoam 2>&1', work/f"{folder.name}.log")


def row(folder):
    """The cells of a line of each table: cost, statistics."""
    p = check.parameters(folder)
    log = (folder/"log.pimpleFoam").read_text()
    planes = check.Results(folder).planes
    balance = tables.history(folder/"postProcessing/liggghtsCoupling", "balance")
    solves = [int(count) for count in re.findall(r"Solving for p,.*No Iterations (\d+)", log)]
    courant = [float(value) for value in re.findall(r"Courant Number mean: \S+ max: (\S+)", log)]
    clock = float(re.findall(r"ClockTime = (\S+) s", log)[-1])
    sampled = balance["Time"] > p["sampleStart"]
    slip = balance["meanSlip"][sampled].mean()
    change = balance["fluidChange"][sampled].mean()/slip if "fluidChange" in balance else numpy.nan
    _, put = check.inserted(p)
    n, outer = re.fullmatch(r"n(\d+)o(\d+)", folder.name).groups()
    means = " ".join(f"{plane.mean:.2f} +- {plane.error:.2f}" for plane in planes)
    rms = " ".join(f"{plane.rms:.2f}" for plane in planes)
    flows = " ".join(f"{plane.particles_per_s/put:.3f}" for plane in planes)
    name = [n, f"{max(courant):.1f}", outer]
    seconds = [f"{balance[part].sum():.0f}" for part in ("secondsFluid", "secondsDEM", "secondsCoupling")]
    return (name + [str(len(solves)), str(sum(solves)), *seconds, f"{clock:.0f}"],
            name + [means, rms, flows, f"{slip:.3f}", "-" if n == "1" else f"{100*change:.2f} %", f"{balance['imbalance'].max():.0e}"])


def table(work):
    name = ["n", "Courant", "outer"]
    heads = (name + ["pressure solves", "iterations", "fluid, s", "DEM, s", "coupling, s", "clock, s"],
             name + ["mean on the axis, m/s", "rms, m/s", "through the plane/inserted", "slip, m/s", "change/slip", "imbalance"])
    folders = [path.parent for path in work.glob("n*o*/log.pimpleFoam") if "\nEnd" in path.read_text()]
    rows = [row(folder) for folder in sorted(folders, key=lambda path: [int(k) for k in re.findall(r"\d+", path.name)])]
    for head, lines in zip(heads, zip(*rows)):
        print("\n| " + " | ".join(head) + " |\n|" + "---|"*len(head))
        for cells in lines:
            print("| " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("prepare", "run", "go-on", "table"))
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("numbers", type=int, nargs="*")
    parser.add_argument("--ranks", type=int, default=0)
    parser.add_argument("--case", type=pathlib.Path)
    parser.add_argument("--from", dest="begin", metavar="TIME")
    parser.add_argument("--length", type=float)
    args = parser.parse_args()
    if args.what == "prepare":
        prepare(args.work, args.ranks)
    elif args.what == "run":
        run(args.work, *args.numbers)
    elif args.what == "go-on":
        go_on(args.work, *args.numbers, args.case, args.begin, args.length)
    else:
        table(args.work)


if __name__ == "__main__":
    main()
