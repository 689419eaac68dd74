# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The coupling in a stock solver: same physics on any ranks, Newton's third law, one way."""
# processors: 2
# label: long

import math
import unittest

from grainjet import coupled_box as box, dictionaries, dumps
from grainjet.coupled_box import swarm


class Coupling(box.CoupledCase):

    def test_same_on_two_ranks(self):
        """1 and 2 ranks give the same fields and grains. The linear solvers stop at a normalised
        residual of 1e-13; 1e-11 relative allows for its growth over 20 steps."""
        grains = swarm(300, 7, low=(0.003,) * 3, high=(0.017, 0.017, 0.037))
        cases = [
            ({"walls": True, "grains": grains}, "cellPoint", "f f f"),
            ({"walls": False, "grains": swarm(300, 7)}, "cellPoint", "p p p"),
            ({"walls": False, "grains": swarm(300, 7)}, "cell", "p p p"),
        ]
        for arguments, interpolation, boundary in cases:
            options = {"interpolation": interpolation}
            serial = self.run_box(0, options=options, boundary=boundary, **arguments)
            for decomposition in ("(1 1 2)", "(2 1 1)"):
                with self.subTest(decomposition=decomposition, interpolation=interpolation):
                    parallel = self.run_box(2, options=options, boundary=boundary,
                                            decomposition=decomposition, **arguments)
                    self.compare(serial, parallel, "0.002", 1e-11)

    def test_rank_without_grains(self):
        """All grains in the lower quarter: one of the two ranks has none, on both sides."""
        grains = swarm(100, 3, high=(0.02, 0.02, 0.01), mean=(0, 0, 0.2), rms=0.05)
        options = {"interpolation": "cell"}
        serial = self.run_box(0, grains=grains, options=options)
        parallel = self.run_box(2, grains=grains, options=options)
        self.compare(serial, parallel, "0.002", 1e-11)

    def test_decompositions_that_do_not_match(self):
        """LIGGGHTS is cut in z, the fluid in x: half of the grains are
        remote. Same result, and the table shows the traffic."""
        options = {"interpolation": "cell"}
        serial = self.run_box(0, options=options)
        parallel = self.run_box(2, options=options, decomposition="(2 1 1)",
                                processors="processors 1 1 2")
        self.compare(serial, parallel, "0.002", 1e-11)
        self.assertGreater(box.read_balance(parallel)["bytes"][-1], 0)

    def test_one_way_is_bit_identical(self):
        """oneWay: the flow is, byte by byte, that of a run without the coupling."""
        velocity = "(0.3 0.1 1)"
        alone = self.run_box(0, options=False, velocity=velocity, libs="()")
        coupled = self.run_box(0, options={"coupling": "oneWay"}, velocity=velocity)
        for field in ("U", "p", "phi"):
            a, b = ((f / "0.002" / field).read_bytes() for f in (alone, coupled))
            self.assertEqual(a, b, field)
        # and the grains did feel the fluid
        slip = box.read_balance(coupled)["meanSlip"]
        self.assertLess(slip[-1], slip[0])

    def momentum_drift(self, folder, before, rho=1.2, steps=1000):
        time = f"{steps * 1e-4:.10g}"
        u = dictionaries.internal(folder / time / "U")
        volume = 0.02 * 0.02 * 0.04 / 4000
        mass = 2500.0 * math.pi / 6 * 2e-4 ** 3
        grains = dumps.last(folder / "grains.dump")
        balance = box.read_balance(folder)
        drift = []
        for k in range(3):
            fluid = rho * volume * math.fsum(c[k] for c in u)
            solid = mass * math.fsum(g[3 + k] for g in grains.values())
            drift.append(fluid + solid - mass * math.fsum(v[k] for v in before))
        exchanged = math.fsum(math.hypot(*v) for v in zip(
            *(balance[f"toGrains_{c}"] for c in "xyz")))
        return math.hypot(*drift), exchanged, balance

    def test_momentum_of_a_closed_box(self):
        """Fluid and grains in a periodic box keep their total momentum to 1e-6 of what
        they exchanged over 1000 steps. What implicit shows is the carry-over of the last step,
        still owed to the fluid; explicit shows round-off and the linear solver's rest."""
        for momentum in ("implicit", "explicit"):
            with self.subTest(momentum=momentum):
                x, v = swarm(200, 11)
                folder = self.run_box(0, steps=1000, grains=(x, v), options={"momentum": momentum},
                                      cells="10 10 40")
                drift, exchanged, balance = self.momentum_drift(folder, v)
                print(f"\n{momentum}: drift {drift:.3g} N s of {exchanged:.3g} N s exchanged, "
                      f"ratio {drift / exchanged:.3g}")
                self.assertGreater(exchanged, 0)
                self.assertLess(drift, 1e-6 * exchanged)
                self.assertLess(max(balance["imbalance"]), 1e-10)

    def test_stiff_drag_does_not_swing(self):
        """Grains so heavy that they stay at rest in a fluid that moves, with kappa = K dt/(rho V) = 2.4.
        The fluid must come to rest. For uniform kappa and Stokes drag the update of
        implicitMomentum is linear in velocity and debt; it is evaluated here step by step, with the
        first half of the first of 10 DEM steps still driven by the former velocity, and the run
        must follow it (to 1e-6: the grains' inertia is not quite infinite). Its largest swing back
        over all kappa is 0.242 (bound: 0.243); paying the debt back at once would swing by 0.6 here."""
        d, steps = 1e-3, 40
        x = [(0.001 + 0.002 * i, 0.001 + 0.002 * j, 0.001 + 0.002 * k)
             for i in range(10) for j in range(10) for k in range(20)]
        volume, rho, nu = 8e-9, 1.2, 0.02
        kappa = 3 * math.pi * rho * nu * d * 1e-4 / (rho * volume)
        folder = self.run_box(0, grains=(x, [(0, 0, 0)] * len(x)), diameter=d, density=1e12,
                              velocity="(0 0 1)", nu=nu, steps=steps, write_every=1,
                              options={"drag": "Stokes", "forces": "()"})
        u, former, debt, expected = 1.0, 1.0, 0.0, []
        for _ in range(steps):
            felt = u + (former - u) / 20
            new = u + (-kappa * felt + debt / (1 + kappa)) / (1 + kappa)
            debt = debt * kappa / (1 + kappa) + kappa * (new - u)
            u, former = new, u
            expected.append(u)
        seen = []
        for i in range(1, steps + 1):
            values = dictionaries.internal(folder / f"{i * 1e-4:.10g}" / "U")
            seen.append(sum(v[2] for v in values) / len(values))
        self.assertGreater(kappa, 2)
        for a, b in zip(seen, expected):
            self.assertAlmostEqual(a, b, delta=1e-6)
        self.assertGreater(min(seen), -0.243)
        self.assertLess(abs(seen[-1]), 0.01)
        self.assertLess(max(box.read_balance(folder)["imbalance"]), 1e-10)


if __name__ == "__main__":
    unittest.main()
