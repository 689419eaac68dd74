#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of `fix hertz/cg` against the stock pair style, in one run, alternating.

    source environment; run.py [case ...] [--grains N] [--steps N] [--repeat N] [--ranks N] [--skin X ...] [--profile]

Cases
    first   a dilute stream in a pipe with the settings a user writes first:
            `neighbor 80e-6 bin`, no bin size, no sorting
    best    the same, stock with its best settings (skin, bin size and sorting found by hand),
            the plugin with the user's first ones: it chooses its own
    dense   a settled bed
    tube, hopper, floor, screw, drum, or all of them as `walls`
            mesh walls: from an empty box in one run, both programs with the same settings and
            `neighbor` of --skin diameters; numbers of grains and steps are the case's own

Both programs of a pair run one after the other, `--repeat` times; printed are the times per grain
and step and the median of the ratios stock/plugin with its range. With --profile the functions
that take the time, from `perf record`. Times are of LIGGGHTS' own loop, without set-up; with mesh
walls processor time of the whole run on all ranks, since insertion belongs to the run.
"""

import argparse
import itertools
import math
import os
import pathlib
import random
import re
import resource
import shutil
import statistics
import subprocess
import tempfile

import grainjet
import walls
from grainjet import scripts

D, DENSITY, PIPE = 80e-6, 2950.0, 14.2e-3

MATERIAL = """
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.926
fix m4 all property/global coefficientFriction peratomtypepair 1 0.18
"""

STOCK = "pair_style gran model hertz tangential history\npair_coeff * *\n"
# a restart file brings its pair style along
PLUGIN = "pair_style none\nfix c all hertz/cg\n"


def stream(folder, grains):
    """Grains at random in a pipe along z at solid fraction 4e-4, periodic; its length."""
    rng = random.Random(1)
    volume = grains * 3.14159265 / 6 * D ** 3 / 4e-4
    length = volume / (3.14159265 / 4 * PIPE ** 2)
    radius = 0.5 * PIPE
    places = []
    taken = {}      # cells of one diameter: no two grains may overlap at the start
    for _ in range(grains):
        while True:
            x, y, z = rng.uniform(-radius, radius), rng.uniform(-radius, radius), rng.random() * length
            cell = (int(x // D), int(y // D), int(z // D))
            near = [taken[key] for key in itertools.product(*((c - 1, c, c + 1) for c in cell)) if key in taken]
            if x * x + y * y < (radius - D) ** 2 and D < z < length - D and not any(
                    math.dist((x, y, z), other) < 1.01 * D for other in near):
                break
        taken[cell] = (x, y, z)
        places.append((x, y, z))
    (folder / "stream.data").write_text(scripts.data(
        [(1, D, DENSITY, x, [rng.gauss(mean, 0.3) for mean in (0, 0, 6)]) for x in places],
        ((-radius, radius), (-radius, radius), (0, length))))


def stream_script(law, settings, steps):
    neighbor, before = settings
    return f"""{'plugin load hertzcgplugin.so' if law is PLUGIN else ''}
atom_style granular
atom_modify map array
{before}
boundary f f p
newton off
communicate single vel yes
units si
read_data stream.data
{neighbor}
{MATERIAL}
{law}
fix g all gravity 9.81 vector 0 0 1
fix w all wall/gran model hertz tangential history primitive type 1 zcylinder {0.5 * PIPE} 0 0
fix i all nve/sphere
timestep 1e-6
thermo 100000
run 50
run {steps}
"""


def bed(folder, grains):
    """A bed of grains settled by the stock program, written as a data file."""
    side = (grains * D ** 3 / 1.1 / 2.0) ** (1 / 3)
    rng = random.Random(2)
    cells = int((grains / 2) ** (1 / 3) / 1.26) + 1
    pitch = side / cells
    layers, places = grains // cells ** 2 + 1, []
    for i in range(grains):
        k, rest = divmod(i, cells ** 2)
        x, y = rest % cells, rest // cells
        places.append(((x + 0.5) * pitch + rng.uniform(-.02, .02) * D, (y + 0.5) * pitch + rng.uniform(-.02, .02) * D,
                       (k + 0.7) * 1.05 * D))
    (folder / "loose.data").write_text(scripts.data(
        [(1, D, DENSITY, x) for x in places], ((0, side), (0, side), (0, (layers + 2) * 1.05 * D))))
    (folder / "in.settle").write_text(bed_script(STOCK, "read_data loose.data", """
