# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""All sources compile with clang without a warning."""

import shutil
import sys
import unittest

import grainjet

CHECK = grainjet.ROOT / "validation/compilers/compile_check.py"


class Clang(grainjet.Case):

    def check(self, part):
        result = grainjet.run([CHECK, part, "--compiler", "clang++"], self.folder, timeout=850)
        self.assertEqual(result.code, 0, result)

    def test_plugins(self):
        self.check("plugins")

    def test_openfoam_libraries(self):
        self.check("openfoam")


if __name__ == "__main__":
    if not shutil.which("clang++"):
        print("skipped: no clang++ (Debian's package clang)")
        sys.exit(77)
    unittest.main()
