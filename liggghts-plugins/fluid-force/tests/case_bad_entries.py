# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every word of fix fluid/force spoilt in every way; what makes forces that are no numbers; empty boxes."""
# processors: 2
# label: long

import concurrent.futures
import unittest

import grainjet
from grainjet import bad_input, pages
from grainjet.bad_input import Entry

SCRIPT = """
    plugin load fluidforceplugin.so
    atom_style granular
    atom_modify map array sort 0 0
    boundary f f f
    newton off
    communicate single vel yes
    units si
    region box block -1 1 -1 1 -1 1 units box
    create_box 1 box
    neighbor 0.1 bin
    timestep 1e-5
    {grains}
    fix g all gravity 9.81 vector 0 0 -1
    {fix}
    fix i all nve/sphere
    thermo_style custom step atoms f_f[1] f_f[4]
    run 2
"""
GRAIN = "create_atoms 1 single 0 0 0 units box\nset group all diameter 1e-3 density 2500"

ENTRIES = {
    "uniform": Entry("velocity", "1 0 0", required=True),
    "density": Entry("positive", "1.2", required=True),
    "viscosity": Entry("positive", "1.5e-5", required=True),
    # the one needs the other
    "drag": Entry("choice", "ganser", required=True),
    "sphericity": Entry("sphericity", "0.8", required=True),
    "buoyancy": Entry("switch", "yes"),
    "rotation": Entry("switch", "yes"),
    "magnus": Entry("switch", "yes"),
    "addedMass": Entry("positive", "0.5"),
}
KINDS = {"velocity": [(what, text.replace("x", bad)) for text in ("x 0 0", "0 0 x")
                      for what, bad in (("a word", "up"), ("not a number", "nan"), ("infinite", "inf"),
                                        ("huge", "1e300"), ("minus huge", "-1e300"), ("faster than light", "3e8"))]
         + [("two values", "1 0"), ("four values", "1 0 0 0")],
         "sphericity": bad_input.values("positive") + [("above one", "1.0001"), ("below the fit", "0.08")],
         "positive": bad_input.values("positive") + [("tiny", "1e-300"), ("with a unit", "1.2kg")]}


class Spoilt(grainjet.Case):

    def end(self, line, ranks=0, grains=GRAIN, name="in.test"):
        return self.liggghts(SCRIPT.format(fix=f"fix f all fluid/force {line}", grains=grains), ranks, check=False,
                             args=["-log", "none"], name=name)

    def refused(self, result):
        self.assertEqual(result.code, 1, result)
        errors = result.errors
        self.assertEqual(len(errors), 1, result)
        self.assertIn("Fix fluid/force (ID f)", errors[0])
        return errors[0]

    def test_the_page_has_these_entries(self):
        page = (grainjet.ROOT / "docs/fix_fluid_force.md").read_text()
        names = ["uniform" if name == "ux uy uz" else name for name in pages.table_of_page(page, "Syntax")]
        self.assertEqual(names, list(ENTRIES))

    def test_good_ones(self):
        line = " ".join(f"{key} {entry.good}" for key, entry in ENTRIES.items())
        for ranks in (0, 2):
            self.assertEqual(self.end(line, ranks).code, 0)

    def test_each_entry(self):
        every = bad_input.spoil(ENTRIES, KINDS)
        lines = [" ".join(f"{key} {value}" for key, value in bad.replace(ENTRIES)) for bad in every]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda n: self.end(lines[n], name=f"in.{n}"), range(len(lines))))
        for bad, result in zip(every, results):
            with self.subTest(f"{bad.entry}: {bad.what}"):
                if bad.must_fail:
                    self.refused(result)
                else:
                    self.assertEqual(result.code, 0, result)

    def test_names_what_and_limits(self):
        for line, words in (
                ("uniform 1e300 0 0 density 1 viscosity 1", ("ux uy uz", "2.99792e+08", "1e300")),
                ("uniform 1 0 0 density 1e300 viscosity 1", ("density must be from 1e-12 to 1e+12", "1e300")),
                ("uniform 1 0 0 density 1 density 1 viscosity 1", ("keyword density is given twice",)),
        ):
            error = self.refused(self.end(line, ranks=2))
            for word in words:
                self.assertIn(word, error)

    def test_box_without_grains(self):
        for line in ("coupled", "uniform 1 0 0 density 1.2 viscosity 1.5e-5 rotation yes buoyancy yes"):
            for ranks in (0, 2):
                result = self.end(line, ranks, grains="")
                self.assertEqual(result.code, 0, result)


class NoNumber(grainjet.Case):

    def test_force_that_is_no_number(self):
        """A speed of which the square overflows, as after a contact that blew up; one rank has the grain."""
        script = SCRIPT.format(grains=GRAIN + "\nvelocity all set 1e200 0 0 units box",
                               fix="fix f all fluid/force uniform 1 0 0 density 1.2 viscosity 1.5e-5")
        for ranks in (0, 2):
            result = self.liggghts(script, ranks, check=False)
            self.assertEqual(result.code, 1, result)
            self.assertFails(result, "Fix fluid/force (ID f): the force on grain 1 is", "in step", "Its velocity is",
                             "the fluid's (1 0 0) m/s", "radius 0.0005 m")
            self.assertEqual(result.output.count("Fix fluid/force"), 1, result)

    def test_fluid_that_diverges(self):
        """What a coupling writes: a velocity that overflows, and one that is no number."""
        for wind in ("1e300", "nan"):
            script = SCRIPT.format(grains=GRAIN, fix=f"""
                plugin load {grainjet.ROOT}/lib/tests/exchangeprobeplugin.so
                fix f all fluid/force coupled
                fix d all exchange/probe 1 {wind} 0 1e-5 0""").replace("run 2", "run 20")
            result = self.liggghts(script, check=False)
            self.assertFails(result, "Fix fluid/force (ID f): the force on grain 1 is", "the fluid's")


if __name__ == "__main__":
    unittest.main()