fix s all viscous 2e-7
run 20000
unfix s
run 1000
write_restart bed
"""))
    done = grainjet.run(["liggghts", "-in", "in.settle"], folder, timeout=3000)
    assert done.code == 0, done


def bed_script(law, source, tail):
    return f"""{'plugin load hertzcgplugin.so' if law is PLUGIN else ''}
atom_style granular
atom_modify map array
boundary p p f
newton off
communicate single vel yes
units si
{source}
neighbor {0.25 * D} bin
neigh_modify delay 0
{MATERIAL}
{law}
fix g all gravity 9.81 vector 0 0 -1
fix w all wall/gran model hertz tangential history primitive type 1 zplane 0
fix i all nve/sphere
timestep 5e-7
thermo 100000
{tail}
"""


FIRST = ("neighbor 80e-6 bin\nneigh_modify delay 0", "atom_modify sort 0 0")
BEST = ("neighbor 280e-6 bin\nneigh_modify delay 0 binsize 0.0004", "atom_modify sort 100 0.0005")


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def timed(folder, script, ranks, profile=None, whole=False):
    """Seconds of the last loop in the script; whole: processor time of the run."""
    (folder / "in.bench").write_text(script)
    command = [*grainjet.mpirun(ranks if ranks > 1 else 0), "liggghts-plugins", "-in", "in.bench"]
    if profile:
        command = ["perf", "record", "-q", "-o", str(folder / "perf.data"), *command]
    before = processor_time()
    done = grainjet.run(command, folder, timeout=3600)
    used = processor_time() - before
    assert done.code == 0, done
    if profile:
        report = subprocess.run(["perf", "report", "-i", str(folder / "perf.data"), "--stdio", "--no-children",
                                 "-s", "symbol"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout.decode()
        print(f"  profile, {profile}:")
        shown = [line for line in report.split("\n") if line and not line.startswith("#")]
        print("\n".join("  " + line[:110] for line in shown[:14]))
    return used if whole else float(re.findall(r"^Loop time of (\S+)", done.output, re.M)[-1])


def compare(folder, label, runs, grains, steps, args, whole=False):
    times, ratios = {name: [] for name in runs}, []
    for _ in range(args.repeat):
        for name, script in runs.items():
            times[name].append(timed(folder, script, args.ranks, whole=whole) / steps / grains * 1e9)
        ratios.append(times["stock"][-1] / times["plugin"][-1])
    print(f"{label}: stock {statistics.median(times['stock']):.1f}, plugin {statistics.median(times['plugin']):.1f}; "
          f"stock/plugin {statistics.median(ratios):.2f} (from {min(ratios):.2f} to {max(ratios):.2f}, "
          f"{args.repeat} pairs of {steps} steps)", flush=True)
    if args.profile:
        for name, script in runs.items():
            timed(folder, script, args.ranks, name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--grains", type=int, default=50000)
    parser.add_argument("--steps", type=int, default=1000)
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--skin", type=float, nargs="+", default=[0.1, 0.5])
    parser.add_argument("--profile", action="store_true")
    parser.add_argument("case", nargs="*", default=["first", "best", "dense"])
    args = parser.parse_args()

    folder = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-bench-"))
    try:
        print(f"{args.grains} grains, {args.ranks} rank(s), {os.cpu_count()} cores, "
              f"load {os.getloadavg()[0]:.1f}; ns per grain and step")
        cases = [c for case in args.case for c in (walls.CASES if case == "walls" else [case])]
        for case in cases:
            steps = args.steps
            if case in walls.CASES:
                triangles = walls.prepare(folder, case)
                grains, steps = walls.CASES[case]["grains"], walls.CASES[case]["steps"]
                for skin in args.skin:
                    runs = {law: walls.script(case, law, skin) for law in walls.LAWS}
                    compare(folder, f"{case}, {triangles} triangles, skin {skin} d", runs, grains, steps, args, whole=True)
                continue
            if case == "dense":
                bed(folder, args.grains)
                runs = {name: bed_script(law, "read_restart bed", f"run 50\nrun {steps}")
                        for name, law in (("stock", STOCK), ("plugin", PLUGIN))}
            else:
                stream(folder, args.grains)
                if case == "first":
                    steps = max(100, steps // 5)
                runs = {"stock": stream_script(STOCK, FIRST if case == "first" else BEST, steps),
                        "plugin": stream_script(PLUGIN, FIRST, steps)}
            compare(folder, case, runs, args.grains, steps, args)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main()
