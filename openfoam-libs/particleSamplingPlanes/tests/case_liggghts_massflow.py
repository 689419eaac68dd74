# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""particleSamplingPlanes through the coupling against LIGGGHTS' own `fix massflow/mesh`, crossing by crossing."""

# processors: 2

import math
import random
import unittest

import numpy

import grainjet
from grainjet import coupled_box as box, dumps, scripts

DIAMETER = 0.01                       # m, unit of the planes
PLANES = {1: 0.0101, 2: 0.0203}       # number: z in m
DT, DEM_DT, STEPS = 1e-4, 1e-5, 120
GRAIN = 2e-4                          # m

SAMPLING = f"""
profiles
{{
    type particleSamplingPlanes; libs ("libparticleSamplingPlanes.so");
    cloud liggghts; origin (0.01 0.01 0); axis (0 0 1); diameter {DIAMETER};
    planes ({" ".join(str(z/DIAMETER) for z in PLANES.values())});
    radialBins 5; maxRadius 2; events yes;
}}
"""


class Massflow(grainjet.Case):

    def run_case(self, ranks, sub_steps):
        folder = self.folder/f"ranks{ranks}x{sub_steps}"
        box.write(folder, steps=STEPS//sub_steps, delta_t=DT*sub_steps, functions=SAMPLING)
        rng = random.Random(11)
        positions = [[rng.uniform(0.005, 0.015), rng.uniform(0.005, 0.015),
                      rng.uniform(0.0005, 0.0395)] for _ in range(400)]
        velocities = [[rng.gauss(0, 0.1), rng.gauss(0, 0.1), rng.gauss(0.3, 1.0)] for _ in positions]
        fixes = []
        for name, z in PLANES.items():
            (folder/f"plane{name}.stl").write_text(scripts.stl(*scripts.rectangle(
                (0, 0, z), (0.02, 0, z), (0.02, 0.02, z), (0, 0.02, z))))
            fixes.append(f"fix plane{name} all mesh/surface file plane{name}.stl type 1")
            fixes += [f"fix {way}{name} all massflow/mesh mesh plane{name} vec_side 0 0 {side} "
                      f"count multiple file {way}{name}.txt writeTime"
                      for way, side in (("forward", 1), ("backward", -1))]
        box.script(folder, grains=box.grains(positions, velocities, diameter=GRAIN),
                   fixes="\n".join(fixes), dt=DEM_DT)
        box.fv_options(folder, couplingInterval=round(DT/DEM_DT), coupling="oneWay", subSteps=sub_steps)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.foam("pimpleFoam", folder, ranks=ranks)
        return folder

    def massflow(self, folder):
        """Rows plane, direction, ID, time, x, y, z, vx, vy, vz of what LIGGGHTS counted."""
        rows = []
        for name, z in PLANES.items():
            for way, direction in (("forward", 1), ("backward", -1)):
                for path in folder.glob(f"{way}{name}.txt*"):
                    for line in path.read_text().splitlines():
                        if not line.startswith("#"):
                            tag, time, _, *rest = map(float, line.split()[:9])
                            rows.append((z/DIAMETER, direction, tag, time, *rest))
        return sorted(rows)

    def test_same_crossings(self):
        # A fluid step of four sub-steps: each is looked at, so that the crossings are those of four steps. The fluid
        # stays at rest
        tables = {}
        for ranks, sub_steps in ((0, 1), (2, 1), (2, 4)):
            folder = self.run_case(ranks, sub_steps)
            theirs = self.massflow(folder)
            events = numpy.loadtxt(folder/"postProcessing/profiles/0/events.dat")
            # columns of the events: time x/D direction origProc origId x y z axial radial ...
            ours = sorted((e[1], e[2], e[4], e[0], *e[5:8], e[8]) for e in events)
            self.assertGreater(len(theirs), 100)
            numpy.testing.assert_allclose(events[:, 11], 1)                      # f_cg = 1
            numpy.testing.assert_allclose(events[:, 12], 2500*math.pi/6*GRAIN**3, rtol=1e-9)
            self.assertEqual([row[:3] for row in theirs], [row[:3] for row in ours])
            for their, our in zip(theirs, ours):
                # LIGGGHTS notes the first DEM step behind the plane and prints 4 digits;
                # drag changes the velocity by less than 2 % in a fluid step
                speed = numpy.linalg.norm(their[7:10])
                self.assertAlmostEqual(our[3], their[3], delta=1.1*DEM_DT + 1e-3*their[3])
                for a, b in zip(our[4:7], their[4:7]):
                    self.assertAlmostEqual(a, b, delta=1.1*DEM_DT*speed + 1e-3*b)
                self.assertAlmostEqual(our[7], their[9], delta=0.02*speed)
            tables[ranks, sub_steps] = numpy.loadtxt(folder/"postProcessing/profiles/0/plane_1.01D.dat")
        self.assertEqual(list(tables[0, 1][:, 1]), list(tables[2, 1][:, 1]))
        numpy.testing.assert_allclose(tables[2, 4], tables[2, 1], rtol=1e-9, atol=1e-12)

    def test_grains_lost_in_the_step_of_their_crossing(self):
        # Grains leave the box 20 um behind the plane and are deleted by LIGGGHTS at once; at up
        # to 2 m/s most cross and vanish in the same fluid step. All that are lost have crossed.
        plane = 0.03998
        rng = random.Random(3)
        n = 200
        positions = [[rng.uniform(0.005, 0.015), rng.uniform(0.005, 0.015), rng.uniform(0.03, 0.0395)]
                     for _ in range(n)]
        velocities = [[0, 0, rng.uniform(0.8, 2.0)] for _ in positions]
        for ranks, cut, sub_steps, coupling in ((0, None, 1, "oneWay"), (2, "(2 1 1)", 1, "oneWay"), (2, "(2 1 1)", 4, "twoWay")):
            folder = self.folder/f"lost{ranks}x{sub_steps}"
            box.write(folder, steps=60//sub_steps, delta_t=DT*sub_steps, walls=True, decomposition=cut or "(1 1 2)",
                      functions=SAMPLING.replace("planes (", f"planes ({plane/DIAMETER!r} "))
            box.script(folder, grains=box.grains(positions, velocities, diameter=GRAIN), dt=DEM_DT,
                       boundary="f f f", fixes="neigh_modify delay 0 every 1 check no",
                       end="thermo_modify lost ignore\n" + scripts.dump(600, "end.dump", "id z"))
            box.fv_options(folder, couplingInterval=round(DT/DEM_DT), coupling=coupling, subSteps=sub_steps)
            self.foam("blockMesh", folder)
            if ranks:
                self.foam("decomposePar", folder)
            self.foam("pimpleFoam", folder, ranks=ranks)
            left = dumps.last(folder/"end.dump")
            beyond = sum(row[0] > plane for row in left.values())
            events = numpy.loadtxt(folder/"postProcessing/profiles/0/events.dat")
            crossed = events[events[:, 1] > 3.9]
            self.assertGreater(n - len(left), 50)
            self.assertEqual(len(crossed), n - len(left) + beyond)
            self.assertEqual(len(set(crossed[:, 4])), len(crossed), "each once")


if __name__ == "__main__":
    unittest.main()
