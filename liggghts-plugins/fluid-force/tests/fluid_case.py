# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A cloud of grains in a box, and what the tests of fix fluid/force on several ranks share."""

import math

import numpy

import grainjet
from grainjet import dumps, tables

PROBE = grainjet.ROOT / "lib" / "tests" / "exchangeprobeplugin.so"

HEAD = """
    plugin load fluidforceplugin.so
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
    neighbor 0.0005 bin
    neigh_modify delay 0
    timestep 1e-5
"""

READ = """
    read_restart {name}
    neighbor 0.0005 bin
    neigh_modify delay 0
    timestep 1e-5
"""


class FluidCase(grainjet.Case):

    def head(self, boundary="p p p", sort="0 0", processors="* 1 1"):
        return HEAD.format(boundary=boundary, sort=sort, processors=processors)

    def vector(self, result, names):
        """Values of `print` lines `name = value`."""
        found = tables.printed(result.output)
        return [found[name] for name in names]

    def values(self, output):
        """The values that PRINT has printed, by name; of the last time if it did more than once."""
        return dict(zip(self.NAMES, self.vector(grainjet.Run(0, output), self.NAMES)))

    def triangles(self, name, x, low, high):
        """An STL file of a square normal to x, from `low` to `high` in y and z."""
        a, b, c, d = (low, low), (high, low), (high, high), (low, high)
        text = "solid s\n"
        for corners in ((a, b, c), (a, c, d)):
            text += "facet normal 1 0 0\nouter loop\n"
            text += "".join(f"vertex {x} {p[0]} {p[1]}\n" for p in corners)
            text += "endloop\nendfacet\n"
        (self.folder / name).write_text(text + "endsolid s\n")

    def dump(self, name):
        """Columns of a dump file's last frame, by atom ID."""
        return dumps.array(self.folder / name)

    DIAMETER, DENSITY, GRAINS = 80e-6, 2950.0, 2000
    MASS = math.pi / 6 * DIAMETER ** 3 * DENSITY

    MATERIAL = """
        fix m1 all property/global youngsModulus peratomtype 5.e6
        fix m2 all property/global poissonsRatio peratomtype 0.3
        fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
        fix m4 all property/global coefficientFriction peratomtypepair 1 0.2
    """

    # 2000 grains at set places, each with a velocity of its own, moving through all ranks
    CLOUD = """
        lattice sc 0.001
        create_atoms 1 region box
        set group all diameter 80e-6 density 2950
        variable vx atom 20*sin(id)
        variable vy atom 4*sin(2*id)
        variable vz atom 4*sin(3*id)
        velocity all set v_vx v_vy v_vz units box
    """

    WIND = "fix f all fluid/force uniform 8 1 -1 density 1.2 viscosity 1.5e-5 drag schillerNaumann"
    DUMP = ("dump d all custom {every} {name} id mass vx vy vz f_fluidImpulse[1] "
            "f_fluidImpulse[2] f_fluidImpulse[3]\ndump_modify d format \"%d" + 7 * " %.17g" + "\"")

    def impulse_error(self, first, last):
        """Largest |impulse - m (v1 - v0)| over the grains, relative to the largest impulse."""
        given = last[:, 1:2] * (last[:, 2:5] - first[:, 2:5])
        return abs(last[:, 5:8] - given).max() / abs(given).max()

    PRINT = "\n".join(f'print "{name} = ${{{name}}}"' for name in
                      ("px", "py", "pz", "ix", "iy", "iz", "removed", "lx", "ly", "lz", "lm",
                       "fresh", "nx", "ny", "nz", "deleted", "wrong", "far", "fate", "atoms"))
    NAMES = ["px", "py", "pz", "ix", "iy", "iz", "removed", "lx", "ly", "lz", "lm", "fresh",
             "nx", "ny", "nz", "deleted", "wrong", "far", "fate", "atoms"]
    VARIABLES = """
        variable mvx atom mass*vx
        variable mvy atom mass*vy
        variable mvz atom mass*vz
        compute p all reduce sum v_mvx v_mvy v_mvz
        variable px equal c_p[1]
        variable py equal c_p[2]
        variable pz equal c_p[3]
        variable ix equal f_d[1]
        variable iy equal f_d[2]
        variable iz equal f_d[3]
        variable removed equal f_d[4]
        variable lx equal f_d[5]
        variable ly equal f_d[6]
        variable lz equal f_d[7]
        variable lm equal f_d[8]
        variable fresh equal f_d[9]
        variable nx equal f_d[10]
        variable ny equal f_d[11]
        variable nz equal f_d[12]
        variable deleted equal f_d[13]
        variable wrong equal f_d[14]
        variable far equal f_d[15]
        variable fate equal f_d[16]
        variable atoms equal atoms
        thermo_style custom step atoms c_p[1] c_p[2] c_p[3] f_d[1] f_d[9]
        thermo_modify lost ignore format float %.17g
        thermo 1000
    """
