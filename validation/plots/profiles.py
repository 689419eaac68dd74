#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Radial profiles of a particleSamplingPlanes object, with error bars of one standard error.

    profiles.py postProcessing/profiles [--output profiles.png]
"""

import argparse
import itertools
import pathlib

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

from grainjet import tables

# Rings with fewer crossings say nothing about a mean or a deviation
ENOUGH = 5
MARKERS = "os^Dvp*"


def draw(axes, table, **style):
    """One plane into the panels mean, rms, number flux."""
    good = table["crossings"] >= ENOUGH
    r, n = table["r/D"], table["crossings"]
    mean, rms, flux = axes
    mean.errorbar(r[good], table["flux_weighted_mean_axial"][good],
                  yerr=table["stderr_flux_weighted_mean_axial"][good], **style)
    # standard error of a standard deviation of n normal values: s/sqrt(2 (n - 1))
    for name, fill in (("axial", True), ("radial", False)):
        s = table[f"flux_weighted_rms_{name}"][good]
        rms.errorbar(r[good], s, yerr=s/numpy.sqrt(2*(n[good] - 1)),
                     **{**style, "label": f"{style['label']}, {name}"},
                     **({} if fill else {"markerfacecolor": "white", "linestyle": "--"}))
    seen = n > 0
    flux.errorbar(r[seen], 1e-9*table["number_flux"][seen],
                  yerr=1e-9*table["stderr_number_flux"][seen], **style)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path, help="of the function object")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("profiles.png"))
    parser.add_argument("--dpi", type=int, default=200)
    args = parser.parse_args()

    planes = tables.planes(args.folder)
    figure, axes = plt.subplots(1, 3, figsize=(13, 4.2), constrained_layout=True)
    figure.suptitle("Particles, error bars: one standard error", fontsize=10)
    colours = plt.get_cmap("viridis")(numpy.linspace(0, 0.75, len(planes)))
    widest = 0
    for (position, path), colour, marker in zip(planes.items(), colours, itertools.cycle(MARKERS)):
        table = tables.read(path)
        draw(axes, table, label=f"$z/D$ = {position:g}", color=colour, marker=marker,
             markersize=4, linewidth=1, capsize=2)
        widest = max(widest, table["r_outer/D"][table["crossings"] >= ENOUGH].max(initial=0.5))
    labels = ("mean axial velocity, m/s", "rms velocity, m/s", "number flux, $10^9$ particles/(m$^2$ s)")
    for panel, label, letter in zip(axes, labels, "abc"):
        panel.set(xlabel="$r/D$", ylabel=label, xlim=(0, widest))
        panel.set_title(f"({letter})", loc="left")
        panel.set_ylim(0, 1.25*panel.get_ylim()[1])    # room for the legend
        panel.grid(alpha=0.3)
        panel.legend(fontsize=8, loc="upper right", ncol=2 if letter == "b" else 1)
    args.output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(args.output, dpi=args.dpi)


if __name__ == "__main__":
    main()
