# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""docs/tutorial.md and docs/tutorial_cluster.md, which begins where it ends, done to the letter: every block in the order of the
pages (grainjet.pages)."""

import unittest

import grainjet
from grainjet import tables
from grainjet.pages import blocks, edited, follow, missing

PAGE = grainjet.ROOT/"docs"/"tutorial.md"
CLUSTER = grainjet.ROOT/"docs"/"tutorial_cluster.md"


class Tutorial(grainjet.Case):

    def test_page(self):
        page = PAGE.read_text()

        self.assertGreater(len(blocks(page)), 10)

        case = follow(page, self.folder)

        # the last of it, in parallel, has really run
        profiles = sorted((case/"postProcessing"/"profiles").glob("*/plane_5D.dat"))
        self.assertEqual(len(profiles), 3, profiles)
        self.assertIn("End", (case/"log.pimpleFoam").read_text().splitlines())

        # From 2 ranks by way of a kill to 4. What the script inserts per second (the log of LIGGGHTS says it) goes on: each start
        # loses or gains less than the 11 grains of one insertion
        case = follow(CLUSTER.read_text(), case)
        balance = tables.history(case/"postProcessing"/"liggghtsCoupling", "balance")
        last = {name: column[-1] for name, column in balance.items()}
        self.assertAlmostEqual(last["Time"], 0.0925, delta=1e-9)
        self.assertEqual(last["inserted"], last["present"] + last["leftBox"] + last["deleted"])
        self.assertAlmostEqual(last["inserted"], 56901*0.0925, delta=6*12)

    def test_a_page_that_is_wrong_is_noticed(self):
        self.assertRaises(AssertionError, follow, "<!-- rum -->\n```\nls\n```\n", self.folder)
        self.assertRaises(AssertionError, follow, "<!-- run -->\n```\nfalse\n```\n", self.folder)
        follow("<!-- run -->\n```\nexport there=here\n```\n<!-- run -->\n```\necho $there\n```\n<!-- shows -->\n```\nhere\n```\n", self.folder)
        self.assertEqual(edited("a\nb\nc\n", " a\n-b\n+x\n"), "a\nx\nc\n")
        self.assertRaises(AssertionError, edited, "a\nb\nc\n", "-d\n+e\n")
        self.assertRaises(AssertionError, edited, "a\na\n", "-a\n+e\n")
        self.assertIsNone(missing("grains 5, slip 1.5e-3 m/s\n...\nEnd\n", "x\ngrains 71, slip 2 m/s\ny\nEnd\n"))
        self.assertIsNone(missing("finish time Tue Nov 24 15:33:09 2026", "finish time Sat May 1 08:00:00 2027"))
        self.assertEqual(missing("grains 5\n", "grain 5\n"), "grains 5")
        self.assertEqual(missing("End\nStart\n", "Start\nEnd\n"), "Start")


if __name__ == "__main__":
    unittest.main()
