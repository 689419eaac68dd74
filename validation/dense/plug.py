#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A porous plug of grains that moves through still fluid: the pressure in it against Bernoulli's, and how smooth it is.

    plug.py <work folder>

A crowd of grains of void fraction 0.4 moves at V = 1 m/s along a column of fluid at rest, without drag. The flux of the mixture is
zero everywhere. In the frame of the grains the fluid is steady, at - V before the plug and at - V/e in it, so

    p/rho = V^2/2 (1 - 1/e^2)

The filter smooths the ends of the plug. Grains stand in columns of a square lattice, each column at a height of its own; in step they
would all cross a face at the same time. With a ramp the columns also begin and end at heights of their own, so that the solid
fraction rises over some spacings. Writes results/plug.csv and .png.
"""

import argparse
import csv
import pathlib
import random

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import grainjet
from grainjet import coupled_box as box, dictionaries

HERE = pathlib.Path(__file__).resolve().parent
RHO, NU = 1.2, 1.5e-5
V, VOID = 1.0, 0.4                          # m/s, speed of the plug; its void fraction
D = 1e-3
SPACING = D*(numpy.pi/6/(1 - VOID))**(1/3)  # of the lattice; grains overlap by 4 %, without contacts
ACROSS = 8                                  # spacings
WIDTH, HEIGHT = ACROSS*SPACING, 160*SPACING
PLUG = (24, 88)                             # layers of the lattice with grains at the start
PROBE = 88*SPACING                          # here the pressure is watched: at the tip at first, then well inside
COURANT, PATH = 0.1, 4*ACROSS*SPACING       # of the plug, which moves by this
LENGTH = 4*D                                # of the filter
MESHES = {4: 2, 2: 4, 1: 8}                 # cell over spacing: cells across
BERNOULLI = 0.5*V**2*(1 - 1/VOID**2)        # m2/s2

# cell over spacing, what differs
CASES = [(cell, {"formulation": formulation}) for formulation in ("SetII", "SetI") for cell in MESHES]
CASES += [(2, {"length": 0.0}), (2, {"in_step": True}), (1, {"courant": 0.025, "formulation": "SetI"})]
CASES += [(4, {"ramp": 16, "courant": courant, "formulation": formulation})
          for courant, formulation in ((COURANT, "SetII"), (COURANT, "SetI"), (COURANT/4, "SetI"))]


def times(cells, courant=COURANT):
    """Cell [m], step [s], number of steps."""
    cell = WIDTH/cells
    step = float(f"{courant*cell/V:.4g}")
    return cell, step, round(PATH/V/step)


def write(case, cells, length=LENGTH, in_step=False, formulation="SetII", ramp=0, courant=COURANT):
    """The column with cells of WIDTH/cells."""
    cell, step, steps = times(cells, courant)
    probe = (WIDTH/2 - cell/2, WIDTH/2 - cell/2, PROBE - ramp/2*SPACING + cell/2)
    box.write(case, velocity="(0 0 0)", nu=NU, through=True, cells=f"{cells} {cells} {round(HEIGHT/cell)}", delta_t=step,
              steps=steps, size=[1e3*x for x in (WIDTH, WIDTH, HEIGHT)],
              functions=f"probe {{ type probes; libs (sampling); fields (p); probeLocations ({dictionaries.vector(probe)}); }}")
    rng = random.Random(1)
    phases = [[0 if in_step else rng.random() for _ in range(ACROSS)] for _ in range(ACROSS)]
    places = [((i + 0.37)*SPACING, (j + 0.41)*SPACING, (k + 0.29 + phases[i][j])*SPACING)
              for k in range(PLUG[0], PLUG[1] - ramp) for j in range(ACROSS) for i in range(ACROSS)]
    starts = list(range(ACROSS**2))
    random.Random(2).shuffle(starts)
    places = [(x, y, z + ramp*starts[n % ACROSS**2]/ACROSS**2*SPACING) for n, (x, y, z) in enumerate(places)]
    # So heavy that the pressure does not change their speed
    box.script(case, dt=step/2, boundary="p p f", box=f"0 {WIDTH} 0 {WIDTH} 0 {HEIGHT}",
               grains=box.grains(places, [(0, 0, V)]*len(places), D, 1e11))
    box.fv_options(case, "forces { pressureGradient {} viscous {} }", drag=None, forces=None, couplingInterval="2",
                   formulation=formulation,
                   voidFraction=f"{{ model divided; equations full; filter {{ length {length!r}; }} }}")


def roughness(p):
    """Rms of that by which the pressure of a step differs from the mean of the step before and behind it, over Bernoulli's."""
    return float(numpy.sqrt(numpy.mean((p[1:-1] - 0.5*(p[:-2] + p[2:]))**2))/abs(BERNOULLI))


