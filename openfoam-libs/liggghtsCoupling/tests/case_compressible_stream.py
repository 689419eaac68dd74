# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A grain in a uniform stream of gas, subsonic to supersonic: its velocity against the exact solution of the drag
law. Density, viscosity, velocity, speed of sound and ratio of specific heats of the gas have to reach it."""

import math
import unittest

import bad_case
import gas_box
from gas_box import loth
from grainjet import coupled_box as box, dumps

D, RHO_P, MU = 6e-5, 2500.0, 1.8e-5


def wen_yu(re, mach):
    """Cd Re of a lone sphere by Wen and Yu's drag (Weaver and Miskovic 2023, Eqs. 18 to 20), without Mach number."""
    return 24 * (1 + 0.15 * re ** 0.687) if re < 1000 else 0.44 * re


def henderson(re, mach, t=1.5):
    """Cd Re by Henderson (1976), AIAA J. 14, 707, of particles at t times the temperature of the gas."""
    def low(m):
        s, r = m * (gas_box.GAMMA / 2) ** 0.5, 0.03 * re + 0.48 * re ** 0.5
        return (24 / (re + s * (4.33 + (3.65 - 1.53 * t) / (1 + 0.353 * t) * math.exp(-0.247 * re / s)))
                + math.exp(-0.5 * m / re ** 0.5) * ((4.5 + 0.38 * r) / (1 + r) + 0.1 * m ** 2 + 0.2 * m ** 8)
                + 0.6 * s * (1 - math.exp(-m / re)))

    def high(m):
        s, layer = m * (gas_box.GAMMA / 2) ** 0.5, 1.86 * (m / re) ** 0.5
        return (0.9 + 0.34 / m ** 2 + layer * (2 + 2 / s ** 2 + 1.058 / s * t ** 0.5 - 1 / s ** 4)) / (1 + layer)
    share = min(max((mach - 1) / 0.75, 0), 1)
    return re * ((1 - share) * low(min(mach, 1)) + share * high(max(mach, 1.75)))


def acceleration(slip, law):
    """Of the grain, by a law for Cd Re."""
    re = gas_box.RHO0 * slip * D / MU
    return 0.75 * MU * law(re, slip / gas_box.SOUND) * slip / (RHO_P * D ** 2)


def slip_after(time, start, law, n=4000):
    """Slip of a grain that is released at rest, by a fourth-order Runge-Kutta integration."""
    w, h = start, time / n
    for _ in range(n):
        k1 = acceleration(w, law)
        k2 = acceleration(w - h / 2 * k1, law)
        k3 = acceleration(w - h / 2 * k2, law)
        k4 = acceleration(w - h * k3, law)
        w -= h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return w


class Stream(gas_box.GasCase):

    def velocity(self, stream, time, steps, solver, transonic, drag=None):
        """Velocity of the grain along the stream after a time, for a number of fluid steps."""
        dt = time / steps
        folder = self.run_gas(
            steps=steps, solver=solver, transonic=transonic, velocity=f"(0 0 {stream!r})", delta_t=dt, dem_step=dt / 10,
            mu=MU, cells="2 2 2", grains=([(0.011, 0.012, 0.013)], [(0, 0, 0)]), diameter=D, density=RHO_P,
            options={"coupling": "oneWay", **({"drag": None, "forces": f"{{ drag {{ {drag} }} }}"} if drag else {})})
        return dumps.last(folder / "grains.dump")[1][5]

    def check(self, mach, solver, transonic, law, drag=None):
        """The time in which most of the slip is gone. Drag coefficients are those of the slip at the beginning of a
        fluid step, so the error is of first order in the step: extrapolated from two steps, 2e-4 of the stream is
        left."""
        with self.subTest(mach=mach, solver=solver, drag=drag):
            stream = mach * gas_box.SOUND
            time = float(f"{stream / acceleration(stream, law):.3g}")
            exact = stream - slip_after(time, stream, law)
            coarse, fine = (self.velocity(stream, time, n, solver, transonic, drag) for n in (50, 100))
            value = 2 * fine - coarse
            print(f"M {mach} {solver} {drag or ''}: {coarse:.4f} {fine:.4f}, extrapolated {value:.4f} m/s, exact {exact:.4f}, "
                  f"off by {(value - exact) / stream:.1e} of the stream")
            self.assertLess(abs(value - exact), 2e-4 * stream)
            self.assertGreater(exact, 0.3 * stream)

    def test_relaxation(self):
        for mach, solver, transonic in ((0.1, "rhoPimpleFoam", False), (0.5, "rhoPimpleFoam", True),
                                        (1.0, "rhoPimpleFoam", True), (2.0, "rhoPimpleFoam", True), (2.0, "sonicFoam", True)):
            self.check(mach, solver, transonic, wen_yu)

    def test_drag_at_speed(self):
        """Laws that know the Mach number, through their changes of form at M 0.8, 1 and 1.5. They jump there by some
        0.1 to 1 % at this Reynolds number, which the extrapolation does not see as a jump: within the same error."""
        self.check(0.5, "rhoPimpleFoam", True, loth, "model Loth;")
        self.check(1.7, "sonicFoam", True, loth, "model Loth;")
        self.check(2.0, "rhoPimpleFoam", True, henderson, "model Henderson; temperatureRatio 1.5;")


class NoGas(bad_case.BadCase):
    """Laws that need a speed of sound where there is none: one message that says what to do."""

    def prepare(self, write, **options):
        folder = self.new_folder()
        write(folder, **options)
        box.script(folder, grains=box.grains([(0.011, 0.012, 0.013)], [(0, 0, 0)], D, RHO_P), dt=1e-5)
        box.fv_options(folder, drag=None, forces="{ drag { model Loth; } }")
        self.foam("blockMesh", folder)
        return folder

    def test_incompressible(self):
        self.assertRefused(self.prepare(box.write), "speed of sound", "rhoPimpleFoam", "drag law without Mach number", steps=True)

    def test_liquid(self):
        folder = self.prepare(gas_box.write, gas="rhoConst", gas_density=1000.0)
        self.assertRefused(folder, "equationOfState in constant/thermophysicalProperties", "perfectGas", solver="rhoPimpleFoam",
                           steps=True)


if __name__ == "__main__":
    unittest.main()
