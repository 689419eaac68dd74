#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bubbling bed of van Wachem et al., Powder Technology 116 (2001) 155: its height over time.

    pseudo2d.py <work folder> --reference <folder>

Polystyrene spheres of 1.545 mm in a column 90 mm wide and 8 mm deep, air at 0.9 m/s. <folder>/beds/pseudo2d_height.csv holds the
measured height (columns t, h; not part of Grainjet). All grains are there, none stands for several; they are softer than
polystyrene, so that a DEM step of 4e-5 s is 20 % of the Rayleigh time. One rank. Writes results/pseudo2d.csv and .png.
"""

import argparse
import csv
import math
import pathlib
import random

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import grainjet
from grainjet import coupled_box as box, dictionaries, scripts

HERE = pathlib.Path(__file__).resolve().parent
WIDTH, DEPTH, HEIGHT = 0.09, 0.008, 0.3             # m
D, DENSITY, GRAINS = 1.545e-3, 1150.0, 17562
YOUNG = 5e5                                         # Pa
RHO, NU, U = 1.28, 1.33e-5, 0.9
FILTER = 4*D
FLUID_STEP, DEM_STEP = 2e-4, 4e-5                   # s
END, FIRST = 4.0, 2.0                               # s: the measurement begins at 2 s
SAMPLE = 50                                         # fluid steps from sample to sample
PROBE = 0.045                                       # m, height of the pressure

WALLS = "\n".join(
    f"fix {name} all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 {plane}"
    for name, plane in (("left", "xplane 0"), ("right", f"xplane {WIDTH}"), ("front", "yplane 0"),
                        ("back", f"yplane {DEPTH}"), ("floor", "zplane 0")))

FIXES = f"""
fix m5 all property/global coefficientRollingFriction peratomtypepair 1 0.025
fix contact all hertz/cg tangential history rolling cdt
{WALLS}
compute top all reduce max z
compute middle all reduce ave z
fix heights all print {SAMPLE*5} "$(step*dt) $(c_top) $(c_middle)" file heights.txt screen no title "time top middle"
dump places all custom {SAMPLE*5} places.dump z
dump_modify places format "%.5g"
"""


def write(case):
    box.write(case, velocity=f"(0 0 {U})", walls=True, through=True, nu=NU, rho=f"rho [1 -3 0 0 0 0 0] {RHO};",
              delta_t=FLUID_STEP, steps=round(END/FLUID_STEP), write_every=2500, cells="20 2 60", convection="upwind",
              size=[1e3*s for s in (WIDTH, DEPTH, HEIGHT)],
              functions=f"""
    bottom {{ type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name zlo; operation areaAverage;
             fields (p); writeFields no; log no; writeControl timeStep; writeInterval {SAMPLE}; }}
    above {{ type probes; libs (sampling); fields (p); probeLocations (({WIDTH/2} {DEPTH/2} {PROBE}));
            writeControl timeStep; writeInterval {SAMPLE}; }}""")
    # No layer of the air at the walls, which would be thinner than a grain; the bed stands on the inlet
    dictionaries.write_field(case, "U", "0 1 -1", f"(0 0 {U})", f"""
