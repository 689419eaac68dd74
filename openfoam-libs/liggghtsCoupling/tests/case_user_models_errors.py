# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mistakes in a user's model and in its dictionary: one error that names the model, the file and the
entry, before LIGGGHTS begins. One of each kind on 2 ranks, too."""
# processors: 2

import re
import unittest

import bad_case
from grainjet import coupled_box as box, releases
import user_library

FILE = "constant/fvOptions"


def of_force(name):
    """Where an error says that a force's entry stands."""
    return releases.nested(FILE, "particles", "forces", name)


class UserModelsErrors(bad_case.BadCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        path = cls.base / "system/controlDict"
        path.write_text(path.read_text().replace(
            '("libliggghtsCoupling.so")', user_library.libs("userModels", "probeModels")))

    def case(self, forces, **entries):
        folder = self.fresh()
        box.fv_options(folder, **{"drag": None, "forces": forces, **entries})
        return folder

    def assertOneError(self, forces, *words, lines=None, parallel=False, **entries):
        """Refused before LIGGGHTS begins, by one message, also on 2 ranks if asked for. lines: an expression
        that the message matches."""
        for ranks in (0, 2) if parallel else (0,):
            with self.subTest(forces=forces, ranks=ranks, **entries):
                folder = self.case(forces, **entries)
                result = self.assertRefused(folder, *words, ranks=ranks, steps=True)
                self.assertEqual(result.output.count("FOAM FATAL"), 1, result)
                self.assertEqual((folder / "log.liggghts").exists(), False, result)
                if lines:
                    self.assertRegex(result.output, lines)

    # ---- entries

    def test_misspelt_entry(self):
        """Told by the model, with its own entries."""
        options = f"file: .*{re.escape(of_force('shearLift'))} at line [0-9]+"
        self.assertOneError("{ shearLift { c 1.615; } }", "Unknown entry c", "Valid:", "(C)", lines=options, parallel=True)
        self.assertOneError("{ drag { model scaledStokes; factro 2; } }", "Unknown entry factro", "factor",
                            "model", FILE)
        self.assertOneError("{ viscousTorque { C 1; } }", "Unknown entry C", "It takes none\n", FILE)

    def test_bad_value(self):
        self.assertOneError("{ shearLift { C -1; } }", "C -1", "positive", FILE)
        self.assertOneError("{ memoryForce { time nan; } }", "nan", of_force("memoryForce") + " at line")
        self.assertOneError("{ relaxation { time 1; reaction perhaps; } }", "perhaps", FILE)
        self.assertOneError("{ shearLift { C word; } }", "C word ", of_force("shearLift") + " at line")

    def test_stated_entries(self):
        """Those that a model states at file scope are refused when the option is read, others when the model is made."""
        for forces, word, early in (("{ thermophoresis { K 11; } }", "K 11 in thermophoresis must be a number from 0 to 10: the", True),
                                    ("{ thermophoresis {} }", "Entry K is missing", True),
                                    ("(thermophoresis)", "thermophoresis { K 0.5; } }", True),
                                    ("{ thermophoresis { k 1; } }", "Unknown entry k", True),
                                    ("{ shearLift { C -1; } }", "C -1", False)):
            result = self.assertRefused(self.case(forces), word, FILE)
            self.assertEqual("\nTime = " in result.output, not early, result)

    def test_missing_entry(self):
        self.assertOneError("{ shearLift {} }", "Entry C is missing", of_force("shearLift"),
                            parallel=True)
        self.assertOneError("{ drag { model scaledStokes; } }", "Entry factor is missing", FILE)

    def test_no_coefficients_in_the_short_form(self):
        """The short form has no room for them: the model says what it lacks, and how to write it."""
        self.assertOneError("(shearLift)", "Entry C is missing", FILE, "no room for it",
                            "forces { drag { model ...; } shearLift { C ...; } }\n", parallel=True)
        self.assertOneError(None, "Entry factor is missing", FILE, "no room for it",
                            "forces { drag { model scaledStokes; factor ...; } }\n", drag="scaledStokes")

    def test_long_form_is_not_taken_for_the_short_one(self):
        for forces in ("{ shearLift {} }", "{ drag { model scaledStokes; } }"):
            folder = self.case(forces)
            self.assertNotIn("short form", self.assertRefused(folder, "is missing", steps=True).output)

    def test_unknown_model(self):
        self.assertOneError("{ shearlift { C 1.6; } }", "shearlift", "shearLift", "pressureGradient", FILE,
                            parallel=True)
        self.assertOneError("{ drag { model scaledstokes; } }", "scaledstokes", "scaledStokes", "Gidaspow", FILE,
                            parallel=True)

    def test_library_not_loaded(self):
        """Without libs the model is unknown; the message says where models come from."""
        folder = self.case("{ shearLift { C 1.6; } }")
        self.change(folder, "system/controlDict", (str(user_library.build("userModels")), "libliggghtsCoupling.so"))
        self.assertRefused(folder, "shearLift", "libs", FILE, steps=True)

    def test_library_in_the_options(self):
        library = user_library.build("userModels")
        folder = self.case("{ shearLift { C 1.6; } }", libs=f'("{library}")')
        self.change(folder, "system/controlDict", (str(library), "libliggghtsCoupling.so"))
        self.assertRuns(folder)

    # ---- what a model asks for

    def test_unknown_quantity(self):
        self.assertOneError("{ probe { quantities (vorticity); } }", "probe", "vorticity", "not known", "curlU",
                            "gradT", FILE, parallel=True)

    def test_quantity_that_the_case_lacks(self):
        self.assertOneError("{ probe { quantities (k); } }", "The model probe needs k", "laminar", FILE,
                            parallel=True)
        self.assertOneError("{ probe { quantities (U epsilon); } }", "needs epsilon", "laminar", FILE)
        self.assertOneError("{ probe { quantities (wallDistance); } }", "The model probe needs wallDistance",
                            "system/fvSchemes has no wallDist { method meshWave; }", FILE, parallel=True)
        self.assertOneError("{ thermophoresis { K 1; } }", "thermophoresis needs T", "no field T", FILE)
        self.assertOneError("{ probe { quantities (gradT); } }", "probe needs gradT", "no field T", FILE)

    def test_all_quantities(self):
        """All that a laminar case has, at once, each sampled without a floating-point exception."""
        forces = ("{ probe { quantities (U voidFraction rho nu gradP divTau curlU DUDt wallDistance); "
                  "states (a b); numbers 3; } }")
        for interpolation, ranks in (("cell", 0), ("cellPoint", 2), ("cellPointWallModified", 2)):
            folder = self.case(forces, interpolation=interpolation)
            self.change(folder, "system/fvSchemes", ("ddtSchemes", "wallDist { method meshWave; } ddtSchemes"))
            self.assertRuns(folder, ranks=ranks)

    def test_state_of_the_same_name(self):
        """Of one model: refused. The same name in two models means two states."""
        self.assertOneError("{ probe { states (a a); } }", "The model probe", "state a twice", FILE, parallel=True)
        self.assertRuns(self.case("{ memoryForce { time 1e-3; } probe { states (slip); numbers 3; } }"))

    def test_bad_state(self):
        self.assertOneError("{ probe { states (a_b); } }", "state a_b", "letters and digits", FILE)
        self.assertOneError("{ probe { states (a); numbers 0; } }", "without numbers", FILE)
        self.assertOneError("{ probe { states (a); infinite yes; } }", "state a", "not finite", FILE)
        self.assertOneError("{ probe::odd { states (a); } }", "The model probe::odd", "TypeName", FILE, parallel=True)

    def test_not_asked_for(self):
        """What a model adds without asking for it would get lost: an error when it comes."""
        for unasked, words in (("torque", "adds torque"), ("nonReacting", "adds forces without reaction")):
            for ranks in (0, 2):
                folder = self.case(f"{{ drag {{}} probe {{ unasked {unasked}; }} }}")
                self.assertRefused(folder, "(drag probe)", words, f"forceNeeds::{unasked}()", ranks=ranks, steps=True)
        # the spin of grains that nobody has asked for is no number, and so is a force from it
        self.assertRefused(self.case("{ drag {} probe { unasked spin; } }"), "LIGGGHTS stopped", "force", steps=True)

    def test_negative_coefficient(self):
        """Such drag would speed grains up, without an end: an error in the first step."""
        for negative in ("Sp", "nonReactingSp", "spinCoefficient"):
            for ranks in (0, 2):
                folder = self.case(f"{{ drag {{}} probe {{ negative {negative}; }} }}")
                self.assertRefused(folder, "(drag probe)", f"a negative {negative}", ranks=ranks, steps=True)

    # ---- the fluid

    def test_fluid(self):
        """A word, or a dictionary with the entries of the user's fluid."""
        for good in ("incompressible", "{ model incompressible; }", "{ model givenViscosity; nu 1e-5; }"):
            self.assertRuns(self.case("()", fluid=good))
        for bad, words in (
                ("givenViscosity", ("Entry nu is missing", "    fluid { model givenViscosity; nu ...; }\n")),
                ("{ model givenViscosity; }", ("Entry nu is missing",)),
                ("{ model givenViscosity; nuu 1; }", ("Unknown entry nuu", "model nu")),
                ("{ model givenViscosity; nu -1; }", ("nu", "positive")),
                ("{ model incompressible; nu 1; }", ("Unknown entry nu",)),
                ("{ nu 1; }", ("Entry model is missing", "Valid: (Boussinesq VOF buoyantCompressible compressible givenViscosity incompressible)")),
                ("water", ("water", "givenViscosity", "incompressible")),
                ("3", ("fluid",)),
                ("(a b)", ("fluid",))):
            self.assertOneError("()", *words, FILE, fluid=bad, parallel=bad in ("givenViscosity", "water", "3"))


if __name__ == "__main__":
    unittest.main()
