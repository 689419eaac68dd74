# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counters of the balance table beyond what 32 bits hold, written by the coupling's own class from a small program."""
# processors: 2

import pathlib
import shutil
import unittest

import grainjet
from grainjet import coupled_box as box


class Counters(grainjet.Case):

    def test_bytes_and_searches(self):
        program = self.folder / "counters"
        shutil.copytree(pathlib.Path(__file__).parent / "counters", program)
        built = grainjet.run(["bash", "-c", f". '{grainjet.ROOT}/openfoam-libs/tools/openfoam-environment' && wmake -s"], program,
                             env={"GRAINJET_DIR": str(grainjet.ROOT)})
        self.assertEqual(built.code, 0, built)

        case = self.folder / "case"
        box.write(case, cells="2 2 4")
        self.foam("blockMesh", case)
        self.foam("decomposePar", case)
        for ranks in (0, 2):
            self.foam(str(program / "countersTest"), case, ranks)
            table = (case / "postProcessing/liggghtsCoupling/0/balance.dat").read_text().splitlines()
            names = [line for line in table if line.startswith("#")][-1].lstrip("# ").split()
            rows = [dict(zip(names, line.split())) for line in table if not line.startswith("#")]
            self.assertEqual(len(rows), 5)
            for n, row in enumerate(rows, 1):
                # all digits: rank r has sent 3e9 n + r bytes, and searched once more
                sent = sum(3000000000 * n + rank for rank in range(max(ranks, 1)))
                self.assertEqual(row["bytes"], str(sent))
                self.assertEqual(row["searches"], str(sent + max(ranks, 1)))
            shutil.rmtree(case / "postProcessing")


if __name__ == "__main__":
    unittest.main()
