# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Libraries of models as a user writes them: built by wmake against the headers of this Grainjet."""

import fcntl
import os
import pathlib
import shutil

import grainjet

HERE = pathlib.Path(__file__).parent


def build(name):
    """Build the library in the folder tests/<name> and return its path. Source and objects are kept in
    build/, so that only what has changed is compiled; tests that want it at once wait."""
    folder = grainjet.ROOT / "build" / name
    folder.mkdir(parents=True, exist_ok=True)
    with (folder.parent / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        shutil.copytree(HERE / name, folder, dirs_exist_ok=True)
        former = os.environ.get("FOAM_USER_LIBBIN")
        env = {"FOAM_USER_LIBBIN": str(folder)}
        if former:
            # with an OpenFOAM of the user's own the coupling lies there
            env["LIBRARY_PATH"] = former
        result = grainjet.run(["./Allwmake"], folder, env=env)
        library = folder / f"lib{name}.so"
        if result.code or not library.exists():
            raise AssertionError(result)
    return library


def libs(*names):
    """The value of the entry libs of controlDict for a coupling with these libraries."""
    paths = " ".join(f'"{build(name)}"' for name in names)
    return f'("libliggghtsCoupling.so" {paths})'
