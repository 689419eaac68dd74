#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimum fluidisation: the pressure drop of a bed while the air is turned up and down again.

    fluidisation.py <work folder>

Grains of 1 mm in a column that is periodic across, on a floor through which the air comes. The pressure drop, less what accelerates
the grains, is compared with the weight of the bed. U_mf is where the law fitted to the drops of the bed at rest, A U + B U^2,
reaches that weight. Beside it: that of the drag law with the bed's own void fraction, layer by layer and as one number.
Writes results/fluidisation.csv, fluidisation_ramp.csv and .png.
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
import laws
from grainjet import coupled_box as box, dictionaries, scripts

HERE = pathlib.Path(__file__).resolve().parent
RHO, NU = 1.2, 1.5e-5
D, DENSITY = 1e-3, 1000.0
FILTER, CELL = 4*D, 2*D
FLUID_STEP, DEM_STEP, SETTLE = 1e-4, 2e-5, 8000     # s, s, DEM steps
SAMPLE = 20                                         # fluid steps
LAWS = {"Ergun": laws.ergun, "Gidaspow": laws.gidaspow}

FIXES = """
fix contact all hertz/cg tangential history
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0
compute middle all reduce ave z
compute speed all reduce ave vz
{settle}
fix heights all print {every} "$(c_middle) $(c_speed)" file heights.txt screen no title "middle speed"
"""