class Result:
    """What a run of the column gave."""

    def __init__(self, case, cells, courant):
        end = max((f.parent for f in pathlib.Path(case).glob("*/voidFraction")), key=lambda f: float(f.name))
        cell, step, steps = times(cells, courant)
        along = round(HEIGHT/cell)

        def layers(name):
            return numpy.array(dictionaries.internal(end/name)).reshape(along, cells**2).mean(1)
        self.z, self.p, self.void = (numpy.arange(along) + 0.5)*cell, layers("p"), layers("voidFraction")
        middle = (sum(PLUG)/2 + 0.8)*SPACING + V*step*steps
        self.behind = self.p[self.z < middle - 44*SPACING].mean()/BERNOULLI
        self.uneven = abs(numpy.array(dictionaries.internal(end/"U"))).max()/V
        rows = [line.split() for line in (case/"postProcessing/probe/0/p").read_text().splitlines() if line[0] != "#"]
        self.time, self.history = numpy.array(rows, float).T
        late = self.history[steps//2:]                  # the probe lies deep in the plug
        self.pressure = late.mean()/BERNOULLI
        self.largest = abs(late - late.mean()).max()/abs(BERNOULLI)
        self.roughness = roughness(late)


def run(case, cells, **options):
    if not (case/"log.pimpleFoam").exists():
        write(case, cells, **options)
        for program in ("blockMesh", "pimpleFoam"):
            done = grainjet.run([program], case)
            if done.code:
                raise SystemExit(f"{case}: {program}\n{done.output[-3000:]}")
            (case/f"log.{program}").write_text(done.output)
    return Result(case, cells, options.get("courant", COURANT))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    work = parser.parse_args().work
    rows = [["cell/spacing", "formulation", "filter", "columns", "ramp", "Courant", "p/Bernoulli", "p behind/Bernoulli", "roughness",
             "largest deviation", "max U/V"]]
    figure, (along, over) = plt.subplots(1, 2, figsize=(11, 3.6), constrained_layout=True)
    for size, options in CASES:
        formulation = options.get("formulation", "SetII")
        name = "-".join([f"{size}", *(f"{key}-{value}" for key, value in options.items())])
        found = run(work/name, MESHES[size], **options)
        measured = (found.pressure, found.behind, found.roughness, found.largest, found.uneven)
        rows.append([size, formulation, f"{options.get('length', LENGTH)/D:g} d", "in step" if "in_step" in options else "out of step",
                     options.get("ramp", 0), options.get("courant", COURANT), *(f"{value:.4f}" for value in measured)])
        print(*rows[-1], sep="  ", flush=True)
        if options == {"formulation": "SetII"}:
            along.plot(found.z/D, found.p/abs(BERNOULLI), label=f"cell {size} spacings")
            over.plot(found.time, found.history/abs(BERNOULLI), label=f"cell {size} spacings")
    with open(HERE/"results/plug.csv", "w", newline="") as file:
        csv.writer(file).writerows(rows)
    along.axhline(-1, color="black", linewidth=0.6)
    along.set(xlabel="z/d", ylabel="pressure over Bernoulli's", title="along the column at the end")
    over.set(xlabel="time, s", title="at a cell that the plug reaches")
    for axes in (along, over):
        axes.legend(fontsize="small")
    figure.savefig(HERE/"results/plug.png", dpi=110)


if __name__ == "__main__":
    main()
