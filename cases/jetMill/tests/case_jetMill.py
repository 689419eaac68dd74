# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The jet mill, shrunk: the same Allrun with coarse grains and few cells in a copy of the folder. What it must leave behind, what
must hold in its results, how it goes on, and how it fails."""

import shutil
import unittest

import grainjet
from grainjet import dictionaries, tables

JET_MILL = grainjet.ROOT/"cases"/"jetMill"

# A smaller chamber, so that grains meet soon; 27 particles in a grain
SHRUNK = {"D": 0.03, "height": 0.03, "nozzleHeight": 0.012, "cg": 3, "nParticles": 27000, "nNozzle": 2, "nMiddle": 10, "nRing": 5, "nAcross": 5, "grading": 3,
          "nBelow": 4, "nAbove": 4, "fluidStep": "3e-6", "couplingInterval": 15, "feedLow": 0.002, "feedHigh": 0.022, "feedStart": "1e-4", "feedInterval": "6e-5", "nFeed": 5,
          "sampleStart": 0.0006, "endTime": 0.0018, "writeInterval": 0.0009}


def shrunk_copy(folder):
    """The case in a folder of its own, shrunk."""
    case = folder/"jetMill"
    shutil.copytree(JET_MILL, case, ignore=shutil.ignore_patterns(
        "tests", "log.*", "processor*", "postProcessing", "results", "polyMesh", "particles", "blockMeshDict", "0", "0.[0-9]*", "[1-9]*"))
    dictionaries.put(case/"system"/"parameters", **SHRUNK)
    return case


class JetMill(grainjet.Case):

    def allrun(self, case, timeout=800):
        return grainjet.run(["./Allrun"], case, timeout=timeout, env={"GRAINJET_PROGRESS": "2"})

    def test_job_and_its_results(self):
        case = shrunk_copy(self.folder)
        job = self.allrun(case)
        self.assertEqual(job.code, 0, job)
        self.assertIn("All checks hold", job.output)
        summary = (case/"results/summary.txt").read_text()
        for words in ("whole mill", "where the jets meet", "collisions of grains dissipate"):
            self.assertIn(words, summary)
        self.assertTrue((case/"results/mill.png").read_bytes().startswith(b"\x89PNG"))
        self.assertTrue((case/"results/spectra.csv").read_text().startswith("place,from J,to J,collisions\nmill,"))

        # checks that cannot fail are none: a collision that is missing in the spectrum
        spectra = case/"postProcessing/collisions/mill_spectra.csv"
        lines = spectra.read_text().splitlines()
        first = next(i for i, line in enumerate(lines) if line.startswith("all,") and ",normal_energy," in line and float(line.split(",")[5]) > 0)
        lines[first] = ",".join("0" if k == 5 else word for k, word in enumerate(lines[first].split(",")))
        spectra.write_text("\n".join(lines) + "\n")
        self.assertFails(grainjet.run(["./millResults"], case), "FAILED  the spectrum holds")

    def test_goes_on(self):
        """A job that was interrupted while it fed goes on with the rest of the feed, and with its collisions."""
        case = shrunk_copy(self.folder)
        dictionaries.put(case/"system/parameters", feedInterval="2e-4", nFeed=6, sampleStart="3e-4", endTime="6e-4", writeInterval="6e-4")
        self.allrun(case)
        before = tables.history(case/"postProcessing/liggghtsCoupling", "balance")
        self.assertLess(before["present"][-1], 1000)
        dictionaries.put(case/"system/parameters", endTime=0.0018)
        self.foam("rhoPimpleFoam", case, 2)
        self.foam("reconstructPar", case)
        self.assertIn("grains: 1000 of 1000", grainjet.run(["./millResults"], case).output)
        after = tables.history(case/"postProcessing/liggghtsCoupling", "balance")
        self.assertEqual(abs(after["unaccounted"]).max(), 0)
        self.assertAlmostEqual(float((case/"postProcessing/collisions/mill.csv").read_text().splitlines()[1].split(",")[4]), 0.0015, delta=1e-6)

    def test_bad_numbers_end_the_job_with_a_message(self):
        for entry, words in (({"nParticles": 0}, ("nParticles",)), ({"sampleStart": 1}, ("sampleStart = 1 s must lie before endTime",)),
                             ({"endTime": 0.001}, ("endTime = 0.001 s must be a multiple of writeInterval = 0.0009 s", "make endTime 0.0018")), ({"ranks": 0.5}, ("ranks must be",)),
                             ({"stagnationPressure": "1.5e5"}, ("stagnationPressure must be 208222 Pa", "clearly supersonic")),
                             ({"nozzleHeight": 0.2}, ("nozzleHeight", "wall of the chamber"))):
            with self.subTest(entry=entry):
                folder = self.new_folder()
                folder.mkdir()
                case = shrunk_copy(folder)
                dictionaries.put(case/"system/parameters", **entry)
                self.assertFails(self.allrun(case, 300), *words)
                self.assertFalse((case/"results/summary.txt").exists())


if __name__ == "__main__":
    unittest.main()
