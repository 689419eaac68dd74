# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# label: long
"""docs/tutorial_coldSpray.md, done to the letter: the gas against one-dimensional theory, the powder against the flight of one sphere."""

import math
import re
import sys
import types
import unittest

import numpy

import grainjet
from grainjet.pages import follow

sys.path.insert(0, str(grainjet.ROOT/"cases"/"coldSpray"))
import flight

NUMBER = r" +([-+.\d]+)"
CP, R = 1038.7, 8314.46/28.0134
SIZES = {10: True, 50: False}           # um: faster than the critical velocity; 20 um are at it


class ColdSpray(grainjet.Case):

    def printed(self, case, program):
        ran = grainjet.run(["/usr/bin/python3", program], case)
        self.assertEqual(ran.code, 0, ran)
        return ran.output

    def test_page(self):
        case = follow((grainjet.ROOT/"docs"/"tutorial_coldSpray.md").read_text(), self.folder)

        # One-dimensional theory leaves out the sharp corner of the throat; cells there are 0.4 mm long
        mach, theory = map(float, re.search(r"(?m)^   69\.2" + 2*NUMBER, self.printed(case, "gas.py")).groups())
        self.assertAlmostEqual(mach/theory, 1, delta=0.02)

        # Each size against the flight through the gas of the sections: they differ by what the flow has across them
        sys.path.insert(0, str(case))
        import gas
        numbers = [gas.field(name, str(case/"0.0005")) for name in "UpT"]
        nitrogen = types.SimpleNamespace(R=R, gamma=CP/(CP - R), p={"Cp": CP}, viscosity=lambda T: 1.401e-6*math.sqrt(T)/(1 + 107/T))
        axis = flight.Axis(gas.sections(), *numbers, nitrogen)
        table = self.printed(case, "spray.py")
        for micrometres in (10, 20, 50):
            found = re.search(rf"(?m)^ +{micrometres}" + 5*NUMBER, table)
            hits, speed, temperature, critical, above = map(float, found.groups())
            self.assertGreater(hits, 20)
            _, v, T, _ = flight.fly(axis, 1e-6*micrometres, 8960, 385, -0.01825, 40, 300, 0.0695 - 0.5e-6*micrometres, step=5e-7)
            self.assertAlmostEqual(speed/v[-1], 1, delta=0.01)
            self.assertAlmostEqual(temperature/T[-1], 1, delta=0.01)
            if micrometres in SIZES:
                self.assertEqual(above, 100 if SIZES[micrometres] else 0)
            self.assertAlmostEqual(critical/(667 - 14*8.96 + 0.08*1083 + 22 - 0.4*(temperature - 273.15)), 1, delta=1e-3)
        self.assertTrue(numpy.all(numpy.diff(numbers[0]) > 0), "the gas speeds up all along the nozzle")


if __name__ == "__main__":
    unittest.main()
