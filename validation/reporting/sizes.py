# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of larger sizes beside those of the document's: what the finer mesh changes, and what it cost beside the
estimate of cost.py."""

import copy

import cost
import figures
import results as results_
from sections import head, row

PARTS = (("fluid", "secondsFluid"), ("DEM", "secondsDEM"), ("coupling", "secondsCoupling"))


def pairs(results):
    """[(case, [its runs, of the document's size first])] of the cases of which a larger size is in hand."""
    found = []
    for name in results.table.cases:
        larger = [runs[name] for runs in results.larger.values() if name in runs]
        # the same mesh with the grains of the larger size, if that was run
        between = [run for run in results.study("sizes").values() if run and run.settings["case"] == name]
        if larger and name in results.runs:
            found.append((name, [results.runs[name], *between, *larger]))
    return found


def report(results, pictures):
    lines = ["## Larger sizes", ""]
    for name, runs in pairs(results):
        lines += [*profiles(name, runs, pictures), *apart(runs)]
    if len(lines) == 2:
        lines += [f"Not run; `cases/Allrun Hardalupas1 {next(iter(results.larger), results.size)}` does it.", ""]
    return lines


def title(run):
    return f"{run.name}, {run.summary['size']}"


def profiles(name, runs, pictures):
    planes = runs[0].settings["planes"]
    lines = [head("run", "cells", "f_cg", "y+", "checks that hold", "fluid without grains on the axis at the exit, m/s",
                  *(f"axis at {plane:g}D, m/s" for plane in planes), *(f"rms at {plane:g}D, m/s" for plane in planes),
                  "crossings (grains) of the last plane")]
    named = []
    for run in runs:
        s = run.summary
        held = sum(check["holds"] for check in s["checks"])
        lines.append(row(title(run), f"{s['mesh']['cells']:,}", f"{run.settings['cg']:g}", f"{s['mesh']['yPlusAverage']:.0f}",
                         f"{held} of {len(s['checks'])}", f"{s['fluidAxisSpeed']:.2f}",
                         *(f"{p['axisMean']:.2f} +- {p['axisMeanError']:.2f}" for p in s["planes"]),
                         *(f"{p['axisRms']:.2f}" for p in s["planes"]), f"{s['planes'][-1]['crossings']:,.0f}"))
        named.append(copy.copy(run))
        named[-1].name = title(run)
    figures.profiles(named, planes, pictures/f"sizes-{name}.png")
    return [*lines, "", f"![Profiles of {name} on meshes of several sizes](figures/sizes-{name}.png)", ""]


def apart(runs):
    """How far each is from the largest."""
    largest = runs[-1]
    lines = [head("run", "plane", *(f"{q}: difference, %" for q in results_.QUANTITIES), *(f"{q}: noise, %" for q in results_.QUANTITIES))]
    for run in runs[:-1]:
        for plane in largest.settings["planes"]:
            difference, noise = results_.difference(run, largest, plane)
            lines.append(row(title(run), f"{plane:g}D", *(f"{100*difference[q]:.1f}" for q in results_.QUANTITIES),
                             *(f"{100*noise[q]:.1f}" for q in results_.QUANTITIES)))
    return [*lines, "", f"Root mean square over the rings of the difference from `{title(largest)}`, of mean and rms velocity over Ugc of each run and "
            "flux over Gm; noise: what the standard errors of both alone would give.", ""]


def spent(results, unit, stay):
    """The processor time of the runs of larger sizes beside the estimate."""
    runs = [run for of_size in results.larger.values() for run in of_size.values()]
    if not runs:
        return []
    lines = [head("run", "ranks", "core hours: fluid, estimated", "measured", "DEM, estimated", "measured", "coupling, estimated", "measured",
                  "all, estimated", "measured", "us per cell and fluid step", "wall time, h")]
    for run in runs:
        s, e = run.summary["cost"], cost.estimate(run.settings, unit, stay)
        # processorSeconds is that of the first rank
        whole = s["processorSeconds"]*run.settings["ranks"]/3600
        timed = sum(s[key] for _, key in PARTS)
        cells = [cell for part, key in PARTS for cell in (f"{e[part]:.2f}", f"{whole*s[key]/timed:.2f}")]
        fluid = 3600e6*whole*s["secondsFluid"]/timed/(run.summary["mesh"]["cells"]*run.summary["fluidSteps"])
        lines.append(row(title(run), run.settings["ranks"], *cells, f"{e['hours']:.2f}", f"{whole:.2f}", f"{fluid:.2f}", f"{s['wallSeconds']/3600:.2f}"))
    return ["Of these were run, coupled run only:", "", *lines, ""]
