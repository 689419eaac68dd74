# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of the hits of a plate, with statistical errors, from the events of fix plate/stats."""

import math

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy
import scipy.stats

FORCES = ("normal_force_peak", "tangential_force_peak", "normal_force", "tangential_force")
RESAMPLES = 400
BATCHES = 20


def moments(values):
    """Mean, variance (n - 1), skewness; nan where there are too few values."""
    n = values.shape[-1]
    mean = values.mean(axis=-1) if n else numpy.nan
    variance = values.var(axis=-1, ddof=1) if n > 1 else numpy.nan
    skewness = scipy.stats.skew(values, axis=-1) if n > 2 else numpy.nan
    return mean, variance, skewness


def region(hits, p):
    """One region of the plate. Errors are one standard error: of the frequency from the counts in
    equal parts of the time, of moments by bootstrap over the collisions."""
    time = p["endTime"] - p["sampleStart"]
    n = len(hits)
    counts, _ = numpy.histogram(hits["time"], bins=BATCHES, range=(p["sampleStart"], p["endTime"]))
    half = BATCHES//2
    found = {"collisions": n, "time": time, "particle_frequency": n*p["cg"]**3/time,
             "particle_frequency_halves": [float(part.sum())*p["cg"]**3/(0.5*time)
                                           for part in (counts[:half], counts[half:])],
             "frequency_relative_error": (counts.std(ddof=1)/math.sqrt(BATCHES)/counts.mean() if n
                                          else math.nan)}
    random = numpy.random.default_rng(1)
    for force in FORCES:
        values = hits[force]
        entry = dict(zip(("mean", "variance", "skewness"), map(float, moments(values))))
        if n > 10:
            again = numpy.array([moments(values[random.integers(0, n, n)]) for _ in range(RESAMPLES)])
            for name, error in zip(("mean", "variance", "skewness"), again.std(axis=0)):
                entry[f"{name}_relative_error"] = float(error/abs(entry[name]))
        found[force] = entry
    return found


def read(path, p):
    """The collisions that began while profiles were sampled."""
    hits = numpy.atleast_1d(numpy.genfromtxt(path, delimiter=",", names=True))
    return hits[(hits["time"] >= p["sampleStart"]) & (hits["time"] <= p["endTime"])]


def statistics(path, p):
    """{region: statistics} of the whole plate and its rings."""
    hits = read(path, p)
    radius = numpy.hypot(hits["x"], hits["y"])/p["D"]
    width = p["plateRadius"]/p["plateRings"]
    found = {"all": region(hits, p)}
    for i in range(int(p["plateRings"])):
        inside = (radius >= i*width) & (radius < (i + 1)*width)
        found[f"ring{i + 1}"] = {"r_in/D": i*width, "r_out/D": (i + 1)*width, **region(hits[inside], p)}
    return found


def density_plot(path, p, output):
    """Figure 10: Gaussian kernel density estimate of the places of impact."""
    hits = read(path, p)
    if len(hits) < 10:
        return
    kept = hits if len(hits) <= 5000 else numpy.random.default_rng(1).choice(hits, 5000, replace=False)
    points = numpy.vstack([kept["x"], kept["y"]])/p["D"]
    R = p["plateRadius"]
    axis = numpy.linspace(-R, R, 81)
    x, y = numpy.meshgrid(axis, axis)
    density = scipy.stats.gaussian_kde(points)(numpy.vstack([x.ravel(), y.ravel()])).reshape(x.shape)
    figure, axes = plt.subplots(figsize=(3.6, 3.1), constrained_layout=True)
    filled = axes.contourf(x, y, density, levels=12, cmap="viridis")
    axes.add_patch(plt.Circle((0, 0), R, fill=False, color="white", linewidth=1))
    axes.set(xlabel="$x/D$", ylabel="$y/D$", aspect="equal",
             title=f"plate at {p['jetLength']:g}D, $f_{{cg}}$ = {p['cg']:g}, {len(hits)} hits")
    axes.title.set_fontsize(9)
    figure.colorbar(filled, ax=axes, label="density, $D^{-2}$")
    figure.savefig(output, dpi=90)
    plt.close(figure)
