#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of what a surface suffers: a map of one quantity of fix surface/stats, in parallel projection, and spectra.

    surface.py plate.vtp [--field wear_depth] [--look 0 0 -1] [--up 0 1 0] [--spectra spectra.csv] [--output surface.png]
    surface.py plate.vtp --average 2e-3        each value is the mean over the triangles within 2 mm of its own
    surface.py plate.vtp --list                names and ranges of the quantities

Prints where the shown quantity is largest. Triangles of any surface with values per triangle will do, in .vtp or .vtk.
"""

import argparse
import csv
import pathlib
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.collections
import matplotlib.colors
import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy
import scipy.spatial

from grainjet import surfaces

UNITS = {"wear_depth": "m", "wear_volume": "m$^3$", "impact_mass": "kg", "mass_flux": "kg/(m$^2$ s)",
         "particle_flux": "1/(m$^2$ s)", "impact_speed_mean": "m/s", "impact_speed_rms": "m/s",
         "impact_angle_mean": "degrees from the normal", "impact_angle_rms": "degrees from the normal",
         "kinetic_energy_normal": "J", "kinetic_energy_tangential": "J", "energy_loss": "J",
         "normal_force_peak": "N", "tangential_force_peak": "N", "sliding_work": "J", "area": "m$^2$"}


def unit(vector):
    vector = numpy.asarray(vector, dtype=float)
    size = numpy.linalg.norm(vector)
    if not size > 0:
        raise ValueError("a direction must not be 0 0 0")
    return vector/size


def projection(look, up):
    """(to the right, upwards, towards the eye): unit vectors of a picture seen along `look`."""
    towards = -unit(look)
    right = numpy.cross(up, towards)
    if numpy.linalg.norm(right) < 1e-9:
        raise ValueError("--up must not lie along --look")
    right = unit(right)
    return right, numpy.cross(towards, right), towards


def draw_map(axes, surface, values, look=(0, 0, -1), up=(0, 1, 0), length=1.0, norm=None, cmap="inferno", background="0.85"):
    """Draw the triangles, far ones first, so that near ones cover them. Values that are not finite
    or not above 0 on a logarithmic scale are drawn in the colour of the background. Lengths are divided by `length`."""
    right, upwards, towards = projection(look, up)
    order = numpy.argsort(surface.centres() @ towards)
    corners = surface.corners()[order]/length
    flat = numpy.stack([corners @ right, corners @ upwards], axis=2)
    shown = numpy.ma.masked_invalid(values[order])
    if isinstance(norm, matplotlib.colors.LogNorm):
        shown = numpy.ma.masked_less_equal(shown, 0)
    colours = plt.get_cmap(cmap).copy()
    colours.set_bad(background)
    drawn = matplotlib.collections.PolyCollection(flat, array=shown, cmap=colours, norm=norm, edgecolors="none", antialiased=False)
    axes.add_collection(drawn)
    axes.set_aspect("equal")
    axes.set_xlim(flat[..., 0].min(), flat[..., 0].max())
    axes.set_ylim(flat[..., 1].min(), flat[..., 1].max())
    return drawn


def axis_name(direction):
    """What an axis of the picture shows: a coordinate, or the direction in which it points."""
    for name, component in zip("xyz", direction):
        if abs(component) > 1 - 1e-9:
            return name if component > 0 else f"-{name}"
    return "along ({:.2g} {:.2g} {:.2g})".format(*(numpy.round(direction, 9) + 0.0))


def averaged(surface, values, radius):
    """Means over the triangles whose centres lie within a radius [m] of each one's, weighted by area; without those that have no
    value. For quantities per area and means: the noise of few hits on small triangles goes, what is wider than the radius stays."""
    if not radius > 0:
        raise ValueError("--average must be above 0")
    centres, areas = surface.centres(), surface.areas()
    weight = numpy.where(numpy.isfinite(values), areas, 0)
    weighted = numpy.where(weight > 0, values, 0)*weight
    near = scipy.spatial.cKDTree(centres).query_ball_point(centres, radius)
    with numpy.errstate(invalid="ignore"):
        return numpy.array([weighted[i].sum() for i in near])/numpy.array([weight[i].sum() for i in near])


def largest(surface, values):
    """(value, centre of its triangle) of the largest one."""
    if not numpy.isfinite(values).any():
        raise ValueError("no triangle has a value")
    i = numpy.nanargmax(numpy.where(numpy.isfinite(values), values, numpy.nan))
    return values[i], surface.centres()[i]


def read_spectra(path):
    """{quantity: rows of (low, high, particles, density)} with finite bins."""
    found = {}
    with open(path, newline="") as file:
        reader = csv.DictReader(file)
        if not {"quantity", "low", "high", "particles", "density"} <= set(reader.fieldnames or ()):
            raise ValueError(f"{path} is no table of spectra of fix surface/stats")
        for row in reader:
            low, high, particles, density = (float(row[name]) for name in ("low", "high", "particles", "density"))
            if numpy.isfinite(low) and numpy.isfinite(high):
                found.setdefault(row["quantity"], []).append((low, high, particles, density))
    return {name: numpy.array(rows) for name, rows in found.items()}


SPECTRA = {"impact_speed": "speed, m/s", "impact_angle": "angle from the normal, degrees", "kinetic_energy": "kinetic energy of a particle, J",
           "energy_loss": "energy loss of a particle, J"}


def draw_spectrum(axes, rows, name):
    """Share of the particles by bin; logarithmic bins on a logarithmic axis."""
    low, high, particles, _ = rows.T
    share = particles/max(particles.sum(), 1)
    logarithmic = low[0] > 0
    width = numpy.log10(high/low) if logarithmic else high - low
    axes.stairs(share/width, numpy.append(low, high[-1]), fill=True, alpha=0.6)
    if logarithmic:
        axes.set_xscale("log")
        seen = numpy.flatnonzero(particles)
        if len(seen):
            axes.set_xlim(low[seen[0]], high[seen[-1]])
        # within a decade or two the axis has no number but at minor ticks
        axes.xaxis.set_minor_formatter(matplotlib.ticker.LogFormatterSciNotation(minor_thresholds=(2, 0.5)))
    axes.set(xlabel=SPECTRA.get(name, name), ylabel="share per decade" if logarithmic else "share per degree", ylim=(0, None))
    axes.grid(alpha=0.3)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("surface", type=pathlib.Path)
    parser.add_argument("--field", default="wear_depth")
    parser.add_argument("--look", type=float, nargs=3, default=(0, 0, -1), help="direction in which one looks")
    parser.add_argument("--up", type=float, nargs=3, default=(0, 1, 0), help="direction that is upwards in the picture")
    parser.add_argument("--length", type=float, default=1e-3, help="unit of length of the axes, m")
    parser.add_argument("--average", type=float, help="radius, m, over which values are averaged")
    parser.add_argument("--log", action="store_true", help="logarithmic colours")
    parser.add_argument("--range", type=float, nargs=2, help="of the colours")
    parser.add_argument("--spectra", type=pathlib.Path, help="CSV file of spectra of the same fix")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("surface.png"))
    args = parser.parse_args()

    try:
        surface = surfaces.Surface(args.surface)
        if args.list:
            for name, values in surface.values.items():
                finite = values[numpy.isfinite(values)]
                print(f"{name:28s} {finite.min() if finite.size else numpy.nan:12.4g} {finite.max() if finite.size else numpy.nan:12.4g}")
            return 0
        if args.field not in surface.values:
            raise ValueError(f"{args.surface} has no quantity {args.field}; it has {', '.join(surface.values)}")
        values = surface.values[args.field]
        if args.average is not None:
            values = averaged(surface, values, args.average)
        top, place = largest(surface, values)
        spectra = {name: rows for name, rows in (read_spectra(args.spectra) if args.spectra else {}).items() if name in SPECTRA}
        norm = (matplotlib.colors.LogNorm if args.log else matplotlib.colors.Normalize)(*(args.range or (None, None)))
        columns = (len(spectra) + 1)//2
        # a narrow surface has a narrow map
        right, upwards, _ = projection(args.look, args.up)
        width = 1.8 + 4.2*min(numpy.ptp(surface.points @ right)/max(numpy.ptp(surface.points @ upwards), 1e-30), 1)
        figure = plt.figure(figsize=(width + 3.6*columns, 4.8), constrained_layout=True)
        grid = figure.add_gridspec(2, columns + 1, width_ratios=[width] + [3.6]*columns)
        axes = figure.add_subplot(grid[:, 0])
        drawn = draw_map(axes, surface, values, args.look, args.up, args.length, norm)
    except (ValueError, OSError) as error:
        return f"surface.py: {error}"
    unit_text = UNITS.get(args.field)
    plain = f" {unit_text.replace('$', '')}" if unit_text else ""
    print(f"largest {args.field}: {top:.4g}{plain} at ({place[0]:.5g} {place[1]:.5g} {place[2]:.5g}) m")
    figure.colorbar(drawn, ax=axes, label=args.field.replace("_", " ") + (f", {unit_text}" if unit_text else ""), shrink=0.8)
    lengths = {1e-3: "mm", 1.0: "m"}.get(args.length, f"{args.length:g} m")
    axes.set(xlabel=f"{axis_name(right)}, {lengths}", ylabel=f"{axis_name(upwards)}, {lengths}")
    figure.suptitle(args.field.replace("_", " ") + (f", mean within {args.average/args.length:g} {lengths}" if args.average else "")
                    + f"\n{args.surface.name}" + (f" at {surface.time:.6g} s" if surface.time is not None else ""), fontsize="medium")
    for i, (name, rows) in enumerate(spectra.items()):
        draw_spectrum(figure.add_subplot(grid[i % 2, 1 + i//2]), rows, name)
    args.output.parent.mkdir(parents=True, exist_ok=True)
    # constrained_layout alone cuts labels of narrow pictures
    figure.savefig(args.output, dpi=150, bbox_inches="tight")
    print(f"written: {args.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
