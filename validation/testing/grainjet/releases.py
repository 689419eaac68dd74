# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What differs between the releases of OpenFOAM in what tests read, under names of one meaning each.

Tests do not ask for the release. The libraries have the same in openfoam-libs/tools/releases.H.
"""

import functools
import re

from grainjet.programs import ROOT, run


@functools.lru_cache(maxsize=None)
def openfoam():
    """The release of the programs that tests run, as 2412."""
    result = run(["blockMesh", "-help"], ROOT)
    found = re.search(r"Using: OpenFOAM-\S* \((\d{4})\)", result.output)
    if not found:
        raise AssertionError(f"blockMesh -help names no release of OpenFOAM: {result}")
    return int(found[1])


def nested(*names):
    """The name of a dictionary within others, as OpenFOAM prints it."""
    return ("/" if openfoam() >= 2312 else ".").join(names)


def atmospheric_wall_function():
    """The wall function of nut by k in libatmosphericModels."""
    return "atmNutkWallFunction" if openfoam() >= 2006 else "nutkAtmRoughWallFunction"
