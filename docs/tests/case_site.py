# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/build-site makes the web pages without a warning, and they need no connection."""

import json
import pathlib
import re
import shutil
import sys
import unittest

import grainjet


class Site(grainjet.Case):

    def test_web_pages(self):
        site = self.folder / "site"
        result = grainjet.run([str(grainjet.ROOT / "docs/build-site"), str(site)], self.folder)
        self.assertEqual(result.code, 0, result)
        self.assertNotIn("WARNING", result.output)
        pages = list(site.rglob("*.html"))
        self.assertLessEqual({site / "index.html", site / "docs/fix_hertz_cg.html", site / "cases/index.html",
                              site / "validation/index.html"}, set(pages))
        # guides come first in the search: the index has their weight, its reader takes it
        entries = json.loads((site / "search/search_index.json").read_text())["docs"]
        weighed = {entry["location"].partition("#")[0] for entry in entries if entry.get("boost", 1) > 1}
        self.assertLessEqual({"docs/troubleshooting.html", "docs/choosing.html", "docs/tutorial.html", "docs/tutorial_nozzle.html"}, weighed)
        self.assertFalse([name for name in weighed if "fix_" in name or "theory" in name or name.startswith("validation")])
        reader, = site.glob("assets/javascripts/workers/search.*.js")
        self.assertRegex(reader.read_text(), r"this\.add\((\w+),\{boost:\1\.boost")
        for page in pages:
            text = page.read_text()
            fetched = re.findall(r'<(?:script|link|img)[^>]*(?:src|href)="(https?:[^"]*)"', text)
            self.assertFalse([address for address in fetched if "canonical" not in address], page.name)
            words = re.sub(r"(?s)<(pre|code|script)\b.*?</\1>", "", text)
            self.assertFalse("$$" in words, f"{page.name}: a formula is not set")
            if page.name == "404.html":
                continue
            for target, fragment in re.findall(r'<a [^>]*href="([^":#]*)#([^"]+)"', text):
                other = (page.parent / target).resolve() if target else page
                self.assertIn(f'id="{fragment}"', other.read_text(), f"{page.name}: {target}#{fragment}")

    def test_formulas(self):
        """Each command of a formula is one of KaTeX."""
        known = pathlib.Path("/usr/share/javascript/katex/katex.min.js").read_text()
        used = set()
        for path in (grainjet.ROOT / "docs").glob("*.md"):
            text = re.sub(r"(?s)```.*?```|`[^`\n]*`", "", path.read_text())
            for formula in re.findall(r"(?s)\$\$(.+?)\$\$|\$([^$\n]+)\$", text):
                used |= set(re.findall(r"\\([A-Za-z]+)", "".join(formula)))
        self.assertGreater(len(used), 30)
        self.assertEqual({name for name in used if f'"\\\\{name}"' not in known}, set())

    def test_help(self):
        """Nothing is made."""
        for word in ("--help", "-h"):
            result = grainjet.run([str(grainjet.ROOT / "docs/build-site"), word], self.folder)
            self.assertEqual(result.code, 0, result)
            self.assertIn("Usage: docs/build-site [folder]", result.output)
            self.assertIn("by default in build/site", result.output)
        self.assertEqual(list(self.folder.iterdir()), [])
        self.assertFails(grainjet.run([str(grainjet.ROOT / "docs/build-site"), "--helper"], self.folder), "unknown arguments: --helper")

    def test_a_folder_with_other_files_is_kept(self):
        (self.folder / "site").mkdir()
        (self.folder / "site/mine").write_text("mine")
        result = grainjet.run([str(grainjet.ROOT / "docs/build-site"), str(self.folder / "site")], self.folder)
        self.assertNotEqual(result.code, 0)
        self.assertIn("holds other files", result.output)
        self.assertEqual((self.folder / "site/mine").read_text(), "mine")


if __name__ == "__main__":
    theme = pathlib.Path("/usr/share/mkdocs/themes/material")
    katex = pathlib.Path("/usr/share/javascript/katex/katex.min.js")
    if shutil.which("mkdocs") is None or not theme.is_dir() or not katex.is_file():
        print("skipped: the web pages need the packages mkdocs, mkdocs-material and libjs-katex")
        sys.exit(77)
    unittest.main()
