# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The fluidised bed, shrunk: the same Allrun with coarse grains in a copy of the folder. What it must leave behind, what must
hold in its results, how it goes on, and how it fails."""

import shutil
import unittest

import grainjet
from grainjet import dictionaries

FLUID_BED = grainjet.ROOT/"cases"/"fluidBed"

# Eight particles in a grain; a deeper column, so that as many grains stand across it
SHRUNK = {"cg": 2, "width": 0.06, "depth": 0.012, "nWidth": 8, "nHeight": 36, "fluidStep": "4e-4", "sampleEvery": 10, "sampleStart": 0.3,
          "endTime": 0.5, "writeInterval": 0.1, "filterLength": "9e-3"}


def shrunk_copy(folder):
    """The case in a folder of its own, with coarse grains."""
    case = folder/"fluidBed"
    shutil.copytree(FLUID_BED, case, ignore=shutil.ignore_patterns(
        "tests", "log.*", "processor*", "postProcessing", "results", "polyMesh", "particles", "0", "0.[0-9]*", "[1-9]*"))
    grainjet.run(["./Allclean"], case)      # what the job itself has left, if it ran here before
    dictionaries.put(case/"system"/"parameters", **SHRUNK)
    return case


class FluidBed(grainjet.Case):

    def test_job_and_its_results(self):
        case = shrunk_copy(self.folder)
        job = grainjet.run(["./Allrun"], case, timeout=800, env={"GRAINJET_PROGRESS": "2"})
        self.assertEqual(job.code, 0, job)
        self.assertIn("All checks hold", job.output)
        self.assertRegex(job.output, r"% done, \d+ s left, grains 2195 ")
        summary = (case/"results/summary.txt").read_text()
        print(summary)
        for words in ("pressure drop/weight", "bubbles per second", "highest grain"):
            self.assertIn(words, summary)
        self.assertTrue((case/"results/bed.png").read_bytes().startswith(b"\x89PNG"))
        rows = (case/"results/bed.csv").read_text().splitlines()
        self.assertEqual(len(rows), 1 + round(SHRUNK["endTime"]/(10*4e-4)))

        # a check that cannot fail is none: spoil the balance and it must
        balance = next((case/"postProcessing/liggghtsCoupling").glob("*/balance.dat"))
        lines = balance.read_text().splitlines()
        values = lines[-1].split("\t")
        values[2] = str(int(float(values[2])) - 1)
        balance.write_text("\n".join([*lines[:-1], "\t".join(values)]) + "\n")
        self.assertFails(grainjet.run(["./bedResults"], case), "FAILED  grains")

    def test_goes_on(self):
        """A job that ended goes on with a later endTime, with its grains."""
        case = shrunk_copy(self.folder)
        dictionaries.put(case/"system/parameters", sampleStart=0, endTime=0.02, writeInterval=0.02, ranks=1)
        self.assertIn("grains: 2195 of 2195", grainjet.run(["./Allrun"], case, timeout=800).output)
        dictionaries.put(case/"system/parameters", endTime=0.04)
        self.foam("pimpleFoam", case)
        self.assertTrue((case/"0.04/uniform/liggghts.restart").exists())
        self.assertIn("grains: 2195 of 2195", grainjet.run(["./bedResults"], case).output)

    def test_bad_numbers_end_the_job_with_a_message(self):
        for entry, words in (({"nParticles": 0}, ("nParticles",)), ({"sampleStart": 1}, ("sampleStart = 1 s must lie before endTime",)),
                             ({"endTime": 0.35}, ("endTime = 0.35 s must be a multiple of writeInterval = 0.1 s", "make endTime 0.4")), ({"ranks": 0.5}, ("ranks must be",)),
                             ({"drag": "Gidaspov"}, ("Gidaspov", "log.pimpleFoam"))):
            with self.subTest(entry=entry):
                folder = self.new_folder()
                folder.mkdir()
                case = shrunk_copy(folder)
                dictionaries.put(case/"system/parameters", **entry)
                job = grainjet.run(["./Allrun"], case, timeout=300)
                self.assertFails(job, *words)
                self.assertFalse((case/"results/summary.txt").exists())


if __name__ == "__main__":
    unittest.main()
