# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat from a gas to a single grain: laws, recovery temperature, coarse grains, and the temperature that a drag law takes."""

import math
import unittest

import gas_box
import heat_box
from grainjet import coupled_box as box, dumps

MU, PR, CP = 1.8e-5, 0.7, gas_box.CV + gas_box.R
D, RHO_P, C_P = 2e-4, 2500.0, 20.0           # a specific heat so small that grains follow within some ms
CAPACITY = heat_box.mass(D, RHO_P) * C_P
KAPPA = heat_box.conductivity(MU, PR)


def gunn(re, prandtl):
    """Of a lone sphere: void fraction 1."""
    return 2 * (1 + 0.7 * re ** 0.2 * prandtl ** (1 / 3)) + 0.13 * re ** 0.7 * prandtl ** (1 / 3)


def whitaker(re, prandtl, ratio=1.0):
    """ratio: viscosity of the gas over that at the grain's surface."""
    return 2 + (0.4 * re ** 0.5 + 0.06 * re ** (2 / 3)) * prandtl ** 0.4 * ratio ** 0.25


class Heat(heat_box.HeatCase):

    def stream(self, *, speed=0.0, heat="model RanzMarshall;", steps=20, drag=None, temperature=400.0, specific_heat=C_P,
               diameter=D, plugins="", stop_at=None, **case):
        """Temperature and velocity of a grain that is at rest in a stream in z, without drag unless one is given."""
        options = {"coupling": "oneWay", "drag": None,
                   "forces": "{ " + (f"drag {{ {drag} }} " if drag else "") + f"heat {{ {heat} }} }}"}
        case = {"steps": steps, "velocity": f"(0 0 {speed!r})", "mu": MU, "prandtl": PR, "cells": "2 2 2", **case}
        folder = self.run_warm(grains=([(0.011, 0.012, 0.013)], [(0, 0, 0)]), options=options, diameter=diameter,
                               density=RHO_P, specific_heat=specific_heat, temperature=temperature, plugins=plugins, **case)
        row = dumps.last(folder / "grains.dump")[1]
        return row[-1], row[5]

    def test_laws(self):
        """A grain cools in a uniform stream along the exact exponential curve. Gunn's law gets the void fraction of a cell,
        1 - 4e-6: 2e-5 of the difference of temperatures."""
        re = 30.0 * D / (MU / gas_box.RHO0)
        for name, law, tolerance in (("RanzMarshall", heat_box.ranz_marshall, 1e-9), ("Gunn", gunn, 2e-5), ("Whitaker", whitaker, 1e-9)):
            with self.subTest(law=name):
                H = law(re, PR) * KAPPA * math.pi * D
                exact = 300 + 100 * math.exp(-H * 20e-4 / CAPACITY)
                T, _ = self.stream(speed=30.0, heat=f"model {name}; recovery no;")
                print(f"{name}: {T:.9f} K, exact {exact:.9f} K")
                self.assertTrue(305 < exact < 395, exact)
                # R of OpenFOAM differs from the CODATA value by 1e-6, so do cp and density
                self.assertLess(abs(T - exact), (tolerance + 3e-6) * 100)

    def test_viscosity_at_the_surface(self):
        """Whitaker with the viscosity of Sutherland: that of each step's grain, whose curve is not an exponential one."""
        def mu(T):
            return 1.4792e-6 * T ** 0.5 / (1 + 116 / T)
        T, dt, speed = 600.0, 1e-4, 30.0
        cv = gas_box.CV
        # OpenFOAM's Sutherland gas conducts by Eucken's formula
        kappa = mu(300.0) * cv * (1.32 + 1.77 * gas_box.R / cv)
        prandtl = mu(300.0) * CP / kappa
        for _ in range(20):
            Nu = whitaker(speed * D * gas_box.RHO0 / mu(300.0), prandtl, mu(300.0) / mu(T))
            T = 300 + (T - 300) * math.exp(-Nu * kappa * math.pi * D * dt / CAPACITY)
        found, _ = self.stream(speed=speed, heat="model Whitaker; recovery no;", temperature=600.0, transport="sutherland")
        print(f"{found:.6f} K, integrated {T:.6f} K")
        self.assertTrue(305 < T < 590, T)
        self.assertLess(abs(found - T), 5e-6 * 300)

    def test_recovery_temperature(self):
        """In a fast stream a grain ends at the recovery temperature, T + sqrt(Pr) u^2/(2 cp); without the entry at T."""
        speed = 2 * gas_box.SOUND
        for recovery, end in (("yes", 300 + PR ** 0.5 * speed ** 2 / (2 * CP)), ("no", 300.0)):
            for solver, transonic in (("rhoPimpleFoam", True), ("sonicFoam", True)):
                with self.subTest(recovery=recovery, solver=solver):
                    T, _ = self.stream(speed=speed, heat=f"model RanzMarshall; recovery {recovery};", steps=60, solver=solver,
                                       transonic=transonic, specific_heat=0.2)
                    print(f"recovery {recovery}, {solver}: {T:.6f} K, expected {end:.6f} K")
                    self.assertLess(abs(T - end), 3e-6 * end)
        self.assertGreater(300 + PR ** 0.5 * speed ** 2 / (2 * CP), 480)

    def test_coarse_grain(self):
        """A grain that stands for 8 particles has their temperature at every time: the same heat per solid volume. To round-off."""
        fine, _ = self.stream(speed=30.0)
        coarse, _ = self.stream(speed=30.0, plugins="plugin load hertzcgplugin.so\ncoarsegraining 2 model_check warn")
        print(f"particle {fine:.12f} K, grain of 8 {coarse:.12f} K")
        self.assertTrue(305 < fine < 395, fine)
        self.assertLess(abs(fine - coarse), 1e-9)

    def test_drag_of_a_hot_grain(self):
        """Henderson's drag takes the temperature of the grain: as with the ratio stated. The grain keeps its temperature by its heat
        capacity."""
        speed = 2 * gas_box.SOUND
        case = {"speed": speed, "steps": 20, "transonic": True, "diameter": 6e-5, "temperature": 450.0, "specific_heat": 1e9,
                "delta_t": 2e-5, "dem_step": 2e-6}
        _, hot = self.stream(drag="model Henderson;", **case)
        _, cold = self.stream(drag="model Henderson;", **{**case, "temperature": 300.0})
        folder = self.run_gas(steps=20, velocity=f"(0 0 {speed!r})", mu=MU, prandtl=PR, cells="2 2 2", transonic=True, delta_t=2e-5,
                              dem_step=2e-6, grains=([(0.011, 0.012, 0.013)], [(0, 0, 0)]), diameter=6e-5, density=RHO_P,
                              options={"coupling": "oneWay", "drag": None,
                                       "forces": "{ drag { model Henderson; temperatureRatio 1.5; } }"})
        stated = dumps.last(folder / "grains.dump")[1][5]
        print(f"{hot:.9f} m/s at 450 K, {stated:.9f} m/s stated, {cold:.9f} m/s at 300 K")
        self.assertLess(abs(hot - stated), 1e-6 * stated)
        self.assertGreater(abs(hot - cold), 5e-4 * stated)


if __name__ == "__main__":
    unittest.main()
