# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/new_model.md shows the library in tests/userModels as it is."""

import pathlib
import re
import unittest

import grainjet

PAGE = (grainjet.ROOT / "docs/new_model.md").read_text()
LIBRARY = pathlib.Path(__file__).parent / "userModels"
FORCES = LIBRARY.parents[1] / "forces"


class NewModelPage(unittest.TestCase):

    def test_code(self):
        """Each block of code stands in the file that the text names last before it."""
        blocks = list(re.finditer(r"```cpp\n(.*?)```", PAGE, re.DOTALL))
        self.assertGreater(len(blocks), 9)
        for block in blocks:
            names = re.findall(r"`(\w+\.[CH])`", PAGE[:block.start()])
            source = next(room / names[-1] for room in (LIBRARY, FORCES) if (room / names[-1]).exists()).read_text()
            self.assertIn(block.group(1), source, names[-1])

    def test_make(self):
        for name in ("files", "options"):
            text = (LIBRARY / "Make" / name).read_text()
            self.assertIn(f"```make\n{text}```", PAGE)

    def test_classes(self):
        """All of the library are in the table at the top, and all files of the table are there."""
        table = PAGE[:PAGE.index("## Build and use it")]
        for source in LIBRARY.glob("*.C"):
            self.assertIn(f"`{source.stem}`", table)
            self.assertIn(source.name, (LIBRARY / "Make/files").read_text())

    def test_quantities(self):
        """The table of the coupling's page has those that the program offers after an unknown one."""
        page = (grainjet.ROOT / "docs/liggghtsCoupling.md").read_text()
        table = page[page.index("## Adding a model"):]
        documented = set(re.findall(r"(?m)^\| `(\w+)` \|", table))
        fluid = LIBRARY.parent.parent / "fluid"
        offered = {name for file in ("standardQuantities.C", "turbulenceQuantities.C", "gasQuantities.C",
                                          "accelerationQuantity.H")
                   for name in re.findall(r'TypeName\("(\w+)"\)', (fluid / file).read_text())}
        self.assertEqual(documented, offered)
        header = (fluid / "fluidQuantity.H").read_text()
        listed = set(re.findall(r"(?m)^        (\w+) +\| (?:scalar|vector) ", header))
        self.assertEqual(listed, offered)


if __name__ == "__main__":
    unittest.main()
