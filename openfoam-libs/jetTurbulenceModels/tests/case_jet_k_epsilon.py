# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""jetKEpsilon in stock pimpleFoam: equal to kEpsilon where it must be, and exact in homogeneous turbulence."""

# processors: 2

import math
import unittest

import grainjet
import homogeneous_box as box
from grainjet import dictionaries

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


CAVITY = {
    "system/blockMeshDict": """
vertices ((0 0 0)(1 0 0)(1 1 0)(0 1 0)(0 0 0.1)(1 0 0.1)(1 1 0.1)(0 1 0.1));
blocks (hex (0 1 2 3 4 5 6 7) (16 16 1) simpleGrading (1 1 1));
boundary
(
    lid { type wall; faces ((3 7 6 2)); }
    walls { type wall; faces ((0 4 7 3)(1 2 6 5)(0 1 5 4)); }
    frontAndBack { type empty; faces ((0 3 2 1)(4 5 6 7)); }
);
""",
    "system/decomposeParDict": "numberOfSubdomains 2; method simple; simpleCoeffs { n (2 1 1); delta 0.001; }",
    "system/controlDict": """
libs ("libjetTurbulenceModels.so");
startFrom startTime; startTime 0; stopAt endTime; endTime 0.1; deltaT 0.01;
writeControl timeStep; writeInterval 10; writePrecision 17; runTimeModifiable no;
""",
    "system/fvSchemes": """
ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { default Gauss linear; div(phi,U) Gauss linearUpwind grad(U); div(phi,k) Gauss upwind; div(phi,epsilon) Gauss upwind; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }
""",
    "system/fvSolution": """
solvers
{
    ".*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-9; relTol 0; }
    "p.*" { solver PCG; preconditioner DIC; tolerance 1e-9; relTol 0; }
}
PIMPLE { nCorrectors 2; pRefCell 0; pRefValue 0; }
""",
    "constant/transportProperties": "transportModel Newtonian; nu 1e-05;",
    "0/U": """dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField { lid { type fixedValue; value uniform (1 0 0); } walls { type noSlip; } frontAndBack { type empty; } }""",
    "0/p": """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { frontAndBack { type empty; } ".*" { type zeroGradient; } }""",
    "0/k": """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0.00325;
boundaryField { frontAndBack { type empty; } ".*" { type kqRWallFunction; value uniform 0.00325; } }""",
    "0/epsilon": """dimensions [0 2 -3 0 0 0 0]; internalField uniform 0.000765;
boundaryField { frontAndBack { type empty; } ".*" { type epsilonWallFunction; value uniform 0.000765; } }""",
    "0/nut": """dimensions [0 2 -1 0 0 0 0]; internalField uniform 0;
boundaryField { frontAndBack { type empty; } ".*" { type nutkWallFunction; value uniform 0; } }""",
}


class Cavity(grainjet.Case):
    """A driven cavity with walls, 10 steps: every written field compared byte for byte."""

    def fields(self, model, ranks, **coefficients):
        folder = self.folder/f"{model}{ranks}{len(coefficients)}"
        for name, text in CAVITY.items():
            kind = "volVectorField" if name == "0/U" else "volScalarField" if name.startswith("0/") else "dictionary"
            dictionaries.write(folder/name, text, kind)
        box.write_turbulence(folder, model, **coefficients)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.foam("pimpleFoam", folder, ranks=ranks)
        roots = sorted(folder.glob("processor*")) if ranks else [folder]
        return [(root/"0.1"/name).read_bytes() for root in roots for name in ("U", "p", "k", "epsilon", "nut")]

    def test_standard_coefficients_give_stock_k_epsilon_bit_for_bit(self):
        for ranks in (0, 2):
            stock = self.fields("kEpsilon", ranks)
            self.assertEqual(stock, self.fields("jetKEpsilon", ranks, C1=1.44, C2=1.92, roundJetCorrection="none"))
            self.assertNotEqual(stock, self.fields("jetKEpsilon", ranks), "the defaults must differ")


if __name__ == "__main__":
    unittest.main()
