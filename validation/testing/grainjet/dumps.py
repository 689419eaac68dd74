# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What LIGGGHTS writes by `dump custom`."""

import pathlib
from typing import List, NamedTuple

import numpy


class Frame(NamedTuple):
    """One time of a dump."""
    step: int
    columns: List[str]
    rows: List[List[float]]

    def by_id(self):
        """{id: the other values}; the first column must be the id."""
        if self.columns[:1] != ["id"]:
            raise AssertionError(f"the first column is not id: {self.columns}")
        found = {int(row[0]): row[1:] for row in self.rows}
        if len(found) != len(self.rows):
            raise AssertionError(f"an id is there twice at step {self.step}")
        return found

    def array(self):
        """All values as an array, a row per grain, sorted by the first column."""
        rows = numpy.array(self.rows).reshape(len(self.rows), len(self.columns))
        return rows[numpy.argsort(rows[:, 0])]


def frames(path):
    """All times of a dump, in order."""
    found, lines = [], pathlib.Path(path).read_text().splitlines()
    at = 0
    while at < len(lines):
        if lines[at] != "ITEM: TIMESTEP" or lines[at + 2] != "ITEM: NUMBER OF ATOMS":
            raise AssertionError(f"{path}, line {at + 1}: not the head of a frame: {lines[at]}")
        step, count = int(lines[at + 1]), int(lines[at + 3])
        while not lines[at].startswith("ITEM: ATOMS"):
            at += 1
        columns = lines[at].split()[2:]
        rows = [[float(word) for word in line.split()] for line in lines[at + 1:at + 1 + count]]
        if len(rows) != count or any(len(row) != len(columns) for row in rows):
            raise AssertionError(f"{path}: step {step} is not complete")
        found.append(Frame(step, columns, rows))
        at += 1 + count
    if not found:
        raise AssertionError(f"{path} is empty")
    return found


def last(path):
    """{id: the other values} of the last time of a dump."""
    return frames(path)[-1].by_id()


def array(path):
    """The last time of a dump as an array, a row per grain, sorted by id."""
    return frames(path)[-1].array()
