# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""Runs of fix hertz/cg continued from restart files."""

import unittest

import granular as g
from grainjet import Case

BOX = 0.0125
END = 500     # every run ends at this step


class Restart(Case):

    def setUp(self):
        super().setUp()
        (self.folder / "data").write_text(
            g.assembly(800, BOX, (0.001, 0.0012), speed=0.5, spin=300, seed=5))

    def run_script(self, name, source, tail, ranks=0, more="", check=True, rolling="cdt"):
        """Run to the end; the last frame and the sums over all collisions."""
        result = self.liggghts(
            g.load(g.PLUGIN) + g.head(more=more) + source
            + "neighbor 0.0005 bin\nneigh_modify delay 0\n" + g.MATERIAL
            + g.contacts(g.PLUGIN, rolling=rolling) + "fix i all nve/sphere\n"
            + "fix g all gravity 9.81 vector 0 0 -1\ntimestep 1e-6\n"
            + "variable b equal f_c[2]\nvariable d equal f_c[7]\n"
            + g.dump(END, f"dump.{name}") + tail + "print 'sums $b $d'\n",
            ranks, name=f"in.{name}", check=check)
        if not check:
            return result
        sums = [line for line in result.output.split("\n") if line.startswith("sums ")]
        return g.read_dump(self.folder / f"dump.{name}")[END], sums[-1]

    def assertSame(self, whole, continued):
        """All digits of all grains, and of collisions and dissipated energy."""
        self.assertEqual(whole[0], continued[0])
        self.assertEqual(whole[1], continued[1])
        self.assertGreater(max(abs(r[k]) for r in whole[0].values() for k in g.T), 0.0)

    def test_write_restart_between_runs_bit_for_bit(self):
        whole = self.run_script("whole", "read_data data\n", "run 300\nwrite_restart r\nrun 200\n")
        continued = self.run_script("continued", "read_restart r\n", "run 200\n")
        self.assertSame(whole, continued)

    def test_file_from_the_middle_of_a_run_bit_for_bit(self):
        for more in ("", "atom_modify sort 0 0\n", "atom_modify sort 100 0\n"):
            with self.subTest(more=more):
                whole = self.run_script("whole", "read_data data\n", "restart 300 r.*\nrun 500\n", more=more)
                continued = self.run_script("continued", "read_restart r.300\n", "run 200\n", more=more)
                self.assertSame(whole, continued)

    def test_other_number_of_ranks(self):
        """A file of a serial run read by 2 ranks and by 4, and one of 2 ranks read serially. Sums in another
        order: round-off, and a few contacts' growth of it."""
        whole = self.run_script("whole", "read_data data\n", "restart 300 s.*\nrun 500\n")
        self.run_script("two", "read_data data\n", "restart 300 t.*\nrun 500\n", ranks=2)
        for name, file, ranks in (("a", "s.300", 2), ("b", "s.300", 4), ("c", "t.300", 0)):
            frame, sums = self.run_script(name, f"read_restart {file}\n", "run 200\n", ranks=ranks)
            x = g.distance(whole[0], frame, BOX)
            print(f"{file} on {ranks or 1} rank(s): positions differ by {x / 1e-3:.1e} diameters")
            self.assertLess(x, 1e-8 * 1e-3)
            self.assertEqual(whole[1].split()[1], sums.split()[1], "collisions begun")

    def test_another_factor_is_refused(self):
        self.run_script("whole", "read_data data\n", "run 300\nwrite_restart r\nrun 200\n",
                        more="coarsegraining 2\n")
        self.assertFails(
            self.run_script("other", "read_restart r\n", "run 200\n", more="coarsegraining 3\n", check=False),
            "hertz/cg", "coarsegraining 2", "3")
        # also that of another type than the first
        self.run_script("types", "read_data data\n", "run 10\nwrite_restart r2\nrun 490\n", more="coarsegraining 2 2\n")
        self.assertFails(
            self.run_script("other", "read_restart r2\n", "run 200\n", more="coarsegraining 2 3\n", check=False),
            "hertz/cg", "`coarsegraining 2` for type 2", "this script has 3")

    def test_another_rolling_model(self):
        """Springs of one model mean nothing to another; without springs the model may change."""
        self.run_script("epsd", "read_data data\n", "run 10\nwrite_restart r\nrun 490\n", rolling="epsd")
        for model in ("epsd2", "cdt", "off"):
            self.assertFails(self.run_script("other", "read_restart r\n", "run 20\n", check=False, rolling=model),
                             "hertz/cg", "another `rolling` model")
        self.run_script("cdt", "read_data data\n", "run 10\nwrite_restart r\nrun 490\n")
        self.run_script("off", "read_restart r\n", "run 490\n", rolling="off")

    def test_rolling_springs_go_on_bit_for_bit(self):
        whole = self.run_script("whole", "read_data data\n", "restart 300 r.*\nrun 500\n", rolling="epsd")
        self.assertSame(whole, self.run_script("continued", "read_restart r.300\n", "run 200\n", rolling="epsd"))

    def test_grains_changed_after_reading(self):
        """What the script changes before it runs on counts from the first force: as after a file that was written
        between runs, of which forces are worked out anew."""
        self.run_script("whole", "read_data data\n", "restart 300 m.*\nrun 300\nwrite_restart e\nrun 200\n")
        for change in ("set group all diameter 0.0012\n", "velocity all set 0.1 0 0\n",
                       "run 0\ndisplace_atoms all random 1e-4 1e-4 1e-4 15485863 units box\nset group all diameter 0.00115\n"):
            with self.subTest(change=change):
                frames = []
                for file in ("m.300", "e"):
                    self.liggghts(g.load(g.PLUGIN) + g.head() + f"read_restart {file}\nneighbor 0.0005 bin\n" + g.MATERIAL
                                  + g.contacts(g.PLUGIN, rolling="cdt") + "fix i all nve/sphere\ntimestep 1e-6\n" + change
                                  + g.dump(100, f"dump.{file}") + "run 100\n")
                    frames.append(g.read_dump(self.folder / f"dump.{file}"))
                for step in frames[0]:
                    self.assertLess(g.difference(frames[1][step], frames[0][step], g.F), 1e-9, step)


if __name__ == "__main__":
    unittest.main()
