# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""jetKEpsilon in stock pimpleFoam: equal to kEpsilon where it must be, and exact in homogeneous turbulence."""

# processors: 2

import math
import unittest

import grainjet
import homogeneous_box as box
import lid_cavity

REST = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]


class Homogeneous(grainjet.Case):

    def evolve(self, model, gradient, k, epsilon, dt, steps, **coefficients):
        box.write(self.folder, model, gradient, k, epsilon, dt, steps, **coefficients)
        self.foam("blockMesh")
        self.log = self.foam("pimpleFoam").output
        return box.history(self.folder)

    def test_defaults_are_shown_in_the_log(self):
        self.evolve("jetKEpsilon", REST, 1, 1, 0.1, 1)
        for entry in ("C1              1.52;", "C2              1.9;", "C3              0.79;",
                      "roundJetCorrection none;", "Cmu             0.09;"):
            self.assertIn(entry, self.log)

    def test_decay_exponent(self):
        # k ~ (t + t0)^-n, n = 1/(C2 - 1), while k/epsilon grows as t + t0. The error of the
        # implicit steps is linear in dt epsilon/k (below 0.002 here) and removed by halving
        # the step; its square, times a factor of order 10, is left.
        for coefficients, exponent in (({}, 1/0.90), ({"C1": 1.44, "C2": 1.92}, 1/0.92)):
            slopes = []
            for dt, steps in ((0.01, 1000), (0.005, 2000)):
                rows = self.evolve("jetKEpsilon", REST, 1, 1, dt, steps, **coefficients)
                (_, k1, epsilon1), (_, k2, epsilon2) = rows[steps//2 - 1], rows[-1]
                slopes.append(-math.log(k2/k1)/math.log(k2*epsilon1/(epsilon2*k1)))
            self.assertAlmostEqual((2*slopes[1] - slopes[0])/exponent, 1, delta=5e-5)

    def test_homogeneous_shear(self):
        # P/epsilon tends to (C2 - 1)/(C1 - 1), P = Cmu k^2/epsilon S^2. The eigenvalue
        # of the approach makes the remainder e^-(St/5); the split, implicit steps
        # of S dt = 0.02 leave an error of the order of that step.
        shear = [[0, 1, 0], [0, 0, 0], [0, 0, 0]]
        for coefficients, ratio in (({}, 0.90/0.52), ({"C1": 1.44, "C2": 1.92}, 0.92/0.44)):
            rows = self.evolve("jetKEpsilon", shear, 1, 0.2, 0.02, 2000, **coefficients)
            _, k, epsilon = rows[-1]
            self.assertAlmostEqual(0.09*(k/epsilon)**2/ratio, 1, delta=0.02)

    def test_pope_term_in_a_stretched_vortex(self):
        # rotation about z at rate w (curl 2w), stretched (a > 0) or squashed along z:
        # chi epsilon/k = (k/epsilon)^2 (2w)^2 a/4. The first step changes ln(epsilon)
        # by dt times that more than without the term; higher terms are of order dt.
        w, k, epsilon, dt = 3.0, 1.0, 2.0, 1e-5
        for a in (0.5, -0.5):
            gradient = [[-a/2, -w, 0], [w, -a/2, 0], [0, 0, a]]
            with_term = self.evolve("jetKEpsilon", gradient, k, epsilon, dt, 1, roundJetCorrection="Pope")
            without = self.evolve("jetKEpsilon", gradient, k, epsilon, dt, 1)
            change = math.log(with_term[0][2]/without[0][2])/dt
            expected = 0.79*(k/epsilon)**2*w**2*a
            self.assertAlmostEqual(change/expected, 1, delta=1e-3)
            self.assertEqual(with_term[0][1] < without[0][1], a > 0)

    def test_pope_factor_is_read_and_is_not_the_compression_coefficient(self):
        gradient = [[0.5, -3, 0], [3, -0.25, 0], [0, 0, 1]]      # not solenoidal
        none = self.evolve("jetKEpsilon", gradient, 1, 2, 1e-3, 1, roundJetCorrection="none", C3=5)
        stock = self.evolve("kEpsilon", gradient, 1, 2, 1e-3, 1, C1=1.52, C2=1.90)
        self.assertEqual(none, stock)
        once = self.evolve("jetKEpsilon", gradient, 1, 2, 1e-6, 1, roundJetCorrection="Pope", C3=0.2)
        twice = self.evolve("jetKEpsilon", gradient, 1, 2, 1e-6, 1, roundJetCorrection="Pope", C3=0.4)
        off = self.evolve("jetKEpsilon", gradient, 1, 2, 1e-6, 1, roundJetCorrection="Pope", C3=0)
        ratio = math.log(twice[0][2]/off[0][2])/math.log(once[0][2]/off[0][2])
        self.assertAlmostEqual(ratio, 2, delta=1e-4)             # round-off of ln(1 + 1e-6)

    def test_pope_term_is_zero_in_plane_flow(self):
        plane = [[0.7, 2, 0], [-1.5, -0.7, 0], [0, 0, 0]]
        self.assertEqual(
            self.evolve("jetKEpsilon", plane, 1, 1, 0.01, 20, roundJetCorrection="Pope"),
            self.evolve("jetKEpsilon", plane, 1, 1, 0.01, 20))

    def test_unknown_correction_lists_the_valid_ones(self):
        box.write(self.folder, "jetKEpsilon", REST, 1, 1, 0.1, 1, roundJetCorrection="Popper")
        self.foam("blockMesh")
        self.assertFails(self.foam("pimpleFoam", check=False),
                         "roundJetCorrection", "Popper", "none", "Pope", "turbulenceProperties")


class Cavity(lid_cavity.Comparison):

    def test_pimpleFoam(self):
        self.prepare("pimpleFoam")
        self.compare()


if __name__ == "__main__":
    unittest.main()
