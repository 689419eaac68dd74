# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# label: long
"""docs/tutorial_model.md, done to the letter: a drag law in a library of its own, by the velocity at which its bead hovers."""

import math
import os
import pathlib
import unittest

import grainjet
from grainjet.pages import follow

RHO, NU, RHO_P, D, AIR = 1.2, 1.5e-5, 2500, 1e-4, 0.5


class Model(grainjet.Case):

    def test_page(self):
        if "FOAM_USER_LIBBIN" in os.environ:        # the page builds into the reader's own folder, if there is one
            self.addCleanup(pathlib.Path(os.environ["FOAM_USER_LIBBIN"], "libmyGrainModels.so").unlink, missing_ok=True)
        case = follow((grainjet.ROOT/"docs"/"tutorial_model.md").read_text(), self.folder)

        rows = [line.split() for line in (case/"log.liggghts").read_text().splitlines()]
        velocity = [float(row[2]) for row in rows if len(row) == 3 and row[1] == "1" and row[0].isdigit()][-1]
        slip = AIR - velocity
        # At rest after some 15 response times; air of 0.5 m/s between walls with slip is uniform to the solver's tolerance
        drag = 18*RHO*NU/D**2*(1 + math.sqrt(slip*D/NU)/9.06)**2*slip
        self.assertAlmostEqual(drag/(RHO_P*9.81), 1, delta=1e-4)


if __name__ == "__main__":
    unittest.main()
