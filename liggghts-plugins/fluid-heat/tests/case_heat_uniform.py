# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/heat uniform in stock LIGGGHTS: exact cooling at any time step, coarse grains, laws of heat
transfer, recovery temperature, velocity by fix fluid/force, conduction by fix heat/gran.
"""
# processors: 1

import math
import unittest

import numpy

from heat_case import (AIR, BOX, C, D, DENSITY, HeatCase, MASS, MATERIAL, NU, ONE, RHO, SETTINGS, coefficient, gunn, recovery,
                       whitaker)

OUTPUT = """
    fix i all nve/sphere
    compute t all reduce sum f_Temp f_fluidHeat f_fluidHeatCoefficient f_fluidTemperature
    thermo_style custom step c_t[1] c_t[2] c_t[3] c_t[4] f_h[1] f_h[2] f_h[3] f_h[4]
    thermo_modify format float %.17g
"""
TEMPERATURE, HEAT, COEFFICIENT, FLUID, FLOW, MEAN, TOTAL, BIOT = range(1, 9)


class Uniform(HeatCase):

    def grain(self, fluid, steps, output, dt=1e-5, before="", after="", plugins="", box=BOX, move="nve/sphere"):
        """One grain; the table of thermo output, one row per time."""
        body = f"{before}\nfix h all fluid/heat uniform {fluid}\n{OUTPUT}{after}\nthermo {output}\nrun {steps}".replace("nve/sphere", move)
        return self.thermo(self.liggghts(self.script(body, dt=dt, grains=ONE, plugins=plugins, box=box, boundary="f f f")))

    def test_one_grain_cools(self):
        """T = Tf + (T0 - Tf) exp(-H t/(m c)), within 1e-12 of T0 - Tf, at steps from 1e-4 to 2 time constants;
        the heat is m c (T - T0) to rounding."""
        H = coefficient(8.0)
        tau = MASS * C / H
        for ratio in (1e-4, 0.03, 2.0):
            steps = max(10, min(1000, round(3 / ratio)))
            rows = self.grain(f"300 {AIR} velocity 8 0 0 temperature 400 recovery no", steps, steps // 10, dt=ratio * tau)
            exact = 300 + 100 * numpy.exp(-ratio * rows[:, 0])
            self.assertLess(abs(rows[:, TEMPERATURE] - exact).max(), 1e-10, ratio)
            self.assertLess(abs(rows[:, HEAT] - MASS * C * (rows[:, TEMPERATURE] - 400)).max(), 1e-13 * MASS * C * 400, ratio)
            numpy.testing.assert_array_equal(rows[:, TOTAL], rows[:, HEAT])
            numpy.testing.assert_allclose(rows[:, MEAN], rows[:, TEMPERATURE], rtol=1e-15)
            numpy.testing.assert_allclose(rows[1:, COEFFICIENT], H, rtol=1e-14)
            self.assertTrue((rows[:, BIOT] == -1).all())
            # flow of the latest step: between those of its two ends
            flow = H * (300 - exact[1:])
            self.assertTrue((rows[1:, FLOW] < flow).all() and (rows[1:, FLOW] > flow * math.exp(ratio)).all())

    def test_recovery(self):
        """In a fast gas the grain goes to T + r u^2/(2 cp), r = Pr^(1/2); `recovery yes` is the default."""
        exact = recovery(300.0, 400.0)
        self.assertGreater(exact, 360)
        for word in ("", "recovery yes"):
            rows = self.grain(f"300 {AIR} velocity 0 400 0 temperature 300 {word}", 4000, 4000, dt=1e-4)
            self.assertAlmostEqual(rows[-1, FLUID] / exact, 1, delta=1e-14)
            self.assertAlmostEqual(rows[-1, TEMPERATURE] / exact, 1, delta=1e-12)

    def test_laws(self):
        """Coefficients at a slip of 3 m/s and at rest, to rounding; void fraction 1, mu/mu_s 1."""
        for name, law in (("gunn", gunn), ("whitaker", whitaker)):
            rows = self.grain(f"300 {AIR} velocity 0 0 3 nusselt {name} temperature 310", 2, 1)
            self.assertAlmostEqual(rows[-1, COEFFICIENT] / coefficient(3.0, nusselt=law), 1, delta=1e-13)
            rows = self.grain(f"300 {AIR} nusselt {name} temperature 310", 2, 1)
            self.assertAlmostEqual(rows[-1, COEFFICIENT] / coefficient(0.0), 1, delta=1e-13)

    def test_coarse_grain_is_its_particles(self):
        """A grain of 5^3 particles follows the curve of one of them and takes 125 times the heat: rounding."""
        fluid = f"300 {AIR} velocity 8 0 0 temperature 400"
        fine = self.grain(fluid, 1000, 100)
        # `set diameter` multiplies by f_cg
        coarse = self.grain(fluid, 1000, 100, plugins="plugin load hertzcgplugin.so", before=f"""
            coarsegraining 5
            set group all diameter {D!r} density {DENSITY}""")
        numpy.testing.assert_allclose(coarse[:, TEMPERATURE], fine[:, TEMPERATURE], rtol=1e-13)
        numpy.testing.assert_allclose(coarse[1:, HEAT], 125 * fine[1:, HEAT], rtol=1e-10)
        numpy.testing.assert_allclose(coarse[1:, COEFFICIENT], 125 * fine[1:, COEFFICIENT], rtol=1e-13)

    def test_biot_number(self):
        """h d/(6 kp), and one warning above 0.1 that names the grain."""
        for kp, warnings in ((0.02, 1), (200.0, 0)):
            body = f"""
                fix k all property/global thermalConductivity peratomtype {kp}
                fix h all fluid/heat uniform 300 {AIR} velocity 8 0 0 temperature 310
                {OUTPUT}
                thermo 10
                run 20
                run 20"""
            result = self.liggghts(self.script(body, grains=ONE, boundary="f f f"))
            self.assertAlmostEqual(self.thermo(result)[-1, BIOT] * 6 * math.pi * D * kp / coefficient(8.0), 1, delta=1e-13)
            self.assertEqual(result.output.count("WARNING: Fix fluid/heat (ID h): the Biot number of grain 1 is 1.18"), warnings)

    def test_grains_of_the_fluids_temperature(self):
        """Without any other temperature grains have the fluid's, and the log says so."""
        result = self.liggghts(self.script(f"fix h all fluid/heat uniform 321 {AIR} velocity 8 0 0\n{OUTPUT}\nrun 10", grains=ONE))
        self.assertIn("Fix fluid/heat (ID h): no temperature is given for grains; new ones have the fluid's, 321 K", result.output)
        self.assertEqual(self.thermo(result)[0, TEMPERATURE], 321)

    def force(self, dt, steps, move="nve/sphere"):
        """A grain that the fluid of fix fluid/force accelerates and heats: last row of thermo output."""
        box = BOX.replace("block 0 0.02", "block 0 20").replace("0.01", "10")
        plugins = "plugin load fluidforceplugin.so\nplugin load grainmotionplugin.so"
        return self.grain(f"300 {AIR} temperature 400", steps, steps, dt=dt, box=box, move=move, plugins=plugins, before=f"""
            neighbor 5 bin
            fix f all fluid/force uniform 100 0 0 density {RHO} viscosity {NU} drag stokes""")[-1]

    def test_grain_motion(self):
        """fix grain/motion with the fluid's force in its pass instead of nve/sphere, as in the case coldSpray: the same digits."""
        stock = self.force(1e-3, 50)
        self.assertLess(stock[TEMPERATURE], 399)
        for fluid in ("", " fluid f"):
            self.assertEqual(self.force(1e-3, 50, "grain/motion" + fluid).tolist(), stock.tolist(), fluid)

    def test_velocity_of_fluid_force(self):
        """The fluid's velocity is that of fix fluid/force. With Stokes' drag the slip is 100 exp(-t/tau); temperature
        against a Runge-Kutta solution. Second order: the error falls by four (3 to 5, asymptotic only) when
        the step is halved."""
        tau = DENSITY * D ** 2 / (18 * RHO * NU)
        end = 0.5 * tau

        def slope(t, T):
            slip = 100 * math.exp(-t / tau)
            return coefficient(slip) / (MASS * C) * (recovery(300, slip) - T)

        T, n = 400.0, 4000
        h = end / n
        for i in range(n):
            t = i * h
            k1 = slope(t, T)
            k2 = slope(t + h / 2, T + h / 2 * k1)
            k3 = slope(t + h / 2, T + h / 2 * k2)
            T += h / 6 * (k1 + 2 * k2 + 2 * k3 + slope(t + h, T + h * k3))
        errors = [abs(self.force(end / steps, steps)[TEMPERATURE] - T) for steps in (10, 20, 40)]
        self.assertLess(errors[0] / (400 - T), 0.01)
        for coarse, fine in zip(errors, errors[1:]):
            self.assertGreater(coarse / fine, 3, errors)
            self.assertLess(coarse / fine, 5, errors)

    def test_two_grains_with_conduction(self):
        """With stock fix heat/gran both act on one Temp: heat that two touching grains conduct stays between them, so
        what the fluid gave is the change of their thermal energy, to rounding, and the hot one loses more."""
        d = D
        grains = f"""
            create_atoms 1 single 0.003 0.003 0.003 units box
            create_atoms 1 single {0.003 + 0.99 * d!r} 0.003 0.003 units box
            set group all diameter {d!r} density {DENSITY}
        """
        rows = {}
        for conductivity in (1e-3, 100.0):
            body = f"""
                {MATERIAL}
                fix k all property/global thermalConductivity peratomtype {conductivity}
                pair_style gran model hertz tangential history
                pair_coeff * *
                fix s all heat/gran initial_temperature 350
                fix h all fluid/heat uniform 300 {AIR}
                fix z all freeze
                fix i all nve/sphere
                variable a equal f_Temp[1]
                variable b equal f_Temp[2]
                variable q equal f_h[3]
                thermo_style custom step v_a v_b v_q
                thermo_modify format float %.17g
                thermo 100
                run 0
                set atom 1 property/atom Temp 400
                run 400"""
            rows[conductivity] = self.thermo(self.liggghts(self.script(body, dt=1e-6, grains=grains, boundary="f f f")))
        for values in rows.values():
            values = values[1:]
            self.assertEqual(list(values[0, 1:]), [400, 350, 0])
            change = MASS * C * (values[:, 1] + values[:, 2] - 750)
            self.assertLess(abs(values[:, 3] - change).max(), 1e-13 * MASS * C * 750)
            self.assertLess(values[-1, 3], -1e-3 * MASS * C)
        poor, good = (rows[k][-1] for k in (1e-3, 100.0))
        self.assertGreater((poor[1] - poor[2]) / (good[1] - good[2]), 1.1)

    def test_heat_source(self):
        """A source of fix heat/gran's property heatSource against the fluid: both in turn, the fluid last. The balance of
        that is T = Tf + S dt/(m c) e/(1 - e), e = exp(-H dt/(m c)); for dt -> 0 it is Tf + S/H."""
        H, dt, S = coefficient(0.0), 1e-4, 1e-3
        body = f"""
            {MATERIAL}
            pair_style gran model hertz tangential history
            pair_coeff * *
            fix k all property/global thermalConductivity peratomtype 1000
            fix s all heat/gran initial_temperature 300
            fix h all fluid/heat uniform 300 {AIR}
            {OUTPUT}
            thermo 20000
            run 0
            set group all property/atom heatSource {S}
            run 20000"""
        rows = self.thermo(self.liggghts(self.script(body, dt=dt, grains=ONE, boundary="f f f")))
        x = H * dt / (MASS * C)
        self.assertLess(x, 0.01)
        exact = S * dt / (MASS * C) * math.exp(-x) / -math.expm1(-x)
        self.assertAlmostEqual((rows[-1, TEMPERATURE] - 300) / exact, 1, delta=1e-11)
        self.assertAlmostEqual(exact * H / S, 1, delta=x)


if __name__ == "__main__":
    unittest.main()
