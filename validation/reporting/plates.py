# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 7: ratios of what hits a plate at 5D and at 15D, at two coarse-graining factors."""

import math

STATISTICS = ("mean", "variance", "skewness")
# which force a collision is counted with
PEAK = ("normal_force_peak", "tangential_force_peak")
AVERAGE = ("normal_force", "tangential_force")
NAMES = ("frequency", "Fn mean", "Fn variance", "Fn skewness", "Ft mean", "Ft variance", "Ft skewness")


def columns(region, forces):
    """[(value, relative standard error)] in the order of NAMES."""
    found = [(region["particle_frequency"], region["frequency_relative_error"])]
    for force in forces:
        for statistic in STATISTICS:
            entry = region[force]
            found.append((entry[statistic], entry.get(f"{statistic}_relative_error", math.nan)))
    return found


def ratios(near, far, forces, region="all"):
    """[(ratio 5D/15D, its standard error)]"""
    found = []
    for (a, da), (b, db) in zip(columns(near.plate[region], forces), columns(far.plate[region], forces)):
        ratio = a/b if b else math.nan
        found.append((ratio, abs(ratio)*math.hypot(da, db)))
    return found


def inverse(found):
    """15D/5D of the same."""
    return [(1/a, da/a**2) if a else (math.nan, math.nan) for a, da in found]


def errors(fine, coarse):
    """Eq. (28) with its standard error: [(percent, percent)]"""
    return [(100*abs(a - b)/abs(a), 100*math.hypot(da, db)/abs(a))
            for (a, da), (b, db) in zip(fine, coarse)]
