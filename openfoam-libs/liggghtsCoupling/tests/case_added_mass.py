# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The force addedMass in the coupling: accelerating fluid, Newton's third law, stability, ranks and restart."""
# label: long
# processors: 2

import math
import re
import unittest

import numpy

import bad_case
from grainjet import coupled_box as box, dictionaries, dumps, scripts
from grainjet.coupled_box import end_at

RHO, D, C = 1000.0, 2e-4, 0.5
VOLUME = math.pi / 6 * D ** 3
LIQUID = dict(rho=f"rho [1 -3 0 0 0 0 0] {RHO};", nu=1e-5)
MOTION = scripts.dump(10, "grains.dump", box.MOTION)

# light grains that fill 18 % of the fluid, each with a cell of its own
LARGE, LIGHT = 1.4e-3, 1.0
PLACES = [(0.002 * (i + 0.5), 0.002 * (j + 0.5), 0.002 * (k + 0.5)) for i in range(10) for j in range(10) for k in range(20)]
ALL = "{ drag { model Stokes; } pressureGradient {} viscous {} addedMass { C 0.5; } }"


class AddedMass(box.CoupledCase):

    def test_accelerating_fluid(self):
        """A plug flow with acceleration a: without drag dv/dt = (1 + C)/(s + C) a at a density ratio s, so 3 a for a
        bubble, and a for a grain like the fluid. It begins with the second interval, since the
        first knows no flow before. Tolerance of the solver's own pressure gradient, case_forces."""
        a, steps = 100.0, 6
        for ratio in (0.001, 1.0, 2.5):
            with self.subTest(ratio=ratio):
                folder = self.new_folder()
                box.write(folder, steps=steps, walls=True, **LIQUID)
                places = [(0.006, 0.007, 0.02), (0.01, 0.01, 0.03)]
                box.script(folder, grains=box.grains(places, [(0, 0, 0)] * 2, D, ratio * RHO), boundary="f f f", end=MOTION)
                box.fv_options(folder, coupling="oneWay", drag=None, forces="{ pressureGradient {} viscous {} addedMass {} }")
                self.foam("blockMesh", folder)
                for name, inlet, outlet in (
                        ("U", f"type uniformFixedValue; uniformValue table ((0 (0 0 0)) (1 (0 0 {a})));", "type zeroGradient;"),
                        ("p", "type zeroGradient;", "type fixedValue; value uniform 0;")):
                    path = folder / "0" / name
                    text = path.read_text()
                    path.write_text(text[:text.index("boundaryField")] + "boundaryField\n"
                                    f'{{ zlo {{ {inlet} }} zhi {{ {outlet} }} "[xy].*" {{ type slip; }} }}\n')
                mesh = folder / "constant/polyMesh/boundary"
                mesh.write_text(mesh.read_text().replace("wall;", "patch;"))
                self.foam("pimpleFoam", folder)
                # each interval has ten kicks, the first of them half with the force of the interval before
                dt, expected = 1e-4, (1 + C) / (ratio + C) * a
                for row in dumps.last(folder / "grains.dump").values():
                    self.assertAlmostEqual(row[5] / (expected * (steps - 1 - 0.05) * dt), 1, delta=1e-5)
                    self.assertLess(math.hypot(row[3], row[4]), 1e-5 * row[5])

    def swarm(self, density, steps, ranks=0, options=None, **more):
        x, v = box.swarm(300, 7, mean=(0, 0, 0.3))
        self.folder_of_run = self.run_box(ranks, steps, (x, v), diameter=5e-4, density=density,
                                          options={"drag": None, "forces": ALL, **(options or {})}, **LIQUID, **more)
        return self.folder_of_run, numpy.array(v)

    def test_third_law(self):
        """In a periodic box, without gravity: what fluid and grains have of momentum, from velocities alone. Light grains
        bring none, so the exchange is measured by what passed, in the coupling's own table. 5e-11: each of 20 steps solves for U to 1e-14 of its size."""
        for density in (1.0, 1000.0, 2500.0):
            for momentum in ("implicit", "explicit"):
                with self.subTest(density=density, momentum=momentum):
                    folder, v = self.swarm(density, 20, options={"momentum": momentum, "formulation": "SetI"})
                    mass = density * math.pi / 6 * 5e-4 ** 3
                    last = numpy.array([row[3:6] for row in dumps.last(folder / "grains.dump").values()])
                    gained = mass * (last - v).sum(axis=0)
                    fluid = RHO * 0.002 ** 3 * numpy.array(dictionaries.internal(folder / "0.002/U")).sum(axis=0)
                    owed = numpy.zeros(3)
                    if momentum == "implicit":
                        text = (folder / "0.002/particleMomentumOwed").read_text()
                        owed = numpy.array([[float(word) for word in row] for row in
                                            re.findall(r"\((\S+) (\S+) (\S+)\)", text)]).sum(axis=0)
                    table = box.read_balance(folder)
                    passed = numpy.linalg.norm(numpy.array([table["toGrains_" + k] for k in "xyz"]), axis=0).sum()
                    self.assertLess(abs(gained + fluid + owed).max(), 5e-11 * passed)
                    self.assertLess(max(table["imbalance"]), 1e-11)

    def test_third_law_is_seen_to_matter(self):
        """The same with a fluid that is at rest and grains that are pulled by gravity: with added mass they gain less."""
        speeds = []
        for forces in (ALL, ALL.replace("addedMass { C 0.5; }", "")):
            folder, v = self.swarm(1000.0, 5, options={"forces": forces}, fixes="fix g all gravity 9.81 vector 0 0 -1")
            last = numpy.array([row[3:6] for row in dumps.last(folder / "grains.dump").values()])
            speeds.append((last - v)[:, 2].mean())
        self.assertGreater(abs(speeds[0] - speeds[1]), 0.2 * abs(speeds[1]))

    def test_light_and_crowded(self):
        """18 % of grains a thousand times lighter than the fluid, which starts as vortices: fluid and
        grains slow down, at steps of 60 times the grain's own response time and of half of it."""
        m = LIGHT * math.pi / 6 * LARGE ** 3
        response = m / (3 * math.pi * RHO * 1e-5 * LARGE)
        values = "".join(f"({math.sin(k * y)!r} {math.sin(k * x)!r} 0)\n" for k in [2 * math.pi / 0.02]
                         for _ in range(20) for y in [0.002 * (j + 0.5) for j in range(10)]
                         for x in [0.002 * (i + 0.5) for i in range(10)])
        for delta_t in (60 * response, 0.5 * response):
            for momentum in ("implicit", "explicit"):
                with self.subTest(delta_t=delta_t, momentum=momentum):
                    delta_t = float(f"{delta_t:.3g}")
                    folder = self.new_folder()
                    box.write(folder, steps=60, delta_t=delta_t, write_every=20, **LIQUID)
                    dictionaries.change(folder / "0/U", ("uniform (0 0 0)", f"nonuniform List<vector> 2000 ({values})"))
                    x = PLACES
                    box.script(folder, dt=delta_t / 10, grains=box.grains(x, [(0.3, 0, 0)] * len(x), LARGE, LIGHT), end=MOTION)
                    box.fv_options(folder, drag=None, forces=ALL, momentum=momentum)
                    self.foam("blockMesh", folder)
                    self.foam("pimpleFoam", folder)
                    energy = []
                    for n in (0, 20, 40, 60):
                        name = "0" if n == 0 else f"{n * delta_t:.10g}"
                        U = numpy.array(dictionaries.internal(folder / name / "U"))
                        energy.append((U ** 2).sum())
                    print(f"\nstep {delta_t / response:.3g} response times, {momentum}: energy {energy}")
                    self.assertTrue(all(b <= a for a, b in zip(energy, energy[1:])), energy)
                    speeds = numpy.array([row[3:6] for row in dumps.last(folder / "grains.dump").values()])
                    self.assertLess(abs(speeds).max(), 1.5)

    def test_ranks(self):
        serial, _ = self.swarm(100.0, 20)
        for ranks, decomposition in ((2, "(1 1 2)"), (4, "(2 1 2)")):
            parallel, _ = self.swarm(100.0, 20, ranks, ranks_in_case=ranks, decomposition=decomposition)
            self.compare(serial, parallel, "0.002", 1e-11)

    def test_restart(self):
        """Bit for bit: fluid and grains, the fluid's acceleration of the interval before included."""
        whole, _ = self.swarm(100.0, 20)
        parts, _ = self.swarm(100.0, 10)
        end_at(parts, 20)
        self.foam("pimpleFoam", parts)
        for field in ("U", "p", "particleMomentumSource"):
            self.assertEqual((whole / "0.002" / field).read_bytes(), (parts / "0.002" / field).read_bytes(), field)

    def test_log(self):
        self.swarm(100.0, 1)
        self.assertIn("addedMass (C 0.5)", self.result.output)


