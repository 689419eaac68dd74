# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hot grains and cold gas: energy of both together, stiff exchange, ranks, restart, spread grains, grains that leave."""
# processors: 4
# label: long

import random
import unittest

import numpy

import fluid_cases
import gas_box
import heat_box
from crowded_box import values
from gas_box import SOLVERS, field, field_sum
from grainjet import coupled_box as box, dictionaries, scripts

SPECIFIC_HEAT, HOT, PR = 800.0, 400.0, 1e-4      # a gas that conducts so well that its box is of one temperature soon
CONVERGED = "nOuterCorrectors 20; nCorrectors 2;"
AT_REST = {"mean": (0, 0, 0), "rms": 0}
DEBTS = ("particleHeatOwed", "heatOfLostGrains", "particleEnergyOwed", "energyOfLostGrains")
SIZE = 0.02 * 0.02 * 0.04


def volume(folder, time):
    """Of a cell, m3."""
    return SIZE / len(field(folder / time / "U"))


def of_gas(folder, time, energy="e", share=None):
    """Energy (J) of the gas, with what it is still owed. Enthalpy holds p/rho. share: of the cells that it fills."""
    U, p, rho, of_mass = (field(folder / time / name) for name in ("U", "p", "rho", energy))
    of_volume = rho * of_mass - (p if energy == "h" else 0) + 0.5 * rho * (U ** 2).sum(1)
    owed = sum(field_sum(folder / time / name) for name in DEBTS if (folder / time / name).exists())
    return volume(folder, time) * (of_volume * (1 if share is None else share)).sum() + owed


def of_grains(folder, frame, specific_heat=SPECIFIC_HEAT, grain=None):
    """Heat and kinetic energy (J) of the grains of a dump."""
    grain = grain or heat_box.mass()
    rows = numpy.array(list(heat_box.temperatures(folder / "grains.dump", frame).values()))
    return grain * specific_heat * rows.sum() + gas_box.kinetic(folder / "grains.dump", frame)[0] * grain / heat_box.mass()


