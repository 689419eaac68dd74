# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains in a gas: momentum and energy of both together, ranks, restart, and what is refused. For the drag of a
stream of gas see case_compressible_stream.py."""
# processors: 2
# label: long

import shutil
import unittest

import numpy

import gas_box
from crowded_box import CELL_VOLUME, values
from gas_box import SOLVERS, field, field_sum, kinetic
from grainjet import coupled_box as box, dictionaries, dumps

# 40 m/s, a tenth of the speed of sound, so that the gas heats up by more than round-off
FAST = {"mean": (0, 0, 40), "rms": 8}


def outer(n):
    """Correctors of the solver."""
    return f"nOuterCorrectors {n}; nCorrectors 2;"


def of_gas(folder, energy="e"):
    """Momentum (N s), energy (J) and mass (kg) of the gas, with what it is still owed. Enthalpy holds p/rho."""
    U, p, rho, of_mass = (field(folder / name) for name in ("U", "p", "rho", energy))
    of_volume = rho * of_mass - (p if energy == "h" else 0)
    total = CELL_VOLUME * (of_volume + 0.5 * rho * (U ** 2).sum(1)).sum()
    owed = values(folder / "particleMomentumOwed").sum(0)
    return (CELL_VOLUME * (rho[:, None] * U).sum(0) + owed, total + field_sum(folder / "particleEnergyOwed"),
            CELL_VOLUME * rho.sum())


class Compressible(gas_box.GasCase):

    def balances(self, folder, energy, first, last, steps):
        """Relative to what was exchanged: momentum and energy that gas and grains have not kept between two
        times, from the fields and the grains' velocities; the gas that is lost, relative to all."""
        a, b = (of_gas(folder / time, energy) for time in (first, last))
        table = box.read_balance(folder)
        frames = dumps.frames(folder / "grains.dump")
        (k0, p0), (k1, p1) = (kinetic(folder / "grains.dump", frame) for frame in steps)
        exchanged = sum(map(abs, table["energyToGrains"]))
        passed = sum(map(abs, table["toGrains_z"]))
        self.assertEqual(len(frames), 3)
        return (abs(b[0] + p1 - a[0] - p0).max() / passed, abs(b[1] + k1 - a[1] - k0) / exchanged,
                abs(b[2] / a[2] - 1), table)

    def run_balanced(self, solver, energy, transonic, n, steps=20, **more):
        """The balances of a closed box from its step 10 to its step 20."""
        folder = self.run_gas(steps=steps, write_every=10, solver=solver, energy=energy, transonic=transonic,
                              correctors=outer(n), grains=box.swarm(2000, 7, **FAST), dump_every=100, **more)
        return self.balances(folder, energy, "0.001", "0.002", (1, 2))

    def test_balances(self):
        """In a closed periodic box gas and grains keep momentum and energy together. Twenty outer correctors: the
        kinetic energy in the energy equation is that of the corrector before."""
        for solver, energy, transonic in SOLVERS:
            with self.subTest(solver=solver, energy=energy, transonic=transonic):
                momentum, joule, mass, table = self.run_balanced(solver, energy, transonic, 20)
                print(f"{solver} {energy} transonic {transonic}: momentum {momentum:.1e}, energy {joule:.1e} of what "
                      f"was exchanged, mass {mass:.1e}; tables {table['imbalance'][-1]:.1e} {table['energyImbalance'][-1]:.1e}")
                self.assertLess(momentum, 1e-9)
                self.assertLess(joule, 1e-6)
                self.assertLess(mass, 1e-12)
                self.assertLess(max(table["imbalance"]), 1e-10)
                self.assertLess(max(table["energyImbalance"]), 1e-10)
                # it is not the motion alone: half of the energy heats the gas
                self.assertGreater(max(table["energyToFluid"]), 0)

    def test_consistent(self):
        """The same with SIMPLEC."""
        for energy, transonic in (("e", False), ("h", True)):
            with self.subTest(energy=energy, transonic=transonic):
                momentum, joule, mass, _ = self.run_balanced("rhoPimpleFoam", energy, transonic, 20, consistent=True)
                self.assertLess(momentum, 1e-9)
                self.assertLess(joule, 1e-6)
                self.assertLess(mass, 1e-12)

    def test_second_order_in_time(self):
        """These schemes keep 3/2 of the momentum of a step less 1/2 of that before, or give half of the rate of a step in the next
        one: what gas and grains have differs by at most half of what a step exchanged. Mass as ever."""
        for scheme in ("backward", "CrankNicolson 0.9"):
            with self.subTest(scheme=scheme):
                momentum, joule, mass, table = self.run_balanced("rhoPimpleFoam", "e", False, 20, time_scheme=scheme)
                print(f"{scheme}: momentum {momentum:.1e}, energy {joule:.1e}, mass {mass:.1e}")
                for off, name in ((momentum, "toGrains_z"), (joule, "energyToGrains")):
                    steps = numpy.abs(table[name])
                    self.assertLess(off, 0.5 * steps.max() / steps.sum())
                self.assertLess(mass, 1e-12)

    def test_first_step(self):
        """Gas of Mach 1.5 that grains at rest begin to slow down: what its motion loses heats it in the first step of a run,
        too. To 1e-6 of that; a first step as of the stock solver has no change of the kinetic energy, and loses all of it."""
        speed, count = 1.5 * gas_box.SOUND, 500
        x, _ = box.swarm(count, 7)
        for solver in ("rhoPimpleFoam", "sonicFoam"):
            with self.subTest(solver=solver):
                folder = self.run_gas(steps=1, solver=solver, velocity=f"(0 0 {speed!r})", delta_t=2e-6, dem_step=2e-7,
                                      correctors=outer(20), grains=(x, [(0, 0, 0)] * count))
                U, T, rho = (field(folder / "2e-06" / name) for name in ("U", "T", "rho"))
                now = CELL_VOLUME * (rho * (gas_box.CV * T + 0.5 * (U ** 2).sum(1))).sum()
                before = CELL_VOLUME * rho.sum() * (gas_box.CV * gas_box.T0 + 0.5 * speed ** 2)
                owed = field_sum(folder / "2e-06/particleEnergyOwed")
                grains, _ = kinetic(folder / "grains.dump")
                heat = speed * box.read_balance(folder)["toGrains_z"][0]
                print(f"{solver}: lost {(now + owed + grains - before) / heat:.1e} of {heat:.1e} J, owed {owed:.1e} J")
                self.assertLess(abs(now + owed + grains - before), 1e-6 * heat)

    def test_ranks(self):
        """1 and 2 ranks: the same but for the order of sums and the tolerance of the solvers."""
        runs = [self.run_gas(ranks, steps=6, grains=box.swarm(500, 3, **FAST), correctors=outer(3)) for ranks in (0, 2)]
        self.compare(*runs, "0.0006", 1e-9)
        for name, least in (("T", 1e-3), ("particleEnergySource", 1)):
            a, b = (field(run / "0.0006" / name) for run in runs)
            self.assertGreater(abs(a - a.mean()).max(), least, name)
            self.assertLess(abs(a - b).max(), 1e-9 * abs(a).max(), name)

    def test_restart(self):
        """A run of 12 steps, and one that is stopped and continued after 6: fields of the solver to the round-off
        of T, from which OpenFOAM works e out anew; without the kinetic energy of the step before it would be 1e-5. What
        the gas is owed at the stop is not taken for an imbalance."""
        for solver, transonic in (("rhoPimpleFoam", True), ("sonicFoam", False)):
            with self.subTest(solver=solver):
                case = {"solver": solver, "transonic": transonic, "write_every": 6,
                        "grains": box.swarm(500, 3, **FAST), "dump_every": 60}
                whole, parts = (self.run_gas(steps=steps, **case) for steps in (12, 6))
                box.end_at(parts, 12)
                self.foam(solver, parts)
                table = box.read_balance(parts, "0.0006")
                self.assertLess(max(table["imbalance"] + table["energyImbalance"]), 1e-10)
                for name in ("U", "p", "T", "particleMomentumSource", "particleEnergySource"):
                    a, b = (field(run / "0.0012" / name) for run in (whole, parts))
                    print(f"{solver} {name}: {abs(a - b).max() / abs(a).max():.1e}")
                    self.assertLess(abs(a - b).max(), 1e-9 * abs(a).max(), name)

    def test_without_grains(self):
        """Without a grain the fields are bit for bit those of the solver alone."""
        for solver, energy, transonic in SOLVERS:
            with self.subTest(solver=solver, energy=energy, transonic=transonic):
                gas = {"steps": 3, "velocity": "(1 2 3)", "walls": True, "solver": solver, "energy": energy,
                       "transonic": transonic}
                alone = self.run_gas(options=False, **gas)
                coupled = self.run_gas(grains=([], []), boundary="f f f", **gas)
                for name in ("U", "p", "T", "phi"):
                    a, b = ((f / "0.0003" / name).read_bytes() for f in (alone, coupled))
                    self.assertEqual(a, b, name)

    def test_relaxed_last_energy_equation(self):
        """It is not satisfied, so that energy gets lost: a warning, once. None if only the correctors before are
        relaxed, or for one-way coupling."""
        for factors, coupling, warnings in (('"e.*" 0.7;', "twoWay", 1), ("e 0.7;", "twoWay", 0), ('"e.*" 0.7;', "oneWay", 0)):
            with self.subTest(factors=factors, coupling=coupling):
                folder = self.new_folder()
                self.run_gas(steps=1, into=folder, grains=box.swarm(5, 3), cells="2 2 4", check=False)
                for time in folder.glob("0.*"):
                    shutil.rmtree(time)
                box.fv_options(folder, fluid="compressible", coupling=coupling)
                dictionaries.change(folder / "system/controlDict", ("endTime 0.0001", "endTime 0.0004"))
                dictionaries.change(folder / "system/fvSolution",
                                    ("PIMPLE", f"relaxationFactors {{ equations {{ {factors} }} }}\nPIMPLE"),
                                    ("nOuterCorrectors 1", "nOuterCorrectors 2"))
                output = self.foam("rhoPimpleFoam", folder).output
                self.assertEqual(output.count("last energy equation of the time step is relaxed"), warnings, output)
                self.assertEqual("for eFinal in relaxationFactors" in output, warnings == 1)

    def test_refused(self):
        """Before time is spent, with file, entry and remedy; a solver without an equation of energy in its
        second step."""
        for solver, options, words in (
                ("rhoPimpleAdiabaticFoam", {}, ("has not asked for sources", "rhoPimpleFoam")),
                ("pimpleFoam", {}, ("has not read constant/thermophysicalProperties", "rhoPimpleFoam and sonicFoam")),
                ("rhoPimpleFoam", {"fluid": "incompressible"}, ("is a compressible solver",)),
                ("rhoPimpleFoam", {"formulation": "SetII", "voidFraction": "{ model divided; filter { length 4e-3; } }"},
                 ("formulation SetII with a filter", "SetI"))):
            with self.subTest(solver=solver, options=options):
                folder = self.new_folder()
                if solver == "pimpleFoam":
                    box.write(folder)
                else:
                    gas_box.write(folder, solver=solver)
                if solver == "rhoPimpleAdiabaticFoam":
                    dictionaries.change(folder / "constant/thermophysicalProperties",
                                        ("molWeight 28.9; }", f"molWeight 28.9; }} equationOfState {{ p0 1e5; T0 300; }}"))
                box.script(folder, grains=box.grains(*box.swarm(3, 1)))
                box.fv_options(folder, **{"fluid": "compressible", **options})
                self.foam("blockMesh", folder)
                result = self.foam(solver, folder, check=False)
                self.assertFails(result, "fvOptions", *words)


if __name__ == "__main__":
    unittest.main()
