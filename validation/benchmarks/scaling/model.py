#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of a fluid step on a cluster, from counted messages and a stated latency and bandwidth.

    T = work + messages L + bytes/B + collectives log2(P) L

of the rank with most work, on P ranks: latency L, bandwidth B of a rank's share of its node's network. A message costs a latency, a collective
operation a tree of log2(P) of them, and nothing overlaps, so it errs on the slow side (after LogP: Culler et al., PPoPP 1993; trees of collectives:
Thakur, Rabenseifner, Gropp, IJHPCA 19 (2005) 49). Where the numbers come from is said beside each.

    validation/benchmarks/scaling/model.py [--latency US] [--bandwidth GB/S] [--ranks-per-node N] [--balanced] [--ranks P ...]
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
    "quickJet": Case(46_020, 4_600, 5, 10),
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
RANKS_PER_NODE = 16        # cores of those nodes

# Neighbours of a rank in a mesh cut into compact parts
NEIGHBOURS = 14             # assumed

# Counted in quickJet on 4 ranks, quarters, 46,020 cells, 4,600 grains, in a fluid step of 5 exchanges and 50 DEM steps: the fluid 1,567
# collective operations, 2,920 messages, 17.7 MB; LIGGGHTS with fix hertz/cg and insertion 198, 275 and 1.1 MB; the coupling 135 messages, 5.95 MB,
# nearly all of it values at points between ranks (cellPoint). A quarter has 2 neighbours and 4,270 faces to them
FLUID_COLLECTIVES = 1567    # reductions of the linear solvers: as many on a finer mesh, which needs more iterations
FLUID_MESSAGES = 1460       # to each neighbour
FLUID_BYTES = 4150          # per face between ranks
DEM_MESSAGES = 5.5          # per DEM step
DEM_COLLECTIVES = 4         # per DEM step: whether lists are to be rebuilt, and for each new list
DEM_BYTES = 190             # per DEM step and grain near a cut, (grains of the rank)^(2/3) of them
COUPLING_COLLECTIVES = (2, 5)   # per fluid step, and per exchange: the limits that tests/case_collectives.py holds
OTHER_COLLECTIVES = 11      # per fluid step of quickJet: fix hertz/cg 3, sampling planes 4, lift 2, dispersion 1, grains that left 1
COUPLING_MESSAGES = 13      # per exchange and neighbour
POINT_BYTES = 279           # per exchange and face between ranks: values at points
GRAIN_BYTES = 525           # per exchange and remote grain: load.py, 484 and 1248 kB with 0.20 and 0.52 of 4,600 grains
REMOTE = 0.1                # part of the grains that is remote: load.py, with weights
OCCUPIED = 0.4              # part of the cells, and so of the ranks, with grains of a jet: quickJet, 0.05 grains a cell or more


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
                         case.exchanges*(GRAIN_BYTES*REMOTE*grains*apart + POINT_BYTES*faces(case.cells, ranks)), per_step + OTHER_COLLECTIVES + per_exchange*case.exchanges),
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
    parser.add_argument("--balanced", action="store_true", help="ranks have as many grains each, as with weights")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 16, 64, 256, 1024, 4096])
    given = parser.parse_args()
    options = {"latency": 1e-6*given.latency, "bandwidth": 1e9*given.bandwidth/given.ranks_per_node, "balanced": given.balanced}
    for name, case in CASES.items():
        table(f"strong: {name}, {case.cells:,} cells, {case.grains:,} grains", rows(case, given.ranks, True, **options))
    for name in ("Hardalupas1-full", "Hardalupas4-full"):
        case = per_rank(CASES[name], 30_000)
        table(f"weak: {case.cells:,} cells and {case.grains:,.0f} grains a rank, as {name}", rows(case, given.ranks, False, **options))


if __name__ == "__main__":
    main()