class HeatBalance(heat_box.HeatCase):

    def run_hot(self, **case):
        """A closed box; grains at rest and without drag unless the case has others."""
        return self.run_warm(**{"specific_heat": SPECIFIC_HEAT, "temperature": HOT, "prandtl": PR, "correctors": CONVERGED,
                                "grains": box.swarm(2000, 7, **AT_REST), **case})

    def unbalanced(self, folder, times, frames, energy="e", **grains):
        """Energy that gas and grains have not kept between two times, relative to what was exchanged; the table."""
        table = box.read_balance(folder)
        first, last = (of_gas(folder, time, energy) + of_grains(folder, frame, **grains) for time, frame in zip(times, frames))
        return abs(last - first) / sum(map(abs, table["energyToGrains"])), table

    def common(self, folder, time, specific_heat=SPECIFIC_HEAT, count=2000, grain=None):
        """The temperature that gas of 300 K and the grains come to."""
        C = count * (grain or heat_box.mass()) * specific_heat
        G = volume(folder, time) * field(folder / time / "rho").sum() * gas_box.CV
        return (C * HOT + G * gas_box.T0) / (C + G)

    def test_common_temperature(self):
        """In a closed adiabatic box gas and grains keep their energy, and come to the temperature that m c of both give. Walls, and a
        periodic box; for e and h."""
        for (solver, energy, transonic), walls in zip(SOLVERS, (True, False, True)):
            with self.subTest(solver=solver, energy=energy, walls=walls):
                folder = self.run_hot(solver=solver, energy=energy, transonic=transonic, walls=walls, steps=120, write_every=60,
                                      dump_every=600, cells="5 5 10")
                off, table = self.unbalanced(folder, ("0.006", "0.012"), (1, 2), energy)
                T = numpy.concatenate([list(heat_box.temperatures(folder / "grains.dump").values()), field(folder / "0.012/T")])
                expected = self.common(folder, "0.012")
                print(f"{solver} {energy}: energy {off:.1e} of what was exchanged, table {max(table['energyImbalance']):.1e}; "
                      f"{T.min():.7f} to {T.max():.7f} K, expected {expected:.7f} K")
                self.assertLess(off, 1e-10)
                self.assertLess(max(table["energyImbalance"]), 1e-10)
                # what is left of the difference, and R of OpenFOAM, 1e-6 off, with the heat capacity of the gas
                self.assertLess(abs(T - expected).max(), 2e-6 * 100)
                self.assertTrue(320 < expected < 380, expected)

    def test_from_the_first_step(self):
        """The same while most of the heat goes over, from the end of the first step on, with grains that move and have drag: 1e-10."""
        for solver, energy, transonic in SOLVERS:
            with self.subTest(solver=solver, energy=energy):
                folder = self.run_hot(solver=solver, energy=energy, transonic=transonic, steps=10, write_every=1, dump_every=10,
                                      grains=box.swarm(2000, 7, mean=(0, 0, 2), rms=1))
                off, table = self.unbalanced(folder, ("0.0001", "0.001"), (1, 10), energy)
                print(f"{solver} {energy}: {off:.1e}, table {max(table['energyImbalance']):.1e}")
                self.assertLess(off, 1e-10)
                self.assertLess(max(table["energyImbalance"]), 1e-10)
                self.assertGreater(sum(map(abs, table["heatToGrains"][1:])), 0.1 * abs(table["heatToGrains"][0]))

    def test_explicit_momentum(self):
        """The entry momentum has no say in heat."""
        folder = self.run_hot(steps=10, write_every=1, dump_every=10, options={"momentum": "explicit"}, walls=True)
        off, table = self.unbalanced(folder, ("0.0001", "0.001"), (1, 10))
        print(f"{off:.1e}, table {max(table['energyImbalance']):.1e}")
        self.assertLess(off, 1e-10)
        self.assertLess(max(table["energyImbalance"]), 1e-10)

    def test_stiff(self):
        """Grains of 1000 times the heat capacity of the gas that follow it within 1/100 of a step. They take its temperature in the first
        step, in which it is that of the beginning; from the second one on both have their common one, to the conduction between
        cells with more and with fewer grains. With four sub-steps the same, but that the grains have nothing to exchange in
        the last ones, so that what the gas is owed stays in its cells: between the temperatures to 1 % of their difference."""
        for sub_steps in (1, 4):
            with self.subTest(sub_steps=sub_steps):
                self.stiff(sub_steps)

    def stiff(self, sub_steps):
        gas = SIZE * gas_box.RHO0 * gas_box.CV
        H = 2 * heat_box.conductivity(1.8e-5, PR) * numpy.pi * 2e-4
        specific_heat = 1000.0
        density = 1000 * gas / (2000 * specific_heat * heat_box.mass(density=1.0))
        grain = heat_box.mass(density=density)
        delta_t = 100 * grain * specific_heat / H
        folder = self.run_hot(steps=10, write_every=1, delta_t=delta_t, dem_step=delta_t / 10 / sub_steps, dump_every=10 * sub_steps,
                              cells="5 5 10", walls=True, specific_heat=specific_heat, density=density, options={"subSteps": sub_steps})
        names = sorted((path.parent.name for path in folder.glob("*/particleHeatOwed")), key=float)
        self.assertEqual(len(names), 10)
        expected = self.common(folder, names[-1], specific_heat, grain=grain)
        warm = [list(heat_box.temperatures(folder / "grains.dump", frame).values()) for frame in range(1, 11)]
        spans = [(min(g.min(), min(p)), max(g.max(), max(p))) for g, p in zip((field(folder / name / "T") for name in names), warm)]
        print(f"expected {expected:.4f} K; " + "; ".join(f"{a:.3f} to {b:.3f}" for a, b in spans))
        self.assertGreater(expected, 399.8)
        for low, high in spans:
            self.assertGreater(low, 300 - 1e-6)
            self.assertLess(high, 400 + (1e-6 if sub_steps == 1 else 0.01 * 100))
        for low, high in spans[1:]:
            self.assertLess(max(expected - low, high - expected), 0.01 * 100)
        self.assertLess(max(expected - spans[-1][0], spans[-1][1] - expected), 1e-6 * 100)
        table = box.read_balance(folder)
        self.assertLess(max(table["energyImbalance"]), 1e-10)

    def test_buoyant_solver(self):
        """buoyantPimpleFoam: what it gets is what grains give, in the table, and gas and grains come to one temperature where they are."""
        for energy in ("InternalEnergy", "Enthalpy"):
            with self.subTest(energy=energy):
                folder = self.new_folder()
                box.write(folder, walls=True, cells="2 2 4", steps=20, write_every=20)
                fluid_cases.buoyant_pimple(folder, "uniform 1e5", (0, 0, 0), energy=energy)
                x, v = box.swarm(200, 3, **AT_REST)
                box.script(folder, grains=box.grains(x, v), plugins="plugin load fluidheatplugin.so", fixes=heat_box.fixes(800.0, HOT),
                           end=scripts.dump(200, "grains.dump", heat_box.COLUMNS), boundary="f f f")
                box.fv_options(folder, **heat_box.forces(others="pressureGradient {}"))
                self.foam("blockMesh", folder)
                self.foam("buoyantPimpleFoam", folder)
                table, T = box.read_balance(folder), field(folder / "0.002/T")
                print(f"{energy}: {sum(table['heatToGrains']):.3e} J to grains, table {max(table['energyImbalance']):.1e}, gas to {T.max():.3f} K")
                self.assertLess(sum(table["heatToGrains"]), 0)
                self.assertLess(max(table["energyImbalance"]), 1e-10)
                self.assertGreater(T.min(), 300.01)

    def test_group(self):
        """Grains outside of the fix's group give no heat and keep their temperature, also where those beside them are stiff."""
        folder = self.run_hot(steps=10, write_every=1, dump_every=10, cells="5 5 10", before="group warm id 1:1000\n", group="warm")
        off, table = self.unbalanced(folder, ("0.0001", "0.001"), (1, 10))
        T = heat_box.temperatures(folder / "grains.dump")
        inside, outside = ([t for tag, t in T.items() if (tag <= 1000) == warm] for warm in (True, False))
        print(f"{off:.1e}, table {max(table['energyImbalance']):.1e}; {max(inside):.3f} K, outside {min(outside)} to {max(outside)} K")
        self.assertLess(off, 1e-10)
        self.assertLess(max(inside), 380)
        self.assertEqual((min(outside), max(outside)), (HOT, HOT))

    def crossing(self, steps=60, **case):
        """120 grains, one in a cell, of some 400 times the heat capacity of its gas, that lose 2/3 of their difference of
        temperature in a step and cross a cell in two steps. One half begins at 300 K, as the gas, the other one at 400 K. No drag."""
        rng = random.Random(1)
        x = [[rng.uniform(0, side) for side in (0.02, 0.02, 0.04)] for _ in range(120)]
        v = [[rng.uniform(-30, 30) for _ in "xyz"] for _ in x]
        cg = 186
        cold = "".join(f"set atom {i} property/atom Temp 300\n" for i in range(1, 121, 2))
        return self.run_warm(**{
            "steps": steps, "grains": (x, v), "cells": "4 4 8", "write_every": 2, "specific_heat": 800.0, "density": 1.2e7,
            "diameter": 2e-4 / cg, "prandtl": 2e-3, "options": {"drag": None, "forces": "{ heat { recovery no; } }"},
            "correctors": "nOuterCorrectors 3; nCorrectors 2;", "temperature": HOT,
            "plugins": f"plugin load hertzcgplugin.so\ncoarsegraining {cg} model_check warn",
            "more_fixes": f'if "${{continued}} == 0" then "jump SELF fresh"\njump SELF warm\nlabel fresh\n{cold}label warm\n', **case})

    def test_moving_debts(self):
        """Debts of heat move with the grains: gas and grains keep between the temperatures of the beginning."""
        folder = self.crossing()
        times = sorted((path.parent.name for path in folder.glob("*/particleHeatOwed")), key=float)
        spans = [(field(folder / time / "T").min(), field(folder / time / "T").max()) for time in times]
        print("; ".join(f"{a:.1f} to {b:.1f}" for a, b in spans[::3]))
        table = box.read_balance(folder)
        self.assertEqual(len(times), 30)
        self.assertLess(max(b for _, b in spans), 410)
        self.assertGreater(min(a for a, _ in spans), 290)
        self.assertLess(max(table["energyImbalance"]), 1e-10)

    def test_grain_between_cells(self):
        """A grain of 300 K that lies in cells of 300 K and of 600 K: none of its cells gets colder than it, but for waves of pressure."""
        def hot_half(folder):
            dictionaries.change(folder / "0/T", ("internalField uniform 300.0", "internalField " + dictionaries.nonuniform([300.0] * 64 + [600.0] * 64)))
        cg = 20
        folder = self.run_warm(steps=40, write_every=40, cells="4 4 8", walls=True, temperature=300.0, diameter=4e-3 / cg, density=8900.0,
                               grains=([[0.0075, 0.0075, 0.0203]], [[0, 0, 0]]), prepare=hot_half,
                               options={"drag": None, "forces": "{ heat { recovery no; } }"},
                               plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {cg} model_check warn")
        T = field(folder / "0.004/T")
        print(f"{T.min():.2f} to {T.max():.2f} K")
        self.assertGreater(T.min(), 297)

    def assertSame(self, a, b, time, tolerance, names=("T", "U", "particleHeatSource", "particleHeatOwed", "particleTemperature")):
        for name in names:
            one, two = ((values_of if name in DEBTS else field)(folder / time / name) for folder in (a, b))
            scale = abs(one).max()
            print(f"{name}: {abs(one - two).max() / scale:.1e}")
            self.assertGreater(scale, 0, name)
            self.assertLess(abs(one - two).max(), tolerance * scale, name)

    def test_ranks(self):
        """1, 2 and 4 ranks: the same but for the order of sums and the tolerance of the solvers."""
        case = {"steps": 12, "grains": box.swarm(500, 3, mean=(0, 0, 20), rms=8), "correctors": "nOuterCorrectors 3; nCorrectors 2;"}
        serial = self.run_hot(**case)
        for ranks, decomposition in ((2, "(1 1 2)"), (4, "(2 1 2)")):
            with self.subTest(ranks=ranks):
                parallel = self.run_hot(ranks=ranks, ranks_in_case=ranks, decomposition=decomposition, **case)
                self.assertSame(serial, parallel, "0.0012", 1e-8)
                one, two = (heat_box.temperatures(folder / "grains.dump") for folder in (serial, parallel))
                self.assertEqual(sorted(one), sorted(two))
                self.assertLess(max(abs(one[tag] - two[tag]) for tag in one), 1e-7)
                self.assertGreater(max(one.values()) - min(one.values()), 0.1)

    def test_restart(self):
        """A run of 12 steps, and one that is stopped and continued after 6, on 1 and 2 ranks: to the round-off of T, from which OpenFOAM
        works out e anew."""
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                case = {"grains": box.swarm(500, 3, mean=(0, 0, 20), rms=8), "write_every": 6, "dump_every": 60, "ranks": ranks}
                whole, parts = (self.run_hot(steps=steps, **case) for steps in (12, 6))
                box.end_at(parts, 12)
                self.foam("rhoPimpleFoam", parts, ranks)
                if ranks:
                    self.foam("reconstructPar", parts)
                table = box.read_balance(parts, "0.0006")
                self.assertLess(max(table["energyImbalance"]), 1e-10)
                self.assertSame(whole, parts, "0.0012", 1e-9)
                one, two = (heat_box.temperatures(folder / "grains.dump") for folder in (whole, parts))
                self.assertLess(max(abs(one[tag] - two[tag]) for tag in one), 1e-8)

    def test_restart_after_removal(self):
        """LIGGGHTS removes grains in the last interval before the restart: what they have given stays with the gas, in both runs."""
        case = {"write_every": 1, "boundary": "f f f", "before": "neigh_modify delay 0 every 1 check no\n", "dump_every": 10}
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                whole, parts = (self.crossing(steps=steps, ranks=ranks, **case) for steps in (6, 3))
                left = box.read_balance(whole)["leftBox"]
                self.assertGreater(left[2], left[1])
                box.end_at(parts, 6)
                self.foam("rhoPimpleFoam", parts, ranks)
                if ranks:
                    self.foam("reconstructPar", parts)
                self.assertLess(max(box.read_balance(parts, "0.0003")["energyImbalance"]), 1e-10)
                self.assertSame(whole, parts, "0.0006", 1e-9, ("T", "particleTemperature", "particleHeatOwed", "heatOfLostGrains"))

    def test_filter(self):
        """Spread grains: energy as ever, 1 and 2 ranks the same."""
        case = {"grains": box.swarm(500, 3, mean=(0, 0, 2), rms=1), "steps": 10, "write_every": 1, "dump_every": 10,
                "options": {"voidFraction": "{ model divided; filter { length 4e-3; } }"}}
        folder = self.run_hot(**case)
        off, table = self.unbalanced(folder, ("0.0001", "0.001"), (1, 10))
        print(f"{off:.1e}, table {max(table['energyImbalance']):.1e}")
        self.assertLess(off, 1e-10)
        self.assertLess(max(table["energyImbalance"]), 1e-10)
        self.assertSame(folder, self.run_hot(ranks=2, **case), "0.001", 1e-6)

    def test_full_equations(self):
        """Gas between the grains, with its volume: energy of the gas alone, with what it is owed, changes by what the grains got."""
        folder = self.run_hot(grains=box.swarm(5000, 3, mean=(0, 0, 0), rms=0), diameter=8e-4, steps=10, write_every=1, dump_every=10,
                              specific_heat=20.0, options={"voidFraction": box.void_fraction("full")})
        table = box.read_balance(folder)
        first, last = (of_gas(folder, time, share=field(folder / time / "voidFraction"))
                       + field_sum(folder / time / "energyOfShares") for time in ("0.0001", "0.001"))
        got = sum(table["energyToGrains"][1:])
        passed = sum(map(abs, table["energyToGrains"]))
        print(f"{abs(last - first + got) / passed:.1e} of what was exchanged, table {max(table['energyImbalance']):.1e}, "
              f"void fraction from {field(folder / '0.001/voidFraction').min():.2f}")
        self.assertLess(field(folder / "0.001/voidFraction").min(), 0.75)
        self.assertLess(abs(last - first + got), 1e-8 * passed)
        self.assertLess(max(table["energyImbalance"]), 1e-10)

    def test_grains_that_leave(self):
        """The heat of grains that LIGGGHTS has removed belongs to the balance: the gas of a closed box loses what all grains
        have got, with those that left, to 1e-10."""
        x, _ = box.swarm(400, 5, **AT_REST)
        rng = random.Random(2)
        v = [[0, 0, rng.choice((-1, 1)) * rng.uniform(5, 60)] for _ in x]
        case = {"grains": (x, v), "boundary": "f f f", "walls": True, "steps": 10, "write_every": 1, "dump_every": 10,
                "options": {"drag": None, "forces": "{ heat { recovery no; } }"}, "specific_heat": 20.0}
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                folder = self.run_hot(ranks=ranks, **case)
                table = box.read_balance(folder)
                first, last = (of_gas(folder, time) for time in ("0.0001", "0.001"))
                got = sum(table["heatToGrains"][1:])
                passed = sum(map(abs, table["heatToGrains"]))
                grain = heat_box.mass() * 20.0
                left = set(heat_box.temperatures(folder / "grains.dump", 1)) - set(heat_box.temperatures(folder / "grains.dump", 10))
                seen = sum(grain * (heat_box.temperatures(folder / "grains.dump", 10).get(tag, before) - before)
                           for tag, before in heat_box.temperatures(folder / "grains.dump", 1).items())
                print(f"{ranks} ranks: {len(left)} grains left; gas {last - first:.6e} J, grains {got:.6e} J, of those that stayed "
                      f"{seen:.6e} J; {abs(last - first + got) / passed:.1e}, table {max(table['energyImbalance']):.1e}")
                self.assertGreater(len(left), 50)
                self.assertLess(abs(last - first + got), 1e-10 * passed)
                self.assertLess(max(table["energyImbalance"]), 1e-10)
                self.assertGreater(abs(seen - got), 0.01 * abs(got))


def values_of(path):
    """A field of the cells without boundary."""
    text = path.read_text()
    body = text[text.index("value"):]
    if "nonuniform" not in body[:40]:
        return numpy.zeros(1)
    return numpy.array([float(line) for line in body.split("(", 1)[1].split(")")[0].split()])


if __name__ == "__main__":
    unittest.main()
