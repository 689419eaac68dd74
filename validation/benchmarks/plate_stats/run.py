#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What fix plate/stats and fix fluid/force cost, as a share of the DEM step.

50,000 grains of 80 um fly between two walls without loss, so that hundreds touch the plate
at any time and the load stays the same. One process alternates short runs without and
with the fix, so that a slow spell of the machine hits both; the figure is the median of
the ratios of neighbouring runs, with its standard error. Time is that on the processor
(/proc/<pid>/schedstat), which other programs lengthen less than the time on the wall.
Pair style and walls are stock.

    source environment; validation/benchmarks/plate_stats/run.py [--pairs N] [--only name]

writes results/<name>.csv and prints a table. Takes about 6 minutes on one quiet core.
"""

import argparse
import csv
import math
import pathlib
import random
import re
import statistics
import tempfile

import grainjet
from grainjet import scripts

HERE = pathlib.Path(__file__).resolve().parent

N, D, RHO, SPEED, WIDTH, HEIGHT, DT, STEPS = 50000, 80e-6, 2950.0, 1.2, 0.02, 0.002, 1e-6, 300

PLATE = ("fix p all plate/stats wall w centre 0 0 0 normal 0 0 1 radius 0.0141 rings 7 every 1000 "
         "file plate.csv events events.csv")
FLUID = "fix f all fluid/force uniform 0 0 0 density 1.2 viscosity 1.5e-5 drag gidaspow"
COUPLED = "fix f all fluid/force coupled"
CASES = {
    "plate_stats": (PLATE, "unfix p"),
    "fluid_force_coupled": (COUPLED, "unfix f"),
    "fluid_force_uniform": (FLUID, "unfix f"),
}

SCRIPT = """
plugin load platestatsplugin.so
plugin load fluidforceplugin.so
atom_style granular
atom_modify map array sort 100 0.0005
boundary p p f
newton off
communicate single vel yes
units si
soft_particles yes
read_data grains.data
neighbor 0.00024 bin
neigh_modify delay 0 binsize 0.0004
fix m1 all property/global youngsModulus peratomtype 1.e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 1.0
fix m4 all property/global coefficientFriction peratomtypepair 1 0.0
pair_style gran model hertz tangential history
pair_coeff * *
timestep {dt}
fix w all wall/gran model hertz tangential history primitive type 1 zplane 0.0 store_force yes
fix t all wall/gran model hertz tangential history primitive type 1 zplane {height}
fix i all nve/sphere
thermo {steps}
thermo_modify lost error
run {steps}
"""


def data(path):
    """Random places without overlap, random directions of flight."""
    random.seed(7)
    pitch = 1.5 * D
    across, up = int(WIDTH / pitch), int(HEIGHT / pitch)
    places = random.sample(range(across * across * up), N)
    half, grains = WIDTH / 2, []
    for place in places:
        x, y, z = place % across, place // across % across, place // across ** 2
        grains.append((1, D, RHO, ((x + 0.5) * pitch - half, (y + 0.5) * pitch - half, (z + 0.5) * pitch),
                       [random.gauss(0, SPEED) for _ in range(3)]))
    path.write_text(scripts.data(grains, ((-half, half), (-half, half), (-1e-4, HEIGHT + 1e-4))))


# prints the nanoseconds that the LIGGGHTS process above has spent on a processor
CLOCK = """
pid=$$
until grep -q liggghts /proc/$pid/comm; do pid=$(awk '/^PPid/ {print $2}' /proc/$pid/status); done
echo on processor $(cut -d' ' -f1 /proc/$pid/schedstat)
"""


def measure(define, remove, pairs, folder):
    """Times (s) of the runs without and with the fix, alternating, and grains in contact."""
    body = SCRIPT.format(dt=DT, height=HEIGHT, steps=STEPS)
    contacts = 'variable n equal f_p[2]\nprint "touching = $n"\n' if define is PLATE else ""
    timed = f"shell sh clock.sh\nrun {STEPS}\nshell sh clock.sh\n"
    for _ in range(pairs):
        body += f"{timed}{define}\n{timed}{contacts}{remove}\n"
    (folder / "in.bench").write_text(body)
    (folder / "clock.sh").write_text(CLOCK)
    result = grainjet.run(["liggghts-plugins", "-in", "in.bench"], folder, timeout=3600)
    if result.code != 0:
        raise SystemExit(repr(result))
    stamps = [float(t) for t in re.findall(r"on processor ([0-9]+)", result.output)]
    times = [1e-9 * (end - start) for start, end in zip(stamps[0::2], stamps[1::2])]
    touching = [float(t) for t in re.findall(r"touching = ([0-9.e+-]+)", result.output)]
    return times[0::2], times[1::2], touching


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--pairs", type=int, default=40)
    parser.add_argument("--only", choices=CASES, action="append")
    options = parser.parse_args()

    rows = []
    for name in options.only or CASES:
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            data(folder / "grains.data")
            without, with_fix, touching = measure(*CASES[name], options.pairs, folder)
        # the run before and the one after the fix's bracket it in time
        ratios = [b / (0.5 * (a + c)) - 1 for a, b, c in zip(without, with_fix, without[1:])]
        spread = 1.2533 * statistics.stdev(ratios) / math.sqrt(len(ratios))
        rows.append({"fix": name, "pairs": len(ratios),
                     "ns_per_grain_step": 1e9 * statistics.median(without) / (N * STEPS),
                     "overhead_percent": 100 * statistics.median(ratios),
                     "standard_error_percent": 100 * spread,
                     "contacts_at_a_time": statistics.mean(touching) if touching else float("nan")})
        print("{fix:22s} DEM step {ns_per_grain_step:6.1f} ns per grain, overhead "
              "{overhead_percent:6.2f} +- {standard_error_percent:.2f} %, contacts "
              "{contacts_at_a_time:.0f}".format(**rows[-1]), flush=True)

    results = HERE / "results"
    results.mkdir(exist_ok=True)
    with open(results / "overhead.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        for row in rows:
            writer.writerow({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()})


if __name__ == "__main__":
    main()
