# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The plugins and the unit tests compile for aarch64 without a warning."""

import shutil
import sys
import unittest

import grainjet

CHECK = grainjet.ROOT / "validation/compilers/compile_check.py"


class Aarch64(grainjet.Case):

    def test_plugins(self):
        result = grainjet.run([CHECK, "plugins", "--aarch64"], self.folder)
        self.assertEqual(result.code, 0, result)


if __name__ == "__main__":
    if not shutil.which("aarch64-linux-gnu-g++"):
        print("skipped: no aarch64-linux-gnu-g++ (Debian's package g++-aarch64-linux-gnu)")
        sys.exit(77)
    unittest.main()
