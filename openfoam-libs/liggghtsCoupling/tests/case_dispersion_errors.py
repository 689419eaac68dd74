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
        for entry, words in (("Langvin", ("Unknown turbulentDispersion Langvin", "discreteRandomWalk", "Langevin")),
                             ("{ Sct 1; }", ("model", "not found")),
                             ("{ model Langevin; Sct 0; }", ("Sct",)),
                             ("{ model Langevin; Sct 0.05; }", ("Sct 0.05", "0.1 to 10")),
                             ("{ model Langevin; Sct 11; }", ("Sct 11", "0.1 to 10")),
                             ("{ model Langevin; seed 0; }", ("seed",)),
                             ("{ model Langevin; seed 1.5; }", ("seed",)),
                             ("{ model Langevin; CL 0.15; }", ("Unknown entry CL",)),
                             ("{ model discreteRandomWalk; Sct 1; }", ("Unknown entry Sct",)),
                             ("{ model discreteRandomWalk; CL 2; }", ("CL 2", "0.01 to 1")),
                             ("{ model none; Sct 1; }", ("Unknown entry Sct",))):
            with self.subTest(entry=entry):
                folder = self.entry(entry)
                self.turbulent(folder, "kEpsilon", "k", "epsilon")
                self.assertRefused(folder, "fvOptions", *words)

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
        self.assertRefused(folder, "The model Langevin needs turbulentSpeed", "SpalartAllmaras has no field k")
        self.change(folder, "constant/fvOptions", ("turbulentDispersion Langevin", "turbulentDispersion none"),
                    ("forces (pressureGradient viscous)", "forces { pressureGradient { turbulentPressure yes; } }"),
                    ("drag Gidaspow;", ""))
        self.assertRefused(folder, "The model pressureGradient needs gradK", "SpalartAllmaras has no field k")

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
