# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tiny runs from the table to the results: killed on the way and continued, compared with a kept
table, never made twice; a plate; the report of them."""
# label: long

import csv
import json
import math
import re
import shutil

import unittest

import grainjet
from grainjet import dictionaries

CASES = grainjet.ROOT/"cases"
KEPT = json.loads((CASES/"tests"/"Hardalupas1-tiny.json").read_text())


class Allrun(grainjet.Case):

    def setUp(self):
        super().setUp()
        self.runs = self.folder/"runs"
        self.env = {"GRAINJET_RUNS": str(self.runs)}

    def allrun(self, *words):
        return grainjet.run([CASES/"Allrun", *words], self.folder, timeout=300, env=self.env)

    LAST = "uniform/functionObjects/functionObjectProperties"       # written after all else of a time

    def killed_in_the_coupled_run(self, folder):
        """Start, wait for the first time that is kept, kill everything."""
        with grainjet.start([CASES/"Allrun", "Hardalupas1", "tiny"], self.folder, self.folder/"log", self.env) as job:
            job.wait_for(lambda: any(path.stat().st_size for path in folder.glob(f"0.*/{self.LAST}")), "a time")
            self.assertIsNone(job.process.poll(), "ended before it could be killed")

    def test_killed_continued_and_compared(self):
        folder = self.runs/"Hardalupas1-tiny"
        self.killed_in_the_coupled_run(folder)
        self.assertFalse((folder/"results").exists())

        # what a kill in the middle of writing leaves: a time without its grains, one without some fields
        kept = next(folder.glob(f"0.*/{self.LAST}")).parents[2]
        (folder/"0.05").mkdir()
        shutil.copytree(kept, folder/"0.06")
        (folder/"0.06"/self.LAST).unlink()
        (folder/"0.06"/"epsilon").unlink()
        continued = self.allrun("Hardalupas1", "tiny")
        self.assertEqual(continued.code, 0, continued)
        self.assertIn("unfinished", continued.output)
        self.assertRegex(continued.output, r"goes on from 0\.0\d+ s")
        self.assertNotIn("Mesh quality", continued.output)      # finished stages are not made again
        self.assertFalse((folder/"0.05").exists())
        self.assertFalse((folder/"0.06").exists())
        self.assertIn("12 of 12 checks hold", continued.output)

        self.compare(json.loads((folder/"results"/"summary.json").read_text()))
        self.assertTrue((folder/"results"/"profiles.csv").stat().st_size > 1000)

        # finished results stay as they are: even what was added to them
        summary = folder/"results"/"summary.json"
        summary.write_text(summary.read_text() + "\n\n")
        kept = summary.read_text()
        again = self.allrun("Hardalupas1", "tiny")
        self.assertEqual(again.code, 0, again)
        self.assertIn("finished", again.output)
        self.assertEqual(summary.read_text(), kept)
        self.assertRegex(self.allrun("--list", "Hardalupas1", "Lau1", "tiny").output,
                         r"Hardalupas1 tiny +finished\nLau1 tiny +not begun")

    def compare(self, found):
        """With the kept table. The mesh is the same; the steady flow stops within its residuals, 1 %;
        the grains differ in the last digit, and after some steps in their paths: 4 standard errors of the
        difference of two runs, a count of n being known to sqrt(n)."""
        for name in ("cells", "nonOrthogonalityMax", "skewnessMax"):
            self.assertAlmostEqual(found["mesh"][name], KEPT["mesh"][name], delta=1e-3*KEPT["mesh"][name])
        self.assertAlmostEqual(found["mesh"]["yPlusAverage"]/KEPT["mesh"]["yPlusAverage"], 1, delta=0.01)
        self.assertAlmostEqual(found["fluidAxisSpeed"]/KEPT["fluidAxisSpeed"], 1, delta=0.01)
        # the inlet profile, Eq. (23) with n + 1, has the stated mean: 13 m/s within 1 % on these faces
        self.assertAlmostEqual(found["fluidBulkSpeed"]/13, 1, delta=0.01)
        self.assertEqual(len(found["planes"]), len(KEPT["planes"]))
        for ours, kept in zip(found["planes"], KEPT["planes"]):
            self.assertEqual(ours["position"], kept["position"])
            self.assertAlmostEqual(ours["crossings"], kept["crossings"],
                                   delta=4*math.sqrt(2*kept["crossings"]))
            self.assertAlmostEqual(ours["axisMean"], kept["axisMean"],
                                   delta=4*math.hypot(ours["axisMeanError"], kept["axisMeanError"]))
            # a deviation of n values is known to 1/sqrt(2 n) of itself; n near the axis follows
            # from rms and error
            n = (kept["axisRms"]/kept["axisMeanError"])**2
            self.assertAlmostEqual(ours["axisRms"]/kept["axisRms"], 1, delta=4*math.sqrt(2/(2*n)))

    def test_plate_and_report(self):
        # the steady flow starts from that of a coarser mesh if the run has one
        self.allrun("--generate", "plate5D-cg1", "tiny")
        made = self.runs/"plate5D-cg1-tiny"
        shutil.copytree(made, made/"coarse")
        dictionaries.put(made/"coarse"/"system"/"parameters", nSide="2", nRing="2", nJet="10", spinUpIterations="30")
        job = self.allrun("plate5D-cg1", "tiny")
        self.assertEqual(job.code, 0, job)
        self.assertIn("interpolating epsilon", (made/"log.mapFields").read_text())
        self.assertIn("After renumbering", (made/"log.renumberMesh").read_text())
        cells = [int(re.search(r"cells: +(\d+)", (at/"log.checkMesh").read_text())[1]) for at in (made/"coarse", made)]
        self.assertLess(cells[0], cells[1]/2)
        self.assertIn("6 of 6 checks hold", job.output)
        results = self.runs/"plate5D-cg1-tiny"/"results"
        hits = json.loads((results/"plate.json").read_text())
        summary = json.loads((results/"summary.json").read_text())
        rings = sum(hits[f"ring{i}"]["collisions"] for i in range(1, 8))
        self.assertEqual(hits["all"]["collisions"], rings)
        # nearly all grains hit at least once, and some come back
        sent = summary["settings"]["particlesPerSecond"]
        self.assertGreater(hits["all"]["particle_frequency"], 0.8*sent)
        self.assertLess(hits["all"]["particle_frequency"], 3*sent)

        # The fix's own table is that of the last step, which is no multiple of its `every` (1000 by default),
        # and counts what it has written to the events file
        case = results.parent
        parameters = dict(re.findall(r"(?m)^(\w+)\s+([0-9.e+-]+);", (case/"system"/"parameters").read_text()))
        end, start, step = (float(parameters[name]) for name in ("endTime", "sampleStart", "fluidStep"))
        self.assertNotEqual(round(end/step)*int(parameters["subSteps"])*int(parameters["couplingInterval"]) % 1000, 0)
        self.assertNotIn("every", (case/"constant"/"particles"/"plate").read_text().split("fix plate ")[1].split("\n")[0])
        with open(case/"postProcessing"/"plate"/"plate.csv") as file:
            whole = next(csv.DictReader(file))
        self.assertEqual(whole["region"], "all")
        # the fix counts time in DEM steps
        self.assertAlmostEqual(float(whole["time"]), end - start, delta=1e-6*(end - start))
        events = (case/"postProcessing"/"plate"/"events.csv").read_text().splitlines()
        self.assertGreater(len(events), 100)
        self.assertEqual(int(whole["collisions"]), len(events) - 1)

        kept = self.folder/"kept"
        shutil.copytree(results, kept/"plate5D-cg1-tiny")
        (self.folder/"points").mkdir()
        (self.folder/"points"/"Hardalupas1.csv").write_text("plane,r,quantity,value\n0.1,0,mean,0.8\n")
        report = [grainjet.ROOT/"validation"/"report", "--results", kept, "--size", "tiny",
                  "--experiments", self.folder/"points", "--output", self.folder/"report.md"]
        written = grainjet.run(report, self.folder)
        self.assertEqual(written.code, 0, written)
        text = (self.folder/"report.md").read_text()
        for words in ("plate5D-cg1", "## Not run", "Hardalupas1", "no points"):
            self.assertIn(words, text)

        (self.folder/"points"/"Hardalupas1.csv").write_text("plane,r,quantity,value\n0.1,0,speed,0.8\n")
        self.assertFails(grainjet.run(report, self.folder), "Hardalupas1.csv", "speed", "mean, rms, flux")
        (self.folder/"points"/"Hardalupas1.csv").write_text("r,value\n")
        self.assertFails(grainjet.run(report, self.folder), "Hardalupas1.csv", "plane,r,quantity,value")
        shutil.rmtree(kept/"plate5D-cg1-tiny")
        self.assertFails(grainjet.run(report, self.folder), "no results of size tiny", "cases/Allrun")

    def test_a_solver_that_fails_is_reported_and_can_be_continued(self):
        made = self.allrun("--generate", "Hardalupas1", "tiny")
        self.assertEqual(made.code, 0, made)
        options = self.runs/"Hardalupas1-tiny"/"system"/"fvOptions"
        options.write_text(options.read_text().replace("Gidaspow", "Gidaspov"))
        failed = self.allrun("Hardalupas1", "tiny")
        self.assertFails(failed, "Gidaspov", "log.pimpleFoam")
        self.assertFalse((self.runs/"Hardalupas1-tiny"/"stage.coupled").exists())


if __name__ == "__main__":
    unittest.main()
