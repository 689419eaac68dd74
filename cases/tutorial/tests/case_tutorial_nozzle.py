# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""docs/tutorial_nozzle.md, done to the letter: quickJet with a nozzle from an STL file, the wear of a plate, a restart on four ranks."""

import csv
import math
import re
import unittest

import grainjet
from grainjet import tables
from grainjet.pages import follow


class Nozzle(grainjet.Case):

    def test_page(self):
        case = follow((grainjet.ROOT/"docs"/"tutorial_nozzle.md").read_text(), self.folder)
        said = (case/"Allrun.out").read_text()
        self.assertIn("All checks hold", said)

        # All beads that come in leave the nozzle, but for those under way: 900 are expected, with what an insertion's rhythm and
        # the few that come back at the exit add
        share = float(re.search(r"(?m)^ +0\.1 .* ([\d.]+)$", said)[1])
        self.assertAlmostEqual(share, 1, delta=0.1)

        # The spot lies where the axis meets the plate: its deepest place within the nozzle's radius, its hits nearly head-on
        drawn = grainjet.run([grainjet.ROOT/"validation/plots/surface.py", "postProcessing/wear/plate.vtp", "--average", "3e-3"], case)
        x, y, z = map(float, re.search(r"largest wear_depth: .* at \((\S+) (\S+) (\S+)\) m", drawn.output).groups())
        self.assertLess(math.hypot(x, y), 0.005)
        self.assertAlmostEqual(z, 0.05, delta=1e-6)
        with open(case/"postProcessing"/"wear"/"plate.csv", newline="") as file:
            plate = list(csv.DictReader(file))[-1]
        self.assertGreater(float(plate["collisions"]), 500)
        self.assertLess(float(plate["impact_angle_mean"]), 20)

        # On four ranks all that was counted before goes on
        balance = tables.history(case/"postProcessing"/"liggghtsCoupling", "balance")
        last = {name: column[-1] for name, column in balance.items()}
        self.assertAlmostEqual(last["Time"], 0.045, delta=1e-9)
        self.assertEqual(last["inserted"], last["present"] + last["leftBox"] + last["deleted"])
        # what system/parameters says, but for the beads of one insertion at each start
        rate = 0.23*1.2*13*math.pi/4*0.01**2/(2950*math.pi/6*80e-6**3)/8
        self.assertAlmostEqual(last["inserted"], rate*0.045, delta=20)


if __name__ == "__main__":
    unittest.main()
