#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Far field of the free round jet with jetKEpsilon: standard, modified coefficients, Pope's correction.

    round_jet.py <work folder> [--reference <folder>] [--iterations 4000] [--coarse]

Top-hat jet of Re 1e5 into still air, 100 diameters long. Writes results/round_jet.csv (spreading rate, decay
constant, turbulence on the axis, momentum as a check) and results/round_jet.png; profiles of Panchapakesan & Lumley (1993)
are drawn with them if <folder>/round_jet_single_phase/panchapakesan_lumley_1993_air_jet.csv exists.
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

LENGTH, RE = 100, 1e5            # D, U = 1, D = 1
RADII = (0.5, 45), (10, 45)      # of the blocks' outer edges at x = 0 and at the end
FIT = (50, 90)                   # x/D
NEAR = (10, 15, 20)              # x/D
MEASURED = {                     # spreading rate, decay constant, k/Uc^2 on the axis, axis velocity
    "Hussein, Capp & George 1994": (0.094, 5.8, "", *3*("",)),
    "Panchapakesan & Lumley 1993": (0.096, 6.06, 0.064, *3*("",)),
    "Bridges & Wernet 2011, Mach 0.51": ("", "", "", 0.774, 0.518, 0.383),
}


def write(case, model, cells):
    nx, nr = cells
    foam.write_system(case, model, 1/RE)
    (start, end) = [(0, RADII[0]), (LENGTH, RADII[1])]
    points, (a, b) = foam.wedge_points([start, end])
    sides = [foam.side_faces(a, b, i) for i in (0, 1)]
    foam.write_mesh(case, points,
                    [foam.block(a, b, 0, (nx, nr[0]), 25, (1, 1)), foam.block(a, b, 1, (nx, nr[1]), 25, (300, 15))],
                    {"inlet": ("type patch;", [foam.radial_face(a, 0)]),
                     "ambient": ("type patch;", [foam.radial_face(a, 1), foam.axial_face(a, b, 2)]),
                     "outlet": ("type patch;", [foam.radial_face(b, 0), foam.radial_face(b, 1)]),
                     "back": ("type wedge;", [s[0] for s in sides]),
                     "front": ("type wedge;", [s[1] for s in sides]),
                     "axis": ("type empty;", [foam.axial_face(a, b, 0)])})
    k = 1.5*0.05**2
    epsilon = 0.09**0.75*k**1.5/0.07
    still = {"k": 1e-6, "epsilon": 1e-8}     # eddy viscosity of the order of nu
    wedges = {"back|front": "type wedge;", "axis": "type empty;"}
    dictionaries.write_field(case, "U", "[0 1 -1 0 0 0 0]", "uniform (0.01 0 0)", {
        "inlet": "type fixedValue; value uniform (1 0 0);",
        "ambient": "type pressureInletOutletVelocity; value uniform (0 0 0);",
        "outlet": "type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0);", **wedges})
    dictionaries.write_field(case, "p", "[0 2 -2 0 0 0 0]", "uniform 0", {
        "inlet": "type zeroGradient;", "ambient": "type totalPressure; p0 uniform 0; value uniform 0;",
        "outlet": "type fixedValue; value uniform 0;", **wedges})
    for name, value, dimensions in (("k", k, "[0 2 -2 0 0 0 0]"), ("epsilon", epsilon, "[0 2 -3 0 0 0 0]")):
        air = f"uniform {still[name]}"
        dictionaries.write_field(case, name, dimensions, air, {
            "inlet": f"type fixedValue; value uniform {value!r};",
            "ambient|outlet": f"type inletOutlet; inletValue {air}; value {air};", **wedges})
    dictionaries.write_field(case, "nut", "[0 2 -1 0 0 0 0]", "uniform 1e-5",
                     {"inlet|ambient|outlet": "type calculated; value uniform 1e-5;", **wedges})


def half_radius(r, u):
    """Where the velocity falls to half of that on the axis."""
    u = u/u[0]
    i = numpy.argmax(u < 0.5)
    return r[i - 1] + (u[i - 1] - 0.5)/(u[i - 1] - u[i])*(r[i] - r[i - 1])


