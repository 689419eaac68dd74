# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The studies in the document: full development, mesh, Young's modulus, interpolation, plate, f_cg."""

import figures
import plates
import results as results_

NOT_RUN = "Not run; `cases/Allrun {study} {size}` does it."


def row(*cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def head(*cells):
    return row(*cells) + "\n|" + "---|"*len(cells)


def not_run(results, study):
    return [NOT_RUN.format(study=study, size=results.size), ""]


def complete(results, study):
    return all(results.study(study).values())


def trends(results):
    """What the paper says in words of its profiles, beside our numbers."""
    runs = results.runs

    def axis(name, index):
        plane = runs[name].summary["planes"][index]
        speed = runs[name].settings["Umean"]
        return f"{plane['axisMean']/speed:.3f} +- {plane['axisMeanError']/speed:.3f}"

    def inner_over_outer(name):
        """Mean flux in r < 0.2 D over that in the ring at the wall."""
        r, flux, _ = runs[name].normalised(0.1)["flux"]
        area = [(x + 0.05)**2 - (x - 0.05)**2 for x in r]
        inner = [i for i, x in enumerate(r) if x < 0.2]
        return (sum(flux[i]*area[i] for i in inner)/sum(area[i] for i in inner)
                / flux[[i for i, x in enumerate(r) if 0.4 < x < 0.5][0]])

    lines = []
    lau = [name for name in ("Lau1", "Lau2", "Lau3") if name in runs]
    if len(lau) == 3:
        values = [", ".join(f"{name} {axis(name, index)}" for name in lau) for index in (0, 1)]
        lines += [row("Lau, 0.2D: the lowest Stokes number has the highest mean velocity near the axis, the highest the lowest",
                      f"Up/Ub on the axis: {values[0]}"),
                  row("Lau, 10D: the mean velocity depends on the Stokes number (which the experiment hardly shows)",
                      f"Up/Ub on the axis: {values[1]}")]
    if {"Hardalupas3", "Hardalupas4"} <= runs.keys():
        lines += [row("Hardalupas3 has a flatter flux profile at the exit than Hardalupas4",
                      "flux in r < 0.2 D over that in the ring at the wall: "
                      + ", ".join(f"{name} {inner_over_outer(name):.2f}" for name in ("Hardalupas3", "Hardalupas4")))]
    return [head("In words, the paper", "ours"), *lines, ""] if lines else []


def development(results, pictures):
    lines = ["## Figures 2 and 3: full development", ""]
    for title, run in (*results.study("development").items(), *results.study("development-models").items()):
        if run is None:
            continue
        planes = run.settings["planes"]
        models = " with all models" if title.endswith("-models") else ""
        figures.development(run, planes, pictures/f"{title}.png")
        lines += [f"![Profiles in the pipe, insertion at {run.settings['Uinsertion']:g} m/s{models}](figures/{title}.png)", "",
                  f"Insertion at {run.settings['Uinsertion']:g} m/s{models}:", "",
                  head("plane", "from 0D: mean/Ugc", "noise", "rms/Ugc", "noise", "G/Gm", "noise")]
        for plane in planes[:-1]:
            shifted = results_.difference_of_profiles(run.normalised(plane), run.normalised(planes[-1]))
            lines.append(row(f"{plane:g}D", *(f"{value:.3f}" for quantity in results_.QUANTITIES
                                             for value in (shifted[0][quantity], shifted[1][quantity]))))
        lines.append("")
    if len(lines) == 2:
        return lines + not_run(results, "development")
    if None in results.study("development-models").values():
        lines += not_run(results, "development-models")
    lines += ["Root mean square difference of each profile from that at the exit, and what the noise of both alone would give. The paper: most of the "
              "development within 40 D of the insertion at 60 D, minute changes in the last 20 D.", ""]
    return lines


def compared(results, study, reference, planes):
    """Table of the differences of the runs of a study from one of them."""
    runs = results.study(study)
    lines = [head("run", "plane", *(f"{q}: difference, %" for q in results_.QUANTITIES),
                  *(f"{q}: noise, %" for q in results_.QUANTITIES), "processor time, s")]
    for name, run in runs.items():
        for plane in planes if name != reference else ():
            apart, noise = results_.difference(run, runs[reference], plane)
            lines.append(row(name, f"{plane:g}D", *(f"{100*apart[q]:.1f}" for q in results_.QUANTITIES),
                             *(f"{100*noise[q]:.1f}" for q in results_.QUANTITIES),
                             f"{run.summary['cost']['processorSeconds']:.0f}"))
    return lines + ["", f"Root mean square over the rings of the difference from `{reference}`, of mean and rms velocity over Ugc and flux over Gm; "
                    "noise: what the standard errors of both alone would give.", ""]


def mesh(results, pictures):
    lines = ["## Mesh study", ""]
    if not complete(results, "mesh"):
        return lines + not_run(results, "mesh")
    runs = list(results.study("mesh").values())
    lines += [head("run", "cells", "y+", "axis at 0.1D, m/s", "10D", "20D")]
    for run in runs:
        lines.append(row(run.name, f"{run.summary['mesh']['cells']:,}", f"{run.summary['mesh']['yPlusAverage']:.0f}",
                         *(f"{p['axisMean']:.2f} +- {p['axisMeanError']:.2f}" for p in run.summary["planes"])))
    figures.profiles(runs, runs[0].settings["planes"], pictures/"mesh.png")
    return lines + ["", "![Profiles on three meshes](figures/mesh.png)", "",
                    *compared(results, "mesh", "mesh-fine", runs[0].settings["planes"])]


def young(results):
    lines = ["## Young's modulus", ""]
    if not complete(results, "E"):
        return lines + not_run(results, "E")
    planes = results.study("E")["E-5e6"].settings["planes"]
    paper = results.paper["E"]
    return lines + [f"The paper, 5e6 against 1e7 Pa: {100*paper['velocity']:g} % in velocity, {100*paper['flux']:g} % in flux.", "",
                    *compared(results, "E", "E-5e6", planes)]


def interpolation(results, pictures):
    lines = ["## Interpolation: cell against cellPoint", ""]
    if not complete(results, "interpolation"):
        return lines + not_run(results, "interpolation")
    runs = list(results.study("interpolation").values())
    figures.profiles(runs, [0.1], pictures/"interpolation.png")
    return lines + ["![Profiles at the nozzle exit](figures/interpolation.png)", "",
                    *compared(results, "interpolation", "interpolation-cellPoint", runs[0].settings["planes"])]


def percent(value, error):
    return f"{value:.1f} +- {error:.1f}"


def plate(results, pictures):
    lines = ["## Table 7 and figures 9, 10: plate", ""]
    runs = results.study("plate")
    if not complete(results, "plate"):
        return lines + not_run(results, "plate")
    lines += ["Hardalupas1 with a plate that ends the domain at 5D or at 15D; hits counted within 3.5 D. Mesh, steps and sampled time of each "
              "run are in the table of runs. Grains rebound and may come back; those that fly back past the nozzle exit beside the "
              "pipe, or out at the sides, leave.", "",
              head("run", "cells", "sampled, s", "hits (collisions of grains)", "hits per second, particles", "+- %",
                   "second half/first half", "hits per inserted particle", "mean peak force of a grain, N",
                   "grains in flight, begin and end of sampling")]
    for name, run in runs.items():
        hit = run.plate["all"]
        early, late = hit["particle_frequency_halves"]
        lines.append(row(name, f"{run.summary['mesh']['cells']:,}", f"{hit['time']:.4f}", f"{hit['collisions']:,}",
                         f"{hit['particle_frequency']:.4g}", f"{100*hit['frequency_relative_error']:.1f}",
                         f"{late/early:.3f}",
                         f"{hit['particle_frequency']/run.settings['particlesPerSecond']:.3f}",
                         f"{hit['normal_force_peak']['mean']:.4g}",
                         " and ".join(f"{n:,.0f}" for n in run.summary["grainsInFlightStartEnd"])))
    lines += ["", head("peak force of a collision over f_cg^2 (variance over f_cg^4)", "Fn mean, N", "variance, N2", "skewness",
                       "Ft mean, N", "variance, N2", "skewness")]
    for name, run in runs.items():
        scale = run.settings["cg"]**2
        cells = []
        for force in plates.PEAK:
            entry = run.plate["all"][force]
            cells += [f"{entry['mean']/scale:.3e}", f"{entry['variance']/scale**2:.3e}",
                      f"{entry['skewness']:.3f} +- {abs(entry['skewness'])*entry['skewness_relative_error']:.3f}"]
        lines.append(row(name, *cells))
    lines += ["", "Ratios as Eqs. (25) to (27) of the paper define them, 5D/15D, and the other way round: see "
              "[what the results say](findings.md).", ""]
    paper = results.paper["table7"]
    for title, forces in (("peak of each collision", plates.PEAK), ("average over the contact", plates.AVERAGE)):
        fine = plates.ratios(runs["plate5D-cg1"], runs["plate15D-cg1"], forces)
        coarse = plates.ratios(runs["plate5D-cg2"], runs["plate15D-cg2"], forces)
        wrong = plates.errors(fine, coarse)
        lines += ["", f"Force: {title}.", "", head("", *plates.NAMES),
                  row("f_cg 1, paper", *(f"{value:.2f}" for value in paper["cg1"])),
                  row("f_cg 2, paper", *(f"{value:.2f}" for value in paper["cg2"]))]
        for direction, pair in (("5D/15D", (fine, coarse)),
                                ("15D/5D", (plates.inverse(fine), plates.inverse(coarse)))):
            for f, ours, printed in zip((1, 2), pair, (paper["cg1"], paper["cg2"])):
                lines += [row(f"f_cg {f}, ours, {direction}", *(f"{a:.2f} +- {da:.2f}" for a, da in ours)),
                          row(f"f_cg {f}, {direction}, within 10 % of the paper's",
                              *(verdict(100*abs(a/b - 1), 10, 100*da/b) for (a, da), b in zip(ours, printed)))]
        lines += [row("error by coarse graining, %, paper", *paper["error"]),
                  row("error by coarse graining, %, ours, 5D/15D", *(percent(*e) for e in wrong)),
                  row("at most 4 %", *(verdict(e, 4, de) for e, de in wrong))]
    lines += ["", "`within the noise`: beyond the goal by less than two standard errors.", "", *rings(results, pictures)]
    for name, run in runs.items():
        if (run.folder/"plate.png").exists():
            (pictures/f"{name}.png").write_bytes((run.folder/"plate.png").read_bytes())
            lines += [f"![Places of impact, {name}](figures/{name}.png)"]
    return lines + ["", "Figure 10: kernel density estimate (`scipy.stats.gaussian_kde`, at most 5000 hits drawn at random).", ""]


def verdict(value, goal, error):
    if value <= goal:
        return "yes"
    return "within the noise" if value - goal <= 2*error else f"no ({value:.0f} %)"


def rings(results, pictures):
    """Figure 9."""
    runs = results.study("plate")
    rows = []
    for region, entry in runs["plate5D-cg1"].plate.items():
        if region == "all":
            continue
        fine = plates.ratios(runs["plate5D-cg1"], runs["plate15D-cg1"], plates.PEAK, region)
        coarse = plates.ratios(runs["plate5D-cg2"], runs["plate15D-cg2"], plates.PEAK, region)
        wrong = plates.errors(fine, coarse)
        rows.append((0.5*(entry["r_in/D"] + entry["r_out/D"]),
                     dict(zip(plates.NAMES, [e for e, _ in wrong])),
                     {name: run.plate[region]["particle_frequency"] for name, run in runs.items()},
                     wrong, {name: run.plate[region]["collisions"] for name, run in runs.items()}))
    figures.rings(rows, pictures/"figure9.png")
    lines = ["Figure 9: error of the ratios by ring, peak forces.", "", "![Errors by ring](figures/figure9.png)", "",
             head("ring, r/D", *(f"{name}, %" for name in plates.NAMES), "fewest hits in a run")]
    for r, _, _, wrong, counts in rows:
        lines.append(row(f"{r:g}", *(f"{e:.0f} +- {de:.0f}" if de == de else "too few" for e, de in wrong),
                         min(counts.values())))
    return lines + [""]


def sweep(results, pictures):
    lines = ["## Figures 11, 12 and the choice of f_cg", ""]
    runs = results.study("cg")
    if not complete(results, "cg"):
        return lines + not_run(results, "cg")
    reference = runs["cg-1"]
    planes = [p for p in (0.1, 10, 20) if reference.has(p)]
    entries = []
    lines += [head("f_cg", "grains in flight", "processor time per simulated second, s", "of it grains and coupling, s",
                   *(f"{q} {p:g}D: difference (noise), %" for p in planes for q in results_.QUANTITIES))]
    for run in runs.values():
        s = run.summary
        spent = s["cost"]
        timed = spent["secondsFluid"] + spent["secondsDEM"] + spent["secondsCoupling"]
        end = run.settings["endTime"]
        found = [results_.difference(run, reference, plane) for plane in planes]
        mean = [{q: (sum(f[i][q]**2 for f in found)/len(found))**0.5 for q in results_.QUANTITIES} for i in (0, 1)]
        entries.append({"cg": run.settings["cg"], "apart": mean[0], "noise": mean[1],
                        "perSecond": spent["processorSeconds"]/end,
                        "grainsPerSecond": spent["processorSeconds"]/end*(1 - spent["secondsFluid"]/timed)})
        cells = (["reference"]*len(planes)*3 if run is reference else
                 [f"{100*a[q]:.1f} ({100*n[q]:.1f})" for a, n in found for q in results_.QUANTITIES])
        lines.append(row(f"{run.settings['cg']:g}", f"{s['grainsInFlight']:,.0f}", f"{entries[-1]['perSecond']:,.0f}",
                         f"{entries[-1]['grainsPerSecond']:,.0f}", *cells))
    figures.sweep(entries, pictures/"sweep.png")
    lines += ["", "![Error and run time against f_cg](figures/sweep.png)", "",
              "Difference: root mean square over the rings, from f_cg 1, of mean and rms velocity over Ugc and of flux over Gm; noise: what the standard "
              "errors of both runs alone would give. A run with larger grains has fewer crossings per second.", ""]
    for name in ("cg-1", "cg-2"):
        inside = [p for p in runs[name].settings["planes"] if p <= 0]
        outside = [p for p in runs[name].settings["planes"] if 0 <= p <= 14 and p != 0.1]
        figures.development(runs[name], inside, pictures/f"figure11-{name}.png")
        figures.development(runs[name], outside, pictures/f"figure12-{name}.png")
        lines += [f"![In the pipe, {name}](figures/figure11-{name}.png)", f"![In the jet, {name}](figures/figure12-{name}.png)"]
    return lines + [""]
