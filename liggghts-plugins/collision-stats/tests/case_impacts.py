# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""Two grains that meet: fix collision/stats against the theory of the impact and against their motion."""

import math
import unittest

from collision_case import CollisionCase, effective, hertz, mass
from grainjet import dumps, scripts

D, RHO = 0.001, 2500.0
BOX = ((0.0, 0.02), (0.0, 0.02), (0.0, 0.02))
PRINT = """
variable a equal f_k[1]
variable b equal f_k[4]
variable d equal f_c[7]
print "sums $a $b $d"
"""
DUMP = scripts.dump("{}", "dump.txt", "id x y z vx vy vz omegax omegay omegaz")


class Impacts(CollisionCase):

    def meet(self, v1, v2=(0, 0, 0), d2=D, spin1=(0, 0, 0), spin2=(0, 0, 0), gap=1e-6, steps=3000, dt=1e-7, factor=1,
             ranks=0, **options):
        """Grain 1 comes along x, grain 2 lies in the middle; the row of totals, frames of the dump at the start
        and the end, and sums that are printed."""
        reach = 0.5 * (D + d2) * factor + gap
        self.data([(1, D * factor, RHO, (0.01 - reach, 0.01, 0.01), v1, spin1),
                   (1, d2 * factor, RHO, (0.01, 0.01, 0.01), v2, spin2)], BOX)
        result = self.liggghts(self.script(DUMP.format(steps) + f"run {steps}\n" + PRINT, dt=dt, **options), ranks)
        frames = dumps.frames(self.folder / "dump.txt")
        first, *_, last = [{int(row[0]): row[1:] for row in frame.rows} for frame in frames]
        return self.rows()["all", "all"], first, last, self.printed(result, "sums")

    def kinetic(self, frame, sizes):
        energy = 0.0
        for i, row in frame.items():
            m, r = mass(sizes[i - 1], RHO), 0.5 * sizes[i - 1]
            energy += 0.5 * m * sum(v * v for v in row[3:6]) + 0.2 * m * r * r * sum(w * w for w in row[6:9])
        return energy

    def test_head_on_elastic(self):
        """All of Hertz' theory: about 1500 steps in contact. The peak lies between two steps, (pi/2/1500)^2/2 of it at
        most too low; the duration is a whole number of steps, one too long or short."""
        v, d2 = 0.4, 1.5 * D
        m = effective(mass(D, RHO), mass(d2, RHO))
        depth, peak, duration = hertz(effective(D / 2, d2 / 2), m, v)
        row, _, _, _ = self.meet((v, 0, 0), d2=d2, e=1.0, steps=int(1.2 * duration / 1e-7))
        self.assertEqual(row["collisions"], 1)
        self.assertAlmostEqual(row["impact_speed_mean"], v, delta=1e-10 * v)
        self.assertAlmostEqual(row["normal_energy_mean"] / (0.5 * m * v * v), 1.0, delta=1e-9)
        self.assertLess(row["tangential_energy_mean"], 1e-25)
        self.assertAlmostEqual(row["normal_force_peak_mean"] / peak, 1.0, delta=2e-5)
        self.assertAlmostEqual(row["duration_mean"], duration, delta=1e-7)
        self.assertLess(abs(row["dissipated_energy_mean"]), 1e-6 * 0.5 * m * v * v, "of the order of the steps squared")
        self.assertEqual(row["lost"], 0)

    def test_loss_is_that_of_the_motion(self):
        """An oblique impact with dissipation, without and with friction and rotation, which the dumped motion before and
        after shows. Velocity Verlet gives each grain exactly the work of the mean force on the mid-step motion, to
        rounding; the torque of friction turns a little within a step of 1/600 of the contact, and its work is
        exact to the square of that only."""
        row, first, last, (n, loss, of_contacts) = self.meet((0.5, 0.3, -0.1), (-0.2, 0.05, 0.0), e=0.7,
                                                             contact="fix c all hertz/cg tangential off")
        self.assertEqual(n, 1)
        change = self.kinetic(first, (D, D)) - self.kinetic(last, (D, D))
        self.assertAlmostEqual(row["dissipated_energy_mean"] / change, 1.0, delta=1e-9)
        self.assertAlmostEqual(loss / of_contacts, 1.0, delta=1e-12)
        v1, v2, w1, w2 = (0.5, 0.3, -0.1), (-0.2, 0.05, 0.0), (100, -50, 300), (0, 20, -40)
        row, first, last, (n, loss, of_contacts) = self.meet(v1, v2, spin1=w1, spin2=w2, e=0.7, mu=0.2)
        self.assertEqual(n, 1)
        change = self.kinetic(first, (D, D)) - self.kinetic(last, (D, D))
        self.assertAlmostEqual(row["dissipated_energy_mean"] / change, 1.0, delta=5e-6)
        self.assertAlmostEqual(loss / of_contacts, 1.0, delta=1e-12)
        self.assertEqual(row["dissipated_energy_sum"], row["dissipated_energy_mean"])
        # before: from the places of the first step in contact
        m, step = effective(mass(D, RHO), mass(D, RHO)), 0
        while True:
            x1, x2 = ([x + 1e-7 * step * u for x, u in zip(first[i][:3], v)] for i, v in ((1, v1), (2, v2)))
            if math.dist(x1, x2) < D:
                break
            step += 1
        n = [(a - b) / math.dist(x1, x2) for a, b in zip(x1, x2)]
        u = [a - b for a, b in zip(v1, v2)]
        approach = sum(a * b for a, b in zip(u, n))
        arm = math.dist(x1, x2) / 2
        s = [arm * (a + b) for a, b in zip(w1, w2)]
        turn = (n[1] * s[2] - n[2] * s[1], n[2] * s[0] - n[0] * s[2], n[0] * s[1] - n[1] * s[0])
        slip = math.sqrt(sum((a - approach * b + t) ** 2 for a, b, t in zip(u, n, turn)))
        self.assertAlmostEqual(row["impact_speed_mean"], math.hypot(*u), delta=1e-9)
        self.assertAlmostEqual(row["normal_energy_mean"] / (0.5 * m * approach ** 2), 1.0, delta=1e-8)
        self.assertAlmostEqual(row["tangential_energy_mean"] / (0.5 * m * slip ** 2), 1.0, delta=1e-8)
        # friction slides at first, so its peak is at most mu times the normal one, and not far from it here
        ratio = row["tangential_force_peak_mean"] / row["normal_force_peak_mean"]
        self.assertLessEqual(ratio, 0.2 * (1 + 1e-12))
        self.assertGreater(ratio, 0.15)

    def test_restitution(self):
        """A head-on impact with e = 0.8 takes (1 - e^2) of the energy. The damping of the law gives e to 0.1 % or so;
        the energy goes with its square."""
        row, _, _, _ = self.meet((0.3, 0, 0), e=0.8)
        print("share of the energy that is dissipated:", row["dissipated_energy_mean"] / row["normal_energy_mean"],
              "against", 1 - 0.8 ** 2)
        self.assertAlmostEqual(row["dissipated_energy_mean"] / row["normal_energy_mean"], 1 - 0.8 ** 2, delta=2e-3)

    def test_coarse_grains(self):
        """The same impact of grains 3 times as large as the particles, at the same speeds: Hertz-Mindlin is self-similar,
        so energies go with 27, forces with 9, the duration with 3, to the digits of rounding over 3000 steps."""
        particle, _, _, _ = self.meet((0.5, 0.3, 0), e=0.7, mu=0.2)
        grain, _, _, _ = self.meet((0.5, 0.3, 0), e=0.7, mu=0.2, gap=3e-6, dt=3e-7, factor=3,
                                   contact="coarsegraining 3\nfix c all hertz/cg")
        for name, power in (("normal_energy", 3), ("tangential_energy", 3), ("dissipated_energy", 3), ("impact_speed", 0),
                            ("normal_force_peak", 2), ("tangential_force_peak", 2), ("duration", 1)):
            self.assertAlmostEqual(grain[f"{name}_mean"] / particle[f"{name}_mean"] / 3 ** power, 1.0, delta=1e-8, msg=name)
        # of grains, and of the particles that they stand for, would these meet as in a gas
        self.assertAlmostEqual(grain["frequency_per_particle_1"] / grain["frequency_per_grain_1"], 3, delta=1e-8)
        self.assertAlmostEqual(grain["particle_frequency_per_volume"] / grain["frequency_per_volume"], 81, delta=1e-7)

    def test_frozen_partner(self):
        """An immovable grain counts with no mass of its own in m*."""
        row, _, _, _ = self.meet((0.3, 0, 0), e=1.0, contact="group still id 2\nfix z still freeze\nfix c all hertz/cg")
        self.assertAlmostEqual(row["normal_energy_mean"] / (0.5 * mass(D, RHO) * 0.09), 1.0, delta=1e-9)

    def test_across_a_periodic_boundary(self):
        """A pair that meets at the corner of a periodic box is computed on each side of it, and counts once: serially
        and where the two grains are of one rank, of two and of four."""
        middle = self.meet((0.3, 0.1, 0.05), e=0.8)[0]
        self.data([(1, D, RHO, (0.02 - D / 2 - 1e-6, 1e-5, 1e-5), (0.3, 0.1, 0.05)),
                   (1, D, RHO, (D / 2, 1e-5, 1e-5), (0, 0, 0))], BOX)
        for ranks, processors in ((0, "* * *"), (2, "2 1 1"), (2, "1 2 1"), (4, "2 2 1")):
            with self.subTest(processors):
                self.liggghts(self.script("run 3000", dt=1e-7, e=0.8, processors=processors), ranks)
                row = self.rows()["all", "all"]
                self.assertEqual((row["collisions"], row["touching"], row["lost"]), (1, 0, 0))
                # the place in the box changes the last digits of distances, 1e-16 of 0.02 m against overlaps of 1e-5
                for name in ("normal_energy", "tangential_energy", "dissipated_energy", "normal_force_peak", "duration"):
                    self.assertAlmostEqual(row[f"{name}_mean"] / middle[f"{name}_mean"], 1.0, delta=1e-8, msg=name)

    def test_carried_to_other_ranks(self):
        """A pair that bounces while it is carried over borders of ranks, one after the other and together, and round the box:
        the same collision as in a box that moves along. Every 100 steps a run begins, at which grains change their rank,
        also in the middle of the 1500 steps in contact. Rounding of 6 m/s in differences of 0.3 m/s, and of places."""
        body = "run 3000 every 100 NULL"
        self.data([(1, D, RHO, (0.01 - D - 1e-6, 0.01, 0.01), (0.3, 0.1, 0.05)), (1, D, RHO, (0.01, 0.01, 0.01), (0, 0, 0))], BOX)
        self.liggghts(self.script(body, dt=1e-7, e=0.8))
        still = self.rows()["all", "all"]
        self.assertEqual(still["collisions"], 1)
        for start in (0.0096, 0.0196):
            for ranks, processors in ((0, "* * *"), (2, "2 1 1"), (4, "4 1 1")):
                with self.subTest(processors, start=start):
                    self.data([(1, D, RHO, (start - D - 1e-6, 0.01, 0.01), (6.3, 0.1, 0.05)), (1, D, RHO, (start, 0.01, 0.01), (6, 0, 0))],
                              BOX)
                    self.liggghts(self.script(body, dt=1e-7, e=0.8, processors=processors), ranks)
                    row = self.rows()["all", "all"]
                    self.assertEqual((row["collisions"], row["touching"], row["lost"]), (1, 0, 0))
                    for name in ("normal_energy", "tangential_energy", "dissipated_energy", "normal_force_peak", "duration"):
                        self.assertAlmostEqual(row[f"{name}_mean"] / still[f"{name}_mean"], 1.0, delta=1e-8, msg=name)

    def test_only_what_has_begun_in_sight(self):
        """Grains that touch when the run starts have no known beginning: they never count. A contact that goes on at
        the end is not over."""
        self.meet((0.3, 0, 0), gap=-1e-7)
        row = self.rows()["all", "all"]
        self.assertEqual((row["collisions"], row["touching"], row["lost"]), (0, 0, 0))
        row = self.meet((0.3, 0, 0), steps=200)[0]
        self.assertEqual((row["collisions"], row["touching"], row["lost"]), (0, 1, 0))

    def test_deleted_in_contact(self):
        self.data([(1, D, RHO, (0.01 - D - 1e-6, 0.01, 0.01), (0.3, 0, 0)), (1, D, RHO, (0.01, 0.01, 0.01), (0, 0, 0))], BOX)
        self.liggghts(self.script("run 200\ngroup one id 1\ndelete_atoms group one compress no\nrun 3000", dt=1e-7))
        row = self.rows()["all", "all"]
        self.assertEqual((row["collisions"], row["touching"], row["lost"]), (0, 0, 1))

    def test_same_motion_with_and_without(self):
        """Who looks on changes nothing, to the last digit."""
        self.meet((0.5, 0.3, -0.1), e=0.7)
        watched = (self.folder / "dump.txt").read_text()
        self.liggghts(self.script(DUMP.format(3000) + "run 3000", stats="", dt=1e-7, e=0.7))
        self.assertEqual(watched, (self.folder / "dump.txt").read_text())


if __name__ == "__main__":
    unittest.main()
