# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A fixed bed's pressure drop: the stock solver's own balance exactly, Ergun's equation where the bed is dilute.

The solver knows no void fraction, so its velocity U is the superficial one, and the drag law sees U where
the fluid between the grains has U/eps. See "Fixed bed" in docs/theory-coupling.md.
"""
# processors: 2
# label: long

import math
import pathlib
import re
import tempfile
import unittest

import grainjet
from grainjet import coupled_box as box, dictionaries

RHO, NU = 1.2, 1.5e-5

CELL = 4e-3             # cubes
ACROSS, ALONG = 2, 40   # cells
BED = range(5, 35)      # cell layers with grains
MIDDLE = (17, 22)       # between the centres of these layers the pressure drop is measured
SPACING = CELL / 2      # of the cubic lattice: eight grains per cell

# The lattice is out of step with the cells, so that most grains lie in several of them. It has the cells'
# period, so that all cells inside the bed hold the same solid fraction.
OFFSET = (0.13, 0.21, 0.29)

# What the middle feels of the bed's ends, where cell velocities are off by up to 1.1 U. That fades by a
# factor of about three per layer, so over the twelve layers to the nearer end to less than 1e-5.
BALANCE = 1e-5


class Bed:
    """A bed of solid fraction alpha, crossed at the Reynolds number U d/nu."""

    def __init__(self, alpha, reynolds):
        self.eps = 1 - alpha
        self.diameter = SPACING * (6 * alpha / math.pi) ** (1 / 3)
        self.velocity = reynolds * NU / self.diameter
        self.viscous = 150 * RHO * NU * alpha ** 2 * self.velocity / self.diameter ** 2
        self.inertial = 1.75 * RHO * alpha * self.velocity ** 2 / self.diameter

    def ergun(self):
        """- dp/dz in Pa/m, Ergun, Chem. Eng. Prog. 48 (1952) 89, with the superficial velocity."""
        return (self.viscous + self.inertial) / self.eps ** 3

    def stock(self, pressure_gradient):
        """- dp/dz in Pa/m of the solver's equation, - grad p = drag (- alpha grad p), where the drag
        per volume is beta U of the Ergun law at U."""
        drag = self.viscous / self.eps + self.inertial
        return drag / self.eps if pressure_gradient else drag

    def time_step(self):
        """A fifth of a cell, and half the time in which drag stops the fluid: with longer steps the
        implicit source, whose correction comes one step late, rings for longer than the run."""
        rate = self.stock(False) / (RHO * self.velocity)
        return float(f"{min(0.2 * CELL / self.velocity, 0.5 / rate):.6g}")


class FixedBed(grainjet.Case):

    def drop(self, bed, ranks=0, **options):
        """Measured - dp/dz in the middle of the bed, Pa/m."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        dt = bed.time_step()
        # Fifty steps of an incompressible fluid that has its velocity from the start: the pressure
        # gradient that grains feel is one step old, and settles by a factor alpha per step.
        # Upwind: odd-even waves from the ends of the bed would cross it with linear.
        box.write(folder, velocity=f"(0 0 {bed.velocity!r})", nu=NU, steps=50, delta_t=dt,
                  cells=f"{ACROSS} {ACROSS} {ALONG}", through=True, convection="upwind",
                  size=[1e3 * CELL * n for n in (ACROSS, ACROSS, ALONG)])
        across = range(2 * ACROSS)
        positions = [[(n + 0.5 + shift) * SPACING for n, shift in zip((i, j, k), OFFSET)]
                     for k in range(2 * BED.start, 2 * BED.stop) for j in across for i in across]
        # So heavy that they gain less than 1e-7 of the fluid's velocity in the run
        width, length = ACROSS * CELL, ALONG * CELL
        box.script(folder, dt=dt / 10, boundary="p p f", box=f"0 {width} 0 {width} 0 {length}",
                   grains=box.grains(positions, [(0, 0, 0)] * len(positions), bed.diameter, 1e11),
                   processors="processors 1 1 2" if ranks else "")
        box.fv_options(folder, drag="Ergun", **options)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.log = self.foam("pimpleFoam", folder, ranks=ranks).output
        if ranks:
            self.foam("reconstructPar", folder)

        end = max((f.parent for f in folder.glob("*/voidFraction")), key=lambda f: float(f.name))
        for layer in MIDDLE:
            for value in self.layer(end / "voidFraction", layer):
                self.assertAlmostEqual(value, bed.eps, delta=1e-12)
        pressure = [RHO * sum(self.layer(end / "p", k)) / ACROSS ** 2 for k in range(ALONG)]
        fastest = max(u[2] for u in dictionaries.internal(end / "U")) / bed.velocity
        whole = (pressure[0] - pressure[-1]) / (CELL * len(BED))
        low, high = (pressure[layer] for layer in MIDDLE)
        slope = (low - high) / (CELL * (MIDDLE[1] - MIDDLE[0]))
        print(f"\nwhole bed/middle {whole / slope:.3f}, largest cell velocity {fastest:.2f} U")
        return slope

    def layer(self, path, k):
        return dictionaries.internal(path)[k * ACROSS ** 2:(k + 1) * ACROSS ** 2]

    def announced(self):
        """Percentages of the log's warnings about solid fractions."""
        return [float(x) for x in re.findall("Grains fill (.*) % of a cell", self.log)]

    def assertRatio(self, value, expected, tolerance):
        self.assertLess(abs(value / expected - 1), tolerance, f"{value} against {expected}")

    def test_balance_of_the_stock_equation(self):
        """Both terms of the drag law alike (Re 17), with and without the pressure gradient on the
        grains, as Set I and as Set II, which are the same in a uniform bed; serial and on 2 ranks,
        whose cut lies in the middle of the bed, to round-off."""
        bed = Bed(0.2, 17)
        for formulation, forces in (("SetI", "()"), ("SetI", "(pressureGradient)"),
                                    ("SetII", "(pressureGradient)"), ("SetI", "(pressureGradient viscous)")):
            with self.subTest(formulation=formulation, forces=forces):
                serial = self.drop(bed, formulation=formulation, forces=forces)
                expected = bed.stock(pressure_gradient="pressureGradient" in forces)
                print(f"{formulation} {forces}: {serial:.8g} Pa/m, balance {expected:.8g} Pa/m")
                self.assertRatio(serial, expected, BALANCE)
                parallel = self.drop(bed, ranks=2, formulation=formulation, forces=forces)
                print(f"2 ranks / serial - 1 = {parallel / serial - 1:.1e}")
                self.assertRatio(parallel, serial, 1e-9)

    def against_ergun(self, alpha, reynolds):
        """Ratio to Ergun's pressure drop, with the pressure gradient on the grains."""
        bed = Bed(alpha, reynolds)
        measured = self.drop(bed, forces="(pressureGradient)")
        ergun, stock = bed.ergun(), bed.stock(pressure_gradient=True)
        print(f"alpha_s {alpha:<5} Re {reynolds:<5} Ergun {ergun:.6g} stock {stock:.6g} measured "
              f"{measured:.6g} Pa/m, measured/stock - 1 {measured / stock - 1:.1e}, "
              f"measured/Ergun {measured / ergun:.4f}")
        self.assertRatio(measured, stock, BALANCE)
        return measured / ergun

    def test_ergun_where_dilute(self):
        """Within 5 % of Ergun up to a solid fraction of 5 % where viscosity rules and 2.5 % where
        inertia does; no warning there."""
        for alpha, reynolds in ((0.01, 0.01), (0.049, 0.01), (0.02, 1), (0.01, 1000), (0.025, 1000)):
            with self.subTest(alpha=alpha, reynolds=reynolds):
                self.assertLess(abs(self.against_ergun(alpha, reynolds) - 1), 0.05)
                self.assertEqual(self.announced(), [])

    def test_ergun_where_dense(self):
        """Outside of that range low by eps (viscous) to eps^2 (inertial), and the log warns. The
        other term's share of the drag is below 1e-3 at Re 0.01 and 0.034 at Re 1000."""
        for alpha, reynolds, power, tolerance in ((0.2, 0.01, 1, 1e-3), (0.2, 1000, 2, 0.034),
                                            (0.4, 0.01, 1, 1e-3), (0.4, 1000, 2, 0.034)):
            with self.subTest(alpha=alpha, reynolds=reynolds):
                ratio = self.against_ergun(alpha, reynolds)
                self.assertRatio(ratio, (1 - alpha) ** power, tolerance)
                self.assertEqual(len(self.announced()), 1)
                self.assertAlmostEqual(self.announced()[0], 100 * alpha, delta=1e-9)
        self.assertLess(self.against_ergun(0.2, 17), 0.95)


if __name__ == "__main__":
    unittest.main()
