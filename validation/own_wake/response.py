#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of liggghts-plugins/physics/wake/own_wake.h: how a fluid on a mesh answers to a force that moves.

    validation/own_wake/response.py [--check]

Everything is linear and on a periodic cubic mesh of 48^3 cells, so it is worked out in wave numbers, without any flow solver
or body: viscosity by second-order differences and implicit Euler, the pressure of a collocated mesh. A body moves along a
straight line; each step its force lies in the cells that hold its 29 parts, and the velocity at it is sampled from
cells or by cellPoint. Averages are over places in the cell for three oblique directions, and along lines at set places across.
Two exponential modes are fitted to all this at once, for diameters of 0, 0.5 and 1 cells. --check: only compare the numbers of the
header. Lengths in cells, times in L^2/nu.
"""

import argparse
import pathlib
import re

import numpy
from scipy.optimize import least_squares

CELLS = 48
DIRECTIONS = ((0.5, 0.3, -0.81), (1.0, 0.4, 0.7), (0.1, 0.2, 1.0))
SIZES = (0.0, 0.5, 1.0)
HEADER = pathlib.Path(__file__).resolve().parents[2] / "liggghts-plugins/physics/wake/own_wake.h"

# w L/nu, nu dt/L^2, cells travelled
MOVING = ((0.1, 0.4, 4), (0.3, 0.1, 6), (0.3, 0.4, 12), (1, 0.04, 6), (1, 0.1, 8), (1, 0.3, 20), (2, 0.02, 6), (2, 0.05, 8),
          (2, 0.15, 16), (3, 0.05, 8), (3, 0.1, 20), (5, 0.01, 6), (5, 0.06, 16), (10, 0.01, 8), (10, 0.03, 20), (30, 0.003, 8),
          (30, 0.01, 16), (100, 0.0015, 8), (100, 0.003, 20), (1000, 0.00015, 8), (1000, 0.0003, 20))
ON_LINES = ((0.3, 0.1, 6), (1, 0.1, 8), (3, 0.05, 8), (10, 0.01, 8), (100, 0.0015, 8))
LINES = ((0.01, 0.01), (0.49, 0.49), (0.25, 0.4), (0.49, 0.01))     # from the middle of the cell
# nu dt/L^2, times
AT_REST = ((0.02, (0.1, 0.4, 1, 2)), (0.1, (0.1, 0.4, 1, 2, 4, 8)), (0.4, (0.4, 2, 4, 8, 24)))


def parts():
    """The 29 points of dividedVoidFraction, for radius 1."""
    def shell(begin, end):
        a, b = (begin/29)**(1/3), (end/29)**(1/3)
        return 0.75*(b**4 - a**4)/(b**3 - a**3)

    c = 3**-0.5
    directions = numpy.array([(1, 0, 0), (0, 1, 0), (0, 0, 1), (c, c, c), (c, c, -c), (c, -c, c), (c, -c, -c)])
    return numpy.vstack([numpy.zeros((1, 3))] + [sign*r*directions for r in (shell(1, 15), shell(15, 29)) for sign in (1, -1)])


def sampled(x, scheme):
    """Cells and their weights in the velocity at places x, in cells."""
    cell = numpy.floor(x).astype(int)
    if scheme == "cell":
        return cell[:, None, :], numpy.ones((len(x), 1))
    # cellPoint: the pyramid of the nearest face, its two triangles; a point has the mean of its eight cells
    rows = numpy.arange(len(x))
    local = 2*(x - cell) - 1
    a = abs(local).argmax(axis=1)
    b, c = (a + 1) % 3, (a + 2) % 3
    height = abs(local[rows, a])
    p, q = local[rows, b]/height, local[rows, c]/height
    swapped = p < q
    p, q = numpy.where(swapped, q, p), numpy.where(swapped, p, q)
    corners = (((1 - p)/2, -1, -1), ((p - q)/2, 1, -1), ((1 + q)/2, 1, 1))
    cells, weights = [cell], [1 - height]
    for weight, first, second in corners:
        corner = numpy.zeros((len(x), 3))
        corner[rows, a] = numpy.sign(local[rows, a])
        corner[rows, b] = numpy.where(swapped, second, first)
        corner[rows, c] = numpy.where(swapped, first, second)
        for offset in numpy.ndindex(2, 2, 2):
            cells.append((cell + numpy.array(offset)*corner).astype(int))
            weights.append(height*weight/8)
    return numpy.stack(cells, 1), numpy.stack(weights, 1)


def starts(line=None, places=200):
    """Places in the cell, at random or along a line in z."""
    start = numpy.random.default_rng(3).random((places, 3))
    if line:
        start[:, :2] = 0.5 + numpy.array(line)
    return start


def overlap(scheme, size, start):
    """own_wake.h's Place, averaged: how often cells with a part of the force are those that are sampled, or their neighbours
    over a face, an edge, a corner."""
    local = abs(2*start - 1)
    room = (1 - local)/2
    R = size/2
    beyond = numpy.where(room < R, (R - room)**2*(2*R + room)/(4*R**3), 0.0) if R > 0 else 0*room

    def product(axes):
        q = numpy.zeros((len(start), 4))
        q[:, 0] = 1
        for same, next_to in axes:
            moved = numpy.zeros_like(q)
            moved[:, 1:] = q[:, :-1]*next_to[:, None]
            q = q*same[:, None] + moved
        return q

    inside = product([(1 - beyond[:, k], beyond[:, k]) for k in range(3)])
    if scheme == "cell":
        return inside.mean(axis=0)
    height = local.max(axis=1)
    half = 0.5 + 0*height
    axes = []
    for k in range(3):
        towards = numpy.where(local[:, k] == height, 1.0, 0.5*(1 + local[:, k]/height))
        axes.append((0.5*towards + 0.5*(1 - beyond[:, k])*(1 - towards), half))
    return ((1 - height)[:, None]*inside + height[:, None]*product(axes)).mean(axis=0)


def response(scheme, size, w, dt, steps, direction, start):
    """Velocity at the body after each step under a unit force."""
    k = 2*numpy.pi*numpy.fft.fftfreq(CELLS)
    waves = numpy.meshgrid(k, k, 2*numpy.pi*numpy.fft.rfftfreq(CELLS), indexing="ij")
    n = numpy.array(direction)/numpy.linalg.norm(direction)
    laplacian = sum(2 - 2*numpy.cos(wave) for wave in waves)
    gradient = [numpy.sin(wave) for wave in waves]
    wide = sum(g**2 for g in gradient)
    along = sum(n[i]*gradient[i] for i in range(3))

    # Continuity is that of the faces: the wide gradient in the momentum equation, the compact one in
    # the equation for pressure, whose difference is times 1/(1/dt + 6 nu/L^2)
    pressure = wide + laplacian*(laplacian - wide)*dt/(1 + 6*dt)
    pressure[0, 0, 0] = 1
    amplitude = 1 - along**2/pressure
    amplitude[0, 0, 0] = 0
    decay = 1/(1 + laplacian*dt)

    if size > 0:
        force_in = numpy.floor(start[:, None, :] + 0.5*size*parts()[None]).astype(int)
    else:
        force_in = numpy.floor(start)[:, None, :].astype(int)
    values = []
    for step in range(1, steps + 1):
        amplitude *= decay
        field = numpy.fft.irfftn(amplitude, s=(CELLS,)*3, axes=(0, 1, 2))
        cells, weights = sampled(start + n*w*dt*step, scheme)
        index = (cells[:, None, :, :] - force_in[:, :, None, :]) % CELLS
        values.append(dt*(field[index[..., 0], index[..., 1], index[..., 2]]*weights[:, None, :]).sum(2).mean())
    return numpy.cumsum(values)


def measured(scheme, size):
    """[overlap, w, dt, steps, velocity, weight in the fit]"""
    rows = []
    anywhere = starts()
    q = overlap(scheme, size, anywhere)
    for dt, times in AT_REST:
        values = response(scheme, size, 0.0, dt, round(times[-1]/dt), DIRECTIONS[0], anywhere)
        rows += [(q, 0.0, dt, round(t/dt), values[round(t/dt) - 1], 0.4) for t in times]
    for w, dt, travel in MOVING:
        steps = int(numpy.ceil(min(60, travel/w)/dt))
        value = numpy.mean([response(scheme, size, w, dt, steps, direction, anywhere)[-1] for direction in DIRECTIONS])
        rows.append((q, w, dt, steps, value, 1.0))
    for line in LINES:
        along = starts(line, 60)
        for w, dt, travel in ON_LINES:
            steps = int(numpy.ceil(travel/w/dt))
            rows.append((overlap(scheme, size, along), w, dt, steps,
                         response(scheme, size, w, dt, steps, (0, 0, 1), along)[-1], 0.5))
    return rows


def modes(numbers, q, w, dt, steps):
    """The same by own_wake.h. numbers: k of four kinds of neighbours, for each mode; t; l."""
    k, t, l = numpy.reshape(numbers[:8], (2, 4)) @ q, numpy.array(numbers[8:10]), numpy.array(numbers[10:12])
    kept = numpy.exp(-dt*(numpy.hypot(1/t, w/l) - 1/t))/(1 + dt/t)
    return (k*dt*kept*(1 - kept**steps)/(1 - kept)).sum()


def fit(data):
    def errors(numbers):
        return [row[5]*numpy.log(max(modes(numbers, *row[:4]), 1e-12)/row[4]) for row in data]

    start = numpy.array([0.5, 0.05, 0.01, 0.01, 0.2, 0.1, 0.05, 0.03, 0.12, 0.6, 0.6, 0.7])
    return least_squares(errors, start, x_scale=abs(start)).x


def of_header(name):
    body = re.search(r"Response %s = \{(.*?)\};" % name, HEADER.read_text(), re.S).group(1)
    return [float(x) for x in re.findall(r"-?[0-9.]+", body)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    check = parser.parse_args().check
    for scheme, name in (("cell", "CELL"), ("cellPoint", "CELL_POINT")):
        rows = [row for size in SIZES for row in measured(scheme, size)]
        for what, numbers in [("header", of_header(name))] + ([] if check else [("fit", fit(rows))]):
            print(f"{scheme} {what}: " + ", ".join(f"{x:.4g}" for x in numbers))
            errors = numpy.array([modes(numbers, *row[:4])/row[4] - 1 for row in rows])
            weights = numpy.array([row[5] for row in rows])
            for kind, weight in (("anywhere", 1.0), ("at rest", 0.4), ("on lines", 0.5)):
                some = errors[weights == weight]
                print(f"    {kind}: rms {100*numpy.sqrt((some**2).mean()):.1f} %, largest {100*abs(some).max():.1f} %", flush=True)


if __name__ == "__main__":
    main()
