# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity at random places in the wall cells of a pipe, for `cell`, `cellPoint` and `wallLaw`, against the mean
profile of a DNS that is imposed on the mesh.

    python3 wall_cell.py <folder with yao2022_pipe_DNS_Retau550_MEAN.dat, ..._Retau1K_MEAN.dat> <new folder>

Writes results/wall_cell.csv.
"""

import csv
import pathlib
import random
import sys

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "testing"))

from grainjet import wall_flow      # noqa: E402

DATA = {550: "yao2022_pipe_DNS_Retau550_MEAN.dat", 1000: "yao2022_pipe_DNS_Retau1K_MEAN.dat"}
SCHEMES = {"cell": ("cell", "no"), "cellPoint": ("cellPoint", "no"), "wallLaw": ("cellPoint", "yes")}
NU, RADIUS, GRAINS = 1.5e-5, 0.015, 4000


def profile(path):
    """u+ of y+ from the columns y+ and Uz."""
    rows = numpy.array([line.split() for line in path.read_text().splitlines()
                        if line.strip() and not line.startswith("#")], dtype=float)
    order = numpy.argsort(rows[:, 2])
    y, u = rows[order, 2], rows[order, 5]
    return lambda y_plus: float(numpy.interp(y_plus, y, u))


def main(data, work):
    lines = []
    for re_tau, name in DATA.items():
        dns = profile(data / name)
        u_tau = re_tau * NU / RADIUS
        for y_plus in (15, 30, 60, 100):
            height = 2 * y_plus * NU / u_tau
            pipe = wall_flow.Pipe(RADIUS, height)
            folder = work / f"{re_tau}-{y_plus}"
            centres = wall_flow.mesh(folder, pipe.mesh(), nu=NU, steps=1)
            y = [pipe.distance(p) for p in centres]
            wall_flow.impose(folder, [(0, 0, u_tau * dns(d * u_tau / NU)) for d in y],
                             k=[u_tau ** 2 / 0.3] * len(y), epsilon=[u_tau ** 3 / (0.41 * d) for d in y])
            rng = random.Random(5)
            places = [pipe.place(rng, 0, height) for _ in range(GRAINS)]
            exact = numpy.array([u_tau * dns(pipe.distance(p) * u_tau / NU) for p in places])
            centre = u_tau * dns(y_plus)
            for scheme, (interpolation, wall_law) in SCHEMES.items():
                rows = wall_flow.sample(folder, places, box=pipe.box(),
                                        options={"interpolation": interpolation, "wallLaw": wall_law})
                error = numpy.array([row[2] for row in rows]) - exact
                lines.append([re_tau, y_plus, scheme] + [f"{100 * numpy.sqrt(numpy.mean(e ** 2)):.2f}"
                                                         for e in (error / centre, error / exact)]
                             + [f"{100 * numpy.mean(error) / centre:.2f}"])
                print(*lines[-1], flush=True)
    with (HERE / "results/wall_cell.csv").open("w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["Re_tau", "y+", "interpolation", "rms % of centre", "rms % of local", "mean % of centre"])
        table.writerows(lines)


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:3]))
