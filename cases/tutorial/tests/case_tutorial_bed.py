# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# label: long
"""docs/tutorial_bed.md, done to the letter: pressure drop of a lifted bed against its weight, minimum fluidisation against Ergun's law."""

import re
import unittest

import grainjet
from grainjet.pages import follow


class Bed(grainjet.Case):

    def test_page(self):
        case = follow((grainjet.ROOT/"docs"/"tutorial_bed.md").read_text(), self.folder)
        printed = grainjet.run(["/usr/bin/python3", "bed.py"], case).output
        drop, fitted, law = (float(re.search(words + r" +([\d.]+)", printed)[1])
                             for words in ("drop/weight", "U_mf from the bed at rest", "U_mf by Ergun's law"))
        # The bed rises and falls as a whole, with its foot on the floor now and then: the mean over one and a half periods, with
        # 1.4 % rms, is that far from the weight
        self.assertAlmostEqual(drop, 1, delta=0.05)
        # Void fractions of one moment, means over layers; a wider bed with both agrees to 2 % (validation/dense)
        self.assertAlmostEqual(fitted/law, 1, delta=0.05)


if __name__ == "__main__":
    unittest.main()
