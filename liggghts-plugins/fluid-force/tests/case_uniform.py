# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/force uniform in stock LIGGGHTS: terminal velocity, relaxation, stiff drag,
coarse graining, buoyancy, spin, order of fixes.

The bounds asked of this fix are 0.5 %. Where the integration is exact the tests assert
round-off instead; every other tolerance states where it comes from.
"""
# processors: 1

import math
import unittest

import numpy

import grainjet
from grainjet import tables

RHO, NU = 1.2, 1.5e-5           # air
GRAIN = 2950.0                  # kg/m3
G = 9.81


def cd_re_over_24(re):
    """Schiller-Naumann with Newton's branch, Cd Re / 24."""
    return 1 + 0.15 * re ** 0.687 if re < 1000 else 0.44 * re / 24


def drag_per_volume(slip, d):
    return 18 * RHO * NU / d ** 2 * cd_re_over_24(slip * d / NU) * slip


def root(function, low, high):
    """Bisection to the last digit."""
    for _ in range(200):
        middle = 0.5 * (low + high)
        if function(middle) > 0:
            high = middle
        else:
            low = middle
    return 0.5 * (low + high)


def tau_stokes(d):
    return GRAIN * d ** 2 / (18 * RHO * NU)


class Uniform(grainjet.Case):

    def grain(self, fluid, d, dt, steps, output, before="", after="", cg=None, velocity=(0, 0, 0),
              more="", gravity=G):
        """One grain in a large box; returns the table of thermo output, one row per time:
        step, vx, vy, vz, fx, fy, fz, slip, omega z."""
        grain = f"plugin load hertzcgplugin.so\ncoarsegraining {cg}\n" if cg else ""
        script = f"""
            plugin load fluidforceplugin.so
            atom_style granular
            atom_modify map array sort 0 0
            boundary f f f
            newton off
            communicate single vel yes
            units si
            region box block -1e6 1e6 -1e6 1e6 -1e6 1e6 units box
            create_box 1 box
            neighbor 1e5 bin
            create_atoms 1 single 0 0 0 units box
            {grain}
            set group all diameter {d!r} density {GRAIN}   # times f_cg, as `set` does
            velocity all set {velocity[0]!r} {velocity[1]!r} {velocity[2]!r} units box
            timestep {dt!r}
            {before}
            fix f all fluid/force uniform {fluid}
            {after}
            fix g all gravity {gravity} vector 0 0 -1
            fix i all nve/sphere
            variable vx equal vx[1]
            variable vy equal vy[1]
            variable vz equal vz[1]
            variable wz equal omegaz[1]
            {more}
            thermo_style custom step v_vx v_vy v_vz f_f[1] f_f[2] f_f[3] f_f[4] v_wz
            thermo_modify format float %.17g lost error
            thermo {output}
            run {steps}
        """
        return numpy.array(tables.thermo(self.liggghts(script).output))

    def test_terminal_velocity(self):
        """v settles where drag = weight - buoyancy. The scheme's fixed point is that root, so
        what is left is exp(-t/tau) of the run's length: more than 25 tau, below 1e-9."""
        seen = []
        for d in (20e-6, 80e-6, 500e-6, 4e-3):
            weight = (GRAIN - RHO) * G
            exact = root(lambda u: drag_per_volume(u, d) - weight, 1e-9, 100)
            tau = GRAIN * exact / drag_per_volume(exact, d)
            rows = self.grain(f"3 0 0 density {RHO} viscosity {NU} drag schillerNaumann buoyancy yes",
                              d, tau / 50, 3000, 3000)
            self.assertAlmostEqual(-rows[-1, 3] / exact, 1, delta=1e-8)
            self.assertAlmostEqual(rows[-1, 1], 3, delta=1e-8)
            self.assertAlmostEqual(rows[-1, 7] / exact, 1, delta=1e-8)
            seen.append(exact * d / NU)
        self.assertLess(seen[0], 0.1)        # the four cover Stokes to Newton
        self.assertGreater(seen[-1], 1000)

    def test_relaxation_stokes(self):
        """v = u (1 - exp(-t/tau)). Half-step velocities are exact; the whole-step one printed is
        the mean of two of them, off by a factor cosh(dt/2tau) in the slip, and exactly that."""
        d = 80e-6
        tau = tau_stokes(d)
        for ratio in (100, 10):
            dt = tau / ratio
            rows = self.grain(f"2 -1 0 density {RHO} viscosity {NU} drag stokes", d, dt,
                              5 * ratio, ratio // 10, gravity=0)
            slip = numpy.exp(-rows[1:, 0] / ratio) * math.cosh(0.5 / ratio)
            numpy.testing.assert_allclose(rows[1:, 1], 2 * (1 - slip), rtol=0, atol=1e-12)
            numpy.testing.assert_allclose(rows[1:, 2], -1 * (1 - slip), rtol=0, atol=1e-12)
            exact = 2 * (1 - numpy.exp(-rows[1:, 0] / ratio))
            self.assertLess(abs(rows[1:, 1] - exact).max() / 2, 0.005)

    def test_relaxation_schiller_naumann(self):
        """Against a Runge-Kutta solution with a hundredth of the step. Second order: the error
        falls by four (between 3 and 5.5, asymptotic only) when the step is halved."""
        d, u = 300e-6, 10.0
        steps = 40
        end = 0.3 * tau_stokes(d)
        slope = lambda v: drag_per_volume(abs(u - v), d) * math.copysign(1, u - v) / GRAIN
        v, h = 0.0, end / (100 * steps)
        for _ in range(100 * steps):
            k1 = slope(v)
            k2 = slope(v + 0.5 * h * k1)
            k3 = slope(v + 0.5 * h * k2)
            k4 = slope(v + h * k3)
            v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        errors = []
        for n in (steps, 2 * steps, 4 * steps):
            rows = self.grain(f"{u} 0 0 density {RHO} viscosity {NU} drag schillerNaumann", d,
                              end / n, n, n, gravity=0)
            errors.append(abs(rows[-1, 1] / v - 1))
        self.assertLess(errors[0], 0.005)
        for coarse, fine in zip(errors, errors[1:]):
            self.assertTrue(3 < coarse / fine < 5.5, errors)

    def test_drag_far_faster_than_the_step(self):
        """tau = 1e-3 dt: half-step velocity u + g tau from the second step on, never beyond."""
        d, dt = 1e-6, None
        tau = tau_stokes(d)
        dt = 1e3 * tau
        rows = self.grain(f"1 0 0 density {RHO} viscosity {NU} drag stokes", d, dt, 20, 1)
        self.assertTrue((rows[1:, 1] <= 1 + 1e-12).all())
        numpy.testing.assert_allclose(rows[2:, 1], 1, rtol=0, atol=1e-12)
        numpy.testing.assert_allclose(rows[2:, 3], -G * tau, rtol=1e-9)

    def test_newton_drag_far_faster_than_the_step(self):
        """Where drag goes with the square of the slip, a coefficient frozen at the old slip
        would oscillate for ever at such a step."""
        d = 4e-3
        exact = root(lambda u: drag_per_volume(u, d) - GRAIN * G, 1e-9, 100)
        tau = exact / G
        rows = self.grain(f"0 0 0 density {RHO} viscosity {NU} drag schillerNaumann", d,
                          1e3 * tau, 20, 1, velocity=(0, 0, -5.0))
        numpy.testing.assert_allclose(-rows[-10:, 3], exact, rtol=1e-9)

    def test_same_for_every_coarse_graining(self):
        """Diameter of the original particle: the path of a grain is its particles' path. What
        differs is rounding of f_cg d / f_cg, some 1e-15 per step."""
        d = 80e-6
        runs = [self.grain(f"2 0 0.5 density {RHO} viscosity {NU} buoyancy yes", d, 1e-4, 2000, 500,
                           cg=cg, velocity=(0, 1.0, 0)) for cg in (None, 2, 3.5)]
        force = [numpy.abs(r[1:, 4:7]).max() for r in runs]
        for rows, f, cg in zip(runs[1:], force[1:], (2, 3.5)):
            numpy.testing.assert_allclose(rows[:, 1:4], runs[0][:, 1:4], rtol=0, atol=1e-11)
            self.assertAlmostEqual(f / force[0] / cg ** 3, 1, delta=1e-11)

    def test_buoyancy_floats(self):
        """A grain as dense as the fluid stays where it is; without drag's help, to round-off."""
        rows = self.grain(f"0 0 0 density {GRAIN} viscosity 1e-6 drag stokes buoyancy yes",
                          80e-6, 1e-4, 1000, 1000)
        self.assertLess(abs(rows[-1, 3]), 1e-12)

    def test_spin(self):
        """omega decays as exp(-60 mu t / (rho d^2)), d that of the original particle; whole-step
        values carry the factor cosh(dt/2tau) as velocities do."""
        d = 80e-6
        tau = GRAIN * d ** 2 / (60 * RHO * NU)
        for cg in (None, 2):
            rows = self.grain(f"0 0 0 density {RHO} viscosity {NU} rotation yes", d, tau / 20, 60, 20,
                              cg=cg, more="set group all omegaz 100", gravity=0)
            numpy.testing.assert_allclose(
                rows[1:, 8], 100 * numpy.exp(-rows[1:, 0] / 20) * math.cosh(1 / 40), rtol=1e-10)
        rows = self.grain(f"0 0 0 density {RHO} viscosity {NU}", d, tau / 20, 60, 20,
                          more="set group all omegaz 100", gravity=0)
        self.assertEqual(rows[-1, 8], 100)

    def test_order_of_fixes_does_not_matter(self):
        """Gravity before or after the fluid force: the same, to the rounding of one
        subtraction at the first step."""
        fluid = f"2 0 0 density {RHO} viscosity {NU} buoyancy yes"
        extra = "fix e all addforce 1e-9 0 -2e-9"
        late = self.grain(fluid, 80e-6, 1e-4, 300, 50, after=extra)
        early = self.grain(fluid, 80e-6, 1e-4, 300, 50, before=extra)
        numpy.testing.assert_allclose(late[1:], early[1:], rtol=1e-12)


if __name__ == "__main__":
    unittest.main()
