# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""SaffmanMei, Magnus and fluidTorque in the coupling, against the paths of single particles.

The bound asked for is 0.5 %. Lift is held over a fluid step with the slip at its start, so its error is first
order: half a fluid step over the relaxation time of the slip.
"""
# processors: 4
# label: long

import math
import random
import unittest

import numpy

import grainjet
from grainjet import coupled_box as box, dictionaries, dumps
from grainjet.coupled_box import end_at
from grainjet.spinning import Particle
import shear_flow

FORCE = "f_fluidExplicitForce[1] f_fluidExplicitForce[2] f_fluidExplicitForce[3]"
MOTION = "x y z vx vy vz omegax omegay omegaz"
ALL = "{ drag { model Stokes; } SaffmanMei {} Magnus {} fluidTorque {} }"


def grains(positions, velocities, spins, diameter, density, f_cg=1):
    """Grains whose particles have these spins: the grains turn slower by f_cg."""
    return box.grains(positions, velocities, diameter, density) + "\n" + "\n".join(
        f"set atom {i} omegax {float(w[0]) / f_cg!r} omegay {float(w[1]) / f_cg!r} omegaz {float(w[2]) / f_cg!r}"
        for i, w in enumerate(spins, 1))


class Lift(grainjet.Case):

    def run_grains(self, name, forces, particle, places, velocities, spins=None, *, dump=MOTION, f_cg=1, steps=20,
                   delta_t=1e-4, every=10, ranks=0, shear=None, options=None, write_every=None, decomposition="(1 1 2)",
                   end=True, **fluid):
        """Run grains in a fluid at rest, in a uniform flow or in a linear shear flow; the last dump by atom ID."""
        folder = self.folder / name
        box.write(folder, steps=steps, delta_t=delta_t, cells="4 4 8", nu=particle.nu, ranks=max(ranks, 1),
                  rho=f"rho [1 -3 0 0 0 0 0] {particle.rho!r};", through=bool(shear), write_every=write_every,
                  decomposition=decomposition, **fluid)
        if shear:
            shear_flow.write(folder, shear)
        plugins = f"plugin load hertzcgplugin.so\ncoarsegraining {f_cg} model_check warn" if f_cg > 1 else ""
        columns = dump.count(" ") + 1
        self.dump = f"dump d all custom {every * steps} grains.*.dump id {dump}\n" \
                    'dump_modify d sort id format "%d' + columns * " %.17g" + '"'
        box.script(folder, dt=delta_t / every, plugins=plugins, boundary="f f f" if shear else "p p p", end=self.dump,
                   grains=grains(places, velocities, spins or [(0, 0, 0)] * len(places), particle.diameter,
                                 particle.density, f_cg))
        box.fv_options(folder, **{"coupling": "oneWay", "drag": None, "forces": forces, "couplingInterval": str(every),
                                  **(options or {})})
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.log = self.foam("pimpleFoam", folder, ranks).output
        return folder, {tag: numpy.array(row) for tag, row in dumps.last(folder / f"grains.{every * steps}.dump").items()}

    # ---- Saffman

    def test_saffman_force(self):
        """Force of one fluid step, in u_x = G z with the vorticity (0 G 0): upwards for a grain that lags. Re of 0.01, 7
        and 60, on both sides of 40. The flow is linear, so sampling is exact; 1e-9 is what the solver leaves.
        A grain of f_cg = 2 has the force of 8 particles. The spin of a grain does not enter."""
        shear = 50.0
        p = Particle(6e-5, 2500.0)
        places = [(0.005, 0.006, 0.011), (0.015, 0.004, 0.029), (0.007, 0.004, 0.019)]
        velocities = [(shear * 0.011 - 0.0025, 0, 0), (3.2, 0.3, -0.1), (-14.0, 2, 1)]
        curl = numpy.array([0, shear, 0])
        for f_cg, ranks in ((1, 0), (2, 0), (1, 2)):
            with self.subTest(f_cg=f_cg, ranks=ranks):
                found = self.run_grains(f"{f_cg}-{ranks}", "{ SaffmanMei {} }", p, places, velocities,
                                        [(1e4, -2e4, 3e4)] * 3, dump=FORCE, f_cg=f_cg, ranks=ranks, steps=1, shear=shear)[1]
                for tag, (x, v) in enumerate(zip(places, velocities), 1):
                    exact = f_cg ** 3 * p.saffman(numpy.array([shear * x[2], 0, 0]) - v, curl)
                    size = abs(exact).max()
                    self.assertGreater(size, 1e-14)
                    numpy.testing.assert_allclose(found[tag], exact, rtol=0, atol=1e-9 * size)
                self.assertGreater(found[1][2], 0)

    def test_saffman_path(self):
        """A particle that begins at rest in the shear rises. Its path for 0.15 relaxation times, in fluid steps of 0.4 %
        of one: 0.2 %. Grains of f_cg 2 and 4 move as their particles do, to round-off of f_cg d/f_cg."""
        shear, steps = 500.0, 40
        p = Particle(6e-5, 2500.0)
        place, velocity = (0.005, 0.006, 0.011), (0, 0.1, 0)
        exact = p.path(lambda x: (shear * x[2], 0, 0), place, velocity, (0, 0, 0), steps * 1e-4, curl=(0, shear, 0), saffman=True)
        runs = {}
        for f_cg in (1, 2, 4):
            runs[f_cg] = self.run_grains(f"{f_cg}", "{ drag { model Stokes; } SaffmanMei {} }", p, [place], [velocity],
                                         f_cg=f_cg, steps=steps, shear=shear)[1][1]
            v = runs[f_cg][3:6]
            print(f"\nf_cg {f_cg}: v {v} m/s, exact {exact[1]}")
            for found, wanted in zip(v, exact[1]):
                self.assertLess(abs(found / wanted - 1), 0.003)
            numpy.testing.assert_allclose(runs[f_cg][:6], runs[1][:6], rtol=0, atol=1e-9)
        self.assertGreater(exact[1][2], 0.005)

    # ---- torque

    def test_spin_up_in_shear(self):
        """Spin of particles tends to half of the vorticity, w_y = G/2 (1 - exp(-t/tau)): 1e-6 (whole-step values).
        Grains turn slower by f_cg."""
        shear = 50.0
        p = Particle(6e-5, 2500.0)
        exact = shear / 2 * (1 - math.exp(-2e-3 / p.tau_spin))
        for f_cg, ranks in ((1, 0), (2, 0), (4, 0), (1, 2)):
            found = self.run_grains(f"{f_cg}-{ranks}", "{ fluidTorque {} }", p, [(0.005, 0.006, 0.021)], [(0, 0, 0)],
                                    f_cg=f_cg, ranks=ranks, shear=shear)[1][1]
            w = f_cg * found[6:]
            print(f"\nf_cg {f_cg}: spin {w[1]!r} of {exact!r} 1/s")
            self.assertLess(abs(w[1] / exact - 1), 1e-6)
            self.assertLess(max(abs(w[0]), abs(w[2])), 1e-9 * exact)
            self.assertEqual(list(found[3:6]), [0, 0, 0])

    def test_decay_of_fast_spin(self):
        """Re_W from 1600 to 53 in fluid steps of a fifth of the relaxation time: the factor of the torque, from 3.2 to 1.2,
        is held over each, yet its end is exact. Left is half a DEM step of 1e-3 relaxation times with the factor of the
        fluid step before, at most 0.1 %."""
        p = Particle(1e-3, 2500.0)
        spin, steps = p.spin(1600), 10
        exact = p.decayed(spin, 2 * p.tau_spin)
        for f_cg in (1, 2, 4):
            w = f_cg * self.run_grains(f"{f_cg}", "{ fluidTorque {} }", p, [(0.01, 0.01, 0.02)], [(0, 0, 0)], [(0, 0, spin)],
                                       f_cg=f_cg, steps=steps, delta_t=0.2 * p.tau_spin, every=200)[1][1][6:]
            print(f"\nf_cg {f_cg}: spin {w[2]:.4f} rad/s, exact {exact:.4f}")
            self.assertLess(abs(w[2] / exact - 1), 1.1e-3)
        self.assertGreater(exact * p.diameter ** 2 / p.nu, 50)

    # ---- Magnus

    def test_magnus_path(self):
        """Re 37, Re_W 200, spin that decays, a uniform flow, for 0.4 relaxation times. Lift is of first order in the fluid
        step: 0.5 % of what it does with steps of 0.5 % of a relaxation time, twice as much with 1 %. The same for f_cg
        1, 2 and 4, and in either order of the models."""
        p = Particle(2e-4, 2500.0)
        spin = numpy.array([0.0, 0.6, 0.8]) * p.spin(200)
        place, velocity, end = (0.01, 0.012, 0.02), (0, 1.0, 0), 0.4 * p.tau
        exact = p.path(lambda x: (2.6, 0, 0), place, velocity, spin, end, magnus=True, torque=True)
        without = p.path(lambda x: (2.6, 0, 0), place, velocity, spin, end, torque=True)
        wanted = exact[1] - without[1]
        self.assertGreater(abs(wanted).max(), 0.5)
        runs, errors = {}, []
        for f_cg, forces, steps in ((1, "Magnus {} fluidTorque {}", 40), (1, "Magnus {} fluidTorque {}", 80),
                                    (2, "Magnus {} fluidTorque {}", 80), (4, "Magnus {} fluidTorque {}", 80),
                                    (1, "fluidTorque {} Magnus {}", 80)):
            found = self.run_grains(f"{f_cg}-{forces[0]}-{steps}", f"{{ drag {{ model Stokes; }} {forces} }}", p, [place],
                                    [velocity], [tuple(spin)], f_cg=f_cg, steps=steps, delta_t=end / steps,
                                    velocity="(2.6 0 0)")[1][1]
            v, w = found[3:6], f_cg * found[6:]
            errors.append(abs(v - exact[1]).max() / abs(wanted).max())
            print(f"\nf_cg {f_cg}, {forces}, {steps} steps: v {v} m/s, exact {exact[1]}, without {without[1]}; w {w} rad/s, "
                  f"exact {exact[2]}; error {errors[-1]}")
            self.assertNotIn("forces: Magnus", self.log)
            if steps == 40:
                continue
            self.assertLess(errors[-1], 0.005)
            numpy.testing.assert_allclose(w, exact[2], rtol=1e-3, atol=1e-9)
            runs.setdefault(1, (v, w))
            numpy.testing.assert_allclose(v, runs[1][0], rtol=0, atol=1e-9)
            numpy.testing.assert_allclose(w, runs[1][1], rtol=1e-9, atol=1e-9)
        self.assertAlmostEqual(errors[0] / errors[1], 2, delta=0.2)

    def test_lift_that_exceeds_the_drag(self):
        """A spin that does not decay, lift 1.5 times the drag, fluid steps of 20 relaxation times: as it is the slip would
        grow by a half in each. It is limited, the slip dies out, and the log says so once; and that the spin does not
        decay. In fluid steps of 1 % of a relaxation time there is no limit."""
        p = Particle(2e-5, 2500.0)
        for delta_t, steps, limited in ((20 * p.tau, 20, 1), (0.01 * p.tau, 20, 0)):
            for ranks in (0, 2):
                v = self.run_grains(f"{limited}-{ranks}", "{ drag { model Stokes; } Magnus {} }", p, [(0.01, 0.01, 0.02)],
                                    [(0, 1e-3, 0)], [(0, 0, p.spin(40))], steps=steps, delta_t=delta_t, ranks=ranks)[1][1][3:6]
                self.assertEqual(self.log.count("Magnus exceeds the drag"), limited)
                self.assertEqual(self.log.count("Magnus without fluidTorque"), 1)
                self.assertLess(math.sqrt(v @ v), 1e-8 if limited else 1e-3)

    # ---- ranks, restart, reaction

    def crowd(self, shear):
        """Grains that cross the cuts of the fluid and of LIGGGHTS, too far from each other to touch."""
        rng = random.Random(3)
        x = [(0.01 + rng.uniform(-4e-4, 4e-4), 0.0005 + 0.0005 * i, 0.02 + rng.uniform(-4e-4, 4e-4)) for i in range(38)]
        v = [(shear * 0.02 + rng.uniform(-0.6, 0.6), 0, rng.choice((-1, 1)) * rng.uniform(0.3, 0.6)) for _ in x]
        w = [tuple(rng.uniform(-2e4, 2e4) for _ in range(3)) for _ in x]
        return x, v, w

    def test_same_on_all_ranks(self):
        """1, 2 and 4 ranks. In a fluid at rest bit for bit; in the shear to what the solver leaves."""
        p = Particle(2e-4, 250.0)
        for shear in (None, 50.0):
            found = {}
            for ranks, cuts in ((0, "(1 1 1)"), (2, "(2 1 1)"), (4, "(2 1 2)")):
                found[ranks] = numpy.array(list(self.run_grains(
                    f"{shear}-{ranks}", ALL, p, *self.crowd(shear or 0), ranks=ranks, shear=shear, decomposition=cuts)[1].values()))
            self.assertEqual(len(found[0]), 38)
            for ranks in (2, 4):
                if not shear:
                    numpy.testing.assert_array_equal(found[ranks], found[0])
                numpy.testing.assert_allclose(found[ranks][:, :6], found[0][:, :6], rtol=0, atol=1e-10)
                numpy.testing.assert_allclose(found[ranks][:, 6:], found[0][:, 6:], rtol=0, atol=1e-6)

    def test_restart(self):
        """20 steps in one run and in two, serial and on 2 ranks, two way: bit for bit. The balance closes, so the fluid
        receives the opposite of the lift."""
        p = Particle(2e-4, 250.0)
        for ranks in (0, 2):
            case = dict(ranks=ranks, write_every=10, shear=50.0, options={"coupling": "twoWay"}, decomposition="(2 1 1)")
            whole, one = self.run_grains(f"whole{ranks}", ALL, p, *self.crowd(50), **case)
            parts = self.run_grains(f"parts{ranks}", ALL, p, *self.crowd(50), steps=10, **case)[0]
            script = parts / "constant/in.particles"
            script.write_text(script.read_text().replace("custom 100 ", "custom 200 "))
            end_at(parts, 20)
            self.assertIn("38 continued grains", self.foam("pimpleFoam", parts, ranks).output)
            two = dumps.last(parts / "grains.200.dump")
            self.assertEqual({tag: list(row) for tag, row in one.items()}, {tag: list(row) for tag, row in two.items()})
            self.assertLess(max(box.read_balance(whole)["imbalance"]), 1e-10)

    # ---- no spheres

    def test_terminal_velocity(self):
        """weight less buoyancy = drag at the root of the law as printed. A fluid that stays at rest; the void fraction
        of a cell with one grain is 1 within 1e-5, and 20 relaxation times leave 1e-8."""
        d, density, g = 3e-4, 2500.0, 9.81
        p = Particle(d, density)

        def haider_levenspiel(re, phi):
            a, b = math.exp(2.3288 - 6.4581 * phi + 2.4486 * phi ** 2), 0.0964 + 0.5565 * phi
            c = math.exp(4.905 - 13.8944 * phi + 18.4222 * phi ** 2 - 10.2599 * phi ** 3)
            e = math.exp(1.4681 + 12.2584 * phi - 20.7322 * phi ** 2 + 15.8855 * phi ** 3)
            return 24 / re * (1 + a * re ** b) + c / (1 + e / re)

        def ganser(re, phi):
            k1 = 1 / (1 / 3 + 2 / 3 * phi ** -0.5)
            z = re * k1 * 10 ** (1.8148 * (-math.log10(phi)) ** 0.5743)
            return z / re / k1 * (24 / z * (1 + 0.1118 * z ** 0.6567) + 0.4305 / (1 + 3305 / z))

        for name, law, phi in (("HaiderLevenspiel", haider_levenspiel, 0.67), ("Ganser", ganser, 0.8)):
            low, high = 1e-3, 100.0
            for _ in range(100):
                u = 0.5 * (low + high)
                force = math.pi / 8 * d ** 2 * p.rho * law(u * d / p.nu, phi) * u ** 2
                low, high = (low, u) if force > math.pi / 6 * d ** 3 * (density - p.rho) * g else (u, high)
            steps, delta_t = 100, 0.2 * low / g
            for f_cg in (1, 2):
                folder = self.folder / f"{name}-{f_cg}"
                box.write(folder, steps=steps, delta_t=delta_t, cells="4 4 8")
                box.script(folder, dt=delta_t / 10, gravity=f"fix g all gravity {g} vector 0 0 -1",
                           plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {f_cg} model_check warn",
                           grains=box.grains([(0.012, 0.013, 0.035)], [(0, 0, 0)], d, density),
                           end=f'dump d all custom {10 * steps} grains.*.dump id vz\ndump_modify d format "%d %.17g"')
                box.fv_options(folder, coupling="oneWay", drag=None,
                               forces=f"{{ drag {{ model {name}; sphericity {phi}; }} buoyancy {{}} }}")
                self.foam("blockMesh", folder)
                self.foam("pimpleFoam", folder)
                w = -dumps.last(folder / f"grains.{10 * steps}.dump")[1][0]
                print(f"\n{name}, sphericity {phi}, f_cg {f_cg}: {w:.6f} m/s, root {low:.6f}, Re {low * d / p.nu:.1f}")
                self.assertLess(abs(w / low - 1), 1e-3)


if __name__ == "__main__":
    unittest.main()
