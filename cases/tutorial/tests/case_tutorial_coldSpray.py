# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# label: long
"""docs/tutorial_coldSpray.md, done to the letter: the gas against one-dimensional theory, the powder against the flight of one sphere."""

import re
import unittest

import grainjet
from grainjet.pages import follow

NUMBER = r" +([-+.\d]+)"
FASTER = {10: 100, 50: 0}               # %, of each size [um] above the critical velocity; 20 um are at it

# Speed and temperature of one sphere of each size at the plate, in the gas of the page's gas.py: the program of the case coldSpray
FLIGHT = """
import math
import types
import flight
import gas
R = 8314.46/28.0134
nitrogen = types.SimpleNamespace(R=R, gamma=1038.7/(1038.7 - R), p={"Cp": 1038.7},
                                 viscosity=lambda T: 1.401e-6*math.sqrt(T)/(1 + 107/T))
axis = flight.Axis(gas.sections(), *(gas.field(name) for name in "UpT"), nitrogen)
for d in (10e-6, 20e-6, 50e-6):
    x, v, T, t = flight.fly(axis, d, 8960, 385, -0.01825, 40, 300, 0.0695 - 0.5*d, step=5e-7)
    print(f"{1e6*d:.0f} {v[-1]} {T[-1]}")
"""


class ColdSpray(grainjet.Case):

    def printed(self, case, *program):
        path = f"{grainjet.ROOT/'cases'/'coldSpray'}:{grainjet.ENV['PYTHONPATH']}"
        ran = grainjet.run(["/usr/bin/python3", *program], case, env={"PYTHONPATH": path})
        self.assertEqual(ran.code, 0, ran)
        return ran.output

    def test_page(self):
        case = follow((grainjet.ROOT/"docs"/"tutorial_coldSpray.md").read_text(), self.folder)

        # One-dimensional theory leaves out the sharp corner of the throat; cells there are 0.4 mm long
        mach, theory = map(float, re.search(r"(?m)^   69\.2" + 2*NUMBER, self.printed(case, "gas.py")).groups())
        self.assertAlmostEqual(mach/theory, 1, delta=0.02)

        # Each size against the flight through the means over the sections: they differ by what the flow has across them
        table = self.printed(case, "spray.py")
        flights = [list(map(float, line.split())) for line in self.printed(case, "-c", FLIGHT).splitlines()]
        self.assertEqual(len(flights), 3)
        for size, v, T in flights:
            hits, speed, temperature, critical, above = map(float, re.search(rf"(?m)^ +{size:.0f}" + 5*NUMBER, table).groups())
            self.assertGreater(hits, 20)
            self.assertAlmostEqual(speed/v, 1, delta=0.01)
            self.assertAlmostEqual(temperature/T, 1, delta=0.01)
            if size in FASTER:
                self.assertEqual(above, FASTER[size])
            # the formula by hand, to the printed digits
            self.assertAlmostEqual(critical/(667 - 14*8.96 + 0.08*1083 + 22 - 0.4*(temperature - 273.15)), 1, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
