#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The main job beside stock DPMFoam: same mesh, same grains, same fluid step, one after the other.

    source environment; validation/benchmarks/dpmfoam/run.py [--filled 0.06] [--cg 2] [--steps 400]
        [--ranks 1 2] [--resolution 12] [--work <folder>] [--output <folder>]

cases/quickJet is filled with grains of --cg particle diameters up to --filled seconds. From that state both programs go on for
--steps fluid steps, on each number of ranks; DPMFoam at the DEM step of the main job, and serially once
more with its own collisionResolutionSteps = --resolution. With --work the folder is kept, and a filled
state found there is used again. README.md says what is the same and what is not.
"""

import argparse
import pathlib
import re
import resource
import shutil
import subprocess
import tempfile
import time

import numpy

import dpm_case
import grainjet
from grainjet import dictionaries, done, fields, tables

SLAB = 4        # length of the pieces of the axis in which grains are averaged, in D
NEAR = 0.2      # grains nearer to the axis than this count, in D


def parameters(case):
    """The entries of system/parameters."""
    return dictionaries.values(case/"system"/"parameters")


def solver(name, ranks):
    return [*grainjet.mpirun(ranks if ranks > 1 else 0), name, *(["-parallel"] if ranks > 1 else [])]


def processor_seconds():
    """Of all programs run so far, ranks of MPI included."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Measured:
    """A solver's run: seconds of the wall clock to the first fluid step, per step, and in all. The lines
    of the log are stamped as they come; the first step is left out of the mean, programs set up in it."""

    def __init__(self, name, folder, ranks):
        start, before = time.monotonic(), processor_seconds()
        process = subprocess.Popen(solver(name, ranks), cwd=folder, text=True,
                                   env={**grainjet.ENV, "PWD": str(folder)},
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        lines, stamps, last = [], [], None
        for line in process.stdout:
            lines.append(line)
            if line.startswith("Time = "):
                stamps.append(time.monotonic())
            elif line.startswith("ExecutionTime"):
                last = time.monotonic()
        self.log = "".join(lines)
        (folder/f"log.{name}").write_text(self.log)
        code = process.wait()
        self.total = time.monotonic() - start
        self.processor = processor_seconds() - before
        if code or len(stamps) < 3:
            raise SystemExit(f"{name} on {ranks} ranks failed, see {folder}/log.{name}\n{self.log[-3000:]}")
        self.start = stamps[0] - start
        self.step = (last - stamps[1])/(len(stamps) - 1)


def fill(work, filled, cg):
    """The main job up to a time, on two ranks, its state joined. Returns its folder."""
    job = work/f"filled-{filled:g}-{cg:g}"
    if (job/"complete").exists():
        return job
    shutil.rmtree(job, ignore_errors=True)
    shutil.copytree(grainjet.ROOT/"cases"/"quickJet", job, ignore=shutil.ignore_patterns(
        "tests", "log.*", "processor*", "postProcessing", "results", "polyMesh", "particles", "0",
        "0.[0-9]*", "[1-9]*"))
    # ascii, because the other case is made from its fields; 17 digits lose nothing
    p = parameters(job)
    finer = p["cg"]/cg          # smaller grains need shorter DEM steps, in proportion
    # DPMFoam solves the fluid as often as it exchanges momentum with the grains
    dictionaries.put(job/"system"/"parameters", fluidStep=f"{p['fluidStep']/p['subSteps']:.10g}", subSteps=1, cg=f"{cg:g}",
        couplingInterval=round(finer*p["couplingInterval"]),
        insertionInterval=round(finer*p["insertionInterval"]))
    dictionaries.put(job/"system"/"controlDict", writeFormat="ascii", writePrecision=17)
    dictionaries.put(job/"spinUp"/"system"/"controlDict", writeFormat="ascii")
    control = job/"system"/"controlDict"
    text, found = re.subn(r"\n    profiles\s*\{[^}]*\}\n", "\n", control.read_text())
    if found != 1:
        raise SystemExit(f"{control}: no function object 'profiles' to take out")
    control.write_text(text)
    done(["./particleInput"], job, "log.particleInput")
    # not before: nothing is sampled, and particleInput wants a time of sampling in the run
    dictionaries.put(job/"system"/"parameters", endTime=filled, writeInterval=filled)
    done(["blockMesh"], job, "log.blockMesh")
    shutil.copytree(job/"0.orig", job/"0")
    (job/"spinUp"/"0").symlink_to("../0")
    (job/"spinUp"/"constant").symlink_to("../constant")
    spin_up = job/"spinUp"
    done(["decomposePar"], spin_up, "log.decomposePar")
    done(solver("simpleFoam", 2), spin_up, "log.simpleFoam")
    done(["reconstructPar", "-latestTime"], spin_up, "log.reconstructPar")
    steady = max((d for d in spin_up.glob("[1-9]*") if d.is_dir()), key=lambda d: float(d.name))
    for field in ("U", "p", "k", "epsilon", "nut", "phi"):
        shutil.copy(steady/field, job/"0")
    done(["decomposePar"], job, "log.decomposePar")
    done(solver("pimpleFoam", 2), job, "log.pimpleFoam")
    done(["reconstructPar", "-latestTime"], job, "log.reconstructPar")
    (job/"complete").touch()
    return job


def latest(case):
    return max((d for d in case.glob("0.[0-9]*") if d.name != "0.orig"), key=lambda d: float(d.name))


def main_job(job, case, p, steps, ranks):
    """Run the main job on from the filled state. Returns its row of the table and its grains at the end."""
    shutil.rmtree(case, ignore_errors=True)
    state = latest(job)
    case.mkdir(parents=True)
    for part in ("constant", "system", state.name):
        shutil.copytree(job/part, case/part)
    window = steps*p["fluidStep"]
    end = float(state.name) + window
    dictionaries.put(case/"system"/"parameters", endTime=f"{end:.10g}", writeInterval=f"{window:.10g}")
    if ranks > 1:
        dictionaries.put(case/"system"/"decomposeParDict", numberOfSubdomains=ranks)
        put_slices(case, ranks)
        done(["decomposePar", "-latestTime"], case, "log.decomposePar")
    run = Measured("pimpleFoam", case, ranks)
    balance = tables.history(case/"postProcessing"/"liggghtsCoupling", "balance")
    seconds = {name: balance[f"seconds{name}"][1:].mean() for name in ("DEM", "Coupling")}
    row = {"program": "pimpleFoam + LIGGGHTS", "ranks": ranks, "DEM steps": p["couplingInterval"],
           "grains": balance["present"].mean(), "run": run, "DEM": seconds["DEM"],
           "particles": seconds["DEM"] + seconds["Coupling"]}
    return row, fields.grains_at(case/"postProcessing"/"grains", end), case


def put_slices(case, ranks):
    path = case/"system"/"decomposeParDict"
    path.write_text(re.sub(r"n\s+\(1 1 \d+\);", f"n (1 1 {ranks});", path.read_text()))


def dpm(job, case, p, steps, ranks, resolution=None):
    """Run DPMFoam from the filled state; by default at the DEM step of the main job."""
    shutil.rmtree(case, ignore_errors=True)
    state = latest(job)
    window = steps*p["fluidStep"]
    shutil.copytree(job/"constant"/"polyMesh", case/"constant"/"polyMesh")
    (case/"0").mkdir()
    (case/"system").mkdir()
    _, positions, data = fields.grains_at(job/"postProcessing"/"grains", float(state.name))
    fastest = numpy.linalg.norm(data["U"], axis=1).max()
    dpm_case.write_dictionaries(case, job, p, window, window)
    dpm_case.write_cloud_properties(
        case, p, resolution or dpm_case.resolution_steps(p, p["couplingInterval"], fastest))
    # Cz, the height of cells and faces, comes from the program that knows them
    done(["postProcess", "-func", "writeCellCentres", "-time", state.name], job, "log.writeCellCentres")
    dpm_case.write_fields(case/"0", state, state/"Cz", p["gravity"])
    dpm_case.write_parcels(case/"0", positions, data["U"], p)
    first = case/"0"
    if ranks > 1:
        dictionaries.put(case/"system"/"decomposeParDict", numberOfSubdomains=ranks)
        put_slices(case, ranks)
        done(["decomposePar"], case, "log.decomposePar")
        first = case/"processor0"/"0"     # slices along the axis: the inlet lies on the first rank
        # decomposePar writes places in another form than it read, but copies what says which
        for rank in range(ranks):
            dpm_case.write_cloud_geometry(case/f"processor{rank}"/"0", "kinematicCloud", "coordinates", len(positions))
    dpm_case.write_entering(first, p, window, len(positions))
    run = Measured("DPMFoam", case, ranks)

    cycles = [int(n) for n in re.findall(r"(\d+) move-collide subCycles", run.log)]
    parcels = [int(n) for n in re.findall(r"Current number of parcels\s+= (\d+)", run.log)]
    profile = (latest(case/"processor0" if ranks > 1 else case)/"uniform"/"profiling").read_text()
    cloud = re.search(r'"?cloud::solve"?;.*?totalTime\s+([\d.e+-]+)', profile, re.S)
    row = {"program": f"DPMFoam, resolution {resolution:g}" if resolution else "DPMFoam", "ranks": ranks,
           "DEM steps": numpy.mean(cycles) if cycles else 1,
           "grains": numpy.mean(parcels), "run": run, "particles": float(cloud[1])/steps}
    return row, fields.grains_at(case/"postProcessing"/"grains", window), case


def axis(grains, p):
    """{start of the piece in D: (grains, mean axial velocity, its standard error)} near the axis."""
    _, x, data = grains
    u = data["U"][:, 2]
    near = numpy.hypot(x[:, 0], x[:, 1]) < NEAR*p["D"]
    pieces = {}
    for start in numpy.arange(-p["pipeLength"] + SLAB/2, p["jetLength"] - SLAB, SLAB):
        seen = u[near & (x[:, 2] >= start*p["D"]) & (x[:, 2] < (start + SLAB)*p["D"])]
        pieces[start] = (len(seen), seen.mean(), seen.std()/len(seen)**0.5)
    return pieces


def axial_velocity(case, field):
    """The fluid's axial velocity in all cells at the end of a serial case."""
    text = (latest(case)/field).read_text()
    cells = re.search(r"internalField\s+nonuniform List<vector>\s*\d+\s*\((.*?)\n\)", text, re.S)[1]
    return numpy.array([float(line.rsplit(None, 1)[1].rstrip(")")) for line in cells.split("\n") if line])


# Rates in millions of grains times DEM steps per second of the wall clock. DPMFoam's profile knows one time
# for contacts, motion and forces of the fluid together.
COLUMNS = ["program", "ranks", "DEM steps per fluid step", "grains", "s before first step", "s per fluid step",
           "of these particles", "total s", "total processor s", "rate, all of particles", "rate, DEM alone",
           "times the main job"]


def cells(row, rows):
    """One line of the table, in the order of COLUMNS."""
    run, moved = row["run"], row["grains"]*row["DEM steps"]
    base = next(r for r in rows if r["ranks"] == row["ranks"] and not r["program"].startswith("DPMFoam"))
    return [row["program"], str(row["ranks"]), f"{row['DEM steps']:.3g}", f"{row['grains']:.0f}",
            f"{run.start:.1f}", f"{run.step:.3f}", f"{row['particles']:.3f}", f"{run.total:.1f}",
            f"{run.processor:.1f}", f"{1e-6*moved/row['particles']:.3g}",
            f"{1e-6*moved/row['DEM']:.3g}" if "DEM" in row else "", f"{run.step/base['run'].step:.2f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--filled", type=float, default=0.06)
    parser.add_argument("--cg", type=float, default=2)
    parser.add_argument("--steps", type=int, default=400)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--resolution", type=float, default=12)
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path)
    options = parser.parse_args()

    work = options.work or pathlib.Path(tempfile.mkdtemp(prefix="grainjet-dpmfoam-"))
    work.mkdir(parents=True, exist_ok=True)
    work = work.resolve()
    job = fill(work, options.filled, options.cg)
    p = parameters(job)
    rows, ends, folders = [], {}, {}
    print("| " + " | ".join(COLUMNS) + " |\n" + "|---"*len(COLUMNS) + "|")

    def report(name, result):
        rows.append(result[0])
        # they differ by the grains in the last quarter of a diameter, which the main job takes out: 1 %
        if abs(rows[-1]["grains"]/rows[0]["grains"] - 1) > 0.03:
            raise SystemExit(f"{name}: {rows[-1]['grains']:.0f} grains where the main job has "
                             f"{rows[0]['grains']:.0f}: this is no comparison, see {work}")
        ends[name] = axis(result[1], p)
        folders[name] = result[2]
        print("| " + " | ".join(cells(rows[-1], rows)) + " |", flush=True)

    for ranks in options.ranks:
        report(f"main job, {ranks}", main_job(job, work/f"main-{ranks}", p, options.steps, ranks))
        report(f"DPMFoam, {ranks}", dpm(job, work/f"dpm-{ranks}", p, options.steps, ranks))
    if options.resolution and 1 in options.ranks:
        report(f"DPMFoam, resolution {options.resolution:g}",
               dpm(job, work/"dpm-own", p, options.steps, 1, options.resolution))

    heads = ["z/D", *(f"{name}: {what}" for name in ends for what in ("grains", "m/s", "+-"))]
    lines = [[f"{start:g} to {start + SLAB:g}", *(text for end in ends.values() for text in (
        f"{end[start][0]}", f"{end[start][1]:.2f}", f"{end[start][2]:.2f}"))] for start in next(iter(ends.values()))]
    print(f"\nMean axial velocity of grains within {NEAR} D of the axis at the end, by pieces of the axis\n")
    tables.show([heads, *lines])

    if {"main job, 1", "DPMFoam, 1"} <= set(folders):
        ours, theirs = axial_velocity(folders["main job, 1"], "U"), axial_velocity(folders["DPMFoam, 1"], "U.air")
        print(f"\nAxial velocity of the fluid, all cells: rms difference "
              f"{numpy.sqrt(((ours - theirs)**2).mean()):.3f} m/s, largest {abs(ours - theirs).max():.3f} m/s, "
              f"at most {ours.max():.2f} m/s")

    if options.output:
        tables.write(options.output/"cost.csv", [COLUMNS, *(cells(row, rows) for row in rows)])
        tables.write(options.output/"axis.csv", [heads, *lines])
    if not options.work:
        shutil.rmtree(work)


if __name__ == "__main__":
    main()
