# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""subSteps: grains fly through a fluid step in several intervals."""
# processors: 2

import math
import unittest

import gas_box
import heat_box
from grainjet import coupled_box as box, dictionaries, dumps, scripts

ALL = "{ drag { model Gidaspow; } pressureGradient {} viscous {} addedMass { C 0.5; } }"
CONTACTS = "fix contacts all hertz/cg tangential history rolling off\n"

# columns of balance.dat that are times of a clock
CLOCKS = ("secondsFluid", "secondsDEM", "secondsCoupling")

K_EPSILON = "simulationType RAS; RAS { RASModel kEpsilon; turbulence off; printCoeffs off; }"


class SubSteps(heat_box.HeatCase):

    def two_way(self, n, ranks=0, steps=5, dense=False, **options):
        """The periodic box, air of 1 m/s, n sub-steps of 1e-4 s in a fluid step."""
        grains = box.swarm(300, 7, high=(0.02, 0.02, 0.02 if dense else 0.04))
        return self.run_box(ranks, steps=steps, grains=grains, diameter=1e-3 if dense else 5e-4, delta_t=n * 1e-4,
                            velocity="(0 0 1)", options={"drag": None, "forces": ALL, "subSteps": n, **options})

    def test_one_is_none(self):
        """subSteps 1 and no such entry: bit for bit, tables too."""
        runs = [self.two_way(1, dense=True, subSteps=n) for n in ("1", None)]
        for field in ("U", "p", "phi", "voidFraction", "particleMomentumSource", "particleMomentumOwed", "dragCoefficient"):
            a, b = ((run / "0.0005" / field).read_bytes() for run in runs)
            self.assertEqual(a, b, field)
        a, b = map(box.read_balance, runs)
        self.assertEqual(list(a), list(b))
        for name in a:
            if name not in CLOCKS:
                self.assertEqual(a[name], b[name], name)

    def test_momentum_and_ranks(self):
        """Momentum of fluid and grains to round-off, with what the fluid is owed at the end of a step; 1 = 2 ranks."""
        for momentum, more in (("implicit", {}), ("explicit", {}),
                               ("implicit", {"voidFraction": "{ filter { length 3e-3; } }"})):
            with self.subTest(momentum=momentum, **more):
                runs = [self.two_way(4, ranks, momentum=momentum, **more) for ranks in (0, 2)]
                for run in runs:
                    balance = box.read_balance(run)
                    self.assertLess(max(balance["imbalance"]), 1e-12)
                    self.assertGreater(min(abs(z) for z in balance["toGrains_z"]), 0)
                # The filter's linear solver leaves 1e-12
                self.compare(*runs, "0.002", 1e-10 if more else 1e-11)

    def test_sum_of_four_steps(self):
        """What grains do to the fluid is the sum over the sub-steps: grains so light in drag that the fluid stays as it
        is, four steps against one of four sub-steps. Half of the last kick is booked in the next step in both."""
        grains = box.swarm(50, 3)
        runs = [self.run_box(grains=grains, diameter=2e-5, delta_t=n * 1e-4, steps=8 // n, velocity="(0 0 1)",
                             options={"subSteps": n}) for n in (1, 4)]
        a, b = map(box.read_balance, runs)
        for axis in "xyz":
            for i in range(2):
                four = sum(a[f"toGrains_{axis}"][4 * i:4 * i + 4])
                self.assertAlmostEqual(b[f"toGrains_{axis}"][i] / four, 1, delta=1e-4)
        self.assertEqual(a["present"][3::4], b["present"])
        self.assertAlmostEqual(sum(a["meanSlip"][:4]) / 4 / b["meanSlip"][0], 1, delta=1e-4)
        self.assertNotIn("fluidChange", a)
        self.assertEqual(b["fluidChange"][0], 0)
        # 50 grains of 8e-11 kg that lose 0.3 m/s give 1e-6 m/s to 20 mg of air, in their own cells some hundred times that
        self.assertTrue(1e-8 < b["fluidChange"][1] < 1e-3, b["fluidChange"])

    def test_trajectory(self):
        """One grain in a stream that stays as it is: four steps and one of four sub-steps give the same way, and that
        of the exact solution under Stokes drag, of which a DEM step h misses 0.25 (h/tau)^2."""
        d, steps = 2e-5, 20
        tau = 2500.0 * d ** 2 / (18 * 1.2 * 1.5e-5)
        start = (0.3, 0, -1)
        last = []
        for n in (1, 4):
            folder = self.run_box(grains=([(0.01, 0.01, 0.02)], [start]), diameter=d, delta_t=n * 1e-4, steps=steps // n,
                                  velocity="(0 0 1)", options={"coupling": "oneWay", "forces": "()", "drag": "Stokes", "subSteps": n})
            frame = dumps.frames(folder / "grains.dump")[-1].by_id()[1]
            last.append(frame)
            for k, fluid in enumerate((0, 0, 1)):
                slip = start[k] - fluid
                expected = fluid + slip * math.exp(-steps * 1e-4 / tau)
                self.assertAlmostEqual(frame[3 + k], expected, delta=0.25 * (1e-5 / tau) ** 2 * abs(slip) + 1e-12)
        for one, four in zip(*last):
            self.assertAlmostEqual(one, four, delta=1e-14)      # the solver's tolerance

    def test_eddies(self):
        """The sub-step is the interval of Langevin, each with random numbers of its own: turbulence that stays as it is
        moves grains as in steps of that length. So it does in a run that goes on with another subSteps, in which no number
        comes twice and none is left out."""
        last = []
        for parts in ([(1, 20)], [(4, 5)], [(4, 3), (1, 8)]):
            folder = self.new_folder()
            n, steps = parts[0]
            box.write(folder, steps=steps, delta_t=n * 1e-4, velocity="(0 0 1)")
            dictionaries.write(folder / "constant/turbulenceProperties", K_EPSILON)
            for name, value, dimensions in (("k", 0.1, "0 2 -2"), ("epsilon", 10, "0 2 -3"), ("nut", 9e-5, "0 2 -1")):
                dictionaries.write_field(folder, name, dimensions, value, {".*": "type cyclic;"})
            box.script(folder, grains=box.grains(*box.swarm(100, 3), 2e-5), end=scripts.dump(200, "grains.dump", box.MOTION))
            box.fv_options(folder, coupling="oneWay", forces="()", turbulentDispersion="Langevin", subSteps=n)
            self.foam("blockMesh", folder)
            for n, steps in parts:
                dictionaries.put(folder / "constant/fvOptions", subSteps=n)
                dictionaries.put(folder / "system/controlDict", deltaT=repr(n * 1e-4), endTime="0.0012" if len(parts) > 1 and n > 1 else "0.002")
                self.foam("pimpleFoam", folder)
            last.append(dumps.last(folder / "grains.dump"))
        for tag in last[0]:
            for one, *others in zip(*(rows[tag] for rows in last)):
                for other in others:
                    self.assertAlmostEqual(one, other, delta=1e-11)       # the solver's tolerance
        self.assertGreater(max(abs(row[3]) for row in last[0].values()), 0.3)

    def test_restart(self):
        """Stopped in the middle and continued: bit for bit, with contacts open."""
        x, v = box.swarm(300, 5, high=(0.02, 0.02, 0.02))
        runs = []
        for ends in ((0.0032,), (0.0016, 0.0032)):
            folder = self.new_folder()
            box.write(folder, steps=8, write_every=4, delta_t=4e-4, velocity="(0 0 1)")
            box.script(folder, grains=box.grains(x, v, 1e-3), plugins="plugin load hertzcgplugin.so", fixes=CONTACTS,
                       end=scripts.dump(320, "grains${continued}.dump", box.MOTION))
            box.fv_options(folder, drag=None, forces=ALL, subSteps=4)
            self.foam("blockMesh", folder)
            for end in ends:
                dictionaries.put(folder / "system/controlDict", endTime=repr(end))
                self.foam("pimpleFoam", folder)
            runs.append(folder)
        self.assertGreater(max(box.read_balance(runs[0])["contacts"]), 0)
        for field in ("U", "p", "phi", "particleMomentumSource", "particleMomentumOwed", "previousGrainU"):
            a, b = ((run / "0.0032" / field).read_bytes() for run in runs)
            self.assertEqual(a, b, field)
        self.assertEqual(dumps.last(runs[0] / "grains0.dump"), dumps.last(runs[1] / "grains1.dump"))

    def test_leaving(self):
        """Grains that leave the box in any of the sub-steps are counted, and what they got is in the balance."""
        grains = box.swarm(100, 3, low=(0, 0, 0.03), mean=(0, 0, 3))
        folder = self.run_box(grains=grains, diameter=5e-4, delta_t=1e-3, steps=6, boundary="f f f", walls=True,
                              fixes="neigh_modify delay 0 every 1 check no", options={"subSteps": 10})
        balance = box.read_balance(folder)
        self.assertGreater(balance["leftBox"][-1], 50)
        self.assertEqual(set(balance["unaccounted"]), {0})
        self.assertLess(max(balance["imbalance"]), 1e-12)

    def test_gas(self):
        """Energy and heat of a gas as well, to round-off; 1 = 2 ranks."""
        runs = []
        for ranks in (0, 2):
            folder = self.run_warm(ranks=ranks, steps=4, delta_t=4e-4, velocity="(0 0 10)", diameter=5e-4, cells="6 6 12",
                                   options={"subSteps": 4})
            balance = box.read_balance(folder)
            self.assertLess(max(balance["imbalance"]), 1e-12)
            self.assertLess(max(balance["energyImbalance"]), 1e-12)
            self.assertGreater(abs(balance["heatToGrains"][-1]), 0)
            runs.append(folder)
        self.compare(*runs, "0.0016", 1e-10)

    def test_step_that_changes(self):
        """With adjustTimeStep each sub-step has the smallest number of DEM steps that are not longer than timestep."""
        folder = self.new_folder()
        box.write(folder, steps=1000, delta_t=4e-5, velocity="(0 0 1)",
                  control="adjustTimeStep yes; maxCo 0.3; maxDeltaT 5e-4;")
        dictionaries.put(folder / "system/controlDict", endTime="0.002", writeControl="adjustableRunTime", writeInterval="0.002")
        box.script(folder, grains=box.grains(*box.swarm(100, 3), 5e-4),
                   fixes='variable t equal time\nvariable h equal dt\n'
                         'fix clock all print 1 "$t $h" file clock.txt screen no title ""\n')
        box.fv_options(folder, couplingInterval=None, subSteps=3)
        self.foam("blockMesh", folder)
        result = self.foam("pimpleFoam", folder)
        rows = [tuple(map(float, line.split())) for line in (folder / "clock.txt").read_text().splitlines() if line[:1] not in ("#", "")]
        steps = [float(line.split()[-1]) for line in result.output.splitlines() if line.startswith("deltaT = ")]
        self.assertGreater(max(steps) / min(steps), 3)
        numbers = [max(1, math.ceil(step / 3 / 1e-5 * (1 - 1e-5))) for step in steps]
        self.assertEqual(3 * sum(numbers), len(rows))
        self.assertAlmostEqual(rows[-1][0] / 0.002, 1, delta=1e-12)
        self.assertLess(max(h for _, h in rows), 1e-5 * (1 + 1e-8))
        self.assertLess(max(box.read_balance(folder)["imbalance"]), 1e-12)

    def test_stiff_drag_is_said(self):
        """Grains of a fluid step that is long against what they do to the fluid."""
        folder = self.two_way(600, steps=1, dense=True)
        self.assertEqual(self.result.output.count("Shorten deltaT, with subSteps"), 1)
        self.assertLess(max(box.read_balance(folder)["imbalance"]), 1e-12)

    def refused(self, *words, ranks=0, delta_t=4e-4, **options):
        folder = self.new_folder()
        box.write(folder, delta_t=delta_t, cells="2 2 4")
        box.script(folder, grains=box.grains([(0.01, 0.01, 0.01)], [(0, 0, 1)]))
        box.fv_options(folder, subSteps=4, **options)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        result = self.foam("pimpleFoam", folder, ranks, check=False, timeout=60)
        self.assertFails(result, "constant/fvOptions", *words)
        self.assertEqual(result.output.count("FOAM FATAL"), 1, result)
        self.assertNotRegex(result.output, box.SOLVED)

    def test_refused(self):
        self.refused("subSteps 4 with equations full", "equations neglected", voidFraction=box.void_fraction("full"), ranks=2)
        self.refused("subSteps 4 with selfDisturbance yes", "Remove subSteps", selfDisturbance="yes")
        for delta_t, words in (("0.0005", "Set deltaT to 0.0004, or subSteps to 5, or couplingInterval to 13 and deltaT to 0.00052"),
                               ("0.00048", "Set deltaT to 0.0004, or couplingInterval to 12\n"),
                               ("1e-06", "Set deltaT to 0.0004, or couplingInterval to 1 and deltaT to 4e-05\n")):
            self.refused("not subSteps times couplingInterval", f"deltaT {delta_t}", "subSteps 4", "couplingInterval 10", words,
                         delta_t=float(delta_t))


if __name__ == "__main__":
    unittest.main()
