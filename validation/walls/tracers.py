# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turbulent flow in a pipe that pimpleFoam calculates (k-epsilon, wall functions, periodic, constant flow), with
tracers: their mean profile in the wall cells against the law of the wall with the friction that the solver has.

    source environment; python3 validation/walls/tracers.py <new folder>

Writes results/tracers.csv. Friction: from the pressure gradient that keeps the flow up.
"""

import csv
import math
import pathlib
import random
import re
import sys

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "testing"))

from grainjet import coupled_box, dictionaries, dumps, programs, scripts, wall_flow      # noqa: E402

NU, RADIUS, U_TAU = 1.5e-5, 0.015, 0.55
DEVELOP, STEPS, DT = 2000, 20, 2e-4
BINS = 8


def command(words, folder):
    result = programs.run(words, folder, 3600)
    if result.code:
        raise SystemExit(result)
    return result.output


def develop(folder, pipe, nut):
    """The flow alone; the friction velocity."""
    centres = wall_flow.mesh(folder, pipe.mesh(), nu=NU, steps=DEVELOP, delta_t=DT, convection="linearUpwind grad(U)",
                             libs="()")
    y = [pipe.distance(p) for p in centres]
    start = [U_TAU * wall_flow.spalding(d * U_TAU / NU) for d in y]
    wall_flow.impose(folder, [(0, 0, u) for u in start], k=[U_TAU ** 2 / 0.3] * len(y),
                     epsilon=[U_TAU ** 3 / (0.41 * d) for d in y], nut=nut)
    dictionaries.change(folder / "system/fvSchemes", ("divSchemes { default Gauss linear;",
                                                      "divSchemes { default Gauss upwind;"))
    dictionaries.write(folder / "constant/fvOptions", FLOW.format(sum(start) / len(start)))
    dictionaries.change(folder / "system/fvSchemes", ("div(phi,U)", "div((nuEff*dev2(T(grad(U))))) Gauss linear; div(phi,U)"))
    gradient = float(re.findall(r"pressure gradient = ([-+.\deE]+)", command(["pimpleFoam"], folder))[-1])
    return math.sqrt(gradient * pipe.apothem / 2)


FLOW = """flow
{{
    type meanVelocityForce; active yes; selectionMode all; fields (U); Ubar (0 0 {!r});
}}
"""


def tracers(folder, pipe, height, wall_law):
    """Distance from the wall and axial velocity of the tracers."""
    rng = random.Random(1)
    places = [pipe.place(rng, 0.01 * height, height) for _ in range(4000)]
    coupled_box.script(folder, dt=DT / 10, boundary="f f p", box=pipe.box(),
                       grains=coupled_box.grains(places, [(0, 0, 0)] * len(places), 2e-6, 1000.0),
                       end=scripts.dump(10 * STEPS, "grains.*.dump", coupled_box.MOTION))
    flow = (folder / "constant/fvOptions").read_text()
    flow = flow[flow.index("flow\n"):flow.rindex("}") + 1]
    flow = re.sub(r"particles\n\{.*?\n\}\n", "", flow, flags=re.S)
    coupled_box.fv_options(folder, coupling="oneWay", forces="()", wallLaw=wall_law)
    path = folder / "constant/fvOptions"
    path.write_text(path.read_text() + flow)
    dictionaries.put(folder / "system/controlDict", endTime=f"{(DEVELOP + STEPS) * DT:.10g}", writeInterval="100000",
                     libs='("libliggghtsCoupling.so")')
    command(["pimpleFoam"], folder)
    path.write_text(re.sub(r"particles\n\{.*?\n\}\n", "", path.read_text(), flags=re.S))
    rows = dumps.last(folder / f"grains.{10 * STEPS}.dump").values()
    return numpy.array([(pipe.distance(row[:3]), row[5]) for row in rows])


def main(work):
    lines = []
    for y_plus in (30, 60):
        for nut in ("nutUSpaldingWallFunction", "nutkWallFunction"):
            height = 2 * y_plus * NU / U_TAU
            pipe = wall_flow.Pipe(RADIUS, height, around=64, along=1)
            folder = work / f"{y_plus}-{nut}"
            u_tau = develop(folder, pipe, nut)
            with_law, without = (tracers(folder, pipe, height, word) for word in ("yes", "no"))
            for i in range(BINS):
                low, high = i * height / BINS, (i + 1) * height / BINS
                mean = [values[(low <= values[:, 0]) & (values[:, 0] < high)] for values in (with_law, without)]
                law = numpy.mean([wall_flow.spalding(d * u_tau / NU) for d in mean[0][:, 0]])
                lines.append([y_plus, nut, f"{(low + high) / 2 * u_tau / NU:.1f}", f"{law:.2f}"]
                             + [f"{numpy.mean(m[:, 1]) / u_tau:.2f}" for m in mean])
                print(*lines[-1], flush=True)
    with (HERE / "results/tracers.csv").open("w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["y+ of the cell (design)", "nut", "y+", "u+ of the law", "u+ of tracers, wallLaw",
                        "u+ of tracers, cellPoint"])
        table.writerows(lines)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
