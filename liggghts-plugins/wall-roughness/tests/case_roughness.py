# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix wall/roughness: grains thrown at a plane and at a pipe. Angles of rebound against the distribution of the model, energy,
restarts in the middle of contacts, ranks, bad input."""
# processors: 4
# label: long

import math
import random
import unittest

import numpy

import grainjet
from grainjet import dumps, scripts, tables

D, RHO, SPEED = 1e-4, 2500.0, 3.0
AFTER = "id vx vy vz omegax omegay omegaz"

SCRIPT = """
plugin load wallroughnessplugin.so
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
units si
processors {processors}
{read}
neighbor 0.0002 bin
neigh_modify delay 0 binsize 0.002
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 1.0
fix m4 all property/global coefficientFriction peratomtypepair 1 {friction}
timestep 2e-7
fix w all wall/gran model hertz tangential history primitive type 1 {wall}
{rough}
fix i all nve/sphere
{end}
"""

PLANE = "zplane 0.0"
ROUGH = "fix r all wall/roughness wall w angle 5"


def thrown(n, angle, seed=3):
    """Grains that do not know of each other, just above the plane z = 0, at an angle to it. They arrive at different steps."""
    rng = random.Random(seed)
    grains = []
    for _ in range(n):
        azimuth = rng.uniform(0, 2*math.pi)
        across = SPEED*math.cos(math.radians(angle))
        place = (rng.uniform(-0.01, 0.01), rng.uniform(-0.01, 0.01), D/2 + rng.uniform(0, 2e-5))
        grains.append((1, D, RHO, place, (across*math.cos(azimuth), across*math.sin(azimuth), -SPEED*math.sin(math.radians(angle)))))
    return grains


class Roughness(grainjet.Case):

    def script(self, grains=None, rough=ROUGH, friction=0.0, wall=PLANE, processors="* * 1",
               read="read_data grains.data", end="run 600\n"):
        if grains:
            (self.folder/"grains.data").write_text(scripts.data(grains, ((-0.02, 0.02), (-0.02, 0.02), (-0.001, 0.01))))
        return SCRIPT.format(rough=rough, friction=friction, wall=wall, processors=processors, read=read, end=end)

    def throw(self, steps=600, name="after", **settings):
        """Velocities before and after, a row per grain."""
        grains = settings["grains"]
        ranks = settings.pop("ranks", 0)
        self.liggghts(self.script(end=scripts.dump(steps, name, AFTER) + f"run {steps}\n", **settings), ranks)
        return numpy.array([g[4] for g in grains]), dumps.array(self.folder/name)[:, 1:]

    def test_angles_of_rebound(self):
        """Without friction an elastic grain leaves a facet of inclination a as from a mirror: elevation 30 degrees - 2 a, of
        mean 30 + 2 s^2 cot(30) and deviation 2 s (rough_wall.h and its unit tests). 4,000 grains: the mean is known to
        2 s/sqrt(4000) = 0.16 degrees, the deviation to 0.11; three of these, and 0.1 for the end of the distribution that leaves
        the wall a second time."""
        angle, s, n = 30.0, 5.0, 4000
        before, after = self.throw(grains=thrown(n, angle), rough=f"fix r all wall/roughness wall w angle {s} seed 5")
        self.assertTrue((after[:, 2] > 0).all(), "a grain is still on its way to the wall")
        forward = before[:, :2]/numpy.hypot(*before[:, :2].T)[:, None]
        along = (after[:, :2]*forward).sum(1)
        across = after[:, 1]*forward[:, 0] - after[:, 0]*forward[:, 1]
        elevation = numpy.degrees(numpy.arctan2(after[:, 2], along))
        expected = angle + math.degrees(2*math.radians(s)**2/math.tan(math.radians(angle)))
        self.assertAlmostEqual(elevation.mean(), expected, delta=3*0.16 + 0.1)
        self.assertAlmostEqual(elevation.std(), 2*s, delta=3*0.11 + 0.2)
        # across: n turns by b, the grain's normal velocity 3 sin(30) leaves at 2 b to the plane of its impact
        self.assertAlmostEqual(across.mean(), 0, delta=3*0.26/n**0.5)
        self.assertAlmostEqual(across.std()/(2*SPEED*math.sin(math.radians(angle))), math.radians(s), delta=0.004)

    def test_energy(self):
        """No friction, restitution 1: every grain keeps its speed, to the error of 60 to 100 steps per contact, which is 3e-4 on the
        smooth wall. No spin appears."""
        _, smooth = self.throw(grains=thrown(300, 20), rough="")
        _, rough = self.throw(grains=thrown(300, 20))
        worst = [abs(numpy.linalg.norm(v[:, :3], axis=1)/SPEED - 1).max() for v in (smooth, rough)]
        self.assertLess(worst[0], 1e-3)
        self.assertLess(worst[1], 1e-3)
        self.assertEqual(abs(rough[:, 3:]).max(), 0)
        self.assertGreater(abs(rough[:, 2] - smooth[:, 2]).std(), 0.1)

    def test_angle_0_is_the_smooth_wall(self):
        _, smooth = self.throw(grains=thrown(100, 30), rough="", friction=0.3)
        _, rough = self.throw(grains=thrown(100, 30), rough="fix r all wall/roughness wall w angle 0", friction=0.3)
        self.assertTrue((smooth == rough).all())

    def test_friction_against_impacts_on_tilted_planes(self):
        """With friction the impact is that of the smooth wall, in the facet's frame: the impulse has the components 2 m vn along the
        facet's normal and 2 mu m vn against the slip (full slip; at 45 degrees no grain hits twice). From its size follows vn, and with
        it the energy that is lost, 2 m vn (mu vt - mu^2 vn). On the smooth wall that holds to 1e-4."""
        mu = 0.05
        before, after = self.throw(grains=thrown(300, 45), friction=mu)
        for v, change in zip(before, after[:, :3] - before):
            vn = numpy.linalg.norm(change)/2/math.sqrt(1 + mu**2)
            vt = math.sqrt(SPEED**2 - vn**2)
            lost = 0.5*(SPEED**2 - numpy.linalg.norm(v + change)**2)
            self.assertAlmostEqual(lost/(2*vn*(mu*vt - mu**2*vn)), 1, delta=1e-3)

    def test_ranks(self):
        """Bit for bit the same on 1, 2 and 4 ranks; the plane is cut where grains hit it, and they cross in contact."""
        grains = thrown(400, 15)
        _, one = self.throw(grains=grains, friction=0.3)
        for ranks in (2, 4):
            _, more = self.throw(grains=grains, friction=0.3, ranks=ranks, name=f"after{ranks}")
            self.assertTrue((one == more).all(), ranks)

    def test_restart(self):
        """A run that is continued from the middle of contacts gives the same digits as one whose `run` ended there (a `run` that is
        cut in two differs from a whole one in the last digit also with LIGGGHTS' smooth wall)."""
        grains = thrown(200, 30)
        result = self.liggghts(self.script(grains=grains, friction=0.3, end=(
            "thermo_style custom step f_r[1] f_r[2]\nthermo 50\nrun 50\nwrite_restart half\n"
            + scripts.dump(600, "after", AFTER) + "run 550\n")))
        whole = dumps.array(self.folder/"after")[:, 1:]
        begun, touching = next(row[1:] for row in tables.thermo(result.output) if row[0] == 50)
        self.assertGreater(touching, 20, "few grains are in contact at the restart")
        self.assertGreaterEqual(begun, touching)
        self.liggghts(self.script(read="read_restart half", friction=0.3, end=scripts.dump(600, "after2", AFTER) + "run 550\n"))
        self.assertTrue((dumps.array(self.folder/"after2")[:, 1:] == whole).all())

    def test_pipe(self):
        """Grains that fly along a pipe and graze its wall keep bouncing without friction and loss: their energy stays, and spreads
        over the three directions; on a smooth wall none goes to the cross-section."""
        rng = random.Random(8)
        grains = [(1, D, RHO, (0.0008*math.cos(a), 0.0008*math.sin(a), 0.0),
                   (0.2*math.cos(a), 0.2*math.sin(a), 3.0)) for a in (rng.uniform(0, 2*math.pi) for _ in range(50))]
        pipe = "zcylinder 0.001 0. 0."
        spread = {}
        for name, rough in (("smooth", ""), ("rough", ROUGH)):
            before, after = self.throw(10000, name, grains=grains, rough=rough, wall=pipe)
            energy = (after[:, :3]**2).sum(1)/(before**2).sum(1)
            self.assertLess(abs(energy - 1).max(), 0.01, name)
            spread[name] = (after[:, :2]**2).sum(1).mean()
        self.assertAlmostEqual(spread["smooth"], 0.04, delta=0.0005)
        self.assertGreater(spread["rough"], 0.1)

    def test_bad_input(self):
        grains = thrown(3, 30)
        (self.folder/"mesh.stl").write_text(scripts.stl(*scripts.rectangle((-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0))))
        mesh = ("fix s all mesh/surface file mesh.stl type 1\n"
                "fix v all wall/gran model hertz tangential history mesh n_meshes 1 meshes s\n")
        for line, words in (
                ("fix r all wall/roughness", ("missing keyword wall",)),
                ("fix r all wall/roughness wall w", ("missing keyword angle",)),
                ("fix r all wall/roughness wall w angle", ("missing the number after angle",)),
                ("fix r all wall/roughness wall w angle -1", ("angle", "-1")),
                ("fix r all wall/roughness wall w angle 30", ("angle", "11.25")),
                ("fix r all wall/roughness wall w angle 5 seed 0", ("seed", "whole number")),
                ("fix r all wall/roughness wall w angle 5 angle 5", ("angle", "twice")),
                ("fix r all wall/roughness wall w angle 5 step 1", ("unknown keyword 'step'", "wall, angle, seed")),
                ("fix r all wall/roughness wall i angle 5", ("wall 'i'", "fix wall/gran")),
                (mesh + "fix r all wall/roughness wall v angle 5", ("wall 'v'", "primitive"))):
            with self.subTest(line):
                for ranks in (0, 2) if line.endswith("roughness") else (0,):
                    result = self.liggghts(self.script(grains=grains, rough=line), ranks, check=False)
                    self.assertFails(result, "Fix wall/roughness (ID r)", *words)
                    self.assertEqual(result.output.count("ERROR"), 1, result)
                    self.assertEqual(result.code, 1, result)


if __name__ == "__main__":
    unittest.main()
