# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The arithmetic of the model of a step on a cluster, against sums done by hand."""

import importlib.util
import unittest

import grainjet

SCRIPT = grainjet.ROOT/"validation/benchmarks/scaling/model.py"


def load():
    spec = importlib.util.spec_from_file_location("scaling_model", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Model(unittest.TestCase):

    def setUp(self):
        self.model = load()

    def test_network(self):
        """10 messages and 3 collectives of log2(8) = 3 stages at 2 us, 1000 bytes at 1 MB/s: 20 + 18 + 1000 us."""
        part = self.model.Part(work=1.0, messages=10, bytes=1000, collectives=3)
        self.assertAlmostEqual(self.model.network(part, 8, 2e-6, 1e6), 1038e-6, delta=1e-15)
        self.assertEqual(self.model.network(part, 1, 2e-6, 1e6), 0)

    def test_stages_and_faces(self):
        self.assertEqual([self.model.stages(p) for p in (1, 2, 3, 4, 16, 4096)], [0, 1, 2, 2, 4, 12])
        self.assertAlmostEqual(self.model.faces(8*1000, 8), 600, delta=1e-9)     # a cube of 10 x 10 x 10 cells
        self.assertEqual(self.model.faces(1000, 1), 0)

    def test_work(self):
        """One rank has all of it, and no network; 8 ranks have an eighth each if grains are balanced."""
        case = self.model.Case(cells=1000, grains=100, exchanges=5, dem_steps=10)
        by_hand = 1000*1.90e-6 + 100*(50*95e-9 + 5*1.81e-6)
        alone = self.model.step(case, 1)
        self.assertAlmostEqual(sum(alone.values()), by_hand, delta=1e-12)
        self.assertAlmostEqual(self.model.step(case, 8, balanced=True)["work"], by_hand/8, delta=1e-12)
        # grains in the cells that the jet occupies only
        occupied = (1000*1.90e-6)/8 + 100/(8*self.model.OCCUPIED)*(50*95e-9 + 5*1.81e-6)
        self.assertAlmostEqual(self.model.step(case, 8)["work"], occupied, delta=1e-12)

    def test_series(self):
        """Strong: efficiency is time alone over P times the time. Weak: over the time."""
        case = self.model.Case(cells=10**6, grains=10**5, exchanges=5, dem_steps=10)
        for strong, share in ((True, 16), (False, 1)):
            (_, first, one), (p, seconds, efficiency) = self.model.rows(case, (1, 16), strong)
            self.assertEqual((p, one), (16, 1))
            self.assertAlmostEqual(efficiency, sum(first.values())/sum(seconds.values())/share, delta=1e-12)
        # collectives of the coupling are those that the counts allow
        per_step, per_exchange = self.model.COUPLING_COLLECTIVES
        self.assertEqual(self.model.parts(case, 16, True)["coupling"].collectives,
                         per_step + 5*per_exchange + self.model.OTHER_COLLECTIVES)

    def test_command(self):
        """It prints its tables, and takes another network."""
        fast, slow = (grainjet.run(["/usr/bin/python3", SCRIPT, "--ranks", "1", "64", "--latency", latency], SCRIPT.parent)
                      for latency in ("1", "100"))
        for result in (fast, slow):
            self.assertEqual(result.code, 0, result)
            self.assertEqual(result.output.count("| 64 |"), 6)
        times = [float(result.output.split("| 64 | ")[1].split(" |")[0]) for result in (fast, slow)]
        self.assertLess(times[0], times[1])


if __name__ == "__main__":
    unittest.main()
