# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The full void-fraction equations of a gas: mass, momentum and energy of a crowd of grains in a closed box. For fixed
beds see case_compressible_bed.py."""
# processors: 2
# label: long

import unittest

import numpy

import gas_box
from crowded_box import CELL_VOLUME, crowd, values
from gas_box import SOLVERS, field, field_sum, kinetic
from grainjet import coupled_box as box, dictionaries

FULL = box.void_fraction("full")


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

    def test_consistent_and_turbulent(self):
        """The same with SIMPLEC, and with models of turbulence."""
        libs = '("libliggghtsCoupling.so" "libjetTurbulenceModels.so")'
        for more in ({"consistent": True}, {"consistent": True, "transonic": True, "energy": "h"},
                     {"turbulence": "kEpsilon", "epsilon": 100.0},
                     {"turbulence": "SpalartAllmaras", "nu_tilda": 1e-3}, {"turbulence": "kEqn", "simulation": "LES"},
                     {"solver": "sonicFoam", "turbulence": "kEpsilon", "epsilon": 100.0}, {"turbulence": "jetKEpsilon", "epsilon": 100.0, "libs": libs}):
            with self.subTest(**more):
                mass, momentum, joule = self.balances(**more)
                print(f"{more}: mass {mass:.1e}, momentum {momentum:.1e}, energy {joule:.1e}")
                self.assertLess(mass, 1e-12)
                self.assertLess(momentum, 1e-9)
                self.assertLess(joule, 1e-6)

    def test_ranks_and_restart(self):
        """1 and 2 ranks; a run that is stopped and continued."""
        for more in ({}, {"turbulence": "kEpsilon", "epsilon": 100.0}):
            with self.subTest(**more):
                x, v = crowd(1500, height=0.019)
                case = {"grains": (x, [[8 * a for a in row] for row in v]), "diameter": 1e-3, "write_every": 3,
                        "correctors": "nOuterCorrectors 3; nCorrectors 3;", "options": {"voidFraction": FULL}, **more}
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

    def test_frozen_model(self):
        """A turbulence model that is switched off has no equations: no warning of sources that are never used."""
        x, v = crowd(500)
        self.run_gas(steps=3, turbulence="kEpsilon", frozen=True, diameter=1e-3, grains=(x, v), options={"voidFraction": FULL})
        self.assertNotIn("never used", self.result.output)

    def test_refused(self):
        """By one error, which names what to change, before the first momentum equation."""
        def change(*pair):
            return lambda folder: dictionaries.change(folder / "system/fvSchemes", pair)

        for more, options, spoil, words in (
                ({}, {"formulation": "SetII"}, None, ("formulation SetII with equations full", "Set formulation SetI")),
                ({"time_scheme": "backward"}, {}, None, ("ddtSchemes", "default backward", "Set Euler")),
                ({"time_scheme": "CrankNicolson 0.9"}, {}, None, ("ddtSchemes", "default CrankNicolson", "Set Euler")),
                ({}, {}, change("default Euler", "default Euler; ddt(rho,U) bounded Euler"), ("ddt(rho,U) bounded", "Set Euler")),
                ({}, {}, change("divSchemes {", "divSchemes { div(phi,e) bounded Gauss upwind;"), ("div(phi,e) is bounded",)),
                ({}, {}, change("divSchemes {", "divSchemes { div(phi,K) bounded Gauss upwind;"), ("div(phi,K) is bounded",)),
                ({"turbulence": "kEpsilon"}, {}, change("divSchemes {", "divSchemes { div(phi,k) bounded Gauss upwind;"),
                 ("div(phi,k) is bounded",)),
                ({"turbulence": "LRR"}, {}, None, ("LRR", "Reynolds stress", "equations neglected"))):
            with self.subTest(words=words):
                folder = self.new_folder()
                gas_box.write(folder, **more)
                if more.get("turbulence") == "LRR":
                    dictionaries.write(folder / "0/R", "dimensions [0 2 -2 0 0 0 0]; internalField uniform (0.6 0 0 0.6 0 0.6);\n"
                                       'boundaryField { ".*" { type cyclic; } }\n', "volSymmTensorField")
                if spoil:
                    spoil(folder)
                box.script(folder, grains=box.grains(*box.swarm(3, 1)))
                box.fv_options(folder, **{"voidFraction": FULL, **options})
                for tool in ("blockMesh", "decomposePar"):
                    self.foam(tool, folder)
                for ranks in (0, 2):
                    result = self.foam("rhoPimpleFoam", folder, ranks, check=False)
                    self.assertFails(result, *words)
                    self.assertNotRegex(result.output, box.SOLVED)
                    self.assertEqual(result.output.count("FOAM FATAL"), 1, result)


if __name__ == "__main__":
    unittest.main()
