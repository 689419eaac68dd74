# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Entries of jetKEpsilon that are wrong or edited during the run."""

import shutil
import unittest

import grainjet
import homogeneous_box as box
import lid_cavity
from grainjet import dictionaries

REST = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]


class Entries(grainjet.Case):

    def properties(self, ras, beside=""):
        dictionaries.write(
            self.folder/"constant/turbulenceProperties",
            f"simulationType RAS;\n{beside}\nRAS {{ RASModel jetKEpsilon; turbulence on; printCoeffs on; {ras} }}")

    def history(self):
        """Run; what the run writes and the log."""
        shutil.rmtree(self.folder/"postProcessing", ignore_errors=True)
        log = self.foam("pimpleFoam").output
        return box.history(self.folder), log

    def test_wrong_entries(self):
        box.write(self.folder, "jetKEpsilon", REST, 1, 1, 0.1, 1)
        self.foam("blockMesh")
        coefficients = "jetKEpsilonCoeffs {{ {} }}".format
        for words, ras in (
                (("roundJetCorection", "jetKEpsilonCoeffs", "roundJetCorrection"), coefficients("roundJetCorection Pope;")),
                (("Unknown entry c1", "C1 C2"), coefficients("c1 1.44;")),
                (("Unknown entry jetKEpsilonCoefs", "jetKEpsilonCoeffs"), "jetKEpsilonCoefs { C1 1.44; }"),
                (("Unknown entry kEpsilonCoeffs", "jetKEpsilonCoeffs"), "kEpsilonCoeffs { C1 1.44; }"),
                (("Unknown entry kmin", "kMin"), "kmin 1e-9;"),
                (("Unknown entry c1",), "c1 1.44;"),
                (("C1 in RAS is not read",), "C1 1.44; " + coefficients("C2 1.92;")),
                (("must be a dictionary",), "jetKEpsilonCoeffs 3;"),
                *(((f"{key} {value}", "must be a number"), coefficients(f"{key} {value};"))
                  for key in ("Cmu", "C1", "C2", "sigmak", "sigmaEps") for value in ("0", "-1", "nan", "1e+300")),
                (("C2 1 must",), coefficients("C2 1;")),
                (("C3 -1 must",), coefficients("C3 -1;")),
                (("C1 must be a number",), coefficients("C1;")),
                (("kMin 0 must",), "kMin 0;"),
                (("epsilonMin -1 must",), "epsilonMin -1;"),
                (("Unknown roundJetCorrection pope", "Pope"), coefficients("roundJetCorrection pope;"))):
            with self.subTest(ras):
                self.properties(ras)
                self.assertFails(self.foam("pimpleFoam", check=False), *words, "turbulenceProperties")
        self.properties("", "jetKEpsilonCoeffs { C1 1.44; }")
        self.assertFails(self.foam("pimpleFoam", check=False), "jetKEpsilonCoeffs is not read beside RAS")

    def test_coefficients_may_lie_in_RAS(self):
        box.write(self.folder, "jetKEpsilon", REST, 1, 1, 0.1, 1, C2=1.8)
        self.foam("blockMesh")
        expected, _ = self.history()
        self.properties("C2 1.8; kMin 1e-12;")
        self.assertEqual(self.history()[0], expected)
        self.properties("C2 1.9; kMin 1e-12;")
        self.assertNotEqual(self.history()[0], expected)

    def test_edit_during_the_run(self):
        steps = 20
        box.write(self.folder, "jetKEpsilon", REST, 1, 1, 0.1, steps)
        self.foam("blockMesh")
        unedited, _ = self.history()

        dictionaries.change(
            self.folder/"system/controlDict",
            ("runTimeModifiable no;", "runTimeModifiable yes; OptimisationSwitches { fileModificationSkew 0; }"),
            ("functions\n{", """functions
{
    edit
    {
        type timeActivatedFileUpdate; libs (utilityFunctionObjects);
        fileToUpdate "<case>/constant/turbulenceProperties";
        timeVsFile ((-1 "<case>/before") (1 "<case>/after"));
    }
""".replace("<case>", str(self.folder))))
        for ras, warning in (("jetKEpsilonCoeffs { C1 -1; }", "C1 -1 must"),
                             ("jetKEpsilonCoeffs { c1 1; }", "Unknown entry c1"),
                             ("jetKEpsilonCoeffs { C2 1.7; }", None)):
            with self.subTest(ras):
                self.properties(ras)
                (self.folder/"constant/turbulenceProperties").rename(self.folder/"after")
                self.properties("")
                (self.folder/"before").write_text((self.folder/"constant/turbulenceProperties").read_text())
                got, log = self.history()
                self.assertEqual(len(got), steps)
                self.assertEqual(got[:9], unedited[:9])
                if warning:                                     # said once, nothing else happens
                    self.assertEqual(log.count(warning), 1)
                    self.assertIn("goes on with the coefficients that it has", log)
                    self.assertEqual(got, unedited)
                else:
                    self.assertNotEqual(got[-1], unedited[-1])

    def test_wrong_entry_in_a_compressible_solver(self):
        box.write(self.folder, "jetKEpsilon", REST, 1, 1, 0.1, 1, density=1.2)
        self.foam("blockMesh")
        for words, ras in ((("Unknown entry c1", "C1 C2"), "jetKEpsilonCoeffs { c1 1.44; }"),
                           (("C2 1 must",), "jetKEpsilonCoeffs { C2 1; }"),
                           (("Unknown roundJetCorrection pope",), "jetKEpsilonCoeffs { roundJetCorrection pope; }")):
            with self.subTest(ras):
                self.properties(ras)
                self.assertFails(self.foam("rhoPimpleFoam", check=False), *words, "turbulenceProperties")

    def test_wrong_entry_of_a_phase(self):
        lid_cavity.write(self.folder, "compressibleInterFoam")
        dictionaries.write(self.folder/"constant/turbulenceProperties", "simulationType twoPhaseTransport;")
        box.write_turbulence(self.folder, "jetKEpsilon", name="turbulenceProperties.air", C1=-1)
        box.write_turbulence(self.folder, "jetKEpsilon", name="turbulenceProperties.water")
        self.foam("blockMesh")
        self.assertFails(self.foam("compressibleInterFoam", check=False), "C1 -1 must", "turbulenceProperties.air")


if __name__ == "__main__":
    unittest.main()
