# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cell of a grain is one and the same on any number of ranks: on faces, edges and points, on an
axis where many cells meet, on warped faces, at baffles."""
# processors: 4
# label: long

import pathlib
import random
import re
import shutil
import unittest

import grainjet
from grainjet import coupled_box as box, dictionaries, scripts

# four wedges around the axis x = y = 10 mm, whose innermost cells are prisms that meet there
AXIS = """
scale 0.001;
vertices ((10 10 0) (20 10 0) (10 20 0) (0 10 0) (10 0 0)
          (10 10 40) (20 10 40) (10 20 40) (0 10 40) (10 0 40));
blocks (hex (0 1 2 0 5 6 7 5) (5 3 10) simpleGrading (1 1 1) hex (0 2 3 0 5 7 8 5) (5 3 10) simpleGrading (1 1 1)
        hex (0 3 4 0 5 8 9 5) (5 3 10) simpleGrading (1 1 1) hex (0 4 1 0 5 9 6 5) (5 3 10) simpleGrading (1 1 1));
edges (arc 1 2 (17.0710678 17.0710678 0) arc 2 3 (2.9289322 17.0710678 0) arc 3 4 (2.9289322 2.9289322 0)
       arc 4 1 (17.0710678 2.9289322 0) arc 6 7 (17.0710678 17.0710678 40) arc 7 8 (2.9289322 17.0710678 40)
       arc 8 9 (2.9289322 2.9289322 40) arc 9 6 (17.0710678 2.9289322 40));
boundary (xlo { type wall; faces ((1 2 7 6) (2 3 8 7) (3 4 9 8) (4 1 6 9)); }
          zlo { type patch; faces ((0 2 1 0) (0 3 2 0) (0 4 3 0) (0 1 4 0)); }
          zhi { type patch; faces ((5 6 7 5) (5 7 8 5) (5 8 9 5) (5 9 6 5)); });
"""

# the lower half of the plane x = 10 mm
BAFFLE = """internalFacesOnly true; noFields true;
baffles { plate { type searchableSurface; surface plate; origin (0.01 0 0); span (0 0.01 0.04);
    patchPairs { type wall; } } }
"""


def moved(folder, share, inner):
    """Move the points of the mesh, or those inside of it only, at random by a share of a cell's
    width of 2 mm."""
    path = folder / "constant/polyMesh/points"
    head, body = path.read_text().split("\n(\n", 1)
    rng = random.Random(3)
    lines = []
    for line in body[:body.index("\n)")].split("\n"):
        p = [float(c) for c in line.strip("()").split()]
        if not inner or all(1e-6 < c < side - 1e-6 for c, side in zip(p, (0.02, 0.02, 0.04))):
            p = [c + share * 2e-3 * rng.uniform(-1, 1) for c in p]
        lines.append("({!r} {!r} {!r})".format(*p))
    path.write_text(head + "\n(\n" + "\n".join(lines) + "\n)\n")


def on_planes(n, seed, sides=(0.02, 0.02, 0.04), width=0.002):
    """Places of which one, two or three coordinates lie on planes between cells, exactly or nearly:
    within and beyond 1e-6 of half a cell's width, and by round-off."""
    rng = random.Random(seed)
    places = []
    while len(places) < n:
        p = [rng.uniform(5e-4, side - 5e-4) for side in sides]
        for k in rng.sample(range(3), rng.choice((1, 1, 2, 3))):
            beside = rng.choice((0, 0, 1e-18, 1e-14, 1e-10, 5e-9)) * rng.choice((-1, 1))
            p[k] = rng.randrange(1, round(sides[k] / width)) * width + beside
        places.append(p)
    return places


