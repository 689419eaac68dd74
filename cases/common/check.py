#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of a job, and what must hold in its results. Exit code 1 if anything does not.

    check.py [folder of the case]

Reads system/parameters, the profiles, the balance of the coupling and the grains at the start and
the end of the sampling."""

import math
import pathlib
import sys

import numpy

from grainjet import dictionaries, fields, tables

# Limits for fluid steps of several sub-steps (validation/benchmarks/sub_steps): change of the fluid at the grains in a step
# over their slip, of which large grains one by one make 2.5 % in runs with the same profiles; Courant number
CHANGE, COURANT = 0.03, 5.0


def parameters(case):
    """Numbers, lists of numbers and words of system/parameters."""
    return dictionaries.values(pathlib.Path(case)/"system"/"parameters")


def inserted(p):
    """(kg/s, particles/s) that the parameters state."""
    kg = p["massLoading"]*p["rhoFluid"]*p["Umean"]*math.pi/4*p["D"]**2
    # particles per kg: each size class by its share of the mass
    per_kg = sum(share/(p["rhoParticle"]*math.pi/6*d**3)
                 for d, share in zip(p["diameters"], p["massFractions"]))
    return kg, kg*per_kg


class Plane:
    """What one sampling plane saw."""

    def __init__(self, position, path):
        table, whole = tables.read(path), tables.stated(path)
        self.position = position
        self.crossings = whole["whole plane: crossings"]
        self.passed = whole["whole plane: forward"] - whole["whole plane: backward"]
        self.particles_per_s = whole["whole plane: number rate"]
        self.kg_per_s = whole["whole plane: mass rate"]

        # On the axis: the rings nearest to it, up to 0.2 D, joined
        near = table["r_outer/D"] < 0.2 + 1e-6
        seen = near & (table["crossings"] > 0)
        n = table["crossings"][seen]
        mean, rms = (table[f"flux_weighted_{name}_axial"][seen] for name in ("mean", "rms"))
        self.mean = (n*mean).sum()/max(n.sum(), 1)
        self.rms = math.sqrt(max((n*(rms**2 + mean**2)).sum()/max(n.sum(), 1) - self.mean**2, 0))
        self.error = self.rms/math.sqrt(max(n.sum(), 1))
        areas = (table["r_outer/D"]**2 - table["r_inner/D"]**2)[near]
        self.axis_flux = (table["number_flux"][near]*areas).sum()/areas.sum()


def removed(balance):
    """Grains that have left the box or were deleted, by row."""
    return balance["leftBox"] + balance["deleted"]


def dem_step(p):
    """The DEM step [s]."""
    return p["fluidStep"]/p.get("subSteps", 1)/p["couplingInterval"]


def beyond(grains, balance, plane, diameter):
    """Grains that have passed a plane by the time of a file of grains: behind it or removed."""
    time, position, _ = grains
    row = numpy.argmin(abs(balance["Time"] - time))
    return (position[:, 2] > plane*diameter).sum() + removed(balance)[row]


def outside_mesh(balance, plate):
    """(whether it holds, in words): no grain leaves the mesh but those that sink into a plate, 1 % of all, as a whole number
    that is not smaller."""
    outside = balance["outsideMesh"].max()
    allowed = math.ceil(0.01*balance["present"].max()) if plate else 0
    return outside <= allowed, f"grains outside the mesh at any step: {outside:.0f} (at most {allowed})"


class Results:
    """What a finished job left, read once."""

    def __init__(self, case):
        case = pathlib.Path(case)
        self.p = parameters(case)
        results = case/"postProcessing"
        self.planes = [Plane(*found) for found in tables.planes(results/"profiles").items()]
        self.balance = tables.history(results/"liggghtsCoupling", "balance")
        self.courant = tables.courant(case)
        self.start, self.end = (fields.grains_at(results/"grains", self.p[time])
                                for time in ("sampleStart", "endTime"))

    def table(self):
        """The lines of the table."""
        p = self.p
        _, particles_per_s = inserted(p)
        yield (f"One grain = {p['cg']**3:g} particles; sampled from {p['sampleStart']:g} s "
               f"to {p['endTime']:g} s")
        yield "  plane  crossings   axis: mean      rms      number flux    through the plane"
        yield "    z/D     grains          m/s      m/s        1/(m2 s)     / inserted"
        for plane in self.planes:
            yield (f"{plane.position:7g} {plane.crossings:10.0f}   {plane.mean:6.2f} +- {plane.error:4.2f}"
                   f"   {plane.rms:6.2f}     {plane.axis_flux:11.3e}         "
                   f"{plane.particles_per_s/particles_per_s:.3f}")

    def checks(self):
        """[(whether it holds, in words)]"""
        p, planes, balance, start, end = self.p, self.planes, self.balance, self.start, self.end
        D = p["D"]
        kg_per_s, particles_per_s = inserted(p)
        expected = particles_per_s/p["cg"]**3*(p["endTime"] - p["sampleStart"])
        plate = p["endPatch"] == "plate"
        checks = []

        # Arrivals scatter at most like independent ones: 4 standard errors of a Poisson count
        tolerance = 4/math.sqrt(expected)
        # (grains that a plate throws back may pass a plane more than once)
        for plane in planes if not plate else ():
            for name, seen, put in (("number", plane.particles_per_s, particles_per_s),
                                    ("mass", plane.kg_per_s, kg_per_s)):
                checks.append((abs(seen/put - 1) < tolerance,
                               f"{name} flow through {plane.position:g}D / inserted = {seen/put:.3f} "
                               f"(1 +- {tolerance:.3f})"))

        # The planes count what the balance and the grains themselves say, but for the grains that
        # pass in the one step that may or may not belong to the sampling. Grains that a plate throws back
        # may leave in front of a plane, so nothing is said there
        slack = 1 + math.ceil(2*expected*p["fluidStep"]/(p["endTime"] - p["sampleStart"]))
        counted = True
        for name, (written, _, _) in (("sampleStart", start), ("endTime", end)) if not plate else ():
            if abs(written - p[name]) > p["fluidStep"]:
                counted = False
                checks.append((False, f"crossings: grains were written at {written:g} s, not at {name} = {p[name]:g} s, so they cannot be counted: "
                               f"make {name} a multiple of writeInterval"))
        for plane in planes if counted and not plate else ():
            passed = (beyond(end, balance, plane.position, D)
                      - beyond(start, balance, plane.position, D))
            checks.append((abs(passed - plane.passed) <= slack,
                           f"crossings of {plane.position:g}D: {plane.passed:.0f}; grains and balance "
                           f"say {passed:.0f} (+- {slack})"))

        last = {name: values[-1] for name, values in balance.items()}
        inside = len(end[1])
        # LIGGGHTS still holds grains that left its box after the latest insertion, when it last
        # looked; and a fast grain sinks into a soft plate: its centre may leave the mesh for a while
        gone = 1 + math.ceil(2*expected*p["insertionInterval"]*dem_step(p)
                             / (p["endTime"] - p["sampleStart"]))
        if plate:
            gone += int(balance["outsideMesh"].max())
        checks.append((0 <= last["inserted"] - inside - last["leftBox"] - last["deleted"] <= gone,
                       f"inserted {last['inserted']:.0f} = inside {inside} + left the box "
                       f"{last['leftBox']:.0f} + deleted {last['deleted']:.0f} "
                       f"(+ at most {gone} on their way out)"))

        # Each insertion rounds its number of grains up or down at random: deviation 1/2 at most
        stated = particles_per_s/p["cg"]**3*p["endTime"]
        insertions = p["endTime"]/dem_step(p)/p["insertionInterval"]
        tolerance = 4*0.5*math.sqrt(insertions)
        checks.append((abs(last["inserted"] - stated) < tolerance,
                       f"inserted {last['inserted']:.0f} of {stated:.0f} grains stated (+- {tolerance:.0f})"))
        checks.append(outside_mesh(balance, plate))
        imbalance = balance["imbalance"].max()
        checks.append((imbalance < 1e-10, "momentum of grains and fluid: imbalance at most "
                       f"{imbalance:.1e} of what they exchanged (allowed: 1e-10, round-off)"))
        # Grains fly through the fluid of the beginning of a step, which must change little until its end, and
        # which must be solved well in such a step. While the first grains come into the steady flow it changes more
        if p.get("subSteps", 1) > 1:
            sampled = balance["Time"] > p["sampleStart"]
            slip, change = (balance[name][sampled].mean() for name in ("meanSlip", "fluidChange"))
            checks.append((change <= CHANGE*slip,
                           f"sub-steps: in a fluid step the fluid at the grains changes by {change:.2g} m/s, {100*change/slip:.2f} % "
                           f"of their slip of {slip:.3g} m/s (at most {100*CHANGE:g} %)"))
            checks.append((self.courant <= COURANT, f"sub-steps: largest Courant number {self.courant:.2f} (at most {COURANT:g})"))
        if planes[-1].position >= 20:
            checks.append((planes[-1].mean + 3*planes[-1].error < planes[0].mean - 3*planes[0].error,
                           f"mean velocity on the axis falls from {planes[0].mean:.2f} to "
                           f"{planes[-1].mean:.2f} m/s"))

        return checks


def judge(results):
    """Print the table of results and what must hold in them. Returns the exit code."""
    print("", *results.table(), sep="\n")
    checks = list(results.checks())
    print()
    for held, text in checks:
        print(f"  {'holds ' if held else 'FAILED'}  {text}")
    failed = sum(not held for held, _ in checks)
    print("All checks hold" if not failed else f"{failed} checks FAILED")
    return 1 if failed else 0


def case():
    """The folder of the case, as the command line says."""
    return sys.argv[1] if len(sys.argv) > 1 else "."


if __name__ == "__main__":
    sys.exit(judge(Results(case())))