def evaluate(flow):
    """Spreading rate, decay constant, momentum at x/D = 70 over that at the inlet, velocity on the axis at
    NEAR, and profiles at x/D = 70."""
    x = flow["x"][:, 0]
    axis = flow["U"][:, 0]
    half = numpy.array([half_radius(r, u) for r, u in zip(flow["r"], flow["U"])])
    far = (x > FIT[0]) & (x < FIT[1])
    spreading, _ = numpy.polyfit(x[far], half[far], 1)
    slope, _ = numpy.polyfit(x[far], 1/axis[far], 1)
    at = numpy.argmin(abs(x - 70))
    r, u = flow["r"][at], flow["U"][at]
    edges = numpy.concatenate(([0], 0.5*(r[1:] + r[:-1]), [r[-1]]))
    jet = r < 3*half[at]          # not the slow air far outside
    momentum = (u**2*(edges[1:]**2 - edges[:-1]**2))[jet].sum()/0.25
    profile = {"r": r/half[at], "U": u/u[0], "k": flow["k"][at]/u[0]**2}
    near = numpy.interp(NEAR, x, axis)
    return spreading, 1/slope, momentum, near, profile


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--reference", type=pathlib.Path)
    parser.add_argument("--iterations", type=int, default=4000)
    parser.add_argument("--coarse", action="store_true", help="half the cells in each direction, to judge the mesh")
    args = parser.parse_args()

    cells = (80, (12, 14)) if args.coarse else (160, (24, 28))
    rows, profiles = [], {}
    for model in foam.MODELS:
        folder = f"round_jet_{{}}{'_coarse' if args.coarse else ''}"
        case = args.work/folder.format(model)
        if not (case/"0").is_dir():
            write(case, model, cells)
            # Pope's term can destroy epsilon in the unphysical flow of the first iterations
            foam.solve(case, args.iterations,
                       args.work/folder.format("standard") if model == "Pope" else None)
        spreading, decay, momentum, near, profiles[model] = evaluate(foam.structured(case, cells[1], cells[0]))
        rows.append((model, cells[0]*sum(cells[1]), f"{spreading:.4f}", f"{decay:.3f}", f"{profiles[model]['k'][0]:.3f}", *(f"{u:.3f}" for u in near), f"{momentum:.3f}"))
        print(*rows[-1], flush=True)

    results = pathlib.Path(__file__).parent/"results"
    with (results/f"round_jet{'_coarse' if args.coarse else ''}.csv").open("w", newline="") as output:
        table = csv.writer(output)
        table.writerow(("case", "cells", "spreading rate dr_half/dx", "decay constant B", "k/Uc^2 on the axis",
                        *(f"Uc at {x}D" for x in NEAR), "momentum at 70D/inlet"))
        table.writerows(rows)
        table.writerows((name, "", *values, "") for name, values in MEASURED.items())
    if args.coarse:
        return

    figure, axes = plt.subplots(1, 2, figsize=(9, 3.8), constrained_layout=True)
    for model, profile in profiles.items():
        axes[0].plot(profile["r"], profile["U"], label=model)
        axes[1].plot(profile["r"], profile["k"], label=model)
    measured = args.reference and args.reference/"round_jet_single_phase/panchapakesan_lumley_1993_air_jet.csv"
    if measured and measured.is_file():
        data = numpy.genfromtxt(measured, delimiter=",", names=True, skip_header=2)
        # the last point of w' is an artefact of the file
        k = 0.5*(data["u_rms_over_Uc"]**2 + data["v_rms_over_Uc"]**2 + data["w_rms_over_Uc"]**2)[:-1]
        axes[0].plot(data["r_over_rhalf"], data["U_over_Uc"], "k.", markersize=3, label="Panchapakesan & Lumley 1993")
        axes[1].plot(data["r_over_rhalf"][:-1], k, "k.", markersize=3)
    else:
        print("no measured profiles given: figure without them")
    for panel, label in zip(axes, ("$U/U_c$", "$k/U_c^2$")):
        panel.set(xlabel="$r/r_{1/2}$", ylabel=label, xlim=(0, 3), ylim=(0, None))
        panel.grid(alpha=0.3)
    axes[0].legend(fontsize=8)
    figure.savefig(results/"round_jet.png", dpi=150)


if __name__ == "__main__":
    main()
