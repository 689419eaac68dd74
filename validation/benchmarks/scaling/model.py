#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of a fluid step on a cluster, from counts of messages and stated latency and bandwidth.

    T = n_cells c_cell + n_grains c_grain + N_m L + N_b/B + N_c log2(P) L

of the rank with most work: n its cells and grains, N_m its messages to neighbours, N_b their bytes, N_c its collective operations, L latency and B
bandwidth of the network, P ranks (a LogP-like model: Culler et al., PPoPP 1993; collectives as trees of log2(P) stages: Thakur et al., IJHPCA 19
(2005) 49). Nothing overlaps, so it errs on the slow side. Where the numbers come from: README.md.

    validation/benchmarks/scaling/model.py [--cases quickJet medium full] [--ranks 16 64 ...] [--latency US] [--bandwidth GB/S]
"""

import argparse
import collections
import math

# What a rank does in a fluid step of one solver iteration more or less, see README.md: counts of quickJet with 5 sub-steps on 16 ranks
Counts = collections.namedtuple("Counts", "collectives exchanges bytes_per_face messages neighbours")
Case = collections.namedtuple("Case", "cells grains dem_steps sub_steps")
Network = collections.namedtuple("Network", "latency bandwidth")
Part = collections.namedtuple("Part", "work messages bytes collectives")
