# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad entries of the models of lift and torque, and of drag with a sphericity: one error with file, entry and limits."""
# processors: 2

import unittest

import bad_case
from grainjet import coupled_box as box


class LiftEntries(bad_case.BadCase):

    def options(self, forces, drag=None):
        folder = self.fresh()
        box.fv_options(folder, drag=drag, forces=forces)
        return folder

    def test_good(self):
        for ranks in (0, 2):
            folder = self.options("{ drag { model HaiderLevenspiel; sphericity 1; } SaffmanMei {} Magnus {} fluidTorque {} }")
            said = self.assertRuns(folder, ranks=ranks).output
            self.assertIn("Forces: drag (HaiderLevenspiel) SaffmanMei Magnus fluidTorque", said)
        self.assertRuns(self.options("(SaffmanMei Magnus fluidTorque)", drag="Stokes"))

    def test_unknown_entries(self):
        for model in ("SaffmanMei", "Magnus", "fluidTorque"):
            self.assertRefused(self.options(f"{{ drag {{}} {model} {{ C 1; }} }}"), "constant/fvOptions", f"Unknown entry C", model)
        self.assertRefused(self.options("{ drag {} Saffman {} }"), "Unknown force Saffman", "SaffmanMei")

    def test_drag_behind(self):
        for ranks in (0, 2):
            for model in ("SaffmanMei", "Magnus"):
                self.assertRefused(self.options(f"{{ {model} {{}} drag {{}} }}"), "constant/fvOptions",
                                   f"drag stands behind {model}", ranks=ranks)

    def test_without_drag(self):
        """The log says once what a lift without drag does; with drag, nothing. The grain spins across its slip."""
        for forces, warned in (("{ Magnus {} }", True), ("{ fluidTorque {} Magnus {} }", True),
                               ("{ drag { model Stokes; } SaffmanMei {} Magnus {} }", False)):
            for ranks in (0, 2):
                with self.subTest(forces=forces, ranks=ranks):
                    folder = self.options(forces)
                    box.script(folder, grains=bad_case.GRAIN + "\nset atom 1 omegax 1000 omegay 0 omegaz 0", boundary="f f f")
                    said = self.assertRuns(folder, ranks=ranks).output
                    self.assertEqual(said.count("Magnus acts on grains without drag"), int(warned), said[-3000:])
                    if warned:
                        self.assertIn("the slip grow in each, without bound. Put drag before it", " ".join(said.split()))

    def test_sphericity(self):
        for law, least in (("HaiderLevenspiel", "0.026"), ("Ganser", "0.09")):
            for value in ("0", "-0.5", "1.001", "0.0259", "80"):
                for ranks in (0, 2) if value == "80" else (0,):
                    self.assertRefused(self.options(f"{{ drag {{ model {law}; sphericity {value}; }} }}"), "constant/fvOptions",
                                       f"sphericity {value} in drag must be a number from {least} to 1: surface of",
                                       ranks=ranks, at_reading=True)
            for value in ("round", "nan", "(1 2)", ""):
                self.assertRefused(self.options(f"{{ drag {{ model {law}; sphericity {value}; }} }}"), "sphericity",
                                   f"must be a number from {least} to 1: surface of", at_reading=True)
            for ranks in (0, 2):
                self.assertRefused(self.options(f"{{ drag {{ model {law}; }} }}"), "constant/fvOptions",
                                   "Entry sphericity is missing in drag", f"must be a number from {least} to 1: surface",
                                   "sphericity 0.8;", ranks=ranks, at_reading=True)
            self.assertRefused(self.options("()", drag=law), "Entry sphericity is missing",
                               f"forces {{ drag {{ model {law}; sphericity 0.8; }} }}")
            self.assertRefused(self.options(f"{{ drag {{ model {law}; phi 0.8; sphericity 0.8; }} }}"), "Unknown entry phi")
        self.assertRefused(self.options("{ drag { model Gidaspow; sphericity 0.8; } }"), "Unknown entry sphericity")


if __name__ == "__main__":
    unittest.main()
