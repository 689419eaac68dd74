# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/force in stock LIGGGHTS: the state of new, carried and restarted grains, ranks without
grains, groups, global vector.

Style coupled is driven by a small plugin that plays the coupling (fix_exchange_probe.h).
"""
# processors: 2

import unittest

import numpy

from grainjet import tables
from fluid_case import BOX, PROBE, FluidCase


class State(FluidCase):

    def test_held_state_survives_restart(self):
        """What the coupling wrote is held over a restart: the run goes on as if it had not
        stopped (a set-up between the runs in both cases), to the last printed digit."""
        columns = ("id vx f_fluidVelocity[1] f_fluidDragCoefficient f_fluidExplicitForce[1] "
                   "f_fluidStartPosition[1] f_fluidStartPosition[2] f_fluidOwner[1] f_fluidOwner[2] "
                   "f_fluidImpulse[1]")
        dump = (f"dump d all custom 20 {{}} {columns}\n"
                'dump_modify d format "%d' + 9 * " %.17g" + '"')
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            plugin load {PROBE}
            fix f all fluid/force coupled
            fix d all exchange/probe 50 8.0 300.0 2e-8 1e-9
            fix i all nve/sphere
            run 120
            unfix d
            write_restart held.restart
            {dump.format("held.dump")}
            run 0
            undump d
            {dump.format("through.dump")}
            run 80
        """, 2)
        self.liggghts(self.head() + f"""
            read_restart held.restart
            neighbor 0.0005 bin
            neigh_modify delay 0
            timestep 1e-5
            fix f all fluid/force coupled
            fix i all nve/sphere
            {dump.format("read.dump")}
            run 0
            undump d
            {dump.format("restarted.dump")}
            run 80
        """, 2)
        held = self.dump("held.dump")
        self.assertTrue((held[:, 3] == 2e-8).all())
        self.assertEqual(set(held[:, 7]), {0, 1})
        numpy.testing.assert_array_equal(self.dump("read.dump"), held)
        through, restarted = self.dump("through.dump"), self.dump("restarted.dump")
        self.assertGreater(abs(through[:, 9] - held[:, 9]).min(), 0)
        numpy.testing.assert_array_equal(restarted, through)

    def test_new_grains_start_with_a_defined_state(self):
        """Grains from create_atoms, insert/stream and insert/pack: no force and no owner until the
        coupling has seen them, start position = where they were put; and the balance holds."""
        result = self.liggghts(self.head(boundary="f f f") + BOX + f"""
            {self.MATERIAL}
            plugin load {PROBE}
            fix f all fluid/force coupled
            create_atoms 1 single 0.003 0.003 0.003 units box
            set group all diameter 80e-6 density 2950
            fix pt all particletemplate/sphere 15485863 atom_type 1 density constant 2950 &
                radius constant 4e-5 volume_limit 1e-16
            fix pd all particledistribution/discrete 32452843 1 pt 1.0
            region half block 0.011 0.019 0.001 0.009 0.001 0.009 units box
            fix in all insert/pack seed 86028121 distributiontemplate pd vel constant 1 0 0 &
                insert_every 37 overlapcheck yes all_in yes particles_in_region 300 region half
            fix d all exchange/probe 50 8.0 300.0 2e-8 1e-9
            fix i all nve/sphere
            {self.VARIABLES}
            dump d all custom 20 new.dump id vx x f_fluidStartPosition[1] f_fluidDragCoefficient &
                f_fluidOwner[1] f_fluidForce[1]
            dump_modify d format "%d %.17g %.17g %.17g %.17g %.17g %.17g"
            run 20
            undump d
            run 380
            {self.PRINT}
        """, 2)
        young = self.dump("new.dump")
        self.assertGreater(len(young), 100)
        created = young[young[:, 2] == 0.003]
        self.assertEqual(len(created), 1)
        self.assertTrue((young[:, 4:] == [0, -1, 0]).all())
        # pack inserts at step 1: moved at 1 m/s since, nothing has acted on it
        others = young[young[:, 2] != 0.003]
        self.assertTrue((others[:, 1] == 1).all())
        moved = others[:, 2] - others[:, 3]
        self.assertTrue((moved > 0).all() and (moved <= 20.5e-5).all(), moved)

        end = self.values(result.output)
        inserted = end["atoms"] + end["removed"] - 1
        balance = end["px"] + end["lx"] - inserted * self.MASS * 1 - end["ix"]
        self.assertLess(abs(balance) / end["ix"], 1e-12)

    def test_grains_carried_by_insert_stream(self):
        """insert/stream carries its grains at constant velocity to the face and undoes all forces
        until then: no impulse is booked for them, the balance holds from release on."""
        self.triangles("face.stl", 0.004, 0.002, 0.008)
        for ranks in (1, 2):
            result = self.liggghts(self.head(boundary="f f f") + BOX + f"""
                {self.MATERIAL}
                plugin load {PROBE}
                fix f all fluid/force coupled
                fix pt all particletemplate/sphere 15485863 atom_type 1 density constant 2950 &
                    radius constant 4e-5 volume_limit 1e-16
                fix pd all particledistribution/discrete 32452843 1 pt 1.0
                fix face all mesh/surface/planar file face.stl type 1
                fix in all insert/stream seed 86028157 distributiontemplate pd nparticles 20000 &
                    particlerate 100000 overlapcheck yes all_in no vel constant 2 0 0 &
                    insertion_face face extrude_length 0.001
                fix d all exchange/probe 10 8.0 300.0 2e-8 1e-9
                fix i all nve/sphere
                {self.VARIABLES}
                dump d all custom 30 young.dump id vx x f_fluidStartPosition[1] &
                    f_fluidDragCoefficient f_fluidOwner[1] f_fluidImpulse[1] f_fluidForce[1]
                dump_modify d format "%d{7 * ' %.17g'}"
                run 30
                undump d
                run 570
                {self.PRINT}
            """, ranks)
            young = self.dump("young.dump")
            carried = young[young[:, 1] == 2]
            self.assertGreater(len(carried), 10)
            self.assertGreater(len(young), len(carried))
            self.assertTrue((carried[:, 6:] == 0).all())
            end = self.values(result.output)
            self.assertGreater(end["ix"], 0.1 * end["px"])
            balance = end["px"] + end["lx"] - (end["atoms"] + end["removed"]) * self.MASS * 2 - end["ix"]
            self.assertLess(abs(balance) / end["ix"], 1e-12)

    def test_ranks_without_grains(self):
        """One grain on four ranks, several runs: the global vector needs all ranks each time."""
        self.liggghts(self.head(processors="2 2 1") + BOX + f"""
            create_atoms 1 single 0.003 0.003 0.003 units box
            set group all diameter 80e-6 density 2950
            {self.WIND}
            fix i all nve/sphere
            thermo_style custom step f_f[1] f_f[4]
            thermo 10
            run 20
            run 20
            run 0
        """, 4)

    def test_only_the_group_feels_the_fluid(self):
        """Grains outside the group keep their velocity and count in no sum."""
        result = self.liggghts(self.head() + BOX + self.CLOUD + f"""
            region left block 0 0.01 INF INF INF INF units box
            group left region left
            {self.WIND.replace("f all", "f left")}
            fix i all nve/sphere
            variable still atom vx-20*sin(id)
            group right subtract all left
            compute left left reduce min v_still
            compute right right reduce max v_still
            thermo_style custom step c_left c_right f_f[1]
            run 50
        """, 2)
        step, left, right, _ = tables.thermo(result.output)[-1]
        self.assertEqual(step, 50)
        self.assertNotEqual(left, 0)
        self.assertEqual(right, 0)

    def test_without_a_coupling_nothing_acts(self):
        """coupled in stock LIGGGHTS: free flight, bit for bit, and a zero vector."""
        dump = ('dump d all custom 200 {} id x y z vx vy vz\n'
                'dump_modify d format "%d' + 6 * " %.17g" + '"')
        for name, fluid in (("with", "fix f all fluid/force coupled"), ("without", "")):
            script = self.head() + BOX + self.CLOUD + f"""
                {fluid}
                fix i all nve/sphere
                {dump.format(name)}
                run 200
            """
            if fluid:
                script += "\n".join(f'variable v{n} equal f_f[{n}]\nprint "v{n} = ${{v{n}}}"'
                                    for n in (1, 2, 3, 4))
            result = self.liggghts(script, 2)
            if fluid:
                self.assertEqual(self.vector(result, ["v1", "v2", "v3", "v4"]), [0, 0, 0, 0])
        numpy.testing.assert_array_equal(self.dump("with"), self.dump("without"))

    def test_total_force_and_slip(self):
        """Global vector against the sum over a dump, on 2 ranks; rounding of the sums."""
        result = self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {self.WIND}
            fix i all nve/sphere
            dump d all custom 100 end.dump id f_fluidForce[1] f_fluidForce[2] f_fluidForce[3] vx vy vz
            dump_modify d format "%d{6 * ' %.17g'}"
            run 100
        """ + "\n".join(f'variable v{n} equal f_f[{n}]\nprint "v{n} = ${{v{n}}}"'
                        for n in (1, 2, 3, 4)), 2)
        rows = self.dump("end.dump")
        slip = numpy.linalg.norm(rows[:, 4:7] - [8, 1, -1], axis=1).mean()
        expected = [*rows[:, 1:4].sum(axis=0), slip]
        numpy.testing.assert_allclose(self.vector(result, ["v1", "v2", "v3", "v4"]), expected,
                                      rtol=1e-6)    # `print` shows ten digits
        self.assertEqual(rows.shape[0], 2000)


if __name__ == "__main__":
    unittest.main()
