# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A one-cell box with a frozen, uniform velocity gradient in stock pimpleFoam.

With no gradients of k and epsilon the turbulence model reduces to its two source
terms, which have exact solutions. The pressure equation is not solved, so the flow
stays what it is given as.
"""

import re
import shutil

HEADER = "FoamFile {{ version 2.0; format ascii; class {0}; object {1}; }}\n"

# patch name: (vertices of the face, its centre), box from -0.5 to 0.5
FACES = {
    "xMin": ("0 4 7 3", (-0.5, 0, 0)), "xMax": ("1 2 6 5", (0.5, 0, 0)),
    "yMin": ("0 1 5 4", (0, -0.5, 0)), "yMax": ("3 7 6 2", (0, 0.5, 0)),
    "zMin": ("0 3 2 1", (0, 0, -0.5)), "zMax": ("4 5 6 7", (0, 0, 0.5)),
}


def vector(values):
    return "(" + " ".join(repr(float(v)) for v in values) + ")"


def turbulence(model, **coefficients):
    """The text of turbulenceProperties."""
    entries = " ".join(f"{key} {value};" for key, value in coefficients.items())
    return (HEADER.format("dictionary", "turbulenceProperties")
            + "simulationType RAS;\n"
            + f"RAS {{ RASModel {model}; turbulence on; printCoeffs on;"
            + f" {model}Coeffs {{ {entries} }} }}\n")


def write(folder, model, gradient, k, epsilon, dt, steps, **coefficients):
    """Write the case; gradient[i][j] = dU_i/dx_j in 1/s, SI units throughout."""
    shutil.rmtree(folder / "postProcessing", ignore_errors=True)
    for name in ("0", "constant", "system"):
        (folder / name).mkdir(exist_ok=True)

    corners = " ".join(
        f"({x} {y} {z})" for z in (-0.5, 0.5)
        for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)))
    patches = "\n".join(
        f"{name} {{ type patch; faces (({face})); }}" for name, (face, _) in FACES.items())
    (folder / "system/blockMeshDict").write_text(
        HEADER.format("dictionary", "blockMeshDict")
        + f"vertices ({corners});\nblocks (hex (0 1 2 3 4 5 6 7) (1 1 1) simpleGrading (1 1 1));\n"
        + f"boundary (\n{patches}\n);\n")

    velocity = "\n".join(
        f"{name} {{ type fixedValue; value uniform "
        + vector(sum(row[j]*centre[j] for j in range(3)) for row in gradient) + "; }"
        for name, (_, centre) in FACES.items())
    (folder / "0/U").write_text(
        HEADER.format("volVectorField", "U") + "dimensions [0 1 -1 0 0 0 0];\n"
        + "internalField uniform (0 0 0);\nboundaryField {\n" + velocity + "\n}\n")
    for name, dimensions, value, kind in (
            ("p", "[0 2 -2 0 0 0 0]", 0, "zeroGradient"),
            ("k", "[0 2 -2 0 0 0 0]", k, "zeroGradient"),
            ("epsilon", "[0 2 -3 0 0 0 0]", epsilon, "zeroGradient"),
            ("nut", "[0 2 -1 0 0 0 0]", 0, "calculated")):
        (folder / "0" / name).write_text(
            HEADER.format("volScalarField", name)
            + f"dimensions {dimensions};\ninternalField uniform {value};\n"
            + f"boundaryField {{ \".*\" {{ type {kind}; value uniform {value}; }} }}\n")

    (folder / "constant/transportProperties").write_text(
        HEADER.format("dictionary", "transportProperties")
        + "transportModel Newtonian; nu 1e-05;\n")
    (folder / "constant/turbulenceProperties").write_text(turbulence(model, **coefficients))
    (folder / "system/controlDict").write_text(
        HEADER.format("dictionary", "controlDict")
        + 'libs ("libjetTurbulenceModels.so");\napplication pimpleFoam;\n'
        + f"startFrom startTime; startTime 0; stopAt endTime; endTime {dt*steps!r};\n"
        + f"deltaT {dt!r}; writeControl timeStep; writeInterval {steps};\n"
        + "writePrecision 16; timePrecision 10; runTimeModifiable no;\n"
        + """functions
{
    history
    {
        type        volFieldValue;
        libs        ("libfieldFunctionObjects.so");
        regionType  all;
        operation   average;
        fields      (k epsilon);
        writeFields no;
        writePrecision 16;
        log         no;
    }
}
""")
    (folder / "system/fvSchemes").write_text(
        HEADER.format("dictionary", "fvSchemes")
        + "ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }\n"
        + "divSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear corrected; }\n"
        + "interpolationSchemes { default linear; } snGradSchemes { default corrected; }\n")
    (folder / "system/fvSolution").write_text(
        HEADER.format("dictionary", "fvSolution")
        + "solvers { \".*\" { solver smoothSolver; smoother GaussSeidel;"
        + " tolerance 1e-15; relTol 0; minIter 1; maxIter 3; } }\n"
        + "PIMPLE { momentumPredictor no; nCorrectors 0; nOuterCorrectors 1;"
        + " pRefCell 0; pRefValue 0; }\n")


def history(folder):
    """Columns t, k, epsilon of the run, without the initial state."""
    text = (folder / "postProcessing/history/0/volFieldValue.dat").read_text()
    rows = [re.split(r"\s+", line.strip()) for line in text.splitlines() if line[0] != "#"]
    return [[float(value) for value in row[:3]] for row in rows]
