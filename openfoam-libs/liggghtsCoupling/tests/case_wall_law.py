# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The law of the wall at grains, in flows that are imposed on the mesh."""
# processors: 2

import math
import random
import unittest

import grainjet
from grainjet import wall_flow

NU, U_TAU, RADIUS = 1.5e-5, 0.55, 0.015         # Re_tau 550


class WallLaw(grainjet.Case):

    def pipe(self, y_plus, profile, interpolation, wall_law, n=1000, ranks=0):
        """rms error of the axial velocity in the wall cells, relative to that in their centres."""
        pipe = wall_flow.Pipe(RADIUS, 2 * y_plus * NU / U_TAU)
        folder = self.new_folder()
        centres = wall_flow.mesh(folder, pipe.mesh(), nu=NU, steps=1, delta_t=1e-4)

        def u(p):
            return U_TAU * profile(pipe.distance(p) * U_TAU / NU)

        cells = len(centres)
        wall_flow.impose(folder, [(0, 0, u(p)) for p in centres], k=[U_TAU ** 2 / 0.3] * cells,
                         epsilon=[U_TAU ** 3 / (0.41 * pipe.distance(p)) for p in centres])
        rng = random.Random(3)
        height = 2 * y_plus * NU / U_TAU
        places = [pipe.place(rng, 0, height) for _ in range(n)]
        rows = wall_flow.sample(self, folder, places, box=pipe.box(), ranks=ranks,
                                options={"interpolation": interpolation, "wallLaw": wall_law})
        scale = U_TAU * profile(y_plus)
        return math.sqrt(sum((row[2] - u(p)) ** 2 for row, p in zip(rows, places)) / n) / scale

    def test_pipe(self):
        for y_plus in (15, 30, 60, 100):
            print(y_plus, [round(100 * self.pipe(y_plus, p, i, w), 2) for p in (wall_flow.spalding, wall_flow.reichardt) for i, w in
                           (("cell", "no"), ("cellPoint", "no"), ("cellPoint", "yes"))])


if __name__ == "__main__":
    unittest.main()
