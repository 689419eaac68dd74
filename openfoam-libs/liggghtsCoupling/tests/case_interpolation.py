# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The fast samplers give what OpenFOAM's own interpolation gives."""
# processors: 2
# label: long

import random
import re
import unittest

import grainjet
from grainjet import coupled_box as box, dictionaries, dumps, scripts
from grainjet.coupled_box import swarm

# distorts the box, so that faces are warped and tetrahedra differ from pyramids
CORNERS = ((0, 0, 0), (20, 1, 2), (22, 20, -1), (0, 18, 2), (1, 0, 40), (20, -2, 38), (19, 20, 41), (-1, 21, 40))
DISTORTED = ("vertices ((0 0 0) (20 0 0) (20 20 0) (0 20 0) (0 0 40) (20 0 40) (20 20 40) (0 20 40));",
             "vertices (" + " ".join("({} {} {})".format(*corner) for corner in CORNERS) + ");")
# the box of LIGGGHTS, and of the mesh that is not distorted
SIZE = (0.02, 0.02, 0.04)
# of points from the sides; faces of the distorted mesh lie up to 1e-5 m beside its sides
MARGIN, DISTORTED_MARGIN = 2e-5, 1e-4


def distorted(p):
    """Where a point of the straight box lies in the distorted one."""
    ways = [(1 - c / size, c / size) for c, size in zip(p, SIZE)]
    # corners in the order of blockMesh
    weights = [ways[0][i] * ways[1][j] * ways[2][k] for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return [0.001 * sum(w * corner[k] for w, corner in zip(weights, CORNERS)) for k in range(3)]


class Interpolation(grainjet.Case):

    def fluid_at_grains(self, scheme, distorted):
        """Fluid velocity and explicit force at each grain after two steps."""
        folder = self.folder / f"{scheme}{distorted}"
        box.write(folder, steps=2, walls=True, velocity="(0.2 -0.1 1)")
        if distorted:
            dictionaries.change(folder / "system/blockMeshDict", DISTORTED)
        x, v = swarm(2000, 9, low=(0.002,) * 3, high=(0.018, 0.018, 0.036))
        fields = " ".join(f"f_{name}[{k}]" for name in ("fluidVelocity", "fluidExplicitForce")
                          for k in (1, 2, 3))
        box.script(folder, grains=box.grains(x, v, diameter=1e-4), boundary="f f f",
                   end=scripts.dump(20, "grains.dump", f"id {fields}"))
        box.fv_options(folder, coupling="oneWay", interpolation=scheme)
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        return dumps.last(folder / "grains.dump")

    def test_cell_point(self):
        """cellPoint against cellPointWallModified, OpenFOAM's own class, which differs only in
        cells at walls: two thirds of the grains must agree to round-off, 1e-11 of the largest value,
        on a straight mesh and on one with warped faces."""
        for distorted in (False, True):
            with self.subTest(distorted=distorted):
                ours = self.fluid_at_grains("cellPoint", distorted)
                stock = self.fluid_at_grains("cellPointWallModified", distorted)
                for columns in (range(0, 3), range(3, 6)):
                    scale = max(abs(v[k]) for v in stock.values() for k in columns)
                    self.assertGreater(scale, 0)
                    equal = [tag for tag in stock if all(
                        abs(ours[tag][k] - stock[tag][k]) < 1e-11 * scale for k in columns)]
                    self.assertGreater(len(equal), 2 / 3 * len(stock))

    def compare_with_probes(self, name, *, ranks=0, sides=(), edits=(), margin=MARGIN, place=lambda x: x,
                            inside=lambda x: True, **fluid):
        """Fluid velocity at each of 2000 grains, up to the boundary, in the first step, and that of
        OpenFOAM's own cellPoint in the same field at the same places, found in serial by the stock
        `probes`. The field is random, so that each value and weight shows."""
        folder = self.folder / name
        rng = random.Random(4)
        box.write(folder, steps=1, ranks=ranks or 2, **fluid)
        mesh = folder / "system/blockMeshDict"
        dictionaries.change(mesh, *edits)
        text = mesh.read_text()
        for patch, kind in sides:
            text, count = re.subn(f"{patch} {{ type (wall|cyclic);", f"{patch} {{ type {kind};", text)
            self.assertEqual(count, 1)
            for field in ("U", "p"):
                path = folder / "0" / field
                path.write_text(re.sub(r"\}\s*$", f"{patch} {{ type {kind.split(';')[0]}; }} }}\n", path.read_text()))
        mesh.write_text(text)
        self.foam("blockMesh", folder)
        n = dictionaries.cells(folder)
        values = "\n".join("({:.9g} {:.9g} {:.9g})".format(*(rng.gauss(0, 1) for _ in range(3)))
                           for _ in range(n))
        path = folder / "0/U"
        path.write_text(path.read_text().replace(
            "uniform (0 0 0)", f"nonuniform List<vector> {n}\n(\n{values}\n)", 1))

        # none outside of the mesh: probes of v2412 would end; none outside of LIGGGHTS' box
        x = []
        while len(x) < 2000:
            p = place([rng.uniform(margin, high - margin) for high in SIZE])
            if inside(p) and all(MARGIN < c < high - MARGIN for c, high in zip(p, SIZE)):
                x.append(p)
        points = "".join("({:.17g} {:.17g} {:.17g})\n".format(*p) for p in x)
        dictionaries.write(folder / "system/probes",
                           "type probes; libs (sampling); fields (U);\n"
                           f"interpolationScheme cellPoint; probeLocations ({points});")
        result = grainjet.run(["postProcess", "-func", "probes", "-time", "0"], folder)
        self.assertEqual(result.code, 0, result)
        written = next(folder.glob("postProcessing/**/U")).read_text().splitlines()[-1]
        stock = [tuple(map(float, v.split())) for v in re.findall(r"\(([^()]*)\)", written)]

        boundary = "f f f" if fluid.get("walls") else "p p p"
        box.script(folder, grains=box.grains(x, [(0, 0, 0)] * len(x), diameter=1e-5), boundary=boundary,
                   end=scripts.dump(10, "grains.dump",
                                    "id f_fluidVelocity[1] f_fluidVelocity[2] f_fluidVelocity[3]"))
        box.fv_options(folder, coupling="oneWay", forces="()")
        if ranks:
            self.foam("decomposePar", folder)
        self.foam("pimpleFoam", folder, ranks)
        ours = dumps.last(folder / "grains.dump")
        self.assertEqual((len(ours), len(stock)), (len(x), len(x)))
        self.assertLess(max(abs(v[0]) for v in stock), 1e100)       # that of a point outside of the mesh
        return [max(abs(a - b) for a, b in zip(ours[i + 1], v)) for i, v in enumerate(stock)]

    def test_up_to_the_boundary(self):
        """As OpenFOAM's cellPoint in all cells, to 1e-12 of a field of size 1: walls, an inlet, periodic
        sides, a symmetry plane, sides that need not match, prisms. On two ranks as OpenFOAM in serial,
        which OpenFOAM itself on two ranks is not where coupled sides meet, or need not match. Over
        warped faces tetrahedra overlap, and either may be chosen: 99 of 100 grains there."""
        # one block with two edges in one: prisms there, with triangles
        prisms = [("hex (0 1 2 3 4 5 6 7)", "hex (0 1 2 2 4 5 6 6)"), ("(0 4 7 3)", "(0 4 6 2)"),
                  ("((3 7 6 2))", "()"), ("(0 3 2 1)", "(0 2 2 1)"), ("((4 5 6 7))", "((4 5 6 6))")]
        for name, share, arguments in (
                ("walls", 1, {"walls": True}),
                ("through", 1, {"walls": True, "through": True}),
                ("periodic", 1, {}),
                ("plane", 1, {"walls": True, "sides": [("xlo", "symmetryPlane")]}),
                ("unmatched", 1, {"sides": [
                    (side, f"cyclicAMI; transform translational; separationVector (0 0 {way})")
                    for side, way in (("zlo", 0.04), ("zhi", -0.04))]}),
                ("prisms", 1, {"walls": True, "edits": prisms, "inside": lambda p: p[1] < p[0] - 1e-4}),
                ("warped", 0.99, {"walls": True, "edits": [DISTORTED], "place": distorted,
                                 "margin": DISTORTED_MARGIN})):
            for ranks in (0, 2):
                with self.subTest(name=name, ranks=ranks):
                    error = self.compare_with_probes(
                        f"{name}{ranks}", ranks=ranks, decomposition="(2 1 1)", **arguments)
                    close = sum(e < 1e-12 for e in error)
                    self.assertGreaterEqual(close, share * len(error), max(error))


if __name__ == "__main__":
    unittest.main()
