# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""docs/tutorial.md, done to the letter: every block of it in the order of the page.

A block counts if the line before it is one of these comments, which a reader of the page does not see:
    <!-- run -->            shell commands, in the folder where the block before ended
    <!-- edit <file> -->    a diff; what it takes away or keeps stands in the file once, as it is
    <!-- create <file> -->  a new file
    <!-- shows -->          what the commands before print, line by line: all words and the form;
                            numbers may differ (they are those of one run), a line "..." leaves out any
"""

import pathlib
import re
import unittest

import grainjet

PAGE = grainjet.ROOT/"docs"/"tutorial.md"
BLOCK = re.compile(r"^<!-- (run|edit|create|shows)(?: (\S+))? -->\n```\w*\n(.*?)^```$", re.M | re.S)
NUMBER = re.compile(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?")
DATE = re.compile(r"\b(Mon|Tue|Wed|Thu|Fri|Sat|Sun) (Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec)\b")

# Where the page says `mpirun -np 2` the test may run as root and on one core
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def blocks(text):
    """(action, file, content) of each block that counts."""
    return [match.groups() for match in BLOCK.finditer(text)]


def edited(text, diff):
    """A text after a diff without line numbers."""
    lines = diff.splitlines(keepends=True)
    old = "".join(line[1:] or "\n" for line in lines if line[0] in " -\n")
    new = "".join(line[1:] or "\n" for line in lines if line[0] in " +\n")
    if text.count(old) != 1:
        raise AssertionError(f"found {text.count(old)} times instead of once:\n{old}")
    return text.replace(old, new)


def form(line):
    """A line without its numbers, its date and the width of its columns."""
    return " ".join(NUMBER.sub("#", DATE.sub("#", line)).split())


def missing(shown, printed):
    """The first line of a block that is not in the output, after those before it; else None."""
    lines = iter(form(line) for line in printed.splitlines())
    for line in shown.splitlines():
        if line.strip() != "..." and not any(form(line) == other for other in lines):
            return line
    return None


def follow(page, folder):
    """Does what a page says, beginning in a folder; the folder in which it ends."""
    here, printed = folder, ""
    for action, name, content in blocks(page):
        if action == "edit":
            (here/name).write_text(edited((here/name).read_text(), content))
        elif action == "create":
            if (here/name).exists():
                raise AssertionError(f"{name} is there already")
            (here/name).write_text(content)
        elif action == "shows":
            line = missing(content, printed)
            if line is not None:
                raise AssertionError(f"not printed: {line}\nof\n{content}\nbut\n{printed[-6000:]}")
        else:
            ends = folder/"ends"
            ran = grainjet.run(["bash", "-euc", f"trap 'pwd > {ends}' EXIT\n{content}"], here, env=MPI)
            if ran.code:
                raise AssertionError(f"{content}\n{ran}")
            here, printed = pathlib.Path(ends.read_text().strip()), ran.output
    return here


class Tutorial(grainjet.Case):

    def test_page(self):
        page = PAGE.read_text()

        # no block escapes by a misspelt comment, and the page has blocks
        self.assertEqual(len(re.findall(r"^<!--", page, re.M)), len(blocks(page)))
        self.assertGreater(len(blocks(page)), 10)

        case = follow(page, self.folder)

        # the last of it, in parallel, has really run
        profiles = sorted((case/"postProcessing"/"profiles").glob("*/plane_5D.dat"))
        self.assertEqual(len(profiles), 3, profiles)
        self.assertIn("End", (case/"log.pimpleFoam").read_text().splitlines()[-3:])

    def test_a_page_that_is_wrong_is_noticed(self):
        self.assertEqual(edited("a\nb\nc\n", " a\n-b\n+x\n"), "a\nx\nc\n")
        self.assertRaises(AssertionError, edited, "a\nb\nc\n", "-d\n+e\n")
        self.assertRaises(AssertionError, edited, "a\na\n", "-a\n+e\n")
        self.assertIsNone(missing("grains 5, slip 1.5e-3 m/s\n...\nEnd\n", "x\ngrains 71, slip 2 m/s\ny\nEnd\n"))
        self.assertIsNone(missing("finish time Tue Nov 24 15:33:09 2026", "finish time Sat May 1 08:00:00 2027"))
        self.assertEqual(missing("grains 5\n", "grain 5\n"), "grains 5")
        self.assertEqual(missing("End\nStart\n", "Start\nEnd\n"), "Start")


if __name__ == "__main__":
    unittest.main()
