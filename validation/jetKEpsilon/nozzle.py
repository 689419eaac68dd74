#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Near field of a jet from a long pipe, gas alone: standard against modified coefficients, and with co-flow.

    nozzle.py <work folder> [--iterations 3000]

The comparison of section 4.3 of Weaver & Miskovic (2023): the gas of case Lau3, Re 40,000. The flow in the pipe is that of
pipe.py, with the same model. Co-flow: 5 % of the bulk velocity (the paper does not state its value). Writes
results/nozzle_axis.csv, results/nozzle_profiles.csv and results/nozzle.png; the unit is diameter and bulk velocity.
"""

import argparse
import csv
import pathlib

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import foam_case as foam
from grainjet import dictionaries
import pipe
from round_jet import half_radius

RE = 40000
PIPE, LENGTH = 2, 40                         # D, upstream and downstream of the exit
CELLS = (30, 120), (22, 30)                  # along pipe and jet; across the nozzle and the air around it
RUNS = (("standard", 0.0), ("modified", 0.0), ("modified", 0.05))
STATIONS = (0.2, 10)


def write(case, model, coflow, inflow):
    foam.write_system(case, model, 1/RE)
    (n_pipe, n_jet), (n_in, n_out) = CELLS
    points, (p, a, b) = foam.wedge_points([(-PIPE, [0.5]), (0, [0.5, 30]), (LENGTH, [4, 30])])
    sides = [foam.side_faces(p, a, 0), foam.side_faces(a, b, 0), foam.side_faces(a, b, 1)]
    foam.write_mesh(case, points,
                    [foam.block(p, a, 0, (n_pipe, n_in), 0.5, (1, 1)), foam.block(a, b, 0, (n_jet, n_in), 15, (1, 1)),
                     foam.block(a, b, 1, (n_jet, n_out), 15, (200, 30))],
                    {"inlet": ("type patch;", [foam.radial_face(p, 0)]), "wall": ("type wall;", [foam.axial_face(p, a, 1)]),
                     "base": ("type patch;", [foam.radial_face(a, 1)]), "side": ("type patch;", [foam.axial_face(a, b, 2)]),
                     "outlet": ("type patch;", [foam.radial_face(b, 0), foam.radial_face(b, 1)]),
                     "back": ("type wedge;", [s[0] for s in sides]), "front": ("type wedge;", [s[1] for s in sides]),
                     "axis": ("type empty;", [foam.axial_face(p, a, 0), foam.axial_face(a, b, 0)])})
    wedges = {"back|front": "type wedge;", "axis": "type empty;"}

    def values(name):
        return " ".join(f"({v!r} 0 0)" if name == "U" else repr(float(v)) for v in inflow[name])

    outside = f"uniform ({coflow} 0 0)"
    entrained = f"type pressureInletOutletVelocity; tangentialVelocity {outside}; value {outside};"
    dictionaries.write_field(case, "U", "[0 1 -1 0 0 0 0]", f"uniform ({max(coflow, 0.01)} 0 0)", {
        "inlet": f"type fixedValue; value nonuniform List<vector> {n_in} ({values('U')});", "wall": "type noSlip;",
        "base": f"type fixedValue; value {outside};" if coflow else entrained, "side": entrained,
        "outlet": "type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0);", **wedges})
    total = f"type totalPressure; p0 uniform {0.5*coflow**2!r}; value uniform 0;"
    dictionaries.write_field(case, "p", "[0 2 -2 0 0 0 0]", "uniform 0", {
        "inlet|wall": "type zeroGradient;", "base": "type zeroGradient;" if coflow else total, "side": total,
        "outlet": "type fixedValue; value uniform 0;", **wedges})
    for name, dimensions, air, wall in (("k", "[0 2 -2 0 0 0 0]", "uniform 1e-6", "type zeroGradient;"),
                                        ("epsilon", "[0 2 -3 0 0 0 0]", "uniform 1e-8", "type epsilonWallFunction; value uniform 1e-3;")):
        dictionaries.write_field(case, name, dimensions, air, {
            "inlet": f"type fixedValue; value nonuniform List<scalar> {n_in} ({values(name)});", "wall": wall,
            "base|side|outlet": f"type inletOutlet; inletValue {air}; value {air};", **wedges})
    dictionaries.write_field(case, "nut", "[0 2 -1 0 0 0 0]", "uniform 1e-5", {
        "wall": "type nutUSpaldingWallFunction; value uniform 0;", "inlet|base|side|outlet": "type calculated; value uniform 1e-5;", **wedges})


def jet(case):
    """The cells downstream of the exit, (along, across)."""
    (n_pipe, n_jet), (n_in, n_out) = CELLS
    return foam.structured(case, (n_in, n_out), n_jet, skip=n_pipe*n_in)


def at(flow, x):
    """Profiles at a distance from the exit, between the two neighbouring columns of cells."""
    columns = flow["x"][:, 0]
    i = numpy.searchsorted(columns, x)
    w = (x - columns[i - 1])/(columns[i] - columns[i - 1])
    return {name: (1 - w)*values[i - 1] + w*values[i] for name, values in flow.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--iterations", type=int, default=3000)
    args = parser.parse_args()

    flows = {}
    for model, coflow in RUNS:
        name = model + (f", co-flow {100*coflow:g} %" if coflow else "")
        case = args.work/f"nozzle_{model}_{coflow}"
        if not (case/"0").is_dir():
            write(case, model, coflow, pipe.solve(args.work, model, RE, CELLS[1][0]))
            foam.solve(case, args.iterations)
        flows[name] = jet(case)

    results = pathlib.Path(__file__).parent/"results"
    with (results/"nozzle_axis.csv").open("w", newline="") as output:
        table = csv.writer(output)
        table.writerow(("case", *(f"Uc at {x}D" for x in (0.2, 2, 5, 10, 15, 20, 30)), "half radius at 10D", "half radius at 20D"))
        for name, flow in flows.items():
            axis = [at(flow, x)["U"][0] for x in (0.2, 2, 5, 10, 15, 20, 30)]
            half = [half_radius(at(flow, x)["r"], at(flow, x)["U"]) for x in (10, 20)]
            table.writerow((name, *(f"{u:.4f}" for u in axis), *(f"{h:.4f}" for h in half)))
            print(name, *(f"{u:.4f}" for u in axis), *(f"{h:.4f}" for h in half))
    with (results/"nozzle_profiles.csv").open("w", newline="") as output:
        table = csv.writer(output)
        table.writerow(("case", "x/D", "r/D", "U", "k"))
        for name, flow in flows.items():
            for x in STATIONS:
                profile = at(flow, x)
                table.writerows((name, x, f"{r:.4f}", f"{u:.5f}", f"{k:.6f}")
                                for r, u, k in zip(profile["r"], profile["U"], profile["k"]) if r < 3)

    figure, axes = plt.subplots(1, 3, figsize=(13, 3.8), constrained_layout=True)
    for name, flow in flows.items():
        axes[0].plot(flow["x"][:, 0], flow["U"][:, 0], label=name)
        for panel, x in zip(axes[1:], STATIONS):
            profile = at(flow, x)
            line, = panel.plot(profile["r"], profile["U"], label=name)
            panel.plot(profile["r"], (2*profile["k"]/3)**0.5, "--", color=line.get_color())
    axes[0].set(xlabel="$x/D$", ylabel="$U_c/U_b$", xlim=(0, 30), title="axis")
    for panel, x in zip(axes[1:], STATIONS):
        panel.set(xlabel="$r/D$", ylabel="$U/U_b$; dashed: $\\sqrt{2k/3}/U_b$", xlim=(0, 3 if x > 1 else 0.8), title=f"$x/D$ = {x}")
    for panel in axes:
        panel.set_ylim(bottom=0)
        panel.grid(alpha=0.3)
    axes[0].legend(fontsize=8)
    figure.savefig(results/"nozzle.png", dpi=150)


if __name__ == "__main__":
    main()
