#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do tracers stay evenly spread in a pipe whose turbulence varies as DNS has it?

    well_mixed.py <work folder> --reference <folder>

A closed periodic pipe with k and epsilon of the DNS of Fukagata and Kasagi (Re_tau 180; <folder>/pipe_flow/K_Pipe), frozen, and no
mean flow. Grains start evenly spread, each moves for itself. In wall units the centre of the first cell is at 1, a grain
has a diameter of 3.6, an interval
is 1.8. Stokes numbers are over T = 0.193 k/epsilon of the axis. Beside: OpenFOAM's own
dispersion models in its own cloud. Writes results/well_mixed.csv and .png.
"""

import argparse
import csv
import math
import pathlib
import re

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import grainjet
from grainjet import coupled_box as box, dictionaries, dumps

R, LENGTH, U_TAU, RE_TAU = 5e-3, 0.02, 0.5, 180.0
DIAMETER, DENSITY, RHO = 1e-4, 1000.0, 1.2
GRAINS, DEM_STEP = 4000, 2e-6             # s
END, FIRST, EVERY = 0.1, 0.02, 0.002       # s: end, first sample, from sample to sample
SIDE, SEGMENTS = 0.5, 12                   # of the square in the middle, over R; cells of a quarter
WALL = R*math.cos(math.pi/(4*SEGMENTS))    # the cylinder in the polygon
EDGES = numpy.linspace(0, 1, 11)           # bins of equal volume, over the square of the radius

# model, Stokes number, interval [s]: 0.07 and 0.018 T of the axis
CASES = (("Langevin", 0.001, 1e-4), ("Langevin", 0.001, 2.5e-5), ("Langevin", 0.01, 1e-4), ("Langevin", 0.1, 1e-4),
         ("Langevin", 1.0, 1e-4), ("Langevin", 10.0, 1e-4), ("discreteRandomWalk", 0.001, 1e-4),
         ("stochasticDispersionRAS", 0.001, 1e-4), ("gradientDispersionRAS", 0.001, 1e-4))


def turbulence(folder):
    """y+, k+, epsilon+ of the DNS, from the wall."""
    def rows(name):
        lines = (folder/"pipe_flow/K_Pipe"/name).read_text().splitlines()
        return numpy.array([[float(v) for v in line.split()] for line in lines if line.strip() and line[0] != "#"])[::-1]
    rms, budget = rows("RMS_ur_uphi_uz_p.dat"), rows("Budget_TKE.dat")
    ur = numpy.interp(rms[:, 0], numpy.append(0, rms[:, 1]), numpy.append(0, rms[:, 2]))
    k = 0.5*(ur**2 + rms[:, 3]**2 + rms[:, 4]**2)
    epsilon = numpy.interp(rms[:, 0], budget[:, 0], -budget[:, 9])
    return numpy.append(0, rms[:, 0]), numpy.append(0, k), numpy.append(epsilon[0], epsilon)


def mesh(case):
    inner, outer = SIDE*R/math.sqrt(2), R/math.sqrt(2)
    points = [(s*x, t*x, z) for z in (0, LENGTH) for x in (inner, outer) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    blocks = [f"hex (0 1 2 3 8 9 10 11) ({SEGMENTS} {SEGMENTS} 4) simpleGrading (1 1 1)"]
    arcs, walls, low, high = [], [], ["(0 3 2 1)"], ["(8 9 10 11)"]
    for i in range(4):
        j = (i + 1) % 4
        blocks.append(f"hex ({i} {4 + i} {4 + j} {j} {8 + i} {12 + i} {12 + j} {8 + j}) (24 {SEGMENTS} 4) simpleGrading (0.1 1 1)")
        middle = [R*math.cos(math.radians(-90 + 90*i)), R*math.sin(math.radians(-90 + 90*i))]
        arcs += [f"arc {4 + i + d} {4 + j + d} ({middle[0]!r} {middle[1]!r} {z})" for d, z in ((0, 0), (8, LENGTH))]
        walls.append(f"({4 + i} {4 + j} {12 + j} {12 + i})")
        low.append(f"({i} {j} {4 + j} {4 + i})")
        high.append(f"({8 + i} {12 + i} {12 + j} {8 + j})")
    vertices = " ".join(f"({x!r} {y!r} {z!r})" for x, y, z in points)
    dictionaries.write(case/"system/blockMeshDict", f"scale 1; vertices ({vertices}); edges ({' '.join(arcs)});\nblocks ({' '.join(blocks)});\n"
                       f"boundary (wall {{ type wall; faces ({' '.join(walls)}); }}\n"
                       f"zlo {{ type cyclic; neighbourPatch zhi; faces ({' '.join(low)}); }}\n"
                       f"zhi {{ type cyclic; neighbourPatch zlo; faces ({' '.join(high)}); }});\n")


def fields(case, dns):
    grainjet.run(["postProcess", "-func", "writeCellCentres", "-time", "0"], case)
    radius = numpy.hypot(*(numpy.array(dictionaries.internal(case/"0"/name)) for name in ("Cx", "Cy")))
    y_plus, k, epsilon = dns
    at = numpy.clip(1 - radius/R, 0, 1)*RE_TAU
    scale = RE_TAU*U_TAU/R                     # u_tau2/nu of the DNS [1/s]
    values = {"k": U_TAU**2*numpy.interp(at, y_plus, k), "epsilon": U_TAU**2*scale*numpy.interp(at, y_plus, epsilon)}
    others = "zlo { type cyclic; } zhi { type cyclic; }"
    dictionaries.write_field(case, "k", "0 2 -2", dictionaries.nonuniform(values["k"]), "wall { type fixedValue; value uniform 0; }" + others)
    dictionaries.write_field(case, "epsilon", "0 2 -3", dictionaries.nonuniform(values["epsilon"]), "wall { type zeroGradient; }" + others)
    dictionaries.write_field(case, "nut", "0 2 -1", 0, "wall { type calculated; value uniform 0; }" + others)


def places():
    rng = numpy.random.default_rng(1)
    radius = (WALL - DIAMETER/2)*numpy.sqrt((numpy.arange(GRAINS) + 0.5)/GRAINS)
    angle, z = rng.uniform(0, 2*math.pi, GRAINS), rng.uniform(0, LENGTH, GRAINS)
    return numpy.column_stack((radius*numpy.cos(angle), radius*numpy.sin(angle), z))


def prepare(case, dns, stokes, dt):
    """Mesh, fields and schemes; the viscosity makes the response time."""
    time = 0.135/0.7*dns[1][-1]/dns[2][-1]*R/(U_TAU*RE_TAU)
    nu = DENSITY*DIAMETER**2/(18*RHO*stokes*time)
    box.write(case, delta_t=dt, steps=round(END/dt), write_every=round(EVERY/dt), nu=nu)
    mesh(case)
    others = "zlo { type cyclic; } zhi { type cyclic; }"
    dictionaries.write_field(case, "U", "0 1 -1", "(0 0 0)", "wall { type noSlip; }" + others)
    dictionaries.write_field(case, "p", "0 2 -2", 0, "wall { type zeroGradient; }" + others)
    dictionaries.write(case/"constant/turbulenceProperties",
                       "simulationType RAS; RAS { RASModel kEpsilon; turbulence off; printCoeffs off; }\n")
    dictionaries.change(case/"system/fvSolution", ('"U.*"', '"(U|k|epsilon).*"'))
    grainjet.run(["blockMesh"], case)
    fields(case, dns)
    return nu


def coupled(case, dns, model, stokes, dt):
    prepare(case, dns, stokes, dt)
    interval = int(dt/DEM_STEP)
    x = places()
    low, high = f"{-1.2*R} {1.2*R} {-1.2*R} {1.2*R}", f"0 {LENGTH}"
    box.script(case, grains=box.grains(x, numpy.zeros_like(x), DIAMETER, DENSITY), dt=dt/interval, box=f"{low} {high}", boundary="f f p",
               fixes=f"fix wall all wall/gran model hertz tangential history primitive type 1 zcylinder {WALL!r} 0 0",
               end=f"dump d all custom {round(EVERY/dt)*interval} grains.dump id x y z vx vy vz")
    # grains do not meet each other
    dictionaries.change(case/"constant/in.particles", ("neighbor 0.0005 bin", "neigh_modify exclude type 1 1\nneighbor 0.0005 bin"))
    box.fv_options(case, coupling="oneWay", drag=None, forces="{ drag { model Stokes; } }", couplingInterval=interval,
                   turbulentDispersion=f"{{ model {model}; seed 1; }}")
    result = grainjet.run(["nice", "-n", "10", "pimpleFoam"], case, 6000)
    if result.code:
        raise RuntimeError(result)


CLOUD = """
solution { active true; coupled false; transient yes; cellValueSourceCorrection off; maxCo 0.3;
           interpolationSchemes { rho cell; U cellPoint; mu cell; } integrationSchemes { U analytical; } }
