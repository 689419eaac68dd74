#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of the sandblast case: wear maps of a head-on and of an inclined jet, and profiles of their scars.

    sandblast.py <folder of the runs> [--output sandblast.png]
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
sys.path[:0] = [str(HERE.parent), str(HERE.parents[2]/"cases"/"sandblast")]
import scar
import surface

STYLES = {"normal-jetKEpsilon": ("#1f5f9f", "o"), "normal-kEpsilon": ("#d95f02", "s"), "far-jetKEpsilon": ("#1b9e77", "^"),
          "inclined-jetKEpsilon": ("#1f5f9f", "o"), "inclined-kEpsilon": ("#d95f02", "s")}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("runs", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("sandblast.png"))
    args = parser.parse_args()

    found = scar.runs(args.runs)
    maps = [run for name, run in found.items() if name in ("normal-jetKEpsilon", "inclined-jetKEpsilon")] or list(found.values())[:1]
    figure, axes = plt.subplots(2, 2, figsize=(11, 8), constrained_layout=True)
    for panel in axes[0, len(maps):]:
        panel.set_axis_off()
    for panel, run in zip(axes[0], maps):
        depth = run.map.values["wear_depth"]/run.abrasive*1e6          # um/kg
        drawn = surface.draw_map(panel, run.map, depth, length=run.p["D"],
                                 norm=matplotlib.colors.Normalize(0, numpy.quantile(depth[depth > 0], 0.995) if (depth > 0).any() else 1))
        panel.set(xlabel="$x/D$", ylabel="$y/D$", title=scar.NAMES[run.name], xlim=(-3, 3), ylim=(-2, 2))
        figure.colorbar(drawn, ax=panel, label="wear depth, um per kg of quartz", shrink=0.85)

    head_on, inclined = axes[1]
    for name, run in found.items():
        colour, marker = STYLES[name]
        label = scar.NAMES[name]
        if run.scar and not run.scar.fitted():
            continue
        if run.scar:
            s, good = run.scar, run.scar.good
            head_on.errorbar(s.r[good]/s.deviation, s.depth[good]/s.top, yerr=s.error[good]/s.top, color=colour, marker=marker,
                             markersize=4, linestyle="", capsize=2, label=f"{label}: width {s.deviation:.2f} D")
        else:
            x, depth = run.along()
            inclined.plot(x, 1e6*depth/run.p["D"]**2, color=colour, marker=marker, markersize=4, linewidth=1, label=label)
    r = numpy.linspace(0, 3.2, 200)
    head_on.plot(r, numpy.exp(-0.5*r**2), color="black", linewidth=1, label="Gaussian")
    head_on.set(xlabel="$r$/width", ylabel="depth/deepest", title="scars of the head-on jets, scaled", xlim=(0, 3.2))
    inclined.set(xlabel="$x/D$", ylabel="wear depth, um/kg", title="30 degrees: along the scar, $|y| < 0.25 D$")
    for panel in (head_on, inclined):
        panel.grid(alpha=0.3)
        if panel.get_legend_handles_labels()[0]:
            panel.legend(fontsize=8)
    args.output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(args.output, dpi=130)


if __name__ == "__main__":
    main()
