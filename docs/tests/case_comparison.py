# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/comparison.md names only tests and commands that exist."""

import os
import re
import unittest

import grainjet

PAGE = (grainjet.ROOT / "docs/comparison.md").read_text()


class Comparison(unittest.TestCase):

    def test_tests_exist(self):
        named = set(re.findall(r"`(case_\w+\.py)`", PAGE))
        self.assertGreater(len(named), 15)
        there = {path.name for room in ("openfoam-libs", "liggghts-plugins") for path in (grainjet.ROOT / room).rglob("case_*.py")}
        self.assertEqual(named - there, set())

    def test_sources_are_named(self):
        """Each label of a link has its address, and each address is used."""
        used = set(re.findall(r"\]\[([\w-]+)\]", PAGE))
        given = dict(re.findall(r"(?m)^\[([\w-]+)\]: (https://\S+)$", PAGE))
        self.assertGreater(len(used), 15)
        self.assertEqual(used, set(given))

    def test_commands_exist(self):
        named = re.findall(r"`(validation/\S+?\.py)", PAGE)
        self.assertGreaterEqual(len(named), 5)
        self.assertEqual([name for name in named if not os.access(grainjet.ROOT / name, os.X_OK)], [])


if __name__ == "__main__":
    unittest.main()
