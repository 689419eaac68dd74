#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of a jet: grains in a slice along the axis over the speed of the fluid.

    jet.py <case> --diameter 0.015 [--grains postProcessing/grains] [--output jet.png]
"""

import argparse
import pathlib

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

from grainjet import fields


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("case", type=pathlib.Path)
    parser.add_argument("--diameter", type=float, required=True, help="of the nozzle, m")
    parser.add_argument("--grains", default="postProcessing/grains",
                        help="folder of a vtkCloud function object, below the case")
    parser.add_argument("--thickness", type=float, default=0.2,
                        help="of the slice of grains that is shown, in nozzle diameters")
    parser.add_argument("--radius", type=float, default=3.5, help="shown, in nozzle diameters")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("jet.png"))
    args = parser.parse_args()

    time, grid = fields.latest_mesh(args.case)
    points, triangles, velocity = fields.axial_slice(grid, "U")
    _, grains, _ = fields.grains_at(args.case/args.grains, time)
    D = args.diameter
    shown = grains[abs(grains[:, 1]) < 0.5*args.thickness*D]

    z, x = points[:, 2]/D, points[:, 0]/D
    speed = numpy.linalg.norm(velocity, axis=1)
    figure, axes = plt.subplots(figsize=(11, 2.95), constrained_layout=True)
    fluid = axes.tripcolor(z, x, triangles, speed, shading="gouraud", cmap="viridis", vmin=0)
    axes.plot(shown[:, 2]/D, shown[:, 0]/D, linestyle="none", marker="o", markersize=1.6,
              markerfacecolor="white", markeredgecolor="black", markeredgewidth=0.2)
    for side in (-0.5, 0.5):
        axes.plot([z.min(), 0], [side, side], color="black", linewidth=1.5)
    axes.set(xlabel="$z/D$", ylabel="$x/D$", aspect="equal", xlim=(z.min(), z.max()),
             ylim=(-args.radius, args.radius),
             title=f"Grains within {0.5*args.thickness:g} D of the plane $y = 0$ "
                   f"over fluid speed at {time:.3g} s")
    bar = figure.colorbar(fluid, ax=axes, label="fluid speed, m/s", shrink=0.95, pad=0.01)
    bar.set_ticks(numpy.arange(0, speed.max(), 2))
    args.output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(args.output, dpi=200)


if __name__ == "__main__":
    main()
