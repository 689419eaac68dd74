#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A plane jet of gas with grains on three meshes, cells of 4, 2 and 0.67 grain diameters, with the filter and without.

    source environment; validation/dense/jet/meshes.py [--end 4e-3] [--work FOLDER] [--output FOLDER]

Gas of 10 m/s with grains of 5 m/s leaves a slot 16 grain diameters wide; beside it gas flows at 2 m/s. The domain is 48 diameters
wide, 4 thick (periodic) and 64 long. The same grains at the same places enter on all meshes: they wait upstream of it. Means over the
second half of the time, over columns of 4 diameters at 10 to 11 of 16 columns downstream, so that all meshes are compared at the resolution of
the coarsest. With --work the folder is kept, and what is complete is not run again.
"""

import argparse
import math
import pathlib
import random
import shutil
import tempfile

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import grainjet
from grainjet import coupled_box as box, dictionaries, tables

GRAIN, CG, DENSITY = 160e-6, 2, 300.0
RHO, NU = 1.2, 1e-4
JET, COFLOW, ENTERING = 10.0, 2.0, 5.0
SOLID = 0.02                    # of the slot
STEP, CYCLES = 1e-5, 5
COARSE = 4*GRAIN
COLUMNS, LAYERS, SLOT = 12, 16, 4   # in coarse cells: width, length, width of the slot
PLANE = 10                      # the layer of coarse cells that is compared
FILTER = 4.2*GRAIN              # the smallest that the coarsest mesh may have is its cell, 4 grains
FINENESS = {"4": 1, "2": 2, "0.67": 6}
QUANTITIES = {"fluid": "velocity of the gas, m/s", "flux": "volumetric flux of grains, mm/s", "grains": "velocity of grains, m/s"}

AVERAGED = ("fluidVelocity", "solidsFlux", "voidFraction")

MEAN = """
mean
{{
    type fieldAverage; libs ("libfieldFunctionObjects.so"); timeStart {start:g}; writeControl onEnd;
    fields ({fields});
}}
"""


def waiting(end):
    """Grains that enter until the end: some are in the mesh, as a run asks for, the others wait upstream of it."""
    rng = random.Random(1)
    length = ENTERING*end
    n = round(SOLID*SLOT*COARSE*COARSE*length/(math.pi/6*GRAIN**3))
    low = (COLUMNS - SLOT)/2*COARSE
    return [(rng.uniform(low, low + SLOT*COARSE), rng.uniform(0, COARSE), COARSE - length*(i + 0.5)/n) for i in range(n)]


def mesh(n):
    """blockMeshDict: three blocks side by side, the middle one behind the slot."""
    beside = (COLUMNS - SLOT)//2
    x = [0, beside, beside + SLOT, COLUMNS]
    corners = " ".join(f"({a} {b} {c})" for c in (0, LAYERS) for b in (0, 1) for a in x)
    blocks = inlets = sides = ends = ""
    back, front = [], []
    for i in range(3):
        a, b, c, d = i, i + 1, i + 5, i + 4
        blocks += f"hex ({a} {b} {c} {d} {a + 8} {b + 8} {c + 8} {d + 8}) ({(x[i + 1] - x[i])*n} {n} {LAYERS*n}) simpleGrading (1 1 1)\n"
        (inlets, sides) = (inlets + f"({a} {d} {c} {b})", sides) if i == 1 else (inlets, sides + f"({a} {d} {c} {b})")
        ends += f"({a + 8} {b + 8} {c + 8} {d + 8})"
        back.append(f"({a} {b} {b + 8} {a + 8})")
        front.append(f"({d} {d + 8} {c + 8} {c})")
    return (f"scale {COARSE!r};\nvertices ({corners});\nblocks ({blocks});\nboundary\n(\n"
            f"slot {{ type patch; faces ({inlets}); }}\ncoflow {{ type patch; faces ({sides}); }}\noutlet {{ type patch; faces ({ends}); }}\n"
            f"back {{ type cyclic; neighbourPatch front; faces ({' '.join(back)}); }}\n"
            f"front {{ type cyclic; neighbourPatch back; faces ({' '.join(front)}); }}\n"
            "sides { type patch; faces ((0 8 12 4) (3 7 15 11)); }\n);\n")


def run(work, cell, length, end):
    """Run a mesh with a length of the filter, unless that was done. Returns the folder."""
    case = work/f"{cell}-{'filter' if length else 'none'}"
    if (case/"complete").exists():
        return case
    shutil.rmtree(case, ignore_errors=True)
    case.mkdir(parents=True)
    steps = round(end/STEP)
    box.write(case, nu=NU, steps=steps, delta_t=STEP, convection="limitedLinear 1",
              functions=MEAN.format(start=end/2, fields=" ".join(f"{name} {{ mean on; prime2Mean off; base time; }}" for name in AVERAGED)))
    dictionaries.write(case/"system/blockMeshDict", mesh(FINENESS[cell]))
    dictionaries.write(case/"system/fvSolution", """
