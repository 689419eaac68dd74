# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing, running and reading small axisymmetric cases of the incompressible solvers.

The axis is x; the mesh is a wedge of one cell about it, half on either side of z = 0.
"""

import math
import re
import shutil
import subprocess

import numpy

import grainjet
from grainjet import dictionaries

HALF_ANGLE = math.radians(2.5)

#: the models compared: name -> coefficients of jetKEpsilon
MODELS = {
    "standard": "C1 1.44; C2 1.92;",
    "modified": "",
    "Pope": "C1 1.44; C2 1.92; roundJetCorrection Pope;",
}

SCHEMES = """
ddtSchemes { default steadyState; }
gradSchemes { default Gauss linear; limited cellLimited Gauss linear 1; }
divSchemes
{
    default none;
    div(phi,U) bounded Gauss linearUpwind limited;
    div(phi,k) bounded Gauss limitedLinear 1;
    div(phi,epsilon) bounded Gauss limitedLinear 1;
    div((nuEff*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""

SOLUTION = """
solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-12; relTol 0.01; }
    "(U|k|epsilon)" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; relTol 0.01; minIter 1; }
}
SIMPLE
{
    nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0;
    residualControl { "(p|U|k|epsilon)" %(residual)g; }
}
relaxationFactors { fields { p 0.2; } equations { U %(relax)g; "(k|epsilon)" %(relax)g; } }
"""


def write_control(case, iterations, functions=""):
    dictionaries.write(case/"system/controlDict",
                     'libs ("libjetTurbulenceModels.so");\nstartFrom latestTime; startTime 0; stopAt endTime;\n'
                     f"endTime {iterations}; deltaT 1; writeControl timeStep; writeInterval {iterations};\n"
                     "purgeWrite 1; writePrecision 10; runTimeModifiable no;\n"
                     f"functions {{ {functions} }}")


def write_system(case, model, nu, residual=1e-7, relax=0.5):
    """Everything but mesh, fields and schemes."""
    write_control(case, 1)
    dictionaries.write(case/"system/fvSolution", SOLUTION % {"residual": residual, "relax": relax})
    dictionaries.write(case/"constant/transportProperties", f"transportModel Newtonian; nu {nu!r};")
    dictionaries.write(case/"constant/turbulenceProperties",
                     "simulationType RAS;\nRAS { RASModel jetKEpsilon; turbulence on; printCoeffs on; "
                     f"jetKEpsilonCoeffs {{ {MODELS[model]} }} }}")


def run(case, *command):
    """Run a program in a case, out of the way of others; output goes to log.<program>."""
    log = case/f"log.{command[0]}"
    with log.open("w") as output:
        code = subprocess.run(["nice", "-n", "19", *command], cwd=case, env=grainjet.ENV, stdout=output,
                              stderr=subprocess.STDOUT, check=False).returncode
    if code:
        raise RuntimeError(f"{command[0]} failed, see {log}")


def solve(case, iterations, start=None, upwind=500):
    """Steady solution: some iterations with upwind convection, which survives the start, then the
    rest with the second-order scheme; or, from the solution of another case, only those."""
    if start is None:
        dictionaries.write(case/"system/fvSchemes", re.sub(r"linearUpwind limited|limitedLinear 1", "upwind", SCHEMES))
        write_control(case, upwind)
        run(case, "simpleFoam")
    else:
        for name in ("U", "p", "k", "epsilon", "nut"):
            shutil.copy(latest(start)/name, case/"0"/name)
    dictionaries.write(case/"system/fvSchemes", SCHEMES)
    write_control(case, iterations)
    run(case, "simpleFoam")
    run(case, "postProcess", "-func", "writeCellCentres", "-latestTime")


def latest(case):
    return max((d for d in case.iterdir() if re.fullmatch(r"[0-9.]+", d.name)), key=lambda d: float(d.name))


def read_field(path):
    """Internal values of a field file, scalar (n) or vector (n, 3)."""
    return numpy.array(dictionaries.internal(path))


def structured(case, blocks, nx, skip=0):
    """{name: (nx, nr) array} of r, x, U, V, k, epsilon, nut; blocks: radial cells of each block from
    the axis, nx cells along; skip: cells of blocks before them."""
    time = latest(case)
    # cell centroid of a wedge lies at r sin(a)/a from the axis
    factor = HALF_ANGLE/math.sin(HALF_ANGLE)
    raw = {"x": read_field(time/"Cx"), "r": read_field(time/"Cy")*factor, "U": read_field(time/"U")[:, 0],
           "V": read_field(time/"U")[:, 1], "k": read_field(time/"k"), "epsilon": read_field(time/"epsilon")}
    result = {}
    for name, values in raw.items():
        parts, start = [], skip
        for nr in blocks:
            parts.append(values[start:start + nx*nr].reshape(nr, nx).T)
            start += nx*nr
        result[name] = numpy.hstack(parts)
    return result


def wedge_points(stations):
    """Vertices for blockMesh: for each (x, [r0, r1 ...]) the point on the axis, then pairs back, front."""
    text, labels = [], []
    for x, radii in stations:
        text.append(f"({x} 0 0)")
        labels.append([(len(text) - 1, len(text) - 1)])
        for r in radii:
            y, z = r*math.cos(HALF_ANGLE), r*math.sin(HALF_ANGLE)
            text += [f"({x} {y!r} {-z!r})", f"({x} {y!r} {z!r})"]
            labels[-1].append((len(text) - 2, len(text) - 1))
    return "\n".join(text), labels


def block(a, b, inner, cells, axial, radial):
    """A block between two stations (labels of wedge_points), from ring `inner` outwards; axial expansion
    ratio, and radial ones at the two stations."""
    (b0, f0), (b1, f1) = a[inner], a[inner + 1]
    (b2, f2), (b3, f3) = b[inner], b[inner + 1]
    r0, r1 = radial
    return (f"hex ({b0} {b2} {b3} {b1} {f0} {f2} {f3} {f1}) ({cells[0]} {cells[1]} 1) "
            f"edgeGrading ({axial} {axial} {axial} {axial} {r0} {r1} {r1} {r0} 1 1 1 1)")


def radial_face(station, inner):
    """Face across the flow between two rings of a station."""
    (b0, f0), (b1, f1) = station[inner], station[inner + 1]
    return f"({b0} {f0} {f1} {b1})"


def axial_face(a, b, ring):
    """Face along the flow at a ring."""
    (b0, f0), (b1, f1) = a[ring], b[ring]
    return f"({b0} {b1} {f1} {f0})"


def side_faces(a, b, inner):
    """Back and front face of a block."""
    (b0, f0), (b1, f1) = a[inner], a[inner + 1]
    (b2, f2), (b3, f3) = b[inner], b[inner + 1]
    return f"({b0} {b1} {b3} {b2})", f"({f0} {f2} {f3} {f1})"


def write_mesh(case, points, blocks, patches):
    """patches: {name: (type and other entries, [faces])}"""
    boundary = "\n".join(f"{name} {{ {kind} faces ({' '.join(faces)}); }}" for name, (kind, faces) in patches.items())
    newline = "\n"
    dictionaries.write(case/"system/blockMeshDict",
                     f"vertices (\n{points}\n);\nblocks (\n{newline.join(blocks)}\n);\nboundary (\n{boundary}\n);")
    run(case, "blockMesh")
