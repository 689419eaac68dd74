# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""jetKEpsilon with a density: equal to kEpsilon in stock compressible solvers, and exact in a homogeneous gas."""

# processors: 2

import math
import unittest

import grainjet
import homogeneous_box as box
import lid_cavity


class Cavity(lid_cavity.Comparison):

    def test_rhoPimpleFoam(self):
        self.prepare("rhoPimpleFoam")
        self.compare()

    def test_buoyantPimpleFoam(self):
        self.prepare("buoyantPimpleFoam")
        self.compare()


class Homogeneous(grainjet.Case):

    def evolve(self, gradient, k, epsilon, dt, steps, **coefficients):
        box.write(self.folder, "jetKEpsilon", gradient, k, epsilon, dt, steps, density=4, **coefficients)
        self.foam("blockMesh")
        self.foam("rhoPimpleFoam")
        return box.history(self.folder)

    def test_all_terms_in_a_gas_that_expands(self):
        # A vortex about z at rate w, strained at the rates a, b, c along x, y, z: each term of
        # the two equations divided by rho k and rho epsilon. Terms of second order are dt times a rate.
        w, k, epsilon, dt = 3.0, 1.0, 2.0, 1e-5
        for a, b, c in ((-0.25, -0.25, 0.5), (0.3, 0.1, 0.6), (-0.4, -0.1, -0.5)):
            divergence, strain = a + b + c, [rate - (a + b + c)/3 for rate in (a, b, c)]
            production = 0.09*k/epsilon*sum(2*s*rate for s, rate in zip(strain, (a, b, c)))      # over k
            for C1, C2, C3 in ((1.52, 1.90, 0), (1.44, 1.92, 0.79)):
                (_, k1, epsilon1), = self.evolve(
                    [[a, -w, 0], [w, b, 0], [0, 0, c]], k, epsilon, dt, 1, C1=C1, C2=C2, C3=C3, roundJetCorrection="Pope")
                # C3 chi epsilon/k, chi = (k/epsilon)^3 (1/4) omega.S.omega, omega = (0, 0, 2w)
                pope = C3*(k/epsilon)**2*w**2*c
                rate_k = production - epsilon/k - 2/3*divergence
                rate_epsilon = C1*production - C2*epsilon/k - 2/3*C1*divergence + pope
                self.assertAlmostEqual(math.log(k1/k)/dt/rate_k, 1, delta=1e-3)
                self.assertAlmostEqual(math.log(epsilon1/epsilon)/dt/rate_epsilon, 1, delta=1e-3)

    def test_pope_term_is_zero_in_plane_flow_that_expands(self):
        plane = [[0.7, 2, 0], [-1.5, 0.4, 0], [0, 0, 0]]
        self.assertEqual(self.evolve(plane, 1, 1, 0.01, 20, roundJetCorrection="Pope"), self.evolve(plane, 1, 1, 0.01, 20))


if __name__ == "__main__":
    unittest.main()
