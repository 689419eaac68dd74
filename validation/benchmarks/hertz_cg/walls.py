# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases with mesh walls, which the fix and the stock pair style run alike: from an empty box in one run, with
the settings of one script. Meshes are made here; lengths in units of the grain diameter are commented so."""

import math

from grainjet import scripts

D = 4e-3

LAWS = {"stock": ("", "pair_style gran model hertz tangential history\npair_coeff * *"),
        "plugin": ("plugin load hertzcgplugin.so", "fix c all hertz/cg")}


def sheet(point, n, m):
    """2 n m triangles over the parameters [0, 1] x [0, 1] of a surface point(u, v)."""
    out = []
    for i in range(n):
        for k in range(m):
            a, b, c, d = (point(u / n, v / m) for u, v in ((i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1)))
            out += scripts.rectangle(a, b, c, d)
    return out


def turn(radius, u):
    # exactly closed: the last edge is the first
    angle = 2 * math.pi * (u % 1.0)
    return radius * math.cos(angle), radius * math.sin(angle)


def tube():
    """Upright tube of fine triangles, 15 diameters wide."""
    return sheet(lambda u, v: (*turn(0.03, u), 0.1 * v), 96, 60)


def hopper():
    """Cone with an outlet of 6 diameters under a cylinder of 20 diameters."""
    def point(u, v):
        z = 0.12 * v
        return (*turn(0.012 + 0.028 * min(z / 0.05, 1.0), u), z)
    return sheet(point, 75, 60)


def floor():
    """Plate of 12 squares."""
    return sheet(lambda u, v: (0.08 * u - 0.04, 0.06 * v - 0.03, 0.0), 4, 3)


def screw():
    """Blade of five turns around x, 15 diameters wide."""
    def point(u, v):
        radius, angle = 0.008 + 0.022 * v, 10 * math.pi * u
        return 0.15 * u, radius * math.cos(angle), radius * math.sin(angle)
    return sheet(point, 1500, 10)


def drum():
    """Drum around y, 20 diameters wide, 8 deep."""
    def point(u, v):
        x, z = turn(0.04, u)
        return x, 0.032 * v, z
    return sheet(point, 100, 20)


# mesh, its motion, box, region of the first grains, their number, other walls, boundary, gravity
CASES = {
    "tube": dict(mesh=tube, grains=1500, steps=8000, box="-0.032 0.032 -0.032 0.032 -0.001 0.101",
                 fill="cylinder z 0 0 0.028 0.002 0.098", walls=["zplane 0"]),
    "hopper": dict(mesh=hopper, grains=1500, steps=10000, box="-0.042 0.042 -0.042 0.042 -0.02 0.121",
                   fill="cylinder z 0 0 0.037 0.052 0.118"),
    "floor": dict(mesh=floor, grains=1500, steps=10000, box="-0.041 0.041 -0.031 0.031 -0.01 0.12",
                  fill="block -0.037 0.037 -0.027 0.027 0.008 0.11",
                  move="wiggle amplitude 0. 0. 0.002 period 0.02",
                  walls=["xplane -0.04", "xplane 0.04", "yplane -0.03", "yplane 0.03"]),
    "screw": dict(mesh=screw, grains=1000, steps=2000, box="-0.002 0.152 -0.033 0.033 -0.033 0.033",
                  fill="block 0.004 0.146 -0.018 0.018 -0.018 0.018",
                  move="rotate origin 0. 0. 0. axis 1. 0. 0. period 0.5",
                  walls=["xcylinder 0.032 0. 0.", "xplane 0.", "xplane 0.15"]),
    "drum": dict(mesh=drum, grains=1500, steps=8000, box="-0.042 0.042 -0.001 0.033 -0.042 0.042",
                 fill="cylinder y 0 0 0.035 0.003 0.029",
                 move="rotate origin 0. 0. 0. axis 0. 1. 0. period 1.0",
                 walls=["yplane 0", "yplane 0.032"]),
}


def prepare(folder, case):
    """Write the mesh; number of triangles."""
    triangles = CASES[case]["mesh"]()
    (folder / f"{case}.stl").write_text(scripts.stl(*triangles))
    return len(triangles)


def script(case, law, skin, steps=None, tail=""):
    """skin in diameters, for `neighbor`"""
    c = CASES[case]
    load, contacts = LAWS[law]
    walls = "".join(f"fix w{i} all wall/gran model hertz tangential history primitive type 1 {wall}\n"
                    for i, wall in enumerate(c.get("walls", [])))
    move = f"fix move all move/mesh mesh mesh {c['move']}\n" if "move" in c else ""
    return f"""{load}
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
region box block {c['box']} units box
create_box 1 box
neighbor {skin * D} bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
{contacts}
timestep 2e-5
fix mesh all mesh/surface file {case}.stl type 1
{move}fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes mesh
{walls}fix grain all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant {0.5 * D}
fix sizes all particledistribution/discrete 15485867 1 grain 1.0
region fill {c['fill']} units box
fix ins all insert/pack seed 32452843 distributiontemplate sizes insert_every once overlapcheck yes all_in yes &
  particles_in_region {c['grains']} region fill ntry_mc 10000
fix gravity all gravity 9.81 vector 0 0 -1
fix motion all nve/sphere
thermo_style custom step atoms ke cpu
thermo 1000
thermo_modify lost ignore norm no
run {steps or c['steps']}
{tail}
"""
