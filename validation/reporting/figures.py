# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counterparts of the paper's figures. Each function writes one picture."""

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

LABELS = {"Hardalupas": {"mean": "$U_p/U_{g,c}$", "rms": "rms$/U_{g,c}$", "flux": "$G/G_m$"},
          "Lau": {"mean": "$U_p/U_{g,b}$", "rms": "rms$/U_p$", "flux": "$G/G_m$"}}
MARKERS = "os^Dvp*<>hX"


def save(figure, path):
    figure.savefig(path, dpi=75)
    plt.close(figure)


def profiles(runs, planes, path, points=None, widths=None):
    """One row of panels per plane: mean, rms, flux of several runs; measured points where given."""
    rig = runs[0].settings["rig"]
    figure, grid = plt.subplots(len(planes), 3, figsize=(10.5, 2.7*len(planes)), squeeze=False,
                                constrained_layout=True)
    for plane, row in zip(planes, grid):
        for quantity, panel in zip(("mean", "rms", "flux"), row):
            for run, marker in zip(runs, MARKERS):
                r, value, error = run.normalised(plane)[quantity]
                line = panel.errorbar(r, value, yerr=error, marker=marker, markersize=4, linewidth=1,
                                      capsize=2, label=run.name)
                measured = [p for p in (points or {}).get(run.name, ())
                            if p["plane"] == plane and p["quantity"] == quantity]
                if measured:
                    panel.plot([p["r"] for p in measured], [p["value"] for p in measured], marker=marker,
                               linestyle="none", markerfacecolor="white", color=line[0].get_color(),
                               label=f"{run.name}, measured")
            panel.set(xlabel="$r/D$", ylabel=LABELS[rig][quantity], title=f"$z/D$ = {plane:g}")
            panel.set_ylim(bottom=0)
            panel.grid(alpha=0.3)
        row[0].legend(fontsize=8)
    save(figure, path)


def development(run, planes, path):
    """Profiles of one run along the pipe or the jet."""
    figure, panels = plt.subplots(1, 3, figsize=(10.5, 3.2), constrained_layout=True)
    colours = plt.get_cmap("viridis")(numpy.linspace(0, 0.9, len(planes)))
    for plane, colour in zip(planes, colours):
        for quantity, panel in zip(("mean", "rms", "flux"), panels):
            r, value, error = run.normalised(plane)[quantity]
            panel.errorbar(r, value, yerr=error, color=colour, linewidth=1, marker=".",
                           label=f"{plane:g}D")
            panel.set(xlabel="$r/D$", ylabel=LABELS[run.settings["rig"]][quantity])
            panel.grid(alpha=0.3)
    panels[0].set_title(run.name, fontsize=10)
    panels[2].legend(fontsize=7, ncol=2)
    save(figure, path)


def rings(rows, path):
    """Figure 9: percent error by ring (a), and the frequencies behind it (b). Rows are (r/D,
    {statistic: error}, {run: frequency})."""
    figure, (errors, counts) = plt.subplots(1, 2, figsize=(9.5, 3.3), constrained_layout=True)
    r = [row[0] for row in rows]
    for (name, marker) in zip(rows[0][1], MARKERS):
        errors.plot(r, [row[1][name] for row in rows], marker=marker, markersize=4, label=name)
    errors.set(xlabel="$r/D$", ylabel="error of the ratio, %", title="(a)")
    errors.set_ylim(0, min(errors.get_ylim()[1], 150))
    errors.legend(fontsize=7)
    for name, marker in zip(rows[0][2], MARKERS):
        counts.semilogy(r, [row[2][name] for row in rows], marker=marker, markersize=4, label=name)
    counts.set(xlabel="$r/D$", ylabel="hits per second, particles", title="(b)")
    counts.legend(fontsize=7)
    for panel in (errors, counts):
        panel.grid(alpha=0.3)
    save(figure, path)


def sweep(entries, path):
    """Error against f_cg, with what noise alone gives, and the run time. Entries are dicts."""
    figure, (errors, times) = plt.subplots(1, 2, figsize=(9.5, 3.3), constrained_layout=True)
    f = [e["cg"] for e in entries]
    for quantity, marker in zip(("mean", "rms", "flux"), MARKERS):
        with_error = [e for e in entries if e["cg"] != 1]
        line, = errors.plot([e["cg"] for e in with_error], [100*e["apart"][quantity] for e in with_error],
                            marker=marker, label=quantity)
        errors.plot([e["cg"] for e in with_error], [100*e["noise"][quantity] for e in with_error],
                    linestyle=":", color=line.get_color())
    errors.set(xlabel="$f_{cg}$", ylabel="rms difference from $f_{cg}$ = 1, %",
               title="dotted: what noise alone gives")
    errors.set_ylim(bottom=0)
    errors.legend(fontsize=8)
    times.semilogy(f, [e["perSecond"] for e in entries], marker="o", label="whole run")
    times.semilogy(f, [e["grainsPerSecond"] for e in entries], marker="s", label="grains and coupling")
    times.set(xlabel="$f_{cg}$", ylabel="seconds per simulated second", xticks=f)
    times.legend(fontsize=8)
    for panel in (errors, times):
        panel.grid(alpha=0.3)
    save(figure, path)
