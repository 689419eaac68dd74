# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The full void-fraction equations of a gas: fixed beds, and mass, momentum and energy of a crowd in a closed box."""
# processors: 2
# label: long

import unittest

import numpy

import gas_box
from case_compressible import CELL_VOLUME, FAST, field_sum, outer
from case_fixed_bed import ACROSS, ALONG, BED, CELL, MIDDLE, NU, OFFSET, RHO, SPACING, Bed
from crowded_box import crowd, values
from gas_box import field, kinetic
from grainjet import coupled_box as box, dumps

FULL = box.void_fraction("full")


class GasBed(gas_box.GasCase):

    def bed(self, bed, ranks=0, steps=100, correctors=6, **options):
        """Measured - dp/dz in the middle of the bed, Pa/m, and the largest difference between the mass that crosses
        a layer and what enters, relative."""
        dt = bed.time_step()
        across = range(2 * ACROSS)
        positions = [[(n + 0.5 + shift) * SPACING for n, shift in zip((i, j, k), OFFSET)]
                     for k in range(2 * BED.start, 2 * BED.stop) for j in across for i in across]
        width, length = ACROSS * CELL, ALONG * CELL
        folder = self.run_gas(
            ranks, steps=steps, grains=(positions, [(0, 0, 0)] * len(positions)), boundary="p p f", density=1e11,
            diameter=bed.diameter, box_of_grains=f"0 {width} 0 {width} 0 {length}", dem_step=dt / 10, delta_t=dt,
            velocity=f"(0 0 {bed.velocity!r})", mu=RHO * NU, through=True, convection="upwind",
            cells=f"{ACROSS} {ACROSS} {ALONG}", size=[1e3 * CELL * n for n in (ACROSS, ACROSS, ALONG)],
            gas="rhoConst", gas_density=RHO, correctors=f"nOuterCorrectors 1; nCorrectors {correctors};",
            processors="processors 1 1 2" if ranks else "", options={"voidFraction": FULL, "drag": "Ergun",
                                                                     "forces": "(pressureGradient)", **options})
        end = max((f.parent for f in folder.glob("*/voidFraction")), key=lambda f: float(f.name))
        layers = {name: field(end / name).reshape(ALONG, ACROSS ** 2, -1).mean(1)[:, 0] for name in ("p", "voidFraction")}
        low, high = MIDDLE
        entering = RHO * bed.velocity * CELL ** 2
        phi = field(end / "phi")
        # the faces between layers carry all of the mean flow
        through = phi[abs(phi) > 0.5 * entering]
        self.assertEqual(len(through), ACROSS ** 2 * (ALONG - 1))
        e = layers["voidFraction"]
        of_layer = numpy.repeat((e[1:] + e[:-1]) / 2, ACROSS ** 2)
        flux = abs(numpy.sort(through) / entering - numpy.sort(1 / of_layer)).max()
        return (layers["p"][low] - layers["p"][high]) / (CELL * (high - low)), flux

    def test_ergun(self):
        """Ergun's pressure drop in the middle, within 0.5 %, of a gas of constant density, from dense to dilute; the
        mass through each layer is what enters."""
        for alpha, reynolds in ((0.6, 17), (0.6, 1000), (0.3, 17), (0.3, 1000), (0.1, 17), (0.1, 1000)):
            with self.subTest(alpha=alpha, reynolds=reynolds):
                bed = Bed(alpha, reynolds)
                slope, flux = self.bed(bed, steps=200 if alpha > 0.5 else 100)
                print(f"alpha_s {alpha} Re {reynolds}: measured/Ergun - 1 = {slope / bed.ergun() - 1:.1e}, flux {flux:.1e}")
                self.assertLess(abs(slope / bed.ergun() - 1), 5e-3)
                self.assertLess(flux, 1e-6)

    def test_ranks(self):
        """Serial and 2 ranks, whose cut lies in the middle of the bed, to the solvers' tolerance."""
        bed = Bed(0.6, 17)
        serial, parallel = (self.bed(bed, ranks, steps=20)[0] for ranks in (0, 2))
        self.assertLess(abs(parallel / serial - 1), 1e-9)


class GasCrowd(gas_box.GasCase):

    def of_gas(self, folder, energy):
        """Mass (kg), momentum (N s) and energy (J) of the gas between the grains, with all debts."""
        U, p, rho, of_mass, e = (field(folder / name) for name in ("U", "p", "rho", energy, "voidFraction"))
        debts = {name: field_sum(folder / name) for name in ("massOfShares", "massLeft", "energyOfShares", "particleEnergyOwed")}
        owed = sum(values(folder / name).sum(0) for name in ("particleMomentumOwed", "momentumOfShares"))
        of_volume = rho * of_mass - (p if energy == "h" else 0) + 0.5 * rho * (U ** 2).sum(1)
        return (CELL_VOLUME * (e * rho).sum() + debts["massOfShares"] + debts["massLeft"],
                CELL_VOLUME * ((e * rho)[:, None] * U).sum(0) + owed,
                CELL_VOLUME * (e * of_volume).sum() + debts["energyOfShares"] + debts["particleEnergyOwed"])

    def test_closed_box(self):
        """A crowd of grains that moves through gas in a closed box, solid fractions up to 0.7: mass of the gas between
        the grains, momentum and energy of both."""
        x, v = crowd()
        v = [[8 * a for a in row] for row in v]
        for energy in ("e", "h"):
            with self.subTest(energy=energy):
                folder = self.run_gas(steps=12, write_every=6, grains=(x, v), diameter=1e-3, dump_every=60, energy=energy,
                                      correctors="nOuterCorrectors 30; nCorrectors 3;", options={"voidFraction": FULL})
                a, b = (self.of_gas(folder / time, energy) for time in ("0.0006", "0.0012"))
                (k0, p0), (k1, p1) = (kinetic(folder / "grains.dump", frame, 1e-3) for frame in (1, 2))
                table = box.read_balance(folder)
                exchanged, passed = (sum(map(abs, table[name][6:])) for name in ("energyToGrains", "toGrains_z"))
                mass = b[0] / a[0] - 1
                momentum = abs(b[1] + p1 - a[1] - p0).max() / passed
                joule = abs(b[2] + k1 - a[2] - k0) / exchanged
                print(f"{energy}: mass {mass:.1e}, momentum {momentum:.1e}, energy {joule:.1e} of what was exchanged")
                self.assertLess(abs(mass), 1e-12)
                self.assertLess(momentum, 1e-6)
                self.assertLess(joule, 1e-4)
                self.assertLess(field(folder / "0.0012/voidFraction").min(), 0.4)

    def test_without_grains(self):
        """Without a grain the fields are bit for bit those of the solver alone."""
        gas = {"steps": 3, "velocity": "(1 2 3)", "walls": True}
        alone = self.run_gas(options=False, **gas)
        coupled = self.run_gas(grains=([], []), boundary="f f f", options={"voidFraction": FULL}, **gas)
        for name in ("U", "p", "T", "phi"):
            a, b = ((f / "0.0003" / name).read_bytes() for f in (alone, coupled))
            self.assertEqual(a, b, name)


if __name__ == "__main__":
    unittest.main()
