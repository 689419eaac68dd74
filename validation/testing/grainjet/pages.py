# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of docs/: their tables, and what they tell the reader to do.

A block of a page counts if the line before it is one of these comments, which a reader does not see:
    <!-- run -->            shell commands, in the folder where the block before ended and with what that exported
    <!-- edit <file> -->    a diff; what it takes away or keeps stands in the file once, as it is
    <!-- create <file> -->  a new file
    <!-- shows -->          what the commands before print, line by line: all words and the form;
                            numbers may differ (they are those of one run), a line "..." leaves out any
"""

import pathlib
import re
from typing import List

from grainjet.programs import run

BLOCK = re.compile(r"^<!-- (run|edit|create|shows)(?: (\S+))? -->\n```\w*\n(.*?)^```$", re.M | re.S)
NUMBER = re.compile(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?")
DATE = re.compile(r"\b(Mon|Tue|Wed|Thu|Fri|Sat|Sun) (Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec)\b")

# The pages that are followed, each with its test
FOLLOWED = {"docs/tutorial.md": "cases/tutorial/tests/case_tutorial.py", "docs/tutorial_cluster.md": "cases/tutorial/tests/case_tutorial.py",
            **{f"docs/tutorial_{name}.md": f"cases/tutorial/tests/case_tutorial_{name}.py"
               for name in ("bed", "coldSpray", "erosion", "model", "nozzle")}}

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
    comments, counted = len(re.findall(r"^<!--", page, re.M)), len(blocks(page))
    if comments != counted:
        raise AssertionError(f"of {comments} comments of the page {counted} are known: one is misspelt, or has no block")
    here, printed, exported = folder, "", MPI
    for action, name, content in blocks(page):
        if action == "edit":
            (here/name).write_text(edited((here/name).read_text(), content))
        elif action == "create":
            if (here/name).exists():
                raise AssertionError(f"{name} is there already")
            (here/name).parent.mkdir(parents=True, exist_ok=True)
            (here/name).write_text(content)
        elif action == "shows":
            line = missing(content, printed)
            if line is not None:
                raise AssertionError(f"not printed: {line}\nof\n{content}\nbut\n{printed[-6000:]}")
        else:
            ends = folder/"ends"
            ran = run(["bash", "-euc", f"trap 'pwd > {ends}; env -0 >> {ends}' EXIT\n{content}"], here, env=exported)
            if ran.code:
                raise AssertionError(f"{content}\n{ran}")
            place, _, variables = ends.read_text().partition("\n")
            exported = dict(item.split("=", 1) for item in variables.split("\0") if "=" in item)
            here, printed = pathlib.Path(place), ran.output
    return here


def table_of_page(text: str, heading: str) -> List[str]:
    """The names in the first column of the Markdown table below a heading, without their backticks; cells
    with several names give several. A test compares them with its own table, so that an entry of
    the page without coverage fails."""
    lines = text.splitlines()
    at = next(i for i, line in enumerate(lines) if line.lstrip("# ") == heading and line.startswith("#"))
    names = []
    for line in lines[at + 1:]:
        if line.startswith("#"):
            break
        if line.startswith("|") and "`" in line.split("|")[1]:
            names += line.split("|")[1].split("`")[1::2]
    return names
