# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pope's correction from a uniform start: a round jet in a slow co-flow on a wedge, in stock simpleFoam."""
# label: long

import math
import re
import unittest

import numpy

import grainjet
import homogeneous_box as box
from grainjet import dictionaries

COFLOW = 0.01            # of the jet's velocity, 1 m/s; diameter 1 m
NX, NR = 48, (6, 20)     # cells along the axis, in the nozzle's radius and outside
SLOPE = math.tan(math.radians(2.5))
C2 = 1.92


def write_field(folder, name, dimensions, inside, inlet, coflow, vector=False):
    def wrap(value):
        return f"({value} 0 0)" if vector else str(value)
    side = "pressureInletOutletVelocity; value" if vector else f"inletOutlet; inletValue uniform {coflow}; value"
    dictionaries.write_field(folder, name, dimensions, wrap(inside), {
        "inlet": f"type fixedValue; value uniform {wrap(inlet)};",
        "coflow": f"type fixedValue; value uniform {wrap(coflow)};",
        "side": f"type {side} uniform {wrap(coflow)};",
        "outlet": f"type inletOutlet; inletValue uniform {wrap(0 if vector else coflow)}; value uniform {wrap(coflow)};",
        "front|back": "type wedge;", "axis": "type empty;"})


def write(folder, iterations, correction, k=1e-4, epsilon=1e-5, velocity=COFLOW):
    """The case; k, epsilon and velocity [SI] are those of the start."""
    points = ["(0 0 0)", "(40 0 0)"]
    for x, r in ((0, 0.5), (0, 12), (40, 1.2), (40, 12)):
        points += [f"({x} {r} {side*r*SLOPE})" for side in (-1, 1)]
    texts = {
        "system/blockMeshDict": f"""vertices ({" ".join(points)});
blocks
(
    hex (0 1 6 2 0 1 7 3) ({NX} {NR[0]} 1) simpleGrading (8 1 1)
    hex (2 6 8 4 3 7 9 5) ({NX} {NR[1]} 1) simpleGrading (8 12 1)
);
boundary
(
    inlet {{ type patch; faces ((0 2 3 0)); }}
    coflow {{ type patch; faces ((2 4 5 3)); }}
    outlet {{ type patch; faces ((1 6 7 1) (6 8 9 7)); }}
    side {{ type patch; faces ((4 8 9 5)); }}
    front {{ type wedge; faces ((0 1 6 2) (2 6 8 4)); }}
    back {{ type wedge; faces ((0 1 7 3) (3 7 9 5)); }}
    axis {{ type empty; faces ((0 1 1 0)); }}
);
""",
        "system/fvSchemes": """ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }
divSchemes
{
    default none; div(phi,U) bounded Gauss linearUpwind grad(U); div(phi,k) bounded Gauss upwind;
    div(phi,epsilon) bounded Gauss upwind; div((nuEff*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }
""",
        "system/fvSolution": """solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-10; relTol 0.02; }
    "(U|k|epsilon)" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0.05; }
}
SIMPLE { nNonOrthogonalCorrectors 0; consistent no; }
relaxationFactors { fields { p 0.3; } equations { U 0.7; k 0.7; epsilon 0.7; } }
""",
        "constant/transportProperties": "transportModel Newtonian; nu 1e-5;",
    }
    dictionaries.write_all(folder, texts)
    write_field(folder, "U", "0 1 -1", velocity, 1, COFLOW, vector=True)
    write_field(folder, "k", "0 2 -2", k, 0.00375, 1e-6)
    write_field(folder, "epsilon", "0 2 -3", epsilon, 0.00054, 1e-7)
    ends = {"front|back": "type wedge;", "axis": "type empty;"}
    dictionaries.write_field(folder, "nut", "0 2 -1", 1e-3, {".*": "type calculated; value uniform 0;", **ends})
    dictionaries.write_field(folder, "p", "0 2 -2", 0, {
        ".*": "type zeroGradient;", **ends, "outlet": "type fixedValue; value uniform 0;",
        "side": "type totalPressure; p0 uniform 0;"})
    control(folder, iterations, correction)


def control(folder, iterations, correction):
    box.write_turbulence(folder, "jetKEpsilon", C1=1.44, C2=C2, roundJetCorrection=correction)
    dictionaries.write(folder/"system/controlDict", f"""
startFrom latestTime; stopAt endTime; endTime {iterations}; deltaT 1;
writeControl timeStep; writeInterval {iterations}; writePrecision 12; runTimeModifiable no;
libs ("libjetTurbulenceModels.so");
DebugSwitches {{ jetKEpsilon 1; }}
""")


def values(folder, time, name):
    """The internal field, one row per cell."""
    return numpy.array(dictionaries.internal(folder/str(time)/name))


class PopeStart(grainjet.Case):

    def solve(self, folder):
        self.foam("blockMesh", folder)
        return self.foam("simpleFoam", folder).output

    def test_cold_start_reaches_the_field_of_a_warm_start(self):
        cold, warm = self.folder/"cold", self.folder/"warm"
        write(cold, 700, "Pope")
        log = self.solve(cold)
        write(warm, 300, "none")
        self.solve(warm)
        control(warm, 1000, "Pope")
        self.foam("simpleFoam", warm)

        # What 700 iterations leave: 5e-5 of U, less of k and epsilon. Without the correction
        # k differs by a third.
        for name, tolerance in (("U", 5e-4), ("k", 1e-5), ("epsilon", 1e-5)):
            a, b = values(cold, 700, name), values(warm, 1000, name)
            self.assertLess(abs(a - b).max()/abs(a).max(), tolerance, name)
        self.assertGreater(abs(values(cold, 700, "k") - values(warm, 300, "k")).max(), 1e-3)

        # The limit is what the start needs and the converged jet does not
        lines = re.findall(r"C3 chi from (\S+) to (\S+), limited in (\d+) of (\d+) cells", log)
        self.assertEqual(len(lines), 700)
        self.assertGreater(max(int(line[2]) for line in lines), 10)
        low, high, limited, cells = map(float, lines[-1])
        self.assertEqual((limited, cells), (0, NX*sum(NR)))
        self.assertLess(max(-low, high), C2 - 1)
        self.assertGreater(high, 0.1)

    def test_other_starts(self):
        # from rest, with k/epsilon from 1e-4 s to 1e3 s: one and the same field. 500 iterations
        # leave 1e-8 of the largest k.
        largest = []
        for k, epsilon in ((1e-8, 1e-4), (1e-6, 1e-8), (1e-4, 1e-7)):
            folder = self.folder/f"k{k}"
            write(folder, 500, "Pope", k=k, epsilon=epsilon, velocity=0)
            self.solve(folder)
            largest.append(values(folder, 500, "k").max())
        self.assertLess(max(largest)/min(largest) - 1, 1e-6)


if __name__ == "__main__":
    unittest.main()
