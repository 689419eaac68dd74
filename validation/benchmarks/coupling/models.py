#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each model of docs/what_grains_feel.md costs, in ns and instructions per grain and interval.

    cost = coupled with the model - coupled without it

The box of run.py, but that two sides are walls with wall functions (nutkWallFunction, y+ 18 in their cells), for
the grains too, k is 1 m2/s2, and there is gravity. Without means: drag, pressureGradient with the solver's p, viscous,
buoyancy, cellPoint. One rank; one way, so that the solver makes the same iterations; what needs two-way coupling is
compared with the same two-way.

Time: runs with a model and runs without take turns, in each repetition anew. A run counts with the lower quartile of
its fluid steps, which other work on the machine disturbs least; a sample is a run less the mean of the runs before and
after it. Printed are the median of the samples and their smallest and largest. The clocks are those of balance.dat, of the
coupling and of DEM: what a model can make longer. The solver's own time differs from run to run by more.

Instructions: as in instructions.py, of the first thread, all and those of Grainjet's own libraries themselves, without
what they call.

    source environment; validation/benchmarks/coupling/models.py [--grains 3400] [--cells 12] [--interval 10]
        [--repeat 5] [--only MODEL...] [--instructions] [--output FILE.csv]
"""

import argparse
import csv
import pathlib
import shutil
import statistics
import tempfile

import grainjet
from grainjet import coupled_box as box, dictionaries
import instructions
import run as benchmark

SKIP, STEPS = 5, 65               # fluid steps that do not count, and all
DRAG, PRESSURE, REST = "drag { model Gidaspow; }", "pressureGradient { turbulentPressure no; }", "viscous {} buoyancy {}"
LIFT = "SaffmanMei {} Magnus {} fluidTorque {}"


def forces(pressure=PRESSURE, more=""):
    return f"{{ {DRAG} {pressure} {REST} {more} }}"


def eddies(model):
    return {"turbulentDispersion": f"{{ model {model}; seed 1; }}"}


ALL = {"forces": forces("pressureGradient { turbulentPressure yes; }", LIFT + " addedMass { C 0.5; }"),
       "wallLaw": "yes", **eddies("Langevin")}
TWO_WAY = {"coupling": "twoWay"}

# entries of each model that differ from those of the box without it
MODELS = {
    "turbulentPressure": {"forces": forces("pressureGradient { turbulentPressure yes; }")},
    "wallLaw": {"wallLaw": "yes"},
    "Langevin": eddies("Langevin"),
    "discreteRandomWalk": eddies("discreteRandomWalk"),
    "SaffmanMei": {"forces": forces(more="SaffmanMei {}")},
    "Magnus": {"forces": forces(more="Magnus {}")},
    "fluidTorque": {"forces": forces(more="fluidTorque {}")},
    "SaffmanMei Magnus fluidTorque": {"forces": forces(more=LIFT)},
    "addedMass": {"forces": forces(more="addedMass { C 0.5; }")},
    "all but selfDisturbance": ALL,
    "selfDisturbance": {**TWO_WAY, "selfDisturbance": "yes"},
    "all": {**ALL, **TWO_WAY, "selfDisturbance": "yes"},
}
BASES = {"oneWay": {"coupling": "oneWay"}, "twoWay": TWO_WAY}


def base_of(name):
    return MODELS[name].get("coupling", "oneWay")


def write_walls(folder, side):
    """Walls at both ends of x, where the vortices have no normal velocity, for fluid and grains."""
    mesh = folder / "system/blockMeshDict"
    dictionaries.change(mesh, ("xlo { type cyclic; neighbourPatch xhi;", "xlo { type wall;"),
                                ("xhi { type cyclic; neighbourPatch xlo;", "xhi { type wall;"))
    for field, dimensions, value, wall in (("k", "0 2 -2", 1, "kqRWallFunction"), ("epsilon", "0 2 -3", 156, "epsilonWallFunction"),
                                           ("nut", "0 2 -1", 5.8e-4, "nutkWallFunction")):
        dictionaries.write_field(folder, field, dimensions, value, {
            ".*": "type cyclic;", "x.*": f"type {wall}; value uniform {value};"})
    for field, wall in (("U", "noSlip"), ("p", "zeroGradient")):
        dictionaries.change(folder / "0" / field, ('".*" { type cyclic; }', f'".*" {{ type cyclic; }} "x.*" {{ type {wall}; }}'))
    walls = "\n".join(f"fix wall{i} all wall/gran model hertz tangential history primitive type 1 xplane {x}"
                      for i, x in enumerate((0, side)))
    for script in ("constant/in.particles", "in.alone"):
        dictionaries.change(folder / script, ("boundary p p p", "boundary f p p"),
                            ("fix contacts all hertz/cg", "fix contacts all hertz/cg\n" + walls
                             + "\nfix gravity all gravity 9.81 vector 0 0 1"))


def write_case(folder, entries, options, steps):
    """The case with some entries of the coupling."""
    benchmark.write_case(folder, options.grains, options.interval, 1, steps, True, cells=options.cells)
    side = 1e-3 * options.cells
    benchmark.write_grains(folder, options.grains, side, margin=1e-4)
    write_walls(folder, side)
    dictionaries.put(folder / "system/controlDict", writeInterval=10 * steps)
    box.fv_options(folder, **{"couplingInterval": options.interval, "drag": None, "forces": forces(), **entries})
    benchmark.prepare(folder, 1)


def seconds(folder):
    """Lower quartile over the fluid steps of a new run, by the clocks of the coupling and of DEM."""
    benchmark.remove_times(folder)
    benchmark.run(benchmark.command("coupled", 1), folder)
    balance = benchmark.latest_balance(folder)
    return {clock: statistics.quantiles(balance["seconds" + name][SKIP:])[0]
            for clock, name in (("coupling", "Coupling"), ("DEM", "DEM"))}


def times(options, names, work):
    """Rows of the table of times in ns per grain and interval: those of the boxes without, and what models add."""
    cases = {}
    for name, entries in [*BASES.items(), *((name, {**BASES[base_of(name)], **MODELS[name]}) for name in names)]:
        if name in BASES and not any(base_of(model) == name for model in names):
            continue
        cases[name] = work / name.replace(" ", "-")
        write_case(cases[name], entries, options, STEPS)
    per_grain = 1e9 / options.grains
    samples, whole = {}, {}
    for repetition in range(options.repeat):
        for base in BASES:
            before = None
            mine = [name for name in names if base_of(name) == base]
            for name in mine if repetition % 2 else mine[::-1]:
                before = before or seconds(cases[base])
                model, after = seconds(cases[name]), seconds(cases[base])
                for clock in model:
                    more = model[clock] - (before[clock] + after[clock]) / 2
                    samples.setdefault((name, clock), []).append(per_grain * more)
                    whole.setdefault((base, clock), []).append(per_grain * after[clock])
                before = after
        print(f"repetition {repetition + 1} of {options.repeat}", flush=True)
    rows = []
    for name, found in [*((base, whole) for base in BASES if base in cases), *((name, samples) for name in names)]:
        row = {"model": name, "compared with": "" if found is whole else base_of(name)}
        for clock in ("coupling", "DEM"):
            values = found[name, clock]
            row.update({f"{clock} ns": round(statistics.median(values)), f"{clock} from": round(min(values)),
                        f"{clock} to": round(max(values))})
        rows.append(row)
    return rows


def count(folder):
    """Instructions of each of the fluid steps 3 to 6 of a run, by library."""
    # one run instead of the two of instructions.py, of which start-up is the larger part: a file for each step
    benchmark.run(["valgrind", "-q", "--tool=callgrind", "--separate-threads=yes", "--trace-children=yes",
                   "--dump-before=Foam::Time::operator++()", "--callgrind-out-file=callgrind.%p",
                   *benchmark.command("coupled", 1)], folder)
    steps = [instructions.count(path) for path in sorted(folder.glob("callgrind.*.[3-6]-01"))]
    if len(steps) != 4:
        raise SystemExit(f"{folder}: {len(steps)} files of callgrind for fluid steps 3 to 6")
    return steps


def counts(options, names, work):
    """Rows of the table of instructions per grain and interval: the mean of four steps, the smallest and the largest."""
    cases = [*(base for base in BASES if any(base_of(name) == base for name in names)), *names]
    rows, found = [], {}
    for name in cases:
        folder = work / name.replace(" ", "-")
        base = None if name in BASES else base_of(name)
        write_case(folder, {**BASES[base or name], **MODELS.get(name, {})}, options, 6)
        found[name] = count(folder)
        row = {"model": name, "compared with": base or ""}
        for library in found[name][0]:
            more = [(step[library] - (found[base][i][library] if base else 0)) / options.grains
                    for i, step in enumerate(found[name])]
            row.update({library: round(statistics.mean(more)), f"{library} from": round(min(more)),
                        f"{library} to": round(max(more))})
        rows.append(row)
        print(row, flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--instructions", action="store_true", help="counted under valgrind, instead of times")
    parser.add_argument("--grains", type=int, default=3400)
    parser.add_argument("--cells", type=int, default=12, help="along each side, of 1 mm")
    parser.add_argument("--interval", type=int, default=10, help="DEM steps per fluid step")
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--only", nargs="+", choices=list(MODELS), default=list(MODELS))
    parser.add_argument("--output", type=pathlib.Path)
    options = parser.parse_args()
    work = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-models-"))
    rows = (counts if options.instructions else times)(options, options.only, work)
    shutil.rmtree(work)
    columns = list(rows[0])
    print("\n".join(["| " + " | ".join(columns) + " |", len(columns) * "|---" + "|"]
                    + ["| " + " | ".join(str(row[column]) for column in columns) + " |" for row in rows]))
    if options.output:
        with open(options.output, "w", newline="") as out:
            table = csv.DictWriter(out, columns, lineterminator="\n")
            table.writeheader()
            table.writerows(rows)


if __name__ == "__main__":
    main()
