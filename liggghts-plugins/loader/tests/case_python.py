# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""LIGGGHTS from Python: the block of docs/loader.md as it is printed there."""

import re
import unittest

import grainjet
from loadercase import BOX, LoaderCase

GRAINS = "plugin load fluidforceplugin.so" + BOX + """
create_atoms 1 single 0.25 0.5 0.5 units box
create_atoms 1 single 0.75 0.5 0.5 units box
set group all diameter 1e-3 density 2500
fix wind all fluid/force uniform 1 0 0 density 1.2 viscosity 1.5e-5
fix move all nve/sphere
"""


class Python(LoaderCase):

    def setUp(self):
        super().setUp()
        page = (grainjet.ROOT / "docs/loader.md").read_text()
        self.block, = re.findall(r"(?ms)^```python\n(.*?)^```", page)

    def run_block(self, script=GRAINS, ranks=0, head="", end=None):
        (self.folder / "in.script").write_text(script)
        (self.folder / "run.py").write_text(head + (self.block if end is None else self.block.replace(*end)))
        # ranks that print without a buffer print into each other's lines
        return grainjet.run([*grainjet.mpirun(ranks), "/usr/bin/python3", "run.py"], self.folder, timeout=120,
                            env={"PYTHONUNBUFFERED": ""})

    def speeds(self, result):
        self.assertEqual(result.code, 0, result)
        return [float(x) for x in re.findall(r"grain 1 moves at \[(\S+),", result.output)]

    def test_block_as_printed(self):
        result = self.run_block()
        speeds = self.speeds(result)
        self.assertEqual(len(speeds), 5, result)
        # dragged along by the wind, faster each time
        self.assertGreater(speeds[0], 0)
        self.assertEqual(speeds, sorted(speeds))

        # LIGGGHTS under the launcher does the same to the last digit
        stock = self.liggghts(GRAINS + 5 * "run 100\n" + "variable v equal vx[1]\nprint \"speed ${v}\"\n")
        self.assertAlmostEqual(float(re.findall(r"speed (\S+)", stock.output)[-1]), speeds[-1], delta=1e-12 * speeds[-1])

        parallel = self.speeds(self.run_block(ranks=2))
        self.assertEqual(len(parallel), 10)
        self.assertEqual(sorted(parallel), sorted(2 * speeds))

    def test_error_ends_python(self):
        result = self.run_block(script=GRAINS + "fix wind2 all fluid/force coupled\n")
        self.assertEqual(result.code, 1, result)
        self.assertEqual(result.output.count("ERROR"), 1, result)
        self.assertNotIn("grain 1 moves", result.output)

    def test_preloaded(self):
        """The other way the page names: LD_PRELOAD, with none of the lines before CDLL("libliggghts...")."""
        begin, end = self.block.index("loader = "), self.block.index("lib = ")
        (self.folder / "in.script").write_text(GRAINS)
        (self.folder / "run.py").write_text(self.block[:begin] + self.block[end:])
        command = ["/usr/bin/python3", "run.py"]
        result = grainjet.run(command, self.folder, env={"LD_PRELOAD": grainjet.ROOT / "lib/liggghtsloader.so"})
        self.assertEqual(len(self.speeds(result)), 5, result)
        self.assertFails(grainjet.run(command, self.folder), "Unknown command: plugin")


if __name__ == "__main__":
    unittest.main()