constantProperties { rho0 %(density)r; youngsModulus 5e6; poissonsRatio 0.3; }
subModels
{
    particleForces { sphereDrag; }
    injectionModels { all { type manualInjection; massTotal 0; parcelBasisType fixed; nParticle 1; SOI 0; positionsFile "places"; U0 (0 0 0);
        sizeDistribution { type fixedValue; fixedValueDistribution { value %(diameter)r; } } } }
    dispersionModel %(model)s; patchInteractionModel standardWallInteraction; stochasticCollisionModel none; collisionModel none; surfaceFilmModel none;
    standardWallInteractionCoeffs { type rebound; e 1; mu 0; }
}
cloudFunctions {}
"""


def cloud(case, dns, model, stokes, dt):
    """OpenFOAM's own cloud of parcels that do not meet."""
    nu = prepare(case, dns, stokes, dt)
    dictionaries.write(case/"constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {nu!r}; rhoInf [1 -3 0 0 0 0 0] {RHO};\n")
    dictionaries.write(case/"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);\n", "uniformDimensionedVectorField")
    dictionaries.write(case/"constant/places", "(\n" + "\n".join(dictionaries.vector(x) for x in places()) + "\n)", "vectorField")
    dictionaries.write(case/"constant/kinematicCloudProperties", CLOUD % {"density": DENSITY, "diameter": DIAMETER, "model": model})
    result = grainjet.run(["nice", "-n", "10", "icoUncoupledKinematicParcelFoam"], case, 6000)
    if result.code:
        raise RuntimeError(result)