class BadAddedMass(bad_case.BadCase):

    def test_bad_entries(self):
        for forces, words in (
                ("{ addedMass { C -0.5; } }", ("C -0.5 ", "from 1e-06 to 100: coefficient of", "C 0.5;")),
                ("{ addedMass { C 0; } }", ("C 0 ", "from 1e-06 to 100")),
                ("{ addedMass { C 101; } }", ("C 101 ", "from 1e-06 to 100")),
                ("{ addedMass { c 0.5; } }", ("Unknown entry c", "(C)")),
                ("{ addedMass { C half; } }", ("C half ", "from 1e-06 to 100")),
        ):
            for ranks in (0, 2):
                with self.subTest(forces=forces, ranks=ranks):
                    folder = self.fresh()
                    box.fv_options(folder, drag=None, forces=forces)
                    result = self.assertRefused(folder, *words, "constant/fvOptions", ranks=ranks, at_reading=True)
                    self.assertEqual(result.output.count("FOAM FATAL"), 1, result)

    def test_bounds_themselves(self):
        """Those that the message prints are good."""
        for value in ("1e-6", "100"):
            folder = self.fresh()
            box.fv_options(folder, drag=None, forces=f"{{ addedMass {{ C {value}; }} }}")
            self.assertRuns(folder)


if __name__ == "__main__":
    unittest.main()
