# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the elbow case left: hits of the walls, map, and the profile of wear along the outer line of the bend."""

import csv
import math
import pathlib

import numpy

from grainjet import dictionaries, surfaces, tables

HALF_STRIP = 15.0               # degrees around the pipe: what counts as the outer line
SMOOTH = 3.0                    # degrees, deviation of the kernel by which the profile is smoothed
RESAMPLES = 200


# Laws by hand, per mass [m3/kg]; angle in rad from the surface

def dnv_aluminium(v, a):
    s = numpy.sin(a)
    return 5.8e-9/2700*v**2.3*0.6*(s + 7.2*(s - s**2))**0.6*(1 - numpy.exp(-20*a))


def ecrc(v, a):
    F = 5.3983*a - 10.1068*a**2 + 10.9327*a**3 - 6.3283*a**4 + 1.4234*a**5
    return 2.17e-7*95**-0.59*0.53*v**2.41*F/2700


def oka(v, a):
    H, s = 1.1, numpy.sin(a)
    return 1e-9*65*H**-0.12*(v/104)**(2.3*H**0.038)*s**(0.71*H**0.14)*(1 + H*(1 - s))**(2.4*H**-0.94)


def finnie(v, a):
    return v**2*numpy.where(numpy.tan(a) <= 1/3, numpy.sin(2*a) - 3*numpy.sin(a)**2, numpy.cos(a)**2/3)


LAWS = {"dnv, aluminium": dnv_aluminium, "ecrc": ecrc, "oka, SiO2": oka, "finnie": finnie}


class Bend:

    def __init__(self, case):
        case = pathlib.Path(case)
        self.p = p = dictionaries.values(case/"system"/"parameters")
        results = case/"postProcessing"
        self.events = e = numpy.atleast_1d(numpy.genfromtxt(
            results/"wear"/"events.csv", delimiter=",", names=True, dtype=None, encoding="utf-8"))
        with open(results/"wear"/"walls.csv", newline="") as file:
            self.totals = {row["region"]: row for row in csv.DictReader(file)}
        self.map = surfaces.Surface(results/"wear"/"walls.vtp")
        self.balance = tables.history(results/"liggghtsCoupling", "balance")
        self.radius, self.R = p["bendRadius"]*p["D"], 0.5*p["D"]
        self.speed, self.angle, self.mass = e["speed_before"], numpy.radians(90 - e["angle"]), e["mass"]
        self.in_bend = e["mesh"] == "bend"
        # along the bend and, from its outer line, around the pipe, degrees
        self.along = numpy.degrees(numpy.arctan2(e["z"], self.radius - e["x"]))
        u = numpy.hypot(e["z"], e["x"] - self.radius) - self.radius
        self.around = numpy.degrees(numpy.arctan2(e["y"], u))
        order = numpy.argsort(e["time"], kind="stable")
        self.first = numpy.zeros(len(e), dtype=bool)
        self.first[order[numpy.unique(e["id"][order], return_index=True)[1]]] = True
        self.sand = p["sandRate"]*p["endTime"]          # kg that has entered
        self.outer = self.in_bend & (abs(self.around) < HALF_STRIP)

    def area(self, degrees):
        """m2 of the strip along the outer line, over so many degrees of the bend."""
        half = math.radians(HALF_STRIP)
        return math.radians(degrees)*self.R*(2*half*self.radius + 2*self.R*math.sin(half))

    def smoothed(self, at, where, wear):
        """Depth [m per kg of sand that enters] along the outer line, smoothed; hits mirrored at the ends of the bend."""
        place = self.along[where]
        kernel = sum(numpy.exp(-0.5*((at[:, None] - image[None, :])/SMOOTH)**2) for image in (place, -place, 180 - place))
        return (kernel*wear[None, :]).sum(axis=1)/(SMOOTH*math.sqrt(2*math.pi))/self.area(1)/self.sand

    def maximum(self, law, where=None):
        """(degrees, its standard error by resampling the hits) of the largest depth along the outer line."""
        where = numpy.flatnonzero(self.outer if where is None else where & self.outer)
        at = numpy.arange(0, 90.01, 0.5)
        wear = self.mass[where]*law(self.speed[where], self.angle[where])
        random = numpy.random.default_rng(1)
        found = []
        for _ in range(RESAMPLES):
            chosen = random.integers(0, len(where), len(where))
            found.append(at[self.smoothed(at, where[chosen], wear[chosen]).argmax()])
        return at[self.smoothed(at, where, wear).argmax()], float(numpy.std(found))

    def by_hand(self, where):
        """m3 by the law of the script, applied to each logged hit."""
        return (self.mass[where]*dnv_aluminium(self.speed[where], self.angle[where])).sum()

    def stokes(self):
        """Stokes number of the sand with U/D, Stokes drag."""
        p = self.p
        return p["rhoParticle"]*p["dParticle"]**2/(18*p["nu"]*p["rhoFluid"])*p["Umean"]/p["D"]

    def straight(self, u):
        """Degrees at which a grain hits the outer line that flies straight on, u radii outside the axis."""
        return math.degrees(math.acos((self.radius + u*self.R)/(self.radius + self.R)))
