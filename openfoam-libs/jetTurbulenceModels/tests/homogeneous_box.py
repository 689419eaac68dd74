# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A one-cell box with a frozen, uniform velocity gradient in stock pimpleFoam.

With no gradients of k and epsilon the turbulence model reduces to its two source
terms, which have exact solutions. The pressure equation is not solved, so the flow
stays what it is given as.
"""

import shutil

import numpy

from grainjet import dictionaries

# the centre of each side of the box from -0.5 to 0.5
CENTRES = {"xlo": (-0.5, 0, 0), "xhi": (0.5, 0, 0), "ylo": (0, -0.5, 0), "yhi": (0, 0.5, 0), "zlo": (0, 0, -0.5),
           "zhi": (0, 0, 0.5)}


def write_turbulence(folder, model, **coefficients):
    """Write turbulenceProperties."""
    dictionaries.write(folder / "constant/turbulenceProperties",
                       f"simulationType RAS;\nRAS {{ RASModel {model}; turbulence on; printCoeffs on; "
                       f"{model}Coeffs {{ {dictionaries.entries(coefficients)} }} }}")


def write(folder, model, gradient, k, epsilon, dt, steps, **coefficients):
    """Write the case; gradient[i][j] = dU_i/dx_j in 1/s, SI units throughout."""
    shutil.rmtree(folder / "postProcessing", ignore_errors=True)
    dictionaries.write(folder / "system/blockMeshDict", dictionaries.block(
        (-0.5, -0.5, -0.5), (0.5, 0.5, 0.5), "1 1 1", {side: ("patch", side) for side in CENTRES}))
    dictionaries.write_field(folder, "U", "0 1 -1", "(0 0 0)", {
        side: "type fixedValue; value uniform "
        + dictionaries.vector([sum(row[j]*centre[j] for j in range(3)) for row in gradient]) + ";"
        for side, centre in CENTRES.items()})
    for name, dimensions, value, kind in (
            ("p", "0 2 -2", 0, "zeroGradient"), ("k", "0 2 -2", k, "zeroGradient"),
            ("epsilon", "0 2 -3", epsilon, "zeroGradient"), ("nut", "0 2 -1", 0, "calculated")):
        dictionaries.write_field(folder, name, dimensions, value, {".*": f"type {kind}; value uniform {value};"})
    write_turbulence(folder, model, **coefficients)
    dictionaries.write_all(folder, {
        "constant/transportProperties": "transportModel Newtonian; nu 1e-05;",
        "system/controlDict": f"""libs ("libjetTurbulenceModels.so");
application pimpleFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime {dt*steps!r};
deltaT {dt!r}; writeControl timeStep; writeInterval {steps};
writePrecision 16; timePrecision 10; runTimeModifiable no;
functions
{{
    history
    {{
        type        volFieldValue;
        libs        ("libfieldFunctionObjects.so");
        regionType  all;
        operation   average;
        fields      (k epsilon);
        writeFields no;
        writePrecision 16;
        log         no;
    }}
}}
""",
        "system/fvSchemes": """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }
""",
        "system/fvSolution": """solvers { ".*" { solver smoothSolver; smoother GaussSeidel; tolerance 1e-15; relTol 0; minIter 1; maxIter 3; } }
PIMPLE { momentumPredictor no; nCorrectors 0; nOuterCorrectors 1; pRefCell 0; pRefValue 0; }
"""})


def history(folder):
    """Columns t, k, epsilon of the run, without the initial state."""
    return numpy.loadtxt(folder / "postProcessing/history/0/volFieldValue.dat", ndmin=2)[:, :3].tolist()
