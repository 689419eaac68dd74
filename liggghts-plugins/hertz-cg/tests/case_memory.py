# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Memory of fix hertz/cg goes with the grains, not with the empty volume around them."""

import re
import unittest

import granular as g
from grainjet import Case


class Memory(Case):

    def megabytes(self, kind, box):
        grains = g.assembly(600, 0.02, (0.001,), speed=0.5, spin=0, clearance=0.01)
        (self.folder / "data").write_text(re.sub(r"0 0.02 (.)lo", rf"0 {box} \1lo", grains))
        result = self.liggghts(
            g.load(kind) + g.head() + "read_data data\nneighbor 0.001 bin\n" + g.MATERIAL + g.contacts(kind)
            + "fix w all wall/gran model hertz tangential history primitive type 1 zplane 0\n"
            + "fix i all nve/sphere\ntimestep 1e-6\nrun 1\n", name=f"in.{kind}")
        return float(re.search(r"^Memory usage per processor = (\S+)", result.output, re.M).group(1))

    def test_empty_volume_costs_nothing(self):
        """The host's own figure: arrays of grains, lists, bins. Margins are wider in a dilute box and more pairs
        may be listed; twice as much allows for that, where bins of the volume would take thousands of times."""
        small, large = self.megabytes(g.PLUGIN, 0.02), self.megabytes(g.PLUGIN, 0.3)
        stock = self.megabytes(g.STOCK, 0.3)
        print(f"plugin {small} MB, in 3400 times the volume {large} MB, where the stock program takes {stock} MB")
        self.assertLess(large, 2 * small)
        self.assertGreater(stock, 10 * large, "the case shows nothing if the stock program does not need it")


if __name__ == "__main__":
    unittest.main()
