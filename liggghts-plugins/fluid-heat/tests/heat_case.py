# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains in a fluid of another temperature, and what the tests of fix fluid/heat share."""

import math

import numpy

import grainjet
from grainjet import dumps, tables

PROBE = grainjet.ROOT / "lib" / "tests" / "exchangeprobeplugin.so"

RHO, NU, CP, PR = 1.2, 1.5e-5, 1005.0, 0.7      # air
K = RHO * NU * CP / PR
AIR = f"{RHO} {NU} {CP} {PR}"
D, DENSITY, C = 80e-6, 2950.0, 800.0            # of the grains
MASS = math.pi / 6 * D ** 3 * DENSITY

HEAD = """
    plugin load fluidheatplugin.so
    {plugins}
    atom_style granular
    atom_modify map array sort {sort}
    boundary {boundary}
    newton off
    communicate single vel yes
    units si
    processors {processors}
"""

BOX = """
    region box block 0 0.02 0 0.01 0 0.01 units box
    create_box 1 box
"""

SETTINGS = """
    neighbor 0.0005 bin
    neigh_modify delay 0
    timestep {dt!r}
    fix c all property/global thermalCapacity peratomtype 800
"""

MATERIAL = """
    fix m1 all property/global youngsModulus peratomtype 5.e6
    fix m2 all property/global poissonsRatio peratomtype 0.3
    fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
    fix m4 all property/global coefficientFriction peratomtypepair 1 0.2
"""

ONE = f"""
    create_atoms 1 single 0.003 0.003 0.003 units box
    set group all diameter {D!r} density {DENSITY}
"""

# 2000 grains at set places, each with a velocity of its own, moving through all ranks
CLOUD = f"""
    lattice sc 0.001
    create_atoms 1 region box
    set group all diameter {D!r} density {DENSITY}
    variable vx atom 20*sin(id)
    variable vy atom 4*sin(2*id)
    variable vz atom 4*sin(3*id)
    velocity all set v_vx v_vy v_vz units box
"""

TEMPLATE = f"""
    fix pt all particletemplate/sphere 15485863 atom_type 1 density constant {DENSITY} &
        radius constant {D / 2!r} volume_limit 1e-16
    fix pd all particledistribution/discrete 32452843 1 pt 1.0
"""


def ranz_marshall(re):
    return 2 + 0.6 * math.sqrt(re) * PR ** (1 / 3)


def gunn(re):
    return 2 * (1 + 0.7 * re ** 0.2 * PR ** (1 / 3)) + 0.13 * re ** 0.7 * PR ** (1 / 3)


def whitaker(re):
    return 2 + (0.4 * math.sqrt(re) + 0.06 * re ** (2 / 3)) * PR ** 0.4


def coefficient(slip, d=D, nusselt=ranz_marshall):
    """H of one particle, W/K."""
    return nusselt(slip * d / NU) * K * math.pi * d


def recovery(T, slip):
    return T + math.sqrt(PR) * slip ** 2 / (2 * CP)


class HeatCase(grainjet.Case):

    def head(self, boundary="p p p", sort="0 0", processors="* 1 1", plugins=""):
        return HEAD.format(boundary=boundary, sort=sort, processors=processors, plugins=plugins)

    def script(self, body, dt=1e-5, grains=CLOUD, box=BOX, **head):
        """Input script up to its runs."""
        return self.head(**head) + box + SETTINGS.format(dt=dt) + grains + body

    def dump_command(self, name, every, columns):
        return (f"dump d all custom {every} {name} id {' '.join(columns)}\n"
                f'dump_modify d format "%d{len(columns) * " %.17g"}"')

    def dump(self, name):
        """Columns of a dump file's last frame, by atom ID."""
        return dumps.array(self.folder / name)

    def thermo(self, result):
        return numpy.array(tables.thermo(result.output))

    def printed(self, result):
        return tables.printed(result.output)
