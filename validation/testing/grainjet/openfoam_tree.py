# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A tree that the build takes for a sourced OpenFOAM: what it asks for, and nothing behind it."""

import os
import shutil
import subprocess

import grainjet

LIBRARY = "namespace Foam {{ namespace foamVersion {{ extern const int api; const int api = {api}; }} }}"
# what Grainjet's libraries are linked with
NEEDED = ("finiteVolume", "meshTools", "incompressibleTransportModels", "turbulenceModels", "incompressibleTurbulenceModels",
          "compressibleTurbulenceModels", "DPMTurbulenceModels", "interfaceProperties")
# where an ELF file names its processor, and the number of one that no test runs on
MACHINE, RISC_V = 18, 243


def library(path, api):
    """libOpenFOAM.so, of which only the version is true."""
    path.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run(["g++", "-shared", "-fPIC", "-x", "c++", "-", "-o", path], input=LIBRARY.format(api=api), text=True,
                   check=True, env={**os.environ, "CCACHE_DISABLE": "1"})


def library_of_mpi(path, mpi):
    """libPstream.so, of which only the MPI that it is linked with is true."""
    path.parent.mkdir(parents=True, exist_ok=True)
    empty = ["g++", "-shared", "-fPIC", "-x", "c++", "/dev/null"]
    env = {**os.environ, "CCACHE_DISABLE": "1"}
    other = path.parent/mpi
    subprocess.run([*empty, f"-Wl,-soname,{mpi}", "-o", other], check=True, env=env)
    subprocess.run([*empty, "-x", "none", "-Wl,--no-as-needed", other, "-o", path], check=True, env=env)


def of_another_processor(path):
    """Change the processor that a library says it is for."""
    data = bytearray(path.read_bytes())
    data[MACHINE:MACHINE + 2] = RISC_V.to_bytes(2, "little")
    path.write_bytes(data)


def make(folder, wmake, api=1912):
    """The tree, with `wmake` as its wmake; the variables that its etc/bashrc would set."""
    (folder/"META-INFO").mkdir(parents=True)
    (folder/"META-INFO/api-info").write_text(f"api={api}\npatch=0\n")
    (folder/"wmake").mkdir()
    shutil.copy(wmake, folder/"wmake/wmake")
    library(folder/"lib/libOpenFOAM.so", api)
    for name in NEEDED:
        (folder/f"lib/lib{name}.so").touch()
    return {"WM_PROJECT": "OpenFOAM", "WM_PROJECT_DIR": folder, "WM_PROJECT_VERSION": f"v{api}", "WM_COMPILER": "Gcc",
            "WM_OPTIONS": "linux64", "WM_PRECISION_OPTION": "DP", "FOAM_LIBBIN": folder/"lib", "FOAM_USER_LIBBIN": "",
            "PATH": f"{folder/'wmake'}:{grainjet.ENV['PATH']}", "CXX": ""}
