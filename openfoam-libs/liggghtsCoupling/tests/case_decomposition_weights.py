# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run is decomposed anew by the weights that the coupling writes, and goes on: what is in the field, that decomposePar divides the
work by it, and that the grains come along from one rank to four, back, and to two."""
# processors: 2

import math
import shutil
import unittest

from grainjet import coupled_box as box, dictionaries
from grainjet.coupled_box import end_at

COST = 20.0
WEIGHT_FIELD = "weightField decompositionWeights;\n"


class DecompositionWeights(box.CoupledCase):

    def begin(self):
        """4 steps on one rank: 300 grains in the lower quarter of the box, in air so slow that none leaves its cell."""
        # walls: decomposePar of v1912 spoils the flux through periodic sides where a rank's border has steps, also without grains
        x, _ = box.swarm(300, 3, high=(0.02, 0.02, 0.01))
        self.places = x
        folder = self.run_box(
            0, steps=4, velocity="(0.1 0.05 0.2)", walls=True, boundary="f f f", grains=(x, [(0, 0, 0)]*len(x)), write_every=4, options={
                "decompositionWeights": f"{{ grainCost {COST}; }}", "interpolation": "cell"})
        self.assertEqual(self.result.output.count(f"decompositionWeights with grainCost {COST:g}"), 1)
        return folder

    def decompose(self, folder, ranks, more=""):
        shutil.rmtree(folder/"processor0", ignore_errors=True)
        dictionaries.write(folder/"system/decomposeParDict",
                           f"numberOfSubdomains {ranks}; method simple; simpleCoeffs {{ n (1 1 {ranks}); delta 1e-6; }}\n{more}")
        self.foam("decomposePar", folder)

    def work(self, folder, ranks, time):
        """Largest over mean of the ranks' weights, and of their cells."""
        each = [dictionaries.internal(folder/f"processor{rank}/{time}/decompositionWeights") for rank in range(ranks)]
        cells = [dictionaries.cells(folder/f"processor{rank}") for rank in range(ranks)]
        sums = [sum(values) if len(values) > 1 else n*values[0] for values, n in zip(each, cells)]
        return max(sums)/sum(sums)*ranks, max(cells)/sum(cells)*ranks

    def test_field_decomposition_and_restart(self):
        folder = self.begin()

        # 1 + grainCost N in each cell, N as plain arithmetic counts grains: to round-off
        number = [0]*2000
        for x, y, z in self.places:
            number[math.floor(x/0.002) + 10*(math.floor(y/0.002) + 10*math.floor(z/0.002))] += 1
        weights = dictionaries.internal(folder/"0.0004/decompositionWeights")
        self.assertEqual(len(weights), 2000)
        for weight, n in zip(weights, number):
            self.assertAlmostEqual(weight, 1 + COST*n, delta=1e-10)
        self.assertGreater(max(number), 1)

        # one run on one rank; the other on 4, back to one, on 2
        whole = folder.with_name("whole")
        shutil.copytree(folder, whole)
        end_at(whole, 12)
        self.foam("pimpleFoam", whole)

        # Slices of as many cells: all grains are on the first of four. 300 grains of 20 in 2000 cells of 1: 6500 in 500 cells there,
        # 500 elsewhere, so 3.25 over the mean
        self.decompose(folder, 4)
        work, cells = self.work(folder, 4, "0.0004")
        self.assertAlmostEqual(work, 3.25, delta=1e-6)
        self.assertAlmostEqual(cells, 1, delta=1e-6)
        for rank in range(4):
            shutil.rmtree(folder/f"processor{rank}")

        # By weight: a slice of cells is one in which a layer weighs 2000/8000; simple cuts between cells, so that a cell more or less counts
        self.decompose(folder, 4, WEIGHT_FIELD)
        work, cells = self.work(folder, 4, "0.0004")
        self.assertLess(work, 1.1)
        self.assertGreater(cells, 2)
        end_at(folder, 8)
        result = self.foam("pimpleFoam", folder, 4)
        self.assertIn("300 continued grains", result.output)
        remote = box.read_balance(folder, "0.0004")["remote"]
        self.assertGreater(remote[-1], 100)     # LIGGGHTS' ranks have bricks of one size

        self.foam("reconstructPar", folder)
        for rank in range(4):
            shutil.rmtree(folder/f"processor{rank}")
        self.decompose(folder, 2, WEIGHT_FIELD)
        work, _ = self.work(folder, 2, "0.0008")
        self.assertLess(work, 1.1)
        end_at(folder, 12)
        self.assertIn("300 continued grains", self.foam("pimpleFoam", folder, 2).output)
        self.foam("reconstructPar", folder)

        # Sums in another order: round-off, as where ranks are many from the start
        self.compare(whole, folder, "0.0012", 1e-10)
        self.assertLess(max(box.read_balance(folder, "0.0008")["imbalance"]), 1e-10)
        # a write begins a new mean: grains at rest stay where they are, so it is the same
        again = dictionaries.internal(folder/"0.0012/decompositionWeights")
        for weight, n in zip(again, number):
            self.assertAlmostEqual(weight, 1 + COST*n, delta=1e-10)

    def test_what_the_clock_says(self):
        """Nothing where it cannot: before the fluid has been solved, and without grains. The field is written all the same."""
        for steps, grains in ((1, ([(0.001, 0.001, 0.001)], [(0, 0, 0)])), (2, ([], []))):
            with self.subTest(steps):
                folder = self.run_box(0, steps=steps, walls=True, boundary="f f f", grains=grains, write_every=steps, options={
                    "decompositionWeights": "{ grainCost 2; }", "interpolation": "cell"})
                self.assertNotIn("by the clock of this run", self.result.output)
                weights = dictionaries.internal(folder/f"{1e-4*steps:g}/decompositionWeights")
                self.assertEqual(sum(weights) if len(weights) > 1 else 2000*weights[0], 2000 + 2*len(grains[0]))


if __name__ == "__main__":
    unittest.main()
