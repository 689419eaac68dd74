# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""On meshes that users have, the coupling finds the cells and makes the values that OpenFOAM itself does."""
# processors: 2
# label: long

import pathlib
import re
import shutil
import unittest

import grainjet
from grainjet import coupled_box as box
import meshes


def probe():
    """The program meshProbe: built by wmake from a copy of the sources, which is kept, so that only what
    has changed there or in the library is compiled again."""
    out = grainjet.ROOT / "build/meshProbe"
    shutil.copytree(pathlib.Path(__file__).parent / "meshProbe", out, dirs_exist_ok=True)
    result = grainjet.run(
        ["bash", "-c", f". '{grainjet.ROOT}/openfoam-libs/tools/openfoam-environment' && wmake -s"], out,
        env={"GRAINJET_DIR": str(grainjet.ROOT)})
    if result.code:
        raise AssertionError(result)
    return out / "meshProbe"


# What each mesh is here for: at least so many faces of a cell and points of a face, and shares of
# warped faces and of cells that are not convex
KINDS = {
    "jet": (12, 5, 0.3, 0.01),
    "layers": (6, 4, 0.1, 0),
    "tetrahedra": (4, 3, 0, 0),
    "dual": (14, 6, 0.3, 0),
    "concave": (10, 8, 0.5, 1),
    "wedge": (6, 4, 0, 0),
    "baffles": (6, 4, 0.5, 0),
    "unmatched": (6, 4, 0, 0),
}


class MeshesCells(meshes.EachMesh, grainjet.Case):

    points, walkers, steps, spheres = 100000, 10000, 200, 5000
    shared = 30000      # of the points, looked for on several ranks

    @classmethod
    def setUpClass(cls):
        cls.program = probe()

    def probe(self, folder, ranks=0, **numbers):
        """The figures that meshProbe prints."""
        parallel = ["-parallel"] if ranks else []
        options = [word for name, value in numbers.items() for word in (f"-{name}", value)]
        result = grainjet.run([*grainjet.mpirun(ranks), self.program, *parallel, *options], folder)
        self.assertEqual(result.code, 0, result)
        return {name: float(value) for name, value in re.findall(r"^result (\w+) (\S+)$", result.output, re.M)}

    def on_mesh(self, name):
        """Cells, walks, parts of spheres and cellPoint on a mesh, serial and on 2 and 4 ranks.

        A random point must be found in the cell that polyMesh::findCell names (by tetrahedra, with
        OpenFOAM's octree). On a face both cells are right: one point in 10,000 may be in the other
        one, if that holds it within 1e-6 of its size. Searched or walked to, it must be the same cell.

        Walkers make steps of up to two cells' width. At each step their cell must hold them by its
        tetrahedra (1e-6 of its size), and who is said to be outside must be so for findCell. Next to none
        is searched through the mesh, but through baffles, cyclicAMI, and where cells of another form
        than convex lead a walk astray: less than one step in ten.

        Spheres of a diameter of 0.2 to 2 cells' width lie in cells as a whole (1e-12), and each part in
        the cell that findCell names for its point: 1e-4 of the volume is one part in 10,000 on a face.

        cellPoint is OpenFOAM's interpolationCellPoint to 1e-11 of a field of size 1, but where several
        tetrahedra of the cell hold the point. Beside a cyclicAMI it is that of v2012 and later: values at
        points are divided by those of a field that is one everywhere.

        On ranks each point has one rank, and cell and values of the serial run: values to 1e-11."""
        folder = self.folder / name
        box.write(folder, walls=True, through=True)
        make, _ = meshes.MESHES[name]
        make(folder)
        shutil.rmtree(folder / "0")
        numbers = {"points": self.points, "spheres": self.spheres}
        if name == "unmatched":
            numbers["period"] = "(0 0 0.04)"

        seen = self.probe(folder, walkers=self.walkers, steps=self.steps, **numbers)
        print("\n" + name + ": " + ", ".join(f"{key} {value:.6g}" for key, value in seen.items()))
        faces, points, warped, not_convex = KINDS[name]
        self.assertGreaterEqual(seen["facesOfCell"], faces)
        self.assertGreaterEqual(seen["pointsOfFace"], points)
        self.assertGreaterEqual(seen["warpedFaces"], warped)
        self.assertGreaterEqual(seen["cellsNotConvex"], not_convex)
        self.assertEqual(seen["invertedTetrahedra"], 0)

        self.assertGreater(seen["inside"], 0.4 * self.points)
        for fault in ("lost", "wrongCell", "otherCellByWalk", "differentValue", "notThere", "lostOnTheWay",
                      "otherCellBySearch"):
            self.assertEqual(seen[fault], 0, fault)
        self.assertLessEqual(seen["ambiguousCell"], 1e-4 * self.points)
        self.assertLessEqual(seen["valueOfOtherTetrahedron"], 1e-4 * self.points)
        self.assertGreater(seen["located"], 0.3 * self.walkers * self.steps)
        self.assertLess(seen["searched"], 0.1 if name in ("concave", "baffles", "unmatched") else 1e-3)
        self.assertGreater(seen["spheres"], 0.4 * self.spheres)
        self.assertLess(seen["volumeError"], 1e-12)
        self.assertLess(seen["volumeInOtherCell"], 1e-4)

        for ranks in (2, 4):
            with self.subTest(ranks=ranks):
                meshes.decompose(folder, ranks)
                numbers["points"] = self.shared
                seen = self.probe(folder, ranks, **numbers)
                print(f"{ranks} ranks: " + ", ".join(f"{key} {value:.6g}" for key, value in seen.items()))
                for fault in ("pointsOfSeveralRanks", "pointsLost", "pointsInOtherCell", "otherValues"):
                    self.assertEqual(seen[fault], 0, fault)
                self.assertLess(seen["volumeError"], 1e-12)
        shutil.rmtree(folder)


if __name__ == "__main__":
    unittest.main()
