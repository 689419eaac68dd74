# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the fluid is still to receive moves with the grains: an uneven crowd of heavy grains in air, one to two in a cell, that
cross cells while they follow the air within a fraction of a step."""
# processors: 4
# label: long

import random
import unittest

import numpy

from crowded_box import values
from grainjet import coupled_box as box

AIR, GLASS, NU, STEP = 1.2, 2500.0, 1e-3, 1e-4
NUMBER, CG = 100, 186               # 30 response times of the grains in a step, mass of grains 200 times that of the air
SIDE, CELLS = 0.008, 64


class MovingDebts(box.CoupledCase):

    def crowd(self, equations="full", ranks=0, steps=60, grains=None, boundary="p p p", length=0, **fluid):
        """Half of the grains at rest, half at 1 m/s, or these places and velocities. Folder."""
        rng = random.Random(1)
        x, v = grains or ([[rng.uniform(0, SIDE) for _ in range(3)] for _ in range(NUMBER)], [])
        v = v or [[0, 0, rng.choice((0, 1))] for _ in x]
        folder = self.new_folder()
        box.write(folder, rho=f"rho [1 -3 0 0 0 0 0] {AIR};", nu=NU, size=(8, 8, 8), cells="4 4 4", steps=steps, ranks=ranks or 1,
                  **{"write_every": 20, **fluid})
        box.script(folder, grains=box.grains(x, v, 1e-3 / CG, GLASS), box="0 0.008 0 0.008 0 0.008", boundary=boundary,
                   fixes="neigh_modify delay 0 every 1 check no",
                   plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {CG} model_check warn")
        box.fv_options(folder, voidFraction=box.void_fraction(equations)[:-1] + f"filter {{ length {length}; }} }}", drag="Stokes", forces="(pressureGradient)",
                       interpolation="cell")
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.foam("pimpleFoam", folder, ranks)
        if ranks:
            self.foam("reconstructPar", folder)
        return folder

    def test_bounded(self):
        """With debts that stay in their cells the air has 60 m/s after 38 steps, and the run ends before the 60th. Air between
        grains may be faster than the grains that push it, but not twice as fast."""
        for equations in ("full", "neglected"):
            with self.subTest(equations=equations):
                folder = self.crowd(equations, write_every=10)
                name = "fluidVelocity" if equations == "full" else "U"
                times = sorted((path.parent for path in folder.glob("*/dragCoefficient")), key=lambda path: float(path.name))
                most = [[abs(values(time / n)).max() for time in times] for n in (name, "particleVelocity")]
                print(f"{equations}: fluid {', '.join(f'{u:.3g}' for u in most[0])} m/s, "
                      f"grains {', '.join(f'{u:.3g}' for u in most[1])} m/s")
                self.assertEqual(len(times), 6)
                self.assertLess(max(most[0]), 2)
                self.assertLess(max(most[1]), 1)

    def test_momentum(self):
        """What the grains gain is what the air loses, with what it is still owed, to round-off."""
        folder = self.crowd("neglected", steps=30, write_every=15, correctors="nOuterCorrectors 15; nCorrectors 2;")
        table = box.read_balance(folder)
        first, last = (AIR * (SIDE ** 3 / CELLS) * values(folder / time / "U").sum(0)
                       + values(folder / time / "particleMomentumOwed").sum(0) for time in ("0.0015", "0.003"))
        gained = numpy.array([sum(table[f"toGrains_{c}"][15:30]) for c in "xyz"])
        passed = sum(abs(p) for p in table["toGrains_z"][15:30])
        print(f"{abs(last - first + gained).max() / passed:.1e} of what was exchanged")
        self.assertLess(abs(last - first + gained).max(), 1e-9 * passed)

    def test_ranks(self):
        """The same on 1 and 4 ranks, to the tolerance of the linear solvers."""
        serial, parallel = self.crowd(steps=8, write_every=8), self.crowd(ranks=4, steps=8, write_every=8, decomposition="(2 1 2)")
        for name in ("U", "particleVelocity", "particleMomentumOwed"):
            a, b = (values(folder / "0.0008" / name) for folder in (serial, parallel))
            print(f"{name}: {abs(a - b).max() / abs(a).max():.1e}")
            self.assertLess(abs(a - b).max(), 1e-6 * abs(a).max(), name)

    def test_grains_that_leave(self):
        """Through the outlet, or deleted: what the air is still to receive of them does not throw it. Its speed stays near that of
        the start, which grains of 6 m/s and their crowd give it, and falls when they are gone; with the debt paid at once it
        was 53 m/s after 10 steps and 114 after 15. Momentum in the table is complete, and 2 ranks give the same."""
        rng = random.Random(2)
        x = [[rng.uniform(0.0001, 0.0079) for _ in "xy"] + [rng.uniform(0.0065, 0.0078)] for _ in range(30)]
        v = [[rng.gauss(0, 1), rng.gauss(0, 1), rng.choice((0.5, 6))] for _ in x]
        outlet = {"grains": (x, v), "boundary": "f f f", "through": True, "velocity": "(0 0 1)", "steps": 15, "write_every": 5}
        for equations in ("full", "neglected"):
            with self.subTest(equations=equations):
                folder = self.crowd(equations, **outlet)
                table = box.read_balance(folder)
                self.assertGreater(table["leftBox"][-1], 20)
                times = sorted((path.parent for path in folder.glob("*/dragCoefficient")), key=lambda path: float(path.name))
                most = [abs(values(time / "U")).max() for time in times]
                lost = abs(values(times[0] / "momentumOfLostGrains")).max() / (AIR * SIDE ** 3 / CELLS)
                print(f"{equations}: {', '.join(f'{u:.3g}' for u in most)} m/s, owed {lost:.3g} m/s, "
                      f"imbalance {max(table['imbalance']):.1e}")
                self.assertGreater(lost, 50)
                self.assertLess(max(most), 20)
                self.assertLess(most[-1], most[0])
                self.assertLess(max(table["imbalance"]), 1e-10)
        other = self.crowd(equations, ranks=2, decomposition="(1 1 2)", **outlet)
        for name in ("U", "momentumOfLostGrains"):
            a, b = (values(case / "0.0015" / name) for case in (folder, other))
            self.assertLess(abs(a - b).max(), 1e-6 * abs(a).max(), name)

    def filtered(self, equations, steps=80, **more):
        """30 grains at random velocities, 2 m/s rms each way, spread over the side of a cell."""
        rng = random.Random(3)
        x = [[rng.uniform(0.0002, SIDE - 0.0002) for _ in "xyz"] for _ in range(30)]
        v = [[rng.gauss(0, 2) for _ in "xyz"] for _ in x]
        return self.crowd(equations, grains=(x, v), boundary="f f f", length=0.002, steps=steps, **more)

    def test_filter(self):
        """Spread grains, too, have their debts with them: the air slows down with them. With debts that stay in their cells it had
        41 m/s after 30 steps, 137 after 40, and the run ended before the 60th."""
        for equations in ("full", "neglected"):
            with self.subTest(equations=equations):
                folder = self.filtered(equations, write_every=20)
                most = [abs(values(folder / time / "U")).max() for time in ("0.002", "0.004", "0.006", "0.008")]
                table = box.read_balance(folder)
                print(f"{equations}: {', '.join(f'{u:.3g}' for u in most)} m/s, imbalance {max(table['imbalance']):.1e}")
                self.assertEqual(most, sorted(most, reverse=True))
                self.assertLess(most[0], 4)
                self.assertLess(max(table["imbalance"]), 1e-10)

    def test_filter_ranks_and_restart(self):
        """The same on 1 and 2 ranks, to the tolerance of the linear solvers, and in a continued run, to round-off."""
        whole, parts = self.filtered("full", 8, write_every=8), self.filtered("full", 4, write_every=4)
        box.end_at(parts, 8)
        self.foam("pimpleFoam", parts)
        parallel = self.filtered("full", 8, write_every=8, ranks=2, decomposition="(1 1 2)")
        for other, tolerance in ((parts, 1e-11), (parallel, 1e-6)):
            for name in ("U", "particleVelocity", "particleMomentumOwed"):
                a, b = (values(folder / "0.0008" / name) for folder in (whole, other))
                print(f"{name}: {abs(a - b).max() / abs(a).max():.1e}")
                self.assertLess(abs(a - b).max(), tolerance * abs(a).max(), name)

    def test_restart(self):
        """A run of 40 steps, and one of 20 that is continued, end with the same fields bit for bit."""
        whole, parts = self.crowd(steps=40), self.crowd(steps=20)
        box.end_at(parts, 40)
        self.foam("pimpleFoam", parts)
        for name in ("U", "particleVelocity", "particleMomentumOwed"):
            a, b = ((folder / "0.004" / name).read_bytes() for folder in (whole, parts))
            self.assertEqual(a, b, name)


    def test_restart_after_removal(self):
        """LIGGGHTS removes grains in the last interval before the restart: what is owed of them goes on with those that are gone,
        bit for bit in the solver that continues so itself. Before, it was divided among the grains that were left: 1e-3 to
        1e-1 of the fields."""
        rng = random.Random(1)
        x = [[rng.uniform(0.0003, SIDE - 0.0003) for _ in range(3)] for _ in range(NUMBER)]
        v = [[rng.gauss(0, 0.3), rng.gauss(0, 0.3), rng.choice((0, 4))] for _ in x]
        outlet = {"grains": (x, v), "boundary": "f f f", "through": True, "velocity": "(0 0 1)"}
        for equations in ("full", "neglected"):
            for ranks in (0, 2):
                with self.subTest(equations=equations, ranks=ranks):
                    whole = self.crowd(equations, ranks, steps=6, write_every=1, decomposition="(1 1 2)", **outlet)
                    left = box.read_balance(whole)["leftBox"]
                    split = next(i + 1 for i in range(1, 5) if left[i] > left[i - 1])
                    parts = self.crowd(equations, ranks, steps=split, write_every=1, decomposition="(1 1 2)", **outlet)
                    box.end_at(parts, 6)
                    self.foam("pimpleFoam", parts, ranks)
                    if ranks:
                        self.foam("reconstructPar", parts)
                    print(f"{equations}, {ranks} ranks: {left[split - 1] - left[split - 2]:.0f} grains removed in step {split}")
                    for name in ("U", "particleVelocity", "particleMomentumOwed", "momentumOfLostGrains"):
                        a, b = ((folder / "0.0006" / name).read_bytes() for folder in (whole, parts))
                        self.assertEqual(a, b, name)


if __name__ == "__main__":
    unittest.main()
