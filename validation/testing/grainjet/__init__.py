# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Grainjet's tests, benchmarks and programs for tables and pictures share, in Python.

    import grainjet                         the basis: Case, run, done, start, mpirun, openfoam_library, ROOT, ENV
    from grainjet import dictionaries ...   the rest, by what it is about

programs        runs the real programs, with the environment of a user
case            Case, a test with a fresh folder
dictionaries    files of an OpenFOAM case: written, changed, read
scripts         what LIGGGHTS reads: dump commands, data files, surfaces
dumps           what LIGGGHTS dumps
tables          tables below postProcessing/ and those in the log of LIGGGHTS; writes and prints some
fields          meshes and clouds of grains, read by VTK
coupled_box     a small coupled case
impacts         impacts of single grains
bad_input       inputs spoilt in every way
messages        errors and warnings, read from the sources
pages           the blocks and tables of the pages in docs/
blocks          all blocks of the pages, read and run by the program that each is for
releases        what differs between the releases of OpenFOAM

It holds no tolerances. A file finds the package by PYTHONPATH, which `source environment` and ctest set.
"""

from grainjet.case import Case
from grainjet.programs import ENV, ROOT, Run, done, liggghts_examples, mpirun, openfoam_library, run, start

__all__ = ["Case", "ENV", "ROOT", "Run", "done", "liggghts_examples", "mpirun", "openfoam_library",
           "run", "start"]
