# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/heat in stock LIGGGHTS on several ranks: temperatures that move, restart and are inserted, heat booked to
the last digit, grains that are carried or removed.

Style coupled gets its fluid by `set`, or by a small plugin that plays the coupling (fix_exchange_probe.h).
"""
# processors: 2

import unittest

import numpy

from grainjet import tables
from heat_case import AIR, C, CLOUD, HeatCase, MASS, MATERIAL, ONE, PROBE, SETTINGS, TEMPLATE

STATE = ["vx", "f_Temp", "f_fluidHeat", "f_fluidTemperature", "f_fluidHeatCoefficient"]
TEMPERATURE, HEAT, FLUID, COEFFICIENT = range(2, 6)

# temperatures and coefficients of the cloud's grains, each its own
FLUIDS = """
    variable T atom 350+100*sin(5*id)
    variable F atom 300+50*sin(7*id)
    variable H atom 2e-5*(1+sin(11*id))
    set group all property/atom Temp v_T
    set group all property/atom fluidTemperature v_F
    set group all property/atom fluidHeatCoefficient v_H
"""

COUPLED = "fix h all fluid/heat coupled temperature 333"

SUMS = """
    variable e atom mass*800*f_Temp
    compute e all reduce sum v_e
    variable energy equal c_e
    variable heat equal f_d[19]
    variable removed equal f_d[4]
    variable thermal equal f_d[20]
    variable deleted equal f_d[13]
    thermo_style custom step atoms c_e f_d[19] f_d[20]
    thermo_modify lost ignore
