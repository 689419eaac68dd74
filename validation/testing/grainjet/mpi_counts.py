# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each rank of a program hands to MPI per fluid step, by who asks for it, and its memory: runs of a periodic box of cubes of
cells with grains at rest in moving air, under the counting layer validation/benchmarks/scaling/count_mpi.cpp.

Counts are those of a long run less those of a short one, so that what a start costs is not in them.
"""

import collections
import os
import pathlib
import shutil
import subprocess

from grainjet import coupled_box as box, dictionaries
from grainjet.programs import ROOT, done, mpirun

# How ranks cut the box, along x, y, z
BLOCKS = {1: (1, 1, 1), 2: (1, 1, 2), 4: (1, 2, 2), 8: (2, 2, 2), 16: (2, 2, 4), 32: (2, 4, 4)}
SLICES = {ranks: (1, 1, ranks) for ranks in BLOCKS}
CELLS, SIDE = 8, 8              # of the cube of a rank: cells along a side; mm
GRAINS = 512                    # in it
DIAMETER = 2e-4                 # m
DEM_STEP, INTERVAL = 1e-5, 10
KINDS = ("fluid", "grains", "coupled")
PARTS = ("fluid", "grains", "coupling")     # of a coupled run

# Of a rank and fluid step. messages: those from rank to rank that are no part of a collective operation; collectives: MPI's own and
# OpenFOAM's gathers from rank to rank, for whatever goes to all ranks
Figures = collections.namedtuple("Figures", "messages bytes neighbours collectives sites memory")


def build(folder):
    """The counting layer."""
    library = pathlib.Path(folder)/"libcountmpi.so"
    source = ROOT/"validation/benchmarks/scaling/count_mpi.cpp"
    subprocess.run(["mpicxx", "-DOMPI_SKIP_MPICXX", "-O2", "-fPIC", "-shared", source, "-o", library, "-ldl"], check=True)
    return library


def many(ranks):
    """The command prefix for more ranks than cores: a rank that waits lets others work. Also for one rank, which would start a
    daemon of its own, that is counted, too."""
    return [*mpirun(ranks), "--oversubscribe", "--mca", "mpi_yield_when_idle", "1"]


def _grains(low):
    """Commands that create one grain at a random place of each cell of a lattice, as many for each cube. All at once: single ones
    would need several collective operations each."""
    step = 1e-3*SIDE/round(GRAINS**(1/3))
    origin = " ".join(f"{(0.5 + a/step) % 1:.6g}" for a in low)
    return (f"lattice sc {step!r} origin {origin}\ncreate_atoms 1 box\nset group all diameter {DIAMETER!r} density 2500\n"
            f"displace_atoms all random {0.2*step!r} {0.2*step!r} {0.2*step!r} 15485863 units box")


def write_case(folder, kind, cut, cubes, steps, sub_steps=1, shift=0.0, options=None):
    """A case of so many cubes, cut alike for fluid and grains (map xyz: LIGGGHTS numbers its ranks as decomposePar does).

    shift: mm by which the grains' box lies beside the mesh, so that grains near the cuts are remote."""
    ranks = cut[0]*cut[1]*cut[2]
    size = tuple(SIDE*c for c in cubes)
    box.write(folder, velocity="(1 0.5 2)", steps=steps, cells=" ".join(str(CELLS*c) for c in cubes), size=size,
              decomposition="({} {} {})".format(*cut), ranks=ranks, delta_t=DEM_STEP*INTERVAL*sub_steps)
    dictionaries.change(pathlib.Path(folder)/"system/fvSolution", ("1e-14", "1e-6"), ("1e-13", "1e-6"), ("relTol 0;", "relTol 0.1;"))
    low = tuple(1e-3*shift*(c > 1) for c in cut)
    box.script(folder, grains=_grains(low),
               box=" ".join(f"{a!r} {a + 1e-3*s!r}" for a, s in zip(low, size)), dt=DEM_STEP,
               processors="processors {} {} {} map xyz".format(*cut), end=f"run {INTERVAL*sub_steps*steps}" if kind == "grains" else "")
    if kind == "coupled":
        box.fv_options(folder, **{"couplingInterval": str(INTERVAL), **({"subSteps": str(sub_steps)} if sub_steps > 1 else {}),
                                  **(options or {})})
    elif kind == "grains":
        script = pathlib.Path(folder)/"constant/in.particles"
        script.write_text("variable continued equal 0\n" + script.read_text())


