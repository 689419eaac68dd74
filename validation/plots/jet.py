#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of a jet: grains in a slice along the axis over the speed of the fluid.

    jet.py <case> --diameter 0.015 [--grains postProcessing/grains] [--output jet.png]
    jet.py <case> --diameter 0.015 --animate 0.05 --output jet.gif

An animation has a frame for each time of the grains up to the one given, over the fluid of the nearest time that has it.
"""

import argparse
import pathlib

import matplotlib
matplotlib.use("Agg")
import matplotlib.animation
import matplotlib.pyplot as plt
import numpy
from matplotlib.collections import LineCollection

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
    parser.add_argument("--animate", type=float, help="an animation (GIF) up to this time, s")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("jet.png"))
    args = parser.parse_args()

    times = fields.grain_times(args.case/args.grains)
    if args.animate is None:
        times = [fields.latest_mesh(args.case)[0]]
    else:
        times = [time for time in times if time <= args.animate*(1 + 1e-9)]
        if len(times) < 2:
            parser.error(f"no two times of grains up to {args.animate:g} s in {args.case/args.grains}: let the function object write them "
                         "more often")
    args.output.parent.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(figsize=(11, 2.95), constrained_layout=True)
    draw = Frames(args, figure, axes)
    draw(times[0])
    draw.fit()
    if args.animate is None:
        figure.savefig(args.output, dpi=200)
    else:
        frames = matplotlib.animation.FuncAnimation(figure, draw, times)
        frames.save(args.output, writer=matplotlib.animation.PillowWriter(fps=12), dpi=80)


class Frames:
    """Draws the state of a time: the fluid's speed and the grains of the slice over it."""

    def __init__(self, args, figure, axes):
        self.args, self.figure, self.axes = args, figure, axes
        self.fluid_time = None

    def fluid(self, time):
        """The fluid, drawn anew where another of its times is the nearest one."""
        found, grid = fields.mesh_at(self.args.case, time)
        if found == self.fluid_time:
            return
        points, triangles, velocity = fields.axial_slice(grid, "U")
        D, speed = self.args.diameter, numpy.linalg.norm(velocity, axis=1)
        z, x = points[:, 2]/D, points[:, 0]/D
        if self.fluid_time is not None:
            self.drawn.remove()
        self.drawn = self.axes.tripcolor(z, x, triangles, speed, shading="gouraud", cmap="viridis", vmin=0, zorder=0)
        if self.fluid_time is None:
            walls = fields.wall_lines(self.args.case, time)[:, :, [2, 0]]/D
            self.axes.add_collection(LineCollection(walls, colors="black", linewidths=1.5))
            radius = min(self.args.radius, abs(x).max())
            self.axes.set(xlabel="$z/D$", ylabel="$x/D$", aspect="equal", xlim=(z.min(), z.max()), ylim=(-radius, radius))
            bar = self.figure.colorbar(self.drawn, ax=self.axes, label="fluid speed, m/s", shrink=0.95, pad=0.01)
            bar.set_ticks(numpy.arange(0, speed.max(), 2))
            self.highest = self.drawn.get_clim()[1]
            self.grains, = self.axes.plot([], [], linestyle="none", marker="o", markersize=1.6, markerfacecolor="white",
                                          markeredgecolor="black", markeredgewidth=0.2)
        self.drawn.set_clim(0, self.highest)            # one scale for all frames
        self.fluid_time = found

    def fit(self):
        """A figure of the proportions of what is shown: 11 inches wide, but at most 7 high."""
        (left, right), (low, high) = self.axes.get_xlim(), self.axes.get_ylim()
        beside, above = 1.4, 0.9        # colour bar and labels, title and labels, in
        width = min(11, beside + (7 - above)*(right - left)/(high - low))
        self.figure.set_size_inches(width, above + (width - beside)*(high - low)/(right - left))

    def __call__(self, time):
        self.fluid(time)
        _, grains, _ = fields.grains_at(self.args.case/self.args.grains, time)
        D, half = self.args.diameter, 0.5*self.args.thickness
        shown = grains[abs(grains[:, 1]) < half*D]
        self.grains.set_data(shown[:, 2]/D, shown[:, 0]/D)
        self.axes.set_title(f"Fluid speed, and grains within {half:g} D of $y = 0$, at {time:.3g} s")


if __name__ == "__main__":
    main()
