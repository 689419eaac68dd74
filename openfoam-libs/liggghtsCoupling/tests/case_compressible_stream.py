# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A grain in a uniform stream of gas, subsonic to supersonic: its velocity against the exact solution of the drag
law. The law knows no Mach number; what is tested is that density, viscosity and velocity of the gas reach it."""

import unittest

import gas_box
from grainjet import dumps

D, RHO_P, MU = 6e-5, 2500.0, 1.8e-5


def acceleration(slip):
    """Of a lone sphere by Wen and Yu's drag (Weaver and Miskovic 2023, Eqs. 18 to 20)."""
    re = gas_box.RHO0 * slip * D / MU
    cd_re = 24 * (1 + 0.15 * re ** 0.687) if re < 1000 else 0.44 * re
    return 0.75 * MU * cd_re * slip / (RHO_P * D ** 2)


def slip_after(time, start, n=4000):
    """Slip of a grain that is released at rest, by a fourth-order Runge-Kutta integration."""
    w, h = start, time / n
    for _ in range(n):
        k1 = acceleration(w)
        k2 = acceleration(w - h / 2 * k1)
        k3 = acceleration(w - h / 2 * k2)
        k4 = acceleration(w - h * k3)
        w -= h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return w


class Stream(gas_box.GasCase):

    def velocity(self, stream, time, steps, solver, transonic):
        """Velocity of the grain along the stream after a time, for a number of fluid steps."""
        dt = time / steps
        folder = self.run_gas(
            steps=steps, solver=solver, transonic=transonic, velocity=f"(0 0 {stream!r})", delta_t=dt, dem_step=dt / 10,
            mu=MU, cells="2 2 2", grains=([(0.011, 0.012, 0.013)], [(0, 0, 0)]), diameter=D, density=RHO_P,
            options={"coupling": "oneWay"})
        return dumps.last(folder / "grains.dump")[1][5]

    def test_relaxation(self):
        """The time in which most of the slip is gone. Drag coefficients are those of the slip at the beginning of a
        fluid step, so the error is of first order in the step: extrapolated from two steps, 2e-4 of the stream is
        left."""
        for mach, solver, transonic in ((0.1, "rhoPimpleFoam", False), (0.5, "rhoPimpleFoam", True),
                                        (1.0, "rhoPimpleFoam", True), (2.0, "rhoPimpleFoam", True), (2.0, "sonicFoam", True)):
            with self.subTest(mach=mach, solver=solver):
                stream = mach * gas_box.SOUND
                time = float(f"{stream / acceleration(stream):.3g}")
                exact = stream - slip_after(time, stream)
                coarse, fine = (self.velocity(stream, time, n, solver, transonic) for n in (50, 100))
                value = 2 * fine - coarse
                print(f"M {mach} {solver}: {coarse:.4f} {fine:.4f}, extrapolated {value:.4f} m/s, exact {exact:.4f}, "
                      f"off by {(value - exact) / stream:.1e} of the stream")
                self.assertLess(abs(value - exact), 2e-4 * stream)
                self.assertGreater(exact, 0.3 * stream)


if __name__ == "__main__":
    unittest.main()
