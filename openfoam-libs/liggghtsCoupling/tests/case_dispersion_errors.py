# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input to turbulentDispersion and turbulentPressure: one message with file, keyword and fix, no step computed."""
# processors: 2

import shutil
import unittest

import bad_case
from grainjet import coupled_box as box


class DispersionErrors(bad_case.BadCase):

    def entry(self, dispersion, **more):
        folder = self.fresh()
        box.fv_options(folder, turbulentDispersion=dispersion, **more)
        return folder

    def test_constants(self):
        sct = "must be a number from 0.1 to 10: the turbulent Schmidt number"
        seed = "must be a whole number from 1 to 2147483647"
        models = "Valid: (none Langevin discreteRandomWalk)"
        for entry, words in (("Langvin", ("Unknown turbulentDispersion Langvin", models)),
                             ("{ model Langvin; }", ("Unknown model Langvin in turbulentDispersion", models)),
                             ("{ Sct 1; }", ("Entry model is missing", models, "model Langevin;")),
                             ("{}", ("Entry model is missing in turbulentDispersion", models, "model Langevin;")),
                             ("", ("turbulentDispersion has no value in particles. It must be", models)),
                             ("3", ("turbulentDispersion 3 in particles must be one word or a dictionary", models)),
                             ("{ model Langevin; Sct 0; }", ("Sct 0 ", sct, "Sct 0.7;")),
                             ("{ model Langevin; Sct -1; }", ("Sct -1 ", sct)),
                             ("{ model Langevin; Sct 0.05; }", ("Sct 0.05 ", sct)),
                             ("{ model Langevin; Sct 11; }", ("Sct 11 ", sct)),
                             ("{ model Langevin; Sct; }", ("Sct has no value", sct)),
                             ("{ model Langevin; Sct one; }", ("Sct one ", sct)),
                             ("{ model Langevin; seed 0; }", ("seed 0 ", seed)),
                             ("{ model Langevin; seed 1.5; }", ("seed 1.5 ", seed)),
                             ("{ model Langevin; seed 3e9; }", ("seed 3e+09 ", seed, "seed 1;")),
                             ("{ model Langevin; CL 0.15; }", ("Unknown entry CL",)),
                             ("{ model discreteRandomWalk; Sct 1; }", ("Unknown entry Sct",)),
                             ("{ model discreteRandomWalk; CL 2; }", ("CL 2 ", "must be a number from 0.01 to 1: ")),
                             ("{ model discreteRandomWalk; CL -1; }", ("CL -1 ", "must be a number from 0.01 to 1: ")),
                             ("{ model none; Sct 1; }", ("Unknown entry Sct",))):
            with self.subTest(entry=entry):
                folder = self.entry(entry)
                self.turbulent(folder, "kEpsilon", "k", "epsilon")
                self.assertRefused(folder, "fvOptions", *words, at_reading=True)

    def test_bounds_themselves(self):
        """Those that messages print are good."""
        for entry in ("{ model Langevin; Sct 0.1; seed 2147483647; }", "{ model Langevin; Sct 10; }",
                      "{ model discreteRandomWalk; CL 0.01; }", "{ model discreteRandomWalk; CL 1; }"):
            folder = self.entry(entry)
            self.turbulent(folder, "kEpsilon", "k", "epsilon")
            self.assertRuns(folder)

    def test_on_two_ranks(self):
        folder = self.entry("{ model Langevin; Sct 11; }")
        self.turbulent(folder, "kEpsilon", "k", "epsilon")
        for rank in range(2):
            shutil.rmtree(folder / f"processor{rank}")
        self.foam("decomposePar", folder)
        self.assertRefused(folder, "Sct 11", ranks=2)

    def test_constants_in_laminar_flow(self):
        """They are checked although there is nothing to do."""
        self.assertRefused(self.entry("{ model Langevin; Sct 11; }"), "Sct 11")

    def test_models_without_k(self):
        folder = self.entry("Langevin")
        self.turbulent(folder, "SpalartAllmaras")
        self.field(folder, "nuTilda", "[0 2 -1 0 0 0 0]", "1e-5")
        self.change(folder, "system/fvSolution", ("(U|k|epsilon|omega)", "(U|nuTilda)"))
        self.assertRefused(folder, "turbulentDispersion Langevin needs k", "SpalartAllmaras has no field k",
                           "constant/turbulenceProperties", "such as kEpsilon, or set turbulentDispersion none")
        self.change(folder, "constant/fvOptions", ("turbulentDispersion Langevin", "turbulentDispersion none"),
                    ("forces (pressureGradient viscous)", "forces { pressureGradient { turbulentPressure yes; } }"),
                    ("drag Gidaspow;", ""))
        self.assertRefused(folder, "pressureGradient with turbulentPressure yes needs k", "SpalartAllmaras has no field k",
                           "such as kEpsilon, or set turbulentPressure no")

    def test_pressure_of_a_laminar_flow(self):
        folder = self.fresh()
        box.fv_options(folder, drag=None, forces="{ pressureGradient { turbulentPressure yes; } }")
        self.assertRefused(folder, "turbulentPressure yes needs k", "the flow is laminar", "or set turbulentPressure no")

    def test_resolved_eddies(self):
        folder = self.entry("Langevin")
        self.turbulent(folder, "kEqn", "k", kind="LES")
        self.assertRefused(folder, "turbulentDispersion Langevin", "kEqn", "simulationType LES", "turbulentDispersion to none")

    def test_other_models(self):
        """Whatever model with a k: that with omega, too."""
        for dispersion in ("Langevin", "discreteRandomWalk"):
            with self.subTest(dispersion=dispersion):
                folder = self.entry(dispersion)
                self.turbulent(folder, "kOmegaSST", "k", "omega")
                self.assertIn(f"Turbulent dispersion: {dispersion}", self.assertRuns(folder).output)


if __name__ == "__main__":
    unittest.main()
