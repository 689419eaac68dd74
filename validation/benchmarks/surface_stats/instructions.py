#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What fix surface/stats costs, as a share of the DEM step, in instructions.

20,000 grains of 80 um fly without loss between a mesh of 10,082 triangles and a primitive wall, so densely that
300 touch the mesh at any time. valgrind's callgrind counts what LIGGGHTS spends inside its steps, the first ones left
out, without and with the fix, whatever else the machine does. Counted are collisions, sliding, wear by Oka's law and
the gathering, without files, which depend on `every`. fix plate/stats on the same mesh is there for comparison.
`flat`: triangles in one plane; `hills`: convex and concave edges.

    source environment; validation/benchmarks/surface_stats/instructions.py [--grains N]

prints a table and writes results/instructions.csv. Takes some minutes. More grains make the share smaller.
"""

import argparse
import csv
import math
import pathlib
import random
import re
import shutil
import tempfile

import grainjet
from grainjet import scripts

HERE = pathlib.Path(__file__).resolve().parent

D, RHO, SPEED, WIDTH, ROOM, DT = 80e-6, 2950.0, 1.2, 0.02, 4e-8, 1e-6     # ROOM: m of height for each grain
SIDE = 71                       # squares of two triangles along each side of the mesh
FIRST, STEPS = 50, 40

SURFACE = "fix s all surface/stats mesh m wall w wear oka abrasive SiO2 hardness 1.8e9 every 1000000 file table.csv"
PLATE = "fix s all plate/stats wall w centre 0 0 0 normal 0 0 1 radius 0.0141 rings 7 every 1000000 file plate.csv"
CASES = (("flat", "none", ""), ("flat", "surface/stats", SURFACE), ("flat", "plate/stats", PLATE),
         ("hills", "none", ""), ("hills", "surface/stats", SURFACE))

SCRIPT = """
plugin load platestatsplugin.so
plugin load surfacestatsplugin.so
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
fix m4 all property/global coefficientFriction peratomtypepair 1 0.1
pair_style gran model hertz tangential history
pair_coeff * *
timestep {dt}
fix m all mesh/surface file {mesh}.stl type 1
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes m store_force yes
fix t all wall/gran model hertz tangential history primitive type 1 zplane {height}
fix i all nve/sphere
thermo 100000
{line}
run {first}
run {steps}
{end}
"""


def write_meshes(folder):
    at = [WIDTH * (i / SIDE - 0.5) for i in range(SIDE + 1)]
    for name, rise in (("flat", 0.0), ("hills", 5e-5)):
        def corner(i, j):
            return at[i], at[j], rise * (math.sin(20 * math.pi * i / SIDE) * math.sin(20 * math.pi * j / SIDE) - 1)
        (folder / f"{name}.stl").write_text(scripts.stl(*(
            triangle for i in range(SIDE) for j in range(SIDE) for triangle in scripts.rectangle(
                corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)))))


def write_grains(folder, number, height):
    """Random places without overlap, random directions of flight."""
    random.seed(7)
    pitch = 1.5 * D
    across, up = int(WIDTH / pitch), int(height / pitch)
    half, grains = WIDTH / 2, []
    for place in random.sample(range(across * across * up), number):
        x, y, z = place % across, place // across % across, place // across ** 2
        grains.append((1, D, RHO, ((x + 0.5) * pitch - half, (y + 0.5) * pitch - half, (z + 0.5) * pitch),
                       [random.gauss(0, SPEED) for _ in range(3)]))
    (folder / "grains.data").write_text(scripts.data(
        grains, ((-half, half), (-half, half), (-2e-4, height + 1e-4))))


def count(folder, mesh, line, height):
    """Instructions of a step, and grains that touch the mesh at the end."""
    end = 'variable n equal f_s[2]\nprint "touching = $n"' if line else ""
    (folder / "in.bench").write_text(SCRIPT.format(
        dt=DT, height=height, mesh=mesh, line=line, first=FIRST, steps=STEPS, end=end))
    for name in ("table.csv", "plate.csv"):
        (folder / name).unlink(missing_ok=True)
    loop = "LAMMPS_NS::Verlet::run(int)"
    result = grainjet.run(["valgrind", "-q", "--tool=callgrind", "--trace-children=yes", "--trace-children-skip=*orted*",
                           f"--toggle-collect={loop}", f"--dump-after={loop}",
                           "--callgrind-out-file=callgrind.%p", "liggghts-plugins", "-in", "in.bench"], folder, timeout=7200)
    if result.code != 0:
        raise SystemExit(repr(result))
    totals = {}
    for path in folder.glob("callgrind.*"):
        text = path.read_text(errors="replace")
        part, total = re.search(r"(?m)^part: ([0-9]+)", text), re.search(r"(?m)^(?:summary|totals): ([0-9]+)", text)
        if part and total and int(total[1]):
            totals[int(part[1])] = int(total[1])
        path.unlink()
    touching = re.search("touching = ([0-9]+)", result.output)
    return totals[2] / STEPS, float(touching[1]) if touching else float("nan")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--grains", type=int, default=20000)
    options = parser.parse_args()
    if not shutil.which("valgrind"):
        raise SystemExit("valgrind is not installed: apt-get install valgrind")

    rows, without = [], None
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        write_meshes(folder)
        height = ROOM * options.grains
        write_grains(folder, options.grains, height)
        for mesh, fix, line in CASES:
            step, touching = count(folder, mesh, line, height)
            if not line:
                without = step
            rows.append({"mesh": mesh, "triangles": 2 * SIDE ** 2, "grains": options.grains, "fix": fix,
                         "contacts": touching, "instructions_per_step": step,
                         "overhead_percent": 100 * (step / without - 1),
                         "instructions_per_contact": (step - without) / touching})
            print("{mesh:6s} {fix:14s} {contacts:4.0f} contacts, {instructions_per_step:11.0f} instructions per step, "
                  "{overhead_percent:5.2f} %, {instructions_per_contact:6.0f} per contact".format(**rows[-1]), flush=True)

    results = HERE / "results"
    results.mkdir(exist_ok=True)
    with open(results / "instructions.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        for row in rows:
            writer.writerow({k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()})


if __name__ == "__main__":
    main()
