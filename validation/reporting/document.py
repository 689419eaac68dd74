# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The document: every table of the paper beside ours, the counterparts of its figures."""

import math
import statistics

import cost
import figures
import models
import results as results_
import sections
import sizes
import table


def row(*cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def head(*cells):
    return row(*cells) + "\n|" + "---|"*len(cells)


def write(results, output):
    """The whole document into a file, pictures into a folder beside it."""
    pictures = output.parent/"figures"
    pictures.mkdir(parents=True, exist_ok=True)
    lines = [*introduction(results), *runs_table(results), *table1(results), *table2(results),
             *table4(results), *profiles(results, pictures), *rmse_tables(results),
             *sections.development(results, pictures), *sections.mesh(results, pictures),
             *sections.young(results), *sections.interpolation(results, pictures),
             *models.report(results, pictures), *sections.plate(results, pictures), *sections.sweep(results, pictures),
             *sizes.report(results, pictures), *costs(results), *missing(results)]
    output.write_text("\n".join(lines) + "\n")


def introduction(results):
    run = next(iter(results.runs.values()))
    versions = run.summary["versions"]
    commits = sorted({r.summary["commit"] for r in results.runs.values()})
    return ["# The study of Weaver & Miskovic (2023), run with Grainjet", "",
            f"Written by `validation/report` from the results of size `{results.size}` in hand. Paper: *Fluids* 8 (2023) 215. "
            f"OpenFOAM {versions['OpenFOAM']}, LIGGGHTS {versions['LIGGGHTS'].removeprefix('LIGGGHTS-')}; "
            f"commits of the runs: {', '.join(commits)}.", "",
            "Parameters: `cases/parameters.toml`. How to run it, what the sizes mean, what was assumed: "
            "[cases/README.md](../../cases/README.md). Errors are one standard error unless stated otherwise.", ""]


def runs_table(results):
    lines = ["## Runs", "",
             head("run", "cells", "f_cg", "grains in flight", "simulated, s", "sampled, s", "Courant",
                  "sub-steps", "% Rayleigh", "processor time, s", "ranks", "checks that hold", "commit")]
    for run in results.runs.values():
        s, p = run.summary, run.settings
        held = sum(check["holds"] for check in s["checks"])
        lines.append(row(run.name, f"{s['mesh']['cells']:,}", f"{p['cg']:g}", f"{s['grainsInFlight']:,.0f}",
                         f"{p['endTime']:.3g}", f"{p['endTime'] - p['sampleStart']:.3g}",
                         f"{s['courantMax']:.2f}", p.get("subSteps", 1), f"{s['percentRayleigh']:.1f}",
                         f"{s['cost']['processorSeconds']:.0f}", p["ranks"], f"{held} of {len(s['checks'])}",
                         s["commit"]))
    failed = [f"* {run.name}: {check['text']}" for run in results.runs.values()
              for check in run.summary["checks"] if not check["holds"]]
    if failed:
        lines += ["", "Checks that do not hold:", "", *failed]
    lines += ["", "`% Rayleigh` is that of the smallest grain; the processor time is that of the coupled run. The checks are those "
              "of [quickJet](../../docs/quickJet.md).", ""]
    return lines


def table1(results):
    lines = ["## Table 1: cases", "",
             head("case", "d, um", "rho, kg/m3", "mass loading", "U, m/s", "Re", "nu, m2/s",
                  "St (paper)", "St = rho d^2 U/(18 mu D)", "particles/s", "mass through the exit/inserted")]
    for name, case in results.table.cases.items():
        s = results.table.run(name, results.size)
        nu = s["D"]*s["Umean"]/s["Re"]
        stokes = s["rhoParticle"]*s["dParticle"]**2*s["Umean"]/(18*nu*s["rhoFluid"]*s["D"])
        run = results.runs.get(name)
        seen = f"{run.summary['planes'][0]['massOverInserted']:.3f}" if run else "not run"
        lines.append(row(name, f"{1e6*s['dParticle']:g}", f"{s['rhoParticle']:g}", f"{s['massLoading']:g}",
                         f"{s['Umean']:g}", f"{s['Re']:g}", f"{nu:.3g}", case["printed"]["St"],
                         f"{stokes:.3g}", f"{s['particlesPerSecond']:.3g}", seen))
    return lines + [""]


def table2(results):
    lines = ["## Table 2: mesh", "",
             head("", "cells", "non-orthogonality max", "average", "skewness max", "y+ average",
                  "smallest side, um", "over the largest particle (at least 1.86)")]
    for rig, p in results.paper["table2"].items():
        lines.append(row(f"paper, {rig}", f"{p['cells']:,}", p["nonOrthogonalityMax"],
                         p["nonOrthogonalityAverage"], p["skewnessMax"], p["yPlusAverage"],
                         f"{1e6*p['smallestSide']:.0f}", ""))
    meshes = [(name, results.runs[name].summary["mesh"]) for name in results.table.cases if name in results.runs]
    meshes += results.meshes()
    for name, m in meshes:
        lines.append(row(name, f"{m['cells']:,}", f"{m['nonOrthogonalityMax']:.1f}",
                         f"{m['nonOrthogonalityAverage']:.1f}", f"{m['skewnessMax']:.2f}",
                         f"{m['yPlusAverage']:.0f}" if m["yPlusAverage"] is not None else "no flow yet", f"{1e6*m['smallestSide']:.0f}",
                         f"{m['smallestSideOverDiameter']:.1f}"
                         + (" **below**" if m["smallestSideOverDiameter"] < 1.86 else "")))
    return lines + [""]


def hertz_time(s):
    """2.87 (m*^2/(R* E*^2 v))^(1/5) of two equal grains that meet at twice the mean velocity."""
    radius = s["dParticle"]/2
    mass = s["rhoParticle"]*4/3*math.pi*radius**3
    stiffness = s["youngsModulus"]/(2*(1 - s["poissonsRatio"]**2))
    # effective values of two equal spheres: m/2, R/2
    return 2.87*((mass/2)**2/(radius/2*stiffness**2*2*s["Umean"]))**0.2


def table4(results):
    lines = ["## Table 4: insertion and DEM step", "",
             head("case", "inlet velocity, m/s", "fluctuation, m/s", "DEM step, s", "% Rayleigh: paper",
                  "with E = 5e5 Pa", "with E = 5e6 Pa", "% Hertz: paper", "with E = 5e5 Pa",
                  "with the whole mass")]
    for name, case in results.table.cases.items():
        s = results.table.run(name, "full")
        step, printed = case["demStep"], case["printed"]
        percent = [100*step/table.rayleigh_time(s["dParticle"]/2, s["rhoParticle"], young, s["poissonsRatio"])
                   for young in (5e5, 5e6)]
        lines.append(row(name, f"{s['Uinsertion']:g}", f"({s['uRmsAxial']:g}, {s['uRmsRadial']:g}, {s['uRmsRadial']:g})",
                         f"{step:g}", printed["rayleigh"], f"{percent[0]:.1f}", f"{percent[1]:.1f}",
                         printed["hertz"], f"{100*step/hertz_time(s):.1f}",
                         f"{100*step/hertz_time(s)/4**0.2:.1f}"))
    return lines + ["", "The text of the paper says 5e6 Pa; its column comes out with 5e5 Pa. % Hertz here: two equal particles that meet at "
                    "twice the mean velocity; the stock program puts the whole mass where the formula has the effective one (last column), and takes the "
                    "largest velocity there is.", ""]


def profiles(results, pictures):
    lines = ["## Figures 4, 5 and 7: profiles of the particles", ""]
    for number, names in (("4", ("Hardalupas1", "Hardalupas2")), ("5", ("Hardalupas3", "Hardalupas4")),
                          ("7", ("Lau1", "Lau2", "Lau3"))):
        runs = [results.runs[name] for name in names if name in results.runs]
        if not runs:
            lines += [f"Figure {number}: not run.", ""]
            continue
        name = f"figure{number}.png"
        figures.profiles(runs, runs[0].settings["planes"], pictures/name, results.experiments)
        lines += [f"![Counterpart of figure {number}](figures/{name})", ""]
    lines += [head("case", "plane", "crossings (grains)", "axis: mean, m/s", "rms, m/s", "mean/U")]
    for name in results.table.cases:
        run = results.runs.get(name)
        for plane in run.summary["planes"] if run else ():
            lines.append(row(name, f"{plane['position']:g}D", f"{plane['crossings']:.0f}",
                             f"{plane['axisMean']:.2f} +- {plane['axisMeanError']:.2f}", f"{plane['axisRms']:.2f}",
                             f"{plane['axisMean']/run.settings['Umean']:.3f}"))
    return lines + ["", *sections.trends(results), "Figure 6, the gas of Lau3 without particles with three sets of coefficients: "
                    "[validation/jetKEpsilon](../jetKEpsilon/README.md).", ""]


def rmse_tables(results):
    lines = ["## Tables 5 and 6: errors against the experiments", ""]
    if not results.experiments:
        lines += ["The measured points of Hardalupas et al. (1989) and Lau & Nathan (2016) are not part of the project and were not given, so "
                  "no error of ours is computed; `validation/report --experiments <folder>` does it (format: "
                  "`validation/report --help` and its header). The figures above show profiles only. The errors that the paper prints:", ""]
    layouts = (("table5", [(q, p) for q in results_.QUANTITIES for p in (0.1, 10, 20)]),
               ("table6", [("mean", 0.2), ("mean", 10), ("rms", 0.2), ("rms", 10), ("flux", 0.2)]))
    for name, columns in layouts:
        lines.append(head(f"Table {name[-1]}", *(f"{q} {p:g}D" for q, p in columns)))
        for case, printed in results.paper[name].items():
            lines.append(row(f"{case}, paper", *(f"{value:.3f}" for value in printed)))
            if results.experiments:
                ours = [results.rmse(case, p, q) for q, p in columns]
                lines.append(row(f"{case}, ours", *("no points" if v is None else f"{v:.3f}" for v in ours)))
        lines.append("")
    return lines


def costs(results):
    serial = [run for run in results.runs.values() if run.settings["ranks"] == 1]
    lines = ["## What a medium and a full case cost", ""]
    if not serial:
        return [*lines, "No serial run in hand to measure with.", ""]
    unit = cost.median_costs(serial)
    jets = [run for run in serial if run.settings["endPatch"] == "outlet"]
    stay = statistics.median(cost.residence(run) for run in jets or serial)
    lines += [f"Measured on the serial runs above (medians): {1e6*unit['fluid']:.2f} us per cell and fluid step, "
              f"{1e9*unit['DEM']:.0f} ns per grain and DEM step, {1e6*unit['coupling']:.2f} us per grain and exchange; grains stay "
              f"{stay:.2f} times length over mean velocity. With these, without losses by parallel work:", "",
              head("case", "size", "f_cg", "cells", "grains", "fluid steps", "DEM steps",
                   "core hours: fluid", "DEM", "coupling", "all", "hours on the cores of its script")]
    for size in ("medium", "full"):
        for name in results.table.cases:
            s = results.table.run(name, size)
            e = cost.estimate(s, unit, stay)
            lines.append(row(name, size, f"{s['cg']:g}", f"{e['cells']:,.0f}", f"{e['grains']:,.0f}",
                             f"{e['fluidSteps']:,.0f}", f"{e['demSteps']:,.0f}",
                             *(f"{e[part]:,.1f}" for part in ("fluid", "DEM", "coupling", "hours")),
                             f"{e['hours']/s['ranks']:.1f} on {s['ranks']}"))
    return lines + ["", *sizes.spent(results, unit, stay), *scaling(results), "Lower bounds: nothing beyond two ranks was measured, the pressure solver may need more "
                    "iterations on a finer mesh, and the machine's caches hold less of it. Count on twice the hours for size full.", ""]


def scaling(results):
    """Wall time on more ranks."""
    runs = [run for run in results.study("ranks").values() if run]
    if len(runs) < 2:
        return ["More ranks: not run; `cases/Allrun ranks` does it.", ""]
    first = runs[0].summary["cost"]
    lines = [head("ranks", "wall time of the coupled run, s", "processor time of one rank, s", "speed-up by wall time",
                  "speed-up by processor time")]
    for run in runs:
        spent = run.summary["cost"]
        lines.append(row(run.settings["ranks"], f"{spent['wallSeconds']:.0f}", f"{spent['processorSeconds']:.0f}",
                         f"{first['wallSeconds']/spent['wallSeconds']:.2f}",
                         f"{first['processorSeconds']/spent['processorSeconds']:.2f}"))
    return [*lines, "", "Where the wall time is far above the processor time, other work shared the machine.", ""]


def missing(results):
    wanted = [*results.table.cases, *(run for study in results.table.studies.values() for run in study["run"])]
    absent = [name for name in wanted if name not in results.runs]
    if not absent:
        return ["All cases and studies of this size were run.", ""]
    return ["## Not run", "", f"Generated by `cases/Allrun <name> {results.size}`, but not run for this document: "
            + ", ".join(absent) + ".", ""]
