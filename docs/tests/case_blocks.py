# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the blocks of the pages name is there: programs and files, plugins, styles and libraries, entries of the coupling.

case_block_runs.py and case_block_foam.py read and run them.
"""

import re
import unittest

import grainjet
from grainjet import blocks
from grainjet.pages import table_of_page

# A library, plugin or style of the reader's own in an example
EXAMPLES = {"exampleplugin.so", "plugin/example", "libmyGrainModels.so"}


def registered(kind):
    """The names of styles of one kind that the plugins bring."""
    return {name for path in (grainjet.ROOT / "liggghts-plugins").rglob("*plugin.cpp") if "tests" not in path.parts
            for name in re.findall(rf'\{{"{kind}", "([^"]+)"', path.read_text())}


class Blocks(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.blocks = [(block.page, block.language, block.text) for block in blocks.of_pages()]

    def lines(self, pattern):
        """(page, match) of each line of a block that matches."""
        return [(page, match) for page, _, text in self.blocks for line in text.splitlines()
                for match in re.finditer(pattern, line)]

    def test_blocks_are_found(self):
        self.assertGreater(len(self.blocks), 100)

    def test_each_style_has_a_block_to_paste(self):
        """A page of a fix, command or library has one before its table of words or entries."""
        pages = [*(grainjet.ROOT / "docs").glob("fix_*.md"),
                 *(grainjet.ROOT / f"docs/{name}.md" for name in ("coarsegraining", "loader", "liggghtsCoupling", "jetKEpsilon", "particleSamplingPlanes"))]
        self.assertGreater(len(pages), 12)
        for page in pages:
            self.assertRegex(page.read_text(), r"(?s)## A block to paste\n.*?```(?:liggghts|foam)\n.*?\| (?:Word|Entry|keyword).*?\|", page.name)

    def test_programs_and_files_exist(self):
        """Paths that begin with a folder of the project, and its scripts."""
        found = self.lines(r"(?<![\w/.>-])(?:\./)?((?:cases|validation|openfoam-libs|liggghts-plugins|docs)/[\w/.-]*\w|All(?:wmake|test|wclean))\b")
        self.assertGreater(len(found), 20)
        lost = {f"{page}: {match[1]}" for page, match in found if not (grainjet.ROOT / match[1]).exists()}
        self.assertFalse(lost, "\n".join(sorted(lost)))

    def test_plugins_exist(self):
        targets = {f"{name}.so" for path in (grainjet.ROOT / "liggghts-plugins").rglob("CMakeLists.txt")
                   for name in re.findall(r"grainjet_plugin\((\w+)", path.read_text())}
        found = self.lines(r"plugin load (\w+\.so)")
        self.assertGreater(len(found), 10)
        self.assertEqual({match[1] for _, match in found} - targets - EXAMPLES, set())

    def test_styles_exist(self):
        """Fixes whose names begin like one of Grainjet's."""
        ours = registered("fix")
        self.assertLessEqual({"hertz/cg", "fluid/force", "plate/stats"}, ours)
        rooms = {name.split("/")[0] for name in ours if name.split("/")[0] not in ("wall",)}
        found = self.lines(r"^\s*fix\s+\S+\s+\S+\s+(\S+)")
        named = {match[1] for _, match in found}
        self.assertTrue(ours & named)
        self.assertEqual({name for name in named if name.split("/")[0] in rooms} - ours - EXAMPLES, set())

    def test_libraries_exist(self):
        built = {f"{name.split('/')[-1]}.so" for path in (grainjet.ROOT / "openfoam-libs").glob("**/Make/files")
                 for name in re.findall(r"(?m)^LIB\s*=\s*(\S+)", path.read_text())}
        found = self.lines(r"libs\s*\(\"(lib\w+\.so)\"")
        self.assertGreater(len(found), 3)
        self.assertEqual({match[1] for _, match in found} - built - EXAMPLES, set())

    def test_entries_of_the_coupling_are_known(self):
        """In each dictionary with `type liggghtsCoupling;`, the names at its first level."""
        page = (grainjet.ROOT / "docs/liggghtsCoupling.md").read_text()
        known = set(table_of_page(page, "Entries")) | {"type"}
        found = 0
        for name, _, text in self.blocks:
            for match in re.finditer(r"(?ms)^\w+\s*\n\{\s*\n(.*?)^\}", text):
                if not re.search(r"\btype\s+liggghtsCoupling;", match[1]):
                    continue
                found += 1
                body = re.sub(r"//[^\n]*", "", match[1])
                while re.search(r"\{[^{}]*\}", body):
                    body = re.sub(r"\{[^{}]*\}", ";", body)
                used = {entry.split()[0] for entry in body.split(";") if entry.split()}
                self.assertEqual({entry for entry in used if re.fullmatch(r"\w+", entry)} - known, set(), name)
        self.assertGreater(found, 2)


if __name__ == "__main__":
    unittest.main()
