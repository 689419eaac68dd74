#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lateral spread of hollow glass beads in the decaying turbulence behind a grid (Snyder and Lumley 1971).

    snyder_lumley.py <work folder> --reference <folder>

Air at 6.55 m/s, upwards, behind a grid of M = 25.4 mm. The turbulence is imposed, from the fits of the paper: U2/<u2> = 42.4 (x/M - 16)
along the stream and U2/<v2> = 39.4 (x/M - 12) across it; k of both, epsilon = - U dk/dx. Beads of 46.5 um and 260 kg/m3
enter at x/M = 20; the spread counts from x/M = 68.4 on. Beside <folder>/dispersion/hollow_glass_lateral_dispersion.csv. Writes
results/snyder_lumley.csv and .png.
"""

import argparse
import csv
import math
import pathlib

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import grainjet
from grainjet import coupled_box as box, dictionaries, dumps

M, U, NU, RHO = 0.0254, 6.55, 1.5e-5, 1.2
BEGIN, START, END = 20*M, 68.4*M, 176*M
DIAMETER, DENSITY, BEADS = 46.5e-6, 260.0, 2000
CELLS, DT, EVERY = 900, 5e-4, 20
MODELS = {"Langevin, Sct 0.7": "{ model Langevin; Sct 0.7; }", "Langevin, Sct 1": "{ model Langevin; Sct 1; }",
          "discreteRandomWalk": "discreteRandomWalk"}


def energy(x):
    """k [m2/s2] and epsilon [m2/s3] behind the grid."""
    a, b = x/M - 16, x/M - 12
    return U*U/2*(1/(42.4*a) + 2/(39.4*b)), U**3/(2*M)*(1/(42.4*a*a) + 2/(39.4*b*b))


def run(case, model):
    length = END + 0.1 - BEGIN
    steps = round((END - BEGIN)/U/DT)
    box.write(case, velocity=f"(0 0 {U})", through=True, delta_t=DT, steps=steps, cells=f"2 2 {CELLS}", size=(20, 20, 1000*length))
    k, epsilon = energy(BEGIN + (numpy.arange(CELLS) + 0.5)*length/CELLS)
    for name, dimensions, values in (("k", "0 2 -2", k), ("epsilon", "0 2 -3", epsilon), ("nut", "0 2 -1", 0*k)):
        ends = "calculated; value uniform 0" if name == "nut" else "zeroGradient"
        dictionaries.write_field(case, name, dimensions, dictionaries.nonuniform(numpy.repeat(values, 4)),
                                 f'".*" {{ type cyclic; }} "z.*" {{ type {ends}; }}')
    dictionaries.write(case/"constant/turbulenceProperties",
                       "simulationType RAS; RAS { RASModel kEpsilon; turbulence off; printCoeffs off; }\n")
    dictionaries.change(case/"system/fvSolution", ('"U.*"', '"(U|k|epsilon).*"'))
    rng = numpy.random.default_rng(2)
    x = rng.uniform(0, 0.02, (BEADS, 3))*(1, 1, 0) + (0, 0, 0.001)
    box.script(case, grains=box.grains(x, numpy.tile((0, 0, U), (BEADS, 1)), DIAMETER, DENSITY), dt=DT/5, box=f"0 0.02 0 0.02 0 {length}", boundary="p p f",
               gravity="fix g all gravity 9.81 vector 0 0 -1", end=f"dump d all custom {5*EVERY} grains.dump id xu yu zu vx vy vz")
    # dilute: beads do not meet
    dictionaries.change(case/"constant/in.particles", ("neighbor 0.0005 bin", "neigh_modify exclude type 1 1\nneighbor 0.0005 bin"))
    box.fv_options(case, coupling="oneWay", drag="SchillerNaumann", forces="()", couplingInterval=5, turbulentDispersion=model)
    for command in ("blockMesh", "pimpleFoam"):
        result = grainjet.run(["nice", "-n", "10", command], case, 6000)
        if result.code:
            raise RuntimeError(result)


def spread(case):
    """t [s] since x/M = 68.4, mean square lateral displacement [m2] of one component."""
    frames = [frame.array() for frame in dumps.frames(case/"grains.dump")]
    begin = next(i for i, rows in enumerate(frames) if BEGIN + rows[:, 3].mean() >= START)
    origin, table = frames[begin], []
    for i, rows in enumerate(frames[begin:]):
        if len(rows) == len(origin):
            table.append((i*EVERY*DT, ((rows[:, 1:3] - origin[:, 1:3])**2).mean()))
    return numpy.array(table).T


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--reference", type=pathlib.Path, required=True)
    args = parser.parse_args()
    data = numpy.loadtxt(args.reference/"dispersion/hollow_glass_lateral_dispersion.csv", delimiter=",", comments=("#", "t_ms"))
    t, measured = data[:, 0]*1e-3, data[:, 1]

    columns, axes = [], plt.subplots(figsize=(6, 4.5), constrained_layout=True)[1]
    axes.plot(t*1e3, measured, "ko", markerfacecolor="none", label="measured")
    for number, (name, model) in enumerate(MODELS.items()):
        case = args.work/f"snyder_lumley_{number}"
        if not (case/"grains.dump").is_file():
            run(case, model)
        times, square = spread(case)
        found = numpy.interp(t, times, square)*1e4
        columns.append(found)
        axes.plot(times*1e3, square*1e4, label=name)
        print(name, " ".join(f"{f:.3f}/{m:.3f}" for f, m in zip(found, measured)),
              f"rms deviation over the last point {math.sqrt(((found - measured)**2).mean())/measured[-1]:.3f}", flush=True)
    axes.set(xlabel="time since x/M = 68.4 [ms]", ylabel="mean square lateral displacement [cm2]", xlim=(0, 450), ylim=(0, 6))
    axes.legend(fontsize=8)
    results = pathlib.Path(__file__).parent/"results"
    plt.savefig(results/"snyder_lumley.png", dpi=130)
    with (results/"snyder_lumley.csv").open("w", newline="") as output:
        table = csv.writer(output)
        table.writerow(["t [ms]", *(f"{name} [cm2]" for name in MODELS)])
        table.writerows([f"{a*1e3:.1f}", *(f"{c[i]:.3f}" for c in columns)] for i, a in enumerate(t))


if __name__ == "__main__":
    main()
