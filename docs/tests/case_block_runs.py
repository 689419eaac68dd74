# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each block of the pages, read or run by the program that it is for (grainjet.blocks); a broken one of each kind is found."""
# label: long

import concurrent.futures
import pathlib
import re
import tempfile
import unittest

import grainjet
from grainjet import blocks
from grainjet.pages import FOLLOWED

# these tests run blocks that belong to a longer example
ELSEWHERE = {**FOLLOWED, "docs/loader.md": "liggghts-plugins/loader/tests/case_python.py",
             "docs/fix_collision_stats.md": "liggghts-plugins/collision-stats/tests/case_page.py",
             "docs/fix_plate_stats.md": "docs/tests/case_block_runs.py"}

GOOD = {
    "liggghts": "plugin load fluidforceplugin.so\nfix f all fluid/force coupled\n",
    "diff": "-pair_style gran model hertz\n-pair_coeff * *\n+plugin load hertzcgplugin.so\n+fix c all hertz/cg tangential off\n",
    "foam": "a { b 1; }\n",
    "sh": "source environment\nvalidation/report --collect > log\n",
    "cpp": "const liggghtsplugin_description *liggghtsplugin_init()\n",
    "python": "print(1)\n",
}
BROKEN = {
    "liggghts": ["plugin load fluidforceplugin.so\nfix f all fluid/force coupling\n", "fix f all fluid/force coupled\n", "nonsense 1\n"],
    "diff": ["-pair_style gran model hertz\n-pair_coeff * *\n+plugin load hertzcgplugin.so\n+fix c all hertz/cg tangent off\n",
             "-pair_style gran model hertzz\n-pair_coeff * *\n+fix c all hertz/cg\n"],
    "foam": ["a { b 1; \n", "a { b 1 }\n", "a { b 1; } }\n"],
    "sh": ["validation/reporting --collect\n", "validation/report --colect\n", "validation/report --collect 'x\n", "reprot\n",
           "cp cases/quickjet here\n"],
    "cpp": ["const liggghtsplugin_description *liggghtsplugin_start()\n"],
    "python": ["print(1\n"],
}


def faults(found, folder):
    """Of blocks of any languages."""
    def of(*languages):
        return [block for block in found if block.language in languages]

    def run(block):
        with tempfile.TemporaryDirectory(dir=folder) as name:
            return list(blocks.faults_of_liggghts(block, pathlib.Path(name)))

    said = [f"{block.place}: the language '{block.language}' is none of {' '.join(sorted(blocks.LANGUAGES))}"
            for block in found if block.language not in blocks.LANGUAGES]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for texts in pool.map(run, of("liggghts", "diff")):
            said += texts
    said += blocks.faults_of_foam(of("foam"), folder) if of("foam") else []
    for block in of("sh"):
        said += blocks.faults_of_shell(block, folder)
    for language in ("cpp", "cmake", "make"):
        said += blocks.faults_of_code(of(language), language)
    for block in of("python"):
        said += blocks.faults_of_python(block)
    return said


class Blocks(grainjet.Case):

    def test_the_pages(self):
        found = blocks.of_pages()
        for language in blocks.LANGUAGES:
            self.assertTrue([block for block in found if block.language == language], language)
        self.assertGreater(len(found), 130)
        # what the tutorials tell to do is done by tests of their own
        rest = [block for block in found if not (block.page in ELSEWHERE and block.mark.split()[:1] in (["edit"], ["run"], ["create"]))]
        said = faults(rest, self.folder)
        self.assertFalse(said, "\n".join(said))

    def test_what_runs_elsewhere(self):
        for page in {block.page for block in blocks.of_pages() if block.language == "python" or block.mark.startswith("edit")}:
            self.assertTrue((grainjet.ROOT / ELSEWHERE[page]).is_file(), page)

    def test_density_of_hits(self):
        """The picture's data of fix_plate_stats.md, from events on a square: the density in its middle is that of a uniform one,
        1/m2, but for what the kernel spreads over its sides."""
        block, = (block for block in blocks.of_pages() if (block.page, block.language) == ("docs/fix_plate_stats.md", "python"))
        rows = [f"{(i + 0.5) / 20 - 0.5},{(j + 0.5) / 20 - 0.5},8\n" for i in range(20) for j in range(20)]
        (self.folder / "events.csv").write_text("x,y,particles\n" + "".join(rows))
        (self.folder / "draw.py").write_text(block.text + "print(density([[0.0], [0.0]])[0])\n")
        ran = grainjet.run(["/usr/bin/python3", "draw.py"], self.folder)
        self.assertEqual(ran.code, 0, ran)
        self.assertAlmostEqual(float(ran.output), 1.0, delta=0.1)

    def test_broken_blocks_are_found(self):
        """Of a page with one good block and broken ones of each kind all broken ones are named, and no other."""
        page, broken = "", {}
        for language in GOOD:
            for text in [GOOD[language], *BROKEN[language]]:
                if text != GOOD[language]:
                    broken[f"page:{page.count(chr(10)) + 1}:"] = text
                page += f"```{language}\n{text}```\n"
        said = faults(blocks.of_text(page, "page"), self.folder)
        self.assertEqual({fault.split()[0] for fault in said}, set(broken), "\n".join(said))

    def test_blocks_are_fenced(self):
        """One that is set in by blanks would not be read here."""
        for path in blocks.pages():
            if "benchmarks" in path.parts:
                continue
            text = blocks.FENCE.sub(lambda match: "\n" * match[0].count("\n"), path.read_text())
            self.assertIsNone(re.search(r"(?m)^\n    \S", text), path)

    def test_a_block_without_language_is_found(self):
        self.assertEqual(len(faults(blocks.of_text("```\na\n```\n", "page"), self.folder)), 1)


if __name__ == "__main__":
    unittest.main()
