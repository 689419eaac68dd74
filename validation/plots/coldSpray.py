#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of the cold spray case: Mach number with grains, jet and shocks before the plate, gas on the axis, speed against size,
deposit.

    coldSpray.py <case> [--output coldSpray.png]
"""

import argparse
import pathlib
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[2]/"cases"/"coldSpray"))
import spray

SIZES = 1e-6*numpy.array([3, 5, 7, 10, 14, 20, 28, 38, 50])


def draw(panel, s, x, r, clip):
    """Mach number in a window, mirrored at the axis, with the grains in it."""
    X, Y = numpy.meshgrid(numpy.linspace(*x, 900), numpy.linspace(1e-6, r, 220))
    M = s.gas.at(X, Y)["M"].reshape(X.shape) if X.size else X
    drawn = None
    for sign in (1, -1):
        drawn = panel.pcolormesh(1e3*X, sign*1e3*Y, numpy.ma.masked_invalid(M), vmin=0, vmax=clip, cmap="viridis", shading="auto", rasterized=True)
    time = max(way[-1, 0] for way in s.ways.values())
    here = numpy.array([way[-1] for way in s.ways.values() if way[-1, 0] == time])
    inside = (here[:, 2] > x[0]) & (here[:, 2] < x[1]) & (here[:, 3] < r)
    # each grain stands for a ring: drawn on either side
    side = numpy.where(numpy.arange(inside.sum()) % 2, 1, -1)
    panel.scatter(1e3*here[inside, 2], side*1e3*here[inside, 3], s=(here[inside, 1]/20e-6)**2*6, c="white", edgecolors="black", linewidths=0.3)
    panel.set(xlabel="x, mm", ylabel="r, mm", xlim=(1e3*x[0], 1e3*x[1]), ylim=(-1e3*r, 1e3*r))
    return drawn


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("case", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("coldSpray.png"))
    args = parser.parse_args()
    s = spray.Spray(args.case)
    n, p = s.n, s.p

    figure = plt.figure(figsize=(13, 8.6), constrained_layout=True)
    grid = figure.add_gridspec(3, 3, height_ratios=(0.75, 1.0, 1.15))
    whole, jet = figure.add_subplot(grid[0, :]), figure.add_subplot(grid[1, :])
    axis, size, deposit = (figure.add_subplot(grid[2, i]) for i in range(3))
    draw(whole, s, (n.begin, n.plate), 1.6*n.exit, 3.3)
    whole.set_title("Mach number and grains (area as d$^2$)")
    drawn = draw(jet, s, (n.end - 0.02, n.plate), 2.2*n.exit, 3.3)
    jet.set_aspect("equal")
    figure.colorbar(drawn, ax=[whole, jet], label="Mach number", shrink=0.8)

    x = numpy.linspace(p["insertionPlace"], n.plate - 1e-6, 1500)
    gas = s.gas.at(x, 1e-6)
    axis.plot(1e3*x, gas["U"], color="#1f5f9f", label="gas on the axis")
    inside = x < n.end
    axis.plot(1e3*x[inside], [n.at(a)["U"] for a in x[inside]], ":", color="#1f5f9f", label="theory, isentropic")
    for d, colour in ((5e-6, "#d95f02"), (p["dParticle"], "#1b9e77"), (50e-6, "#7570b3")):
        way = s.flight(d)
        axis.plot(1e3*way[0], way[1], color=colour, label=f"{1e6*d:g} um")
    axis.set(xlabel="x, mm", ylabel="speed, m/s", ylim=(0, None))
    axis.legend(fontsize=7)

    exits, ends = [], []
    for d in SIZES:
        way = s.flight(d)
        i = numpy.argmax(way[0] >= n.end)
        exits.append(way[1][i])
        ends.append(way[1][-1])
    size.plot(1e6*SIZES, exits, color="#1f5f9f", label="exit: one sphere on the axis")
    size.plot(1e6*SIZES, ends, color="#d95f02", label="plate: one sphere on the axis")
    sizes = sorted(p["diameters"])
    size.plot(1e6*numpy.array(sizes), [s.passing(n.end, d)[0].mean() for d in sizes], "o", color="#1f5f9f", label="exit: grains, mean")
    h = s.hits
    hit = [h["speed_before"][abs(h["d"]/d - 1) < 1e-6] for d in sizes]
    size.errorbar(1e6*numpy.array(sizes), [v.mean() if len(v) else numpy.nan for v in hit], [v.std() if len(v) else 0 for v in hit], fmt="s", color="#d95f02",
                  capsize=2, label="plate: first hits, mean and deviation")
    for k, (name, style) in enumerate((("Assadi 2003", "-"), ("Schmidt 2006", "--"))):
        T = [h["temperature"][abs(h["d"]/d - 1) < 1e-6].mean() for d in sizes]
        size.plot(1e6*numpy.array(sizes), [s.critical(t)[k] for t in T], style, color="black", linewidth=0.9, label=f"critical, {name}")
    size.set(xlabel="diameter, um", ylabel="speed, m/s")
    size.legend(fontsize=7)

    edges = numpy.linspace(0, 0.4, 17)*n.exit
    here = abs(h["d"]/p["dParticle"] - 1) < 1e-6
    mass, _ = numpy.histogram(h["r"][here], edges, weights=h["mass"][here])
    above = here & (h["speed_before"] > s.critical(h["temperature"])[1])
    stuck, _ = numpy.histogram(h["r"][above], edges, weights=h["mass"][above])
    area = numpy.pi*numpy.diff(edges**2)*max(mass.sum(), 1e-300)
    deposit.stairs(1e-6*mass/area, edges/n.exit, label="all hits", color="#1f5f9f")
    deposit.stairs(1e-6*stuck/area, edges/n.exit, label="above critical (Schmidt)", color="#d95f02", fill=True, alpha=0.5)
    deposit.set(xlabel="r over the radius of the exit", ylabel="1/mm$^2$, share of the sprayed mass", title=f"deposit of the {1e6*p['dParticle']:g} um")
    deposit.legend(fontsize=7)
    for panel in (axis, size, deposit):
        panel.grid(alpha=0.3)
    args.output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(args.output, dpi=85)


if __name__ == "__main__":
    main()
