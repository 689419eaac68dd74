# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Both libraries in stock DPMFoam: phase-weighted jetKEpsilon, and sampling of its cloud."""

import unittest

import numpy

import ballistic_stream as stream
import grainjet
from grainjet import dictionaries

END = 0.2


def write_field(folder, name, dimensions, inlet, sides="type zeroGradient;"):
    dictionaries.write_field(folder, name, dimensions, inlet, {
        "inlet": f"type fixedValue; value uniform {inlet};", "outlet": "type zeroGradient;", "sides": sides})


class DPMFoam(grainjet.Case):

    def run_case(self, name, model, coefficients=""):
        folder = self.folder/name
        stream.write(folder, END, ends={"inlet": "zlo", "outlet": "zhi"},
                     functions=stream.sampling(planes="(2 6)"))
        dictionaries.change(folder/"system/controlDict",
                            ("startFrom", 'libs ("libjetTurbulenceModels.so");\nstartFrom'))
        dictionaries.write_all(folder, {
            "constant/transportProperties": "continuousPhase air; rho.air 1.2; transportModel Newtonian; nu 1e-05;",
            "constant/turbulenceProperties.air":
                "simulationType RAS; RAS { RASModel %s; turbulence on; printCoeffs on; %sCoeffs { %s } }"
                % (model, model, coefficients),
            "system/fvSchemes": """
ddtSchemes { default Euler; } gradSchemes { default Gauss linear; } divSchemes { default Gauss upwind;
div(((alpha.air*nuEff.air)*dev2(T(grad(U.air))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }
snGradSchemes { default corrected; }""",
            "system/fvSolution": """
solvers { ".*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-9; relTol 0; }
"p.*" { solver PCG; preconditioner DIC; tolerance 1e-9; relTol 0; } }
PIMPLE { nCorrectors 2; }"""})
        dictionaries.change(
            folder/"constant/kinematicCloudProperties",
            ("coupled false;", "coupled true; sourceTerms { schemes { U semiImplicit 1; } }"),
            ("interpolationSchemes { rho cell; U cell; mu cell; }",
             "interpolationSchemes { rho.air cell; U.air cell; mu.air cell; }"),
            ("constantProperties {", "constantProperties { alphaMax 0.9;"),
            ("particleForces {}", "particleForces { sphereDrag; }"))
        (folder/"0/U").unlink()
        write_field(folder, "U.air", "0 1 -1", "(0 0 2)", "type noSlip;")
        write_field(folder, "k.air", "0 2 -2", 0.02, "type kqRWallFunction; value uniform 0.02;")
        write_field(folder, "epsilon.air", "0 2 -3", 0.06, "type epsilonWallFunction; value uniform 0.06;")
        dictionaries.write_field(folder, "nut.air", "0 2 -1", 0, {
            "sides": "type nutkWallFunction; value uniform 0;", "inlet|outlet": "type calculated; value uniform 0;"})
        dictionaries.write_field(folder, "p", "0 2 -2", 0, {
            "outlet": "type fixedValue; value uniform 0;",
            "inlet|sides": "type fixedFluxPressure; phi phi.air; value uniform 0;"})
        self.foam("blockMesh", folder)
        self.log = self.foam("DPMFoam", folder).output
        return folder

    def test_model_and_sampling(self):
        fields = ["U.air", "k.air", "epsilon.air", "nut.air"]
        stock = self.run_case("stock", "kEpsilon")
        same = self.run_case("same", "jetKEpsilon", "C1 1.44; C2 1.92;")
        other = self.run_case("other", "jetKEpsilon", "roundJetCorrection Pope;")
        for field in fields:
            first, second, third = ((case/f"{END}"/field).read_bytes() for case in (stock, same, other))
            self.assertEqual(first, second, field)
            self.assertNotEqual(first, third, field)
        self.assertIn("Selecting RAS turbulence model jetKEpsilon", self.log)
        for case in (stock, same):
            crossings = numpy.loadtxt(case/"postProcessing/profiles/0/plane_2D.dat")[:, 1].sum()
            # The 5 fast injectors cross in each of the 20 steps; the 13 at the axis, above
            # 1.87 m/s in air of about 2 m/s, need 0.1 s and cross in the other half
            self.assertGreater(crossings, 200)


if __name__ == "__main__":
    unittest.main()
