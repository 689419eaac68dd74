# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# label: long
"""docs/tutorial_erosion.md, done to the letter, and the wear of its rod against Finnie's law for straight flight."""

import csv
import math
import re
import unittest

import grainjet
from grainjet.pages import follow


class Erosion(grainjet.Case):

    def test_page(self):
        case = follow((grainjet.ROOT/"docs"/"tutorial_erosion.md").read_text(), self.folder)

        # Wear per area of a round rod goes with sin a cos^2 a (a: angle from the surface), largest at tan^2 a = 1/2, which is 54.7
        # degrees from the front. Its mean angle over the front, 51.0 degrees, with 4,000 hits is known to 0.3; air and eddies turn
        # grains of this Stokes number (400) by less than a degree
        wear, turned, hits = 0.0, 0.0, 0
        with open(case/"postProcessing"/"wear"/"events.csv", newline="") as file:
            for hit in csv.DictReader(file):
                angle = abs(math.degrees(math.atan2(float(hit["y"]), 0.040 - float(hit["x"]))))
                if 0.004 < float(hit["z"]) < 0.030 and angle < 90:
                    wear += float(hit["wear_volume"])
                    turned += angle*float(hit["wear_volume"])
                    hits += 1
        self.assertGreater(hits, 3000)
        self.assertAlmostEqual(turned/wear, 50.97, delta=2)

        # The deepest spot, with some 30 hits in its 2 mm; on the round end, too, the normal leans towards the front by x/R. The
        # curve is flat at its top and 30 % lower 20 degrees away, beyond the uncertainty of 30 hits, 18 %
        place = re.search(r"largest wear_depth: \S+ m at \((\S+) ", self.map_again(case))
        angle = math.degrees(math.acos((0.040 - float(place[1]))/0.008))
        self.assertAlmostEqual(angle, 54.7, delta=20)

    def map_again(self, case):
        """What surface.py says of the map, once more."""
        drawn = grainjet.run([grainjet.ROOT/"validation/plots/surface.py", "postProcessing/wear/rod.vtp", "--average", "2e-3"], case)
        self.assertEqual(drawn.code, 0, drawn)
        return drawn.output


if __name__ == "__main__":
    unittest.main()