".*" {{ type slip; }} zlo {{ type fixedValue; value uniform (0 0 {U}); }}
zhi {{ type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); }}""")
    dictionaries.change(case/"0/p", ("zlo { type zeroGradient; }", "zlo { type fixedFluxExtrapolatedPressure; }"))
    box.fv_options(
        case, drag="DiFelice", forces="(pressureGradient viscous buoyancy)", couplingInterval="5",
        voidFraction=f"{{ model divided; equations full; filter {{ length {FILTER!r}; }} }}")
    box.script(case, grains="", dt=DEM_STEP, boundary="f f f", gravity="fix g all gravity 9.81 vector 0 0 -1",
               plugins="plugin load hertzcgplugin.so\nsoft_particles yes", fixes=FIXES,
               box=f"0 {WIDTH} 0 {DEPTH} 0 {HEIGHT}")
    dictionaries.change(case/"constant/in.particles", ("5.e6", repr(YOUNG)), ("1 0.2", "1 0.3"),
                        ("plugin load hertzcgplugin.so\nsoft_particles yes\nunits si",
                         "plugin load hertzcgplugin.so\nunits si\nsoft_particles yes"))
    rng, spacing = random.Random(1), 1.6e-3
    across, deep = int(WIDTH/spacing), int(DEPTH/spacing)
    places = [((i + 0.5)*WIDTH/across, (j + 0.5)*DEPTH/deep, (k + 0.5)*spacing)
              for k in range(GRAINS//(across*deep) + 1) for j in range(deep) for i in range(across)][:GRAINS]
    grains = [(1, D, DENSITY, place, [rng.gauss(0, 0.02) for _ in range(3)]) for place in places]
    (case/"constant/new.grains").write_text("read_data constant/grains.data\n")
    (case/"constant/grains.data").write_text(scripts.data(grains, ((0, WIDTH), (0, DEPTH), (0, HEIGHT))))


def columns(path):
    """Rows of numbers of a table, the first column in front; titles and incomplete rows are left out."""
    rows = [line.replace(",", " ").split() for line in path.read_text().splitlines() if line[:1].isdigit() or line[:1] == " "]
    return numpy.array([row for row in rows if len(row) == len(rows[0])], float).T


def frequency(time, values):
    """How often per second values rise through their mean."""
    x = values - values.mean()
    return ((x[1:] > 0) & (x[:-1] <= 0)).sum()/(time[-1] - time[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--reference", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    case = arguments.work/"bed"
    if not case.exists():
        write(case)
        for program in ("blockMesh", "pimpleFoam"):
            done = grainjet.run([program], case, timeout=20000)
            if done.code:
                raise SystemExit(f"{case}: {program}\n{done.output[-3000:]}")

    t, h = columns(arguments.reference/"beds/pseudo2d_height.csv")
    measured_t = numpy.arange(t[0], t[-1], 0.01)
    measured = numpy.interp(measured_t, t, h)
    time, top, middle = columns(case/"heights.txt")
    late = time >= FIRST
    floor_t, floor = columns(next(case.glob("postProcessing/bottom/0/*.dat")))
    floor_t, floor = floor_t[floor_t >= FIRST], RHO*floor[floor_t >= FIRST]
    weight = GRAINS*math.pi/6*D**3*(DENSITY - RHO)*9.81/(WIDTH*DEPTH)
    rows = [["", "mean height mm", "rms mm", "lowest mm", "highest mm", "bubbles per s"]]
    for name, at, y in (("measured", measured_t, measured), ("highest grain", time[late], top[late]),
                        ("twice the mean height", time[late], 2*middle[late])):
        rows.append([name, *(f"{1e3*v:.1f}" for v in (y.mean(), y.std(), y.min(), y.max())), f"{frequency(at, y):.2f}"])
    rows.append(["by pressure at the floor", "", "", "", "", f"{frequency(floor_t, floor):.2f}"])
    rows.append([f"pressure drop/weight {floor.mean()/weight:.3f}; until {time[-1]:.2f} s", "", "", "", "", ""])
    print(*("  ".join(row) for row in rows), sep="\n")
    with open(HERE/"results/pseudo2d.csv", "w", newline="") as file:
        csv.writer(file).writerows(rows)

    figure, axes = plt.subplots(figsize=(8, 3.6), constrained_layout=True)
    axes.plot(t, 1e3*h, color="black", linewidth=0.9, label="measured")
    axes.plot(time[late], 1e3*top[late], linewidth=0.9, label="highest grain")
    axes.plot(time[late], 2e3*middle[late], linewidth=0.9, label="twice the mean height")
    axes.set(xlabel="time, s", ylabel="height of the bed, mm", ylim=(60, 180))
    axes.legend(fontsize="small")
    figure.savefig(HERE/"results/pseudo2d.png", dpi=110)


if __name__ == "__main__":
    main()
