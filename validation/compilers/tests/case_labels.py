# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The OpenFOAM libraries compile with 64-bit labels without a warning, and refuse single precision in words."""

import unittest

import grainjet

CHECK = grainjet.ROOT / "validation/compilers/compile_check.py"
LIBRARIES = 6


class Labels(grainjet.Case):

    def test_64_bits(self):
        result = grainjet.run([CHECK, "openfoam", "--label", "64"], self.folder, timeout=850)
        self.assertEqual(result.code, 0, result)

    def test_single_precision(self):
        """One error in each library, which says what is needed. Fields are of single precision with SPDP as with SP."""
        result = grainjet.run([CHECK, "openfoam", "--precision", "SPDP", "--first"], self.folder)
        self.assertEqual(result.code, 1, result)
        errors = [line for line in result.output.splitlines() if "error: " in line and "/tests/" not in line]
        self.assertEqual(len(errors), LIBRARIES, result)
        for line in errors:
            self.assertIn("Grainjet needs an OpenFOAM in double precision", line)


if __name__ == "__main__":
    unittest.main()
