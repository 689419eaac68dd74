#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost of particleSamplingPlanes per step: 100,000 grains through 12 planes, coupled to LIGGGHTS.

    source environment; sampling_cost.py <work folder> [--grains 100000] [--steps 40] [--cells 20] [--interval 10]

A periodic box of 20 mm x 20 mm x 40 mm with 80 um grains that fly through air; --interval DEM steps of 1e-6 s per fluid step. OpenFOAM's
profiling gives the time of the function object and of the whole run; the start-up of the first steps is left out.
"""

import argparse
import pathlib
import re

import grainjet
from grainjet import coupled_box as box, dictionaries

DIAMETER = 80e-6      # m

SAMPLING = """
profiles
{
    type particleSamplingPlanes; libs ("libparticleSamplingPlanes.so");
    cloud liggghts; origin (0.01 0.01 0); axis (0 0 1); diameter 0.01;
    planes (0.3 0.6 0.9 1.2 1.5 1.8 2.1 2.4 2.7 3.0 3.3 3.6); radialBins 30; maxRadius 1; log no;
}
"""


def run(folder, *command):
    result = grainjet.run(command, folder, timeout=7200)
    (folder/f"log.{command[0]}").write_text(result.output)
    if result.code:
        raise SystemExit(repr(result))


def profile(folder, steps, delta_t):
    """Seconds of the function object and of the run after the first half of the steps."""
    def at(step):
        text = next((folder/f"{step*delta_t:.10g}"/"uniform").glob("profiling")).read_text()
        found = {}
        for description, total in re.findall(r'description\s+"?([^";]+)"?;.*?totalTime\s+([\d.eE+-]+);', text, re.DOTALL):
            found[description.strip()] = float(total)
        sampling = sum(t for name, t in found.items() if name.startswith("functionObject::profiles"))
        return sampling, max(found.values())
    first, last = at(steps//2), at(steps)
    return [b - a for a, b in zip(first, last)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--grains", type=int, default=100000)
    parser.add_argument("--steps", type=int, default=40)
    parser.add_argument("--cells", type=int, default=20, help="along the short sides of the box")
    parser.add_argument("--interval", type=int, default=10, help="DEM steps per fluid step")
    args = parser.parse_args()
    delta_t = args.interval*1e-6

    args.work.mkdir(parents=True, exist_ok=True)
    box.write(args.work, steps=args.steps, delta_t=delta_t, functions=SAMPLING, write_every=args.steps//2,
              cells=f"{args.cells} {args.cells} {2*args.cells}", control="profiling { active true; }")
    region = ("region inside block 0.0005 0.0195 0.0005 0.0195 0.0005 0.0395 units box\n"
              f"fix beads all particletemplate/sphere 15485863 atom_type 1 density constant 2950 radius constant {DIAMETER/2} volume_limit 1e-16\n"
              "fix mixture all particledistribution/discrete 32452843 1 beads 1.0\n"
              "fix pack all insert/pack seed 86028121 distributiontemplate mixture insert_every once overlapcheck no vel gaussian 0 0 5 0.3 0.3 1 "
              f"region inside particles_in_region {args.grains}\nrun 1\nunfix pack")
    box.script(args.work, grains=region, dt=1e-6)
    dictionaries.change(args.work/"constant/in.particles", ("neighbor 0.0005 bin", "neighbor 0.0003 bin"),
                        ("binsize 0.002", "binsize 0.0004"), ("sort 0 0", "sort 100 0.0005"))
    box.fv_options(args.work, couplingInterval=args.interval)
    run(args.work, "blockMesh")
    run(args.work, "pimpleFoam")
    sampling, whole = profile(args.work, args.steps, delta_t)
    steps = args.steps - args.steps//2
    print(f"{args.grains} grains, {2*args.cells**3} cells, 12 planes: sampling {1e3*sampling/steps:.2f} ms of "
          f"{1e3*whole/steps:.1f} ms per step, {100*sampling/whole:.2f} %")


if __name__ == "__main__":
    main()
