#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of the cold spray case, and what must hold in its results. Exit code 1 if anything does not.

    check.py [folder of the case]
"""

import math
import pathlib
import sys

import numpy

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1]/"common"), str(pathlib.Path(__file__).resolve().parent)]
import check as jet                 # judges and prints
import spray

RINGS = 8                           # of the deposit, to DEPOSIT of the radius of the exit
DEPOSIT = 0.4


def apart(a, b):
    """In per cent of b."""
    return 100*(a/b - 1)


class Results:

    def __init__(self, case):
        self.s = s = spray.Spray(case)
        n = s.n
        # the exit: just before, where the gas is still in the nozzle
        self.places = {"throat": 0.0, "exit": n.end - 1e-4}
        self.free = {name: s.isentropic.section(x) for name, x in self.places.items()}
        self.real = {name: s.gas.section(x) for name, x in self.places.items()}
        self.theory = {name: n.at(x) for name, x in self.places.items()}
        # the theory with the area that the boundary layer leaves
        e = self.real["exit"]
        self.core = n.state(n.mach((n.radius(self.places["exit"]) - e["displacement"])**2
                                   / (n.throat - self.real["throat"]["displacement"])**2, True))
        self.exit = {d: self._exit(d) for d in s.p["diameters"]}

    def _exit(self, d):
        """Of a size at the exit: number, mean speed and temperature near the axis, and those of the sphere on the axis."""
        s, x = self.s, self.s.n.end
        speed, T, _ = s.passing(x, d, spray.NEAR*s.n.exit)
        way = s.flight(d)
        i = numpy.argmax(way[0] >= x)
        at = [numpy.interp(x, way[0][:i + 1], way[k][:i + 1]) for k in (1, 2)]
        return len(speed), speed.mean() if len(speed) else numpy.nan, T.mean() if len(T) else numpy.nan, *at

    def table(self):
        s, p, n = self.s, self.s.p, self.s.n
        yield (f"Nitrogen of {1e-6*p['pStagnation']:g} MPa and {p['TStagnation']:g} K, nozzle {1e3*p['throatDiameter']:g} to {1e3*p['exitDiameter']:g} mm, "
               f"{1e3*p['divergence']:g} mm long; copper; plate after {1e3*p['standOff']:g} mm; {1e3*p['endTime']:g} ms")
        yield ""
        yield "Gas, means over the mass flow; theory: one-dimensional, isentropic"
        yield "                                     Mach          p, kPa              T, K"
        for name, rows in (("throat", (("theory", self.theory), ("without friction", self.free), ("job", self.real))),
                           ("exit", (("theory", self.theory), ("without friction", self.free), ("job", self.real)))):
            ideal = self.theory[name]
            for what, states in rows:
                g = states[name]
                yield f"{name:7s} {what:22s}" + "".join(
                    f"  {scale*g[q]:9.{digits}f}{'' if what == 'theory' else f' ({apart(g[q], ideal[q]):+5.1f} %)':10s}"
                    for q, scale, digits in (("M", 1, 3), ("p", 1e-3, 1), ("T", 1, 1)))
        a, e = self.real["exit"]["axis"], self.core
        for what, g in (("job, on the axis", a), ("theory, core", e)):
            yield f"exit    {what:22s}" + "".join(
                f"  {scale*g[q]:9.{digits}f}{f' ({apart(g[q], self.theory[name][q]):+5.1f} %)':10s}" for name in ("exit",)
                for q, scale, digits in (("M", 1, 3), ("p", 1e-3, 1), ("T", 1, 1)))
        yield (f"        core: the area without the displacement thickness of the boundary layer, {1e3*self.real['exit']['displacement']:.3f} mm at the exit "
               f"(throat {1e3*self.real['throat']['displacement']:.3f} mm)")
        choked = self.theory["throat"]
        ideal = choked["rho"]*choked["U"]*math.pi*n.throat**2
        yield (f"        mass flow {1e3*self.real['throat']['flow']:.2f} g/s, {self.real['throat']['flow']/ideal:.3f} of the theory's; "
               f"without friction {self.free['throat']['flow']/ideal:.3f}")
        yield ""
        yield (f"Copper at the exit, grains within {spray.NEAR:g} of its radius from the axis, and one sphere on the axis (its own equation of motion)")
        yield "diameter   grains    speed, m/s        sphere            temperature, K    sphere"
        for d, (count, v, T, v1, T1) in self.exit.items():
            yield f"{1e6*d:5.0f} um   {count:6d}    {v:8.2f}     {v1:8.2f} ({apart(v, v1):+5.2f} %)    {T:8.2f}     {T1:8.2f} ({apart(T, T1):+5.2f} %)"
        yield ""
        yield "Copper on the plate: first hits; critical velocity by Assadi et al. (2003) and Schmidt et al. (2006), at the temperature of each grain"
        yield "diameter     hits    speed, m/s: before the shock  at impact    rms   sphere   temperature, K  sphere   critical, m/s   share above, %"
        h = s.hits
        for d in p["diameters"]:
            here = abs(h["d"]/d - 1) < 1e-6
            if not here.any():
                yield f"{1e6*d:5.0f} um         0"
                continue
            v, T = h["speed_before"][here], h["temperature"][here]
            before, _, _ = s.passing(n.plate - spray.SHOCK, d)
            critical = s.critical(T)
            way = s.flight(d)
            yield (f"{1e6*d:5.0f} um   {here.sum():6d}                     {before.mean():8.1f}    {v.mean():8.1f}{v.std():7.1f} {way[1][-1]:8.1f}"
                   f"         {T.mean():8.1f}{way[2][-1]:8.1f}   {critical[0].mean():6.0f}{critical[1].mean():8.0f}"
                   f"     {100*(v > critical[0]).mean():6.1f}{100*(v > critical[1]).mean():7.1f}")
        yield ""
        yield f"Deposit of the {1e6*p['dParticle']:g} um, radius over that of the exit; mass that hits, and of it above the critical velocity (Assadi, Schmidt)"
        yield "radius           hits   kg/m2 per kg sprayed    above, %          speed, m/s"
        here = abs(h["d"]/p["dParticle"] - 1) < 1e-6
        edges = numpy.linspace(0, DEPOSIT, RINGS + 1)*n.exit
        total = h["mass"][here].sum()
        for low, high in zip(edges, edges[1:]):
            ring = here & (h["r"] >= low) & (h["r"] < high)
            if not ring.any():
                yield f"{low/n.exit:4.2f} - {high/n.exit:4.2f}     {0:8d}"
                continue
            v, T = h["speed_before"][ring], h["temperature"][ring]
            critical = s.critical(T)
            yield (f"{low/n.exit:4.2f} - {high/n.exit:4.2f}     {ring.sum():8d}            {h['mass'][ring].sum()/total/(math.pi*(high**2 - low**2)):10.3g}"
                   f"    {100*(v > critical[0]).mean():5.0f}  {100*(v > critical[1]).mean():5.0f}       {v.mean():8.1f}")

    def checks(self):
        s, p = self.s, self.s.p
        checks = []
        for name in self.places:
            g, ideal = self.free[name], self.theory[name]
            worst = max(abs(apart(g[q], ideal[q])) for q in ("M", "p", "T"))
            checks.append((worst < 3, f"{name}, without friction: Mach number, pressure, temperature within {worst:.2f} % of the theory (3 %)"))
        a, core = self.real["exit"]["axis"], self.core
        # not the pressure, which changes by 4.4 % where the Mach number changes by 1 %, and by 6 % from the axis to the wall
        worst = max(abs(apart(a[q], core[q])) for q in ("M", "T"))
        checks.append((worst < 3, f"exit, the job's gas on the axis: Mach number, temperature within {worst:.2f} % of the theory "
                       "for the area of the core (3 %)"))
        total = a["T"]*(1 + 0.5*(s.n.gamma - 1)*a["M"]**2)
        checks.append((abs(total/p["TStagnation"] - 1) < 0.005, f"exit, on the axis: total temperature {total:.1f} K of {p['TStagnation']:g} K (0.5 %)"))
        for d, (count, v, T, v1, T1) in self.exit.items():
            if count:
                checks.append((abs(apart(v, v1)) < 2 and abs(apart(T, T1)) < 2,
                               f"{1e6*d:g} um at the exit: speed {apart(v, v1):+.2f} %, temperature {apart(T, T1):+.2f} % off the sphere on the axis (2 %)"))
        seen = sum(self.exit[d][0] for d in p["diameters"])
        checks.append((seen >= len(p["diameters"]), f"{seen} grains near the axis have passed the exit"))
        sizes = sorted(p["diameters"])
        h = s.hits
        small, most = (h["speed_before"][abs(h["d"]/d - 1) < 1e-6] for d in (sizes[0], p["dParticle"]))
        if len(small) and len(most):
            before = [s.passing(s.n.plate - spray.SHOCK, d)[0].mean() for d in (sizes[0], p["dParticle"])]
            loss = [1 - v.mean()/b for v, b in zip((small, most), before)]
            checks.append((loss[0] > loss[1], f"the bow shock takes {100*loss[0]:.1f} % of the speed of the smallest, {100*loss[1]:.1f} % of that of the "
                           f"{1e6*p['dParticle']:g} um"))
        unaccounted = abs(s.balance["unaccounted"]).max()
        checks.append((unaccounted == 0, f"grains unaccounted for at any step: {unaccounted:.0f}"))
        # a grain in the plate, up to its radius deep, has its centre at its surface; others are in the mesh
        outside = s.balance["outsideMesh"].max()
        checks.append((outside <= 0.01*s.balance["present"].max(), f"grains outside the mesh at any step: {outside:.0f} of {s.balance['present'].max():.0f}"))
        return checks


if __name__ == "__main__":
    sys.exit(jet.judge(Results(jet.case())))
