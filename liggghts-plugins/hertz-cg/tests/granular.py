# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of fix hertz/cg share: one script text for the stock pair style and the plugin,
random assemblies, dumps with all digits."""

import math
import random

from grainjet import dumps, scripts

MATERIAL = """
fix m1 all property/global youngsModulus peratomtype 5.e6 8.e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.25
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.9 0.7 0.7 0.8
fix m4 all property/global coefficientFriction peratomtypepair 2 0.3 0.2 0.2 0.5
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.05 0.1 0.1 0.2
fix m6 all property/global coefficientRollingViscousDamping peratomtypepair 2 0.3 0.2 0.2 0.4
fix m7 all property/global cohesionEnergyDensity peratomtypepair 2 2.e4 3.e4 3.e4 5.e4
"""

COLUMNS = ["id", "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz",
           "tqx", "tqy", "tqz", "omegax", "omegay", "omegaz"]
X, V, F, T, W = (1, 2, 3), (4, 5, 6), (7, 8, 9), (10, 11, 12), (13, 14, 15)


def head(boundary="p p p", more=""):
    """Everything before the box."""
    return f"""atom_style granular
atom_modify map array
boundary {boundary}
newton off
communicate single vel yes
units si
{more}
"""


STOCK, PLUGIN = "stock", "plugin"


def contacts(kind, tangential="history", rolling="off", more="", words=""):
    """The contact law, by the stock pair style or by the plugin. words: further ones of the stock
    style, for both; more: for the plugin alone."""
    if kind == STOCK:
        options = f"tangential {tangential}" if tangential != "off" else ""
        options += f" rolling_friction {rolling}" if rolling != "off" else ""
        return f"pair_style gran model hertz {options} {words}\npair_coeff * *\n"
    options = f"rolling {rolling}" if rolling != "off" else ""
    return f"fix c all hertz/cg tangential {tangential} {options} {words} {more}\n"


def load(kind):
    return "plugin load hertzcgplugin.so\n" if kind == PLUGIN else ""


def dump(every, name="dump.txt"):
    return scripts.dump(every, name, " ".join(COLUMNS))


def read_dump(path):
    """{step: {id: [numbers in COLUMNS]}}"""
    return {frame.step: {int(row[0]): row for row in frame.rows} for frame in dumps.frames(path)}


def difference(a, b, columns):
    """Largest difference of two frames over the largest magnitude in the first."""
    assert a.keys() == b.keys(), "not the same grains"
    scale = max((abs(a[i][k]) for i in a for k in columns), default=0.0) or 1.0
    return max((abs(a[i][k] - b[i][k]) for i in a for k in columns), default=0.0) / scale


def distance(a, b, box):
    """Largest distance of the same grain in two frames of a periodic cube; the programs may
    send a grain round at different steps."""
    assert a.keys() == b.keys(), "not the same grains"
    return max(abs(d - box * round(d / box)) for i in a for d in (a[i][k] - b[i][k] for k in X))


def last_digit(data):
    """The same data file with every position moved by one unit in the last place."""
    before, rest = data.split("\nAtoms\n\n")
    rows, after = rest.split("\nVelocities\n")
    moved = []
    for row in rows.strip().split("\n"):
        words = row.split()
        words[4:] = [repr(math.nextafter(float(w), 1.0)) for w in words[4:]]
        moved.append(" ".join(words) + "\n")
    return before + "\nAtoms\n\n" + "".join(moved) + "\nVelocities\n" + after


def square(half, z, parts=1):
    """A horizontal square of 2 parts^2 triangles around the z axis."""
    step, out = 2.0 * half / parts, []
    for i in range(parts):
        for j in range(parts):
            x, y = -half + i * step, -half + j * step
            out += scripts.rectangle((x, y, z), (x + step, y, z), (x + step, y + step, z), (x, y + step, z))
    return out


def assembly(n, box, diameters, speed, spin, seed=3, clearance=0.0, types=(1, 2),
             stream=(0.0, 0.0, 0.0)):
    """A data file of n grains at random places; clearance > 0: none touches another, by that
    fraction of the diameter."""
    rng = random.Random(seed)
    grains = []
    while len(grains) < n:
        d, x = rng.choice(diameters), [rng.random() * box for _ in range(3)]
        if clearance:
            def far(other):
                gap = sum(min(abs(p - q), box - abs(p - q)) ** 2 for p, q in zip(x, other[1]))
                return gap > (0.5 * (1 + clearance) * (d + other[0])) ** 2
            if not all(map(far, grains)):
                continue
        grains.append((d, x))
    kinds = [rng.choice(types) for _ in grains]
    rows = [(kind, d, 2500, x, [rng.gauss(mean, speed) for mean in stream], [rng.gauss(0, spin) for _ in range(3)])
            for kind, (d, x) in zip(kinds, grains)]
    return scripts.data(rows, ((0, box),) * 3, max(types))
