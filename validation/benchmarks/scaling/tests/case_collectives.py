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
SUB_STEPS = 2


class Collectives(grainjet.Case):

    def test_per_exchange_and_step(self):
        """A limit is no equality: grains that nobody has to be asked for need fewer."""
        library = counts.build(self.folder)
        cases = {}
        for ranks in (2, 4):
            cut = counts.BLOCKS[ranks]
            with self.subTest(ranks=ranks):
                parts = counts.per_step(self.folder, "coupled", cut, cut, library, short=1, long=2, sub_steps=SUB_STEPS, shift=0.75)
                top = cases[ranks] = counts.largest(parts["coupling"])
                self.assertLessEqual(top.collectives, PER_EXCHANGE*SUB_STEPS + PER_STEP, top.sites)
                # remote grains, and parts of grains in cells of other ranks, are asked for, so that no way is left out
                for items in ("grainData", "remotePart"):
                    self.assertTrue(any(items in site for site in top.sites), top.sites)
                self.assertGreater(top.bytes, 0)
                self.assertLess(top.neighbours, ranks)
                # the layer sees the exchanges one by one
                self.assertGreaterEqual(top.collectives, 3*SUB_STEPS)
        self.assertEqual(cases[2].collectives, cases[4].collectives)


if __name__ == "__main__":
    unittest.main()
