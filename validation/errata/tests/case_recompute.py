# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/errata.md shows what recompute.py prints, and names only tests that exist."""

import pathlib
import re
import unittest

import grainjet

PAGE = grainjet.ROOT/"docs"/"errata.md"


class Errata(grainjet.Case):

    def test_tables_of_the_page(self):
        ran = grainjet.run([pathlib.Path(__file__).parents[1]/"recompute.py"], self.folder)
        self.assertEqual(ran.code, 0, ran)
        page = PAGE.read_text()
        for table in ran.output.strip().split("\n\n"):
            self.assertIn(table, page)

    def test_named_tests_exist(self):
        named = re.findall(r"`(case_\w+\.py|test_\w+\.cpp)`(?: \(`(\w+)`\))?", PAGE.read_text())
        self.assertGreater(len(named), 5)
        for name, function in named:
            files = [path for path in grainjet.ROOT.rglob(name) if "build" not in path.parts]
            self.assertTrue(files, name)
            if function:
                self.assertTrue(any(function in path.read_text() for path in files), (name, function))


if __name__ == "__main__":
    unittest.main()
