# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same script with stock integration and with fix grain/motion."""

import numpy

import grainjet
from grainjet import dumps, scripts

PROBE = grainjet.ROOT / "lib" / "tests" / "exchangeprobeplugin.so"

STOCK, MOTION = "stock", "motion"

HEAD = """
    plugin load hertzcgplugin.so
    plugin load fluidforceplugin.so
    plugin load platestatsplugin.so
    plugin load grainmotionplugin.so
    plugin load {probe}
    atom_style granular
    atom_modify map array sort {sort}
    boundary {boundary}
    newton off
    communicate single vel yes
    units si
    dimension {dimension}
"""

SETTINGS = """
    neighbor 0.0005 bin
    neigh_modify delay 0
    timestep 1e-6
    fix m1 all property/global youngsModulus peratomtype 5.e6
    fix m2 all property/global poissonsRatio peratomtype 0.3
    fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
    fix m4 all property/global coefficientFriction peratomtypepair 1 0.2
"""

# 200 grains of 1 mm at set places that fall on a floor and into each other, spinning
CLOUD = """
    region box block 0 0.02 0 0.01 0 0.02 units box
    create_box 1 box
    lattice sc 0.00125 origin 0.45 0.45 0.45
    region cloud block 0.0005 0.0195 0.0005 0.0095 0.0002 0.006 units box
    create_atoms 1 region cloud
    set group all diameter 1e-3 density 2500
    variable vx atom 0.5*sin(id)
    variable vy atom 0.5*sin(2*id)
    variable vz atom -0.5-0.3*sin(3*id)
    velocity all set v_vx v_vy v_vz units box
    set group all omegax 200
    set group all omegay -100
"""

FLOOR = "fix w all wall/gran model hertz tangential history primitive type 1 zplane 0 {more}\n"
PAIR = {"gran": "pair_style gran model hertz tangential history\npair_coeff * *\n", "hertz/cg": "fix c all hertz/cg\n"}
STATE = "x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz"
FLUID = " ".join(f"f_{name}[{k}]" for name in ("fluidForce", "fluidImpulse") for k in (1, 2, 3))
WITHOUT = " ".join(f"f_fluidNonReacting{name}[{k}]" for name in ("Impulse", "Applied") for k in (1, 2, 3))


class MotionCase(grainjet.Case):

    def head(self, boundary="p p f", sort="0 0", dimension=3):
        return HEAD.format(boundary=boundary, sort=sort, probe=PROBE, dimension=dimension)

    def moved(self, kind, gravity="9.81 0 0 -1", fluid="", group="all", inside=True):
        """The lines that move grains; fluid: the fix fluid/force with ID f; inside: gravity by the keyword."""
        weight = f"fix g {group} gravity {gravity.replace(' ', ' vector ', 1)}\n" if gravity else ""
        if kind == STOCK:
            return weight + fluid + f"fix i {group} nve/sphere\n"
        words = (" gravity " + gravity if gravity and inside else "") + (" fluid f" if fluid else "")
        return ("" if inside else weight) + fluid + f"fix i {group} grain/motion{words}\n"

    def compare(self, script, columns, tolerance, ranks=(0,), joined=None):
        """script(kind): text that dumps `columns` to the file <kind>.dump. All columns of all grains agree to
        `tolerance` of the largest number in their kind; returns the outputs."""
        stock = self.liggghts(script(STOCK), name="in.stock").output
        expected = dumps.array(self.folder / "stock.dump")
        for n in ranks:
            output = self.liggghts(script(MOTION), n, name="in.motion").output
            found = dumps.array(self.folder / "motion.dump")
            if joined is not None:
                self.assertEqual("halves of steps are joined" in output, joined, output)
            self.assertEqual(expected.shape, found.shape)
            numpy.testing.assert_array_equal(expected[:, 0], found[:, 0])
            for k in range(1, expected.shape[1], 3):
                scale = abs(expected[:, k:k + 3]).max()
                error = abs(found[:, k:k + 3] - expected[:, k:k + 3]).max()
                name = columns.split()[k - 1]
                print(f"{n or 1} rank(s), {name}: largest {scale:.3g}, differs by {error / scale if scale else error:.1e}")
                self.assertLessEqual(error, tolerance * scale, name)
        return stock, output

    def dump(self, kind, columns):
        # at steps that are no multiples of anything else, and at the end of the run
        return scripts.dump(37, f"{kind}.dump", "id " + columns)
