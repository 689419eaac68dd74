# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""jetKEpsilon equal to kEpsilon in stock solvers with a model for each phase, and the libraries that hold it."""

# processors: 2

import shutil
import unittest

import grainjet
import lid_cavity
from grainjet import dictionaries

PHASES = ("air", "water")


class Phases(lid_cavity.Comparison):

    def test_compressibleInterFoam(self):
        self.prepare("compressibleInterFoam", PHASES)
        self.compare()

    def test_reactingTwoPhaseEulerFoam(self):
        self.prepare("reactingTwoPhaseEulerFoam", PHASES)
        self.compare()

    def test_reactingMultiphaseEulerFoam(self):
        self.prepare("reactingMultiphaseEulerFoam", PHASES)
        self.compare()


class Library(lid_cavity.Comparison):

    """Those for phases are looked for beside the one in libs, and only where the solver has such phases."""

    def copy(self, solver, *names):
        """Log of a run with a copy of the library, and of these, in a folder of their own."""
        folder = self.folder/"lib"
        folder.mkdir()
        for name in ("Turbulence", *names):
            shutil.copy(grainjet.openfoam_library(f"libjet{name}Models"), folder)
        self.prepare(solver)
        dictionaries.change(self.folder/"system/controlDict", ('"libjet', f'"{folder}/libjet'))
        self.results("jetKEpsilon")
        return self.log

    def test_alone_without_phases(self):
        self.assertNotIn("Warning", self.copy("interFoam"))

    def test_alone_with_phases(self):
        log = self.copy("compressibleInterFoam")
        self.assertEqual(log.count("cannot be opened, so that the phases of this solver know no jetKEpsilon"), 1)
        self.assertIn(f"{self.folder}/lib/libjetVoFphaseTurbulenceModels.so", log)

    def test_both_with_phases(self):
        self.assertNotIn("Warning", self.copy("compressibleInterFoam", "VoFphaseTurbulence"))


if __name__ == "__main__":
    unittest.main()
