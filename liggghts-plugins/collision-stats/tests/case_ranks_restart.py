# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""fix collision/stats on several ranks and over restarts: a gas that streams through a periodic box, so that grains change
their rank in the middle of collisions and these go on where a restart file is written."""

import math
import unittest

from collision_case import CollisionCase, gas

D = 0.001
STATS = ("fix k all collision/stats contact c region half bins x 0 0.016 4 energy 1e-10 1e-4 12 every 500 file {name}.csv "
         "stats_start 2e-4\n"
         "fix a all collision/stats contact c every 500 file all_{name}.csv")
REGION = "region half block INF INF 0.002 0.008 INF INF"
SUMS = """
variable a equal f_a[1]
variable b equal f_a[2]
variable c equal f_a[3]
variable d equal f_a[4]+f_a[5]-f_c[6]
variable e equal f_c[7]
variable f equal f_c[2]
print "sums $a $b $c $d $e $f"
"""


class RanksAndRestart(CollisionCase):

    def setUp(self):
        super().setUp()
        grains, self.width = gas(400, 0.1, (D, 1.3 * D), 0.5, seed=3, types=2, spin=200)
        # no grain may begin in contact
        self.data([(*row[:4], [v + u for v, u in zip(row[4], (1.5, -1.0, 0.7))], row[5]) for row in grains], self.width, types=2)

    def run_it(self, name, body, ranks=0, read="read_data grains.data", stats=STATS):
        result = self.liggghts(
            self.script(body + SUMS, stats=f"{REGION}\n" + stats.format(name=name), dt=1e-6, types=2, read=read), ranks,
            name=f"in.{name}")
        return self.printed(result, "sums")

    def texts(self, name):
        return [(self.folder / f"{prefix}{name}{suffix}.csv").read_text()
                for prefix in ("", "all_") for suffix in ("", "_spectra")]

    def test_every_number_of_ranks(self):
        """Counts are equal; moments differ by what rounding has grown to after one or two collisions of each grain,
        in grains that the boundary of a box or a rank has shifted."""
        one = self.run_it("one", "run 3000")
        self.assertGreater(one[0], 300)
        self.assertGreater(one[1], 10, "none goes on")
        self.assertEqual(one[2], 0)
        self.assertEqual(one[0] + one[1], one[5], "collisions that fix hertz/cg has begun")
        self.assertAlmostEqual(one[3] / one[4], 1.0, delta=1e-10, msg="dissipated energy, with what is in springs")
        tables = {}
        for ranks in (1, 2, 4):
            name = f"ranks{ranks}"
            sums = self.run_it(name, "run 3000", ranks)
            self.assertEqual(sums[:3], one[:3])
            self.assertEqual(sums[5], one[5])
            self.assertAlmostEqual(sums[3] / one[3], 1.0, delta=1e-7)
            for prefix in ("", "all_"):
                tables[prefix] = self.rows(f"{prefix}one.csv")
                other = self.rows(f"{prefix}{name}.csv")
                self.assertEqual(other.keys(), tables[prefix].keys())
                for key, row in tables[prefix].items():
                    for column, value in row.items():
                        with self.subTest(ranks=ranks, row=key, column=column):
                            if math.isnan(value):
                                self.assertTrue(math.isnan(other[key][column]))
                            elif column in ("collisions", "touching", "lost", "grains_1", "grains_2"):
                                self.assertEqual(other[key][column], value)
                            elif "skewness" in column or "tangential" in column or "variance" in column:
                                continue    # differences of nearly equal numbers
                            else:
                                self.assertAlmostEqual(other[key][column], value, delta=1e-6 * abs(value) + 1e-300)
        for key, row in tables[""].items():
            if key[0] == "all":
                print(key[1], "in the region:", row["collisions"], "collisions of", row["grains_1"], "grains")
        self.assertEqual(sum(tables[""][f"bin{n}", "all"]["collisions"] for n in range(1, 5)),
                         tables[""]["all", "all"]["collisions"], "the slabs are the whole box")

    def assertContinues(self, run, go_on, file, ranks):
        whole = self.run_it("whole", run, ranks)
        expected = self.texts("whole")
        self.assertIn("1-2", expected[0])
        again = self.run_it("again", go_on, ranks, read=f"read_restart {file}")
        # fix hertz/cg adds up its energies in another order, to their last digit
        self.assertEqual(again[:3], whole[:3])
        self.assertEqual(self.texts("again"), expected)
        self.assertGreater(whole[0], 300)

    def test_restart_between_runs_bit_for_bit(self):
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                self.assertContinues("run 1400\nwrite_restart r\nrun 1600", "run 1600", "r", ranks)

    def test_restart_from_the_middle_bit_for_bit(self):
        self.assertContinues("restart 1400 r.*\nrun 3000", "run 1600", "r.1400", 0)

    def test_collisions_go_on_over_a_restart(self):
        """Those that go on at the restart are over afterwards, none is lost, and without the state of the file they
        would not count."""
        before = self.run_it("before", "run 1400\nwrite_restart r")
        self.assertGreater(before[1], 10)
        after = self.run_it("after", "run 1600", read="read_restart r")
        self.assertEqual(after[2], 0)
        self.assertEqual(after[0] + after[1], after[5])
        self.liggghts(self.script("run 1600", dt=1e-6, types=2, read="read_restart r",
                                  stats="fix new all collision/stats contact c file new.csv"))
        row = self.rows("new.csv")["all", "all"]
        self.assertEqual(row["lost"], 0)
        self.assertEqual(after[0] - before[0] - row["collisions"], before[1])

    def test_restart_without_the_fix_and_with_it_again(self):
        """The state of collisions is dropped with the fix; the grains go on the same."""
        self.run_it("before", "run 1400\nwrite_restart r")
        dump = "dump d all custom 1600 {}.txt id x y z vx vy vz\ndump_modify d sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"\n"
        self.run_it("with", dump.format("with") + "run 1600", read="read_restart r")
        result = self.liggghts(self.script(dump.format("without") + "run 1600\nwrite_restart s", stats="", dt=1e-6, types=2,
                                           read="read_restart r"))
        self.assertEqual((self.folder / "with.txt").read_text(), (self.folder / "without.txt").read_text())
        self.assertNotIn("Fix collision/stats", result.output)
        self.run_it("again", "run 100", read="read_restart s")

    def test_what_differs_from_the_file_is_refused(self):
        self.run_it("before", "run 100\nwrite_restart r")
        for words, change in (
                (("other bins or spectra", "stats_start"), lambda s: s.replace("0.016 4", "0.016 5")),
                (("other bins or spectra",), lambda s: s.replace("1e-4 12", "1e-4 13")),
                (("region 'half'",), lambda s: s.replace("region half ", "")),
                (("group 'all', not 'ones'",), lambda s: "group ones type 1\n" + s.replace("fix k all", "fix k ones")),
                (("region 'half' that was block", "0.002 0.008", "not block", "0.003 0.008"),
                 lambda s: "region half delete\n" + REGION.replace("0.002", "0.003") + "\n" + s),
                (("not cylinder",), lambda s: "region half delete\nregion half cylinder z 0 0 0.01 INF INF\n" + s),
        ):
            result = self.liggghts(self.script("run 1", stats=f"{REGION}\n" + change(STATS.format(name="x")), types=2,
                                               read="read_restart r"), 2, check=False)
            self.assertFails(result, "Fix collision/stats (ID k)", *words)
            self.assertEqual(result.output.count("ERROR"), 1)
        # with another stats_start statistics begin anew
        self.run_it("anew", "run 100", read="read_restart r",
                    stats=STATS.replace("0.016 4", "0.016 5").replace("stats_start 2e-4", "stats_start 1e-4"))
        self.assertAlmostEqual(self.rows("anew.csv")["all", "all"]["time"], 1e-4, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
