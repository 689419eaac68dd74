# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/gallery.md has a picture for each case, below 300 kB, and its animation moves and is below 3 MB."""

import re
import unittest

import grainjet

PAGE = grainjet.ROOT / "docs/gallery.md"


class Gallery(unittest.TestCase):

    def test_each_case_has_its_picture(self):
        text = PAGE.read_text()
        cases = {path.parent.name for path in (grainjet.ROOT / "cases").glob("*/Allrun")}
        self.assertGreater(len(cases), 6)
        for name in cases:
            # the title with the case's name, its command, its picture, its page
            self.assertRegex(text, rf"(?s)## {name}: .*?cases/{name}/Allrun.*?\(images/{name}\.png\).*?\({name}\.md\)")

    def test_pictures_are_small(self):
        pictures = {(PAGE.parent / name).resolve() for name in re.findall(r"!\[[^\]]+\]\(([^)]+)\)", PAGE.read_text())}
        self.assertGreater(len(pictures), 9)
        for path in pictures:
            data = path.read_bytes()
            animated = path.suffix == ".gif"
            self.assertLess(len(data), 3e6 if animated else 3e5, path)
            self.assertTrue(data.startswith(b"GIF89a" if animated else b"\x89PNG"), path)
            if animated:
                # each frame has a block of its own in the file
                self.assertGreater(data.count(b"\x21\xf9\x04"), 10)


if __name__ == "__main__":
    unittest.main()
