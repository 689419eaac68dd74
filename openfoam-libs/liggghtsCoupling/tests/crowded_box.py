# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A box crowded with grains, for tests with the void fraction in the fluid's equations."""

import random
import re

import numpy

CELL_VOLUME = 0.002 ** 3            # of the box of 10 x 10 x 20 cells
CONVERGED = "nOuterCorrectors 30; nCorrectors 2;"


def crowd(n=5000, seed=3, height=0.02):
    """Grains of 1 mm that overlap as they please, without contacts: up to the least void fraction."""
    rng = random.Random(seed)
    x = [[rng.uniform(0, a) for a in (0.02, 0.02, height)] for _ in range(n)]
    v = [[rng.gauss(mean, 0.2) for mean in (0, 0, 0.5)] for _ in range(n)]
    return x, v


def values(path):
    """A field of the cells as an array, also one without boundary."""
    text = path.read_text()
    found = text[re.search(r"\b(internalField|value)\s", text).start():]
    if "nonuniform" not in found[:40]:
        return numpy.zeros((1, 3))
    rows = re.findall(r"^\(([^()\n]+)\)$", found, re.M)
    return numpy.array([[float(c) for c in row.split()] for row in rows])


def of_fluid(folder, rho):
    """Momentum of the fluid between the grains, rho (U - q) V, with what it is still owed, in N s."""
    sums = values(folder / "U").sum(0) - values(folder / "solidsFlux").sum(0)
    debts = (values(folder / name).sum(0) for name in ("particleMomentumOwed", "momentumOfShares"))
    return rho * CELL_VOLUME * sums + sum(debts)
