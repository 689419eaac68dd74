# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command coarsegraining: factors before and after the box, and its words spoilt in every way."""
# processors: 2
# label: long

import concurrent.futures
import unittest

import grainjet
from grainjet import bad_input, pages, tables
from grainjet.bad_input import Entry

HEAD = """
plugin load hertzcgplugin.so
{before}
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
units si
region box block -1 1 -1 1 -1 1 units box
"""
RUN = """
neighbor 0.1 bin
timestep 1e-5
fix i all nve/sphere
run 1
"""
GRAINS = """
create_box 2 box
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0 0 0.5 units box
set group all diameter 1e-3 density 2500
"""

ENTRIES = {"coarsegraining": Entry("factor", "2 3", required=True), "model_check": Entry("check", "warn")}
KINDS = {
    "factor": [(what, text.replace("x", bad)) for text in ("x", "2 x", "x 2")
               for what, bad in (("a word", "two"), ("not a number", "nan"), ("infinite", "inf"), ("huge", "1e300"),
                                 ("above the limit", "1000001"), ("minus huge", "-1e300"), ("zero", "0"),
                                 ("negative", "-2"), ("below one", "0.999"), ("with a comma", "2,5"))]
    + [("too many", "2 3 4"), ("one word", '"2 3"')],
    "check": bad_input.values("choice"),
}


class Command(grainjet.Case):

    def end(self, line, box="create_box 2 box", ranks=0, name="in.test", after=""):
        script = HEAD.format(before=line) + box + "\n" + after + RUN
        return self.liggghts(script, ranks, check=False, args=["-log", "none"], name=name)

    def refused(self, result):
        self.assertEqual(result.code, 1, result)
        errors = result.errors
        self.assertEqual(len(errors), 1, result)
        self.assertIn("Command coarsegraining", errors[0])
        self.assertNotIn("Setting up run", result.output)
        return errors[0]

    def factors(self, result):
        self.assertEqual(result.code, 0, result)
        line, = (line for line in result.output.splitlines() if line.startswith("Coarse graining:"))
        return line.split("f_cg =")[1].split()

    def test_the_page_has_these_entries(self):
        page = (grainjet.ROOT / "docs/coarsegraining.md").read_text()
        self.assertEqual(pages.table_of_page(page, "Syntax"), ["f [f2 ... fn]", "model_check"])

    def test_each_word(self):
        every = [bad for bad in bad_input.spoil(ENTRIES, KINDS) if bad.lines or bad.entry == "model_check"]
        lines = [" ".join(f"{key} {value}" for key, value in bad.replace(ENTRIES)) for bad in every]
        # the command's own name misspelt is an unknown command
        every, lines = zip(*((bad, line) for bad, line in zip(every, lines) if line.startswith("coarsegraining ")))
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda n: self.end(lines[n], name=f"in.{n}"), range(len(lines))))
        for bad, result in zip(every, results):
            with self.subTest(f"{bad.entry}: {bad.what} {bad.lines}"):
                if bad.must_fail:
                    self.refused(result)
                else:
                    self.assertEqual(result.code, 0, result)

    def test_factors_per_type_before_the_box(self):
        for ranks in (0, 2):
            self.assertEqual(self.factors(self.end("coarsegraining 2 5", ranks=ranks)), ["2", "5"])

    def test_before_and_after_the_box_are_the_same(self):
        """Template and skin see the factors of both types: a mixture inserted either way has the same radii."""
        mixture = """
            fix t1 all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.01
            fix t2 all particletemplate/sphere 15485867 atom_type 2 density constant 2500 radius constant 0.01
            fix m all particledistribution/discrete 32452843 2 t1 0.5 t2 0.5
            fix s all insert/pack seed 32452867 distributiontemplate m insert_every once overlapcheck yes &
                all_in yes particles_in_region 10 region box
            run 1
            compute radii all property/atom radius
            compute most all reduce max c_radii
            compute least all reduce min c_radii
            thermo_style custom step atoms c_most c_least
        """
        printed = []
        for before, box in (("coarsegraining 2 5", "create_box 2 box"), ("", "create_box 2 box\ncoarsegraining 2 5")):
            result = self.end(before, box=box, after="timestep 1e-5\n" + mixture)
            self.assertEqual(self.factors(result), ["2", "5"])
            _, atoms, *radii = tables.thermo(result.output)[-1]
            self.assertEqual(atoms, 10)
            printed.append(radii)
            self.assertEqual(radii, [0.05, 0.02])
        self.assertEqual(printed[0], printed[1])

    def test_wrong_number(self):
        """Before or after the box, made by any of the three commands: both numbers, and no step."""
        self.liggghts(HEAD.format(before="") + GRAINS + RUN + "write_restart grains.bin\n")
        (self.folder / "grains.data").write_text(
            "grains\n\n2 atoms\n2 atom types\n-1 1 xlo xhi\n-1 1 ylo yhi\n-1 1 zlo zhi\n\nAtoms\n\n"
            "1 1 0.001 2500 0 0 0\n2 2 0.001 2500 0 0 0.5\n")
        for box in ("create_box 2 box", "read_restart grains.bin", "read_data grains.data"):
            for ranks in (0, 2):
                with self.subTest(box, ranks=ranks):
                    error = self.refused(self.end("coarsegraining 2 5 3", box=box, ranks=ranks))
                    self.assertIn("states 3 factors, but the box has 2 atom types", error)
                    self.assertEqual(self.factors(self.end("coarsegraining 2 5", box=box, ranks=ranks)), ["2", "5"])
        error = self.refused(self.end("", box="create_box 2 box\ncoarsegraining 2 5 3"))
        self.assertIn("states 3 factors, but the box has 2 atom types", error)

    def test_after_clear_nothing_is_left(self):
        again = HEAD.format(before="").replace("plugin load hertzcgplugin.so", "")
        result = self.end("coarsegraining 2 5", box="create_box 2 box\nclear\n" + again + "create_box 3 box")
        self.assertEqual(result.code, 0, result)
        error = self.refused(self.end(
            "coarsegraining 2 5", box="create_box 2 box\nclear\ncoarsegraining 2 5\n" + again + "create_box 3 box"))
        self.assertIn("states 2 factors, but the box has 3 atom types", error)

    def test_one_factor_is_that_of_all_types(self):
        """Without the stock warning of unspecified types that model_check warn lets through."""
        result = self.end("coarsegraining 2 model_check warn", box="create_box 3 box")
        self.assertEqual(self.factors(result), ["2"])
        self.assertNotIn("WARNING", result.output)

    def test_order_of_commands(self):
        self.assertIn("given twice", self.refused(self.end("coarsegraining 2\ncoarsegraining 2")))


if __name__ == "__main__":
    unittest.main()
