#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Folders of runs from the table of parameters: the files of quickJet with other numbers.

    generate.py list [case|study|run ...] [size]     the runs that are meant, one per line
    generate.py make <run> <size> [--ranks N] [--again]
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import slurm
import table

CASES = table.HERE.parent
TEMPLATE = CASES/"quickJet"
RUNS = pathlib.Path(os.environ.get("GRAINJET_RUNS", CASES/"runs"))
COPIED = ("0.orig", "constant", "system", "spinUp", "particleInput")


def foam(value):
    """A value as an OpenFOAM dictionary has it."""
    if isinstance(value, list):
        return "(" + " ".join(foam(v) for v in value) + ")"
    return value if isinstance(value, str) else f"{value:.10g}"


def parameters(settings):
    """The text of system/parameters: quickJet's with the numbers of the run."""
    text = (TEMPLATE/"system"/"parameters").read_text()
    text = re.sub(r"(?m)^// Default: .*\n", f"// Run {settings['name']} of size {settings['size']}, "
                  "generated from cases/parameters.toml.\n", text)

    def value(match):
        if match[1] not in settings:
            raise table.TableError(f"cases/parameters.toml lacks {match[1]}, which quickJet's "
                                   "system/parameters has")
        # the comments of the template speak of its own values
        return f"{match[1]:<15} {foam(settings[match[1]])};"
    return re.sub(r"(?m)^(\w+)\s+[^;\n]+;", value, text)


def commit():
    """The commit a run was made with; marked if files differ from it. Unknown of a packed Grainjet."""
    if not shutil.which("git"):
        return "unknown"

    def git(*words):
        return subprocess.run(["git", "-c", f"safe.directory={CASES.parent}", "-C", CASES.parent, *words],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout.strip()
    changed = git("status", "--porcelain", "--untracked-files=no")
    return (git("rev-parse", "--short", "HEAD") or "unknown") + ("-changed" if changed else "")


def make(name, size, ranks, again):
    """Prints `<state> <folder>`, the state being new, unfinished or finished."""
    settings = table.Table().run(name, size)
    if ranks:
        settings["ranks"] = ranks
    folder = RUNS/f"{name}-{size}"
    stated = folder/"case.json"
    wanted = json.loads(json.dumps(settings))
    if stated.exists() and not again:
        kept = json.loads(stated.read_text())["settings"]
        if not ranks:
            wanted["ranks"] = kept["ranks"]
        differing = sorted(k for k in wanted.keys() | kept.keys() if wanted.get(k) != kept.get(k))
        finished = (folder/"stage.finished").exists()
        if differing and not finished:
            raise table.TableError(
                f"{folder}: begun with other parameters than cases/parameters.toml has now "
                f"({', '.join(differing)}); --again starts it anew")
        if differing:
            print(f"{folder.name}: cases/parameters.toml has changed since ({', '.join(differing)}); "
                  "--again runs it anew", file=sys.stderr)
        print("finished" if finished else "unfinished", folder)
        return
    if folder.exists():
        shutil.rmtree(folder)
    fill(folder, settings)
    coarse = table.Table().coarse(settings)
    if coarse:
        fill(folder/"coarse", {**coarse, "ranks": 1})       # so small a mesh needs no more
    (folder/f"{folder.name}.foam").touch()
    if settings["ranks"] > 8:
        (folder/"job.slurm").write_text(slurm.script(settings, CASES, RUNS.resolve()))
    stated.write_text(json.dumps({"settings": settings, "commit": commit()}, indent=1) + "\n")
    print("new", folder)


def fill(folder, settings):
    """The files of quickJet with the numbers of a run, in a new folder."""
    folder.mkdir(parents=True)
    for item in COPIED:
        if (TEMPLATE/item).is_dir():
            shutil.copytree(TEMPLATE/item, folder/item, ignore=shutil.ignore_patterns(
                "polyMesh", "particles", "0", "processor*", "[1-9]*", "postProcessing", *(["constant"] if item == "spinUp" else [])))
        else:
            shutil.copy2(TEMPLATE/item, folder/item)
    (folder/"system"/"parameters").write_text(parameters(settings))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    commands = parser.add_subparsers(dest="command", required=True)
    lister = commands.add_parser("list")
    lister.add_argument("word", nargs="*")
    maker = commands.add_parser("make")
    maker.add_argument("name")
    maker.add_argument("size")
    maker.add_argument("--ranks", type=int)
    maker.add_argument("--again", action="store_true")
    args = parser.parse_args()
    try:
        if args.command == "make":
            make(args.name, args.size, args.ranks, args.again)
            return 0
        jets = table.Table()
        words = args.word
        size = words.pop() if words and words[-1] in jets.sizes else "quick"
        for word in words or list(jets.cases):
            for name in jets.runs(word):
                print(name, size)
    except table.TableError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
