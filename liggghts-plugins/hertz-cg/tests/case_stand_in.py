# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""Fix hertz/cg in the place of the pair style: it comes and goes with the fix, and restart files know nothing
of it."""

import unittest

import granular as g
from grainjet import Case, tables


class StandIn(Case):

    def setUp(self):
        super().setUp()
        (self.folder / "data").write_text(g.assembly(60, 0.0085, (0.001, 0.0014), speed=0.5, spin=300))

    def script(self, law, commands, source="read_data data\n", kind=g.PLUGIN):
        return (g.load(kind) + g.head(more="atom_modify sort 0 0") + source + "neighbor 0.0005 bin\nneigh_modify delay 0\n" + g.MATERIAL + law
                + "fix i all nve/sphere\ntimestep 1e-7\n" + commands)

    def frames(self, script, ranks=0):
        self.liggghts(script, ranks)
        return g.read_dump(self.folder / "dump.txt")

    def assertSame(self, one, other):
        self.assertEqual(one.keys(), other.keys())
        for step in one:
            self.assertLess(g.difference(one[step], other[step], g.F + g.T), 1e-9, step)

    STOCK = "pair_style gran model hertz tangential history\npair_coeff * *\n"

    def test_the_fix_comes_after_the_pair_style_has_gone(self):
        stock = self.frames(self.script(self.STOCK, g.dump(10) + "run 20\n", kind=g.STOCK))
        for law in ("fix c all hertz/cg\n",
                    self.STOCK + "pair_style none\nfix c all hertz/cg\n",
                    self.STOCK + "fix c all hertz/cg\npair_style none\n",
                    "fix c all hertz/cg\npair_coeff * *\n"):
            with self.subTest(law=law):
                self.assertSame(stock, self.frames(self.script(law, g.dump(10) + "run 20\n")))

    def test_the_stock_pair_style_after_the_fix_has_gone(self):
        stock = self.frames(self.script(self.STOCK, "run 1\n" + g.dump(10) + "run 20\n", kind=g.STOCK))
        law = "fix c all hertz/cg\nrun 0\nunfix c\n" + self.STOCK
        self.assertSame(stock, self.frames(self.script(law, "run 1\n" + g.dump(10) + "run 20\n")))
        # nothing holds the grains apart when neither is there: nobody's contacts are left behind
        result = self.liggghts(self.script("fix c all hertz/cg\nrun 0\nunfix c\n", "run 5\n"))
        self.assertNotIn("ERROR", result.output)

    def test_the_pair_style_after_the_fix_is_refused(self):
        for law in ("fix c all hertz/cg\n" + self.STOCK, self.STOCK + "fix c all hertz/cg\n"):
            for ranks in (0, 2):
                result = self.liggghts(self.script(law, "run 1\n"), ranks, check=False)
                self.assertFails(result, "ERROR", "hertz/cg", "pair_style gran", "remove one of them")

    def test_defined_again_under_its_name(self):
        stock = self.frames(self.script(self.STOCK, "run 1\n" + g.dump(10) + "run 20\n", kind=g.STOCK))
        for before in ("", "run 0\n"):
            law = "fix c all hertz/cg rolling epsd\n" + before + "fix c all hertz/cg\n"
            for ranks in (0, 2):
                self.assertSame(stock, self.frames(self.script(law, "run 1\n" + g.dump(10) + "run 20\n"), ranks))

    def test_clear(self):
        self.liggghts(self.script("fix c all hertz/cg\n", "compute s all stress/atom\nfix a all ave/atom 1 10 10 c_s[1]\nrun 20\nclear\n")
                      + self.script("fix c all hertz/cg\n", "run 20\n").replace("plugin load hertzcgplugin.so\n", ""), 2)

    def test_computes_outlive_the_fix(self):
        """What referred to the pair style says so when it is gone, as it does with the stock one."""
        for law, gone in ((self.STOCK, "pair_style none\n"), ("fix c all hertz/cg\n", "unfix c\n")):
            commands = ("compute l all pair/gran/local id force\ncompute r all reduce sum c_l[4]\nthermo_style custom step c_r\n"
                        "run 5\n" + gone + "run 5\n")
            result = self.liggghts(self.script(law, commands), check=False)
            self.assertFails(result, "ERROR: No pair style is defined for compute pair/gran/local")

    def test_restart_files_hold_no_pair_style(self):
        """The stock program reads them without a pair style, and another number of ranks does as well."""
        written = ("fix heat all heat/gran/conduction initial_temperature 300.\nfix h1 all property/global thermalConductivity peratomtype 50. 30.\n"
                   "fix h2 all property/global thermalCapacity peratomtype 1. 2.\n")
        for ranks, name in ((0, "r0"), (2, "r2"), (2, "r%")):
            self.liggghts(self.script("fix c all hertz/cg\n", written + f"run 20\nwrite_restart {name}\n"), ranks)
            for other in (0, 2):
                last = self.frames(self.script("fix c all hertz/cg\n", g.dump(10) + "run 20\n", f"read_restart {name}\n"), other)
                self.assertEqual(len(last), 3)
            # without a pair style and without the fix grains do not feel each other
            free = self.frames(self.script("", g.dump(10) + "run 20\n", f"read_restart {name}\n", kind=g.STOCK))
            self.assertEqual(max(abs(row[k]) for row in free[40].values() for k in g.F), 0.0)
            # and with it again they do, as the stock program itself goes on
            self.frames(self.script(self.STOCK, g.dump(10) + "run 20\n", f"read_restart {name}\n", kind=g.STOCK))


class TwoImages(Case):

    def test_grains_that_touch_through_two_sides(self):
        """A periodic box of 1.4 diameters: two grains touch on both sides at once, and each contact keeps its own
        spring through searches and ranks. Without loss in the law the energy stays to 0.4 %, since a spring may be lost
        while a contact pulls; mixed up ones made 3 % of it on one rank and 28 % on two."""
        (self.folder / "data").write_text("two\n\n2 atoms\n1 atom types\n0 0.0014 xlo xhi\n0 0.003 ylo yhi\n0 0.003 zlo zhi\n\n"
            "Atoms\n\n1 1 0.001 2500 0.0001 0.001 0.0015\n2 1 0.001 2500 0.00081 0.0018 0.0015\n\n"
            "Velocities\n\n1 0 0.3 0.05 300 50 300\n2 0 -0.3 -0.05 -200 -70 400\n")
        material = "".join(f"fix {n} all property/global {text}\n" for n, text in (
            ("m1", "youngsModulus peratomtype 5.e6"), ("m2", "poissonsRatio peratomtype 0.3"),
            ("m3", "coefficientRestitution peratomtypepair 1 1"), ("m4", "coefficientFriction peratomtypepair 1 0.9")))
        for ranks in (0, 2):
            for more in ("", "restart 10 scratch.a scratch.b\n"):
                result = self.liggghts(g.load(g.PLUGIN) + g.head("p p p") + "processors 1 * *\nread_data data\nneighbor 0.0001 bin\n" + material
                    + "fix c all hertz/cg tangential_damping off\nfix i all nve/sphere\ntimestep 2e-7\n" + more
                    + "compute k all ke\ncompute r all erotate/sphere\nvariable e equal c_k+c_r+f_c[6]+f_c[7]\nvariable n equal f_c[1]\n"
                    "thermo_style custom step v_n v_e\nthermo 100\nrun 3000\n", ranks)
                rows = tables.thermo(result.output)
                self.assertEqual(max(row[1] for row in rows), 2, "never touched on both sides")
                for row in rows:
                    self.assertAlmostEqual(row[2], rows[0][2], delta=0.01 * rows[0][2])


if __name__ == "__main__":
    unittest.main()
