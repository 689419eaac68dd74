# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The elbow case, shrunk: the same Allrun on a coarser mesh and for a shorter time, in a copy of the folder."""

import shutil
import unittest

import grainjet
from grainjet import dictionaries

ELBOW = grainjet.ROOT/"cases"/"elbow"

SHRUNK = {"nSide": 4, "nRing": 3, "nInlet": 12, "nBend": 18, "nOutlet": 9, "fluidStep": 2.5e-5, "couplingInterval": 250,
          "insertionInterval": 250, "endTime": 0.004, "writeInterval": 0.002, "spinUpIterations": 100}


class Elbow(grainjet.Case):

    def test_job_and_its_results(self):
        case = self.folder/"elbow"
        shutil.copytree(ELBOW, case, ignore=shutil.ignore_patterns(
            "tests", "log.*", "processor*", "postProcessing", "results", "polyMesh", "particles", "begun", "0", "0.[0-9]*", "[1-9]*"))
        grainjet.run(["./Allclean"], case)
        dictionaries.put(case/"system"/"parameters", **SHRUNK)
        job = grainjet.run(["./Allrun"], case, timeout=800, env={"GRAINJET_PROGRESS": "2"})
        self.assertEqual(job.code, 0, job)
        self.assertIn("All checks hold", job.output)
        self.assertTrue((case/"results"/"elbow.png").read_bytes().startswith(b"\x89PNG"))
        events = case/"postProcessing"/"wear"/"events.csv"
        # a million grains per second, nearly all of which hit, from 1.2 ms on
        self.assertGreater(len(events.read_text().splitlines()), 1500)

        events.write_text("\n".join(events.read_text().splitlines()[:-1]) + "\n")
        self.assertFails(grainjet.run([ELBOW/"check.py", case], case), "FAILED", "logged hits")

    def test_bad_parameters(self):
        case = self.folder/"elbow"
        case.mkdir()
        shutil.copytree(ELBOW/"system", case/"system")
        shutil.copy(ELBOW/"particleInput", case)
        for name, value, words in (("nBend", 20, "multiple of 6, not 20"), ("bendRadius", 0.4, "larger than 0.5"),
                                   ("insertionLength", 9, "between 0 and inletLength"), ("endTime", 0.003, "endTime = 0.003 s must be a multiple"),
                                   ("ranks", 0, "ranks must be a whole number")):
            shutil.copy(ELBOW/"system"/"parameters", case/"system")
            dictionaries.put(case/"system"/"parameters", **{name: value})
            self.assertFails(grainjet.run(["./particleInput"], case), words)


if __name__ == "__main__":
    unittest.main()
