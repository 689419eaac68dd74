# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The coupling's collective operations per fluid step stay few, and do not go with the number of ranks: counted by PMPI on 2 and
4 ranks, with grains that are remote, so that ranks ask each other for them. No time is measured."""
# processors: 2

import unittest

import grainjet
from grainjet import mpi_counts as counts

# In each exchange with the grains: where grains are and whether all were found (2), where their parts are (2), impulses (1)
PER_EXCHANGE = 5
# In each fluid step: figures of the log (1), whether drag is so stiff that debts move (1)
PER_STEP = 2


class Collectives(grainjet.Case):

    def test_per_exchange_and_step(self):
        """A limit is no equality: grains that nobody has to be asked for need fewer."""
        library = counts.build(self.folder)
        cases = {}
        for ranks, sub_steps in ((2, 1), (4, 1), (2, 3)):
            cut = counts.BLOCKS[ranks]
            with self.subTest(ranks=ranks, sub_steps=sub_steps):
                parts = counts.per_step(self.folder, "coupled", cut, cut, library, short=1, long=3, sub_steps=sub_steps, shift=1.0)
                top = cases[ranks, sub_steps] = counts.largest(parts["coupling"])
                self.assertLessEqual(top.collectives, PER_EXCHANGE*sub_steps + PER_STEP, top.sites)
                # remote grains are asked for and answered, so that no way is left out
                self.assertGreater(top.messages, 0)
                self.assertTrue(any("grainData" in site for site in top.sites), top.sites)
                # each rank sends to those around it at most
                self.assertLess(top.neighbours, ranks)
        self.assertEqual(cases[2, 1].collectives, cases[4, 1].collectives)
        self.assertGreater(cases[2, 3].collectives, cases[2, 1].collectives)


if __name__ == "__main__":
    unittest.main()
