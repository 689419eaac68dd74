# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's models beside those it has not: law of the wall, eddies, lift, spin and torque."""

import figures
import numpy
import sections
from sections import head, row

WITHOUT = "the paper's"


def rings(run, plane):
    """Rings of a plane in which enough grains crossed, and their areas."""
    profile = run.profile(plane)
    r = profile["r/D"]
    width = r[1] - r[0]
    areas = (r + width/2)**2 - (r - width/2)**2
    good = profile["crossings"] > 0
    return {key: value[good] for key, value in profile.items()}, areas[good]


def fullness(run, plane):
    """Velocity of the particles on the axis over their bulk velocity (volume flow over volume)."""
    profile, areas = rings(run, plane)
    flow = profile["number_flux"]*areas
    bulk = flow.sum()/(flow/profile["flux_weighted_mean_axial"]).sum()
    at = next(p for p in run.summary["planes"] if abs(p["position"] - plane) < 1e-6)
    return at["axisMean"]/bulk


def rms(run, plane, column, radius):
    """Root mean square velocity of all grains within a radius, about the mean of their ring [m/s]."""
    profile, _ = rings(run, plane)
    near = profile["r/D"] < radius
    n = profile["crossings"][near]
    return numpy.sqrt((n*profile[column][near]**2).sum()/n.sum())


def line(case, name, run):
    gas = run.summary["fluidAxisSpeed"]/run.summary["fluidBulkSpeed"]
    planes = run.settings["planes"]
    far = planes[-1]
    speed = run.settings["Umean"]
    return row(case, name, f"{gas:.3f}", f"{fullness(run, planes[0]):.3f}",
               *(f"{p['axisMean']/speed:.3f} +- {p['axisMeanError']/speed:.3f}"
                 for p in (run.summary["planes"][0], run.summary["planes"][-1])),
               *(f"{rms(run, plane, 'flux_weighted_rms_axial', 0.2):.2f}" for plane in (planes[0], far)),
               *(f"{rms(run, plane, 'flux_weighted_rms_radial', 0.5):.3f}" for plane in (planes[0], far)),
               f"{far:g}D")


def table(results, pairs):
    lines = [head("case", "models", "gas: axis/bulk at the exit", "particles: axis/bulk", "particles on the axis, exit, over U",
                  "far", "rms axial within 0.2 D, m/s: exit", "far", "rms radial within 0.5 D, m/s: exit", "far", "far is at")]
    for case, name, run in pairs:
        if run:
            lines.append(line(case, name, run))
    return lines + [""]


def report(results, pictures):
    """The section: all cases, one model at a time, the spread over meshes."""
    lines = ["## Models beyond the paper", "",
             "`models = \"all\"` of `cases/parameters.toml`: law of the wall, Langevin dispersion, Saffman-Mei lift, Magnus force and torque "
             "([what grains feel](../../docs/what_grains_feel.md)), beside the runs above. "
             "Gas: the flow before the grains come in.", ""]
    beyond = results.study("models")
    if not any(beyond.values()):
        return lines + sections.not_run(results, "models")
    pairs = []
    for name, run in beyond.items():
        case = name.removesuffix("-models")
        if run and case in results.runs:
            pairs += [(case, WITHOUT, results.runs[case]), (case, "all", run)]
    lines += table(results, pairs)
    for name, run in beyond.items():
        case = name.removesuffix("-models")
        if run and case in results.runs:
            figures.profiles([results.runs[case], run], run.settings["planes"], pictures/f"{name}.png",
                             results.experiments)
            lines += [f"![{case} with the paper's models and with all](figures/{name}.png)"]
    return lines + ["", *alone(results), *meshes(results)]


def alone(results):
    """One case with one model at a time."""
    case = results.table.studies["model"]["case"]
    runs = results.study("model")
    if case not in results.runs or not any(runs.values()):
        return [f"One model at a time: {sections.not_run(results, 'model')[0]}", ""]
    named = [(case, WITHOUT, results.runs[case]),
             *((case, name.removeprefix("model-"), run) for name, run in runs.items()),
             (case, "all", results.study("models")[f"{case}-models"])]
    return ["One model at a time:", "", *table(results, named)]


def meshes(results):
    """Does the exit profile depend less on the mesh?"""
    if not sections.complete(results, "mesh") or not sections.complete(results, "mesh-models"):
        return [f"Three meshes: {sections.not_run(results, 'mesh-models')[0]}", ""]
    lines = ["Three meshes, the paper's models and all. Axis: velocity of the particles there. Spread: largest less smallest, over their mean.", "",
             head("models", "plane", "axis, m/s: coarse", "middle", "fine", "spread, %")]
    for name, study in ((WITHOUT, "mesh"), ("all", "mesh-models")):
        runs = list(results.study(study).values())
        for i, plane in enumerate(runs[0].settings["planes"]):
            axis = numpy.array([run.summary["planes"][i]["axisMean"] for run in runs])
            errors = [run.summary["planes"][i]["axisMeanError"] for run in runs]
            lines.append(row(name, f"{plane:g}D", *(f"{a:.2f} +- {e:.2f}" for a, e in zip(axis, errors)),
                             f"{100*numpy.ptp(axis)/axis.mean():.1f}"))
    lines.append("")
    return lines + sections.compared(results, "mesh-models", "mesh-fine-models",
                                     results.study("mesh-models")["mesh-fine-models"].settings["planes"])
