# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of fix fluid/heat: its blocks run in stock LIGGGHTS."""
# processors: 1

import re
import unittest

import grainjet
from heat_case import BOX, HEAD, HeatCase, ONE

PAGE = (grainjet.ROOT / "docs/fix_fluid_heat.md").read_text()
BLOCKS = re.findall(r"^```liggghts\n(plugin load .*?)^```$", PAGE, re.M | re.S)


class Page(HeatCase):

    def test_blocks(self):
        self.assertEqual(len(BLOCKS), 2)
        for block in BLOCKS:
            head = HEAD.replace("plugin load fluidheatplugin.so", "").format(sort="0 0", boundary="f f f", processors="* 1 1", plugins="")
            result = self.liggghts(f"{head}{BOX}neighbor 0.0005 bin\n{ONE}\n{block}\nfix i all nve/sphere\ntimestep 1e-5\nthermo 10\nrun 10")
            self.assertNotIn("WARNING", result.output)
        self.assertTrue((self.folder / "grains.0.txt").exists())

    def test_table_of_laws(self):
        """Numbers of the theory's table, to the digits printed, by the formulas beside it."""
        text = (grainjet.ROOT / "docs/theory-heat.md").read_text()
        rows = {name: [float(cell) for cell in cells.split("|")] for name, cells in
                re.findall(r"^\| (`\w+`(?:, \$\\varepsilon\$ = [\d.]+)?)[^|]* \|((?: [\d.]+ \|){4} [\d.]+) \|$", text, re.M)}
        cube = 0.7 ** (1 / 3)

        def gunn(re, eps):
            return ((7 - 10 * eps + 5 * eps ** 2) * (1 + 0.7 * re ** 0.2 * cube)
                    + (1.33 - 2.4 * eps + 1.2 * eps ** 2) * re ** 0.7 * cube)

        laws = {"`ranzMarshall`": lambda re: 2 + 0.6 * re ** 0.5 * cube,
                "`whitaker`": lambda re: 2 + (0.4 * re ** 0.5 + 0.06 * re ** (2 / 3)) * 0.7 ** 0.4,
                r"`gunn`, $\varepsilon$ = 1": lambda re: gunn(re, 1), r"`gunn`, $\varepsilon$ = 0.4": lambda re: gunn(re, 0.4)}
        self.assertEqual(set(rows), set(laws))
        for name, row in rows.items():
            for value, number in zip(row, (0, 1, 10, 100, 1000)):
                self.assertAlmostEqual(value / laws[name](number), 1, delta=0.005, msg=f"{name} Re {number}")


if __name__ == "__main__":
    unittest.main()
