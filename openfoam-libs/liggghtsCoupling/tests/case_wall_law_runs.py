# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coupled runs with the law of the wall: continued, two-way, at a wall without thickness, and refused ones."""
# processors: 2
# label: long

import random
import shutil
import unittest

import bad_case
import grainjet
from grainjet import coupled_box as box, dictionaries, dumps, releases, scripts, wall_flow

NU, SIZE, N, U_TAU = 1.5e-5, 0.02, 8, 0.36
CELL = SIZE / N
WALL = ("wall", "ylo yhi")
PERIODIC = {side: (f"cyclic; neighbourPatch {other}", side)
            for side, other in (("xlo", "xhi"), ("xhi", "xlo"), ("zlo", "zhi"), ("zhi", "zlo"))}


def law(y):
    return U_TAU * wall_flow.spalding(y * U_TAU / NU)


class WallLawRuns(grainjet.Case):

    def case(self, name, steps, n=300, *, low=2e-4, high=CELL, diameter=1e-4, write_every=10, plugins="", **options):
        """A channel with grains in the cells at its lower wall."""
        folder = self.folder / name
        centres = wall_flow.mesh(
            folder, wall_flow.channel((SIZE,) * 3, f"6 {N} 6", {"walls": WALL, **PERIODIC}), nu=NU, steps=steps,
            write_every=write_every, correctors="nOuterCorrectors 1; nCorrectors 2;")
        self.centres = centres
        y = [min(p[1], SIZE - p[1]) for p in centres]
        wall_flow.impose(folder, [(law(d), 0, 0) for d in y], k=[U_TAU ** 2 / 0.3] * len(y),
                         epsilon=[U_TAU ** 3 / (0.41 * d) for d in y], nut="nutkWallFunction")
        rng = random.Random(2)
        places = [(rng.uniform(0, SIZE), rng.uniform(low, high), rng.uniform(0, SIZE)) for _ in range(n)]
        box.script(folder, grains=box.grains(places, [(0, 0, 0)] * n, diameter), boundary="p f p", plugins=plugins,
                   box=f"0 {SIZE} 0 {SIZE} 0 {SIZE}", end=scripts.dump(100, "grains.*.dump", box.MOTION))
        box.fv_options(folder, **{"wallLaw": "yes", "forces": "()", **options})
        return folder

    def test_continued(self):
        """20 steps at once and in two halves: bit for bit, as u_tau comes from the fields that are written."""
        whole, parts = self.case("whole", 20), self.case("parts", 10)
        self.foam("pimpleFoam", whole)
        result = self.foam("pimpleFoam", parts)
        self.assertRegex(result.output, r"Law of the wall: 72 cells at 1?\(walls\)")
        box.end_at(parts, 20)
        self.foam("pimpleFoam", parts)
        for field in ("U", "k", "nut", "particleMomentumOwed"):
            a, b = ((f / "0.002" / field).read_bytes() for f in (whole, parts))
            self.assertEqual(a, b, field)
        a, b = (dumps.last(f / "grains.200.dump") for f in (whole, parts))
        self.assertEqual(a, b)

    def test_two_way(self):
        """Grains with 84 times the mass of the air in their cell, in fluid steps of 2.7 of its response times. They
        sit at the top of the wall cells, where the fluid at a grain follows the cell by a factor above 1, or at the
        bottom: what they receive the fluid loses, to round-off. The air swings, as it does with cellPoint, since they
        are fed by the cells around, too; but it is stable: in 30 steps the swing falls to less than half."""
        f, d = 30, 2e-5
        for name, low, high in (("top", 0.9 * CELL, 0.999 * CELL), ("bottom", 0.02 * CELL, 0.1 * CELL)):
            with self.subTest(name):
                folder = self.case(name, 30, n=360, diameter=d, low=low, high=high, write_every=1,
                                   plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {f} model_check warn",
                                   voidFraction="{ model centre; minimum 0.3; }")
                self.foam("pimpleFoam", folder)
                self.assertLess(max(box.read_balance(folder)["imbalance"]), 1e-10)
                below_zero = [-min(u[0] for u, p in zip(
                    dictionaries.internal(folder / f"{step * 1e-4:.10g}/U"), self.centres) if p[1] < CELL)
                              for step in range(1, 31)]
                self.assertGreater(max(below_zero), 0.1 * law(CELL / 2))
                self.assertLess(below_zero[-1], 0.5 * max(below_zero))

    def test_without_thickness(self):
        """A baffle between a flow and a fluid at rest: each side has its own flow, in the middle of its cells the
        law and zero."""
        folder = self.folder / "baffle"
        text = wall_flow.channel((SIZE,) * 3, f"6 {N} 6", {"walls": WALL, **PERIODIC})
        wall_flow.mesh(folder, text, nu=NU, steps=1)
        dictionaries.write(folder / "system/createBafflesDict", f"""
internalFacesOnly true; noFields true;
baffles
{{
    between
    {{
        type searchableSurface; surface searchablePlate;
        origin (-1 {SIZE / 2} -1); span (2 0 2);
        patchPairs {{ type wall; }}
    }}
}}
""")
        result = grainjet.run(["createBaffles", "-overwrite"], folder)
        self.assertEqual(result.code, 0, result)
        centres = wall_flow.centres(folder)

        def distance(p):
            return min(p[1], abs(p[1] - SIZE / 2))

        u = [law(distance(p)) if p[1] < SIZE / 2 else 0 for p in centres]
        wall_flow.impose(folder, [(a, 0, 0) for a in u], k=[U_TAU ** 2 / 0.3] * len(u),
                         epsilon=[U_TAU ** 3 / (0.41 * distance(p)) for p in centres])
        rng = random.Random(3)
        places = [(rng.uniform(0, SIZE), SIZE / 2 + side * rng.uniform(1e-6, CELL / 2), rng.uniform(0, SIZE))
                  for side in (-1, 1) for _ in range(100)]
        rows = wall_flow.sample(folder, places, box=f"0 {SIZE} 0 {SIZE} 0 {SIZE}", boundary="p f p")
        for place, (value, *_) in zip(places, rows):
            expected = law(SIZE / 2 - place[1]) if place[1] < SIZE / 2 else 0
            self.assertAlmostEqual(value, expected, delta=2e-3 * law(CELL / 2), msg=str(place))


