# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/force: the work of forces with reaction is the change of kinetic energy by them, to rounding, through
migration and loss. The coupling is played by a small plugin (fix_exchange_probe.h)."""
# processors: 2

import re
import unittest

from fluid_case import BOX, PROBE, FluidCase

ENERGY = """
    variable ek atom 0.5*mass*(vx*vx+vy*vy+vz*vz)
    compute ek all reduce sum v_ek
    variable present equal c_ek
    variable work equal f_d[17]
    variable carried equal f_d[18]
    variable gone equal f_d[4]
    thermo_style custom step atoms c_ek f_d[17]
    thermo 100
    run 0
    print "energy = ${present} ${work} ${carried} ${gone}"
    run 1000
    print "energy = ${present} ${work} ${carried} ${gone}"
"""


class Work(FluidCase):

    def test_work_is_the_energy_gained(self):
        """Free grains in a shear flow that leave through fixed boundaries in mid-interval: energy at the end + carried
        away = at the start + work, with drag that is fast and slow against the step, and with an added mass."""
        for ranks in (1, 2, 4):
            for forces in ("2e-8 1e-9", "2e-4 1e-6", "2e-8 1e-9 addedMass 2e-10"):
                with self.subTest(ranks=ranks, forces=forces):
                    result = self.liggghts(self.head(boundary="f f f") + BOX + self.CLOUD + f"""
                        plugin load {PROBE}
                        fix f all fluid/force coupled
                        fix d all exchange/probe 10 8.0 300.0 {forces} work
                        fix i all nve/sphere
                        {ENERGY}
                    """, ranks)
                    (start, done, _, _), (end, work, carried, gone) = (
                        [float(x) for x in row.split()] for row in re.findall("energy = (.*)", result.output)[-2:])
                    self.assertEqual(done, 0)
                    self.assertGreater(gone, 100)
                    self.assertGreater(abs(work), 0.01 * start)
                    self.assertLess(abs(end + carried - start - work), 1e-12 * (end + carried))


if __name__ == "__main__":
    unittest.main()
