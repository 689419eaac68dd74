# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains that hit each other, for the tests of fix collision/stats."""

import csv
import math
import random
import re

import grainjet
from grainjet import scripts

YOUNG, POISSON = 5e6, 0.3

SCRIPT = """
plugin load hertzcgplugin.so
plugin load collisionstatsplugin.so
{before}
atom_style granular
atom_modify map array
boundary {boundary}
newton off
communicate single vel yes
units {units}
processors {processors}
{read}
neighbor 0.0005 bin
fix m1 all property/global youngsModulus peratomtype {young}
fix m2 all property/global poissonsRatio peratomtype {poisson}
fix m3 all property/global coefficientRestitution peratomtypepair {types} {e}
fix m4 all property/global coefficientFriction peratomtypepair {types} {mu}
{contact}
timestep {dt!r}
fix i all nve/sphere
"""

STATS = "fix k all collision/stats contact c every 1000000 file collisions.csv"


def mass(diameter, density):
    return math.pi / 6 * diameter ** 3 * density


def effective(a, b):
    return a * b / (a + b)


def hertz(radius, mass, speed, young=YOUNG):
    """Largest overlap, peak force and duration of a head-on elastic impact of two equal materials; radius and mass:
    effective ones (Johnson, Contact Mechanics, 11.4)."""
    modulus = young / (2 * (1 - POISSON ** 2))
    k = 4 / 3 * modulus * math.sqrt(radius)
    depth = (5 * mass * speed ** 2 / (4 * k)) ** 0.4
    return depth, k * depth ** 1.5, 2.9432750643 * depth / speed


def gas(count, fraction, diameters, speed, seed, types=1, spin=0.0):
    """Grains at random places in a periodic cube, apart from each other by a tenth of their diameter at least: rows
    and the cube's width."""
    rng = random.Random(seed)
    sizes = [rng.choice(diameters) for _ in range(count)]
    width = (sum(math.pi / 6 * d ** 3 for d in sizes) / fraction) ** (1 / 3)
    cells, placed = {}, []
    cell = 1.1 * max(diameters)
    n = max(int(width / cell), 1)

    def near(x):
        at = [int(c / width * n) for c in x]
        return {tuple((a + s) % n for a, s in zip(at, (i, j, k)))
                for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)}

    for d in sizes:
        while True:
            x = [rng.random() * width for _ in range(3)]
            if all(sum(min(abs(p - q), width - abs(p - q)) ** 2 for p, q in zip(x, y)) > (0.55 * (d + e)) ** 2
                   for c in near(x) for y, e in cells.get(c, ())):
                break
        cells.setdefault(tuple(int(c / width * n) for c in x), []).append((x, d))
        placed.append((rng.randint(1, types), d, 2500.0, x, [rng.gauss(0, speed) for _ in range(3)],
                       [rng.gauss(0, spin) for _ in range(3)]))
    mean = [sum(row[4][k] for row in placed) / count for k in range(3)]
    for row in placed:
        row[4][:] = [v - m for v, m in zip(row[4], mean)]
    return placed, width


class CollisionCase(grainjet.Case):

    def data(self, grains, box, types=1, name="grains.data"):
        """grains: (type, diameter, density, place, velocity, spin); box: (low, high) of each axis, or a width."""
        limits = ((0, box),) * 3 if isinstance(box, float) else box
        (self.folder / name).write_text(scripts.data(grains, limits, types))

    def script(self, body, stats=STATS, dt=1e-6, e=0.9, mu=0.3, types=1, young=YOUNG, read="read_data grains.data",
               boundary="p p p", processors="* * *", units="si", before="", contact="fix c all hertz/cg"):
        def each(value, count):
            return " ".join([repr(value)] * count)
        return SCRIPT.format(before=before, boundary=boundary, units=units, processors=processors, read=read, types=types,
                             young=each(young, types), poisson=each(POISSON, types), e=each(e, types ** 2),
                             mu=each(mu, types ** 2), contact=contact, dt=dt) + f"{stats}\n{body}\n"

    def rows(self, name="collisions.csv"):
        """{(region, types): row} of the table of totals, numbers as floats."""
        with open(self.folder / name, newline="") as file:
            return {(row["region"], row["types"]): {k: float(v) for k, v in row.items() if k not in ("region", "types")}
                    for row in csv.DictReader(file)}

    def spectrum(self, quantity, region="all", types="all", name="collisions_spectra.csv"):
        """[(from, to, collisions, density)]"""
        with open(self.folder / name, newline="") as file:
            return [tuple(float(row[k]) for k in ("from", "to", "collisions", "density"))
                    for row in csv.DictReader(file)
                    if (row["quantity"], row["region"], row["types"]) == (quantity, region, types)]

    def printed(self, result, name):
        """Numbers behind a word that the script prints at the start of a line."""
        return [float(x) for x in re.findall(rf"^{name} (.*)$", result.output, re.M)[-1].split()]
