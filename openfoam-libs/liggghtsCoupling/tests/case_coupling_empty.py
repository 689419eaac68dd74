# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A box without grains is a normal state of a coupled run, at any time."""
# processors: 2
# label: long

import unittest

import grainjet
from grainjet import coupled_box as box
from grainjet.coupled_box import end_at

WALL = "fix w all wall/gran model hertz tangential history primitive type 1 zplane 0.0\n"

INSERTION = """
fix template all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0004
fix grains all particledistribution/discrete 32452843 1 template 1.0
region source block 0.002 0.018 0.002 0.018 0.012 0.018 units box
fix source all insert/pack seed 86028121 distributiontemplate grains vel constant 0 0.2 -0.5 &
    insert_every 1000 start 65 overlapcheck yes all_in yes particles_in_region 15 region source
"""


class Empty(grainjet.Case):

    def write(self, grains, fixes="", plugins="", ranks=0):
        folder = self.folder / f"case{len(list(self.folder.iterdir()))}"
        box.write(folder, steps=6, write_every=2, walls=True)
        box.script(folder, grains=grains, boundary="f f f", fixes=fixes, plugins=plugins)
        box.fv_options(folder)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        return folder

    def go_on(self, folder, steps, ranks=0):
        end_at(folder, steps)
        return self.foam("pimpleFoam", folder, ranks, timeout=120).output

    def test_last_grain_leaves(self):
        """It leaves in the second step; the run goes on, writes, and is continued."""
        last = box.grains([(0.0103, 0.0107, 0.0385)], [(0, 0, 20)])
        hertz = "plugin load hertzcgplugin.so"
        for ranks in (0, 2):
            for fixes in ("", WALL, WALL + "fix c all hertz/cg\n"):
                with self.subTest(ranks=ranks, fixes=fixes):
                    folder = self.write(last, fixes, hertz if "hertz/cg" in fixes else "", ranks)
                    self.assertIn("grains 0 (inserted 1, left the box 1", self.go_on(folder, 6, ranks))
                    output = self.go_on(folder, 9, ranks)
                    self.assertIn(" 0 continued grains", output)
                    self.assertIn("grains 0 (inserted 1, left the box 1", output)

    def test_never_any_grain(self):
        for fixes in ("", WALL):
            with self.subTest(fixes=fixes):
                folder = self.write("", fixes)
                self.assertIn(" 0 new grains", self.go_on(folder, 4))
                self.assertIn(" 0 continued grains", self.go_on(folder, 6))

    def test_grains_come_later(self):
        """Inserted into an empty box after it has been continued."""
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                folder = self.write("", WALL + INSERTION, ranks=ranks)
                self.assertIn("grains 0 (inserted 0", self.go_on(folder, 4, ranks))
                output = self.go_on(folder, 9, ranks)
                self.assertIn(" 0 continued grains", output)
                self.assertIn("grains 15 (inserted 15, left the box 0", output)


if __name__ == "__main__":
    unittest.main()
