# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heavy grains that leave through an outlet draw the gas in beside them. Steps of 30 response times of the grains, Courant
numbers above 1."""
# processors: 4
# label: long

import random
import shutil
import unittest

import gas_box
from crowded_box import values
from grainjet import coupled_box as box, dictionaries

GLASS, CG, SPEED = 2500.0, 186, 4
WARNING = "The fluid comes in through the outlet zhi"


class OutletInflow(box.CoupledCase):

    def leave(self, equations="full", inlet_outlet=True, ranks=0, steps=20, check=True, **fluid):
        """40 grains of 1 mm in a box of 64 cells of 2 mm, all at 4 m/s towards the outlet, air of 1 m/s. Folder."""
        rng = random.Random(2)
        x = [[rng.uniform(0.001, 0.007) for _ in "xy"] + [rng.uniform(0.003, 0.0075)] for _ in range(40)]
        folder = self.new_folder()
        gas_box.write(folder, mu=1.2e-3, size=(8, 8, 8), cells="4 4 4", steps=steps, ranks=ranks or 1, through=True, velocity="(0 0 1)",
                      **{"write_every": steps, "correctors": "nOuterCorrectors 3; nCorrectors 2;", **fluid})
        if inlet_outlet:
            dictionaries.change(folder / "0/U", ("zhi { type zeroGradient; }",
                                                 "zhi { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); }"))
        box.script(folder, grains=box.grains(x, [[0, 0, SPEED]] * len(x), 1e-3 / CG, GLASS), box="0 0.008 0 0.008 0 0.008",
                   boundary="p p f", fixes="neigh_modify delay 0 every 1 check no",
                   plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {CG} model_check warn")
        box.fv_options(folder, voidFraction=box.void_fraction(equations), drag="Stokes", forces="(pressureGradient)",
                       interpolation="cell")
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.result = self.foam("rhoPimpleFoam", folder, ranks, check=check)
        if ranks:
            self.foam("reconstructPar", folder)
        return folder

    def fastest(self, folder):
        return [abs(values(folder / f"{step * 1e-4:.10g}" / "U")).max() for step in range(1, 99)
                if (folder / f"{step * 1e-4:.10g}" / "U").exists()]

    def test_inlet_outlet(self):
        """With inletOutlet the grains leave, but for a slow one, the air slows down after them, and the table is complete."""
        for equations in ("full", "neglected"):
            with self.subTest(equations=equations):
                folder = self.leave(equations, steps=40, write_every=10)
                table, most = box.read_balance(folder), self.fastest(folder)
                print(f"{equations}: {', '.join(f'{u:.3g}' for u in most)} m/s, imbalance {max(table['imbalance']):.1e}, "
                      f"of energy {max(table['energyImbalance']):.1e}")
                self.assertNotIn(WARNING, self.result.output)
                self.assertGreaterEqual(table["leftBox"][-1], 39)
                self.assertEqual(most, sorted(most, reverse=True))
                self.assertLess(most[-1], SPEED / 2)
                self.assertLess(max(table["imbalance"] + table["energyImbalance"]), 1e-10)

    def test_ranks(self):
        """2 and 4 ranks give the same to the tolerance of the linear solvers."""
        serial = self.leave(steps=12)
        for ranks, decomposition in ((2, "(1 1 2)"), (4, "(2 1 2)")):
            with self.subTest(ranks=ranks):
                other = self.leave(steps=12, ranks=ranks, decomposition=decomposition)
                for name in ("U", "particleMomentumOwed", "momentumOfLostGrains", "momentumOfShares"):
                    a, b = (values(folder / "0.0012" / name) for folder in (serial, other))
                    print(f"{ranks} ranks, {name}: {abs(a - b).max() / abs(a).max():.1e}")
                    self.assertLess(abs(a - b).max(), 1e-6 * abs(a).max(), name)

    def test_restart_after_removal(self):
        """LIGGGHTS removes grains in the step before the restart: the fields go on to the round-off of the solver, which calculates
        energy and density anew. Before, momentum and energy owed of these grains were divided among the others: 1e-2."""
        whole = self.leave(steps=7, write_every=1)
        left = box.read_balance(whole)["leftBox"]
        split = next(i + 1 for i in range(1, 6) if left[i] > left[i - 1])
        parts = self.leave(steps=split, write_every=1)
        box.end_at(parts, 7)
        self.foam("rhoPimpleFoam", parts)
        print(f"{left[split - 1] - left[split - 2]:.0f} grains removed in step {split}")
        for name in ("U", "particleMomentumOwed", "momentumOfLostGrains", "momentumOfShares"):
            a, b = (values(folder / "0.0007" / name) for folder in (whole, parts))
            print(f"{name}: {abs(a - b).max() / abs(a).max():.1e}")
            self.assertLess(abs(a - b).max(), 1e-9 * abs(a).max(), name)
        a, b = (gas_box.field_sum(folder / "0.0007/energyOfLostGrains") for folder in (whole, parts))
        self.assertNotEqual(a, 0)
        self.assertLess(abs(a - b), 1e-9 * abs(a))

    def test_zero_gradient(self):
        """With zeroGradient the air that comes in may grow without bound: warned of once, on any number of ranks, before it is
        ten times as fast. It does so in the stock solver alone, too, from the state that the grains leave."""
        folder = self.leave(inlet_outlet=False, write_every=1, check=False)
        for output in (self.result.output, self.leave(inlet_outlet=False, steps=2, ranks=2) and self.result.output):
            self.assertEqual(output.count(WARNING), 1)
            self.assertIn("Set U of zhi to inletOutlet", " ".join(output.split()))
            self.assertLess(output.index(WARNING), output.index("Time = 0.0003") if "Time = 0.0003" in output else len(output))
        most = self.fastest(folder)
        self.assertGreater(most[-1], 10 * most[11])

        stock = self.new_folder()
        for part in ("constant", "system", "0.0012"):
            shutil.copytree(folder / part, stock / ("0" if part == "0.0012" else part))
        shutil.rmtree(stock / "0/uniform")
        (stock / "constant/fvOptions").unlink()
        dictionaries.change(stock / "system/controlDict", ('libs ("libliggghtsCoupling.so");', ""))
        self.foam("rhoPimpleFoam", stock, check=False)
        alone = self.fastest(stock)
        print(f"coupled {most[10]:.3g}, {most[11]:.3g}, {most[12]:.3g} m/s; stock from there {', '.join(f'{u:.3g}' for u in alone[:3])} m/s")
        self.assertGreater(max(alone), 10 * most[11])


if __name__ == "__main__":
    unittest.main()
