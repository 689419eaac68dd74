#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles all sources with a compiler, label size or processor other than the build's; nothing is kept.

    compile_check.py plugins  --compiler clang++      the plugins, those for tests, and the unit tests
    compile_check.py plugins  --aarch64               the same for aarch64, by Debian's cross compiler
    compile_check.py openfoam --compiler clang++      the OpenFOAM libraries
    compile_check.py openfoam --label 64              the same with 64-bit labels
                                                      (tools/check-release does it, and for other releases)

A warning counts as an error. Exit code 0: all compile without one; 1: what does not is printed.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLCHAIN = ROOT / "validation/compilers/aarch64.cmake"


def output(command, **settings):
    """Exit code and all that a command prints."""
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", **settings)
    return done.returncode, done.stdout


def without_object(command):
    """A compile command that generates code, unoptimised, and drops it."""
    words = shlex.split(command)
    del words[words.index("-o"):words.index("-o") + 2]
    return [*words, "-Werror", "-O0", "-S", "-o", os.devnull]


def check_plugins(folder, compiler, aarch64):
    """Number of sources of the CMake project that do not compile without a warning; what is printed says why."""
    choice = f"-DCMAKE_TOOLCHAIN_FILE={TOOLCHAIN}" if aarch64 else f"-DCMAKE_CXX_COMPILER={compiler}"
    code, printed = output(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                            "-DPython3_EXECUTABLE=/usr/bin/python3", choice])
    if code:
        print(f"the plugins cannot be configured:\n{printed}")
        return 1
    failed = 0
    entries = json.loads((folder / "compile_commands.json").read_text())
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = pool.map(lambda entry: output(without_object(entry["command"]), cwd=entry["directory"]), entries)
        for entry, (code, printed) in zip(entries, results):
            if code:
                failed += 1
                print(f"{entry['file']}:\n{printed}", flush=True)
    print(f"{len(entries)} sources of the plugins and their tests, {failed} with warnings or errors")
    return failed


# The tree that ./Allwmake builds with: the sourced one, or Debian's
TREE = """
. openfoam-libs/tools/openfoam-environment
echo "$WM_PROJECT_DIR"
"""


def check_openfoam(arguments):
    """Exit code of check-release, which says what does not compile."""
    code, printed = output(["bash", "-c", TREE], cwd=ROOT)
    if code:
        print(printed)
        return 1
    options = ["--compiler", arguments.compiler] if arguments.compiler else []
    options += ["--first"] if arguments.first else []
    return subprocess.run([ROOT / "openfoam-libs/tools/check-release", printed.splitlines()[-1], "--quick",
                           "--label", str(arguments.label), "--precision", arguments.precision, *options],
                          check=False).returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", choices=("plugins", "openfoam"))
    parser.add_argument("--compiler", help="g++ or clang++, with a version or path as you like")
    parser.add_argument("--aarch64", action="store_true", help="plugins: the cross compiler for aarch64")
    parser.add_argument("--label", type=int, choices=(32, 64), default=32, help="openfoam: bits of a label")
    parser.add_argument("--precision", choices=("DP", "SP", "SPDP"), default="DP",
                        help="openfoam: of its numbers; SP and SPDP shall be refused")
    parser.add_argument("--first", action="store_true", help="openfoam: the first source of each library only")
    arguments = parser.parse_args()
    if arguments.part == "openfoam":
        return check_openfoam(arguments)
    with tempfile.TemporaryDirectory(prefix="grainjet-") as folder:
        return 1 if check_plugins(pathlib.Path(folder), arguments.compiler or "g++", arguments.aarch64) else 0


if __name__ == "__main__":
    sys.exit(main())