def samples(case, model, dt):
    """Positions at the times that count."""
    if model.endswith("RAS"):
        times = sorted((float(d.name), d) for d in case.iterdir() if re.fullmatch(r"[0-9.]+", d.name))
        for time, folder in times:
            if time > FIRST - 1e-9:
                text = (folder/"lagrangian/kinematicCloud/positions").read_text()
                yield numpy.array([[float(v) for v in m.split()] for m in re.findall(r"^\(([-+.\deE ]+)\)", text, re.M)])
    else:
        for frame in dumps.frames(case/"grains.dump"):
            if frame.step*dt/int(dt/DEM_STEP) > FIRST - 1e-9:
                yield frame.array()[:, 1:4]


def profile(case, model, dt):
    """Concentration over the even one in bins of equal volume, and its standard error from 20 groups of grains."""
    groups, found, reach = 20, [], WALL - DIAMETER/2
    for x in samples(case, model, dt):
        square = (x[:, 0]**2 + x[:, 1]**2)/reach**2
        found.append([numpy.histogram(numpy.minimum(square[g::groups], 1 - 1e-12), EDGES)[0]/len(square[g::groups]) for g in range(groups)])
    share = numpy.array(found).mean(axis=0)*(len(EDGES) - 1)
    return share.mean(axis=0), share.std(axis=0, ddof=1)/math.sqrt(groups), len(x)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--reference", type=pathlib.Path, required=True)
    args = parser.parse_args()
    dns = turbulence(args.reference)

    rows, axes = [], plt.subplots(figsize=(7, 5), constrained_layout=True)[1]
    for model, stokes, dt in CASES:
        case = args.work/f"{model}_{stokes}_{dt}"
        if not (case/"0").is_dir():
            (cloud if model.endswith("RAS") else coupled)(case, dns, model, stokes, dt)
        share, error, left = profile(case, model, dt)
        rows += [[model, stokes, dt, f"{math.sqrt(a):.3f}", f"{math.sqrt(b):.3f}", f"{c:.3f}", f"{e:.3f}"]
                 for a, b, c, e in zip(EDGES, EDGES[1:], share, error)]
        print(f"{model} St {stokes}, interval {dt} s, {left} grains:", " ".join(f"{c:.3f}+-{e:.3f}" for c, e in zip(share, error)), flush=True)
        axes.errorbar(numpy.sqrt((EDGES[1:] + EDGES[:-1])/2), share, error, marker="o", markersize=3, label=f"{model}, St {stokes:g}, {dt:g} s")

    results = pathlib.Path(__file__).parent/"results"
    with (results/"well_mixed.csv").open("w", newline="") as output:
        table = csv.writer(output)
        table.writerow(("model", "Stokes number", "interval [s]", "r/R from", "r/R to", "concentration over the even one", "standard error"))
        table.writerows(rows)
    axes.set(xlabel="$r/R$", ylabel="concentration over the even one", ylim=(0, 3.5))
    axes.axhline(1, color="k", linewidth=0.5)
    axes.legend(fontsize=7)
    plt.savefig(results/"well_mixed.png", dpi=130)


if __name__ == "__main__":
    main()
