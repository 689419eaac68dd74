# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables: those that Grainjet writes below `postProcessing/`, columns by name as numpy arrays, those that
LIGGGHTS prints, and those of a comparison, rows of texts."""

import csv
import pathlib
import re

import numpy


def read(path):
    """{column: values} of a table whose last `#` line names the columns, separated by tabs."""
    names = None
    with open(path) as lines:
        for line in lines:
            if not line.startswith("#"):
                break
            names = [name.strip() for name in line[1:].strip().split("\t")]
    rows = numpy.loadtxt(path, comments="#", ndmin=2)
    if names is None or rows.shape[1] != len(names):
        raise ValueError(f"{path}: {len(names or [])} column names for {rows.shape[1]} columns")
    return dict(zip(names, rows.T))


def starts(folder):
    """The subfolders of a function object's folder, one per start of the solver, in order."""
    found = [entry for entry in pathlib.Path(folder).iterdir() if entry.is_dir()]
    if not found:
        raise FileNotFoundError(f"{folder}: no results there")
    return sorted(found, key=lambda entry: float(entry.name))


def history(folder, name):
    """A table with a column Time, joined over all starts; where they overlap the later one holds.

    OpenFOAM names the table of a second start from the same time name_<time>.dat."""
    parts = [read(max(start.glob(f"{name}*.dat"), key=lambda path: path.stat().st_mtime))
             for start in starts(folder)]
    for earlier, later in zip(parts, parts[1:]):
        kept = earlier["Time"] < later["Time"][0]
        earlier.update({column: values[kept] for column, values in earlier.items()})
    return {column: numpy.concatenate([part[column] for part in parts]) for column in parts[0]}


def courant(folder):
    """The largest Courant number in the logs of the solver (log.pimpleFoam*) of a case."""
    return max(float(number) for log in pathlib.Path(folder).glob("log.pimpleFoam*")
               for number in re.findall(r"Courant Number mean: \S+ max: (\S+)", log.read_text()))


def planes(folder):
    """{position in diameters: path} of the files of a particleSamplingPlanes object, in order."""
    found = {float(re.fullmatch(r"plane_(.+)D", path.stem)[1]): path
             for path in starts(folder)[-1].glob("plane_*D.dat")}
    return dict(sorted(found.items()))


def stated(path):
    """{name: value} of the numbers stated as `name = value` in the `#` lines of a table. In a line
    with a title the key is `title: name`."""
    found = {}
    with open(path) as lines:
        for line in lines:
            if not line.startswith("#"):
                break
            title = re.match(r"# ([^=:]+): ", line)
            for name, value in re.findall(r"([A-Za-z][\w ./]*?) = ([-+\d.eE]+)", line):
                found[f"{title[1]}: {name.strip()}" if title else name.strip()] = float(value)
    return found


def thermo(output):
    """The rows of numbers that LIGGGHTS printed in its tables of a run, one after the other."""
    rows, reading = [], False
    for line in output.splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            reading = True
        elif line.startswith("Loop time"):
            reading = False
        elif reading and words and words[0].isdigit():
            rows.append([float(word) for word in words])
    return rows


def printed(output):
    """{name: value} of the lines `name = value` that `print` has left; the last one of a name holds."""
    return {name: float(value) for name, value in re.findall(r"(?m)^(\w+) = ([-+.\deE]+|-?nan|-?inf)$", output)}


def write(path, rows):
    """Write rows into a CSV file, whose folder is made."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as out:
        csv.writer(out, lineterminator="\n").writerows(rows)


def show(rows):
    """Print rows of texts, the first one with the heads, as a table in Markdown."""
    heads, *lines = ("| " + " | ".join(row) + " |" for row in rows)
    print(heads, "|---"*len(rows[0]) + "|", *lines, sep="\n", flush=True)
