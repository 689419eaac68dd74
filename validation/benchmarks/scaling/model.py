#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of a fluid step on a cluster, from counted messages and a stated latency and bandwidth.

    T = work + messages L + bytes/B + collectives log2(P) L

of the rank with most work, on P ranks: latency L, bandwidth B of a rank's share of its node's network. A message costs a latency, a collective
operation a tree of log2(P) of them, and nothing overlaps, so it errs on the slow side (after LogP: Culler et al., PPoPP 1993; trees of collectives:
Thakur, Rabenseifner, Gropp, IJHPCA 19 (2005) 49). Where the numbers come from is said beside each.

    validation/benchmarks/scaling/model.py [--latency US] [--bandwidth GB/S] [--ranks-per-node N] [--ranks P ...]
"""

import argparse
import collections
import math

# exchanges: with the grains, in a fluid step; dem_steps: between two of them
Case = collections.namedtuple("Case", "cells grains exchanges dem_steps")
# of the rank with most work in a fluid step: s of work, messages, bytes, collective operations
Part = collections.namedtuple("Part", "work messages bytes collectives")

# Cells and grains of Hardalupas1 and of the case with most grains, validation/cases/report.md; steps of cases/parameters.toml
CASES = {
    "quickJet": Case(33_408, 5_000, 5, 10),
    "Hardalupas1-medium": Case(640_032, 72_158, 5, 14),
    "Hardalupas1-full": Case(3_811_840, 72_158, 5, 10),
    "Hardalupas4-full": Case(3_811_840, 2_489_721, 5, 10),
}

# Unit costs of one core [s], validation/cases/report.md: "What a medium and a full case cost"
CELL = 1.90e-6              # cell and fluid step
GRAIN_DEM = 95e-9           # grain and DEM step
GRAIN_EXCHANGE = 1.81e-6    # grain and exchange

# Latency [s] and bandwidth [B/s] of a node: Open MPI over Ethernet of 40 Gb/s with usNIC, half round trip 1.93 us, 37.23 Gb/s
# (Squyres, "MPI over 40Gb Ethernet", Cisco, 2014)
LATENCY = 1.93e-6
BANDWIDTH = 37.23e9/8
RANKS_PER_NODE = 64

# Neighbours of a rank in a mesh cut into compact parts
NEIGHBOURS = 14

# Counted with run.py and load.py, see README.md
FLUID_COLLECTIVES = 250     # quickJet's solver in a fluid step: reductions of its linear solvers
FLUID_MESSAGES = 150        # to each neighbour
FLUID_BYTES = 2000          # per face between ranks
DEM_MESSAGES = 4            # LIGGGHTS: per DEM step, a stream in slices
DEM_COLLECTIVES = 1         # LIGGGHTS: per DEM step, whether lists are to be rebuilt
DEM_BYTES = 100             # per grain near a cut and DEM step
COUPLING_COLLECTIVES = (2, 5)   # per fluid step, and per exchange: the limits that tests/case_collectives.py holds
CONTACT_COLLECTIVES = 3     # per fluid step: fix hertz/cg, contacts and Rayleigh time of the log
COUPLING_MESSAGES = 8       # per exchange and neighbour
GRAIN_BYTES = 300           # per exchange and grain: all grains remote
OCCUPIED = 0.3              # part of the cells, and so of the ranks, that hold the grains of a jet


def stages(ranks):
    """Latencies of one collective operation."""
    return math.ceil(math.log2(ranks)) if ranks > 1 else 0


def faces(cells, ranks):
    """Faces that a rank shares with others: those of a cube of its cells."""
    return 6*(cells/ranks)**(2/3) if ranks > 1 else 0


def parts(case, ranks, balanced):
    """{fluid, grains, coupling: Part} of a fluid step. balanced: ranks have as many grains each; else grains lie on the ranks of the
    cells that the jet occupies, and a rank there has as many cells as all."""
    neighbours = min(NEIGHBOURS, ranks - 1)
    grains = case.grains/ranks if balanced or ranks == 1 else min(case.grains, case.grains/max(1, OCCUPIED*ranks))
    steps = case.exchanges*case.dem_steps
    apart = ranks > 1
    per_step, per_exchange = COUPLING_COLLECTIVES
    return {
        "fluid": Part(CELL*case.cells/ranks, FLUID_MESSAGES*neighbours, FLUID_BYTES*faces(case.cells, ranks), FLUID_COLLECTIVES),
        "grains": Part(GRAIN_DEM*grains*steps, DEM_MESSAGES*steps*apart, DEM_BYTES*grains**(2/3)*steps*apart, DEM_COLLECTIVES*steps),
        "coupling": Part(GRAIN_EXCHANGE*grains*case.exchanges, COUPLING_MESSAGES*neighbours*case.exchanges,
                         GRAIN_BYTES*grains*case.exchanges*apart, per_step + CONTACT_COLLECTIVES + per_exchange*case.exchanges),
    }


def network(part, ranks, latency, bandwidth):
    """Seconds of a part's messages and collective operations."""
    if ranks == 1:
        return 0.0
    return part.messages*latency + part.bytes/bandwidth + part.collectives*stages(ranks)*latency


def step(case, ranks, latency=LATENCY, bandwidth=BANDWIDTH/RANKS_PER_NODE, balanced=False):
    """{name: seconds} of a fluid step: work, and the network of fluid, grains and coupling."""
    found = parts(case, ranks, balanced)
    return {"work": sum(part.work for part in found.values()),
            **{name: network(part, ranks, latency, bandwidth) for name, part in found.items()}}


def total(*arguments, **options):
    return sum(step(*arguments, **options).values())


def rows(case, ranks, strong, **options):
    """(P, seconds by name, efficiency) of a case, on ever more ranks, or ever larger with the number of ranks."""
    alone = total(case, 1, **options)
    for p in ranks:
        size = case if strong else case._replace(cells=case.cells*p, grains=case.grains*p)
        seconds = step(size, p, **options)
        yield p, seconds, alone/sum(seconds.values())/(p if strong else 1)


def per_rank(case, cells):
    """What a rank with so many cells has of a case, for a series in which the case grows with the ranks."""
    return case._replace(cells=cells, grains=case.grains*cells/case.cells)


def table(title, found):
    print(f"\n{title}\n\n| ranks | step, ms | work, ms | fluid's network, ms | grains' network, ms | coupling's network, ms | efficiency |\n"
          + 7*"|---" + "|")
    for p, seconds, efficiency in found:
        print(f"| {p:,} | {1e3*sum(seconds.values()):.2f} | " + " | ".join(f"{1e3*seconds[name]:.2f}" for name in ("work", "fluid", "grains", "coupling"))
              + f" | {efficiency:.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--latency", type=float, default=1e6*LATENCY, help="us")
    parser.add_argument("--bandwidth", type=float, default=1e-9*BANDWIDTH, help="of a node, GB/s")
    parser.add_argument("--ranks-per-node", type=int, default=RANKS_PER_NODE)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 16, 64, 256, 1024, 4096])
    given = parser.parse_args()
    options = {"latency": 1e-6*given.latency, "bandwidth": 1e9*given.bandwidth/given.ranks_per_node}
    for name, case in CASES.items():
        table(f"strong: {name}, {case.cells:,} cells, {case.grains:,} grains", rows(case, given.ranks, True, **options))
    for name in ("Hardalupas1-full", "Hardalupas4-full"):
        case = per_rank(CASES[name], 30_000)
        table(f"weak: {case.cells:,} cells and {case.grains:,.0f} grains a rank, as {name}", rows(case, given.ranks, False, **options))


if __name__ == "__main__":
    main()
