# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of fix collision/stats: its block runs, its columns are those of the tables, its picture is drawn."""

import re
import sys
import unittest

import grainjet
from collision_case import CollisionCase, gas

PAGE = (grainjet.ROOT / "docs/fix_collision_stats.md").read_text()
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```$", PAGE, re.M | re.S)


class Page(CollisionCase):

    def test_block_and_picture(self):
        grains, _ = gas(500, 0.1, (0.001,), 0.5, seed=8)
        # to the axis of the region
        self.data([(kind, d, rho, [c + shift for c, shift in zip(x, (0, 0, 0.04))], v, w) for kind, d, rho, x, v, w in grains],
                  ((-0.05, 0.05), (-0.05, 0.05), (0.0, 0.1)))
        block = BLOCKS[0][1].replace("stats_start 0.5", "stats_start 0")
        self.liggghts(self.script("run 2000", stats=re.sub(r"^plugin load .*\n", "", block, flags=re.M), contact=""))
        row = self.rows()["all", "all"]
        self.assertGreater(row["collisions"], 50)
        self.assertEqual(len(self.rows()), 11)
        picture, = (text for language, text in BLOCKS if language == "python")
        (self.folder / "draw.py").write_text("import matplotlib\nmatplotlib.use('Agg')\n" + picture)
        result = grainjet.run([sys.executable, "draw.py"], self.folder)
        self.assertEqual(result.code, 0, result)
        self.assertGreater((self.folder / "spectrum.png").stat().st_size, 5000)

    def test_columns(self):
        """Every column stands on the page, with its first or last words at least."""
        self.data([(1, 0.001, 2500.0, (0.005, 0.005, 0.005), (0, 0, 0))], 0.01)
        self.liggghts(self.script("run 0"))
        columns = (self.folder / "collisions.csv").read_text().split("\n")[0].split(",")
        for column in columns:
            name = re.sub(r"_(mean|variance|skewness|standard_error)$", "", column)
            stem = re.sub(r"_2$", "", name)
            self.assertTrue(f"`{name}`" in PAGE or f"`{stem}_1`" in PAGE or f"`{stem}_*`" in PAGE, column)


if __name__ == "__main__":
    unittest.main()
