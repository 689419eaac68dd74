# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""jetKEpsilon equal to kEpsilon in stock solvers for water and air, as model of the mixture."""

# processors: 2

import unittest

import lid_cavity


class Mixture(lid_cavity.Comparison):

    def test_interFoam(self):
        self.prepare("interFoam")
        self.compare()

    def test_compressibleInterFoam(self):
        self.prepare("compressibleInterFoam")
        self.compare()

    def test_MPPICInterFoam(self):
        self.prepare("MPPICInterFoam")
        self.compare()


if __name__ == "__main__":
    unittest.main()