"""
PRINT = "\n".join(f'print "{name} = ${{{name}}}"' for name in ("energy", "heat", "removed", "thermal", "deleted"))


class State(HeatCase):

    def test_heat_equals_energy_gained(self):
        """Heat = m c (T1 - T0), to rounding, when grains cross ranks and are sorted; bitwise the same on any number of
        ranks, since free grains do not know of each other. Each goes its own exponential way."""
        finals = []
        for ranks, sort in ((0, "0 0"), (1, "10 0.001"), (2, "10 0.001"), (4, "0 0")):
            self.liggghts(self.script(f"""
                {COUPLED}
                {FLUIDS}
                fix i all nve/sphere
                {self.dump_command("start.dump", 1000, STATE)}
                run 0
                undump d
                {self.dump_command("end.dump", 1000, STATE)}
                run 1000
            """, sort=sort), ranks)
            first, last = self.dump("start.dump"), self.dump("end.dump")
            self.assertEqual(len(last), 2000)
            given = MASS * C * (last[:, TEMPERATURE] - first[:, TEMPERATURE])
            self.assertLess(abs(last[:, HEAT] - given).max(), 1e-12 * MASS * C * 100)
            left = numpy.exp(-last[:, COEFFICIENT] * 1e-2 / (MASS * C))
            exact = last[:, FLUID] + (first[:, TEMPERATURE] - last[:, FLUID]) * left
            self.assertLess(abs(last[:, TEMPERATURE] - exact).max(), 1e-10)
            self.assertGreater(abs(last[:, TEMPERATURE] - first[:, TEMPERATURE]).max(), 10)
            finals.append(last)
        for other in finals[1:]:
            numpy.testing.assert_array_equal(other, finals[0])

    def test_restart_continues(self):
        """A run goes on from a file as if it had not stopped, bit for bit, also with another number of ranks; the
        total heat goes on to rounding of its sum."""
        end = f"""
            fix i all nve/sphere
            {self.dump_command("{}", 80, STATE)}
            thermo_style custom step f_h[2] f_h[3]
            thermo_modify format float %.17g
            thermo 80
            run 80
        """
        through = self.liggghts(self.script(f"""
            {COUPLED}
            {FLUIDS}
            fix i all nve/sphere
            run 120
            write_restart half.restart
            unfix i
            {end.format("through.dump")}
        """), 2)
        expected = self.dump("through.dump")
        self.assertGreater(abs(expected[:, HEAT]).min(), 0)
        for ranks in (1, 2, 4):
            result = self.liggghts(self.head() + f"read_restart half.restart\n{SETTINGS.format(dt=1e-5)}\n"
                                   + COUPLED + end.format("restarted.dump"), ranks)
            numpy.testing.assert_array_equal(self.dump("restarted.dump"), expected)
            numpy.testing.assert_allclose(tables.thermo(result.output)[-1], tables.thermo(through.output)[-1], rtol=1e-12)

    def test_restart_from_the_middle_of_a_coupled_run(self):
        """Beside fix fluid/force coupled, from a file that a running interval has left: bit for bit, on the same ranks."""
        fluid = f"fix f all fluid/force coupled\n{COUPLED}\n"
        end = f"fix i all nve/sphere\n{self.dump_command('{}', 190, ['x', *STATE])}\n"
        plugins = "plugin load fluidforceplugin.so"
        self.liggghts(self.script(f"""
            plugin load {PROBE}
            {fluid}
            {FLUIDS}
            fix d all exchange/probe 100 8.0 300.0 2e-8 1e-9 heat 500 2e-5
            {end.format("through.dump")}
            restart 120 half.*.restart
            run 190
        """, plugins=plugins), 2)
        self.liggghts(self.head(plugins=plugins) + f"read_restart half.120.restart\n{SETTINGS.format(dt=1e-5)}\n{fluid}"
                      + end.format("restarted.dump") + "run 70", 2)
        through = self.dump("through.dump")
        self.assertTrue((through[:, 1 + COEFFICIENT] == 2e-5).all())
        self.assertGreater(abs(through[:, 1 + HEAT]).min(), 0)
        numpy.testing.assert_array_equal(self.dump("restarted.dump"), through)

    def test_restart_of_uniform(self):
        """The same with style uniform and the script's own property Temp."""
        fluid = f"fix Temp all property/atom Temp scalar yes yes no 400\nfix h all fluid/heat uniform 300 {AIR} velocity 5 0 0"
        end = f"""
            fix i all nve/sphere
            {self.dump_command("{}", 80, STATE)}
            run 80
        """
        self.liggghts(self.script(f"{fluid}\nfix i all nve/sphere\nrun 120\nwrite_restart half.restart\nunfix i"
                                  + end.format("through.dump")), 2)
        self.liggghts(self.head() + f"read_restart half.restart\n{SETTINGS.format(dt=1e-5)}\n{fluid}"
                      + end.format("restarted.dump"), 2)
        through = self.dump("through.dump")
        self.assertLess(through[:, TEMPERATURE].max(), 399.5)
        numpy.testing.assert_array_equal(self.dump("restarted.dump"), through)

    def test_new_grains(self):
        """Grains from create_atoms and insert/pack have T0 and no fluid until the coupling has seen them: no heat. Between
        the exchanges they keep that temperature."""
        result = self.liggghts(self.script(f"""
            {MATERIAL}
            plugin load {PROBE}
            fix f all fluid/force coupled
            {COUPLED}
            {TEMPLATE}
            region half block 0.011 0.019 0.001 0.009 0.001 0.009 units box
            fix in all insert/pack seed 86028121 distributiontemplate pd vel constant 1 0 0 &
                insert_every 37 overlapcheck yes all_in yes particles_in_region 300 region half
            fix d all exchange/probe 50 8.0 300.0 2e-8 1e-9 heat 500 1e-5
            fix i all nve/sphere
            {SUMS}
            {self.dump_command("new.dump", 20, STATE)}
            run 20
            undump d
            {self.dump_command("late.dump", 90, STATE)}
            run 70
            undump d
            {self.dump_command("end.dump", 200, STATE)}
            run 110
            {PRINT}
        """, grains=ONE, boundary="f f f", plugins="plugin load fluidforceplugin.so"), 2)
        young = self.dump("new.dump")
        self.assertGreater(len(young), 100)
        self.assertTrue((young[:, 2:] == [333, 0, 0, 0]).all())
        late = self.dump("late.dump")
        seen = late[:, COEFFICIENT] > 0
        self.assertTrue(0 < seen.sum() < len(late), "grains of before and after the exchange")
        self.assertTrue((late[~seen][:, 2:] == [333, 0, 0, 0]).all())
        self.assertTrue((late[seen, TEMPERATURE] > 333).all())
        end = self.printed(result)
        last = self.dump("end.dump")
        balance = end["energy"] + end["thermal"] - (len(last) + end["removed"]) * MASS * C * 333
        self.assertTrue((last[:, HEAT] == 0).all())
        self.assertLess(abs(balance - end["heat"]), 1e-12 * end["energy"])
        self.assertGreater(end["heat"], 1e-4 * end["energy"])

    def test_grains_carried_by_insert_stream(self):
        """insert/stream carries its grains to the face: they exchange no heat until their release, as no momentum."""
        self.triangles("face.stl", 0.004, 0.002, 0.008)
        self.liggghts(self.script(f"""
            {MATERIAL}
            fix h all fluid/heat uniform 300 {AIR} temperature 400
            {TEMPLATE}
            fix face all mesh/surface/planar file face.stl type 1
            fix in all insert/stream seed 86028157 distributiontemplate pd nparticles 20000 &
                particlerate 100000 overlapcheck yes all_in no vel constant 2 0 0 &
                insertion_face face extrude_length 0.001
            fix i all nve/sphere
            dump d all custom 30 young.dump id x f_Temp f_fluidHeat f_fluidHeatCoefficient
            run 30
        """, grains="", boundary="f f f"), 2)
        young = self.dump("young.dump")
        carried = young[:, 1] < 0.004
        self.assertGreater(carried.sum(), 10)
        self.assertGreater((~carried).sum(), 10)
        self.assertTrue((young[carried][:, 2:] == [400, 0, 0]).all())
        self.assertTrue((young[~carried][:, 2] < 400).all())

    def triangles(self, name, x, low, high):
        """An STL file of a square normal to x, from `low` to `high` in y and z."""
        a, b, c, d = (low, low), (high, low), (high, high), (low, high)
        text = "solid s\n"
        for corners in ((a, b, c), (a, c, d)):
            text += "facet normal 1 0 0\nouter loop\n"
            text += "".join(f"vertex {x} {p[0]} {p[1]}\n" for p in corners)
            text += "endloop\nendfacet\n"
        (self.folder / name).write_text(text + "endsolid s\n")

    def removal(self, steps, before="", boundary="p p p", ranks=2):
        """Thermal energy at the start and end of a run from which grains go, and what the probe has taken."""
        result = self.liggghts(self.script(f"""
            fix m1 all property/global youngsModulus peratomtype 5.e6
            plugin load {PROBE}
            {before}
            fix f all fluid/force coupled
            {COUPLED}
            fix d all exchange/probe 10 8.0 300.0 2e-8 1e-9 heat 500 2e-5
            fix i all nve/sphere
            {SUMS}
            thermo 1000
            run 0
            {PRINT}
            run {steps}
            {PRINT}
        """, boundary=boundary, plugins="plugin load fluidforceplugin.so"), ranks)
        start, end = (self.printed(type(result)(0, part)) for part in result.output.split("Loop time")[1:])
        return start, end

    def balanced(self, start, end):
        """Rounding of sums over 2000 grains and 1000 steps; a step of one removed grain's heat would be 1e-8 of it."""
        given = end["energy"] + end["thermal"] - start["energy"]
        self.assertGreater(end["heat"], 0.01 * start["energy"])
        self.assertLess(abs(given - end["heat"]) / end["heat"], 1e-12 * start["energy"] / end["heat"])

    def test_balance_with_grains_removed(self):
        """Energy at the end + carried away = at the start + given by the fluid, when grains leave through fixed boundaries in
        the middle of intervals: the heat of all steps before is in."""
        for ranks in (1, 2, 4):
            start, end = self.removal(1000, boundary="f f f", ranks=ranks)
            self.assertGreater(end["removed"], 100)
            self.balanced(start, end)

    def test_balance_with_deleting_mesh(self):
        """The same with a fix massflow/mesh that deletes what crosses it."""
        self.triangles("plane.stl", 0.0155, 0, 0.01)
        start, end = self.removal(300, before="""
            fix face all mesh/surface/planar file plane.stl type 1
            fix count all massflow/mesh mesh face count once vec_side -1 0 0 delete_atoms yes
        """)
        self.assertGreater(end["deleted"], 10)
        self.assertEqual(end["deleted"], end["removed"])
        self.balanced(start, end)

    def test_only_the_group(self):
        """Grains outside the group keep their temperature and count in no sum."""
        result = self.liggghts(self.script(f"""
            region left block 0 0.0095 INF INF INF INF units box
            group left region left
            fix h left fluid/heat uniform 300 {AIR} temperature 400
            fix i all nve/sphere
            {self.dump_command("end.dump", 50, STATE)}
            thermo_style custom step f_h[2] f_h[3]
            thermo_modify format float %.17g
            run 50
        """), 2)
        last = self.dump("end.dump")
        still = last[:, TEMPERATURE] == 400
        self.assertEqual(still.sum(), 1000)
        self.assertTrue((last[still, HEAT] == 0).all())
        _, mean, total = self.thermo(result)[-1]
        self.assertAlmostEqual(mean / last[~still, TEMPERATURE].mean(), 1, delta=1e-13)
        self.assertAlmostEqual(total / last[:, HEAT].sum(), 1, delta=1e-12)

    def test_ranks_without_grains(self):
        """One grain on four ranks, several runs: vector, Biot number and checks need all ranks each time."""
        result = self.liggghts(self.script(f"""
            fix k all property/global thermalConductivity peratomtype 0.02
            fix h all fluid/heat uniform 300 {AIR} temperature 400
            fix i all nve/sphere
            thermo_style custom step f_h[1] f_h[2] f_h[3] f_h[4]
            thermo 10
            run 20
            run 20
            run 0
        """, grains=ONE, processors="2 2 1"), 4)
        rows = self.thermo(result)
        self.assertLess(rows[-1, 2], 400)
        self.assertEqual(result.output.count("WARNING: Fix fluid/heat"), 1)

    def test_without_a_coupling_nothing_acts(self):
        """coupled in stock LIGGGHTS, an empty box first: temperatures stay."""
        result = self.liggghts(self.script(f"""
            {COUPLED}
            fix i all nve/sphere
            run 0
            {CLOUD}
            thermo_style custom step f_h[1] f_h[2] f_h[3] f_h[4]
            run 20
        """, grains=""), 2)
        self.assertEqual(tables.thermo(result.output)[-1], [20, 0, 333, 0, -1])


if __name__ == "__main__":
    unittest.main()
