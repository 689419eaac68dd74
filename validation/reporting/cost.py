# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run costs, from the runs in hand: processor time per cell and fluid step, per grain and DEM
step, per grain and exchange with the fluid. And with these what a larger run would cost."""

import statistics


def unit_costs(run):
    """{part: seconds per unit} of a serial run. The parts were timed by the wall clock, which other
    work on the machine disturbs: they share the processor time."""
    s = run.summary
    cost = s["cost"]
    timed = cost["secondsFluid"] + cost["secondsDEM"] + cost["secondsCoupling"]
    used = cost["processorSeconds"]/timed
    exchanges = s["grainSteps"]/s["settings"]["couplingInterval"]
    return {"fluid": used*cost["secondsFluid"]/(s["mesh"]["cells"]*s["fluidSteps"]),
            "DEM": used*cost["secondsDEM"]/s["grainSteps"],
            "coupling": used*cost["secondsCoupling"]/exchanges}


def median_costs(runs):
    found = [unit_costs(run) for run in runs]
    return {part: statistics.median(f[part] for f in found) for part in ("fluid", "DEM", "coupling")}


def cells(s):
    """Number of cells of a run of the table."""
    pipe = s["nSide"]**2 + 4*s["nRing"]*s["nSide"]
    return pipe*(s["nPipe"] + s["nJet"]) + 4*s["nAir"]*s["nSide"]*s["nJet"]


def estimate(s, unit, residence):
    """Core hours of a run of the table without losses by parallel work. residence: how much longer
    grains stay than length over mean velocity, from the runs in hand."""
    steps = s["endTime"]/s["fluidStep"]
    length = s["insertionLength"] + s["jetLength"]
    grains = s["particlesPerSecond"]/s["cg"]**3*residence*length*s["D"]/s["Umean"]
    exchanges = steps*s["subSteps"]
    seconds = {"fluid": unit["fluid"]*cells(s)*steps,
               "DEM": unit["DEM"]*grains*exchanges*s["couplingInterval"],
               "coupling": unit["coupling"]*grains*exchanges}
    return {"cells": cells(s), "grains": grains, "fluidSteps": steps, "demSteps": exchanges*s["couplingInterval"],
            **{part: value/3600 for part, value in seconds.items()},
            "hours": sum(seconds.values())/3600}


def residence(run):
    """Time in flight over length/Umean."""
    s = run.settings
    length = s["insertionLength"] + s["jetLength"]
    rate = s["particlesPerSecond"]/s["cg"]**3
    return run.summary["grainsInFlight"]/rate/(length*s["D"]/s["Umean"])
