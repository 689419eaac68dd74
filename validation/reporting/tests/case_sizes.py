# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the report on larger sizes: kept results of a quick run beside a copy of them that is called medium, with
other numbers where a difference must be seen."""
# modules: cases/common

import json
import pathlib
import re
import shutil
import unittest

import grainjet
import results
import sizes

KEPT = grainjet.ROOT/"validation/cases/results/Hardalupas1-quick"
UNIT = {"fluid": 2e-6, "DEM": 1e-7, "coupling": 2e-6}


class Sizes(grainjet.Case):

    def setUp(self):
        super().setUp()
        shutil.copytree(KEPT, self.folder/"Hardalupas1-quick")

    def medium(self, faster):
        """The copy: profiles whose mean velocity is faster by a part, two ranks."""
        at = self.folder/"Hardalupas1-medium"
        shutil.copytree(KEPT, at)
        summary = json.loads((at/"summary.json").read_text())
        summary["size"] = "medium"
        summary["settings"].update(size="medium", ranks=2, subSteps=5)
        summary["fluidAxisSpeed"] /= faster
        (at/"summary.json").write_text(json.dumps(summary))
        return summary

    def text(self):
        found = results.Results(self.folder, "quick")
        return "\n".join([*sizes.report(found, pathlib.Path(self.folder)), *sizes.spent(found, UNIT, 1.1)])

    def test_none(self):
        self.assertIn("Not run; `cases/Allrun Hardalupas1 medium`", self.text())
        self.assertNotIn("core hours", self.text())

    def test_equal_runs_do_not_differ(self):
        self.medium(1)
        differences = re.findall(r"\| Hardalupas1, quick \| (\S+)D \| 0\.0 \| 0\.0 \| 0\.0 \|", self.text())
        self.assertEqual(differences, ["0.1", "10", "20"])
        self.assertTrue((self.folder/"sizes-Hardalupas1.png").exists())

    def test_a_difference_is_seen(self):
        """A tenth faster everywhere over Ugc: by the root mean square of the profile, a tenth of it."""
        self.medium(1.1)
        found = results.Results(self.folder, "quick")
        mean = found.runs["Hardalupas1"].normalised(0.1)["mean"][1]
        shown = float(re.search(r"\| Hardalupas1, quick \| 0\.1D \| (\S+) ", self.text())[1])
        self.assertAlmostEqual(shown, 10*(mean**2).mean()**0.5, delta=0.06)

    def test_cost(self):
        """Core hours: those of all ranks; by parts as they were timed."""
        cost = self.medium(1)["cost"]
        cells = re.search(r"\| Hardalupas1, medium \| 2 \|(.*)\|", self.text())[1].split("|")
        hours = 2*cost["processorSeconds"]/3600
        self.assertAlmostEqual(float(cells[7]), hours, delta=0.005)
        self.assertAlmostEqual(sum(float(cells[i]) for i in (1, 3, 5)), hours, delta=0.02)


if __name__ == "__main__":
    unittest.main()
