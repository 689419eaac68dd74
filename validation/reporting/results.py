# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The results in hand: kept runs, printed numbers of the paper, measured points of the user."""

import csv
import json
import math
import pathlib

import numpy
import table

QUANTITIES = ("mean", "rms", "flux")
ENOUGH = 20             # crossings that a ring needs to count in a comparison


class InputError(Exception):
    """Wrong input, in one sentence."""


class Run:
    """What was kept of one run."""

    def __init__(self, folder):
        self.folder = folder
        self.summary = json.loads((folder/"summary.json").read_text())
        self.name = self.summary["name"]
        self.settings = self.summary["settings"]
        with open(folder/"profiles.csv") as file:
            self.rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
        path = folder/"plate.json"
        self.plate = json.loads(path.read_text()) if path.exists() else None

    def profile(self, plane):
        """{column: values} of one plane."""
        rows = [row for row in self.rows if abs(row["plane/D"] - plane) < 1e-6]
        if not rows:
            raise InputError(f"{self.folder}: no plane at {plane:g}D")
        return {key: numpy.array([row[key] for row in rows]) for key in rows[0]}

    def has(self, plane):
        return any(abs(row["plane/D"] - plane) < 1e-6 for row in self.rows)

    def normalised(self, plane):
        """{quantity: (r/D, value, standard error)} as the paper's figures have them, where enough
        grains crossed."""
        profile = self.profile(plane)
        good = profile["crossings"] >= ENOUGH
        p = {key: value[good] for key, value in profile.items()}
        lau = self.settings["rig"] == "Lau"
        speed = self.settings["Umean"] if lau else self.summary["fluidAxisSpeed"]
        mean, rms = p["flux_weighted_mean_axial"], p["flux_weighted_rms_axial"]
        rms_error = rms/numpy.sqrt(2*p["crossings"])
        below = mean if lau else speed
        return {"mean": (p["r/D"], mean/speed, p["stderr_flux_weighted_mean_axial"]/speed),
                "rms": (p["r/D"], rms/below, rms_error/below),
                "flux": (p["r/D"], p["G/Gm"], p["G/Gm"]*p["stderr_number_flux"]/p["number_flux"])}


class Results:
    """All that the document is made of."""

    def __init__(self, folder, size, experiments=None):
        self.folder, self.size = pathlib.Path(folder), size
        self.table = table.Table()
        self.paper = table.read_toml(pathlib.Path(__file__).parent/"paper.toml")
        self.runs = {}
        for path in sorted(self.folder.glob(f"*-{size}/summary.json")):
            run = Run(path.parent)
            self.runs[run.name] = run
        if not self.runs:
            raise InputError(f"no results of size {size} in {folder}; run cases/Allrun {size}, then "
                             "validation/report --collect")
        # {size: {run: Run}} of the sizes above this one
        sizes = list(self.table.sizes)
        self.larger = {above: {run.name: run for run in (Run(path.parent) for path in sorted(self.folder.glob(f"*-{above}/summary.json")))}
                       for above in sizes[sizes.index(size) + 1:]}
        self.experiments = {}
        if experiments:
            if not pathlib.Path(experiments).is_dir():
                raise InputError(f"--experiments {experiments}: no such folder")
            for path in sorted(pathlib.Path(experiments).glob("*.csv")):
                self.experiments[path.stem] = read_experiment(path, self.table.cases)

    def meshes(self):
        """[(run, mesh quality)] of runs of which only the mesh was made."""
        return [(path.parent.name, json.loads(path.read_text()))
                for path in sorted(self.folder.glob("*/mesh.json"))
                if not (path.parent/"summary.json").exists()]

    def study(self, name):
        """{run: Run or None} of a study, in the order of the table."""
        return {run: self.runs.get(run) for run in self.table.studies[name]["run"]}

    def rmse(self, case, plane, quantity):
        """Root of the mean squared difference from the measured points, or None. Points beyond the
        rings in which enough grains crossed do not count."""
        points = [p for p in self.experiments.get(case, ())
                  if abs(p["plane"] - plane) < 1e-6 and p["quantity"] == quantity]
        run = self.runs.get(case)
        if not points or run is None or not run.has(plane):
            return None
        r, value, _ = run.normalised(plane)[quantity]
        squares = [(numpy.interp(p["r"], r, value) - p["value"])**2 for p in points
                   if abs(p["r"]) <= r.max() + 1e-9]
        return math.sqrt(sum(squares)/len(squares)) if squares else None


def read_experiment(path, cases):
    """Rows of a file of measured points, checked."""
    if path.stem not in cases:
        raise InputError(f"{path}: no case of that name; there are {', '.join(cases)}")
    with open(path) as file:
        reader = csv.DictReader(line for line in file if not line.startswith("#"))
        if reader.fieldnames != ["plane", "r", "quantity", "value"]:
            raise InputError(f"{path}: the header must be plane,r,quantity,value, not "
                             f"{','.join(reader.fieldnames or [])}")
        points = []
        for number, row in enumerate(reader, 1):
            if row["quantity"] not in QUANTITIES:
                raise InputError(f"{path}: point {number}: quantity {row['quantity']!r} is none of "
                                 f"{', '.join(QUANTITIES)}")
            try:
                points.append({"quantity": row["quantity"],
                               **{key: float(row[key]) for key in ("plane", "r", "value")}})
            except (TypeError, ValueError):
                raise InputError(f"{path}: point {number}: plane, r and value must be numbers") from None
    return points


def difference(run, reference, plane):
    """How far two runs are apart on a plane: ({quantity: rms difference}, {quantity: what noise
    alone would give}), over the rings that both fill; velocities over Ugc or Ugb, flux over Gm."""
    return difference_of_profiles(run.normalised(plane), reference.normalised(plane))


def difference_of_profiles(ours, theirs):
    """The same for two sets of profiles, as Run.normalised gives them."""
    apart, noise = {}, {}
    for quantity in QUANTITIES:
        r, a, da = ours[quantity]
        q, b, db = theirs[quantity]
        common = numpy.intersect1d(r.round(6), q.round(6))
        i, j = numpy.isin(r.round(6), common), numpy.isin(q.round(6), common)
        if not len(common):
            apart[quantity] = noise[quantity] = math.nan
            continue
        apart[quantity] = math.sqrt(((a[i] - b[j])**2).mean())
        noise[quantity] = math.sqrt((da[i]**2 + db[j]**2).mean())
    return apart, noise
