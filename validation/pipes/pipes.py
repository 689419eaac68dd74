#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured particle-laden pipes, simulated as periodic pipes with the models of the coupling, and compared.

    pipes.py <work folder> [--data <folder>] [--cases <name> ...] [--models <name>[+<name>] ...] [--size <name>]
             [--ranks <n>] [--again] [--results <folder>]

Cases, models and sizes are those of pipes.toml. Finished runs of the same version in the work folder are used again. Writes
errors.csv (rows of former calls stay, `version` says which made them) and a figure per case. Without --data it runs, draws no
points and writes no errors.
"""

import argparse
import csv
import json
import math
import pathlib
import sys
import time

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import pipe_case
import pipe_profiles
from pipe_table import PipeError, Pipes, version

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = ("case", "model", "size", "grains", "loading wanted", "loading", "mean particle velocity/Ubulk",
           "rms error gas", "mean error gas", "rms error particles", "mean error particles", "rms error of rms", "mean error of rms",
           "rms error of diameter", "points missed", "dp/dz drive/(rho_p g)",
           "axial drag/weight", "(friction + drag)/drive", "lost", "minutes", "version")
LOADING = 0.1                   # of the wanted one
# settings that a finished run may differ in: what follows from the slip, which is kept with the run, and what makes no difference
UNSTATED = ("slip", "grains", "solidFraction", "ranks", "title", "folder")
QUANTITIES = {"mean": "particles", "rms": "rms", "size": "size"}       # of a profile: entry of the case with its file


def simulate(work, case, size, name, pipes, args):
    """The folder and settings of a run, finished now or before. The slip of the table sets the number of grains; if the loading
    comes out wrong by more than LOADING, the case runs once more with the slip that was found."""
    ranks = {"ranks": args.ranks} if args.ranks else {}
    s = pipes.run(case, size, **ranks)
    model = pipes.model(name)
    folder = work/f"{case}_{size}_{name}"
    stated = {"settings": {k: v for k, v in s.items() if k not in UNSTATED}, "model": model, "version": version()}
    done = folder/"finished.json"
    if done.is_file() and not args.again:
        kept = json.loads(done.read_text())
        before = {**kept["stated"], "settings": {k: v for k, v in kept["stated"]["settings"].items() if k not in UNSTATED}}
        if before == json.loads(json.dumps(stated)):
            return folder, pipes.run(case, size, slip=kept["slip"]), kept["minutes"]
        print(f"{folder.name}: run by another version or with other numbers than pipes.toml has now, runs again", flush=True)
    for _ in range(2):
        start = time.monotonic()
        pipe_case.run(folder, s, model)
        minutes = (time.monotonic() - start)/60
        slip = s["slip"]
        if abs(pipe_profiles.loading(folder, s)/s["loading"] - 1) < LOADING:
            break
        s = pipes.run(case, size, slip=1 - particle_velocity(folder, s), **ranks)
    done.write_text(json.dumps({"stated": stated, "slip": slip, "minutes": minutes}))
    return folder, pipes.run(case, size, slip=slip), minutes


def measured(data, s):
    """{quantity: points in units of the simulation} of a case; empty without data."""
    found = {}
    for quantity, key in {"gas": "gas", **QUANTITIES}.items():
        if data is None or key not in s:
            continue
        path = data/s["folder"]/s[key]
        if not path.is_file():
            print(f"{s['name']}: no {path}, so no points of {quantity}", flush=True)
            continue
        position, value = pipe_profiles.read_points(path, s["order"])
        unit = s["dParticle"] if quantity == "size" else s["Ubulk"] if s["scale"] == "bulk" else 1
        found[quantity] = (position, value*unit)
    return found


def compare(folder, s, points):
    """Numbers of a run: the row of the table without its names, and its profiles."""
    profile = pipe_profiles.profiles(folder, s)
    gas = pipe_profiles.Gas(folder, s)
    symmetric = s["flow"] == "up"
    force = pipe_profiles.balance(folder, s)
    row = {"grains": s["grains"], "loading wanted": s["loading"], "loading": f"{pipe_profiles.loading(folder, s):.3g}",
           "mean particle velocity/Ubulk": f"{particle_velocity(folder, s):.3f}",
           "dp/dz drive/(rho_p g)": f"{pipe_profiles.drive(folder)*s['rhoFluid']/(s['rhoParticle']*s['gravity']):.4f}",
           "axial drag/weight": f"{force['taken']/force['weight']:.3f}",
           "(friction + drag)/drive": f"{(force['friction'] + force['taken'])/force['drive']:.4f}",
           "lost": pipe_profiles.lost(folder)}

    def number(value):
        return "" if math.isnan(value) else f"{value:.4f}"

    missed = 0
    for quantity, label in (("gas", "gas"), ("mean", "particles"), ("rms", "of rms"), ("size", "of diameter")):
        if quantity not in points:
            continue
        scale = s["dParticle"] if quantity == "size" else s["Ubulk"]
        error = pipe_profiles.difference(gas if quantity == "gas" else profile[quantity], points[quantity], scale, symmetric)
        row[f"rms error {label}"] = number(error["rms"])
        if f"mean error {label}" in COLUMNS:
            row[f"mean error {label}"] = number(error["mean"])
        missed += error["missing"]
    row["points missed"] = missed if points else ""
    return row, {**profile, "gas": gas}


def particle_velocity(folder, s):
    """Mean velocity of the particles over the bulk velocity: mass flux over the mass per length that is there."""
    flux = pipe_profiles.loading(folder, s)*s["rhoFluid"]*s["Ubulk"]
    return flux/(s["rhoParticle"]*s["solidFraction"])/s["Ubulk"]


def draw(path, s, runs, points):
    """Particles and gas, rms or diameter, flux: one figure per case, a line per model."""
    panels = ["mean", "rms", "flux"] + (["size"] if "size" in points else [])
    figure, axes = plt.subplots(1, len(panels), figsize=(4.6*len(panels), 4.2), constrained_layout=True)
    figure.suptitle(f"{s['title']}: {s['name']}, {1e6*s['dParticle']:.0f} um, loading {s['loading']}, {s['Ubulk']} m/s", fontsize=10)
    labels = {"mean": "mean axial velocity/$U_b$ (dashed, hollow: gas)", "rms": "rms axial velocity/$U_b$",
              "flux": "particle flux over its mean", "size": "mean diameter/nominal"}
    symmetric = s["flow"] == "up"
    for axis, quantity in zip(axes, panels):
        unit = {"flux": 1, "size": s["dParticle"]}.get(quantity, s["Ubulk"])
        for i, (model, profile) in enumerate(runs.items()):
            p = profile[quantity]
            axis.errorbar(p["position"], p["value"]/unit, yerr=p["error"]/unit, color=f"C{i}", linewidth=1, label=model)
            if quantity == "mean":
                r = numpy.linspace(0 if symmetric else -0.98, 0.98, 60)
                axis.plot(r, profile["gas"](r)/unit, "--", color=f"C{i}", linewidth=1)
        for kind, style in ((quantity, {"markerfacecolor": "k"}), ("gas" if quantity == "mean" else None, {"markerfacecolor": "none"})):
            if kind in points:
                position, value = points[kind]
                axis.plot(numpy.abs(position) if symmetric else position, value/unit, "o", color="k", markersize=3, **style)
        axis.set(xlabel="$r/R$" if symmetric else "height/$R$", ylabel=labels[quantity], ylim=(0, None))
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=8)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=90)
    plt.close(figure)


def write_table(path, rows):
    """Rows of former calls stay; those of this call replace the ones of the same case, model and size."""
    def key(row):
        return row["case"], row["model"], row["size"]
    kept = {}
    if path.is_file():
        with path.open(newline="") as file:
            kept = {key(row): row for row in csv.DictReader(file)}
    kept |= {key(row): row for row in rows}
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, restval="", extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        table.writerows(row for _, row in sorted(kept.items()))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--data", type=pathlib.Path, help="folder with the folders of the experiments")
    parser.add_argument("--cases", nargs="+")
    parser.add_argument("--models", nargs="+", default=["base"])
    parser.add_argument("--size", default="standard")
    parser.add_argument("--ranks", type=int)
    parser.add_argument("--again", action="store_true", help="run finished cases anew")
    parser.add_argument("--results", type=pathlib.Path, default=HERE/"results")
    args = parser.parse_args()
    try:
        pipes = Pipes()
        for case in args.cases or []:
            pipes.run(case, args.size)
        for model in args.models:
            pipes.model(model)
        if args.data is None:
            print("No measured points: give the folder that has them by --data. Cases run, nothing is compared.", flush=True)
        elif not args.data.is_dir():
            raise PipeError(f"--data {args.data}: no such folder")
        for case in args.cases or pipes.data["case"]:
            runs = {}
            for model in args.models:
                folder, s, minutes = simulate(args.work.resolve(), case, args.size, model, pipes, args)
                points = measured(args.data, s)
                row, runs[model] = compare(folder, s, points)
                row |= {"case": case, "model": model, "size": args.size, "minutes": f"{minutes:.1f}", "version": version()}
                print(", ".join(f"{name} {row[name]}" for name in COLUMNS if row.get(name, "") != ""), flush=True)
                if points:
                    write_table(args.results/"errors.csv", [row])
            suffix = "" if args.size == "standard" else f"_{args.size}"
            draw(args.results/f"{case}{suffix}.png", s, runs, points)
    except (PipeError, RuntimeError) as error:
        return f"pipes.py: {error}"
    return 0


if __name__ == "__main__":
    sys.exit(main())
