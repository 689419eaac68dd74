# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/force in stock LIGGGHTS on several ranks: momentum is booked to the last digit
through migration, sorting, restart and loss.

Style coupled is driven by a small plugin that plays the coupling (fix_exchange_probe.h).
"""
# processors: 2

import unittest

import numpy

from fluid_case import BOX, PROBE, FluidCase


class Momentum(FluidCase):

    def test_impulse_equals_momentum_gained(self):
        """Free grains: sum of the impulse = m (v1 - v0), to rounding, 1e-12 over 1000 steps, when
        grains cross ranks and are sorted."""
        finals = []
        for ranks, sort in ((0, "0 0"), (1, "10 0.001"), (2, "10 0.001"), (4, "0 0")):
            script = self.head(sort=sort) + BOX + self.CLOUD + f"""
                {self.WIND}
                fix i all nve/sphere
                {self.DUMP.format(every=1000, name='start.dump')}
                run 0
                undump d
                {self.DUMP.format(every=1000, name='end.dump')}
                run 1000
            """
            self.liggghts(script, ranks)
            first, last = self.dump("start.dump"), self.dump("end.dump")
            self.assertEqual(len(first), len(last))
            self.assertGreater(len(first), 1000)
            self.assertLess(self.impulse_error(first, last), 1e-12)
            finals.append(last)
        for other in finals[1:]:
            # free grains do not know of each other: bitwise the same on any number of ranks
            numpy.testing.assert_array_equal(other, finals[0])

    def test_restart_continues(self):
        """Impulse and momentum go on over a restart, also with another number of ranks."""
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {self.WIND}
            fix i all nve/sphere
            {self.DUMP.format(every=1000, name='start.dump')}
            run 0
            undump d
            run 500
            write_restart half.restart
        """, 2)
        for ranks in (1, 2, 4):
            self.liggghts(self.head() + f"""
                read_restart half.restart
                neighbor 0.0005 bin
                neigh_modify delay 0
                timestep 1e-5
                {self.WIND}
                fix i all nve/sphere
                {self.DUMP.format(every=1000, name='end.dump')}
                run 500
            """, ranks)
            self.assertLess(self.impulse_error(self.dump("start.dump"), self.dump("end.dump")), 1e-12)

    def test_balance_with_grains_removed(self):
        """Momentum at the end + carried away = at the start + given by the fluid, when grains
        leave through fixed boundaries in mid-interval and through a counting mesh."""
        for ranks in (1, 2, 4):
            result = self.liggghts(self.head(boundary="f f f") + BOX + self.CLOUD + f"""
                plugin load {PROBE}
                fix f all fluid/force coupled
                fix d all exchange/probe 10 8.0 300.0 2e-8 1e-9
                fix i all nve/sphere
                {self.VARIABLES}
                run 0
                {self.PRINT}
                run 1000
                {self.PRINT}
            """, ranks)
            blocks = result.output.split("Loop time")
            start = self.values(blocks[1])
            end = self.values(blocks[2])
            self.assertGreater(end["removed"], 100)
            self.assertEqual(end["deleted"], 0)
            self.assertEqual(end["atoms"] + end["removed"], start["atoms"])
            self.assertAlmostEqual(end["lm"] / (end["removed"] * self.MASS), 1, delta=1e-12)
            scale = abs(end["ix"])
            for k in "xyz":
                balance = end["p" + k] + end["l" + k] - start["p" + k] - end["i" + k]
                self.assertLess(abs(balance) / scale, 1e-12, (ranks, k))
            # at most what the fastest grain covers in an interval and the time until a loss
            # is noticed
            self.assertLess(end["fate"], 0.02)

    def test_balance_with_deleting_mesh(self):
        """The same with a fix massflow/mesh that deletes what crosses it, before or after the
        fluid force in the script."""
        self.triangles("plane.stl", 0.0155, 0, 0.01)
        counter = """
            fix face all mesh/surface/planar file plane.stl type 1
            fix count all massflow/mesh mesh face count once vec_side -1 0 0 delete_atoms yes
        """
        for before, after in ((counter, ""), ("", counter)):
            result = self.liggghts(self.head() + BOX + self.CLOUD + f"""
                fix m1 all property/global youngsModulus peratomtype 5.e6
                plugin load {PROBE}
                {before}
                fix f all fluid/force coupled
                {after}
                fix d all exchange/probe 10 8.0 300.0 2e-8 1e-9
                fix i all nve/sphere
                {self.VARIABLES}
                run 0
                {self.PRINT}
                run 300
                {self.PRINT}
            """, 2)
            blocks = result.output.split("Loop time")
            start = self.values(blocks[1])
            end = self.values(blocks[2])
            self.assertGreater(end["removed"], 10)
            self.assertEqual(end["deleted"], end["removed"])
            self.assertEqual(end["atoms"] + end["removed"], start["atoms"])
            for k in "xyz":
                balance = end["p" + k] + end["l" + k] - start["p" + k] - end["i" + k]
                self.assertLess(abs(balance) / abs(end["ix"]), 1e-12)


if __name__ == "__main__":
    unittest.main()
