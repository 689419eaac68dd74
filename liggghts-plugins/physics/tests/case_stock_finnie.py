# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Why laws of wear are applied once per impact: the Finnie model of the stock program adds up its law over the steps of the approach,
each with the angle and speed of the moment, in which the normal velocity falls to zero. A frictionless impact comes out at

    W/(k m v^2) = integral of 2 sqrt(cos^2 a + s^2) g(b) ds over s from 0 to sin a,    tan b = s/cos a

which is not Finnie's g(a), the result of one impact at the angle a."""

import math
import unittest

import grainjet
from grainjet import scripts, surfaces
from scipy.integrate import quad

D, RHO, SPEED, K = 1e-4, 2500.0, 5.0, 1e-10
MASS = math.pi / 6 * D ** 3 * RHO
ANGLES = (10, 20, 30, 45, 60)

SCRIPT = """
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
units si
read_data grains.data
neighbor 0.0002 bin
neigh_modify delay 0 binsize 0.002
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 1.0
fix m4 all property/global coefficientFriction peratomtypepair 1 0.0
fix m5 all property/global k_finnie peratomtypepair 1 1e-10
timestep 2e-8
fix plates all mesh/surface/stress file plates.stl type 1 wear finnie
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes plates
fix i all nve/sphere
run 3000
dump worn all mesh/vtk 1 worn*.vtk wear area
run 0
"""


def finnie(angle):
    """g(a), as in the paper of 1960."""
    if math.tan(angle) <= 1 / 3:
        return math.sin(2 * angle) - 3 * math.sin(angle) ** 2
    return math.cos(angle) ** 2 / 3


def summed(angle):
    """What the sum over the approach comes to, over k m v^2."""
    along = math.cos(angle)
    integral = quad(lambda s: 2 * math.hypot(along, s) * finnie(math.atan2(s, along)), 0, math.sin(angle),
                    points=[along / 3] if math.sin(angle) > along / 3 else None)
    return integral[0]


class StockFinnie(grainjet.Case):

    def test_sum_over_steps(self):
        """One triangle and one grain per angle."""
        grains, triangles = [], []
        for i, degrees in enumerate(ANGLES):
            x, a = 0.01 * i, math.radians(degrees)
            triangles.append(((x, -0.002, 0), (x + 0.006, -0.002, 0), (x, 0.004, 0)))
            grains.append((1, D, RHO, (x + 0.0015, 0, 0.51 * D), (SPEED * math.cos(a), 0, -SPEED * math.sin(a))))
        (self.folder / "grains.data").write_text(scripts.data(grains, ((-0.001, 0.06), (-0.01, 0.01), (-0.001, 0.01))))
        (self.folder / "plates.stl").write_text(scripts.stl(*triangles))
        self.liggghts(SCRIPT, program="liggghts")
        surface = surfaces.Surface(self.folder / "worn3000.vtk")
        stock = surface.values["wear"] * surface.values["area"] / (K * MASS * SPEED ** 2)

        print("angle  stock, summed over steps  quadrature  Finnie, per impact  stock/Finnie")
        for degrees, worn in zip(ANGLES, stock):
            angle = math.radians(degrees)
            print(f"{degrees:5d}  {worn:24.4f}  {summed(angle):10.4f}  {finnie(angle):18.4f}  {worn / finnie(angle):12.3f}")
        for degrees, worn in zip(ANGLES, stock):
            angle = math.radians(degrees)
            # thousands of steps over the approach; the stock program has 0.33333 for 1/3
            self.assertAlmostEqual(worn / summed(angle), 1, delta=0.005, msg=f"{degrees} degrees")
        for degrees, ratio in ((10, 0.20), (30, 0.88), (60, 2.4)):
            self.assertAlmostEqual(stock[ANGLES.index(degrees)] / finnie(math.radians(degrees)) / ratio, 1, delta=0.02)


if __name__ == "__main__":
    unittest.main()
