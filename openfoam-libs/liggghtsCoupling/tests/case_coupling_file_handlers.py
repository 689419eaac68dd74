# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains lie where OpenFOAM's file handler keeps its files, and go with them through the
utilities that take a case apart and put it together."""
# processors: 2
# label: long

import shutil
import unittest

import grainjet
from grainjet import coupled_box as box, dumps, scripts
from grainjet.coupled_box import end_at, swarm

HANDLERS = ("uncollated", "masterUncollated", "collated")


class FileHandlers(grainjet.Case):

    def write(self, name, steps=6):
        folder = self.folder / name
        box.write(folder, steps=steps, walls=True)
        box.script(folder, grains=box.grains(*swarm(30, 3)), end=scripts.dump(20, "grains.*.dump", box.MOTION))
        box.fv_options(folder, interpolation="cell")
        self.foam("blockMesh", folder)
        return folder

    def run_on(self, folder, program, handler, ranks=0, *arguments):
        parallel = ["-parallel"] if ranks else []
        result = grainjet.run([*grainjet.mpirun(ranks), program, *parallel, *arguments], folder, timeout=120,
                              env={"FOAM_FILEHANDLER": handler})
        self.assertEqual(result.code, 0, result)
        return result.output

    def continue_to(self, folder, steps, handler, ranks):
        end_at(folder, steps)
        self.assertIn("30 continued grains", self.run_on(folder, "pimpleFoam", handler, ranks))

    def setUp(self):
        super().setUp()
        self.whole = self.write("whole", 12)
        self.foam("decomposePar", self.whole)
        self.foam("pimpleFoam", self.whole, 2)

    def assertSameGrains(self, folder, digits=None):
        """All digits, or the last ones left out: with another number of ranks sums in cells are
        taken in another order."""
        one, other = (dumps.last(f / "grains.120.dump") for f in (self.whole, folder))
        self.assertEqual(one.keys(), other.keys())
        for i in one:
            for a, b in zip(one[i], other[i]):
                self.assertEqual(a, b) if digits is None else self.assertAlmostEqual(a, b, digits)

    def test_each_continues_bit_for_bit(self):
        for handler in HANDLERS:
            with self.subTest(handler=handler):
                folder = self.write(handler)
                self.run_on(folder, "decomposePar", handler)
                self.run_on(folder, "pimpleFoam", handler, 2)
                self.continue_to(folder, 12, handler, 2)
                self.assertSameGrains(folder)
                written = {str(p.relative_to(folder)) for p in folder.rglob("liggghts.restart")}
                first = "processors2" if handler == "collated" else "processor0"
                self.assertEqual(written, {f"{first}/0.0006/uniform/liggghts.restart",
                                           f"{first}/0.0012/uniform/liggghts.restart"})

    def test_one_continues_the_other(self):
        for first, second in (("collated", "uncollated"), ("uncollated", "collated")):
            with self.subTest(first=first):
                folder = self.write(first)
                self.run_on(folder, "decomposePar", first)
                self.run_on(folder, "pimpleFoam", first, 2)
                self.continue_to(folder, 12, second, 2)
                self.assertSameGrains(folder)

    def test_several_ranks_that_write(self):
        folder = self.write("two")
        env = {"FOAM_FILEHANDLER": "collated", "FOAM_IORANKS": "(0 1)"}
        for steps, word in ((6, "30 new grains"), (12, "30 continued grains")):
            end_at(folder, steps)
            if steps == 6:
                self.assertEqual(grainjet.run(["decomposePar"], folder, env=env).code, 0)
            result = grainjet.run([*grainjet.mpirun(2), "pimpleFoam", "-parallel"], folder, 120, env)
            self.assertEqual(result.code, 0, result)
            self.assertIn(word, result.output)
        self.assertSameGrains(folder)

    def test_put_together_and_taken_apart(self):
        """Two ranks, then one, then two again. 1e-12 m is 1e-10 of the box."""
        for handler in HANDLERS:
            with self.subTest(handler=handler):
                folder = self.write(handler, 4)
                self.run_on(folder, "decomposePar", handler)
                self.run_on(folder, "pimpleFoam", handler, 2)
                self.run_on(folder, "reconstructPar", handler, 0, "-latestTime")
                self.continue_to(folder, 8, handler, 0)
                for part in folder.glob("processor*"):
                    shutil.rmtree(part)
                self.run_on(folder, "decomposePar", handler, 0, "-latestTime")
                self.continue_to(folder, 12, handler, 2)
                self.assertSameGrains(folder, 12)


if __name__ == "__main__":
    unittest.main()
