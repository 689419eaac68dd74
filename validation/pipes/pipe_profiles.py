# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Profiles of a finished pipe, measured points, and what lies between them.

A profile is {"position": r/R or height/R, "value": m/s or m, "error": standard error} of arrays."""

import math
import re

import numpy

from grainjet import dictionaries, tables

KAPPA, E = 0.41, 9.8                # of OpenFOAM's wall functions
ENOUGH = 30                         # crossings of a ring or slice that has a mean
STRIP = 0.15                        # half width of the strip about the vertical diameter, over R


def read_points(path, order):
    """Position, value of a file of measured points: two columns and maybe more."""
    rows = numpy.array([[float(word) for word in line.split(",")[:2]]
                        for line in path.read_text().splitlines() if line.strip()])
    return rows.T if order == "position" else rows.T[::-1]


def latest(case):
    times = [d for d in case.iterdir() if (d/"UMean").is_file()]
    return max(times, key=lambda d: float(d.name))


def spalding(y_plus):
    """u+ of Spalding's law."""
    low, high = 0.0, max(y_plus, 1.0)
    for _ in range(60):
        u = 0.5*(low + high)
        ku = KAPPA*u
        y = u + (math.exp(min(ku, 50)) - 1 - ku - ku**2/2 - ku**3/6)/E
        low, high = (u, high) if y < y_plus else (low, u)
    return 0.5*(low + high)


def friction_velocity(u, y, nu):
    """u_tau of a velocity at a distance from the wall, by Spalding's law."""
    low, high = 0.0, u
    for _ in range(60):
        middle = 0.5*(low + high)
        low, high = (middle, high) if middle*spalding(y*middle/nu) < u else (low, middle)
    return 0.5*(low + high)


class Gas:
    """The mean velocity of the gas: cells averaged over rings, between them linear, at the wall by Spalding's law."""

    def __init__(self, case, s):
        time = latest(case)
        centres = numpy.array(dictionaries.internal(time/"C"))
        u = numpy.array(dictionaries.internal(time/"UMean"))[:, 2]
        radius = s["D"]/2
        r = numpy.hypot(centres[:, 0], centres[:, 1])/radius
        rings = 2*s["nRing"] + 1
        ring = numpy.minimum((r*rings).astype(int), rings - 1)
        found = [i for i in range(rings) if (ring == i).any()]
        self.r = numpy.array([r[ring == i].mean() for i in found])
        self.u = numpy.array([u[ring == i].mean() for i in found])
        # the wall of the mesh is a prism, whose faces are nearer than the circle
        self.y_wall = (math.cos(math.pi/4/s["nSide"]) - self.r[-1])*radius
        self.u_tau = friction_velocity(self.u[-1], self.y_wall, s["nu"])
        self.nu = s["nu"]

    def __call__(self, position):
        r = numpy.abs(position)
        u = numpy.interp(r, self.r, self.u)
        for i in numpy.flatnonzero(r > self.r[-1]):
            y = self.y_wall*(1 - r[i])/(1 - self.r[-1])
            u[i] = self.u_tau*spalding(y*self.u_tau/self.nu)
        return u


def radial(case):
    """Mean and rms axial velocity of the grains over r/R, from the plane's table."""
    path, = tables.planes(case/"postProcessing/profiles").values()
    t = tables.read(path)
    good = t["crossings"] >= ENOUGH
    r, n = 2*t["r/D"][good], t["crossings"][good]
    mean, rms = (t[f"flux_weighted_{name}_axial"][good] for name in ("mean", "rms"))
    return {"mean": {"position": r, "value": mean, "error": t["stderr_flux_weighted_mean_axial"][good]},
            "rms": {"position": r, "value": rms, "error": rms/numpy.sqrt(2*n)},
            "flux": {"position": r, "value": t["G/Gmean"][good], "error": 0*r}}