class Refused(bad_case.BadCase):

    def case(self, nut, **options):
        """The small box with k-epsilon; nut: the boundary of the field."""
        folder = self.fresh()
        self.turbulent(folder, "kEpsilon", "k", "epsilon")
        self.put(folder, "0/nut", f"dimensions [0 2 -1 0 0 0 0]; internalField uniform 1e-5;\nboundaryField {{ {nut} }}\n",
                 "volScalarField")
        box.fv_options(folder, **{"wallLaw": "yes", **options})
        return folder

    def test_another_interpolation(self):
        for scheme in ("cell", "cellPointFace"):
            folder = self.case('".*" { type nutkWallFunction; value uniform 0; }', interpolation=scheme)
            self.assertRefused(folder, f"wallLaw yes with interpolation {scheme}", "cellPoint", "constant/fvOptions")

    def test_no_wall_function(self):
        for kind in ("calculated", "nutLowReWallFunction"):
            folder = self.case(f'".*" {{ type {kind}; value uniform 0; }}')
            self.assertRefused(folder, "no wall has a wall function", kind, "remove wallLaw")

    def test_rough(self):
        for kind, entries in (("nutkRoughWallFunction", "Ks uniform 1e-4; Cs uniform 0.5;"),
                              ("nutURoughWallFunction",
                               "roughnessHeight 1e-4; roughnessConstant 0.5; roughnessFactor 1;")):
            folder = self.case('".*" { type nutkWallFunction; value uniform 0; } '
                               f"ylo {{ type {kind}; {entries} value uniform 0; }}")
            self.assertRefused(folder, "smooth walls only", "patch ylo", kind)

    def test_atmosphere(self):
        folder = self.case('".*" { type nutkWallFunction; value uniform 0; } '
                           f"zlo {{ type {releases.atmospheric_wall_function()}; z0 uniform 1e-4; value uniform 0; }}")
        self.change(folder, "system/controlDict", ('"libliggghtsCoupling.so"',
                                                   '"libliggghtsCoupling.so" "libatmosphericModels.so"'))
        self.assertRefused(folder, "smooth walls only", "patch zlo", releases.atmospheric_wall_function())

    def test_different_constants(self):
        folder = self.case('".*" { type nutkWallFunction; value uniform 0; } '
                           "xlo { type nutkWallFunction; E 9.0; value uniform 0; }")
        self.assertRefused(folder, "the same constants on all walls", "E 9 ", "E 9.8")

    def test_on_two_ranks(self):
        """No rank hangs or dies."""
        folder = self.case('".*" { type calculated; value uniform 0; }')
        for former in folder.glob("processor*"):
            shutil.rmtree(former)
        self.foam("decomposePar", folder)
        self.assertRefused(folder, "no wall has a wall function", ranks=2)

    def test_rotated_sides(self):
        """A quarter of a pipe with periodic sides that are turned by a right angle."""
        folder = self.case('".*" { type nutkWallFunction; value uniform 0; } "[xy]lo" { type cyclic; }')
        dictionaries.write(folder / "system/blockMeshDict", """
scale 0.02; vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));
blocks (hex (0 1 2 3 4 5 6 7) (4 4 4) simpleGrading (1 1 1));
boundary
(
    xlo { type cyclic; neighbourPatch ylo; transform rotational; rotationAxis (0 0 1); rotationCentre (0 0 0);
          faces ((0 4 7 3)); }
    ylo { type cyclic; neighbourPatch xlo; transform rotational; rotationAxis (0 0 1); rotationCentre (0 0 0);
          faces ((0 1 5 4)); }
    walls { type wall; faces ((1 2 6 5) (3 7 6 2) (0 3 2 1) (4 5 6 7)); }
);
""")
        for name in ("U", "p", "k", "epsilon"):
            path = folder / "0" / name
            path.write_text(path.read_text().rstrip()[:-1] + '"[xy]lo" { type cyclic; } }\n')
        self.foam("blockMesh", folder)
        self.assertRefused(folder, "periodic sides that are rotated", "cyclicAMI")


if __name__ == "__main__":
    unittest.main()
