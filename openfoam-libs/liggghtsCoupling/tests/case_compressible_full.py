# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The full void-fraction equations of a gas: fixed beds, and mass, momentum and energy of a crowd in a closed box."""
# processors: 2
# label: long

import unittest

import numpy

import gas_box
from crowded_box import CELL_VOLUME, crowd, values
from gas_box import SOLVERS, field, field_sum, kinetic
from grainjet import coupled_box as box

FULL = box.void_fraction("full")
RHO, NU = 1.2, 1.5e-5

# A bed as that of case_fixed_bed.py: a cubic lattice, out of step with the cells
CELL, ACROSS, ALONG = 4e-3, 2, 40       # cubes
BED, MIDDLE = range(5, 35), (17, 22)    # layers of cells
SPACING, OFFSET = CELL / 2, (0.13, 0.21, 0.29)


class Bed:
    """A bed of solid fraction alpha, crossed at the Reynolds number U d/nu."""

    def __init__(self, alpha, reynolds):
        self.diameter = SPACING * (6 * alpha / numpy.pi) ** (1 / 3)
        self.velocity = u = reynolds * NU / self.diameter
        viscous, inertial = 150 * RHO * NU * alpha ** 2 * u / self.diameter ** 2, 1.75 * RHO * alpha * u ** 2 / self.diameter
        # Pa/m, Ergun, Chem. Eng. Prog. 48 (1952) 89
        self.ergun = (viscous + inertial) / (1 - alpha) ** 3
        rate = (viscous / (1 - alpha) + inertial) / (1 - alpha) / (RHO * u)
        self.time_step = float(f"{min(0.2 * CELL / u, 0.5 / rate):.6g}")


class GasBed(gas_box.GasCase):

    def drop(self, bed, ranks=0, steps=100, correctors=6, **options):
        """Measured - dp/dz in the middle of the bed, Pa/m, and the largest difference between the mass that crosses
        a layer and what enters, relative."""
        dt = bed.time_step
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
                slope, flux = self.drop(bed, steps=120 if alpha > 0.5 else 60)
                print(f"alpha_s {alpha} Re {reynolds}: measured/Ergun - 1 = {slope / bed.ergun - 1:.1e}, flux {flux:.1e}")
                self.assertLess(abs(slope / bed.ergun - 1), 5e-3)
                self.assertLess(flux, 1e-6)

    def test_ranks(self):
        """Serial and 2 ranks, whose cut lies in the middle of the bed, to the solvers' tolerance."""
        bed = Bed(0.6, 17)
        serial, parallel = (self.drop(bed, ranks, steps=20)[0] for ranks in (0, 2))
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

    def balances(self, steps=4, **more):
        """Relative to what there is, mass of the gas, and relative to what was exchanged, momentum and energy that gas and
        grains have not kept in the second half of a run."""
        x, v = crowd()
        energy = more.get("energy", "e")
        options = {"voidFraction": FULL, **more.pop("options", {})}
        folder = self.run_gas(steps=2 * steps, write_every=steps, grains=(x, [[8 * a for a in row] for row in v]), diameter=1e-3,
                              dump_every=10 * steps, correctors="nOuterCorrectors 25; nCorrectors 3;", options=options, **more)
        a, b = (self.of_gas(folder / f"{n * steps * 1e-4:.10g}", energy) for n in (1, 2))
        (k0, p0), (k1, p1) = (kinetic(folder / "grains.dump", frame, 1e-3) for frame in (1, 2))
        table = box.read_balance(folder)
        exchanged, passed = (sum(map(abs, table[name][steps:])) for name in ("energyToGrains", "toGrains_z"))
        self.assertLess(field(folder / f"{2 * steps * 1e-4:.10g}/voidFraction").min(), 0.4)
        self.assertLess(numpy.ptp(table["gasMass"][1:]), 1e-12 * table["gasMass"][1])
        self.assertLess(max(table["imbalance"] + table["energyImbalance"]), 1e-10)
        return (abs(b[0] / a[0] - 1), abs(b[1] + p1 - a[1] - p0).max() / passed, abs(b[2] + k1 - a[2] - k0) / exchanged)

    def test_closed_box(self):
        """A crowd of grains that moves through gas in a closed box, solid fractions up to 0.7: mass of the gas between
        the grains, momentum and energy of both."""
        for solver, energy, transonic in SOLVERS:
            with self.subTest(solver=solver, energy=energy, transonic=transonic):
                mass, momentum, joule = self.balances(solver=solver, energy=energy, transonic=transonic)
                print(f"{solver} {energy} transonic {transonic}: mass {mass:.1e}, momentum {momentum:.1e}, energy {joule:.1e}")
                self.assertLess(mass, 1e-12)
                self.assertLess(momentum, 1e-9)
                self.assertLess(joule, 1e-6)

    def test_ranks_and_restart(self):
        """1 and 2 ranks; a run that is stopped and continued."""
        x, v = crowd(1500, height=0.019)
        case = {"grains": (x, [[8 * a for a in row] for row in v]), "diameter": 1e-3, "write_every": 3,
                "correctors": "nOuterCorrectors 3; nCorrectors 3;", "options": {"voidFraction": FULL}}
        serial, parallel = (self.run_gas(ranks, steps=6, **case) for ranks in (0, 2))
        self.compare(serial, parallel, "0.0006", 1e-9)
        parts = self.run_gas(steps=3, **case)
        box.end_at(parts, 6)
        self.foam("rhoPimpleFoam", parts)
        for name in ("U", "p", "T", "particleMomentumSource", "particleEnergySource"):
            a, b = (field(run / "0.0006" / name) for run in (serial, parts))
            print(f"{name}: restart {abs(a - b).max() / abs(a).max():.1e}")
            self.assertLess(abs(a - b).max(), 1e-9 * abs(a).max(), name)
        self.assertLess(max(box.read_balance(parts, "0.0003")["energyImbalance"]), 1e-10)

    def test_uniform_motion(self):
        """Gas and grains that move alike keep moving alike, whatever the void fraction, and the pressure stays: what is
        left is what the gas pays back for the kicks that were left out, as in case_full_equations.py. With the kicks
        a grain's part that crosses a face, 1/29 of 1e-3 of the cell, would press the gas by 4 Pa, 14 rho U^2."""
        x, _ = crowd(3000, height=0.04)
        folder = self.run_gas(steps=20, grains=(x, [(0, 0, 0.5)] * len(x)), diameter=1e-3, velocity="(0 0 0.5)", mu=1.8e-5,
                              correctors="nOuterCorrectors 3; nCorrectors 2;", options={"voidFraction": FULL})
        speed = abs(values(folder / "0.002/U") - [0, 0, 0.5]).max() / 0.5
        pressure = numpy.ptp(field(folder / "0.002/p"))
        print(f"velocity off by {speed:.1e} U, pressure by {pressure / (gas_box.RHO0 * 0.25):.1e} rho U^2")
        self.assertLess(speed, 2e-3)
        self.assertLess(pressure, 0.02 * gas_box.RHO0 * 0.25)

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
