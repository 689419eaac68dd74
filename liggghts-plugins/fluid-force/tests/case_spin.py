# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/force uniform: spin that decays, Magnus' lift, drag of particles that are no spheres.

The bound asked for is 0.5 %; the tests assert what the scheme reaches, second order in the step, and say why.
"""
# processors: 2

import math
import unittest

import numpy

from fluid_case import BOX, FluidCase
from grainjet import dumps, scripts
from grainjet.spinning import Particle, magnus_factor, schiller_naumann

RHO, NU = 1.2, 1.5e-5           # air
GRAIN = 2950.0                  # kg/m3
G = 9.81
D = 300e-6
P = Particle(D, GRAIN, RHO, NU)
TAU, TAU_SPIN = P.tau, P.tau_spin


def path(wind, velocity, spin, end, gravity=0.0, n=20000):
    """Velocity and spin of the particle after a time."""
    return P.path(lambda x: wind, (0, 0, 0), velocity, spin, end, n, gravity=(0, 0, -gravity), drag=schiller_naumann,
                  magnus=True, torque=True)[1:]


class Spin(FluidCase):

    def grain(self, fluid, dt, steps, spin, velocity=(0, 0, 0), cg=1, gravity=0.0, d=D):
        """One grain of cg^3 particles of the given spin (rad/s) and velocity. Its final velocity, and spin times cg."""
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
            plugin load hertzcgplugin.so
            coarsegraining {cg}
            set group all diameter {d!r} density {GRAIN}   # times f_cg, as `set` does
            set group all omegax {spin[0] / cg!r} omegay {spin[1] / cg!r} omegaz {spin[2] / cg!r}
            velocity all set {velocity[0]!r} {velocity[1]!r} {velocity[2]!r} units box
            timestep {dt!r}
            fix f all fluid/force uniform {fluid}
            fix g all gravity {gravity} vector 0 0 -1
            fix i all nve/sphere
            {scripts.dump(steps, "end", "id vx vy vz omegax omegay omegaz")}
            run {steps}
        """
        self.liggghts(script)
        row = dumps.last(self.folder / "end")[1]
        return numpy.array(row[:3]), cg * numpy.array(row[3:])

    AIR = f"density {RHO} viscosity {NU}"

    # ---- torque

    def test_decay_of_fast_spin(self):
        """sqrt(w) = A y0 e/(A + B y0 (1 - e)), e = exp(-A t/2 tau): exact between half steps; the whole-step spin
        printed is the mean of two of them, 1e-6 off here. Re_W from 1600 to 60, for all coarse grainings alike."""
        spin = P.spin(1600)
        end, n = 2 * TAU_SPIN, 4000
        exact = P.decayed(spin, end)
        self.assertGreater(exact * D ** 2 / NU, 50)
        for cg in (1, 2, 4):
            w = self.grain(f"0 0 0 {self.AIR} rotation yes", end / n, n, (0, spin, 0), cg=cg)[1]
            print(f"\nf_cg {cg}: spin {w[1]:.6f} rad/s, exact {exact:.6f}")
            self.assertLess(abs(w[1] / exact - 1), 2e-6)
            self.assertEqual((w[0], w[2]), (0, 0))

    def test_slow_spin_is_as_before(self):
        """Below Re_W 31.7 the exponential of Stokes' torque, to round-off but for cosh(dt/2 tau)."""
        spin = P.spin(30)
        w = self.grain(f"0 0 0 {self.AIR} rotation yes", TAU_SPIN / 20, 40, (0, 0, spin))[1]
        self.assertAlmostEqual(w[2] / (spin * math.exp(-2) * math.cosh(1 / 40)), 1, delta=1e-10)

    def test_fast_spin_in_long_steps(self):
        """Steps of 0.75 tau: half-step spins lie on the closed form, and the one printed is the mean of two."""
        spin, step = P.spin(1000), 0.75 * TAU_SPIN
        half = [P.decayed(spin, step / 2)]
        for _ in range(2):
            half.append(P.decayed(half[-1], step))
        self.assertGreater(half[-1] * D ** 2 / NU, 32)
        w = self.grain(f"0 0 0 {self.AIR} rotation yes", step, 2, (0, 0, spin))[1]
        self.assertAlmostEqual(w[2] / (0.5 * (half[1] + half[2])), 1, delta=1e-10)

    # ---- Magnus

    def test_magnus_spiral(self):
        """Stokes' drag and a constant spin: s = s0 exp(-t/tau) turned by 3/4 rho/rho_p C w t. Re and Re_W of 1e-3,
        where C is 1 within 0.1 %; the sideways velocity within 0.2 %."""
        speed = 1e-3 * NU / D
        spin = P.spin(1e-3)
        end, n = TAU, 1000
        turn = 0.75 * RHO / GRAIN * spin * end
        exact = math.exp(-1) * speed * math.sin(turn)
        v = self.grain(f"0 0 0 {self.AIR} drag stokes magnus yes", end / n, n, (0, 0, spin), velocity=(speed, 0, 0))[0]
        print(f"\nsideways {v[1]!r} m/s, exact {exact!r}")
        self.assertAlmostEqual(v[0] / (speed * math.exp(-1)), 1, delta=1e-6)
        self.assertAlmostEqual(v[1] / exact, 1, delta=2e-3)      # w x v: z x x = y

    def test_magnus_with_torque(self):
        """Re 160, Re_W 500, a spin that decays on both sides of the switch: against Runge-Kutta. Second order: 1e-5
        at 1000 steps. The same for all coarse grainings, to round-off of f_cg d/f_cg."""
        wind = numpy.array([8.0, 0, 0])
        spin = numpy.array([0, 0.6, 0.8]) * P.spin(500)
        end = 0.5 * TAU
        velocity, turn = path(wind, (0, 1, 0), spin, end, G)
        runs = {}
        for cg in (1, 2, 4):
            v, w = runs[cg] = self.grain(f"8 0 0 {self.AIR} drag schillerNaumann rotation yes magnus yes", end / 1000, 1000,
                                         spin, velocity=(0, 1.0, 0), cg=cg, gravity=G)
            print(f"\nf_cg {cg}: v {v} m/s, exact {velocity}; w {w}, exact {turn}")
            numpy.testing.assert_allclose(v, velocity, rtol=0, atol=1e-5 * 8)
            numpy.testing.assert_allclose(w, turn, rtol=2e-5, atol=1e-9)
            numpy.testing.assert_allclose(v, runs[1][0], rtol=0, atol=1e-11)
            numpy.testing.assert_allclose(w, runs[1][1], rtol=1e-11)
        self.assertGreater(abs(velocity[1] - path(wind, (0, 1, 0), 0 * spin, end, G, n=2000)[0][1]), 0.05)

    def test_magnus_is_of_second_order(self):
        wind, spin, end = numpy.array([8.0, 0, 0]), numpy.array([0, 0, P.spin(300)]), 0.3 * TAU
        exact = path(wind, (0, 0, 0), spin, end)[0]
        errors = []
        for n in (40, 80, 160):
            v = self.grain(f"8 0 0 {self.AIR} drag schillerNaumann rotation yes magnus yes", end / n, n, spin)[0]
            errors.append(abs(v[1] - exact[1]) / abs(exact[1]))
        print(f"\nerrors of the sideways velocity {errors}")
        self.assertLess(errors[0], 0.005)
        for coarse, fine in zip(errors, errors[1:]):
            self.assertTrue(3 < coarse / fine < 5.5, errors)

    def test_magnus_at_any_step(self):
        """A spin that does not decay, lift 1.5 times the drag, steps of 1000 tau: the steady state
        drag s + 3/4 rho/rho_p C tau (-w) x s = - g tau at once, where an explicit lift would grow for ever."""
        d = 20e-6
        small = Particle(d, GRAIN, RHO, NU)
        tau, spin = small.tau, small.spin(40)
        v = self.grain(f"0 0 0 {self.AIR} drag stokes magnus yes", 1000 * tau, 30, (0, spin, 0), gravity=G, d=d)[0]
        speed = math.sqrt(v @ v)
        ratio = 0.75 * RHO / GRAIN * tau * spin * magnus_factor(speed * d / NU, 40.0)
        self.assertGreater(ratio, 1.2)
        # s = - v; s + ratio (-y) x s = g tau z: sx = ratio sz, sz + ratio sx = g tau
        exact = numpy.array([-ratio, 0, -1]) * G * tau / (1 + ratio ** 2)
        print(f"\nv {v} m/s, exact {exact}")
        numpy.testing.assert_allclose(v, exact, rtol=1e-6, atol=1e-9 * speed)

    def test_same_on_all_ranks(self):
        """2000 grains that spin and cross the ranks: bit for bit."""
        fix = f"fix f all fluid/force uniform 8 1 -1 {self.AIR} drag ganser sphericity 0.8 rotation yes magnus yes"
        columns = "id vx vy vz omegax omegay omegaz"
        results = []
        for ranks in (1, 2, 4):
            self.liggghts(self.head() + BOX + self.CLOUD + f"""
                variable wz atom 1e4*sin(4*id)
                set group all omegaz v_wz omegax 2e3
                {fix}
                fix i all nve/sphere
                {scripts.dump(200, f"end.{ranks}", columns)}
                run 200
            """, ranks)
            results.append(dumps.array(self.folder / f"end.{ranks}"))
        numpy.testing.assert_array_equal(results[0], results[1])
        numpy.testing.assert_array_equal(results[0], results[2])

    # ---- no spheres

    def test_terminal_velocity(self):
        """weight = drag at the root of the law as printed, from 20 um to 4 mm and three shapes. The scheme's fixed point
        is the root: 25 tau leave below 1e-9."""
        def haider_levenspiel(re, phi):
            a, b = math.exp(2.3288 - 6.4581 * phi + 2.4486 * phi ** 2), 0.0964 + 0.5565 * phi
            c = math.exp(4.905 - 13.8944 * phi + 18.4222 * phi ** 2 - 10.2599 * phi ** 3)
            d = math.exp(1.4681 + 12.2584 * phi - 20.7322 * phi ** 2 + 15.8855 * phi ** 3)
            return 24 / re * (1 + a * re ** b) + c / (1 + d / re)

        def ganser(re, phi):
            k1 = 1 / (1 / 3 + 2 / 3 * phi ** -0.5)
            k2 = 10 ** (1.8148 * (-math.log10(phi)) ** 0.5743)
            z = re * k1 * k2
            return k2 * (24 / z * (1 + 0.1118 * z ** 0.6567) + 0.4305 / (1 + 3305 / z))

        for name, law in (("haiderLevenspiel", haider_levenspiel), ("ganser", ganser)):
            for d, phi in ((20e-6, 0.9), (300e-6, 0.67), (4e-3, 0.4)):
                def force(u):
                    return math.pi / 8 * d ** 2 * RHO * law(u * d / NU, phi) * u ** 2
                weight = math.pi / 6 * d ** 3 * (GRAIN - RHO) * G
                low, high = 1e-9, 100.0
                for _ in range(200):
                    middle = 0.5 * (low + high)
                    low, high = (low, middle) if force(middle) > weight else (middle, high)
                tau = low / G
                v = self.grain(f"0 0 0 {self.AIR} drag {name} sphericity {phi} buoyancy yes", tau / 50, 3000, (0, 0, 0), gravity=G,
                               d=d)[0]
                print(f"\n{name}, sphericity {phi}, d {d}: {-v[2]:.8f} m/s, root {low:.8f}, Re {low * d / NU:.3g}")
                self.assertAlmostEqual(-v[2] / low, 1, delta=1e-8)


if __name__ == "__main__":
    unittest.main()