solvers
{
    "p.*" { solver GAMG; smoother GaussSeidel; tolerance 1e-7; relTol 0.001; }
    "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-10; relTol 1e-4; }
    grainFilter { solver PCG; preconditioner DIC; tolerance 1e-12; relTol 1e-6; }
}
PIMPLE { nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; }
""")
    dictionaries.write_field(case, "U", "0 1 -1", f"(0 0 {COFLOW})", {
        "slot": f"type fixedValue; value uniform (0 0 {JET});", "coflow": f"type fixedValue; value uniform (0 0 {COFLOW});",
        "outlet": "type zeroGradient;", "sides": "type slip;", "(front|back)": "type cyclic;"})
    dictionaries.write_field(case, "p", "0 2 -2", 0, {
        "(slot|coflow|sides)": "type zeroGradient;", "outlet": "type fixedValue; value uniform 0;", "(front|back)": "type cyclic;"})
    grains = waiting(end)
    box.script(case, dt=STEP/CYCLES, grains=box.grains(grains, [(0, 0, ENTERING)]*len(grains), GRAIN/CG, DENSITY), boundary="f p f",
               box=f"0 {COLUMNS*COARSE!r} 0 {COARSE!r} {-1.001*ENTERING*end!r} {LAYERS*COARSE!r}",
               plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {CG} model_check warn")
    script = case/"constant/in.particles"
    dictionaries.change(script, ("neighbor 0.0005 bin", "neighbor 0.00005 bin"))
    filtered = f"filter {{ length {length!r}; }}" if length else ""
    box.fv_options(case, couplingInterval=CYCLES, voidFraction=f"{{ model divided; minimum 0.3; equations full; {filtered} }}")
    for command in (["blockMesh"], ["pimpleFoam"]):
        result = grainjet.run(command, case, timeout=7200)
        (case/f"log.{command[0]}").write_text(result.output)
        if result.code:
            raise SystemExit(f"{command[0]} failed, see {case}\n{result.output[-2000:]}")
    (case/"complete").touch()
    return case


def profile(case, cell):
    """{quantity: values of the coarse columns of cells}"""
    n = FINENESS[cell]
    time = max((f.parent for f in case.glob("*/fluidVelocityMean")), key=lambda f: float(f.name))

    def columns(name):
        values = numpy.array(dictionaries.internal(time/name))
        values = values[:, 2] if values.ndim > 1 else values
        blocks, start = [], 0
        for width in ((COLUMNS - SLOT)//2, SLOT, (COLUMNS - SLOT)//2):
            count = LAYERS*n*n*width*n
            block = values[start:start + count].reshape(LAYERS, n, n, width, n)
            blocks.append(block[PLANE].mean(axis=(0, 1, 3)))
            start += count
        return numpy.concatenate(blocks)

    flux, solid = columns("solidsFluxMean"), 1 - columns("voidFractionMean")
    with numpy.errstate(invalid="ignore", divide="ignore"):
        speed = numpy.where(solid > 0.1*solid.max(), flux/solid, numpy.nan)
    return {"fluid": columns("fluidVelocityMean"), "flux": 1e3*flux, "grains": speed}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--end", type=float, default=4e-3)
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path)
    options = parser.parse_args()
    work = options.work or pathlib.Path(tempfile.mkdtemp(prefix="grainjet-meshes-"))
    work.mkdir(parents=True, exist_ok=True)
    work = work.resolve()
    found = {(length, cell): profile(run(work, cell, length, options.end), cell) for length in (FILTER, 0) for cell in FINENESS}

    x = (numpy.arange(COLUMNS) + 0.5 - COLUMNS/2)*COARSE/(SLOT*COARSE)
    rows = [["quantity", "filter, d", "x/D", *(f"cell {cell} d" for cell in FINENESS)]]
    spreads = [["quantity", "filter, d", "largest value", "rms spread of the three meshes, %", "largest, %"]]
    figure, axes = plt.subplots(2, len(QUANTITIES), figsize=(12, 6.5), constrained_layout=True, sharex=True, sharey="col")
    for row, (length, words) in enumerate(((FILTER, f"filter {FILTER/GRAIN:g} d"), (0, "no filter"))):
        for column, (name, label) in enumerate(QUANTITIES.items()):
            values = numpy.array([found[length, cell][name] for cell in FINENESS])
            seen = ~numpy.isnan(values).any(axis=0)
            largest = values[:, seen].max()
            spread = values[:, seen].max(axis=0) - values[:, seen].min(axis=0)
            spreads.append([label, f"{length/GRAIN:g}", f"{largest:.3g}", f"{100*math.sqrt((spread**2).mean())/largest:.1f}",
                            f"{100*spread.max()/largest:.1f}"])
            rows += [[label, f"{length/GRAIN:g}", f"{place:.3f}", *(f"{v:.4g}" for v in values[:, i])] for i, place in enumerate(x)]
            for marker, cell in zip("os^", FINENESS):
                axes[row, column].plot(x, found[length, cell][name], marker=marker, markersize=4, linewidth=1, label=f"cell {cell} d")
            axes[row, column].set_title(f"{label}, {words}", fontsize=9)
    for axis in axes[1]:
        axis.set_xlabel("x/D")
    axes[0, 0].legend(fontsize=8)
    tables.show(spreads)
    if options.output:
        tables.write(options.output/"meshes.csv", rows)
        tables.write(options.output/"meshes_spread.csv", spreads)
        figure.savefig(options.output/"meshes.png", dpi=110)
    if not options.work:
        shutil.rmtree(work)


if __name__ == "__main__":
    main()
