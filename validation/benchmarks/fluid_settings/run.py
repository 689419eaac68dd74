#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Linear solvers, tolerances and correctors of the fluid, see README.md.

    run.py prepare WORK SIZE              coupled flow to start from: quickJet (46,020 cells) or medium (640,032)
    run.py run WORK SIZE VARIANT ...      some fluid steps from it with other settings, those of variants.py; all: each
    run.py table WORK SIZE                what the finished ones took, and how far their fields are from tight tolerances
    run.py cut WORK SIZE                  slices along the axis against halves and quarters of them: faces between ranks

Built Grainjet, its environment sourced. --ranks: MPI ranks of the variants, --steps: their fluid steps,
--across: cut across the axis as well, "2 1" or "2 2",
--messages: print what the first rank hands to MPI."""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT/"cases/common"), str(pathlib.Path(__file__).resolve().parent)]
sys.dont_write_bytecode = True

import check                # noqa: E402
import generate             # noqa: E402
import variants             # noqa: E402
from grainjet import dictionaries, mpi_counts as counts, programs, tables  # noqa: E402

SIZES = ("quickJet", "medium")
# time of the flow to start from, fluid steps on the mesh of medium after its mapping, s
BEGIN = {"quickJet": 0.06, "quick": 0.05775}
SETTLE = 6
STEPS = {"quickJet": 20, "medium": 4}


def stage(folder, name, log):
    """A stage of cases/common/job.sh in a folder."""
    text = f'set -eu -o pipefail; root={ROOT}; . "$root/cases/common/job.sh"; {name}'
    with log.open("w") as out:
        subprocess.run(["bash", "-c", text], cwd=folder, check=True, stdout=out, stderr=subprocess.STDOUT)


def until(folder, end, every=None):
    """The end of a run, and when it writes."""
    dictionaries.put(folder/"system/parameters", endTime=f"{end:.10g}", writeInterval=f"{every or end:.10g}")


def latest(folder):
    """Its last time, as its folder is called."""
    times = [path.name for path in folder.iterdir() if re.fullmatch(r"[0-9.]+(e-\d+)?", path.name)]
    return max(times, key=float)


def prepare(work, size):
    folder = work/f"start-{size}"
    if size == "quickJet":
        shutil.copytree(ROOT/"cases/quickJet", folder)
        begin(folder, BEGIN[size], work)
        return
    coarse = work/"start-quick"
    for at, name in ((coarse, "quick"), (folder, "medium")):
        made = generate.table.Table().run("Hardalupas1", name)
        shutil.copytree(ROOT/"cases/quickJet", at)
        (at/"system/parameters").write_text(generate.parameters({**made, "cg": 2}))
    begin(coarse, BEGIN["quick"], work)
    mapped(coarse, folder, work)


def begin(folder, end, work):
    """The coupled flow up to a time, without what this study changes."""
    dictionaries.put(folder/"system/parameters", ranks="1")
    dictionaries.write(folder/"system/fvSolution", variants.solution({}))
    stage(folder, "mesh_stage", work/f"{folder.name}.mesh.log")
    # not before: nothing is sampled, and particleInput wants a time of sampling in the run
    until(folder, end)
    stage(folder, "steady_stage; coupled_stage", work/f"{folder.name}.log")


def mapped(coarse, folder, work):
    """The flow and the grains of a coarse mesh on a finer one, and some steps there: what the coarse mesh lacks
    is the first thing that the pressure sees."""
    time = latest(coarse)
    step = check.parameters(folder)["fluidStep"]
    dictionaries.put(folder/"system/parameters", ranks="1")
    dictionaries.write(folder/"system/fvSolution", variants.solution(variants.VARIANTS["chosen"]))
    stage(folder, "mesh_stage", work/f"{folder.name}.log")
    until(folder, float(time) + SETTLE*step, SETTLE*step)
    shutil.copytree(folder/"0.orig", folder/time)
    programs.done(["mapFields", coarse, "-consistent", "-sourceTime", time, "-mapMethod", "interpolate"], folder,
                  folder/"log.mapFields")
    (folder/time/"uniform").mkdir()
    for name in ("liggghts.restart", "liggghtsCouplingProperties"):
        shutil.copy2(coarse/time/"uniform"/name, folder/time/"uniform")
    # fields of faces cannot be mapped: the flux is made from the velocity
    state = folder/time/"uniform/liggghtsCouplingProperties"
    state.write_text(re.sub(r"(?m)^files .*", "files 0 ( );", state.read_text()))
    programs.done(["pimpleFoam"], folder, folder/"log.pimpleFoam")


def parts(ranks, across):
    """What decomposeParDict has for so many ranks: slices of the axis, each cut across."""
    x, y = (int(n) for n in across.split())
    return f"({x} {y} {ranks//(x*y)})"


def run(work, size, name, ranks, steps, across, messages):
    start = work/f"start-{size}"
    folder = work/(f"{size}-{name.replace(' ', '_')}" + (f"-{parts(ranks, across)[1:-1].replace(' ', 'x')}" if ranks > 1 else ""))
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    time = latest(start)
    for part in ("system", "constant", time):
        shutil.copytree(start/part, folder/part)
    step = check.parameters(start)["fluidStep"]
    until(folder, float(time) + steps*step, steps*step)
    dictionaries.write(folder/"system/fvSolution", variants.solution(variants.VARIANTS[name]))
    if name.endswith("renumberMesh"):
        programs.done(["renumberMesh", "-overwrite"], folder, folder/"log.renumberMesh")
    solver = ["pimpleFoam"]
    if ranks > 1:
        dictionaries.put(folder/"system/parameters", ranks=str(ranks))
        dictionaries.put(folder/"system/decomposeParDict", n=parts(ranks, across))
        programs.done(["decomposePar"], folder, folder/"log.decomposePar")
        library = [f"LD_PRELOAD={counts.build(work)}", f"GRAINJET_MPI_COUNTS={folder/'counts'}"] if messages else []
        solver = [*programs.mpirun(ranks), "env", *library, "pimpleFoam", "-parallel"]
    programs.done(solver, folder, folder/"log.pimpleFoam")
    if messages:
        calls = [line.split()[:2] for line in (folder/"counts.0").read_text().splitlines() if not line.startswith("memory")]
        sent = sum(int(n) for kind, n in calls if kind == "message")
        print(f"{name}: {sent/steps:.0f} messages, {sum(int(n) for _, n in calls)/steps - sent/steps:.0f} collective operations per step, "
              "with those of the start")


def values(path):
    """The internal field of a binary file, one row per cell."""
    data = path.read_bytes()
    found = re.search(rb"internalField\s+nonuniform List<(\w+)>\s*\n(\d+)\n\(", data)
    width = {b"vector": 3, b"scalar": 1}[found[1]]
    return numpy.frombuffer(data, count=int(found[2])*width, offset=found.end()).reshape(-1, width)


class Log:
    """What the solver said: iterations per fluid step, processor seconds per step, continuity."""

    def __init__(self, folder):
        text = (folder/"log.pimpleFoam").read_text()
        at = [float(value) for value in re.findall(r"ExecutionTime = (\S+) s", text)]
        self.steps = len(at)
        # the first step has what is made once: levels of the solver, grains
        self.seconds = (at[-1] - at[0])/(self.steps - 1)

        def count(pattern):
            return [int(n) for n in re.findall(rf"Solving for {pattern},.*No Iterations (\d+)", text)]
        pressure = count("p")
        self.solves = len(pressure)//self.steps
        self.pressure = sum(pressure)/self.steps
        self.velocity = sum(count("U[xyz]"))/self.steps
        self.turbulence = sum(count("(?:k|epsilon)"))/self.steps
        balance = tables.history(folder/"postProcessing/liggghtsCoupling", "balance")
        fluid, rest = (balance[f"seconds{part}"][1:].sum() for part in ("Fluid", "DEM"))
        rest += balance["secondsCoupling"][1:].sum()
        self.fluid = self.seconds*fluid/(fluid + rest)


def row(work, size, name, folder):
    log, p = Log(folder), check.parameters(folder)
    cells = [name, f"{log.solves}", f"{log.pressure:.1f}", f"{log.velocity:.1f}", f"{log.turbulence:.1f}", log.fluid]
    reference = work/f"{size}-tight"
    if not reference.exists() or name.endswith("renumberMesh") or (folder/"processor0").exists():
        return cells + ["-", "-", "-"]
    time = latest(folder)
    there = latest(reference)
    change = numpy.linalg.norm(values(folder/time/"U") - values(reference/there/"U"), axis=1)/p["Umean"]
    pressure = values(folder/time/"p") - values(reference/there/"p")
    return cells + [f"{change.max():.1e}", f"{numpy.sqrt((change**2).mean()):.1e}", f"{abs(pressure).max()/p['Umean']**2:.1e}"]


def table(work, size):
    print("| settings | pressure solves | iterations of p | of U | of k, epsilon | fluid/before | largest change of U/Umean | rms | of p/Umean^2 |")
    print("|" + "---|"*9)
    names = {path: name for name in variants.VARIANTS for path in work.glob(f"{size}-{name.replace(' ', '_')}*")
             if re.fullmatch(rf"{size}-{re.escape(name.replace(' ', '_'))}(-[0-9x]+)?", path.name)}
    rows = {path: row(work, size, path.name[len(size) + 1:].replace("_", " "), path) for path in names
            if (path/"log.pimpleFoam").exists()}
    before = next(cells[5] for path, cells in rows.items() if path.name == f"{size}-before")
    for cells in rows.values():
        cells[5] = f"{cells[5]/before:.2f}"
        print("| " + " | ".join(cells) + " |")


def cut(work, size):
    """Decomposition alone."""
    print("| ranks | parts in x, y, z | cells of a rank, most/mean | faces between ranks, most of a rank | all | neighbours, most |")
    print("|" + "---|"*6)
    for ranks in (2, 4, 8, 16):
        for across in ("1 1", "2 1", "2 2"):
            if across == "2 2" and ranks < 4:
                continue
            folder = work/f"cut-{size}"
            shutil.rmtree(folder, ignore_errors=True)
            for part in ("system", "constant"):
                shutil.copytree(work/f"start-{size}"/part, folder/part)
            dictionaries.put(folder/"system/parameters", ranks=str(ranks))
            dictionaries.put(folder/"system/decomposeParDict", n=parts(ranks, across))
            said = programs.done(["decomposePar"], folder, folder/"log.decomposePar")
            shutil.rmtree(folder)
            above = re.search(r"Max number of cells = \d+ \((\S+)% above", said)[1]
            faces = re.findall(r"Number of processor faces = (\d+)", said)[-1]
            most = re.search(r"Max number of faces between processors = (\d+)", said)[1]
            near = re.search(r"Max number of processor patches = (\d+)", said)[1]
            print(f"| {ranks} | {parts(ranks, across)[1:-1]} | {1 + float(above)/100:.3f} | {int(most):,} | {int(faces):,} | {near} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("prepare", "run", "table", "cut"))
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("size", choices=SIZES)
    parser.add_argument("variant", nargs="*")
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--steps", type=int)
    parser.add_argument("--across", default="1 1")
    parser.add_argument("--messages", action="store_true")
    args = parser.parse_args()
    work = args.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    if args.what == "prepare":
        prepare(work, args.size)
    elif args.what == "run":
        for name in variants.VARIANTS if args.variant == ["all"] else args.variant:
            run(work, args.size, name, args.ranks, args.steps or STEPS[args.size], args.across, args.messages)
    elif args.what == "cut":
        cut(work, args.size)
    else:
        table(work, args.size)


if __name__ == "__main__":
    main()
