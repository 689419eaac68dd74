# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each entry of the coupling's dictionary spoilt in every way: one error that names the entry and
constant/fvOptions, exit code 1, before the first momentum equation is solved. New entries of the page are covered by themselves."""
# processors: 2
# label: long

import re
import unittest

import bad_case
import grainjet
from grainjet import dictionaries, releases
from grainjet.bad_input import Entry, spoil, values
from grainjet.pages import table_of_page

PAGE = grainjet.ROOT / "docs/liggghtsCoupling.md"

ENTRIES = {
    "script": Entry("file", '"constant/in.particles"', required=True),
    "couplingInterval": Entry("count", "10", required=True),
    "subSteps": Entry("count", "1"),
    "coupling": Entry("choice", "twoWay"),
    "voidFraction": Entry("dictionary", "{ model divided; minimum 0.3; }"),
    "drag": Entry("choice", "Gidaspow"),
    "forces": Entry("words", "(pressureGradient viscous)"),
    "interpolation": Entry("choice", "cellPoint"),
    "wallLaw": Entry("switch", "no"),
    "formulation": Entry("choice", "SetI"),
    "selfDisturbance": Entry("switch", "yes"),
    "momentum": Entry("choice", "implicit"),
    "turbulentDispersion": Entry("choice", "none"),
    "turbulenceSources": Entry("choice", "none"),
    "decompositionWeights": Entry("dictionary", "{ grainCost 1; }"),
    "fluid": Entry("choice", "incompressible"),
    "U": Entry("name", "U"),
    "p": Entry("name", "p"),
    "log": Entry("output", "log.liggghts"),
    "active": Entry("switch", "yes"),
}

LANGEVIN = {
    "model": Entry("choice", "Langevin", required=True),
    "Sct": Entry("positive", "0.7"),
    "seed": Entry("seed", "1"),
}

# what one entry alone does not tell
LATE = ("file", "output", "name", "a thousand million")

VOID_FRACTION = {
    "model": Entry("choice", "divided"),
    "minimum": Entry("fraction", "0.3"),
    "equations": Entry("choice", "neglected"),
    "filter": Entry("dictionary", "{ length 0; }"),
}

WEIGHTS = {
    "grainCost": Entry("positive", "1", required=True),
}

CHEN_WOOD = {
    "B": Entry("nonNegative", "0.0825"),
    "Ce": Entry("positive", "0.165"),
    "C3": Entry("nonNegative", "1.2"),
}

KINDS = {
    "seed": [way for way in values("count") if way[0] != "a thousand million"],
    "dictionary": [("a word", "divided"), ("a number", "0.3"), ("a list", "(a b)")],
    "words": [("another word", "(magic)"), ("a word for a list", "viscous"), ("a number", "3"),
              ("a word twice", "(viscous viscous)"), ("a list in a list", "((viscous))")],
}


def text(lines):
    return "".join(f"    {key} {value}{'' if value.startswith('{') else ';'}\n" for key, value in lines)


def of_dictionary(*within):
    """Regular expression of where an error says that an entry stands."""
    names = (name for name in ("fvOptions", "particles", *within) if name)
    return r"file: \S*constant/" + re.escape(releases.nested(*names))


class Entries(bad_case.BadCase):

    def options(self, folder, body, name="particles"):
        dictionaries.write(folder / "constant/fvOptions",
                           f"{name}\n{{\n    type liggghtsCoupling;\n{body}}}\n")

    def spoilt(self, entries, within=None, ranks=0, only=None, folder=None, **others):
        """Run all spoilt forms of a table (or those in `only`), which may lie in a sub-dictionary; others: good
        values of other entries."""
        folder = folder or self.fresh()
        for bad in spoil(entries, KINDS):
            if only and bad.what not in only:
                continue
            lines = bad.replace(entries)
            if within:
                outer = [(k, others.get(k, e.good)) for k, e in ENTRIES.items() if k != within]
                lines = [*outer, (within, "{ " + text(lines).replace("\n", " ") + "}")]
            self.options(folder, text(lines))
            with self.subTest(entry=bad.entry, what=bad.what, ranks=ranks):
                # the entry as it is misspelt; but a model misses one that it requires first
                key = bad.entry if within and entries[bad.entry].required or not bad.lines else bad.lines[0][0]
                if bad.must_fail:
                    self.assertRefused(folder, "constant/fvOptions", key, ranks=ranks,
                                       at_reading=bool(within) or not (entries[bad.entry].kind in LATE or bad.what in LATE))
                else:
                    self.assertRuns(folder, ranks=ranks)

    def test_every_entry_of_the_page_is_covered(self):
        """And the other way round: the page has all that the test knows. Rows of sub-dictionaries have a bracket."""
        names = table_of_page(PAGE.read_text(), "Entries")
        self.assertEqual(sorted(name for name in names if "{" not in name), sorted(ENTRIES))

    def test_every_entry_of_the_library_is_covered(self):
        """The words that it offers after a misspelt one are those of the tables here."""
        folder = self.fresh()
        self.turbulent(folder, "kEpsilon", "k", "epsilon")
        outer = text((k, "ChenWood" if k == "turbulenceSources" else e.good)
                     for k, e in ENTRIES.items() if k != "voidFraction")
        for body, known in (
                (outer + "    dragg Stokes;\n", {*ENTRIES, "type", "libs", "ChenWoodCoeffs"}),
                (outer + "    voidFraction { model divided; minimun 0.3; }\n", {*VOID_FRACTION}),
                (outer + "    ChenWoodCoeffs { Bb 1; }\n", {*CHEN_WOOD})):
            self.options(folder, body)
            result = self.assertRefused(folder, "Unknown entry")
            offered = result.output.split("Valid: ")[1].split("(")[1].split(")")[0].split()
            self.assertEqual(set(offered), known)

    def test_good_values(self):
        folder = self.fresh()
        for ranks in (0, 2):
            self.options(folder, text((k, e.good) for k, e in ENTRIES.items()))
            self.assertRuns(folder, ranks=ranks)

    def test_every_entry(self):
        self.spoilt(ENTRIES)

    def test_every_entry_on_2_ranks(self):
        self.spoilt(ENTRIES, ranks=2, only=("a word", "another word", "in a missing folder"))

    def test_missing_ones_are_told_once(self):
        for key in ("script", "couplingInterval"):
            folder = self.fresh()
            self.options(folder, text((k, e.good) for k, e in ENTRIES.items() if k != key))
            result = self.assertRefused(folder, f"Entry {key} is missing", "constant/fvOptions", ranks=2)
            self.assertEqual(result.output.count("FOAM FATAL"), 1, result)

    def test_entries_of_the_void_fraction(self):
        self.spoilt(VOID_FRACTION, "voidFraction")

    def test_entries_of_the_weights(self):
        self.spoilt(WEIGHTS, "decompositionWeights")

    def test_entries_of_a_dispersion(self):
        folder = self.fresh()
        self.turbulent(folder, "kEpsilon", "k", "epsilon")
        self.spoilt(LANGEVIN, "turbulentDispersion", folder=folder)

    # what messages say

    def test_line(self):
        """A wrong value: the line of its entry; none if it stands in an included file."""
        good = [(k, e.good) for k, e in ENTRIES.items() if k not in ("drag", "forces")]
        for key, bad, within in (("wallLaw", "maybe", ""), ("coupling", "threeWay", ""), ("couplingInterval", "2.5", ""),
                                 ("interpoltion", "cell", ""), ("Sct", "20", "turbulentDispersion"),
                                 ("sphericity", "2", "forces.drag"), ("C", "-1", "forces.addedMass")):
            folder = self.fresh()
            entries = [pair for pair in good if pair[0] not in (key, within)]
            body = [("forces", "{\n drag\n {\n model Ganser;\n sphericity 0.8;\n }\n addedMass { C 0.5; }\n}"), *entries]
            if within.startswith("forces"):
                body[0] = ("forces", body[0][1].replace("sphericity 0.8" if key == "sphericity" else "C 0.5", f"{key} {bad}"))
            elif within:
                body.append((within, f"{{ model Langevin;\n{key} {bad}; }}"))
            else:
                body.append((key, bad))
            self.options(folder, text(body))
            lines = (folder / "constant/fvOptions").read_text().split("\n")
            number = next(i for i, line in enumerate(lines, 1) if f"{key} {bad};" in line)
            result = self.assertRefused(folder, key, at_reading=True)
            self.assertRegex(result.output, of_dictionary(*within.split(".")) + f" at line {number}\\.")

        (folder / "constant/defaults").write_text("\n" * 12 + "wallLaw maybe;\n")
        self.options(folder, '    #include "defaults"\n' + text([pair for pair in good if pair[0] != "wallLaw"]))
        self.assertRegex(self.assertRefused(folder, "wallLaw maybe").output, of_dictionary() + r"\n")

    def test_words_of_their_own(self):
        """Allowed values and how to write it, in no words of OpenFOAM's parser."""
        folder = self.fresh()
        for key, bad, words in (
                ("wallLaw", "", ("wallLaw has no value in particles. It must be yes or no", "Write, for instance, wallLaw yes;")),
                ("wallLaw", "maybe", ("wallLaw maybe in particles must be yes or no",)),
                ("couplingInterval", "2.5", ("couplingInterval 2.5 ", "whole number from 1 to 2147483647", "DEM steps per fluid step")),
                ("drag", "1", ("drag 1 ", "must be one word. Valid: (", "Gidaspow")),
                ("forces", "viscous", ("forces viscous ", "must be a list of words in parentheses, or a dictionary",
                                       "forces (pressureGradient viscous);")),
                ("voidFraction", "divided", ("voidFraction divided ", "must be a dictionary", "voidFraction { model divided; }\n")),
                ("voidFraction", "{ model dividd; }", ("model dividd", "Valid: (centre divided)")),
                ("voidFraction", "{ model divided; minimum 1; }", ("minimum 1 ", "above 0 and below 1", "minimum 0.3;")),
                ("fluid", "{}", ("Entry model is missing in fluid", "Valid: (Boussinesq VOF buoyantCompressible compressible incompressible)")),
                ("script", "{ a 1; }", ("script { ... } ", "must be a file name", 'script "constant/in.particles";')),
                ("U", "1", ("U 1 ", "must be one word: the name of the velocity"))):
            with self.subTest(key=key, bad=bad):
                self.options(folder, text((k, bad if k == key else e.good) for k, e in ENTRIES.items()))
                result = self.assertRefused(folder, *words, at_reading=True)
                for word in ("token", "Bad", "Expected"):
                    self.assertNotIn(word, result.output)

    def test_unknown_word_comes_first(self):
        """A misspelt interpolation is that, not a clash with wallLaw; a known one clashes."""
        folder = self.fresh()
        good = dict((k, e.good) for k, e in ENTRIES.items())
        self.options(folder, text({**good, "interpolation": "cellPont", "wallLaw": "yes"}.items()))
        result = self.assertRefused(folder, "Unknown interpolation cellPont", "Valid: (", "cellPointWallModified", at_reading=True)
        self.assertNotIn("law of the wall", result.output)
        self.options(folder, text({**good, "interpolation": "cell", "wallLaw": "yes"}.items()))
        self.assertRefused(folder, "wallLaw yes with interpolation cell")

    def test_coefficients_of_chen_and_wood(self):
        folder = self.fresh()
        self.turbulent(folder, "kEpsilon", "k", "epsilon")
        self.spoilt(CHEN_WOOD, "ChenWoodCoeffs", folder=folder, turbulenceSources="ChenWood")

    def test_entries_within_coeffs_of_the_type(self):
        """OpenFOAM lets the entries lie one level deeper."""
        folder = self.fresh()
        body = "liggghtsCouplingCoeffs\n{\n" + text((k, e.good) for k, e in ENTRIES.items() if k != "active")
        self.options(folder, body + "}\n")
        self.assertRuns(folder)
        self.options(folder, body + "    drag WenYu;\n}\n")
        self.assertRefused(folder, "constant/fvOptions", "drag", "twice", "line")
        self.options(folder, body + "    dragg WenYu;\n}\n")
        self.assertRefused(folder, "constant/fvOptions", "Unknown entry dragg")

    def test_included_defaults_may_be_replaced(self):
        """An #include and an entry after it that replaces one of its values is not a repetition."""
        folder = self.fresh()
        good = [(k, e.good) for k, e in ENTRIES.items()]
        (folder / "constant/defaults").write_text(text(good))
        self.options(folder, '    #include "defaults"\n    drag WenYu;\n')
        self.assertRuns(folder)

    # two of them

    def test_two_couplings(self):
        good = text((k, e.good) for k, e in ENTRIES.items())
        for second in (good, good.replace("active yes", "active no")):
            for ranks in (0, 2):
                folder = self.fresh()
                self.options(folder, good)
                with (folder / "constant/fvOptions").open("a") as file:
                    file.write("second\n{\n    type liggghtsCoupling;\n" + second + "}\n")
                self.assertRefused(folder, "constant/fvOptions", "particles and second", ranks=ranks)

    def test_two_of_the_same_name(self):
        folder = self.fresh()
        good = text((k, e.good) for k, e in ENTRIES.items())
        self.options(folder, good)
        with (folder / "constant/fvOptions").open("a") as file:
            file.write("particles\n{\n    type liggghtsCoupling;\n" + good + "}\n")
        self.assertRefused(folder, "constant/fvOptions", "particles", "twice")

    def test_other_options_are_left_alone(self):
        """An option of another type that repeats an entry is OpenFOAM's business."""
        folder = self.fresh()
        self.options(folder, text((k, e.good) for k, e in ENTRIES.items()))
        with (folder / "constant/fvOptions").open("a") as file:
            file.write("""other { type vectorSemiImplicitSource; active no; selectionMode all; active no;
                volumeMode specific; injectionRateSuSp { U ((0 0 0) 0); } }\n""")
        self.assertRuns(folder)

    # switched off

    def test_switched_off_starts_nothing(self):
        """Without script or log, and in a case that could not be coupled."""
        folder = self.fresh()
        good = dict((k, e.good) for k, e in ENTRIES.items())
        self.options(folder, text({**good, "active": "no", "drag": "ofALibraryThatIsNotThere", "forces": "(likewise)"}.items()))
        (folder / "constant/in.particles").unlink()
        self.change(folder, "constant/transportProperties", ("rho [1 -3 0 0 0 0 0] 1.2;", ""))
        result = self.assertRuns(folder)
        self.assertIn("active no", result.output)
        self.assertFalse((folder / "log.liggghts").exists())
        self.assertFalse((folder / "postProcessing").exists())

    # two files

    def test_both_places_of_options(self):
        """OpenFOAM reads constant/fvOptions only; the user is told once."""
        folder = self.fresh()
        system = folder / "system/fvOptions"
        system.write_text((folder / "constant/fvOptions").read_text())
        for ranks in (0, 2):
            result = self.assertRuns(folder, ranks=ranks)
            self.assertEqual(result.output.count("system/fvOptions\" is never read"), 1, result)
        (folder / "constant/fvOptions").unlink()
        self.assertNotIn("never read", self.assertRuns(folder).output)


if __name__ == "__main__":
    unittest.main()
