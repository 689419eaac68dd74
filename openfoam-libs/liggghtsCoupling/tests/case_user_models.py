# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The models of the library in tests/userModels, which a user could have written, one by one against
what is known. docs/new_model.md explains that library."""
# processors: 2

import math
import unittest

import grainjet
from grainjet import coupled_box as box, dumps
import shear_flow
import user_library

RHO, NU, RHO_P = 1.2, 1.5e-5, 2500.0
MU = RHO * NU
D = 6e-5
MASS = RHO_P * math.pi / 6 * D ** 3
SHEAR = 50.0                    # 1/s, of the flow between two walls
V0 = (0.1, -0.05, 0.2)


class Models(grainjet.Case):

    @classmethod
    def setUpClass(cls):
        cls.libs = user_library.libs("userModels")

    def run_grains(self, name, forces, *, dump, grains=None, f_cg=1, steps=20, dt=1e-5, ranks=0,
                   density=RHO_P, flow=None, options=None, **fluid):
        """Run grains in a fluid at rest or in another flow; returns the last dump."""
        folder = self.folder / name
        box.write(folder, steps=steps, delta_t=10 * dt, libs=self.libs, cells="4 4 8", **fluid)
        if flow:
            flow(folder)
        plugins = ("plugin load hertzcgplugin.so\n"
                   f"coarsegraining {f_cg} model_check warn" if f_cg > 1 else "")
        columns = dump.count(" ") + 1
        x, v = grains or ([(0.012, 0.013, 0.021)], [V0])
        box.script(folder, dt=dt, plugins=plugins, boundary="f f f" if flow else "p p p",
                   grains=box.grains(x, v, D, density),
                   end=f"dump d all custom {10 * steps} grains.*.dump id {dump}\n"
                       'dump_modify d sort id format "%d' + columns * " %.17g" + '"')
        box.fv_options(folder, **{"coupling": "oneWay", "drag": None, "forces": forces, **(options or {})})
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.log = self.foam("pimpleFoam", folder, ranks).output
        return dumps.last(folder / f"grains.{10 * steps}.dump")

    def shear(self, folder, temperature=None):
        shear_flow.write(folder, SHEAR, temperature)

    # ---- drag law with a coefficient

    def test_drag_law(self):
        """v = v0 exp(-t/tau) with tau = rho_p d^2/(factor 18 mu), to 1e-7: LIGGGHTS prints the mean of
        two half-step velocities, cosh(dt/2 tau) - 1 = 4e-8 too high. Grains like their particles."""
        rate = 1.5 * 18 * MU / (RHO_P * D ** 2)
        for f_cg in (1, 4):
            with self.subTest(f_cg=f_cg):
                v = self.run_grains(f"{f_cg}", "{ drag { model scaledStokes; factor 1.5; } }",
                                    dump="vx vy vz", f_cg=f_cg)[1]
                self.assertIn("Forces: drag (scaledStokes)", self.log)
                self.assertGreater(rate * 2e-3, 0.1)
                for a, b in zip(v, V0):
                    self.assertLess(abs(a / (b * math.exp(-rate * 2e-3)) - 1), 1e-7)

    # ---- force from curl U

    def test_lift(self):
        """In u_x = G z the vorticity is (0 G 0): f = C d^2 sqrt(rho mu/G) (u - v) x w, upwards for a grain
        that lags. The flow is linear, so sampling is exact; 1e-9 is what the solver leaves of it.
        A grain of f_cg = 2 has the force of 8 particles."""
        x = [(0.005, 0.006, 0.011), (0.015, 0.004, 0.029)]
        v = [(0, 0, 0), (2.0, 0.3, -0.1)]
        scale = 1.615 * D ** 2 * math.sqrt(RHO * MU / SHEAR)
        for f_cg, ranks in ((1, 0), (2, 0), (1, 2)):
            with self.subTest(f_cg=f_cg, ranks=ranks):
                found = self.run_grains(
                    f"{f_cg}-{ranks}", "{ shearLift { C 1.615; } }", grains=(x, v), f_cg=f_cg, ranks=ranks,
                    dump="f_fluidExplicitForce[1] f_fluidExplicitForce[2] f_fluidExplicitForce[3]",
                    steps=1, flow=self.shear, through=True)
                for tag, (place, speed) in enumerate(zip(x, v), 1):
                    slip = (SHEAR * place[2] - speed[0], -speed[1], -speed[2])
                    cross = (-slip[2] * SHEAR, 0, slip[0] * SHEAR)
                    largest = scale * f_cg ** 3 * math.hypot(*cross)
                    self.assertGreater(largest, 1e-13)
                    for a, b in zip(found[tag], cross):
                        self.assertAlmostEqual(a, f_cg ** 3 * scale * b, delta=1e-9 * largest)

    # ---- force with state

    def test_memory(self):
        """Fluid at rest: m dv/dt = -c (v + h), 2 T dh/dt = -v - h, a linear system. With the slip held over
        a fluid step the error is first order: it halves with the step. What a grain remembers is seen in
        its explicit force, - c h, of the beginning of the last step. A light grain, which the force slows
        down by a tenth."""
        time, t_end, density = 1e-3, 2e-3, 250.0
        c = 1.5 * D ** 2 * RHO * math.sqrt(math.pi * NU) * math.sqrt(math.e / time)
        a, b = c / (MASS * density / RHO_P), 1 / (2 * time)

        def exact(t, n=20000):
            v, h, dt = V0[2], 0.0, t / n
            for _ in range(n):
                # midpoint rule: its error, (dt b)^2, is 1e-9 here
                vm, hm = v - dt / 2 * a * (v + h), h - dt / 2 * b * (v + h)
                v, h = v - dt * a * (vm + hm), h - dt * b * (vm + hm)
            return v, h

        errors = []
        for steps in (20, 40):
            v, force = self.run_grains(f"{steps}", f"{{ memoryForce {{ time {time}; }} }}", steps=steps,
                                       dt=t_end / steps / 10, density=density, dump="vz f_fluidExplicitForce[3]")[1]
            wanted = exact(t_end)[0], exact(t_end * (1 - 1 / steps))[1]
            found = v, -force / c
            print(f"\nmemory: v and h found {found}, exact {wanted}")
            # relative to the change by the force; first order, below dt/(3 T)
            change = V0[2] - wanted[0]
            errors.append((found[0] - wanted[0]) / change)
            self.assertLess(abs(errors[-1]), t_end / steps / time / 3)
            self.assertLess(abs(found[1] / wanted[1] - 1), 0.005)
        self.assertGreater(change, 0.09 * V0[2])
        self.assertLess(wanted[1], -0.5 * V0[2])
        self.assertAlmostEqual(errors[0] / errors[1], 2, delta=0.1)

    def test_memory_of_a_grain(self):
        """A grain of f_cg = 4 remembers and moves like its particles, to round-off."""
        particle, grain = (
            self.run_grains(f"{f_cg}", "{ memoryForce { time 1e-3; } }", f_cg=f_cg,
                            dump="vx vy vz f_fluidExplicitForce[1]")[1] for f_cg in (1, 4))
        self.assertNotEqual(particle[3], 0)
        self.assertAlmostEqual(grain[3] / particle[3], 64, delta=1e-10)
        for p, q in zip(particle[:3], grain[:3]):
            self.assertAlmostEqual(p, q, delta=1e-13)

    # ---- given response time

    def test_relaxation(self):
        """v = v0 exp(-t/time), with and without reaction alike, as no fluid feels it."""
        for reaction in ("yes", "no"):
            with self.subTest(reaction=reaction):
                v = self.run_grains(reaction, f"{{ relaxation {{ time 5e-3; reaction {reaction}; }} }}",
                                    dump="vx vy vz")[1]
                for a, b in zip(v, V0):
                    # cosh(dt/2 tau) - 1 = 5e-7
                    self.assertLess(abs(a / (b * math.exp(-0.4)) - 1), 1e-6)

    # ---- torque

    def test_torque(self):
        """Spin tends to that of the fluid, half of its vorticity: w_y = G/2 (1 - exp(-t/tau)) with
        tau = rho_p d^2/(60 mu); grains turn slower by f_cg. To 1e-6: steps of 1e-5 s, tau of 8e-3 s, and
        LIGGGHTS prints the mean of two half steps."""
        tau = RHO_P * D ** 2 / (60 * MU)
        x, v = [(0.005, 0.006, 0.021), (0.015, 0.014, 0.009)], [(0, 0, 0)] * 2
        exact = SHEAR / 2 * (1 - math.exp(-2e-3 / tau))
        for f_cg, ranks in ((1, 0), (4, 0), (1, 2)):
            with self.subTest(f_cg=f_cg, ranks=ranks):
                found = self.run_grains(
                    f"{f_cg}-{ranks}", "{ viscousTorque {} }", grains=(x, v), f_cg=f_cg, ranks=ranks,
                    dump="omegax omegay omegaz vx vy vz", flow=self.shear, through=True)
                for row in found.values():
                    print(f"\nspin {f_cg * row[1]!r} of {exact!r} 1/s")
                    self.assertLess(abs(f_cg * row[1] / exact - 1), 1e-6)
                    self.assertLess(max(abs(row[0]), abs(row[2])), 1e-9 * exact)
                    self.assertEqual(row[3:], [0, 0, 0])

    # ---- own fluid quantity

    def test_thermophoresis(self):
        """T is linear in z: f_z = - K d rho nu^2 (dT/dz)/T exactly, from the library's own quantity gradT.
        T comes from stock scalarTransport; 1e-9 is what its solver leaves."""
        low, high, z = 300.0, 400.0, 0.0113
        transport = ('temperature { type scalarTransport; libs ("libsolverFunctionObjects.so"); '
                     'field T; D 1e-5; nCorr 0; }')
        found = self.run_grains(
            "0", "{ thermophoresis { K 0.5; } }", grains=([(0.005, 0.006, z)], [(0, 0, 0)]), steps=1,
            dump="f_fluidExplicitForce[1] f_fluidExplicitForce[2] f_fluidExplicitForce[3]",
            flow=lambda folder: self.shear(folder, (low, high)), through=True, functions=transport)
        slope = (high - low) / 0.04
        exact = -0.5 * D * RHO * NU ** 2 * slope / (low + slope * z)
        fx, fy, fz = found[1]
        self.assertLess(abs(fz / exact - 1), 1e-9)
        self.assertLess(math.hypot(fx, fy), 1e-9 * abs(exact))

    # ---- own fluid

    def test_given_viscosity(self):
        """A solver with nu = 0, which the stock fluid refuses: Stokes' drag with the viscosity that the user's
        fluid states."""
        rate = 18 * MU / (RHO_P * D ** 2)
        v = self.run_grains("0", "{ drag { model Stokes; } }", dump="vx vy vz", nu=0.0,
                            options={"fluid": f"{{ model givenViscosity; nu {NU!r}; }}"})[1]
        for a, b in zip(v, V0):
            self.assertLess(abs(a / (b * math.exp(-rate * 2e-3)) - 1), 1e-7)


if __name__ == "__main__":
    unittest.main()