def vertical(case, s):
    """Mean, rms axial velocity and mean diameter of the particles that cross beside the vertical diameter."""
    e = tables.read(tables.starts(case/"postProcessing/profiles")[-1]/"events.dat")
    radius = s["D"]/2
    near = numpy.abs(e["x"]) < STRIP*radius
    y, v, n = e["y"][near]/radius, e["axial"][near], e["nParticle"][near]
    d = (6*e["mass"][near]/n/(math.pi*s["rhoParticle"]))**(1/3)
    edges = numpy.linspace(-1, 1, 2*s["rings"] + 1)
    bins = numpy.clip(numpy.digitize(y, edges) - 1, 0, len(edges) - 2)
    rows = []
    for i in range(len(edges) - 1):
        inside = bins == i
        count = inside.sum()
        if count < ENOUGH:
            continue
        mean, rms = v[inside].mean(), v[inside].std()
        rows.append((0.5*(edges[i] + edges[i + 1]), mean, rms, d[inside].mean(), d[inside].std()/count**0.5, count))
    y, mean, rms, size, error, count = numpy.array(rows).reshape(-1, 6).T
    return {"mean": {"position": y, "value": mean, "error": rms/numpy.sqrt(count)},
            "rms": {"position": y, "value": rms, "error": rms/numpy.sqrt(2*count)},
            "size": {"position": y, "value": size, "error": error},
            "flux": {"position": y, "value": count/count.mean() if len(count) else count, "error": 0*y}}


def profiles(case, s):
    return radial(case) if s["flow"] == "up" else vertical(case, s)


def difference(profile, points, scale, symmetric):
    """Root mean square and mean of (simulated - measured)/scale over the points; where the simulation has no grains
    (`missing` points) there is nothing to compare."""
    position, value = points
    if symmetric:
        position = numpy.abs(position)
    if callable(profile):
        simulated = profile(position)
    elif len(profile["position"]):
        # half a ring beyond the middle of the last one is still inside of it
        width = numpy.diff(profile["position"]).min() if len(profile["position"]) > 1 else 0.1
        first, last = profile["position"][[0, -1]]
        simulated = numpy.interp(position, profile["position"], profile["value"])
        simulated[(position > last + 0.6*width) | ((position < first - 0.6*width) & (not symmetric))] = numpy.nan
    else:
        simulated = numpy.full(len(position), numpy.nan)
    d = (simulated - value)/scale
    seen = numpy.isfinite(d)
    if not seen.any():
        return {"rms": math.nan, "mean": math.nan, "missing": len(d)}
    return {"rms": float(numpy.sqrt((d[seen]**2).mean())), "mean": float(d[seen].mean()), "missing": int((~seen).sum())}


def loading(case, s):
    """Mass flux of the particles over that of the gas, from the plane."""
    path, = tables.planes(case/"postProcessing/profiles").values()
    rate = tables.stated(path)["whole plane: mass rate"]
    return rate/(s["rhoFluid"]*s["Ubulk"]*math.pi/4*s["D"]**2)


def lost(case):
    """Grains that were inserted and take no part at the end: they left the box, were deleted, vanished, or are outside of the mesh,
    where they feel no fluid."""
    t = tables.history(case/"postProcessing/liggghtsCoupling", "balance")
    return int((t["inserted"] - t["present"] + t["outsideMesh"])[-1])


def drive(case):
    """The mean pressure gradient of meanVelocityForce over the density, m/s2, averaged over the second half of the run."""
    log = (case/"log.pimpleFoam").read_text(errors="replace")
    # printed behind the momentum predictor and again behind the pressure; the latter holds
    values = [float(word) for word in re.findall(r"pressure gradient = ([-+.\deE]+)", log)][1::2]
    return float(numpy.mean(values[len(values)//2:]))


def balance(case, s):
    """Axial forces in N, averaged over the second half of the run: the drive, the friction of the gas on the wall, what the grains
    take from the gas, what they receive, and their weight.

    The friction comes from Spalding's law and the mean velocity of the cells at the wall, all around alike."""
    t = tables.history(case/"postProcessing/liggghtsCoupling", "balance")
    half = len(t["Time"])//2
    sides = 4*s["nSide"]
    area = sides*math.sin(2*math.pi/sides)/2*(s["D"]/2)**2
    return {"drive": drive(case)*s["rhoFluid"]*area*s["length"],
            "friction": s["rhoFluid"]*Gas(case, s).u_tau**2*math.pi*s["D"]*s["length"],
            "taken": -t["toFluid_z"][half:].mean()/s["fluidStep"],
            "received": t["toGrains_z"][half:].mean()/s["fluidStep"],
            "weight": s["solidFraction"]*s["rhoParticle"]*math.pi/4*s["D"]**2*s["length"]*s["gravity"]}
