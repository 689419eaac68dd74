# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A coupled run that is stopped and continued."""
# processors: 2

import math
import re
import shutil
import unittest

from crowded_box import values
import grainjet
from grainjet import coupled_box as box, dictionaries, dumps, scripts
from grainjet.coupled_box import end_at, swarm

MASS = 2500 * math.pi / 6 * 1e-9    # of a grain
DUMP = scripts.dump(100, "grains.*.dump", box.MOTION)
FIELDS = ("U", "p", "phi", "voidFraction", "particleVelocity", "dragCoefficient",
          "particleMomentumSource", "particleMomentumOwed")


class Restart(grainjet.Case):

    def write(self, name, steps, equations="neglected", **options):
        folder = self.folder / f"{name}_{equations}"
        box.write(folder, steps=steps, write_every=20)
        # large grains in a crowd: there are contacts when the run stops
        x, v = swarm(300, 5, high=(0.02, 0.02, 0.02))
        box.script(folder, grains=box.grains(x, v, 1e-3), end=DUMP,
                   plugins="plugin load hertzcgplugin.so",
                   fixes="fix contacts all hertz/cg tangential history rolling off")
        self.options(folder, equations, **options)
        return folder

    @staticmethod
    def options(folder, equations="neglected", **options):
        box.fv_options(folder, interpolation="cell", voidFraction=box.void_fraction(equations), **options)

    def interrupted(self, ranks=0, equations="neglected"):
        """40 steps in one run, and in two runs of 20."""
        whole, parts = self.write("whole", 40, equations), self.write("parts", 20, equations)
        for folder in (whole, parts):
            self.foam("blockMesh", folder)
            if ranks:
                self.foam("decomposePar", folder)
            self.foam("pimpleFoam", folder, ranks)
        end_at(parts, 40)
        result = self.foam("pimpleFoam", parts, ranks)
        self.assertIn("300 continued grains", result.output)
        # what the first run still owed the fluid is not taken for an imbalance
        balance = box.read_balance(parts, "0.002")
        self.assertEqual(len(balance["Time"]), 20)
        self.assertLess(max(balance["imbalance"]), 1e-10)
        return whole, parts

    def test_serial_bit_for_bit(self):
        """Fields and grains, with contacts open at the time of the restart."""
        for equations, more in (("neglected", ()), ("full", ("fluidVelocity", "solidsFlux"))):
            with self.subTest(equations=equations):
                whole, parts = self.interrupted(equations=equations)
                contacts = box.read_balance(whole)["contacts"]
                self.assertGreater(contacts[19], 0)
                for field in (*FIELDS, *more):
                    a, b = ((f / "0.004" / field).read_bytes() for f in (whole, parts))
                    self.assertEqual(a, b, field)
                a, b = (dumps.last(f / "grains.400.dump") for f in (whole, parts))
                self.assertEqual(a, b)

    def test_backward(self):
        """A time scheme with two former values: those of the void fraction and of the flux of the grains, too."""
        whole, parts = self.write("whole_backward", 40, "full"), self.write("parts_backward", 20, "full")
        for folder in (whole, parts):
            dictionaries.change(folder / "system/fvSchemes", ("default Euler", "default backward"))
            self.foam("blockMesh", folder)
            self.foam("pimpleFoam", folder)
        end_at(parts, 40)
        self.foam("pimpleFoam", parts)
        for field in (*FIELDS, "fluidVelocity", "solidsFlux", "voidFraction_0", "solidsFlux_0"):
            a, b = ((f / "0.004" / field).read_bytes() for f in (whole, parts))
            self.assertEqual(a, b, field)

    def test_parallel(self):
        """2 ranks: LIGGGHTS may order its grains differently after a restart, and sums in
        cells follow that order: round-off, 1e-12 relative."""
        whole, parts = self.interrupted(2, "full")
        for folder in (whole, parts):
            self.foam("reconstructPar", folder)
        for field in ("U", "voidFraction", "particleMomentumSource"):
            a, b = (dictionaries.internal(f / "0.004" / field) for f in (whole, parts))
            a, b = ([c for v in f for c in (v if isinstance(v, tuple) else (v,))] for f in (a, b))
            scale = max(abs(c) for c in a)
            self.assertLess(max(abs(p - q) for p, q in zip(a, b)), 1e-12 * scale, field)

    def test_entries_that_do_not_fit(self):
        """Entries with which the fields of the former run mean something else, or what the fluid is owed would be lost, are
        refused; the same ones continue."""
        for former, present, words in (
                ({"equations": "full"}, {}, ("equations neglected", "equations full")),
                ({}, {"equations": "full"}, ("equations full", "equations neglected")),
                ({}, {"momentum": "explicit"}, ("momentum explicit", "momentum implicit", "particleMomentumOwed"))):
            with self.subTest(former=former, present=present):
                folder = self.write(f"{len(words)}", 10, **former)
                dictionaries.put(folder / "system/controlDict", writeInterval="10")
                self.foam("blockMesh", folder)
                self.foam("pimpleFoam", folder)
                end_at(folder, 11)
                self.options(folder, **present)
                result = self.foam("pimpleFoam", folder, check=False)
                self.assertFails(result, "fvOptions", "time 0.001", *words)
                self.assertNotRegex(result.output, box.SOLVED)
                # a former run of an older version, which did not write its entries
                properties = folder / "0.001/uniform/liggghtsCouplingProperties"
                complete = properties.read_text()
                properties.write_text(re.sub(r"(?m)^(equations|momentum) .*\n", "", complete))
                self.assertNotEqual(properties.read_text(), complete)
                self.assertFails(self.foam("pimpleFoam", folder, check=False), "fvOptions", "time 0.001", *words)
                self.options(folder, **former)
                self.foam("pimpleFoam", folder)

    def test_another_formulation(self):
        """What a run with one formulation owes the fluid is received in one with the other. Booked in neither is the half
        kick by the former SetII's pressure gradient and viscous force; a whole DEM step of them is allowed."""
        for equations, former, present in (("neglected", "SetII", "SetI"), ("full", "SetII", "SetI"), ("full", "SetI", "SetII")):
            with self.subTest(equations=equations, former=former):
                folder = self.write(former, 20, equations, formulation=former)
                self.foam("blockMesh", folder)
                self.foam("pimpleFoam", folder)
                end_at(folder, 40)
                self.options(folder, equations, formulation=present)
                self.foam("pimpleFoam", folder)
                before, balance = box.read_balance(folder), box.read_balance(folder, "0.002")
                self.assertLess(max(balance["imbalance"]), 1e-10)
                debts = ("particleMomentumOwed",) + ("momentumOfShares",) * (equations == "full")
                owed = sum(values(folder / "0.002" / debt).sum(0)[2] for debt in debts)
                self.assertAlmostEqual(balance["owed_z"][0], owed, delta=1e-10 * abs(owed))
                first, second = (sum(motion[5] for motion in dumps.last(folder / f"grains.{step}.dump").values())
                                 for step in (200, 400))
                booked = sum(balance["toGrains_z"]) + sum(balance["nonReacting_z"])
                step = abs(before["nonReacting_z"][-1]) / 10
                self.assertAlmostEqual(MASS * (second - first), booked, delta=step + 1e-10 * abs(booked))

    def test_log_that_a_continued_run_began(self):
        """The log was removed in between: a later run appends to the new one."""
        folder = self.write("log", 20)
        self.foam("blockMesh", folder)
        for end in (20, 40, 60):
            end_at(folder, end)
            if end == 40:
                (folder / "log.liggghts").unlink()
            self.foam("pimpleFoam", folder)
        log = (folder / "log.liggghts").read_text()
        self.assertTrue(log.startswith("variable continued equal 1\n"), log[:200])
        self.assertEqual(log.count("variable continued equal 1\n"), 2)

    def test_one_dump_of_both_runs(self):
        """With the line of the page one file has the frames of both runs, that of the restart step twice; without it, those
        of the second run."""
        for append, steps in (("", [200, 300, 400]),
                              ('if "${continued}" then "dump_modify frames append yes"', [0, 100, 200, 200, 300, 400])):
            folder = self.folder / f"dump{len(steps)}"
            box.write(folder, steps=20)
            box.script(folder, grains=box.grains(*swarm(3, 5)), end="dump frames all custom 100 grains.dump id x y z\n" + append)
            box.fv_options(folder)
            self.foam("blockMesh", folder)
            for end in (20, 40):
                end_at(folder, end)
                self.foam("pimpleFoam", folder)
            frames = list(dumps.frames(folder / "grains.dump"))
            self.assertEqual([frame.step for frame in frames], steps)
            twice = [frame.array().tolist() for frame in frames if frame.step == 200]
            self.assertEqual(twice[0], twice[-1])

    def test_half_written_is_refused(self):
        """A time folder without complete grains stops the run and says what to do."""
        folder = self.write("killed", 40)
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        grains = folder / "0.004/uniform/liggghts.restart"
        grains.rename(grains.with_suffix(".restart.partial"))
        end_at(folder, 60)
        result = self.foam("pimpleFoam", folder, check=False)
        self.assertFails(result, "grains of time 0.004 are missing", "liggghts.restart")
        shutil.rmtree(folder / "0.004")
        self.foam("pimpleFoam", folder)


if __name__ == "__main__":
    unittest.main()
