# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A user's model with state and without reaction: state goes with the grain to other ranks and into a
restart, and the fluid receives the opposite of what has a reaction, and of nothing else."""
# processors: 2

import math
import random
import unittest

import grainjet
from grainjet import coupled_box as box, dictionaries, dumps
from grainjet.coupled_box import end_at, swarm
import user_library

RHO, NU, RHO_P, D = 1.2, 1.5e-5, 250.0, 2e-4
MASS = RHO_P * math.pi / 6 * D ** 3
VOLUME = 0.02 * 0.02 * 0.04 / 2000
# velocity and angular velocity; and - c h of memoryForce, which shows the state
DUMP = ("dump d all custom {every} grains.*.dump id x y z vx vy vz omegax omegay omegaz "
        "f_fluidExplicitForce[1] f_fluidExplicitForce[2] f_fluidExplicitForce[3]\n"
        'dump_modify d sort id format "%d' + 12 * " %.17g" + '"')
ALL = """{
    drag { model scaledStokes; factor 1.5; }
    memoryForce { time 1e-3; }
    relaxation { time 5e-3; reaction no; }
    viscousTorque {}
}"""


class State(grainjet.Case):

    @classmethod
    def setUpClass(cls):
        cls.libs = user_library.libs("userModels")

    def run_swarm(self, name, grains, forces=ALL, steps=20, ranks=0, write_every=None, processors="",
                  options=None, **fluid):
        folder = self.folder / name
        box.write(folder, steps=steps, libs=self.libs, write_every=write_every, **fluid)
        box.script(folder, grains=box.grains(*grains, D, RHO_P), processors=processors,
                   end=DUMP.format(every=10 * steps))
        box.fv_options(folder, **{"coupling": "oneWay", "drag": None, "forces": forces, **(options or {})})
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.foam("pimpleFoam", folder, ranks)
        return folder

    def crowd(self):
        """Grains around the middle of the box, which cross the cuts in x (of the fluid) and z (of
        LIGGGHTS), too far from each other to touch."""
        rng = random.Random(3)
        x = [(0.01 + rng.uniform(-4e-4, 4e-4), 0.0005 + 0.0005 * i, 0.02 + rng.uniform(-4e-4, 4e-4))
             for i in range(38)]
        v = [(rng.choice((-1, 1)) * rng.uniform(0.3, 0.6), 0, rng.choice((-1, 1)) * rng.uniform(0.3, 0.6))
             for _ in x]
        return x, v

    # ---- state

    def test_same_on_two_ranks(self):
        """LIGGGHTS is cut in z, the fluid in x: half of the grains and their state are sent each interval,
        and many change rank. In a fluid at rest nothing depends on other grains: bit for bit."""
        grains = self.crowd()
        serial = self.run_swarm("1", grains)
        parallel = self.run_swarm("2", grains, ranks=2, decomposition="(2 1 1)", processors="processors 1 1 2")
        one, two = (dumps.last(f / "grains.200.dump") for f in (serial, parallel))
        self.assertEqual(one, two)

        def crossed(k, middle):
            return sum((one[tag][k] > middle) != (x[k] > middle) for tag, x in enumerate(grains[0], 1))

        self.assertGreater(crossed(0, 0.01), 8)
        self.assertGreater(crossed(2, 0.02), 8)
        self.assertNotEqual(one[1][9], 0)
        self.assertGreater(box.read_balance(parallel)["bytes"][-1], 0)

    def test_restart(self):
        """20 steps in one run and in two, serial and on 2 ranks: bit for bit."""
        grains = self.crowd()
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                case = dict(ranks=ranks, write_every=10, decomposition="(2 1 1)",
                            processors="processors 1 1 2" if ranks else "")
                whole = self.run_swarm(f"whole{ranks}", grains, **case)
                parts = self.run_swarm(f"parts{ranks}", grains, steps=10, **case)
                script = parts / "constant/in.particles"
                script.write_text(script.read_text().replace("custom 100 ", "custom 200 "))
                end_at(parts, 20)
                result = self.foam("pimpleFoam", parts, ranks)
                self.assertIn("38 continued grains", result.output)
                a, b = (dumps.last(f / "grains.200.dump") for f in (whole, parts))
                self.assertNotEqual(a[1][9], 0)
                self.assertEqual(a, b)

    # ---- reaction

    def momentum(self, folder, grains, time):
        """Change of the momentum of all grains, and of the fluid, which began at rest."""
        found = dumps.last(folder / "grains.500.dump")
        solid = [MASS * math.fsum(row[3 + k] - v[k] for row, v in zip(found.values(), grains[1]))
                 for k in range(3)]
        u = dictionaries.internal(folder / time / "U")
        self.assertEqual(len(u), 2000)
        return solid, [RHO * VOLUME * math.fsum(c[k] for c in u) for k in range(3)]

    def test_reaction(self):
        """Closed periodic box: what drag gave to the grains is b/(b + c) of all that they received, with
        b = 1.5 * 3 pi mu d and c = m/time the same for all grains at all times; the fluid has the
        opposite of that, and nothing of the rest. Counted from masses and velocities alone.
        Explicit: to round-off and the linear solver's rest; implicit: less what the last step still owes."""
        grains = swarm(100, 11)
        b, c = 1.5 * 3 * math.pi * RHO * NU * D, MASS / 5e-3
        for reaction, share in (("no", b / (b + c)), ("yes", 1)):
            for momentum, ranks, tolerance in (("explicit", 0, 1e-9), ("implicit", 0, 1e-4),
                                               ("explicit", 2, 1e-9)):
                with self.subTest(reaction=reaction, momentum=momentum, ranks=ranks):
                    forces = ("{ drag { model scaledStokes; factor 1.5; } "
                              f"relaxation {{ time 5e-3; reaction {reaction}; }} viscousTorque {{}} }}")
                    folder = self.run_swarm(
                        f"{reaction}-{momentum}-{ranks}", grains, forces, steps=50, ranks=ranks,
                        options={"coupling": "twoWay", "momentum": momentum, "interpolation": "cell"})
                    if ranks:
                        self.foam("reconstructPar", folder)
                    solid, fluid = self.momentum(folder, grains, "0.005")
                    print(f"\n{reaction} {momentum} {ranks}: grains {solid} N s, fluid {fluid} N s")
                    self.assertLess(solid[2], -1e-9)
                    for p, q in zip(solid, fluid):
                        self.assertAlmostEqual(q, -share * p, delta=tolerance * abs(solid[2]))
                    self.assertLess(max(box.read_balance(folder)["imbalance"]), 1e-10)


if __name__ == "__main__":
    unittest.main()
