# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Single checks of cases/common/check.py, on tables made here. Nothing is run."""

import unittest

import numpy

from common import check


class Checks(unittest.TestCase):

    def test_grains_outside_the_mesh(self):
        """With a plate 1 % of the grains, up to the next whole number, which is the one that is printed; else none."""
        for present, outside, plate, holds, words in (
                (965, 10, True, True, "10 (at most 10)"), (965, 11, True, False, "11 (at most 10)"), (1000, 10, True, True, "10 (at most 10)"),
                (30, 1, True, True, "1 (at most 1)"), (965, 1, False, False, "1 (at most 0)"), (965, 0, False, True, "0 (at most 0)")):
            with self.subTest(present=present, outside=outside, plate=plate):
                balance = {"present": numpy.array([0, present, 10.0]), "outsideMesh": numpy.array([0, 0.0, outside])}
                held, text = check.outside_mesh(balance, plate)
                self.assertEqual(held, holds)
                self.assertTrue(text.endswith(f": {words}"), text)


if __name__ == "__main__":
    unittest.main()
