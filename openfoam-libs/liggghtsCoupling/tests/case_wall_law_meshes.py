# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The law of the wall on the meshes that users have."""
# processors: 2
# label: long

import math
import random
import unittest

import grainjet
import meshes
from grainjet import wall_flow

NU, U = 1.5e-5, (1.0, 0.4, 2.0)
BOX = " ".join(f"0 {side}" for side in meshes.SIZE)


class WallLawMeshes(grainjet.Case, meshes.EachMesh):

    def on_mesh(self, name):
        """One velocity in all cells, far from what the law has: at the grains it is finite, hardly larger (where cells
        of different height meet, velocity over law and law are interpolated apart: a quarter is the bound, 16 % what
        the tetrahedra have), and the same on 1 and 2 ranks."""
        make, inside = meshes.MESHES[name]
        folder = self.new_folder()
        wall_flow.coupled_box.write(folder, walls=True, through=True, steps=1, nu=NU)
        wall_flow.turbulent(folder)
        make(folder)
        cells = len(wall_flow.centres(folder))
        wall_flow.impose(folder, [U] * cells, k=[0.05] * cells, epsilon=[5.0] * cells)

        rng = random.Random(1)
        low = (0, -0.02, 0) if name == "wedge" else (0, 0, 0)
        places = [p for p in ([rng.uniform(a + 2e-5, b - 2e-5) for a, b in zip(low, meshes.SIZE)] for _ in range(3000))
                  if inside(p)]
        box = f"0 0.02 -0.02 0.02 0 {meshes.SIZE[2]}" if name == "wedge" else BOX
        found = {}
        for key, wall_law, ranks in (("serial", "yes", 0), ("parallel", "yes", 2), ("off", "no", 0)):
            if ranks:
                meshes.decompose(folder, ranks)
            found[key] = wall_flow.sample(folder, places, box=box, boundary="f f f", ranks=ranks,
                                          options={"wallLaw": wall_law})
        speed = math.hypot(*U)
        changed = 0
        for place, a, b, off in zip(places, found["serial"], found["parallel"], found["off"]):
            self.assertTrue(all(map(math.isfinite, a)), place)
            self.assertLess(math.hypot(*a), 1.25 * speed, place)
            for x, y in zip(a, b):
                self.assertAlmostEqual(x, y, delta=1e-9, msg=f"{place}: {a}, {b}")
            changed += a != off
        self.assertGreater(changed, 0.05 * len(places))


if __name__ == "__main__":
    unittest.main()
