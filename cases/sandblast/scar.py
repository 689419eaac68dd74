# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What one run of the sandblast case left: hits of the plate, map, and the profile of the scar."""

import csv
import math
import pathlib

import numpy
import scipy.optimize

from grainjet import dictionaries, surfaces, tables

NAMES = {"normal-jetKEpsilon": "head-on, jetKEpsilon", "normal-kEpsilon": "head-on, kEpsilon",
         "far-jetKEpsilon": "head-on at 8 D, jetKEpsilon", "inclined-jetKEpsilon": "30 degrees, jetKEpsilon",
         "inclined-kEpsilon": "30 degrees, kEpsilon"}

RING = 0.125                    # width of the rings of a profile, D
ENOUGH = 30                     # hits in a ring, below which it says nothing


def oka(speed, angle, diameter, mass, hardness):
    """Volume [m3] that quartz removes: the law by hand. Angle in rad from the surface, hardness in Pa."""
    H, s = 1e-9*hardness, numpy.sin(angle)
    e90 = 65*H**-0.12*(speed/104)**(2.3*H**0.038)*(diameter/326e-6)**0.19
    return 1e-9*mass*e90*s**(0.71*H**0.14)*(1 + H*(1 - s))**(2.4*H**-0.94)


class Scar:
    """Radial profile of the wear of a jet that meets the plate head-on, in depth per mass of abrasive [m/kg]."""

    def __init__(self, r, volume, mass):
        edges = numpy.arange(0, 2.5 + RING/2, RING)
        self.r = 0.5*(edges[1:] + edges[:-1])
        self.count, _ = numpy.histogram(r, edges)
        total, _ = numpy.histogram(r, edges, weights=volume)
        square, _ = numpy.histogram(r, edges, weights=volume**2)
        area = numpy.pi*(edges[1:]**2 - edges[:-1]**2)
        self.depth = total/area/mass                # per D^2
        self.error = numpy.sqrt(square)/area/mass   # of a Poisson count
        self.good = self.count >= ENOUGH

        def gaussian(x, top, deviation):
            return top*numpy.exp(-0.5*(x/deviation)**2)

        # fewer rings make no profile
        self.top, self.deviation = math.nan, math.nan
        if self.good.sum() >= 3:
            (self.top, self.deviation), _ = scipy.optimize.curve_fit(
                gaussian, self.r[self.good], self.depth[self.good], p0=(self.depth[self.good].max(), 0.5), sigma=self.error[self.good])
        self.fit = gaussian(self.r, self.top, self.deviation)
        # <r^4>/<r^2>^2 within three deviations; 2 for a Gaussian that is not cut off
        inside = r < 3*self.deviation
        w, x = volume[inside], r[inside]**2
        self.kurtosis = (w*x**2).sum()*w.sum()/(w*x).sum()**2 if inside.any() else math.nan

    def fitted(self):
        return math.isfinite(self.top)

    def departure(self):
        """(rms of profile less Gaussian, of the profile's scatter): over its top, rings with enough hits."""
        good = self.good
        if not self.fitted():
            return math.nan, math.nan
        return (math.sqrt(((self.depth - self.fit)[good]**2).mean())/self.top,
                math.sqrt((self.error[good]**2).mean())/self.top)

    def scaled(self, x):
        """(depth over its top, its error) at x = r/deviation."""
        return [numpy.interp(x, (self.r/self.deviation)[self.good], values[self.good]/self.top)
                for values in (self.depth, self.error)]


def difference(a, b):
    """(rms difference of two scars scaled to one top and width, that of their scatter)."""
    last = min((s.r/s.deviation)[s.good].max() for s in (a, b))
    x = numpy.linspace(0.3, last, 12)
    (da, ea), (db, eb) = a.scaled(x), b.scaled(x)
    return math.sqrt(((da - db)**2).mean()), math.sqrt((ea**2 + eb**2).mean())


class Run:
    """One finished run."""

    def __init__(self, folder):
        self.name = folder.name
        self.p = p = dictionaries.values(folder/"system"/"parameters")
        results = folder/"postProcessing"
        self.events = numpy.atleast_1d(numpy.genfromtxt(
            results/"wear"/"events.csv", delimiter=",", names=True, dtype=None, encoding="utf-8"))
        with open(results/"wear"/"plate.csv", newline="") as file:
            self.total = {key: float(value) for key, value in next(csv.DictReader(file)).items() if key != "region"}
        self.map = surfaces.Surface(results/"wear"/"plate.vtp")
        self.balance = tables.history(results/"liggghtsCoupling", "balance")
        e = self.events
        self.x, self.y = e["x"]/p["D"], e["y"]/p["D"]
        self.speed, self.angle = e["speed_before"], 90 - e["angle"]         # degrees from the surface
        self.wear, self.mass = e["wear_volume"], e["mass"]
        order = numpy.argsort(e["time"], kind="stable")
        self.first = order[numpy.unique(e["id"][order], return_index=True)[1]]
        self.abrasive = self.mass[self.first].sum()         # kg that has come to the plate
        self.scar = Scar(numpy.hypot(self.x, self.y), self.wear, self.abrasive) if p["angle"] == 90 else None

    def by_hand(self):
        """m3 by the law, applied to each logged hit."""
        e, p = self.events, self.p
        return oka(e["speed_before"], numpy.radians(self.angle), e["diameter"]/numpy.cbrt(e["particles"]), e["mass"], p["hardness"])

    def along(self):
        """(x/D, depth per mass in m/kg times D^2) along the scar, |y| < 0.25 D."""
        edges = numpy.arange(-4, 4.01, 2*RING)
        near = abs(self.y) < 0.25
        total, _ = numpy.histogram(self.x[near], edges, weights=self.wear[near])
        return 0.5*(edges[1:] + edges[:-1]), total/(2*RING*0.5)/self.abrasive

    def middle(self):
        """x/D of the scar's centroid."""
        return (self.wear*self.x).sum()/self.wear.sum()


def runs(folder):
    """The finished runs below a folder, by name."""
    return {name: Run(pathlib.Path(folder)/name) for name in NAMES if (pathlib.Path(folder)/name/"finished").is_file()}
