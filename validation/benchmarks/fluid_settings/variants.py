# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of the fluid that run.py compares: what each has other than BASE, the system/fvSolution of
quickJet before this study."""

from grainjet import dictionaries

BASE = {
    "p": {"solver": "GAMG", "smoother": "GaussSeidel", "tolerance": "1e-8", "relTol": "0.01"},
    "pFinal": {"relTol": "0"},
    "U": {"solver": "smoothSolver", "smoother": "symGaussSeidel", "tolerance": "1e-8", "relTol": "0"},
    "PIMPLE": {"nOuterCorrectors": "1", "nCorrectors": "2", "nNonOrthogonalCorrectors": "0"},
}
PCG = {"solver": "PCG", "smoother": None, "preconditioner": "DIC"}
PCG_GAMG = {"solver": "PCG", "smoother": None, "preconditioner":
            "{ preconditioner GAMG; smoother DICGaussSeidel; tolerance 1e-8; relTol 0; nVcycles 1; }"}
# system/fvSolution of quickJet
CHOSEN = {"p": {"smoother": "DICGaussSeidel", "relTol": "0.05"}, "pFinal": {"relTol": "0.01"}, "U": {"relTol": "0.01"}}

VARIANTS = {
    "before": {},
    "tight": {"p": {"tolerance": "1e-12", "relTol": "0"}, "U": {"tolerance": "1e-12"}},
    "p 1e-7": {"p": {"tolerance": "1e-7"}},
    "p 1e-6": {"p": {"tolerance": "1e-6"}},
    "pFinal relTol 0.01": {"pFinal": {"relTol": "0.01"}},
    "pFinal relTol 0.05": {"pFinal": {"relTol": "0.05"}},
    "p relTol 0.05": {"p": {"relTol": "0.05"}},
    "p relTol 0.1": {"p": {"relTol": "0.1"}},
    "U 1e-6": {"U": {"tolerance": "1e-6"}},
    "U relTol 0.01": {"U": {"relTol": "0.01"}},
    "U GaussSeidel": {"U": {"smoother": "GaussSeidel"}},
    "U DILU": {"U": {"smoother": "DILU"}},
    "U PBiCGStab": {"U": {"solver": "PBiCGStab", "smoother": None, "preconditioner": "DILU"}},
    "symGaussSeidel": {"p": {"smoother": "symGaussSeidel"}},
    "DIC": {"p": {"smoother": "DIC"}},
    "DICGaussSeidel": {"p": {"smoother": "DICGaussSeidel"}},
    "two post-sweeps more": {"p": {"nPostSweeps": "4", "nFinestSweeps": "4"}},
    "coarsest 100": {"p": {"nCellsInCoarsestLevel": "100"}},
    "coarsest 1000": {"p": {"nCellsInCoarsestLevel": "1000"}},
    "mergeLevels 2": {"p": {"mergeLevels": "2"}},
    "no cacheAgglomeration": {"p": {"cacheAgglomeration": "no"}},
    "PCG DIC": {"p": PCG},
    "PCG GAMG": {"p": PCG_GAMG},
    "no momentumPredictor": {"PIMPLE": {"momentumPredictor": "no"}},
    "nCorrectors 1": {"PIMPLE": {"nCorrectors": "1"}},
    "nCorrectors 3": {"PIMPLE": {"nCorrectors": "3"}},
    "consistent": {"PIMPLE": {"consistent": "yes"}},
    "renumberMesh": {},
    "chosen": CHOSEN,
    "chosen, renumberMesh": CHOSEN,
    "chosen, GaussSeidel": {**CHOSEN, "p": {"relTol": "0.05"}},
}


def solution(changes):
    """The text of a system/fvSolution."""
    parts = {part: {**entries, **changes.get(part, {})} for part, entries in BASE.items()}
    parts["pFinal"] = {**parts["p"], **parts["pFinal"]}
    solvers = {"p": parts["p"], "pFinal": parts["pFinal"], '"(U|k|epsilon)"': parts["U"], '"(U|k|epsilon)Final"': parts["U"]}
    text = "".join(f"{name} {{ {dictionaries.entries(entries)} }}\n" for name, entries in solvers.items())
    return (f"solvers\n{{\n{text}}}\ncache {{ grad(U); grad(p); }}\nPIMPLE\n{{\n{dictionaries.entries(parts['PIMPLE'])}}}\n")
