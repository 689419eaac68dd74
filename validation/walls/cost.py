# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Instructions that wallLaw adds, by valgrind's callgrind: per grain in a wall cell, per other grain, and per wall
cell and interval. With k and epsilon at the grains, too.

    source environment; python3 validation/walls/cost.py <new folder>

A channel of 12 x 16 x 12 cells, 288 of them at its walls; the difference between 6 and 2 fluid steps of one rank,
in libliggghtsCoupling.so itself.
"""

import pathlib
import random
import sys

HERE = pathlib.Path(__file__).resolve().parent
for folder in ("testing", "benchmarks/coupling", "../openfoam-libs/liggghtsCoupling/tests"):
    sys.path.insert(0, str(HERE.parent / folder))

from grainjet import coupled_box, dictionaries, programs, wall_flow      # noqa: E402
import instructions                                             # noqa: E402
import user_library                                             # noqa: E402

NU, SIZE, N, U_TAU = 1.5e-5, 0.02, 16, 0.36
CELL = SIZE / N
WALL_CELLS = 2 * 12 * 12
PERIODIC = {side: (f"cyclic; neighbourPatch {other}", side)
            for side, other in (("xlo", "xhi"), ("xhi", "xlo"), ("zlo", "zhi"), ("zhi", "zlo"))}


def make(folder):
    # one iteration of each solver: the fluid does not count
    centres = wall_flow.mesh(
        folder, wall_flow.channel((SIZE,) * 3, f"12 {N} 12", {"walls": ("wall", "ylo yhi"), **PERIODIC}), nu=NU,
        steps=2, write_every=1000, libs=user_library.libs("probeModels"))
    dictionaries.change(folder / "system/fvSolution", ("relTol 0;", "relTol 0; maxIter 1;"))
    y = [min(p[1], SIZE - p[1]) for p in centres]
    wall_flow.impose(folder, [(U_TAU * wall_flow.spalding(d * U_TAU / NU), 0, 0) for d in y],
                     k=[U_TAU ** 2 / 0.3] * len(y), epsilon=[U_TAU ** 3 / (0.41 * d) for d in y])


def count(folder, places, **options):
    """Instructions of the library per fluid step."""
    coupled_box.script(folder, grains=coupled_box.grains(places, [(0, 0, 0)] * len(places), 1e-5), boundary="p f p",
                       box=f"0 {SIZE} 0 {SIZE} 0 {SIZE}")
    coupled_box.fv_options(folder, coupling="oneWay", **{"forces": "()", **options})
    found = []
    for steps in (2, 6):
        dictionaries.put(folder / "system/controlDict", endTime=f"{steps * 1e-4!r}")
        for old in folder.glob("callgrind.*"):
            old.unlink()
        result = programs.run(["valgrind", "-q", "--tool=callgrind", "--separate-threads=yes", "--trace-children=yes",
                               "--callgrind-out-file=callgrind.%p", "pimpleFoam"], folder)
        if result.code:
            raise SystemExit(result)
        counts = map(instructions.count, folder.glob("callgrind.*-01"))
        found.append(max(counts, key=lambda c: c["all"])["libliggghtsCoupling.so"])
    return (found[1] - found[0]) / 4


def main(work):
    make(work)
    def grains(n, low, high):
        rng = random.Random(1)      # the same with and without
        return [(rng.uniform(0, SIZE), rng.uniform(low, high), rng.uniform(0, SIZE)) for _ in range(n)]

    few, many = 100, 900
    for name, options in (("velocity", {}), ("velocity, k, epsilon", {
            "drag": None, "forces": "{ drag { model Gidaspow; } probe { quantities (k epsilon); } }"})):
        at = {}
        for where, low, high in (("wall cells", 1e-5, CELL), ("elsewhere", 3 * CELL, SIZE - 3 * CELL)):
            for wall_law in ("no", "yes"):
                at[where, wall_law] = [count(work, grains(n, low, high), wallLaw=wall_law, **options)
                                       for n in (few, many)]
            off, on = ([(b - a) / (many - few)] for a, b in (at[where, "no"], at[where, "yes"]))
            print(f"{name}, {where}: {off[0]:.0f} instructions per grain without, {on[0]:.0f} with wallLaw", flush=True)
        off, on = (at["elsewhere", w][0] for w in ("no", "yes"))
        print(f"{name}: {(on - off) / WALL_CELLS:.0f} instructions more per wall cell and interval", flush=True)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
