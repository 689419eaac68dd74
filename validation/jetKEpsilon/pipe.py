#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fully developed pipe flow with jetKEpsilon and wall functions, against DNS and friction laws.

    pipe.py <work folder> [--reference <folder>]

Boundary conditions at the wall as in Table 3 of Weaver & Miskovic (2023): Spalding's wall function for nut, zero
gradient of k, wall function for epsilon. The height of the first cell is varied. Writes results/pipe.csv and
results/pipe.png; with <folder>/pipe_flow/yao2022_pipe_DNS_Retau*_MEAN.dat (Yao et al., DNS) the deviation of the
profiles from them too.
"""

import argparse
import csv
import pathlib
import re

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import foam_case as foam
from grainjet import dictionaries

R, UB = 0.5, 1.0                               # D = 1
CASES = (("", 13000), ("Retau550", 19000), ("Retau1K", 37700), ("", 40000))
Y_PLUS = (24, 50, 76)                          # wanted, of the centre of the first cell
MODELS = ("standard", "modified")


def blasius(re):
    """u_b/u_tau after Blasius, f = 0.3164 Re^-1/4."""
    return (8/(0.3164*re**-0.25))**0.5


def read_dns(folder, name):
    """y/R, U+ of the DNS, and its bulk velocity over u_tau and Reynolds number."""
    path = folder and name and folder/f"pipe_flow/yao2022_pipe_DNS_{name}_MEAN.dat"
    if not path or not path.is_file():
        return None
    lines = path.read_text().splitlines()
    rows = numpy.array([[float(v) for v in line.split()] for line in lines if line.strip() and line[0] != "#"])
    r, y, y_plus, u = rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 5]
    bulk = -numpy.trapz(2*r*u, r)
    re_tau = numpy.median(y_plus[1:]/y[1:])
    return {"y": y, "y_plus": y_plus, "U": u, "bulk": bulk, "Re": 2*re_tau*bulk}


def write(case, model, re, n):
    """A pipe one cell long with n cells to the axis."""
    foam.write_system(case, model, 2*R*UB/re, residual=1e-9, relax=0.7)
    points, (a, b) = foam.wedge_points([(0, [R]), (0.1, [R])])
    back, front = foam.side_faces(a, b, 0)
    foam.write_mesh(case, points, [foam.block(a, b, 0, (1, n), 1, (1, 1))], {
        "inlet": ("type cyclic; neighbourPatch outlet;", [foam.radial_face(a, 0)]),
        "outlet": ("type cyclic; neighbourPatch inlet;", [foam.radial_face(b, 0)]),
        "wall": ("type wall;", [foam.axial_face(a, b, 1)]),
        "back": ("type wedge;", [back]), "front": ("type wedge;", [front]),
        "axis": ("type empty;", [foam.axial_face(a, b, 0)])})
    dictionaries.write(case/"constant/fvOptions",
                       f"drive {{ type meanVelocityForce; selectionMode all; fields (U); Ubar ({UB} 0 0); relaxation 0.5; }}")
    others = {"inlet|outlet": "type cyclic;", "back|front": "type wedge;", "axis": "type empty;"}
    for name, dimensions, value, wall in (
            ("U", "[0 1 -1 0 0 0 0]", f"({UB} 0 0)", "type noSlip;"),
            ("p", "[0 2 -2 0 0 0 0]", "0", "type zeroGradient;"),
            ("k", "[0 2 -2 0 0 0 0]", "0.005", "type zeroGradient;"),
            ("epsilon", "[0 2 -3 0 0 0 0]", "0.001", "type epsilonWallFunction; value uniform 0.001;"),
            ("nut", "[0 2 -1 0 0 0 0]", "0", "type nutUSpaldingWallFunction; value uniform 0;")):
        dictionaries.write_field(case, name, dimensions, f"uniform {value}", {"wall": wall, **others})


def evaluate(case, n, re):
    log = (case/"log.simpleFoam").read_text()
    gradient = float(re_last(r"pressure gradient = ([-+.\deE]+)", log))
    u_tau = (gradient*R/2)**0.5
    flow = foam.structured(case, (n,), 1)
    r, u = flow["r"][0], flow["U"][0]
    return {"y": 1 - r/R, "U": u, "k": flow["k"][0], "epsilon": flow["epsilon"][0], "r": r,
            "u_tau": u_tau, "y_plus": (R - r[-1])*u_tau*re/(2*R*UB)}


def re_last(pattern, text):
    return re.findall(pattern, text)[-1]


def solve(work, model, re, n, iterations=4000):
    case = work/f"pipe_{model}_{round(re)}_{n}"
    if not (case/"0").is_dir():
        write(case, model, re, n)
        foam.solve(case, iterations, upwind=50)
    return evaluate(case, n, re)


def draw(panels, path):
    """U/Ub over r/R above, U+ over y+ below, one column per Reynolds number."""
    numbers = sorted({re for re, *_ in panels})
    figure, axes = plt.subplots(2, len(numbers), figsize=(4.5*len(numbers), 7), constrained_layout=True, squeeze=False)
    for column, number in enumerate(numbers):
        bulk, wall = axes[:, column]
        flows = [(n, model, flow) for re, n, model, flow, _ in panels if re == number]
        dns = next(dns for re, _, _, _, dns in panels if re == number)
        bulk.plot(1 - dns["y"], dns["U"]/dns["bulk"], "k-", linewidth=1, label="DNS, Yao et al.")
        wall.semilogx(dns["y_plus"][1:], dns["U"][1:], "k-", linewidth=1)
        sizes = sorted({n for n, *_ in flows}, reverse=True)
        for n, model, flow in flows:
            style = {"linestyle": "none", "markersize": 4, "marker": "os^"[sizes.index(n)], "markerfacecolor": "none",
                     "color": "C0" if model == MODELS[0] else "C3"}
            bulk.plot(1 - flow["y"], flow["U"]/UB, label=f"{model}, $y^+$ {flow['y_plus']:.0f}", **style)
            wall.semilogx(flow["y"]*flow["y_plus"]/flow["y"][-1], flow["U"]/flow["u_tau"], **style)
        bulk.set(xlabel="$r/R$", ylabel="$U/U_b$", title=f"Re {number}", ylim=(0, None), xlim=(0, 1))
        wall.set(xlabel="$y^+$", ylabel="$U^+$", xlim=(1, None), ylim=(0, None))
        bulk.legend(fontsize=7)
    figure.savefig(path, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--reference", type=pathlib.Path)
    args = parser.parse_args()

    rows, panels = [], []
    for name, re in CASES:
        dns = read_dns(args.reference, name)
        re = dns["Re"] if dns else re
        re_tau = re/2/blasius(re)
        for n in sorted({max(4, round(re_tau/(2*wanted))) for wanted in Y_PLUS}, reverse=True):
            for model in MODELS:
                flow = solve(args.work, model, re, n)
                expected = dns["bulk"] if dns else blasius(re)
                row = [round(re), model, n, f"{flow['y_plus']:.1f}", f"{UB/flow['u_tau']:.2f}",
                       f"{expected:.2f} ({'DNS' if dns else 'Blasius'})", f"{flow['U'][0]/UB:.3f}", "", ""]
                if dns:
                    u = numpy.interp(flow["y"], dns["y"], dns["U"]/dns["bulk"])
                    row[-2] = f"{dns['U'][-1]/dns['bulk']:.3f}"
                    row[-1] = f"{100*numpy.sqrt(numpy.average((flow['U']/UB - u)**2, weights=flow['r'])):.1f}"
                    panels.append((round(re), n, model, flow, dns))
                rows.append(row)
                print(*row, flush=True)

    results = pathlib.Path(__file__).parent/"results"
    with (results/"pipe.csv").open("w", newline="") as output:
        table = csv.writer(output)
        table.writerow(("Re", "model", "cells to the axis", "y+ of the first cell", "Ub/u_tau", "Ub/u_tau expected",
                        "axis velocity/Ub", "the same, DNS", "rms deviation of U/Ub from DNS, %"))
        table.writerows(rows)
    if panels:
        draw(panels, results/"pipe.png")


if __name__ == "__main__":
    main()
