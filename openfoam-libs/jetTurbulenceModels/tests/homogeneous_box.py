# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A one-cell box with a frozen, uniform velocity gradient in stock pimpleFoam or rhoPimpleFoam.

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


def write_turbulence(folder, model, name="turbulenceProperties", **coefficients):
    """Write turbulenceProperties."""
    dictionaries.write(folder / "constant" / name,
                       f"simulationType RAS;\nRAS {{ RASModel {model}; turbulence on; printCoeffs on; "
                       f"{model}Coeffs {{ {dictionaries.entries(coefficients)} }} }}")


def write_gas(folder, density):
    """Write what rhoPimpleFoam needs instead of p and nu: a gas of that density [kg/m3] at 1 bar and 300 K."""
    dictionaries.write(folder / "constant/thermophysicalProperties", f"""
thermoType
{{
    type hePsiThermo; mixture pureMixture; transport const; thermo hConst;
    equationOfState perfectGas; specie specie; energy sensibleInternalEnergy;
}}
mixture
{{
    specie {{ molWeight {density*8314.47*300/1e5}; }} thermodynamics {{ Cp 1005; Hf 0; }} transport {{ mu 1.8e-05; Pr 0.7; }}
}}
""")
    for name, dimensions, value, kind in (("T", "[0 0 0 1 0 0 0]", 300, "zeroGradient"), ("p", "1 -1 -2", 1e5, "zeroGradient"),
                                          ("alphat", "1 -1 -1", 0, "calculated")):
        dictionaries.write_field(folder, name, dimensions, value, {".*": f"type {kind}; value uniform {value};"})


def write(folder, model, gradient, k, epsilon, dt, steps, density=None, **coefficients):
    """Write the case; gradient[i][j] = dU_i/dx_j in 1/s, SI units throughout. With a density it is one for rhoPimpleFoam."""
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
    if density:
        write_gas(folder, density)
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
