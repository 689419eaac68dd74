# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains at the edges: of cells, ranks, mesh and box. Nothing is lost without a word."""
# processors: 2
# label: long

import itertools
import math
import random
import re
import unittest

from grainjet import coupled_box as box, dictionaries, dumps, scripts

# a square across z = 15 mm
PLANE = scripts.stl(*scripts.rectangle(
    (0.001, 0.014, 0.015), (0.019, 0.014, 0.015), (0.019, 0.019, 0.015), (0.001, 0.019, 0.015)))


class Traffic(box.CoupledCase):

    def test_solid_volume(self):
        """The solid volume in all cells is that of all grains to round-off (1e-12), also of
        grains that stick out of the mesh or lie on faces, edges and points of cells and at the
        border between ranks."""
        rng = random.Random(2)
        d = 1.5e-3
        x = [[rng.uniform(1e-5, side - 1e-5) for side in (0.02, 0.02, 0.04)] for _ in range(100)]
        x += [(0.01, 0.01, 0.02), (0.004, 0.0045, 0.02), (1e-9, 1e-9, 1e-9), (0.0031, 0.01, 0.02)]
        expected = len(x) * math.pi / 6 * d ** 3
        for model in ("divided", "centre"):
            for ranks in (0, 2):
                with self.subTest(model=model, ranks=ranks):
                    folder = self.run_box(
                        ranks, steps=1, grains=(x, [(0, 0, 0)] * len(x)), diameter=d, walls=True,
                        boundary="f f f",
                        options={"voidFraction": f"{{ model {model}; minimum 1e-3; }}"})
                    eps = dictionaries.internal(folder / "0.0001/voidFraction")
                    cut = box.read_balance(folder)["volumeCut"][0]
                    seen = sum(1 - e for e in eps) * 8e-9 + cut
                    self.assertAlmostEqual(seen, expected, delta=1e-12 * expected)

    def test_parts_of_spheres(self):
        """Each cell holds the parts of spheres that plain arithmetic puts there (1e-12), also across
        edges, corners, ranks and periodic sides, of grains on their way with the fluid; cells
        that they have left are empty. Spheres as wide as three quarters of a cell, so that
        most reach over several faces."""
        rng = random.Random(5)
        n, d, steps, v = 60, 1.5e-3, 20, (0.3, -0.2, 1)
        x = [[rng.uniform(1e-5, side - 1e-5) for side in (0.02, 0.02, 0.04)] for _ in range(n)]

        bounds = [(k / 29) ** (1 / 3) for k in (1, 15, 29)]
        c = 1 / math.sqrt(3)
        directions = [e for e in itertools.product((-1, 0, 1), repeat=3) if sum(map(abs, e)) == 1]
        directions += list(itertools.product((-c, c), repeat=3))
        parts = [(0, 0, 0)]
        for a, b in zip(bounds, bounds[1:]):
            shell = 0.75 * (b ** 4 - a ** 4) / (b ** 3 - a ** 3)
            parts += [[shell * e for e in direction] for direction in directions]
        self.assertEqual(len(parts), 29)

        solid = [0] * 2000
        for centre in x:
            for part in parts:
                i, j, k = (math.floor((m + u * 1e-4 * (steps - 1) + d / 2 * e) / 0.002) % side
                           for m, u, e, side in zip(centre, v, part, (10, 10, 20)))
                solid[i + 10 * (j + 10 * k)] += math.pi / 6 * d ** 3 / 29 / 8e-9

        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                folder = self.run_box(
                    ranks, steps=steps, grains=(x, [v] * n), diameter=d,
                    velocity="({} {} {})".format(*v), options={"coupling": "oneWay"})
                end = folder / "0.002"
                for celli, (eps, velocity) in enumerate(zip(
                        dictionaries.internal(end / "voidFraction"),
                        dictionaries.internal(end / "particleVelocity"), strict=True)):
                    self.assertAlmostEqual(eps, 1 - solid[celli], delta=1e-12, msg=f"cell {celli}")
                    for mean, one in zip(velocity, v):
                        self.assertAlmostEqual(mean, one if solid[celli] else 0, delta=1e-12)
                self.assertEqual(celli, len(solid) - 1)

    def test_across_ranks(self):
        """Fast grains that cross the border between the ranks of both sides, back and forth:
        as in serial to round-off (1e-11), no momentum lost. The border is a plane, or has steps
        where grains turn back to their rank. After the first step no grain is searched, in serial
        (also through periodic sides) and on two ranks."""
        rng = random.Random(6)
        x = [(rng.uniform(0.005, 0.015), rng.uniform(0.005, 0.015), rng.uniform(0.015, 0.025))
             for _ in range(60)]
        v = [(0, 0, rng.choice((-20, 20)) * rng.uniform(0.5, 1)) for _ in range(60)]
        options = {"interpolation": "cell"}
        for cells in ("10 10 20", "9 9 19"):
            with self.subTest(cells=cells):
                serial = self.run_box(0, grains=(x, v), options=options, cells=cells)
                parallel = self.run_box(2, grains=(x, v), options=options, cells=cells)
                self.compare(serial, parallel, "0.002", 1e-11)
                balance = box.read_balance(parallel)
                after = dumps.last(parallel / "grains.dump")
                crossed = sum((x[tag - 1][2] < 0.02) != (row[2] < 0.02)
                              for tag, row in after.items())
                self.assertGreater(crossed, 10)
                if cells == "9 9 19":       # LIGGGHTS cuts in the middle of a layer of cells
                    self.assertGreater(max(balance["remote"]), 5)
                self.assertLess(max(balance["imbalance"]), 1e-10)
                for folder in (serial, parallel):
                    searches = box.read_balance(folder)["searches"]
                    self.assertGreaterEqual(searches[0], 60)
                    self.assertEqual(searches[-1], searches[0])

    def test_where_four_ranks_meet(self):
        """Grains that fly around the edge where four ranks meet, with borders in steps: as in serial to
        round-off (1e-11). Such a corner may lead a walk astray and a rank may name the wrong one:
        then all are asked, and a search is allowed for one in a hundred grains and steps."""
        rng = random.Random(8)
        x = [(rng.uniform(0.002, 0.018), rng.uniform(0.007, 0.013), rng.uniform(0.016, 0.024))
             for _ in range(80)]
        v = [(0, *(rng.choice((-speed, speed)) * rng.uniform(0.5, 1) for speed in (8, 12)))
             for _ in range(80)]
        case = {"grains": (x, v), "options": {"interpolation": "cell"}, "cells": "9 9 19"}
        serial = self.run_box(0, **case)
        parallel = self.run_box(4, **case, decomposition="(1 2 2)", ranks_in_case=4)
        self.compare(serial, parallel, "0.002", 1e-11)
        balance = box.read_balance(parallel)
        self.assertGreater(max(balance["remote"]), 20)
        self.assertLess(max(balance["imbalance"]), 1e-10)
        self.assertLessEqual(balance["searches"][-1] - balance["searches"][0], 0.01 * 80 * 20)

    def test_out_of_the_mesh_and_back_in(self):
        """The box of LIGGGHTS is longer than the mesh. A grain that enters is found, one that leaves
        the mesh is counted in outsideMesh, one that leaves the box in leftBox: each step adds up, and
        the last half kick of a grain outside the mesh is taken from the cell that it has left."""
        x = [(0.01, 0.01, 0.02), (0.011, 0.012, -0.003), (0.007, 0.008, 0.039)]
        v = [(0, 0, 0), (0, 0, 4), (0, 0, 12)]
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                folder = self.run_box(ranks, steps=30, grains=(x, v), walls=True,
                                      boundary="f f f",
                                      box_of_grains="0 0.02 0 0.02 -0.01 0.06")
                balance = box.read_balance(folder)
                # 3 mm at 4 m/s: in after 7.5 steps. 1 mm at 12 m/s: out after 0.8 steps,
                # 21 mm: out of the box after 17.5
                outside = balance["outsideMesh"]
                self.assertEqual(outside[0], 1)
                self.assertEqual(outside[1], 2)
                self.assertEqual(outside[9], 1)
                self.assertEqual(outside[-1], 0)
                self.assertEqual(balance["inserted"], [3] * 30)
                self.assertEqual(balance["leftBox"][0], 0)
                self.assertEqual(balance["leftBox"][-1], 1)
                for present, left in zip(balance["present"], balance["leftBox"]):
                    self.assertEqual(present + left, 3)
                self.assertEqual(set(balance["deleted"]), {0})
                self.assertEqual(set(balance["unaccounted"]), {0})
                self.assertGreater(math.hypot(*(sum(balance[f"toGrains_{k}"]) for k in "xyz")), 0)
                self.assertLess(max(balance["imbalance"]), 1e-10)

    def test_vanished_grains(self):
        """A former run says it has inserted two grains more than there are: nobody saw them leave,
        so they are missed, once in words and in each row of the table; those that leave through the
        boundary, before and after the stop, are not."""
        x = [(0.01, 0.01, 0.005 * i) for i in range(1, 7)]
        v = [(0, 0, 0)] * 4 + [(0, 0, 18), (0, 0, 40)]
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                folder = self.run_box(ranks, steps=8, grains=(x, v), walls=True, boundary="f f f")
                control = folder / "system/controlDict"
                control.write_text(control.read_text().replace("endTime 0.0008;", "endTime 0.002;"))
                time = folder / ("processor0/0.0008" if ranks else "0.0008")
                counters = time / "uniform/liggghtsCouplingProperties"
                text = counters.read_text()
                self.assertRegex(text, r"inserted +6;")
                self.assertRegex(text, r"leftBox +1;")
                counters.write_text(re.sub(r"inserted +6;", "inserted 8;", text))
                result = self.foam("pimpleFoam", folder, ranks)
                self.assertEqual(result.output.count("2 grains are gone"), 1)
                balance = box.read_balance(folder, "0.0008")
                self.assertEqual(set(balance["unaccounted"]), {2})
                self.assertEqual(balance["leftBox"][-1], 2)
                self.assertEqual(balance["present"][-1], 4)

    def test_leaving_while_a_time_is_written(self):
        """Each step is written, for which LIGGGHTS is set up anew. Grains that leave through the six
        sides, and others that a fix massflow/mesh marks and deletes some steps later, are
        counted once each."""
        step = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
        out = [([0.01 + 1e-3 * a for a in d[:2]] + [0.02 + 1e-3 * d[2]], [20 * a for a in d])
               for d in step]
        # slow ones, so that lists are not rebuilt in each step, at all phases of the coupling interval
        marked = [((0.004 + 0.002 * i, 0.016, 0.012 + 7e-5 * i), (0, 0, 4)) for i in range(6)]
        for ranks, grains in itertools.product((0, 2), (out, marked)):
            with self.subTest(ranks=ranks, grains=len(grains)):
                folder = self.folder / f"written{len(list(self.folder.iterdir()))}"
                folder.mkdir()
                (folder / "constant").mkdir()
                (folder / "constant/plane.stl").write_text(PLANE)
                x, v = zip(*grains)
                self.run_box(
                    ranks, steps=16, grains=(x, v), walls=True, boundary="f f f", write_every=1,
                    into=folder,
                    fixes="fix plane all mesh/surface file constant/plane.stl type 1\n"
                    "fix count all massflow/mesh mesh plane count once vec_side 0 0 1 delete_atoms yes")
                balance = box.read_balance(folder)
                self.assertEqual(set(balance["unaccounted"]), {0})
                fate, other = ("leftBox", "deleted") if grains is out else ("deleted", "leftBox")
                self.assertEqual(balance[fate][-1], 6 - balance["present"][-1])
                self.assertGreaterEqual(balance[fate][-1], 4)
                self.assertEqual(balance[other][-1], 0)

    def test_fast_change_of_void_fraction(self):
        """A grain of two thirds of a cell's width flies through cells at 20 m/s, one cell a step: the
        drag coefficient it sees changes smoothly with the void fraction (by less than the 40 % that
        (1 - 0.15)^-2.65 can make), no jump, and momentum is kept."""
        folder = self.run_box(0, steps=12, grains=([(0.0101, 0.0097, 0.004)], [(0, 0, 20)]),
                              diameter=1.3e-3, options={"drag": "Gidaspow"})
        balance = box.read_balance(folder)
        given = [abs(z) for z in balance["toGrains_z"]]
        for a, b in zip(given, given[1:]):
            self.assertLess(abs(b / a - 1), 0.4)
        self.assertLess(max(balance["imbalance"]), 1e-10)


if __name__ == "__main__":
    unittest.main()
