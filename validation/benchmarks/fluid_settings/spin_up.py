#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The steady flow without grains that a coupled run starts from, see README.md.

    spin_up.py run WORK SIZE NAME ...     steady flow of quickJet or of Hardalupas1 medium with settings of METHODS, from rest;
                                          --mapped: from the steady flow of the mesh of size quick
    spin_up.py table WORK                 after how many iterations the velocities along the axis and beside it stay where they end

Built Grainjet, its environment sourced. --ranks: MPI ranks, --iterations: how many."""

import argparse
import pathlib
import re
import shutil

import numpy

from run import ROOT, generate, stage, dictionaries

SOLVERS = """solvers
{
p { solver GAMG; smoother GaussSeidel; tolerance 1e-8; relTol 0.05; }
"(U|k|epsilon)" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0.1; }
}
"""
# consistent, relaxation of p, U, k and epsilon
METHODS = {"SIMPLE": ("no", 0.3, 0.7, 0.7), "SIMPLEC": ("yes", 1, 0.9, 0.8), "SIMPLEC 0.8": ("yes", 1, 0.8, 0.8), "SIMPLEC 0.7": ("yes", 1, 0.7, 0.7),
           "SIMPLEC 0.95": ("yes", 1, 0.95, 0.95)}
# along the axis and beside it, in D: from the pipe's middle to the end
PLACES = [(0, z) for z in (-40, -30, -20, -10, -0.07, 0.1, 5, 10, 15, 20, 23)] + [(0.5, 10), (1, 20)]
EVERY = 5


def probes(diameter, length):
    places = [(r, z) for r, z in PLACES if z > -length]
    where = " ".join(f"({(r + 7e-4)*diameter:.8g} {1e-5} {z*diameter:.8g})" for r, z in places)
    return ("    axis\n    {\n        type probes;\n        libs (\"libsampling.so\");\n        writeControl timeStep;\n"
            f"        writeInterval {EVERY};\n        fields (U);\n        probeLocations ({where});\n    }}\n")


def solution(consistent, p, U, k):
    return (f"{SOLVERS}SIMPLE\n{{\nconsistent {consistent};\nnNonOrthogonalCorrectors 0;\n}}\nrelaxationFactors\n{{\n"
            f"fields {{ p {p}; }}\nequations {{ U {U}; \"(k|epsilon)\" {k}; }}\n}}\n")


def filled(folder, size, mesh=None):
    """A case of a size; mesh: on that of another size."""
    shutil.copytree(ROOT/"cases/quickJet", folder)
    if size != "quickJet":
        jets = generate.table.Table()
        made = jets.run("Hardalupas1", size)
        made = jets.coarse(made) if mesh else made
        (folder/"system/parameters").write_text(generate.parameters(made))
    dictionaries.put(folder/"system/parameters", ranks="1")


def run(work, size, name, mapped, ranks, iterations):
    folder = work/f"spinUp-{size}-{'mapped' if mapped else 'rest'}-{name.replace(' ', '_')}"
    shutil.rmtree(folder, ignore_errors=True)
    filled(folder, size)
    begin = ""
    if mapped:
        coarse = work/"spinUp-coarse"
        if not coarse.exists():
            filled(coarse, size, mesh="quick")
            stage(coarse, "mesh_stage; steady_stage", work/f"{coarse.name}.log")
        (folder/"coarse").symlink_to(coarse)
        (folder/"coarse/stage.steady").touch()
        begin = "start_stage() { mapped_start coarse; }; "
    p = dictionaries.values(folder/"system/parameters")
    dictionaries.put(folder/"system/parameters", ranks=str(ranks), spinUpIterations=str(iterations))
    dictionaries.write(folder/"spinUp/system/fvSolution", solution(*METHODS[name]))
    dictionaries.change(folder/"spinUp/system/controlDict", ("functions\n{\n", "functions\n{\n" + probes(p["D"], p["pipeLength"])))
    stage(folder, f"{begin}mesh_stage; steady_stage", work/f"{folder.name}.log")


def velocities(folder):
    """Iterations, and the axial velocity at each place (rows)."""
    lines = [line for line in (folder/"spinUp/postProcessing/axis/0/U").read_text().splitlines() if not line.startswith("#")]
    numbers = numpy.array([[float(x) for x in re.findall(r"[-+.\deE]+", line)] for line in lines])
    return numbers[:, 0], numbers[:, 3::3]


def table(work):
    print("| mesh | start | method | iterations | within 1 % | 0.3 % | 0.1 % | processor time per iteration/that of SIMPLE |")
    print("|" + "---|"*8)
    rows = []
    for folder in sorted(work.glob("spinUp-*-*-*/")):
        _, size, start, name = folder.name.split("-", 3)
        at, U = velocities(folder)
        bulk = dictionaries.values(folder/"system/parameters")["Umean"]
        spent = float(re.findall(r"ExecutionTime = (\S+) s", (folder/"log.simpleFoam").read_text())[-1])/at[-1]
        rows.append((size, start, name, at, U/bulk, spent))
    for size, start, name, at, U, spent in rows:
        # what the flow of this mesh ends with: the longest run of the method that gets there first
        ends = max((row for row in rows if row[0] == size), key=lambda row: (row[2].startswith("SIMPLEC"), row[3][-1]))[4][-1]
        off = abs(U - ends).max(axis=1)
        cells = []
        for limit in (0.01, 0.003, 0.001):
            outside = numpy.flatnonzero(off > limit)
            cells.append("not reached" if len(outside) and outside[-1] == len(at) - 1 else f"{at[outside[-1] + 1] if len(outside) else at[0]:.0f}")
        simple = next((row[5] for row in rows if row[0] == size and row[2] == "SIMPLE"), spent)
        print("| " + " | ".join([size, start, name.replace("_", " "), f"{at[-1]:.0f}", *cells, f"{spent/simple:.2f}"]) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("run", "table"))
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("size", nargs="?", choices=("quickJet", "quick", "medium"))
    parser.add_argument("name", nargs="*")
    parser.add_argument("--mapped", action="store_true")
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--iterations", type=int, default=300)
    args = parser.parse_args()
    work = args.work.resolve()
    if args.what == "table":
        table(work)
    for name in args.name:
        run(work, args.size, name, args.mapped, args.ranks, args.iterations)


if __name__ == "__main__":
    main()
