#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Instructions that fix collision/stats adds to a DEM step, and those of fix hertz/cg without it.

    source environment; validation/benchmarks/collision_stats/run.py [--before hertzcgplugin.so]

Counted by valgrind's callgrind on one rank: the difference between runs of 400 and 1200 steps, per grain and step. Two gases of
1,000 grains in a periodic box: dilute (solid fraction 0.04, 2 % of the grains in contact) and crowded (0.5 of soft grains,
about one contact for each). --before: the library of another build, to see what being observable costs who does
not observe. Takes one minute.
"""

import argparse
import pathlib
import random
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "coupling"))

from grainjet import programs, scripts       # noqa: E402
import instructions                          # noqa: E402

D, SIDE = 0.001, 10          # m, grains along an edge of the box
CASES = {"dilute": 0.04, "crowded": 0.5}
STEPS = (400, 1200)
SKIP = "--trace-children-skip=*/orted,*/sh,*/dirname,*/grep,*/head,*/readlink"      # what the launcher and MPI start

SCRIPT = """
plugin load {library}
{load}
atom_style granular
atom_modify map array
boundary p p p
newton off
communicate single vel yes
units si
read_data data
neighbor 0.0005 bin
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
fix c all hertz/cg
fix i all nve/sphere
{fix}
timestep 2e-6
thermo_style custom step f_c[1] f_c[2]
run {steps}
"""

LOAD = "plugin load collisionstatsplugin.so"
FIX = "fix k all collision/stats contact c every 1000 file collisions.csv"


def data(path, fraction):
    """A loose lattice whose grains fly in random directions."""
    rng = random.Random(4)
    pitch = D * (3.14159265 / 6 / fraction) ** (1 / 3)
    places = [(i, j, k) for i in range(SIDE) for j in range(SIDE) for k in range(SIDE)]
    path.write_text(scripts.data(
        [(1, D, 2500.0, [(p + 0.5) * pitch for p in place], [rng.gauss(0, 1.0) for _ in range(3)]) for place in places],
        ((0, SIDE * pitch),) * 3))


def count(folder, library, watched):
    """Instructions per grain and step, contacts and collisions at the end."""
    found = []
    for steps in STEPS:
        (folder / "in.count").write_text(SCRIPT.format(library=library, load=LOAD if watched else "", fix=FIX if watched else "",
                                                       steps=steps))
        for old in folder.glob("callgrind.*"):
            old.unlink()
        result = programs.run(["valgrind", "-q", "--tool=callgrind", "--separate-threads=yes", "--trace-children=yes", SKIP,
                               "--callgrind-out-file=callgrind.%p", "liggghts-plugins", "-in", "in.count"], folder, timeout=900)
        if result.code:
            raise SystemExit(result)
        found.append(max(instructions.count(path)["all"] for path in folder.glob("callgrind.*-01")))
    rows = [line.split() for line in result.output.split("\n") if line.split()[:1] == [str(STEPS[1])]]
    return (found[1] - found[0]) / (STEPS[1] - STEPS[0]) / SIDE ** 3, float(rows[0][1]), float(rows[0][2])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--before", help="hertzcgplugin.so of another build")
    before = parser.parse_args().before
    print("case,contacts_per_grain,collisions_per_grain,before,off,on,off_over_before,on_over_off")
    for case, fraction in CASES.items():
        with tempfile.TemporaryDirectory() as work:
            folder = pathlib.Path(work)
            data(folder / "data", fraction)
            old = count(folder, before, False)[0] if before else float("nan")
            off, contacts, collisions = count(folder, "hertzcgplugin.so", False)
            on = count(folder, "hertzcgplugin.so", True)[0]
            print(f"{case},{contacts / SIDE ** 3:.3f},{collisions / SIDE ** 3:.2f},{old:.1f},{off:.1f},{on:.1f},{off / old:.5f},"
                  f"{on / off:.4f}", flush=True)


if __name__ == "__main__":
    main()
