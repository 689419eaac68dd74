# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The sandblast case, shrunk to one run on a coarser mesh with larger grains: what it must leave behind and what must hold in
its results; that it goes on after an end on the way, with the wear of before."""

import shutil
import unittest

import grainjet
from grainjet import dictionaries

SANDBLAST = grainjet.ROOT/"cases"/"sandblast"
RUN = "inclined-jetKEpsilon"

# Cells and time step twice those of the job, so that Courant numbers stay the same; grains twice as large
SHRUNK = {"cg": 2, "fluidStep": 3.2e-5, "couplingInterval": 320, "insertionInterval": 320, "cell": 0.26, "nAir": 5, "nJet": 14,
          "plateCell": 0.25, "endTime": 0.00256, "writeInterval": 0.00128, "spinUpIterations": 60}


class Sandblast(grainjet.Case):

    def allrun(self, case, *runs):
        return grainjet.run(["./Allrun", *runs], case, timeout=800, env={"GRAINJET_PROGRESS": "2"})

    def test_job_its_results_and_the_way_on(self):
        case = self.folder/"sandblast"
        shutil.copytree(SANDBLAST, case, ignore=shutil.ignore_patterns("tests", "runs", "results"))
        dictionaries.put(case/"system"/"parameters", **SHRUNK)
        job = self.allrun(case, RUN)
        self.assertEqual(job.code, 0, job)
        self.assertIn("All checks hold", job.output)
        self.assertTrue((case/"results"/"sandblast.png").read_bytes().startswith(b"\x89PNG"))
        events = case/"runs"/RUN/"postProcessing"/"wear"/"events.csv"
        before = len(events.read_text().splitlines())
        self.assertGreater(before, 50)          # 122,000 grains per second, which need 0.9 ms to the plate

        # an end after the first write: it goes on, and the wear of before is kept once
        (case/"runs"/RUN/"finished").unlink()
        for late in case.glob(f"runs/{RUN}/processor*/0.00256"):
            shutil.rmtree(late)
        again = self.allrun(case, RUN)
        self.assertEqual(again.code, 0, again)
        self.assertIn("goes on from 0.00128 s", again.output)
        self.assertIn("All checks hold", again.output)
        self.assertAlmostEqual(len(events.read_text().splitlines())/before, 1, delta=0.2)   # other grains: random numbers begin anew

        # checks that cannot fail are none: a hit that is missing in the log
        events.write_text("\n".join(events.read_text().splitlines()[:-1]) + "\n")
        judged = grainjet.run([SANDBLAST/"check.py", "runs"], case)
        self.assertFails(judged, "FAILED  30 degrees, jetKEpsilon: wear")

    def test_unknown_run_and_bad_angle(self):
        case = self.folder/"sandblast"
        shutil.copytree(SANDBLAST, case, ignore=shutil.ignore_patterns("tests", "runs", "results"))
        self.assertFails(self.allrun(case, "vertical"), "no run 'vertical'", "normal-jetKEpsilon")
        dictionaries.put(case/"system"/"parameters", angle=5)
        self.assertFails(grainjet.run(["./particleInput"], case), "angle must lie between 20 and 90 degrees, not 5")
        dictionaries.put(case/"system"/"parameters", angle=90, endTime=0.001)
        self.assertFails(grainjet.run(["./particleInput"], case), "endTime = 0.001 s must be a multiple of writeInterval = 0.002 s", "make endTime 0.002")


if __name__ == "__main__":
    unittest.main()
