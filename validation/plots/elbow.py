#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of the elbow case: wear map of the bend, seen from outside, and the wear along its outer line.

    elbow.py <case> [--output elbow.png]
"""

import argparse
import pathlib
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.colors
import matplotlib.pyplot as plt
import numpy

HERE = pathlib.Path(__file__).resolve()
sys.path[:0] = [str(HERE.parent), str(HERE.parents[2]/"cases"/"elbow")]
import bend
import surface


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("case", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("elbow.png"))
    args = parser.parse_args()

    b = bend.Bend(args.case)
    depth = 1e6*b.map.values["wear_depth"]/b.sand
    figure, (outside, beside, line) = plt.subplots(1, 3, figsize=(14, 4.6), constrained_layout=True, gridspec_kw={"width_ratios": (0.75, 1, 1.25)})
    norm = matplotlib.colors.Normalize(0, numpy.quantile(depth[depth > 0], 0.995) if (depth > 0).any() else 1)
    drawn = surface.draw_map(outside, b.map, depth, look=(1, 0, -1), up=(1, 0, 1), length=b.p["D"], norm=norm)
    outside.set(xlabel="$y/D$", ylabel="along the pipe, $D$", title="outer side")
    surface.draw_map(beside, b.map, depth, look=(0, 1, 0), up=(0, 0, 1), length=b.p["D"], norm=norm)
    beside.set(xlabel="$x/D$", ylabel="$z/D$", title="side, flow from below")
    figure.colorbar(drawn, ax=[outside, beside], label="wear depth, um per kg of sand", shrink=0.85)

    at = numpy.arange(0, 90.01, 0.5)
    for name, where, style in (("all hits", b.outer, "-"), ("first hits", b.outer & b.first, "--")):
        chosen = numpy.flatnonzero(where)
        wear = b.events["wear_volume"][chosen]
        line.plot(at, 1e6*b.smoothed(at, chosen, wear), style, color="#1f5f9f", label=name)
    line.axvspan(29, 42, color="#1b9e77", alpha=0.18, label="largest, measured (2016)")
    line.axvspan(45, 55, color="#d95f02", alpha=0.18, label="largest, computed (2023)")
    line.axvline(b.straight(0), color="black", linewidth=0.8, linestyle=":", label="straight flight on the axis")
    line.set(xlabel="degrees along the bend", ylabel="wear depth, um/kg", title="outer line", xlim=(0, 90), ylim=(0, None))
    line.grid(alpha=0.3)
    line.legend(fontsize=8)
    args.output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(args.output, dpi=130)


if __name__ == "__main__":
    main()
