#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""`fix hertz/cg` against measured oblique impacts: Kharaz, Gorham & Salman, Powder Technology 120 (2001) 281,
5 mm spheres of aluminium oxide on a thick plate of soda-lime glass at 3.9 m/s, restitution 0.98, friction 0.092.

    source environment; kharaz.py <folder with the measured points> [<results folder>]

The folder holds rebound_angle.csv, tangential_restitution.csv and angular_velocity.csv: comment lines with #,
a header, and per line the impact angle from the normal (degrees) and the value. They are not part of this project.
Printed is a table of the differences; the results folder gets kharaz.csv (what the contact gives) and kharaz.png.
Nothing is fitted.
"""

import math
import pathlib
import sys
import tempfile

import numpy

from compare import curve
from grainjet import impacts as im

SPEED = 3.9                                       # m/s
BALL = im.Ball(0.0025, 4000.0)
# alumina on glass; the two moduli set the duration of the contact, and hardly anything of what was measured
MATERIAL = im.Material(380e9, 0.23, 0.98, 0.092, other=(70e9, 0.25))
QUANTITIES = {"rebound_angle": ("rebound angle", "degrees"), "tangential_restitution": ("tangential restitution", "-"),
              "angular_velocity": ("angular velocity", "rad/s")}


def rebounds(angles, material=MATERIAL, factor=1):
    """What comes of impacts at these angles from the normal (degrees): {quantity: values}."""
    states = [im.Impact(SPEED * math.cos(math.radians(a)), SPEED * math.sin(math.radians(a))) for a in angles]
    with tempfile.TemporaryDirectory(prefix="grainjet-") as folder:
        after = im.run(pathlib.Path(folder), material, BALL, states, plane=True, factor=factor)
    return {"rebound_angle": numpy.array([math.degrees(math.atan2(r.tangential, r.normal)) for r in after]),
            "tangential_restitution": numpy.array([r.tangential / s.tangential for s, r in zip(states, after)]),
            "angular_velocity": numpy.array([abs(r.spin) for r in after])}


def rigid_sphere(angles):
    """Sliding with Coulomb's friction to the end, or rolling: the closed forms without the sphere's elasticity."""
    result = {name: [] for name in QUANTITIES}
    for a in angles:
        normal, tangential = SPEED * math.cos(math.radians(a)), SPEED * math.sin(math.radians(a))
        loss = min(MATERIAL.friction * (1 + MATERIAL.restitution) * normal, 2 / 7 * tangential)
        result["rebound_angle"].append(math.degrees(math.atan2(tangential - loss, MATERIAL.restitution * normal)))
        result["tangential_restitution"].append(1 - loss / tangential)
        result["angular_velocity"].append(2.5 * loss / BALL.radius)
    return {name: numpy.array(values) for name, values in result.items()}


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    data = {name: numpy.array(curve(pathlib.Path(sys.argv[1]) / f"{name}.csv")) for name in QUANTITIES}
    angles = sorted({float(a) for points in data.values() for a in points[:, 0]})
    own = rebounds(angles)
    sliding = rigid_sphere(angles)

    print("| | points | rms difference | over the largest value | largest difference | at | rigid sphere, rms |")
    print("|---|---|---|---|---|---|---|")
    for name, (words, unit) in QUANTITIES.items():
        points = data[name]
        where = [angles.index(a) for a in points[:, 0]]
        difference = own[name][where] - points[:, 1]
        plain = sliding[name][where] - points[:, 1]
        rms, worst = math.sqrt((difference ** 2).mean()), abs(difference).argmax()
        print(f"| {words}, {unit} | {len(points)} | {rms:.3g} | {100 * rms / points[:, 1].max():.1f} % | "
              f"{difference[worst]:+.3g} | {points[worst, 0]:.0f} deg | {math.sqrt((plain ** 2).mean()):.3g} |")

    for words, material, factor in (
            ("alumina on a rigid plate", im.Material(380e9, 0.23, 0.98, 0.092, rigid=True), 1),
            ("Young's moduli of 5 MPa", im.Material(5e6, 0.23, 0.98, 0.092, other=(5e6, 0.25)), 1),
            ("f_cg = 3", MATERIAL, 3)):
        other = rebounds(angles, material, factor)
        print(f"{words}: " + ", ".join(
            f"{QUANTITIES[name][0]} differs by up to {abs(other[name] - own[name]).max():.2g}" for name in QUANTITIES))

    if len(sys.argv) < 3:
        return
    results = pathlib.Path(sys.argv[2])
    results.mkdir(parents=True, exist_ok=True)
    grid = list(range(1, 21)) + list(range(22, 66, 2))
    smooth, plain = rebounds(grid), rigid_sphere(grid)
    with open(results / "kharaz.csv", "w") as file:
        file.write("impact angle [deg]," + ",".join(f"{words} [{unit}]" for words, unit in QUANTITIES.values()) + "\n")
        for n, angle in enumerate(grid):
            file.write(f"{angle}," + ",".join(f"{smooth[name][n]:.5g}" for name in QUANTITIES) + "\n")

    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(1, 3, figsize=(13, 4))
    for axis, (name, (words, unit)) in zip(axes, QUANTITIES.items()):
        axis.plot(grid, plain[name], "--", color="grey", lw=1, label="rigid sphere")
        axis.plot(grid, smooth[name], label="fix hertz/cg")
        axis.plot(*data[name].T, "ko", ms=4, label="Kharaz et al. 2001, measured")
        axis.set_xlabel("impact angle from the normal, degrees")
        axis.set_ylabel(f"{words}, {unit}")
        axis.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(results / "kharaz.png", dpi=90)


if __name__ == "__main__":
    main()
