# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages as a plain Git host shows them: links and anchors lead somewhere, pictures have a text, lines are short."""

import re
import subprocess
import unittest

import grainjet

LONGEST = 160
FENCE = re.compile(r"(?ms)^([ \t]*)(`{3,})[^\n]*\n.*?^\1\2[ \t]*$")
LINK = re.compile(r"(?<!!)\[((?:[^\[\]]|!\[[^\]]*\]\([^)]*\)|\[[^\]]*\])*)\]\(([^()\s]+(?:\([^()]*\)[^()\s]*)?)\)")
FORMULA = re.compile(r"(?s)\$\$(.+?)\$\$|(?<!\$)\$([^$\n]+)\$(?!\$)")
PICTURE = re.compile(r"!\[([^\]]*)\]\(([^()\s]+)\)")
# Tables of many measured figures, or with a cell per entry that a test reads; one of them is written by a program.
# Their other lines are short.
WIDE_TABLES = {"validation/cases/report.md", "validation/benchmarks/coupling/README.md", "validation/benchmarks/dpmfoam/README.md"}
GENERATED = {"validation/cases/report.md"}
# What a program prints cannot be wrapped
SHOWN = re.compile(r"(?ms)^<!-- shows -->\n```.*?^```$")


def pages():
    listed = subprocess.run(["git", "-c", f"safe.directory={grainjet.ROOT}", "ls-files", "-z", "*.md"], cwd=grainjet.ROOT,
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if listed.returncode == 0:
        found = [grainjet.ROOT / name for name in listed.stdout.decode().split("\0") if name]
    else:
        found = [path for part in (".", "docs", "cases", "validation")
                 for path in (grainjet.ROOT / part).glob("*.md" if part == "." else "**/*.md")]
    return [path for path in found if path.is_file()]


def without_code(text):
    """A page without its blocks and spans of code, in which nothing is a link."""
    return re.sub(r"(`+)(?!`).+?(?<!`)\1(?!`)", "`", FENCE.sub("", text), flags=re.S)


def anchor(heading):
    """As GitHub makes it: lower case, no markup, blanks as hyphens, nothing else but letters, digits, - and _."""
    heading = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    heading = re.sub(r"[`*]", "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", heading).replace(" ", "-")


def anchors(text):
    names = []
    for heading in re.findall(r"(?m)^#{1,6} +(.*?)[ #]*$", FENCE.sub("", text)):
        name, number = anchor(heading), 0
        while (name if not number else f"{name}-{number}") in names:
            number += 1
        names.append(name if not number else f"{name}-{number}")
    return set(names) | set(re.findall(r'<a (?:id|name)="([^"]+)"', text))


class Pages(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.texts = {path: path.read_text() for path in pages()}
        cls.anchors = {path: anchors(text) for path, text in cls.texts.items()}

    def named(self, path):
        return str(path.relative_to(grainjet.ROOT))

    def broken(self, path):
        """Links of a page that lead nowhere."""
        plain = without_code(self.texts[path])
        for target in [match[2] for match in LINK.finditer(plain)] + [match[2] for match in PICTURE.finditer(plain)]:
            if re.match(r"[a-z]+:", target):
                continue
            name, _, fragment = target.partition("#")
            there = (path.parent / name).resolve() if name else path
            if not there.exists() or grainjet.ROOT not in (there, *there.parents):
                yield f"{self.named(path)}: ({target}) is no file of this project"
            elif fragment and there.suffix == ".md" and fragment not in self.anchors[there]:
                yield f"{self.named(path)}: ({target}) has no such heading"

    def test_pages_are_found(self):
        names = {self.named(path) for path in self.texts}
        self.assertLessEqual({"README.md", "docs/building.md", "cases/README.md", "validation/README.md"}, names)
        self.assertGreater(sum(len(LINK.findall(without_code(text))) for text in self.texts.values()), 200)

    def test_anchors_are_those_of_git_hosts(self):
        self.assertEqual(anchors("## `fix hertz/cg` and 2 k, [a page](b.md)\n## Twice\n## Twice\n```\n# no heading\n```\n"),
                         {"fix-hertzcg-and-2-k-a-page", "twice", "twice-1"})

    def test_links_lead_somewhere(self):
        broken = [fault for path in self.texts for fault in self.broken(path)]
        self.assertFalse(broken, "\n".join(broken))

    def test_each_page_of_docs_can_be_reached(self):
        """From README.md, directly or over other pages."""
        reached, new = set(), {grainjet.ROOT / "README.md"}
        while new:
            reached |= new
            new = {(path.parent / match[2].partition("#")[0]).resolve() for path in new
                   for match in LINK.finditer(without_code(self.texts[path]))} & set(self.texts) - reached
        self.assertEqual({self.named(path) for path in self.texts if path.parent.name == "docs"}
                         - {self.named(path) for path in reached}, set())

    def test_pictures_have_a_text(self):
        """What a reader who does not see the picture is told: some words."""
        bare = [f"{self.named(path)}: {target}" for path, text in self.texts.items()
                for words, target in PICTURE.findall(without_code(text)) if len(words.split()) < 3]
        self.assertFalse(bare, "\n".join(bare))

    def test_lines_are_short(self):
        """A table that needs longer ones has too many columns or too much text in a cell."""
        long = [f"{self.named(path)}:{number}: {len(line)} characters" for path, text in self.texts.items()
                if self.named(path) not in GENERATED
                for number, line in enumerate(SHOWN.sub(lambda shown: "\n" * shown[0].count("\n"), text).splitlines(), 1)
                if len(line) > LONGEST and not (line.startswith("|") and self.named(path) in WIDE_TABLES)]
        self.assertFalse(long, f"longer than {LONGEST}:\n" + "\n".join(long))

    def test_formulas_are_whole(self):
        """Lines $$ come in pairs; each formula has as many opening as closing braces and brackets of \\left and \\right."""
        found = 0
        for path, text in self.texts.items():
            plain = re.sub(r"`[^`\n]*`", "", FENCE.sub("", text))
            self.assertEqual(len(re.findall(r"(?m)^\$\$$", plain)) % 2, 0, self.named(path))
            for formula in map("".join, FORMULA.findall(plain)):
                found += 1
                self.assertEqual(formula.count("{"), formula.count("}"), f"{self.named(path)}: {formula}")
                self.assertEqual(formula.count("\\left"), formula.count("\\right"), f"{self.named(path)}: {formula}")
        self.assertGreater(found, 300)

    def test_blocks_are_closed(self):
        for path, text in self.texts.items():
            self.assertEqual(len(re.findall(r"(?m)^[ \t]*```", FENCE.sub("", text))), 0, self.named(path))


if __name__ == "__main__":
    unittest.main()
