#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Suspensions that settle in water which cannot flow off: the balance of weight and drag, and the return flow.

    settling.py <work folder>

A cloud of grains of 2500 kg/m3 (cubic lattice, 2 x 2 x 26 cells) in the middle of a column, periodic across and closed below, so
that the flux of the mixture is zero: e u = - q. In the middle of the cloud

    - dp/dz = (1 - e) (rho_p - rho) g        p without the hydrostatic pressure of the water,
    v = - U(e), the flux at which the law's pressure drop is that weight.

Writes results/settling.csv.
"""

import argparse
import csv
import math
import pathlib

import numpy

import grainjet
import laws
from grainjet import coupled_box as box, dictionaries, dumps, scripts

HERE = pathlib.Path(__file__).resolve().parent
RHO, NU, DENSITY = 1000.0, 1e-6, 2500.0
CELL = 4e-4                                 # m
SPACING = CELL/2                            # of the lattice
ACROSS, ALONG, CLOUD = 2, 40, range(7, 33)  # layers of cells
MIDDLE = slice(17, 23)
STEP = 1e-4                                 # s
LENGTH = 3*CELL                             # of the filter, which smooths the ends of the cloud
VOID = (0.5, 0.6, 0.7, 0.77, 0.83, 0.9, 0.95, 0.99)      # Gidaspow's law jumps at 0.8


def steps(e):
    """Until the grains fall steadily: fifteen of their response times, the drag that of the law."""
    _, speed = expected(e)
    return max(200, math.ceil(15*DENSITY*speed/((DENSITY - RHO)*laws.G)/STEP))


def expected(e):
    """Diameter [m] and the law's settling velocity [m/s]."""
    d = SPACING*(6*(1 - e)/math.pi)**(1/3)
    weight = (1 - e)*(DENSITY - RHO)*laws.G
    return d, laws.carrying(lambda U: laws.gidaspow(e, d, U, RHO, RHO*NU), weight)


def write(case, e, formulation="SetI", length=LENGTH):
    d, _ = expected(e)
    n = steps(e)
    box.write(case, velocity="(0 0 0)", nu=NU, rho=f"rho [1 -3 0 0 0 0 0] {RHO};", through=True, convection="upwind",
              cells=f"{ACROSS} {ACROSS} {ALONG}", size=[1e3*CELL*k for k in (ACROSS, ACROSS, ALONG)],
              delta_t=STEP, steps=n)
    across = range(2*ACROSS)
    places = [[(i + 0.5 + 0.13)*SPACING, (j + 0.5 + 0.21)*SPACING, (k + 0.5 + 0.29)*SPACING]
              for k in range(2*CLOUD.start, 2*CLOUD.stop) for j in across for i in across]
    width, height = ACROSS*CELL, ALONG*CELL
    box.script(case, dt=STEP/10, boundary="p p f", box=f"0 {width} 0 {width} 0 {height}",
               gravity=f"fix g all gravity {laws.G} vector 0 0 -1", end=scripts.dump(10*n, "grains.dump", "id z vz"),
               grains=box.grains(places, [(0, 0, 0)]*len(places), d, DENSITY))
    box.fv_options(case, drag="Gidaspow", forces="(pressureGradient viscous buoyancy)", formulation=formulation,
                   voidFraction=f"{{ model divided; equations full; filter {{ length {length!r}; }} }}")


def result(case, e):
    """Ratios and residuals in the middle of the cloud."""
    case = pathlib.Path(case)
    _, speed = expected(e)
    end = max((f.parent for f in case.glob("*/solidsFlux")), key=lambda f: float(f.name))

    def layers(name):
        values = numpy.array(dictionaries.internal(end/name))
        return values.reshape(ALONG, ACROSS**2, *values.shape[1:]).mean(1)
    void, p = layers("voidFraction"), RHO*layers("p")
    u, q = layers("fluidVelocity")[:, 2], layers("solidsFlux")[:, 2]
    grains = dumps.frames(case/"grains.dump")[-1].array()
    middle = abs(grains[:, 1] - 0.5*ALONG*CELL) < 3*CELL
    slope = numpy.polyfit(CELL*numpy.arange(ALONG)[MIDDLE], p[MIDDLE], 1)[0]
    flux = numpy.array(dictionaries.internal(end/"phi"))/CELL**2
    return {"void fraction": void[MIDDLE].mean(),
            "v/law": -grains[middle, 2].mean()/speed,
            "dp/weight": -slope/((1 - e)*(DENSITY - RHO)*laws.G),
            "u/v": (u[MIDDLE]/-grains[middle, 2].mean()).mean(),
            "q + e u": abs((q + void*u)[MIDDLE]).max()/speed,
            "flux": abs(flux).max()/speed, "law": speed}


def run(case, e, **options):
    write(case, e, **options)
    for program in ("blockMesh", "pimpleFoam"):
        done = grainjet.run([program], case)
        (case/f"log.{program}").write_text(done.output)
        if done.code:
            raise SystemExit(f"{case}: {program}\n{done.output[-3000:]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    work = parser.parse_args().work
    rows = []
    for e in VOID:
        for formulation in ("SetI", "SetII"):
            case = work/f"{e}-{formulation}"
            if not case.exists():
                run(case, e, formulation=formulation)
            found = result(case, e)
            print(f"{e} {formulation}: " + ", ".join(f"{name} {value:.5g}" for name, value in found.items()), flush=True)
            rows.append([f"{e}", formulation] + [f"{value:.5g}" for value in found.values()])
    with open(HERE/"results/settling.csv", "w", newline="") as file:
        csv.writer(file).writerows([["e", "formulation", *found], *rows])


if __name__ == "__main__":
    main()
