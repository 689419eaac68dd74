# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The power-law inlet of docs/theory-turbulence.md as stock exprFixedValue: serial, parallel, after a restart."""

# processors: 2

import re
import unittest

import numpy

import grainjet
from grainjet import dictionaries

R, MEAN, N = 0.0075, 13.0, 7
PEAK = MEAN*(N + 1)*(2*N + 1)/(2*N**2)        # Eq. (23)
SIDE = 9                                      # faces along a side of the square inlet


def profile(r):
    return PEAK*numpy.maximum(1 - r/R, 0)**(1/N)


class Inlet(grainjet.Case):

    def write(self, folder):
        dictionaries.write_all(folder, {
            "system/blockMeshDict": dictionaries.block(
                (-R, -R, 0), (R, R, 0.03), f"{SIDE} {SIDE} 4",
                {"inlet": ("patch", "zlo"), "outlet": ("patch", "zhi"), "sides": ("patch", "xlo xhi ylo yhi")}),
            "system/decomposeParDict": "numberOfSubdomains 2; method simple; simpleCoeffs { n (2 1 1); delta 0.001; }",
            "system/fvSchemes": """
ddtSchemes { default Euler; } gradSchemes { default Gauss linear; } divSchemes { default Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }
snGradSchemes { default corrected; }""",
            "system/fvSolution": """
solvers { ".*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; }
"p.*" { solver PCG; preconditioner DIC; tolerance 1e-8; relTol 0; } }
PIMPLE { nCorrectors 2; }""",
            "constant/transportProperties": "transportModel Newtonian; nu 1.5e-05;",
            "constant/turbulenceProperties": "simulationType laminar;"})
        dictionaries.write_field(folder, "U", "0 1 -1", "(0 0 0)", {
            "inlet": 'type exprFixedValue; value uniform (0 0 0); valueExpr "vector(0, 0, '
                     f'{PEAK!r}*pow(max(1 - sqrt(sqr(pos().x()) + sqr(pos().y()))/{R}, 0), {1/N!r}))";',
            "outlet": "type zeroGradient;", "sides": "type slip;"})
        dictionaries.write_field(folder, "p", "0 2 -2", 0, {
            "outlet": "type fixedValue; value uniform 0;", "inlet|sides": "type zeroGradient;"})

    def control(self, folder, end):
        dictionaries.write(
            folder/"system/controlDict",
            f"startFrom latestTime; startTime 0; stopAt endTime; endTime {end}; deltaT 1e-5; writeControl timeStep;\n"
            "writeInterval 2; writePrecision 12; timePrecision 8; runTimeModifiable no;")

    def inlet(self, folder, time):
        text = (folder/time/"U").read_text()
        patch = text[text.index("    inlet"):text.index("    outlet")]
        values = patch[patch.rindex("List<vector>"):]
        return numpy.array(re.findall(r"\n\((\S+) (\S+) (\S+)\)", values), dtype=float)

    def test_formula_has_the_mean(self):
        edges = numpy.linspace(0, 1, 200001)**3      # fine at the wall, where the profile is steep
        r = R*(1 - edges)
        middle = 0.5*(r[1:] + r[:-1])
        mean = (profile(middle)*abs(r[1:]**2 - r[:-1]**2)).sum()/R**2
        self.assertAlmostEqual(mean/MEAN, 1, delta=1e-7)

    def test_serial_parallel_restart(self):
        centres = (numpy.arange(SIDE) + 0.5)/SIDE*2*R - R
        y, x = numpy.meshgrid(centres, centres)
        expected = numpy.sort(profile(numpy.hypot(x, y)).ravel())
        for ranks in (0, 2):
            folder = self.folder/f"ranks{ranks}"
            self.write(folder)
            self.control(folder, 2e-5)
            self.foam("blockMesh", folder)
            if ranks:
                self.foam("decomposePar", folder)
            for end in (2e-5, 4e-5):                 # the second is a restart
                self.control(folder, end)
                self.foam("pimpleFoam", folder, ranks=ranks)
                if ranks:
                    self.foam("reconstructPar", folder)
                got = self.inlet(folder, f"{end:.0e}")
                self.assertEqual(len(got), SIDE**2)
                self.assertEqual(abs(got[:, :2]).max(), 0)
                # 12 digits written
                numpy.testing.assert_allclose(numpy.sort(got[:, 2]), expected, rtol=1e-10, atol=1e-10)


if __name__ == "__main__":
    unittest.main()
