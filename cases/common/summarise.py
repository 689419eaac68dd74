#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The results of a finished run, small enough to be kept: what it leaves in <folder>/results.

    summarise.py <folder of the run>           all of it
    summarise.py --mesh <folder of the run>    only mesh.json, when there is a mesh but no results

summary.json   parameters, commit, versions, mesh, cost, planes, what had to hold
profiles.csv   radial profiles of all planes, also over Ugc (fluid on the axis at the exit) and Gm
profiles.png   the same as a picture
plate.json, plate.png   hits of a plate, with statistical errors; where they fall
"""

import json
import pathlib
import re
import subprocess
import sys

import numpy

import check
import plate
from grainjet import tables

COLUMNS = ("crossings", "flux_weighted_mean_axial", "stderr_flux_weighted_mean_axial",
           "flux_weighted_rms_axial", "flux_weighted_rms_radial", "number_flux", "stderr_number_flux",
           "mass_flux")


def first(pattern, text, kind=str, default=None):
    found = re.search(pattern, text)
    return kind(found[1]) if found else default


def mesh_quality(folder, p):
    """The columns of Table 2, and the smallest side in particle diameters."""
    text = (folder/"log.checkMesh").read_text()
    steady = folder/"log.simpleFoam"
    wall = steady.read_text() if steady.exists() else ""
    side = first(r"Min/max edge length = (\S+)", text, float)
    return {"cells": first(r"cells:\s+(\d+)", text, int),
            "nonOrthogonalityMax": first(r"non-orthogonality Max: (\S+)", text, float),
            "nonOrthogonalityAverage": first(r"non-orthogonality Max: \S+ average: (\S+)", text, float),
            "skewnessMax": first(r"Max skewness = (\S+)", text, float),
            "smallestSide": side, "smallestSideOverDiameter": side/max(p["diameters"]),
            "yPlusMin": first(r"pipeWall y\+ : min = ([^,\s]+)", wall, float),
            "yPlusMax": first(r"pipeWall y\+ : min = \S+ max = ([^,\s]+)", wall, float),
            "yPlusAverage": first(r"pipeWall y\+ .*average = (\S+)", wall, float)}


def cost(folder, balance):
    """Processor and wall time over all parts of a run that was continued, and who spent it."""
    logs = sorted(folder.glob("log.pimpleFoam*"))
    parts = [re.findall(r"ExecutionTime = (\S+) s  ClockTime = (\S+) s", log.read_text()) for log in logs]
    processor, wall = (sum(float(part[-1][i]) for part in parts if part) for i in (0, 1))
    # a step in which the machine did something else says nothing about who spent the time
    spent = {name: numpy.minimum(balance[name], 20*numpy.median(balance[name])).sum()
             for name in ("secondsFluid", "secondsDEM", "secondsCoupling")}
    return {"processorSeconds": processor, "wallSeconds": wall, **spent}


def versions(folder):
    foam = (folder/"log.pimpleFoam").read_text()[:4000]
    grains = (folder/"log.liggghts").read_text()[:200]
    return {"OpenFOAM": first(r"Build\s*:\s*(?:OPENFOAM=)?(\S+)", foam),
            "LIGGGHTS": first(r"(LIGGGHTS-PUBLIC [\d.]+)", grains),
            "Python": sys.version.split()[0]}


def last_number(folder, name):
    """The last number of a table of the steady flow."""
    table = max((folder/"spinUp"/"postProcessing").glob(name), key=lambda path: path.stat().st_mtime)
    return float(table.read_text().split()[-1].strip("()"))


def profiles(planes, p, axis):
    """Rows of profiles.csv."""
    Gm = check.inserted(p)[0]/(numpy.pi/4*p["D"]**2)
    yield ("plane/D", "r/D", *COLUMNS, "mean/Ugc", "rms/Ugc", "G/Gm")
    for position, path in planes.items():
        table = tables.read(path)
        for i in range(len(table["r/D"])):
            row = [table[name][i] for name in COLUMNS]
            yield (position, table["r/D"][i], *row, row[1]/axis, row[3]/axis, row[7]/Gm)


def mesh_only(folder):
    (folder/"results").mkdir(exist_ok=True)
    quality = mesh_quality(folder, check.parameters(folder))
    (folder/"results"/"mesh.json").write_text(json.dumps(quality, indent=1) + "\n")


def main():
    if sys.argv[1] == "--mesh":
        mesh_only(pathlib.Path(sys.argv[2]))
        return
    folder = pathlib.Path(sys.argv[1])
    stated = json.loads((folder/"case.json").read_text())
    settings = stated["settings"]
    results = check.Results(folder)
    p, balance = results.p, results.balance
    # Ugc, and the bulk velocity over pi/4 D^2: the pipe of the mesh is a prism, a little narrower
    axis = last_number(folder, "exit/*/U")
    bulk = -last_number(folder, "flowRate/*/surfaceFieldValue*.dat")/(numpy.pi/4*p["D"]**2)
    out = folder/"results"
    out.mkdir(exist_ok=True)

    planes = tables.planes(folder/"postProcessing"/"profiles")
    rows = list(profiles(planes, p, axis))
    with open(out/"profiles.csv", "w") as file:
        for row in rows:
            print(*(x if isinstance(x, str) else f"{x:.6g}" for x in row), sep=",", file=file)

    sampled = balance["Time"] > p["sampleStart"]
    judged = results.checks()
    lines = list(results.table())
    put = check.inserted(p)
    summary = {
        "name": settings["name"], "size": settings["size"], "case": settings["case"],
        "study": settings["study"], "commit": stated["commit"], "versions": versions(folder),
        "settings": settings, "mesh": mesh_quality(folder, p), "cost": cost(folder, balance),
        "fluidAxisSpeed": axis, "fluidBulkSpeed": bulk,
        "fluidSteps": len(balance["Time"]), "demSteps": len(balance["Time"])*int(p.get("subSteps", 1)*p["couplingInterval"]),
        "grainsInFlight": balance["present"][sampled].mean(),
        "grainsInFlightStartEnd": [balance["present"][sampled][i] for i in (0, -1)],
        "grainSteps": balance["present"].sum()*p.get("subSteps", 1)*p["couplingInterval"],
        "courantMax": tables.courant(folder), "percentRayleigh": balance["percentRayleigh"].max(),
        "solidFractionMax": balance["maxSolidFraction"].max(),
        "planes": [{"position": plane.position, "crossings": plane.crossings, "axisMean": plane.mean,
                    "axisMeanError": plane.error, "axisRms": plane.rms, "axisNumberFlux": plane.axis_flux,
                    "numberOverInserted": plane.particles_per_s/put[1],
                    "massOverInserted": plane.kg_per_s/put[0]} for plane in results.planes],
        "checks": [{"holds": bool(held), "text": text} for held, text in judged]}
    hits = folder/"postProcessing"/"plate"/"events.csv"
    if hits.exists():
        found = plate.statistics(hits, p)
        (out/"plate.json").write_text(json.dumps(found, indent=1) + "\n")
        plate.density_plot(hits, p, out/"plate.png")
        summary["hits"] = found["all"]["collisions"]
    (out/"summary.json").write_text(json.dumps(summary, indent=1, default=float) + "\n")

    root = pathlib.Path(__file__).resolve().parents[2]
    subprocess.run([root/"validation"/"plots"/"profiles.py", folder/"postProcessing"/"profiles",
                    "--output", out/"profiles.png", "--dpi", "80"], check=True)

    print("", *lines, "", sep="\n")
    for held, text in judged:
        if not held:
            print(f"  WARNING: does not hold: {text}")
    print(f"  {sum(held for held, _ in judged)} of {len(judged)} checks hold")


if __name__ == "__main__":
    main()