def read(path):
    """A file of the counting layer: {(kind, site): (calls, bytes, ranks)}, memory in kB."""
    found, memory = {}, None
    for line in pathlib.Path(path).read_text().splitlines():
        words = line.split()
        if words[0] == "memory":
            memory = int(words[1])
        else:
            found[words[0], words[3]] = (int(words[1]), float(words[2]), set(words[4].split(",")) if len(words) > 4 else set())
    return found, memory


def run(folder, kind, cut, cubes, steps, library, **entries):
    """Of each rank what read() returns, of a run of so many fluid steps."""
    ranks = cut[0]*cut[1]*cut[2]
    case = pathlib.Path(folder)/f"{kind}-{ranks}-{steps}"
    write_case(case, kind, cut, cubes, steps, **entries)
    if kind != "grains":
        done(["blockMesh"], case, "log.blockMesh")
        if ranks > 1:
            done(["decomposePar"], case, "log.decomposePar")
    program = ["liggghts-plugins", "-in", "constant/in.particles"] if kind == "grains" \
        else ["pimpleFoam", *(["-parallel"] if ranks > 1 else [])]
    preload = [f"LD_PRELOAD={library}:{os.environ.get('LD_PRELOAD', '')}".rstrip(":"), f"GRAINJET_MPI_COUNTS={case/'counts'}"]
    done([*many(ranks), "env", *preload, *program], case, "log.program", timeout=1200)
    counts = [read(case/f"counts.{rank}") for rank in range(ranks)]
    shutil.rmtree(case)
    return counts


def part_of(site, kind):
    """Which part of a coupled run calls MPI there: fluid, grains (LIGGGHTS with its plugins) or coupling."""
    if kind != "coupled":
        return kind
    if "LAMMPS_NS" in site or ("liggghtsSession::advance" in site and "sessionWarnings" not in site):
        return "grains"
    return "coupling" if "Foam::" in site else "fluid"


def _is_collective(kind, rank):
    # OpenFOAM's gather from rank to rank is one message upwards of each rank but the first
    return kind not in ("message", "tree", "up") or (kind == "up" and rank > 0)


def per_step(folder, kind, cut, cubes, library, short=2, long=5, **entries):
    """{part: Figures of each rank} per fluid step."""
    first, second = (run(folder, kind, cut, cubes, steps, library, **entries) for steps in (short, long))
    result = {}
    for part in PARTS if kind == "coupled" else (kind,):
        ranks = result[part] = []
        for rank, ((before, _), (after, memory)) in enumerate(zip(first, second)):
            rates = {key: tuple((a - b)/(long - short) for a, b in zip(counts[:2], before.get(key, (0, 0))))
                     for key, counts in after.items() if part_of(key[1], kind) == part}
            rates = {key: value for key, value in rates.items() if value[0] > 0}
            messages = [key for key in rates if key[0] == "message"]
            sites = {f"{name} {site}": value[0] for (name, site), value in rates.items() if _is_collective(name, rank)}
            ranks.append(Figures(
                sum(rates[key][0] for key in messages), sum(rates[key][1] for key in messages),
                len(set().union(*(after[key][2] for key in messages), set())), sum(sites.values()), sites, memory))
    return result


def largest(ranks):
    """Figures of the rank with the largest value, each by itself; sites of the rank with most collectives."""
    most = max(ranks, key=lambda figures: figures.collectives)
    return Figures(*(max(getattr(figures, name) for figures in ranks) for name in ("messages", "bytes", "neighbours", "collectives")),
                   most.sites, max(figures.memory for figures in ranks))