class GrainCells(box.CoupledCase):

    def prepare(self, places, *, name="case", mesh=None, change=None, steps=4, velocities=None, diameter=3e-4,
                boundary="f f f", options=None, **fluid):
        """A case with a mesh, ready to be copied. Grains fly along z, so that those on planes x or y stay
        there. The linear solvers go on to round-off."""
        folder = self.folder / name / "case"
        box.write(folder, steps=steps, velocity="(0.1 -0.2 1)", **fluid)
        dictionaries.change(folder / "system/fvSolution", ("1e-13", "1e-16"), ("1e-14", "1e-16"))
        if mesh:
            dictionaries.write(folder / "system/blockMeshDict", mesh)
        v = velocities or [(0, 0, 0.5)] * len(places)
        box.script(folder, grains=box.grains(places, v, diameter), boundary=boundary,
                   end=scripts.dump(10 * steps, "grains.dump", box.MOTION))
        box.fv_options(folder, **(options or {}))
        self.foam("blockMesh", folder)
        if change:
            change(folder)
        return folder

    def run_on(self, case, ranks=0, decomposition=None):
        """Run a copy of the case. The decomposition: numbers of blocks for the method simple, or a
        function that gives the rank of a cell by its number."""
        folder = case.parent / f"on{len(list(case.parent.iterdir()))}"
        shutil.copytree(case, folder)
        if ranks:
            text = f"numberOfSubdomains {ranks}; method simple; simpleCoeffs {{ n {decomposition}; delta 1e-6; }}\n"
            if callable(decomposition):
                n = dictionaries.cells(folder)
                text = (f"numberOfSubdomains {ranks}; method manual;\n"
                        'manualCoeffs { dataFile "ranksOfCells"; }\n')
                dictionaries.write(
                    folder / "constant/ranksOfCells",
                    f"{n}\n(\n" + "\n".join(str(decomposition(i)) for i in range(n)) + "\n)\n", "labelList")
            dictionaries.write(folder / "system/decomposeParDict", text)
            self.foam("decomposePar", folder)
        self.foam("pimpleFoam", folder, ranks)
        if ranks:
            self.foam("reconstructPar", folder)
        return folder

    def same_on(self, case, *decompositions, time="0.0004"):
        """Fields and grains on these decompositions are those of the serial run to 1e-12 of the
        largest value: round-off of sums and of the linear solvers. A grain or a part of one in another
        cell would be 1e-5 or more."""
        serial = self.run_on(case)
        for ranks, decomposition in decompositions:
            with self.subTest(ranks=ranks, decomposition=decomposition):
                self.compare(serial, self.run_on(case, ranks, decomposition), time, 1e-12)

    def test_on_faces_edges_and_points(self):
        """Grains and parts of grains on faces, edges and points of a box, where up to eight cells of four
        ranks meet, between walls and with periodic sides."""
        places = on_planes(150, 1)
        walls = self.prepare(places, walls=True, name="walls")
        self.same_on(walls, (2, "(2 1 1)"), (4, "(2 2 1)"), (4, lambda i: i // 7 % 4))
        periodic = self.prepare(places + [(0, 0.003, 0.007), (0.0051, 0.02 - 1e-12, 0), (0, 0, 0)],
                                boundary="p p p", name="periodic")
        self.same_on(periodic, (3, "(1 1 3)"), (4, lambda i: i // 7 % 4))

    def test_where_many_cells_meet(self):
        """Grains on the axis where the twelve innermost cells of a round mesh meet, and on the faces and
        edges that end there."""
        rng = random.Random(2)
        places = [(0.01 + rng.choice((0, 1e-18, -1e-15)), 0.01, rng.uniform(0.001, 0.039))
                  for _ in range(20)]
        places += [(0.01, 0.01, 0.004 * k) for k in range(1, 10)]
        places += [(0.01 + 0.002 * rng.randrange(-4, 5), 0.01, 0.002 * k) for k in range(1, 20)]
        places += [(0.01, 0.01 + rng.uniform(-0.009, 0.009), rng.uniform(0.001, 0.039))
                   for _ in range(20)]
        case = self.prepare(places, mesh=AXIS, walls=True, through=True)
        self.same_on(case, (2, "(1 2 1)"), (3, "(3 1 1)"), (4, lambda i: i // 3 % 4))

    def test_warped(self):
        """Points moved by up to 10 % of a cell's width, inside or at the walls as well: planes of warped
        faces leave gaps and overlaps, tetrahedra do not."""
        rng = random.Random(7)
        for inner in (True, False):
            places = [[rng.uniform(5e-4, side - 5e-4) for side in (0.02, 0.02, 0.04)]
                      for _ in range(400)]
            case = self.prepare(places, name=f"warped{inner}", walls=True,
                                change=lambda folder: moved(folder, 0.1, inner))
            self.same_on(case, (3, "(1 1 3)"), (4, lambda i: i // 7 % 4))

    def test_baffle_on_the_cut(self):
        """A baffle where the mesh is cut: no coupled patch there tells that points of both sides are
        one, as they are in the undecomposed mesh. Grains on it and beside it, cellPoint."""
        def baffle(folder):
            dictionaries.write(folder / "system/createBafflesDict", BAFFLE)
            result = grainjet.run(["createBaffles", "-overwrite"], folder)
            self.assertEqual(result.code, 0, result)
            self.assertIn("plate", (folder / "constant/polyMesh/boundary").read_text())

        places = on_planes(100, 5) + [(0.01, 0.001 * k, 0.0021 * k) for k in range(1, 18)]
        case = self.prepare(places, walls=True, change=baffle)
        self.same_on(case, (2, "(2 1 1)"), (4, "(2 2 1)"))

    def test_continued(self):
        """A run that is stopped and continued searches for all grains anew and finds the cells to
        which they had walked, also on warped faces: as in one go, 1e-12."""
        rng = random.Random(9)
        places = on_planes(60, 6) + [[rng.uniform(5e-4, side - 5e-4) for side in (0.02, 0.02, 0.04)]
                                     for _ in range(200)]
        case = self.prepare(places, walls=True, change=lambda folder: moved(folder, 0.1, True))
        control = case / "system/controlDict"
        control.write_text(control.read_text().replace("writeInterval 4", "writeInterval 2"))
        whole = self.run_on(case)
        text = control.read_text()
        control.write_text(text.replace("endTime 0.0004", "endTime 0.0002"))
        halves = self.run_on(case)
        (halves / "system/controlDict").write_text(text)
        self.foam("pimpleFoam", halves)
        self.compare(whole, halves, "0.0004", 1e-12)

    def test_counters(self):
        """What is counted since a run's start has 64 bits wherever it is kept, and the table has whole
        numbers with all digits."""
        found = 0
        for folder in ("ownership", "locate", "voidFraction", "coupling"):
            for path in (pathlib.Path(__file__).parents[1] / folder).glob("*.H"):
                text = path.read_text()
                kinds = re.findall(r"//- (?:Bytes|Searches) [^;{]*?since construction[^;{]*?\n\s*"
                                   r"(?:mutable )?([\w:]+) \w+(?:;|\(\) const)", text)
                kinds += re.findall(r"//- (?:Bytes|Searches) [^\n]*since the start\n\s*([\w:]+) \w+ = 0;", text)
                found += len(kinds)
                self.assertEqual(set(kinds) - {"std::int64_t"}, set(), path)
        self.assertGreaterEqual(found, 8)

        case = self.prepare(on_planes(20, 1), walls=True, steps=1)
        control = case / "system/controlDict"
        control.write_text(control.read_text().replace("writePrecision 17", "writePrecision 6"))
        run = self.run_on(case, 2, "(2 1 1)")
        table = run / "postProcessing/liggghtsCoupling/0/balance.dat"
        row = table.read_text().splitlines()[-1].split()
        self.assertTrue(all(word.isdigit() for word in row[-3:]), row)
        self.assertGreater(int(row[-2]), 0)


if __name__ == "__main__":
    unittest.main()
