#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""One grain settles two-way coupled in a periodic box of laminar fluid: its speed without and with selfDisturbance.

    source environment; validation/own_wake/settle.py <work folder> [--reynolds R ...] [--sizes C ...] [--interpolation S ...]
        [--box N] [--diffusion D] [--courant C] [--convection SCHEME] [--stretch A] [--centre] [--ranks N]

The grain starts at rest; its weight is that which the drag law (Schiller & Naumann) carries at Re = w d/nu. It falls obliquely, so
that it meets all places in a cell. Its speed is taken relative to the mean of the fluid, which the periodic box lets
accelerate. Printed: cell size over d; the mean over the second half of the way over w, less 1, and its scatter; the way after a
quarter of the time over that of the equation of motion without a wake, less 1 (the time from the release on); all in %.
"""

import argparse
import math
import pathlib
import shutil

import numpy

import grainjet
from grainjet import coupled_box as box, dictionaries, scripts

RHO, NU, D, DENSITY = 1000.0, 1e-6, 2e-4, 2500.0
MASS = DENSITY*math.pi/6*D**3
DIRECTION = numpy.array([0.5, 0.3, -0.81])/numpy.linalg.norm([0.5, 0.3, -0.81])
SOLUTION = """
solvers
{
    "p.*" { solver GAMG; smoother GaussSeidel; tolerance 1e-9; relTol 0.01; }
    pFinal { $p; relTol 0.001; }
    "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 1e-4; }
}
PIMPLE { nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }
"""


def drag(speed):
    return 3*math.pi*RHO*NU*D*speed*(1 + 0.15*(abs(speed)*D/NU)**0.687)


def alone(force, times):
    """Way of a grain in fluid at rest, by an exponential step of a thousandth of the time."""
    h = times[-1]/20000
    v = x = 0.0
    ways = [0.0]
    for _ in range(20000):
        b = drag(v)/v if v > 0 else 3*math.pi*RHO*NU*D
        end, tau = force/b, MASS/b
        x += end*h + (v - end)*tau*(1 - math.exp(-h/tau))
        v = end + (v - end)*math.exp(-h/tau)
        ways.append(x)
    return numpy.interp(times, numpy.linspace(0, times[-1], 20001), ways)


def velocities(path):
    """Along gravity, row by row of the dump."""
    lines = path.read_text().split("\n")
    return numpy.array([[float(x) for x in lines[i + 1].split()[1:4]] for i, line in enumerate(lines)
                        if line.startswith("ITEM: ATOMS")]) @ DIRECTION


def settle(folder, reynolds, size, scheme, options, own_wake):
    """Times, way and speed relative to the fluid's mean."""
    w, side, n = reynolds*NU/D, size*D, options.box
    end = min(24*side**2/NU, 16*side/w)
    dt = float(f"{min(options.diffusion*side**2/NU, options.courant*side/w):.4g}")
    steps = math.ceil(end/dt)
    length = [n*side, n*side, n*side*options.stretch]

    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    box.write(folder, steps=steps, delta_t=dt, cells=f"{n} {n} {n}", size=tuple(1000*x for x in length), nu=NU,
              rho=f"rho [1 -3 0 0 0 0 0] {RHO};", write_every=10**6, convection=options.convection,
              ranks=max(options.ranks, 2), decomposition=f"(1 1 {max(options.ranks, 2)})")
    dictionaries.write(folder/"system/fvSolution", SOLUTION)
    g = drag(w)/MASS
    box.script(folder, dt=dt/10, grains=box.grains([tuple(0.41*x for x in length)], [(0, 0, 0)], D, DENSITY),
               box=" ".join(f"0 {x}" for x in length), end=scripts.dump(10, "grains.dump", "id vx vy vz"),
               gravity="fix g all gravity {!r} vector {!r} {!r} {!r}".format(g, *map(float, DIRECTION)))
    dictionaries.change(folder/"constant/in.particles", ("neighbor 0.0005 bin", f"neighbor {0.2*side} bin"),
                        ("binsize 0.002", f"binsize {2*side}"))
    box.fv_options(folder, drag="SchillerNaumann", forces="()", interpolation=scheme, selfDisturbance=own_wake,
                   voidFraction=f"{{ model {'centre' if options.centre else 'divided'}; minimum 0.1; }}")
    for command in [["blockMesh"]] + ([["decomposePar"]] if options.ranks > 1 else []):
        assert grainjet.run(command, folder).code == 0
    solver = grainjet.mpirun(options.ranks) + ["pimpleFoam", "-parallel"] if options.ranks > 1 else ["pimpleFoam"]
    ran = grainjet.run(solver, folder, timeout=3000)
    assert ran.code == 0, ran

    table = box.read_balance(folder)
    given = numpy.cumsum(numpy.array([table["toFluid_" + k] for k in "xyz"]).T @ DIRECTION)
    speed = velocities(folder/"grains.dump")
    mean = numpy.concatenate([[0.0], given])/(RHO*math.prod(length))
    speed = speed - mean[:len(speed)]
    times = dt*numpy.arange(len(speed))
    way = numpy.concatenate([[0.0], numpy.cumsum(0.5*dt*(speed[1:] + speed[:-1]))])
    return times, way, speed/w


def line(folder, reynolds, size, scheme, options):
    words = [f"| {reynolds:g} | {size:g} | {scheme} |"]
    for own_wake in ("no", "yes"):
        times, way, speed = settle(folder, reynolds, size, scheme, options, own_wake)
        half, quarter = len(speed)//2, len(speed)//4
        exact = alone(drag(reynolds*NU/D), times[:quarter + 1])[-1]
        words.append(f" {100*(speed[half:].mean() - 1):.1f} +- {100*speed[half:].std():.1f} |"
                     f" {100*(way[quarter]/exact - 1):.1f} |")
    print("".join(words), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--reynolds", type=float, nargs="+", default=[0.1, 1, 10, 100])
    parser.add_argument("--sizes", type=float, nargs="+", default=[1, 2, 4, 8])
    parser.add_argument("--interpolation", nargs="+", default=["cellPoint", "cell"])
    parser.add_argument("--box", type=int, default=24, help="cells along each side")
    parser.add_argument("--diffusion", type=float, default=0.1, help="nu dt/(cell size)^2 at most")
    parser.add_argument("--courant", type=float, default=0.3, help="w dt/(cell size) at most")
    parser.add_argument("--convection", default="linear")
    parser.add_argument("--stretch", type=float, default=1.0, help="length of cells in z over that in x and y")
    parser.add_argument("--centre", action="store_true", help="void fraction by the model centre")
    parser.add_argument("--ranks", type=int, default=1)
    options = parser.parse_args()
    print("| Re | cell/d | interpolation | settled, without | release | settled, with | release |\n|---|---|---|---|---|---|---|")
    for reynolds in options.reynolds:
        for size in options.sizes:
            for scheme in options.interpolation:
                line(options.folder/"settle", reynolds, size, scheme, options)


if __name__ == "__main__":
    main()