class Bed:
    """A bed of a number of grains on a square of so many cells, and the ramp of the air."""

    def __init__(self, grains=2000, across=4, height=0.064, law="Ergun", low=0.05, high=0.32, up=0.3, hold=0.3, down=0.5):
        self.grains, self.across, self.height, self.law = grains, across, height, law
        self.low, self.high = low, high
        self.times = numpy.cumsum([0, up, hold, down])
        self.speeds = [low, high, high, low]
        if hold + down == 0:
            self.times, self.speeds = self.times[:2], self.speeds[:2]
        self.width = across*CELL
        self.area = self.width**2
        self.steps = round(self.times[-1]/FLUID_STEP)

    @property
    def weight(self):
        """Of the grains less that of the air that they displace, over the area [Pa]."""
        return self.grains*numpy.pi/6*D**3*(DENSITY - RHO)*laws.G/self.area

    def write(self, case):
        size = (self.width, self.width, self.height)
        box.write(case, velocity="(0 0 0)", nu=NU, through=True, convection="upwind", delta_t=FLUID_STEP, steps=self.steps, write_every=500,
                  cells=f"{self.across} {self.across} {round(self.height/CELL)}", size=[1e3*x for x in size],
                  functions=f"""floor {{ type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name zlo;
                  operation areaAverage; fields (p); writeFields no; log no; writeControl timeStep; writeInterval {SAMPLE}; }}""")
        dictionaries.change(case/"system/fvSolution", (
            "solvers\n{", "solvers\n{ grainFilter { solver PCG; preconditioner DIC; tolerance 1e-9; relTol 0; }\n"),
            ("tolerance 1e-13", "tolerance 1e-8"))
        # The bed stands on the inlet: the pressure there goes on as in the bed
        dictionaries.write_field(case, "p", "0 2 -2", 0, """
".*" { type cyclic; } zlo { type fixedFluxExtrapolatedPressure; } zhi { type fixedValue; value uniform 0; }""")
        table = " ".join(f"({t} (0 0 {u}))" for t, u in zip(self.times, self.speeds))
        dictionaries.write_field(case, "U", "0 1 -1", f"(0 0 {self.low})", f"""
".*" {{ type cyclic; }} zhi {{ type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); }}
zlo {{ type uniformFixedValue; uniformValue table ({table}); }}""")
        box.fv_options(case, drag=self.law, forces="(pressureGradient viscous buoyancy)", couplingInterval="5",
                       voidFraction=f"{{ model divided; equations full; filter {{ length {FILTER!r}; }} }}")
        settle = f'if "${{continued}} == 0" then "run {SETTLE}"'
        box.script(case, grains="", dt=DEM_STEP, boundary="p p f", gravity=f"fix g all gravity {laws.G} vector 0 0 -1",
                   plugins="plugin load hertzcgplugin.so", box=f"0 {self.width} 0 {self.width} 0 {self.height}",
                   fixes=FIXES.format(every=SAMPLE*round(FLUID_STEP/DEM_STEP), settle=settle))
        dictionaries.change(case/"constant/in.particles", ("units si", "units si\nsoft_particles yes"), ("5.e6", "5.e5"))
        rng, across = random.Random(1), int(self.width/(1.2*D) + 1e-9)
        spacing = self.width/across
        places = [((i + 0.5)*spacing + rng.uniform(-0.1, 0.1)*D, (j + 0.5)*spacing + rng.uniform(-0.1, 0.1)*D, (k + 0.55)*1.08*D)
                  for k in range(self.grains//across**2 + 1) for j in range(across) for i in range(across)][:self.grains]
        (case/"constant/new.grains").write_text("read_data constant/grains.data\n")
        (case/"constant/grains.data").write_text(scripts.data(
            [(1, D, DENSITY, place, [rng.gauss(0, 0.05) for _ in range(3)]) for place in places],
            [(0, x) for x in size]))

    def drop(self, voids, U):
        """Pressure drop [Pa] by the law over layers of cells."""
        return sum(LAWS[self.law](e, D, U, RHO, RHO*NU) for e in voids if e < 1 - 1e-9)*CELL


class Ramp:
    """What came out: the drop over rising and falling velocity, U_mf of both."""

    def __init__(self, bed, case):
        self.bed, self.case = bed, pathlib.Path(case)
        table = next(self.case.glob("postProcessing/floor/0/*.dat")).read_text().splitlines()
        self.time, p = numpy.array([line.split() for line in table if line[0] != "#"], float).T
        table = (self.case/"heights.txt").read_text().splitlines()[1:]
        self.middle, speed = numpy.array([line.split() for line in table], float).T[:, -len(p):]
        self.drop = RHO*p/bed.weight
        self.U = numpy.interp(self.time, bed.times, bed.speeds)
        mass = bed.grains*numpy.pi/6*D**3*DENSITY
        # What the air and the grains on the floor carry is the weight and what accelerates the grains
        self.carried = self.drop - mass*numpy.gradient(speed, self.time)/bed.area/bed.weight

        self.rising = self.branch(self.time < bed.times[1])
        # The whole bed is lifted, and not yet expanded
        lifted = (self.time < bed.times[1]) & (self.U > 1.03*self.rising["U_mf"]) & (self.U < 1.15*self.rising["U_mf"])
        self.lifted = self.carried[lifted].mean()
        if len(bed.times) > 2:
            held = (self.time > bed.times[1]) & (self.time < bed.times[2])
            self.held = self.drop[held].mean()
            self.falling = self.branch(self.time > bed.times[2])

    def branch(self, mask):
        """U_mf from the bed at rest, and that of the law with the void fractions of a time in this branch."""
        bed = self.bed
        latest_lifted = 0 if mask[0] else self.time[mask & (self.drop > 0.8)].max(initial=0)
        rest = mask & (self.drop < 0.8) & (self.time > latest_lifted)
        u = self.U[rest]
        A, B = numpy.linalg.lstsq(numpy.column_stack([u, u**2]), self.drop[rest], rcond=None)[0]
        umf = laws.carrying(lambda v: A*v + B*v**2, 1.0, 10)
        written = [f.parent for f in self.case.glob("*/voidFraction")]
        # The bed at rest at the largest velocity
        first, last = self.time[rest].min() - 1e-9, self.time[rest].max() + 1e-9
        at = max((f for f in written if first <= float(f.name) <= last),
                 key=lambda f: numpy.interp(float(f.name), self.time, self.U))
        voids = numpy.array(dictionaries.internal(at/"voidFraction")).reshape(-1, bed.across**2).mean(1)
        # One void fraction: that of a bed with this mean height and a sharp top
        e = 1 - bed.grains*numpy.pi/6*D**3/(bed.area*2*numpy.interp(float(at.name), self.time, self.middle))
        layers = laws.carrying(lambda v: bed.drop(voids, v), bed.weight)
        one = laws.carrying(lambda v: LAWS[bed.law](e, D, v, RHO, RHO*NU), (1 - e)*(DENSITY - RHO)*laws.G)
        return {"U_mf": umf, "U_mf of law, layers": layers, "ratio": umf/layers, "e": e, "U_mf of law, one e": one, "ratio to it": umf/one}


def run(bed, case):
    if not (case/"log.pimpleFoam").exists():
        bed.write(case)
        for program in ("blockMesh", "pimpleFoam"):
            done = grainjet.run([program], case, timeout=3000)
            if done.code:
                raise SystemExit(f"{case}: {program}\n{done.output[-3000:]}")
            (case/f"log.{program}").write_text(done.output)
    return Ramp(bed, case)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    work = parser.parse_args().work
    rows = []
    figure, axes = plt.subplots(figsize=(6, 3.8), constrained_layout=True)
    curves = []
    for law in LAWS:
        bed = Bed(law=law)
        found = run(bed, work/law)
        for name, branch in (("rising", found.rising), ("falling", found.falling)):
            rows.append([law, name, *(f"{x:.4f}" for x in (found.lifted, found.held, *branch.values()))])
            print(*rows[-1], sep="  ", flush=True)
            mask = found.time < bed.times[1] if name == "rising" else found.time > bed.times[1]
            axes.plot(found.U[mask], found.drop[mask], linewidth=0.8, linestyle="-" if law == "Ergun" else ":", label=f"{law}, {name}")
        curves += [[law, f"{t:.4f}", f"{u:.4f}", f"{y:.4f}"] for t, u, y in list(zip(found.time, found.U, found.drop))[::5]]
    rows.insert(0, ["law", "air", "carried/weight, lifted", "drop/weight, held", *found.rising])
    axes.axhline(1, color="black", linewidth=0.6)
    axes.set(xlabel="superficial velocity, m/s", ylabel="pressure drop over weight", ylim=(0, 1.6))
    axes.legend(fontsize="small")
    figure.savefig(HERE/"results/fluidisation.png", dpi=110)
    for name, lines in (("fluidisation", rows), ("fluidisation_ramp", [["law", "time", "U", "drop/weight"], *curves])):
        with open(HERE/f"results/{name}.csv", "w", newline="") as file:
            csv.writer(file).writerows(lines)


if __name__ == "__main__":
    main()
