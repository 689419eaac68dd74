# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each page with blocks that tell what to do has a test that does it, and there is no other (grainjet.pages.FOLLOWED)."""

import unittest

import grainjet
from grainjet.pages import FOLLOWED, blocks


class Followed(unittest.TestCase):

    def test_pages_and_tests(self):
        pages = {str(path.relative_to(grainjet.ROOT)) for path in (grainjet.ROOT / "docs").glob("*.md") if blocks(path.read_text())}
        self.assertEqual(pages, set(FOLLOWED))
        for page, test in FOLLOWED.items():
            self.assertIn(page.rpartition("/")[2], (grainjet.ROOT / test).read_text(), page)


if __name__ == "__main__":
    unittest.main()
