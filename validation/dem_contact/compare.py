#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""`fix hertz/cg` against the benchmark tests of Chung & Ooi, Granular Matter 13 (2011) 643.

    source environment; compare.py <folder with digitised curves> [<picture.png>]

The folder holds test1_glass_force_time.csv, test1_glass_force_displacement.csv,
test2_al_alloy_force_time.csv, test2_al_alloy_force_displacement.csv, test4_*.csv and
test6_beta_and_recoil.csv: comment lines with #, a header, columns. Printed is the root mean square
difference of each curve over the largest value in it. The curves are not part of this project.
"""

import csv
import math
import pathlib
import sys
import tempfile

from grainjet import dumps, impacts as im, scripts

GLASS = im.Material(48e9, 0.20, 1.0, 0.35)
ALLOY_PLANE = im.Material(70e9, 0.30, 1.0, 0.0, rigid=True)
OXIDE = im.Material(380e9, 0.23, 0.98, 0.092, rigid=True)
SPINNING = im.Material(70e9, 0.33, 0.5, 0.4, rigid=True)


def curve(path, *key):
    """Columns x, y of a file; with a key the rows that begin with it."""
    rows = [row for row in csv.reader(line for line in path.read_text().split("\n") if line and line[0] != "#")][1:]
    return [tuple(map(float, row[len(key):])) for row in rows if tuple(row[:len(key)]) == key]


def interpolate(points, x):
    points = sorted(points)
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return points[0][1] if x < points[0][0] else points[-1][1]


def history(folder, material, ball, speed, plane):
    """(time, overlap, force) in us, um, kN at every step of a contact."""
    im.run(folder, material, ball, [im.Impact(speed)], plane=plane,
           extra=scripts.dump(1, "history", "id x fx", "h"))
    one, other = ([row for frame in dumps.frames(folder / "history") for row in frame.rows if row[0] == n]
                  for n in (1, 2))
    dt = im.hertz(material, ball, speed, plane)[2] / 2000
    radii = ball.radius * (1 + (im.LARGE if plane else 1))
    touching = [(radii - (b[1] - a[1]), abs(a[2])) for a, b in zip(one, other) if a[2] != 0.0]
    return [(n * dt * 1e6, d * 1e6, f * 1e-3) for n, (d, f) in enumerate(touching)]


def tests(reference):
    """Yields name, reference points, own points."""
    with tempfile.TemporaryDirectory(prefix="grainjet-") as name:
        folder = pathlib.Path(name)
        for test, file, material, ball, speed, plane in (
                ("1 glass", "test1_glass", GLASS, im.Ball(0.010, 2800), 20.0, False),
                ("2 Al alloy", "test2_al_alloy", ALLOY_PLANE, im.Ball(0.10, 2699), 0.2, True)):
            rows = history(folder, material, ball, speed, plane)
            yield (f"{test}: force [kN] over time [us]", curve(reference / f"{file}_force_time.csv"),
                   [(t, f) for t, _, f in rows])
            half = rows[:len(rows) // 2]
            yield (f"{test}: force [kN] over overlap [um]", curve(reference / f"{file}_force_displacement.csv"),
                   [(d, f) for _, d, f in half])

        ball, speed = im.Ball(0.0025, 4000), 3.9
        angles = list(range(2, 88, 2))
        states = [im.Impact(speed * math.cos(math.radians(a)), speed * math.sin(math.radians(a))) for a in angles]
        after = im.run(folder, OXIDE, ball, states, plane=True)
        yield ("4 Al oxide: tangential restitution over angle", curve(reference / "test4_tangential_restitution.csv", "Al_oxide"),
               [(a, r.tangential / s.tangential) for a, s, r in zip(angles, states, after)])
        yield ("4 Al oxide: spin [rad/s] over angle", curve(reference / "test4_rebound_angular_velocity.csv", "Al_oxide"),
               [(a, r.spin) for a, r in zip(angles, after)])
        yield ("4 Al oxide: rebound angle of the patch over angle", curve(reference / "test4_contact_patch_rebound_angle.csv", "Al_oxide"),
               [(a, math.degrees(math.atan((r.tangential + ball.radius * r.spin) / r.normal))) for a, r in zip(angles, after)])

        ball, vn = im.Ball(0.1, 2700), 0.2
        ratios = [0.1 * n for n in range(1, 80)]
        states = [im.Impact(vn, 0.0, r * vn / ball.radius) for r in ratios]
        after = im.run(folder, SPINNING, ball, states, plane=True)
        patch = [r.tangential + ball.radius * r.spin for r in after]
        yield ("6 Al alloy: recoil Vst'/Vcn' over Vst/Vcn", curve(reference / "test6_beta_and_recoil.csv", "recoil", "Al_alloy"),
               [(r, p / a.normal) for r, p, a in zip(ratios, patch, after)])


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    done = []
    for name, points, own in tests(pathlib.Path(sys.argv[1])):
        inside = [p for p in points if own[0][0] <= p[0] <= own[-1][0]]
        scale = max(abs(y) for _, y in points)
        rms = math.sqrt(sum((interpolate(own, x) - y) ** 2 for x, y in inside) / len(inside)) / scale
        print(f"{name}: {100 * rms:.1f} % of its largest value, {len(inside)} points")
        done.append((name, points, own))
    if len(sys.argv) > 2:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        figure, axes = plt.subplots(2, 4, figsize=(17, 7.5))
        for axis, (name, points, own) in zip(axes.flat, done):
            axis.plot(*zip(*own), label="fix hertz/cg")
            axis.plot(*zip(*points), "o", ms=3, label="Chung & Ooi (2011)")
            axis.set_title(name, fontsize=9)
            axis.legend(fontsize=8)
        figure.tight_layout()
        figure.savefig(sys.argv[2], dpi=110)


if __name__ == "__main__":
    main()
