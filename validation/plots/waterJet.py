#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of a water jet onto a plate: the surface of the water and the grains in a slice along the
axis, and where they hit the plate.

    waterJet.py <case> --diameter 0.006 [--output waterJet.png]
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
    parser.add_argument("--thickness", type=float, default=0.2,
                        help="of the slice of grains that is shown, in nozzle diameters")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("waterJet.png"))
    args = parser.parse_args()

    D = args.diameter
    time, grid = fields.latest_mesh(args.case)
    points, triangles, water = fields.axial_slice(grid, "alpha.water")
    x, z = points[:, 0]/D, points[:, 2]/D
    _, grains, of = fields.grains_at(args.case/"postProcessing"/"grains", time)
    shown = abs(grains[:, 1]) < 0.5*args.thickness*D
    speed = numpy.linalg.norm(of["U"], axis=1)
    hits = numpy.atleast_1d(numpy.genfromtxt(args.case/"postProcessing"/"plate"/"events.csv", delimiter=",", names=True))

    figure, (side, plate) = plt.subplots(1, 2, figsize=(11, 4.2), constrained_layout=True,
                                         gridspec_kw={"width_ratios": (1.15, 1)})
    side.tricontourf(x, z, triangles, water, levels=(0.5, 2), colors=("#cfe3f5",))
    side.tricontour(x, z, triangles, water, levels=(0.5,), colors=("#1f5f9f",), linewidths=0.8)
    top = max(speed.max(), hits["speed_before"].max() if len(hits) else 0)
    dots = {"cmap": "plasma", "vmin": 0, "vmax": top, "linewidths": 0}
    side.scatter(grains[shown, 0]/D, grains[shown, 2]/D, c=speed[shown], s=5, **dots)
    side.plot([x.min(), x.max()], [z.max(), z.max()], color="black", linewidth=2.5)
    side.set(xlabel="$x/D$", ylabel="$z/D$", aspect="equal", xlim=(x.min(), x.max()),
             ylim=(z.max() + 0.03, z.min()),
             title=f"water, and grains within {0.5*args.thickness:g} D of $y = 0$, at {1e3*time:.3g} ms")

    seen = plate.scatter(hits["x"]/D, hits["y"]/D, c=hits["speed_before"], s=2.5, **dots)
    plate.set(xlabel="$x/D$", ylabel="$y/D$", aspect="equal", title=f"{len(hits)} hits on the plate")
    figure.colorbar(seen, ax=plate, label="speed of grains, of hits before them, m/s")
    args.output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(args.output, dpi=170)


if __name__ == "__main__":
    main()
