# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coupled runs on meshes that users have: the same on any number of ranks, the balance closes."""
# processors: 4
# label: long

import math
import random
import re
import shutil
import unittest

from grainjet import coupled_box as box, dictionaries, dumps, scripts
import meshes

STEPS = 4
DIAMETER, DENSITY = 4e-4, 2500.0

# entries of the fields on patches other than walls, inlet and outlet
FIELDS = {
    "wedge": '"front|back" { type wedge; }',
    "unmatched": '"below|above|zlo|zhi" { type cyclicAMI; value $internalField; }',
}


class MeshesRuns(meshes.EachMesh, box.CoupledCase):

    def prepare(self, name):
        """A case on a mesh, with 300 grains that fly in all directions up to a quarter of a cell's width in a step."""
        folder = self.folder / name / "case"
        box.write(folder, steps=STEPS, velocity="(0.1 0 1)", walls=True, through=name != "unmatched")
        # the linear solvers go on to round-off, and the pressure is corrected where it is not orthogonal
        solution = folder / "system/fvSolution"
        solution.write_text(solution.read_text().replace("1e-13", "1e-16").replace("1e-14", "1e-16")
                            .replace("nNonOrthogonalCorrectors 0", "nNonOrthogonalCorrectors 1"))
        make, inside = meshes.MESHES[name]
        make(folder)
        for field in ("U", "p"):
            path = folder / "0" / field
            path.write_text(re.sub(r"\}\s*$", FIELDS.get(name, "") + " }\n", path.read_text()))

        rng = random.Random(6)
        low = (0, -0.001, 0) if name == "wedge" else (0, 0, 0)
        places = []
        while len(places) < 300:
            p = [rng.uniform(a + 5e-4, side - 5e-4) for a, side in zip(low, meshes.SIZE)]
            if name == "wedge":
                p[1] = rng.uniform(-8e-4, 8e-4)
            # no contacts: the grains' momentum is that of the fluid's forces alone
            if inside(p) and all(math.dist(p, q) > 2 * DIAMETER for q in places):
                places.append(p)
        # along the thin side of the wedge slowly
        speeds = (5, 0.3 if name == "wedge" else 5, 5)
        self.velocities = [[rng.uniform(-speed, speed) for speed in speeds] for _ in places]
        box.script(folder, grains=box.grains(places, self.velocities, DIAMETER, DENSITY),
                   box=f"-0.01 0.03 -0.01 0.03 {'-0.01 0.05' if name != 'unmatched' else '0 0.04'}",
                   boundary="f f f" if name != "unmatched" else "f f p",
                   end=scripts.dump(10 * STEPS, "grains.dump", box.MOTION))
        box.fv_options(folder)
        return folder

    def run_on(self, case, ranks=0):
        """Run a copy of the case."""
        folder = case.parent / f"on{ranks}"
        shutil.copytree(case, folder)
        if ranks:
            meshes.decompose(folder, ranks)
        self.foam("pimpleFoam", folder, ranks)
        if ranks:
            self.foam("reconstructPar", folder)
        return folder

    def on_mesh(self, name):
        """Fields and grains on 2 and 4 ranks are those of the serial run to 1e-11 of the largest value:
        round-off of sums and of the linear solvers. A grain or a part of one in another cell would be
        1e-5 or more.

        The balance closes to 1e-10 by the coupling's own count, and from an independent one: what the
        table says was given to the grains is the change of their momentum, to 1e-9 of the sum of the
        amounts. Cells hold the volume of the grains (1e-10, by the volumes that writeCellVolumes gives)."""
        case = self.prepare(name)
        time = f"{STEPS * 1e-4:.10g}"
        serial = self.run_on(case)
        for ranks in (2, 4):
            with self.subTest(ranks=ranks):
                self.compare(serial, self.run_on(case, ranks), time, 1e-11)

        mass = DENSITY * math.pi / 6 * DIAMETER ** 3
        for folder in case.parent.glob("on*"):
            balance = box.read_balance(folder)
            self.assertLess(max(balance["imbalance"]), 1e-10)
            self.assertEqual(set(balance["unaccounted"]), {0})
            after = dumps.last(folder / "grains.dump")
            self.assertEqual(len(after), 300)
            amounts = sum(math.hypot(*given) for given in zip(*(balance[f"toGrains_{c}"] for c in "xyz")))
            self.assertGreater(amounts, 0)
            for k, c in enumerate("xyz"):
                change = mass * math.fsum(row[3 + k] - self.velocities[tag - 1][k] for tag, row in after.items())
                self.assertAlmostEqual(sum(balance[f"toGrains_{c}"]), change, delta=1e-9 * amounts)

        meshes.program(serial, "postProcess", "-func", "writeCellVolumes", "-time", time)
        volumes = dictionaries.internal(serial / time / "V")
        eps = dictionaries.internal(serial / time / "voidFraction")
        balance = box.read_balance(serial)
        solid = math.fsum((1 - e) * v for e, v in zip(eps, volumes)) + balance["volumeCut"][-1]
        expected = (300 - balance["outsideMesh"][-1]) * math.pi / 6 * DIAMETER ** 3
        self.assertLess(balance["outsideMesh"][-1], 60)
        self.assertAlmostEqual(solid, expected, delta=1e-10 * expected)


if __name__ == "__main__":
    unittest.main()
