#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of a water jet with grains, and what must hold in its results. Exit code 1 if anything does not.

    check.py [folder of the case]

Reads system/parameters, the planes, the hits of the plate, what grains felt, the water and the
balance of the coupling."""

import math
import pathlib
import sys

import numpy

from grainjet import dumps, fields, tables

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]/"common"))
import check as jet                 # the table of a jet of grains in air: parameters and planes
import plate

ADDED_MASS = 0.5                    # coefficient of addedMass, its default
NEAR = 0.25                         # grains within so many diameters of the axis are on it


def first_hits(hits):
    """Of each grain, the first line of the events."""
    order = numpy.argsort(hits["time"], kind="stable")
    return hits[order[numpy.unique(hits["id"][order], return_index=True)[1]]]


def drag_coefficient(p, slip, density, viscosity):
    """b of a grain in drag = b slip, Wen and Yu at void fraction 1 [kg/s]."""
    d, grain = p["dParticle"], p["cg"]*p["dParticle"]
    Re = numpy.maximum(slip*d/viscosity, 1e-12)
    Cd = numpy.where(Re < 1000, 24/Re*(1 + 0.15*Re**0.687), 0.44)
    return 0.75*Cd*density*slip/d*math.pi/6*grain**3


class Felt:
    """What grains felt in one fluid step, one row per grain, and the water in their cells."""

    def __init__(self, path):
        columns = list(zip(*dumps.frames(path)[0].rows)) or [()]*13
        self.position = numpy.array(columns[1:4]).T
        self.velocity = numpy.array(columns[4:7]).T
        self.volume = 4/3*math.pi*numpy.array(columns[7])**3
        self.fluid = numpy.array(columns[8:11]).T
        self.coefficient = numpy.array(columns[11])
        self.density = numpy.array(columns[12])/(ADDED_MASS*self.volume)
        self.slip = numpy.linalg.norm(self.fluid - self.velocity, axis=1)


class Results:
    """What a finished job left, read once."""

    def __init__(self, case):
        case = pathlib.Path(case)
        results = case/"postProcessing"
        self.p = p = jet.parameters(case)
        self.planes = [jet.Plane(*found) for found in tables.planes(results/"profiles").items()]
        self.balance = tables.history(results/"liggghtsCoupling", "balance")
        self.hits = plate.read(results/"plate"/"events.csv", p)
        self.everyHit = plate.read(results/"plate"/"events.csv", {**p, "sampleStart": 0})
        self.water = tables.history(results/"water", "volFieldValue")["volIntegrate(alpha.water)"]
        self.inflow, self.outflow = (self.water_flux(results/name) for name in ("inletFlux", "openFlux"))

        # by time; LIGGGHTS counts its own steps
        steps = p["fluidStep"]/p["couplingInterval"]
        files = {int(path.stem)*steps: path for path in (results/"felt").glob("*.txt")}
        self.felt = [Felt(path) for time, path in files.items() if time > p["sampleStart"]]
        self.time, mesh = fields.latest_mesh(case)
        nearest = min(files, key=lambda time: abs(time - self.time))
        self.last = Felt(files[nearest])
        self.fraction = fields.at(mesh, "alpha.water", self.last.position)
        # in the cell where the axis meets the plate
        self.stagnation = fields.at(mesh, "p", [(1e-6, 1e-6, p["jetLength"]*p["D"] - 1e-6)])[0]

    def water_flux(self, folder):
        """m3/s of water out of the domain through a patch, by step: the mass flux holds it."""
        p, table = self.p, tables.history(folder, "surfaceFieldValue")
        return (table["sum(rhoPhi)"] - p["rhoAir"]*table["sum(phi)"])/(p["rhoFluid"] - p["rhoAir"])

    def grain_mass(self):
        return self.p["rhoParticle"]*math.pi/6*(self.p["cg"]*self.p["dParticle"])**3

    def sampled(self):
        return self.p["endTime"] - self.p["sampleStart"]

    def along_axis(self):
        """(z/D, of the grains near the axis around there: number, mean axial velocity of them and of
        the fluid at them)"""
        p = self.p
        for plane in self.planes:
            v, u = [], []
            for felt in self.felt:
                r = numpy.hypot(felt.position[:, 0], felt.position[:, 1])
                z = felt.position[:, 2]/p["D"]
                near = (r < NEAR*p["D"]) & (abs(z - plane.position) < 0.1) & (felt.coefficient > 0)
                v.append(felt.velocity[near, 2])
                u.append(felt.fluid[near, 2])
            v, u = numpy.concatenate(v), numpy.concatenate(u)
            yield plane.position, len(v), v.mean() if len(v) else math.nan, u.mean() if len(u) else math.nan

    def by_fluid(self):
        """[(name, density, viscosity, which grains)] of the grains that are in pure water or air."""
        p, held = self.p, self.last.coefficient > 0
        return [("water", p["rhoFluid"], p["nuWater"], held & (self.fraction > 0.999)),
                ("air", p["rhoAir"], p["nuAir"], held & (self.fraction < 0.001))]

    def rings(self):
        """(r_in/D, r_out/D, hits) of the plate."""
        p = self.p
        r, width = numpy.hypot(self.hits["x"], self.hits["y"])/p["D"], p["plateRadius"]/p["plateRings"]
        for i in range(int(p["plateRings"])):
            yield i*width, (i + 1)*width, self.hits[(r >= i*width) & (r < (i + 1)*width)]

    def table(self):
        """The lines of the table."""
        p, inserted = self.p, jet.inserted(self.p)[0]
        yield (f"One grain = {p['cg']**3:g} particles of {1e6*p['dParticle']:g} um; sampled from "
               f"{1e3*p['sampleStart']:g} ms to {1e3*p['endTime']:g} ms")
        yield ""
        yield "Along the jet    grains through the plane          on the axis, m/s"
        yield "    z/D        crossings   net mass/inserted     grains    water    grains/water"
        for plane, (_, _, v, u) in zip(self.planes, self.along_axis()):
            yield (f"{plane.position:7g}       {plane.crossings:10.0f}       {plane.kg_per_s/inserted:6.3f}"
                   f"             {v:7.2f}  {u:7.2f}    {v/u:6.3f}")
        yield ""
        yield "Plate            hits     kg/(m2 s)     speed, m/s       angle from the normal, degrees"
        yield "    r/D                                mean     rms        mean     rms"
        for inner, outer, hits in self.rings():
            area = math.pi*(outer**2 - inner**2)*p["D"]**2
            rate = len(hits)*self.grain_mass()/self.sampled()
            yield f"{inner:5.2f} - {outer:4.2f} {len(hits):8d}    {rate/area:10.2f}    {self.statistics(hits)}"
        yield f"   all       {len(self.hits):8d}                  {self.statistics(self.hits)}"
        yield f"   first     {len(self.first()):8d}                  {self.statistics(self.first())}"
        yield ""
        first = len(self.first())*self.grain_mass()/self.sampled()
        yield f"Garnet, kg/s     inserted {inserted:.4f}, first hits {first:.4f}, all hits " \
              f"{len(self.hits)*self.grain_mass()/self.sampled():.4f}"
        n = round(self.sampled()/p["fluidStep"])        # steps
        rho = p["rhoFluid"]
        yield (f"Water, kg/s      in {-rho*self.inflow[-n:].mean():.4f}, out {rho*self.outflow[-n:].mean():.4f}, "
               f"stored {rho*(self.water[-1] - self.water[-n - 1])/self.sampled():.4f} on the average")
        yield f"Pressure, Pa     {self.stagnation:.3g} in the middle of the plate; rho U^2/2 of the water is {0.5*rho*p['Umean']**2:.3g}"
        yield ""
        yield f"Grains at {1e3*self.time:g} ms  number   density felt   slip, m/s    drag/that of the fluid"
        for name, density, viscosity, of in self.by_fluid():
            felt = self.last
            ratio = felt.coefficient[of]/drag_coefficient(p, felt.slip[of], density, viscosity)
            middle = [numpy.median(x) if of.any() else math.nan for x in (felt.density[of], felt.slip[of], ratio)]
            yield f"  in {name:11s} {of.sum():8d}   {middle[0]:10.3f}   {middle[1]:9.2f}   {middle[2]:10.3f}"
        yield ""
        b = self.balance
        spent = numpy.array([b[f"seconds{part}"].sum() for part in ("Fluid", "DEM", "Coupling")])
        shares = ", ".join(f"{name} {share:.0f} %" for name, share in
                           zip(("fluid", "DEM", "coupling"), 100*spent/spent.sum()))
        yield (f"Largest solid fraction of a cell {b['maxSolidFraction'].max():.3f}; mean of the largest "
               f"{b['maxSolidFraction'][-n:].mean():.3f}. Time: {shares}")

    def first(self):
        """First hits of grains, in the sampled time."""
        found = first_hits(self.everyHit)
        return found[found["time"] >= self.p["sampleStart"]]

    @staticmethod
    def statistics(hits):
        """Mean and rms of speed and angle, as text."""
        if len(hits) < 2:
            return "   nan     nan         nan     nan"
        speed, angle = hits["speed_before"], hits["angle"]
        return f"{speed.mean():6.2f}  {speed.std():6.2f}      {angle.mean():6.2f}  {angle.std():6.2f}"

    def checks(self):
        """[(whether it holds, in words)]"""
        p, balance = self.p, self.balance
        kg_per_s, particles_per_s = jet.inserted(p)
        expected = particles_per_s/p["cg"]**3*self.sampled()
        checks = []

        # Grains pass the planes as they were inserted, up to the scatter of independent arrivals,
        # 4 standard errors; close to the plate they may come back
        tolerance = 4/math.sqrt(expected)
        for plane in self.planes:
            if plane.position < 0.8*p["jetLength"]:
                seen = plane.kg_per_s/kg_per_s
                checks.append((abs(seen - 1) < tolerance,
                               f"mass flow through {plane.position:g}D / inserted = {seen:.3f} (1 +- {tolerance:.3f})"))

        unaccounted = abs(balance["unaccounted"]).max()
        checks.append((unaccounted == 0, f"grains unaccounted for at any step: {unaccounted:.0f}"))
        # A grain in a hard hit has its centre in front of the plate
        outside = balance["outsideMesh"].max()
        checks.append((outside == 0, f"grains outside the mesh at any step: {outside:.0f}"))
        imbalance = balance["imbalance"].max()
        checks.append((imbalance < 1e-10, "momentum of grains and fluid: imbalance at most "
                       f"{imbalance:.1e} of what they exchanged (allowed: 1e-10, round-off)"))

        # What MULES moves is conserved up to what the pressure equation leaves of div(phi)
        came = -self.inflow.sum()*p["fluidStep"]
        error = (self.water[-1] - (came - self.outflow.sum()*p["fluidStep"]))/came
        checks.append((abs(error) < 1e-4, f"water: in - out - stored = {-error:.1e} of what came in (allowed: 1e-4)"))

        # The density is that of the cell in the step before; one part in a thousand of the other
        # fluid changes that of air by 1
        for name, density, viscosity, of in self.by_fluid():
            if of.sum() < 10:
                continue
            felt = numpy.median(self.last.density[of])
            checks.append((abs(felt/density - 1) < 0.01, f"density that grains in {name} feel: {felt:.3f} of {density:g} kg/m3"))
            # Drag grows by the solid fraction to the power -2.65, here of some percent
            ratio = numpy.median(self.last.coefficient[of]/drag_coefficient(p, self.last.slip[of], density, viscosity))
            checks.append((0.95 < ratio < 1.15, f"their drag / that in pure {name} = {ratio:.3f} (0.95 to 1.15)"))
        return checks


if __name__ == "__main__":
    sys.exit(jet.judge(Results(jet.case())))
