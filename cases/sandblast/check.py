#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of the sandblast case, and what must hold in its results. Exit code 1 if anything does not.

    check.py [folder of the runs]
"""

import pathlib
import sys

import numpy

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1]/"common"), str(pathlib.Path(__file__).resolve().parent)]
import check as jet                 # judges and prints
import scar


class Results:

    def __init__(self, folder):
        self.runs = scar.runs(folder)
        if not self.runs:
            raise SystemExit(f"check.py: no finished run in {folder}")

    def table(self):
        p = next(iter(self.runs.values())).p
        yield (f"Quartz of {1e6*p['dParticle']:g} um on metal of {1e-9*p['hardness']:g} GPa; air {p['Umean']:g} m/s, "
               f"{1e3*p['endTime']:g} ms, {p['massLoading']:g} kg of quartz to 1 kg of air")
        yield "                                 hits               first hits, mean            wear, mm3/kg of quartz"
        yield "Run                          all    first       speed, m/s   angle, deg       all hits    first hits"
        for run in self.runs.values():
            f = run.first
            yield (f"{scar.NAMES[run.name]:27s} {len(run.wear):5d}    {len(f):5d}      {run.speed[f].mean():7.2f}      {run.angle[f].mean():7.2f}"
                   f"        {1e9*run.wear.sum()/run.abrasive:8.3f}      {1e9*run.wear[f].sum()/run.abrasive:8.3f}")
        yield ""
        yield "Scar of the head-on jets     deepest      Gaussian   rms departure, % of the deepest    <r^4>/<r^2>^2"
        yield "                             um/kg       width/D    (scatter of the counts)            (Gaussian: 2)"
        for run in self.normal():
            s = run.scar
            off, scatter = s.departure()
            yield (f"{scar.NAMES[run.name]:27s} {1e6*s.top/run.p['D']**2:8.0f}     {s.deviation:7.3f}        {100*off:5.1f} ({100*scatter:3.1f})"
                   f"                         {s.kurtosis:5.2f}")
        for a, b in (("normal-jetKEpsilon", "far-jetKEpsilon"), ("normal-jetKEpsilon", "normal-kEpsilon")):
            if all(name in self.runs and self.runs[name].scar.fitted() for name in (a, b)):
                off, scatter = scar.difference(self.runs[a].scar, self.runs[b].scar)
                yield (f"{scar.NAMES[a]} and {scar.NAMES[b]}, scaled to one top and width: rms difference {100*off:.1f} %"
                       f" ({100*scatter:.1f})")
        inclined = [run for run in self.runs.values() if run.scar is None]
        if inclined:
            yield ""
            yield "Scar of the inclined jets    centroid, x/D    deepest at x/D (|y| < 0.25 D)    the axis meets the plate at x = 0"
        for run in inclined:
            x, depth = run.along()
            yield f"{scar.NAMES[run.name]:27s}    {run.middle():8.3f}        {x[depth.argmax()]:8.3f}"

    def normal(self):
        return [run for run in self.runs.values() if run.scar]

    def checks(self):
        checks = []
        for run in self.runs.values():
            name, total, volume = scar.NAMES[run.name], run.total, run.map.values["wear_volume"]
            hand = run.by_hand().sum()
            # digits of the log
            checks.append((abs(total["wear_volume"]/hand - 1) < 1e-6,
                           f"{name}: wear {1e9*total['wear_volume']:.6g} mm3; the law by hand on {len(run.wear)} logged hits gives {1e9*hand:.6g}"))
            checks.append((abs(volume.sum()/hand - 1) < 1e-6 and run.map.values["impacts"].sum() == len(run.wear),
                           f"{name}: triangles of the map hold {run.map.values['impacts'].sum():.0f} hits and {1e9*volume.sum():.6g} mm3"))
            unaccounted, imbalance = abs(run.balance["unaccounted"]).max(), run.balance["imbalance"].max()
            checks.append((unaccounted == 0 and imbalance < 1e-10,
                           f"{name}: grains unaccounted for {unaccounted:.0f}, imbalance of momentum {imbalance:.1e} (allowed: 1e-10)"))
            # A grain that flies up past the nozzle, or out of a side, stays until lists are rebuilt
            outside = (run.balance["outsideMesh"]/numpy.maximum(run.balance["present"], 1)).max()
            checks.append((outside < 0.01, f"{name}: share of the grains outside the mesh at most {outside:.4f} (allowed: 0.01)"))
        return checks


if __name__ == "__main__":
    sys.exit(jet.judge(Results(sys.argv[1] if len(sys.argv) > 1 else "runs")))
