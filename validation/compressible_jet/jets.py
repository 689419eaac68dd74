#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Axis of round jets of a gas, of Mach 0.51, 0.98 and 1.63, with k-epsilon models of rhoSimpleFoam.

    jets.py <work folder> [--reference <folder>] [--iterations 6000] [--jets M0.5 ...] [--models kEpsilon ...] [--coarse]

Steady, axisymmetric, from a top hat at the nozzle exit. Writes results/jets.csv (length of the core, velocity
on the axis at stations, deviation from the measured one) and results/jets.png. <folder> has the measured centre
lines of NASA's turbulence modelling resource; without it there is no comparison.
"""

import argparse
import csv
import math
import pathlib
import re
import shutil
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]/"jetKEpsilon"))

import foam_case as foam
from grainjet import dictionaries

D, GAMMA, T_AIR, P_AIR = 0.0508, 1.4, 295.0, 101325.0       # m, -, K, Pa
MOL, CP = 28.9, 1007.0
R_GAS = 8314.46/MOL
LENGTH, RADII = 50, (0.5, 12)       # in D: of the mesh, of the blocks' outer edges. all right angles
CELLS = 140, (20, 40)
INTENSITY, MIXING = 0.013, 0.05     # measured on the axis at 1 D: k/U^2 = 2.6e-4 (Mach 0.51); a length in D
CORE = 0.95                         # the core ends where the axis has this share of the velocity at the exit
STATIONS = (5, 8, 10, 12, 15, 20)

#: Mach number at the exit, temperature there over that of the air around, file of the centre line, zone in it
JETS = {
    "M0.5": (0.513, 1/(1 + 0.2*0.513**2), "arn2/ARN-jet-lines-expt.dat", 'y/Dj=0'),
    "M0.9": (0.985, 1/(1 + 0.2*0.985**2), "arn2/ARN-jet-lines-expt-hi.dat", 'y/Dj=0'),
    "M1.63": (1.63, 1.0, "Jet_mach1p63_tmatched_validation_Exp_tmatch_ucl.dat", "Exp"),
}
MODELS = {
    "kEpsilon": ("kEpsilon", "kEpsilonCoeffs { C3 0; }"),
    "jetKEpsilon": ("jetKEpsilon", ""),
    "Pope": ("jetKEpsilon", "jetKEpsilonCoeffs { C1 1.44; C2 1.92; roundJetCorrection Pope; }"),
}

SCHEMES = """
ddtSchemes { default steadyState; }
gradSchemes { default Gauss linear; limited cellLimited Gauss linear 1; }
divSchemes
{
    default none;
    div(phi,U) bounded Gauss linearUpwind limited;
    div(phi,h) bounded Gauss limitedLinear 1; div(phi,K) bounded Gauss limitedLinear 1; div(phid,p) Gauss limitedLinear 1;
    div(phi,k) bounded Gauss upwind; div(phi,epsilon) bounded Gauss upwind;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""

SOLUTION = """
solvers
{
    p { solver PBiCGStab; preconditioner %s; tolerance 1e-10; relTol 0.01; }
    "(U|h|k|epsilon)" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; relTol 0.01; minIter 1; }
}
SIMPLE { transonic %s; nNonOrthogonalCorrectors 0; pMinFactor %g; pMaxFactor %g; }
relaxationFactors { fields { p 0.3; rho %g; } equations { p 1; %s } }
"""
# of slow jets, and of those near the speed of sound and above: each form diverges for the other ones
SLOW = "DIC", "no", 0.5, 2, 0.3, 'U 0.7; h 0.7; "(k|epsilon)" 0.6;'
FAST = "DILU", "yes", 0.3, 3, 0.5, 'U 0.5; h 0.5; "(k|epsilon)" 0.5;'

THERMO = """
thermoType
{
    type hePsiThermo; mixture pureMixture; transport sutherland; thermo hConst;
    equationOfState perfectGas; specie specie; energy sensibleEnthalpy;
}
mixture
{
    specie { molWeight %g; }
    thermodynamics { Cp %g; Hf 0; }
    transport { As 1.458e-6; Ts 110.4; }
}
"""


def write(case, jet, model, cells):
    mach, ratio, _, _ = JETS[jet]
    nx, nr = cells
    T = ratio*T_AIR
    U = mach*math.sqrt(GAMMA*R_GAS*T)
    dictionaries.write(case/"system/fvSchemes", SCHEMES)
    dictionaries.write(case/"system/fvSolution", SOLUTION % (FAST if mach > 0.9 else SLOW))
    foam.write_control(case, 1)
    dictionaries.write(case/"constant/thermophysicalProperties", THERMO % (MOL, CP))
    name, coefficients = MODELS[model]
    dictionaries.write(case/"constant/turbulenceProperties",
                       f"simulationType RAS;\nRAS {{ RASModel {name}; turbulence on; printCoeffs on; {coefficients} }}")
    points, (a, b) = foam.wedge_points([(x, [r*D for r in RADII]) for x in (0, LENGTH*D)])
    sides = [foam.side_faces(a, b, i) for i in (0, 1)]
    foam.write_mesh(case, points,
                    [foam.block(a, b, 0, (nx, nr[0]), 12, (0.3, 0.3)), foam.block(a, b, 1, (nx, nr[1]), 12, (60, 60))],
                    {"inlet": ("type patch;", [foam.radial_face(a, 0)]),
                     "ambient": ("type patch;", [foam.radial_face(a, 1), foam.axial_face(a, b, 2)]),
                     "outlet": ("type patch;", [foam.radial_face(b, 0), foam.radial_face(b, 1)]),
                     "back": ("type wedge;", [s[0] for s in sides]),
                     "front": ("type wedge;", [s[1] for s in sides]),
                     "axis": ("type empty;", [foam.axial_face(a, b, 0)])})
    k = 1.5*(INTENSITY*U)**2
    epsilon = 0.09**0.75*k**1.5/(MIXING*D)
    still = {"k": 1e-6*U**2, "epsilon": 1e-6*U**3/D}
    wedges = {"back|front": "type wedge;", "axis": "type empty;"}
    dictionaries.write_field(case, "U", "[0 1 -1 0 0 0 0]", f"uniform ({0.01*U} 0 0)", {
        "inlet": f"type fixedValue; value uniform ({U!r} 0 0);",
        "ambient": "type pressureInletOutletVelocity; value uniform (0 0 0);",
        "outlet": "type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0);", **wedges})
    dictionaries.write_field(case, "p", "[1 -1 -2 0 0 0 0]", f"uniform {P_AIR}", {
        "inlet": f"type fixedValue; value uniform {P_AIR};" if mach > 1 else "type zeroGradient;",
        "ambient": f"type totalPressure; psi thermo:psi; gamma {GAMMA}; p0 uniform {P_AIR}; value uniform {P_AIR};",
        "outlet": f"type fixedValue; value uniform {P_AIR};", **wedges})
    dictionaries.write_field(case, "T", "[0 0 0 1 0 0 0]", f"uniform {T_AIR}", {
        "inlet": f"type fixedValue; value uniform {T!r};",
        "ambient|outlet": f"type inletOutlet; inletValue uniform {T_AIR}; value uniform {T_AIR};", **wedges})
    for name, value, dimensions in (("k", k, "[0 2 -2 0 0 0 0]"), ("epsilon", epsilon, "[0 2 -3 0 0 0 0]")):
        air = f"uniform {still[name]!r}"
        dictionaries.write_field(case, name, dimensions, air, {
            "inlet": f"type fixedValue; value uniform {value!r};",
            "ambient|outlet": f"type inletOutlet; inletValue {air}; value {air};", **wedges})
    for name, dimensions in (("nut", "[0 2 -1 0 0 0 0]"), ("alphat", "[1 -1 -1 0 0 0 0]")):
        dictionaries.write_field(case, name, dimensions, "uniform 0",
                                 {"inlet|ambient|outlet": "type calculated; value uniform 0;", **wedges})
    return U


def solve(case, iterations, start=None, upwind=400):
    """Until `iterations`, with the field on the way at three quarters of them; the first ones with upwind convection, which
    survives the start, or from the solution of the case `start`."""
    def go(first, last, interval, purge):
        dictionaries.write(case/"system/controlDict",
                           f'libs ("libjetTurbulenceModels.so");\nstartFrom latestTime; startTime {first}; stopAt endTime;\n'
                           f"endTime {last}; deltaT 1; writeControl timeStep; writeInterval {interval}; purgeWrite {purge}; writePrecision 10;\n")
        foam.run(case, "rhoSimpleFoam")

    if start is None:
        dictionaries.write(case/"system/fvSchemes", re.sub(r"linearUpwind limited|limitedLinear 1", "upwind", SCHEMES))
        go(0, upwind, upwind, 1)
        dictionaries.write(case/"system/fvSchemes", SCHEMES)
    else:
        for name in ("U", "p", "T", "k", "epsilon", "nut", "alphat"):
            shutil.copy(foam.latest(start)/name, case/"0"/name)
    quarter = iterations//4
    go(0, 4*quarter, quarter, 2)


def axis(case, time, nx):
    """x/D and U on the axis (cells at it)."""
    U = foam.read_field(time/"U")[:nx, 0]
    # cells of the first row: the mesh along x is that of blockMesh, a geometric series
    q = 12**(1/(nx - 1))
    edges = numpy.concatenate(([0], numpy.cumsum(q**numpy.arange(nx))))
    edges *= LENGTH/edges[-1]
    return 0.5*(edges[1:] + edges[:-1]), U


def measured(folder, jet):
    """x/D and u/Uj of the centre line."""
    _, _, name, zone = JETS[jet]
    text = (folder/name).read_text()
    part = text[text.index(f'ZONE T="{zone}') if f'ZONE T="{zone}' in text else text.index(f'ZONE T = "{zone}'):]
    rows = []
    for line in part.splitlines()[1:]:
        words = line.split()
        if words and words[0].startswith("ZONE"):
            break
        if len(words) >= 6 and re.fullmatch(r"[-+.\dEe]+", "".join(words)):
            rows.append([float(w) for w in words[:3]])
    rows = numpy.array(rows)
    rows = rows[rows[:, 2] > 0]     # 0 stands where nothing was measured
    return rows[:, 0], rows[:, 2]


def smooth(x, u, at, width=0.5):
    """Mean of the points within `width` of a place."""
    near = abs(x - at) <= width
    return u[near].mean() if near.any() else math.nan


def core(x, u):
    """x/D behind which the velocity stays below CORE."""
    above = numpy.nonzero(u >= CORE)[0]
    i = above[-1]
    return x[i] if i + 1 == len(x) else x[i] + (u[i] - CORE)/(u[i] - u[i + 1])*(x[i + 1] - x[i])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--reference", type=pathlib.Path)
    parser.add_argument("--iterations", type=int, default=6000)
    parser.add_argument("--jets", nargs="+", choices=JETS, default=list(JETS))
    parser.add_argument("--models", nargs="+", choices=MODELS, default=["kEpsilon", "jetKEpsilon"])
    parser.add_argument("--coarse", action="store_true", help="half the cells in each direction, to judge the mesh")
    args = parser.parse_args()
    cells = CELLS if not args.coarse else (CELLS[0]//2, tuple(n//2 for n in CELLS[1]))

    rows, curves = [], {}
    for jet in args.jets:
        data = measured(args.reference, jet) if args.reference else None
        if data is not None:
            grid = numpy.arange(1, min(24, data[0].max()), 0.25)
            line = numpy.array([smooth(*data, at) for at in grid])
            rows.append((jet, "measured", "", f"{core(grid, line):.2f}", *(f"{smooth(*data, x):.3f}" for x in STATIONS), "", ""))
            curves[jet, "measured"] = data
        for model in args.models:
            case = args.work/f"{jet}-{model}{'-coarse' if args.coarse else ''}"
            if not (case/"done").is_file():
                shutil.rmtree(case, ignore_errors=True)
                U = write(case, jet, model, cells)
                # Pope's term can destroy epsilon in the unphysical flow of the first iterations
                first = args.work/f"{jet}-kEpsilon{'-coarse' if args.coarse else ''}"
                solve(case, args.iterations, first if model == "Pope" and (first/"done").is_file() else None)
                (case/"done").write_text(repr(U))
            U = float((case/"done").read_text())
            times = sorted((t for t in case.iterdir() if re.fullmatch(r"\d+", t.name) and t.name != "0"), key=lambda t: int(t.name))
            (x, u), (_, before) = (axis(case, t, cells[0]) for t in (times[-1], times[-2]))
            u, before = u/U, before/U
            change = abs(u - before)[x < 25].max()
            curves[jet, model] = x, u
            at = numpy.interp(STATIONS, x, u)
            rms = ""
            if data is not None:
                rms = f"{math.sqrt(numpy.nanmean((numpy.interp(grid, x, u) - line)**2)):.3f}"
            rows.append((jet, model, cells[0]*sum(cells[1]), f"{core(x, u):.2f}", *(f"{v:.3f}" for v in at), rms, f"{change:.4f}"))
            print(*rows[-1], flush=True)

    results = pathlib.Path(__file__).parent/"results"
    results.mkdir(exist_ok=True)
    with (results/f"jets{'-coarse' if args.coarse else ''}.csv").open("w", newline="") as output:
        table = csv.writer(output)
        table.writerow(("jet", "model", "cells", f"core x/D (U = {CORE} Uj)", *(f"U/Uj at {x}D" for x in STATIONS), "rms deviation, 1D to 24D",
                        "change since the time written before, to 25D"))
        table.writerows(rows)
    if args.coarse:
        return
    figure, axes = plt.subplots(1, len(args.jets), figsize=(4*len(args.jets), 3.6), constrained_layout=True, squeeze=False)
    for panel, jet in zip(axes[0], args.jets):
        for (name, model), (x, u) in curves.items():
            if name == jet:
                panel.plot(x, u, **({"ls": "", "marker": ".", "ms": 3, "color": "k"} if model == "measured" else {}), label=model)
        panel.set(xlabel="$x/D$", ylabel="$U/U_j$ on the axis", xlim=(0, 25), ylim=(0, 1.15), title=f"Mach {JETS[jet][0]:g}")
        panel.grid(alpha=0.3)
    axes[0][0].legend(fontsize=8)
    figure.savefig(results/"jets.png", dpi=110)


if __name__ == "__main__":
    main()
