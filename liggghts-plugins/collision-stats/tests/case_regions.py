# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""fix collision/stats by region, slab and pair of types: pairs of grains that meet at known places at known times."""

import math
import unittest

from collision_case import CollisionCase, mass

D, RHO, V = 0.001, 2500.0, 0.3
BOX = ((0.0, 0.02), (0.0, 0.02), (0.0, 0.02))
GAP = 1e-6      # m, on each side of the place: pairs meet after 2 GAP/V = 7e-6 s
LATER = 0.3e-3  # m: after 2e-3 s

# a unit tetrahedron, in the host's format
TETS = """# vtk DataFile Version 2.0
one tetrahedron
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 4 float
0 0 0
0.02 0 0
0 0.02 0
0 0 0.02
CELLS 1 5
4 0 1 2 3
CELL_TYPES 1
10
"""


class Regions(CollisionCase):

    def meet(self, pairs, stats, steps=2000, dt=1e-6, ranks=0, more="", tail=""):
        """pairs: (place of the contact, types, gap); head-on along y. Statistics by fix k."""
        grains = []
        for (x, y, z), (a, b), gap in pairs:
            grains.append((a, D, RHO, (x, y - D / 2 - gap, z), (0, V / 2, 0)))
            grains.append((b, D, RHO, (x, y + D / 2 + gap, z), (0, -V / 2, 0)))
        self.data(grains, BOX, types=3)
        self.liggghts(self.script(f"run {steps}\n{tail}", dt=dt, types=3, e=0.8,
                                  stats=more + f"\nfix k all collision/stats contact c {stats} file collisions.csv"), ranks)
        return self.rows()

    def counts(self, rows):
        return {key: row["collisions"] for key, row in rows.items() if row["collisions"]}

    def test_slabs_and_types(self):
        pairs = [((0.003, 0.005, 0.01), (1, 1), GAP), ((0.0079, 0.005, 0.01), (2, 1), GAP), ((0.0081, 0.005, 0.005), (2, 3), GAP),
                 ((0.012, 0.005, 0.01), (2, 2), GAP), ((0.015, 0.005, 0.01), (1, 2), GAP), ((0.018, 0.005, 0.01), (3, 3), GAP)]
        for ranks in (0, 2):
            rows = self.meet(pairs, "bins x 0.004 0.016 3", ranks=ranks)
            self.assertEqual(self.counts(rows), {
                ("all", "all"): 6, ("all", "1-1"): 1, ("all", "1-2"): 2, ("all", "2-2"): 1, ("all", "2-3"): 1, ("all", "3-3"): 1,
                ("bin1", "all"): 1, ("bin1", "1-2"): 1, ("bin2", "all"): 1, ("bin2", "2-3"): 1,
                ("bin3", "all"): 2, ("bin3", "1-2"): 1, ("bin3", "2-2"): 1})
        self.assertEqual(len(rows), 4 * 7)
        self.assertEqual([(rows[f"bin{n}", "all"]["from"], rows[f"bin{n}", "all"]["to"]) for n in (1, 2, 3)],
                         [(0.004, 0.008), (0.008, 0.012), (0.012, 0.016)])
        # per volume and per grain, of each partner
        row, time = rows["all", "1-2"], 2e-3
        self.assertAlmostEqual(row["time"], time, delta=1e-12)
        self.assertEqual((row["grains_1"], row["grains_2"]), (4, 5))
        self.assertAlmostEqual(row["frequency_per_volume"] / (2 / (time * 0.02 ** 3)), 1, delta=1e-9)
        self.assertAlmostEqual(row["frequency_per_grain_1"] / (2 / (time * 4)), 1, delta=1e-9)
        self.assertAlmostEqual(row["frequency_per_grain_2"] / (2 / (time * 5)), 1, delta=1e-9)
        same = rows["all", "1-1"]
        self.assertAlmostEqual(same["frequency_per_grain_1"] / (2 * 1 / (time * 4)), 1, delta=1e-9)
        energy = mass(D, RHO) * V ** 2 / 4
        self.assertAlmostEqual(rows["all", "all"]["normal_energy_sum"] / (6 * energy), 1, delta=1e-9)
        self.assertEqual(len(self.spectrum("duration", "bin1", "1-2")), 54 + 2)
        self.assertEqual(self.spectrum("duration", "bin1", "1-1"), [], "no collision, no spectrum")

    def test_the_contact_point_decides(self):
        """Not the centres: they lie on either side of an edge that the contact point has just passed, or not."""
        for y, where in ((0.00999, "bin1"), (0.01001, "bin2")):
            rows = self.meet([((0.01, y, 0.01), (1, 1), GAP)], "bins y 0 0.02 2")
            self.assertEqual(rows[where, "all"]["collisions"], 1)

    def test_regions(self):
        """In a region of every kind, with its volume: exact for blocks, else to the 1e-3 of the grid of points."""
        inside, outside = (0.01, 0.01, 0.012), (0.003, 0.016, 0.003)
        (self.folder / "tets.vtk").write_text(TETS)
        ball = 4 / 3 * math.pi * 0.004 ** 3
        for text, volume, first, accuracy in (
                ("block 0.008 0.0123 INF INF 0.011 0.013", 0.0043 * 0.02 * 0.002, True, 1e-9),
                ("block 0.008 0.0123 INF INF 0.011 0.013 side out", 0.02 ** 3 - 0.0043 * 0.02 * 0.002, False, 5e-3),
                ("sphere 0.01 0.01 0.012 0.004", ball, True, 1e-3),
                ("cylinder z 0.01 0.01 0.005 INF INF", math.pi * 0.005 ** 2 * 0.02, True, 1e-3),
                ("cone z 0.01 0.01 0.001 0.008 0.0 0.02", math.pi / 3 * 0.02 * (1e-6 + 8e-6 + 64e-6), True, 1e-3),
                ("union 2 one two", 2 * ball, False, 2e-3),
                ("mesh/tet file tets.vtk scale 1. move 0. 0. 0. rotate 0. 0. 0.", 0.02 ** 3 / 6, False, 1e-2)):
            with self.subTest(text):
                more = ("region one sphere 0.005 0.0155 0.0045 0.004 units box\nregion two sphere 0.015 0.004 0.015 0.004 units box\n"
                        f"region r {text} units box")
                rows = self.meet([(inside, (1, 1), GAP), (outside, (1, 2), GAP)], "region r", steps=1000, more=more)
                row = rows["all", "all"]
                if "mesh" in text:
                    self.assertEqual(row["collisions"], 0)
                else:
                    self.assertEqual(row["collisions"], 1)
                    self.assertEqual(rows["all", "1-1"]["collisions"], first)
                self.assertAlmostEqual(row["volume"] / volume, 1, delta=accuracy)
                self.assertEqual(row["lost"], 0)

    def test_slabs_of_a_region(self):
        """The volume of slabs of a ball, also of those that lie outside of it and of the box."""
        rows = self.meet([((0.01, 0.01, 0.012), (1, 1), GAP)], "region r bins z -0.01 0.03 10", steps=100,
                         more="region r sphere 0.01 0.01 0.01 0.008 units box")
        for n in range(10):
            low, high = (min(max(-0.01 + 0.004 * k, 0.002), 0.018) - 0.01 for k in (n, n + 1))
            exact = math.pi * (0.008 ** 2 * (high - low) - (high ** 3 - low ** 3) / 3)
            self.assertAlmostEqual(rows[f"bin{n + 1}", "all"]["volume"], exact, delta=2e-3 * math.pi * 0.008 ** 2 * 0.004)
        self.assertTrue(math.isnan(rows["bin1", "all"]["frequency_per_volume"]))

    def test_moving_region(self):
        """A ball moves along x, to where the second pair meets later and away from where a third does."""
        pairs = [((0.005, 0.01, 0.01), (1, 1), GAP), ((0.015, 0.01, 0.01), (1, 2), LATER), ((0.005, 0.013, 0.01), (2, 2), LATER)]
        rows = self.meet(pairs, "region r", steps=2600,
                         more="variable dx equal step*dt*4\nregion r sphere 0.005 0.011 0.01 0.0035 units box move v_dx NULL NULL")
        self.assertEqual(self.counts(rows), {("all", "all"): 2, ("all", "1-1"): 1, ("all", "1-2"): 1})
        self.assertAlmostEqual(rows["all", "all"]["volume"] / (4 / 3 * math.pi * 0.0035 ** 3), 1, delta=1e-2)

    def volumes(self, regions, more="", stats="", ranks=0):
        """{region: row of everything} of regions that many fixes look at in one run"""
        names = {name: f"v_{name}.csv" for name in regions}
        text = more + "\n" + "\n".join(f"region {name} {shape}\n" for name, shape in regions.items() if shape)
        text += "".join(f"fix f{name} all collision/stats contact c region {name} {stats} file {file}\n" for name, file in names.items())
        self.meet([((0.003, 0.005, 0.01), (1, 1), GAP)], "", steps=40, more=text, ranks=ranks)
        return {name: self.rows(file) for name, file in names.items()}

    def test_volume_of_what_moves(self):
        """Small against the box, turned, with a radius that varies: a grid about where it is. A block along the grid is
        exact; else 80^3 cells, of which some 3e4 are cut: 1e-3 is four standard deviations."""
        turned, ball = (0.003, 0.004, 0.001), 4 / 3 * math.pi
        v = self.volumes({
            "block": "block 0.003 0.0033 0.004 0.0043 0.005 0.0053 units box move v_dx NULL v_dx",
            "ball": "sphere 0.003 0.003 0.003 0.00003 units box move NULL v_dx NULL",
            "turned": "block 0.01 0.013 0.008 0.012 0.009 0.01 units box rotate v_angle 0.01 0.01 0.01 1 2 3",
            "grows": "sphere 0.01 0.01 0.01 v_r units box",
            "pipe": "cylinder z 0.01 0.01 v_r 0.005 0.006 units box",
            "edge": "block 0.0195 0.0199 0.004 0.0043 0.005 0.0053 units box move v_dx NULL NULL",
            "both": "union 2 block grows units box"},
            "variable dx equal step*1e-5\nvariable angle equal step*0.02\nvariable r equal 0.001+step*1e-5", ranks=2)
        volume = {name: rows["all", "all"]["volume"] for name, rows in v.items()}
        self.assertAlmostEqual(volume["block"] / 0.0003 ** 3, 1, delta=1e-9)
        self.assertAlmostEqual(volume["ball"] / (ball * 0.00003 ** 3), 1, delta=1e-3)
        self.assertAlmostEqual(volume["turned"] / math.prod(turned), 1, delta=3e-3, msg="a sixth of its box")
        self.assertAlmostEqual(volume["grows"] / (ball * 0.0014 ** 3), 1, delta=1e-3)
        self.assertAlmostEqual(volume["pipe"] / (math.pi * 0.0014 ** 2 * 0.001), 1, delta=1e-3)
        self.assertAlmostEqual(volume["edge"] / (0.0001 * 0.0003 ** 2), 1, delta=1e-9, msg="within the box")
        self.assertAlmostEqual(volume["both"] / (volume["block"] + ball * 0.0014 ** 3), 1, delta=1e-3)

    def test_volume_of_what_is_combined(self):
        """Bodies far apart and overlapping; the slabs add up to the whole, the last digit of ten aside."""
        a, b, c = 0.0007 ** 3, 4 / 3 * math.pi * 0.0003 ** 3, 0.004 ** 3
        v = self.volumes({"apart": "union 2 a b", "over": "union 3 a c d", "cut": "intersect 2 c d"},
                         "region a block 0.003 0.0037 0.003 0.0037 0.003 0.0037 units box\nregion b sphere 0.018 0.017 0.016 0.0003 units box\n"
                         "region c block 0.008 0.012 0.008 0.012 0.008 0.012 units box\n"
                         "region d block 0.011 0.015 0.011 0.015 0.011 0.015 units box", stats="bins z 0.003 0.018 7")
        for name, exact, accuracy in (("apart", a + b, 1e-3), ("over", a + 2 * c - 0.001 ** 3, 1e-3), ("cut", 0.001 ** 3, 1e-9)):
            with self.subTest(name):
                whole = v[name]["all", "all"]["volume"]
                self.assertAlmostEqual(whole / exact, 1, delta=accuracy)
                self.assertAlmostEqual(sum(v[name][f"bin{n}", "all"]["volume"] for n in range(1, 8)) / whole, 1, delta=1e-8)

    def test_group(self):
        pairs = [((0.005, 0.01, 0.01), (1, 1), GAP), ((0.01, 0.01, 0.01), (1, 2), GAP), ((0.015, 0.01, 0.01), (2, 2), GAP)]
        rows = self.meet(pairs, "spectra s.csv",
                         more="group second type 2\nfix g second collision/stats contact c file group.csv")
        self.assertEqual(rows["all", "all"]["collisions"], 3)
        group = self.rows("group.csv")
        self.assertEqual(self.counts(group), {("all", "all"): 1, ("all", "2-2"): 1})
        self.assertEqual(group["all", "all"]["grains_1"], 3)

    def test_stats_start(self):
        """What begins before does not count, even if it ends later; time and grains are those since."""
        pairs = [((0.005, 0.01, 0.01), (1, 1), GAP), ((0.01, 0.01, 0.01), (1, 2), LATER)]
        rows = self.meet(pairs, "stats_start 2e-5", steps=3000)
        self.assertEqual(self.counts(rows), {("all", "all"): 1, ("all", "1-2"): 1})
        self.assertAlmostEqual(rows["all", "all"]["time"], 3e-3 - 2e-5, delta=1e-9)
        self.assertEqual(rows["all", "all"]["lost"], 0)

    def test_grains_in_a_region_are_counted_on_the_way(self):
        """The mean of counts at every hundredth step: a grain alone flies through a slab."""
        self.data([(1, D, RHO, (0.0012, 0.01, 0.01), (5.0, 0, 0))], BOX)
        self.liggghts(self.script("run 4000", dt=1e-6, stats="fix k all collision/stats contact c bins x 0 0.02 4 file collisions.csv"))
        rows = self.rows()
        # x = 0.0012 + 5e-4 k at count k = 0 ... 40, through the boundary at k = 38
        expected = [0, 0, 0, 0]
        for k in range(41):
            expected[int((0.0012 + 5e-4 * k) % 0.02 // 0.005)] += 1
        self.assertEqual([round(41 * rows[f"bin{n}", "all"]["grains_1"], 6) for n in (1, 2, 3, 4)], expected)


if __name__ == "__main__":
    unittest.main()
