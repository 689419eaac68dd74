#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of `fix grain/motion` against the stock integration, with and without the force of a fluid.

    source environment; run.py [case ...] [--grains N] [--steps N] [--repeat N] [--ranks N] [--counts] [--apart]

Cases
    dilute  the stream of the benchmark hertz_cg (solid fraction 4e-4, 6 m/s, a pipe as wall)
    dense   the settled bed of that benchmark

Programs
    stock     pair_style gran with its best settings (hertz_cg, case best), nve/sphere, gravity
    today     fix hertz/cg, nve/sphere, gravity
    motion    fix hertz/cg, grain/motion with gravity
    today+    today with fix fluid/force coupled, of which a small plugin writes the fluid every 50 steps
    motion+   the same with grain/motion ... fluid

All programs of a round run one after the other; every ratio is taken within a round, and the median of the
rounds is printed with its range. --counts: instructions per grain and step instead, under valgrind's callgrind,
of the difference between two runs, one of them longer by --steps. --apart: beside a fix that looks at every step.
"""

import argparse
import os
import pathlib
import re
import shutil
import statistics
import sys
import tempfile

import grainjet

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "hertz_cg"))
import run as hertz  # noqa: E402

PROBE = grainjet.ROOT / "lib" / "tests" / "exchangeprobeplugin.so"
FLUID = f"""plugin load fluidforceplugin.so
plugin load {PROBE}
fix f all fluid/force coupled
fix d all exchange/probe 50 6.0 0 1.4e-8 0
"""
# acts at the end of each step, and costs nothing for a grain
LOOKS = "variable one equal 1\nfix look all ave/time 1 1000000 1000000 v_one\n"
RATIOS = (("stock", "today"), ("stock", "motion"), ("today", "motion"), ("today+", "motion+"), ("today+", "today"),
          ("motion+", "motion"), ("motion+", "today"))


def programs(case, steps, apart=False):
    """Scripts by the name of the program."""
    stock, plugin = hertz.STOCK, hertz.PLUGIN
    if case == "dense":
        def script(law):
            return hertz.bed_script(law, "read_restart bed", f"run 50\nrun {steps}")
        scripts = {"stock": script(stock), "today": script(plugin)}
    else:
        scripts = {"stock": hertz.stream_script(stock, hertz.BEST, steps),
                   "today": hertz.stream_script(plugin, hertz.FIRST, steps)}

    weight, integrate = re.search(r"^fix g all gravity 9.81 vector (.*)$", scripts["today"], re.M), "fix i all nve/sphere\n"
    motion = f"plugin load grainmotionplugin.so\nfix i all grain/motion gravity 9.81 {weight.group(1)}"
    bare = scripts["today"].replace(weight.group(0) + "\n", "")
    scripts["motion"] = bare.replace(integrate, motion + "\n")
    scripts["today+"] = scripts["today"].replace(integrate, FLUID + integrate)
    scripts["motion+"] = bare.replace(integrate, FLUID + motion + " fluid f\n")
    if apart:
        scripts = {name: re.sub(r"(?m)^(fix i all .*)$", rf"\1\n{LOOKS}", script) for name, script in scripts.items()}
    return scripts


def instructions(folder, script):
    (folder / "in.bench").write_text(script)
    # what liggghts-plugins does, without its shell
    done = grainjet.run(["env", f"LD_PRELOAD={grainjet.ROOT / 'lib' / 'liggghtsloader.so'}", "valgrind", "--tool=callgrind",
                         "--callgrind-out-file=callgrind.out", "liggghts", "-in", "in.bench"], folder, timeout=3600)
    assert done.code == 0, done
    return int(re.findall(r"^(?:summary|totals): (\d+)", (folder / "callgrind.out").read_text(), re.M)[0])


def counts(folder, case, args):
    for name in programs(case, 1):
        short, long = (instructions(folder, programs(case, n, args.apart)[name]) for n in (100, 100 + args.steps))
        print(f"{case} {name:8} {(long - short) / args.steps / args.grains:7.1f} instructions", flush=True)


def clock(folder, case, args):
    scripts, times = programs(case, args.steps, args.apart), {}
    for _ in range(args.repeat):
        for name, script in scripts.items():
            used = hertz.timed(folder, script, args.ranks) * args.ranks / args.steps / args.grains * 1e9
            times.setdefault(name, []).append(used)
    print(f"{case}: " + ", ".join(f"{name} {statistics.median(t):.1f}" for name, t in times.items()) + " ns")
    for above, below in RATIOS:
        ratios = [a / b for a, b in zip(times[above], times[below])]
        print(f"{case} {above + '/' + below:16} {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--grains", type=int, default=50000)
    parser.add_argument("--steps", type=int, default=1000)
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--counts", action="store_true")
    parser.add_argument("--apart", action="store_true")
    parser.add_argument("case", nargs="*", default=["dilute", "dense"])
    args = parser.parse_args()

    folder = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-bench-"))
    try:
        print(f"{args.grains} grains, {args.ranks} rank(s), load {os.getloadavg()[0]:.1f}; per grain and step")
        for case in args.case:
            (hertz.bed if case == "dense" else hertz.stream)(folder, args.grains)
            (counts if args.counts else clock)(folder, case, args)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main()
