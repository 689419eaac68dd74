# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The water jet, shrunk: the same Allrun on a coarser mesh with larger grains, in a copy of the folder.
What it must leave behind and what must hold in its results; that it goes on after an end on the way."""

import shutil
import unittest

import grainjet
from grainjet import dictionaries, fields, tables

WATER_JET = grainjet.ROOT/"cases"/"waterJet"

# Cells and time step twice those of the job, so that Courant numbers stay the same
SHRUNK = {"cg": 2, "fluidStep": 1e-5, "couplingInterval": 80, "insertionInterval": 320, "nInlet": 8, "nAir": 6, "nJet": 22,
          "sampleStart": 0.002, "endTime": 0.003, "writeInterval": 0.0005}


class WaterJet(grainjet.Case):

    def allrun(self, case):
        job = grainjet.run(["./Allrun"], case, timeout=800, env={"GRAINJET_PROGRESS": "2"})
        self.assertEqual(job.code, 0, job)
        self.assertIn("All checks hold", job.output)
        return job

    def judged(self, case):
        return grainjet.run([WATER_JET/"check.py", case], case)

    def test_job_its_results_and_the_way_on(self):
        case = self.folder/"waterJet"
        shutil.copytree(WATER_JET, case, ignore=shutil.ignore_patterns(
            "tests", "log.*", "processor*", "postProcessing", "results", "polyMesh", "particles", "begun", "0",
            "0.[0-9]*", "[1-9]*"))
        dictionaries.put(case/"system"/"parameters", **SHRUNK)
        job = self.allrun(case)
        # a line for each fluid: there were enough grains to judge in both
        for fluid in ("water", "air"):
            self.assertRegex(job.output, rf"holds  +density that grains in {fluid} feel")
        self.assertTrue((case/"results/waterJet.png").read_bytes().startswith(b"\x89PNG"))
        time, mesh = fields.latest_mesh(case)
        self.assertEqual(time, SHRUNK["endTime"])
        for field in ("U", "alpha.water", "voidFraction"):
            self.assertTrue(mesh.GetCellData().HasArray(field), field)

        # a run that ended on the way goes on, and comes to the same water
        before = tables.history(case/"postProcessing/water", "volFieldValue")["volIntegrate(alpha.water)"]
        shutil.rmtree(case/"results")
        for late in [*case.glob("processor*/0.003"), case/"0.003"]:
            shutil.rmtree(late)
        again = self.allrun(case)
        self.assertIn("goes on from 0.0025 s", again.output)
        self.assertNotIn("Mesh quality", again.output)
        after = tables.history(case/"postProcessing/water", "volFieldValue")["volIntegrate(alpha.water)"]
        self.assertEqual(len(after), len(before))
        self.assertAlmostEqual(after[-1]/before[-1], 1, delta=0.01)     # other grains: random numbers begin anew

        # checks that cannot fail are none: a grain too many, water that is not there
        balance = max(case.glob("postProcessing/liggghtsCoupling/*/balance.dat"))
        good = balance.read_text()
        lines = good.splitlines()
        names = [name.strip() for name in [line for line in lines if line.startswith("#")][-1][1:].split("\t")]
        values = lines[-1].split("\t")
        values[names.index("unaccounted")] = "1"
        balance.write_text("\n".join([*lines[:-1], "\t".join(values)]) + "\n")
        self.assertFails(self.judged(case), "FAILED  grains unaccounted for")
        balance.write_text(good)
        water = max(case.glob("postProcessing/water/*/*.dat"))
        lines = water.read_text().splitlines()
        water.write_text("\n".join([*lines[:-1], f"{lines[-1].split()[0]}\t{1.01*after[-1]:.8e}"]) + "\n")
        self.assertFails(self.judged(case), "FAILED  water: in - out - stored")


if __name__ == "__main__":
    unittest.main()
