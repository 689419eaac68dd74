# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The full void-fraction equations: momentum of fluid and grains together, a uniform motion, a plug of grains that moves
through fluid at rest, stiff drag, restart, ranks, and what is refused. For fixed beds see case_fixed_bed.py."""
# processors: 4
# label: long

import math
import random
import unittest

import numpy

from crowded_box import CELL_VOLUME, CONVERGED, crowd, of_fluid, values
from fluid_cases import AIR, WATER, inter_foam, layers
from grainjet import coupled_box as box, dictionaries

FULL = box.void_fraction("full")


class FullEquations(box.CoupledCase):

    def test_momentum(self):
        """In a periodic box without gravity what the grains gain, from their velocities, is what the fluid between
        them loses, void fractions down to the minimum of 0.3. To the tolerance of the solvers."""
        for rho, forces in ((1.2, "(pressureGradient viscous)"), (1000.0, "(pressureGradient)")):
            with self.subTest(rho=rho, forces=forces):
                x, v = crowd()
                folder = self.run_box(
                    steps=12, write_every=4, grains=(x, v), diameter=1e-3, nu=1e-5, correctors=CONVERGED,
                    rho=f"rho [1 -3 0 0 0 0 0] {rho};", options={"forces": forces, "voidFraction": FULL})
                times = sorted(folder.glob("*/solidsFlux"), key=lambda path: float(path.parent.name))
                first, last = (of_fluid(path.parent, rho) for path in (times[0], times[-1]))
                table = box.read_balance(folder)
                steps = slice(4, 12)
                gained = numpy.array([sum(table[f"toGrains_{c}"][steps]) for c in "xyz"])
                passed = sum(abs(p) for p in table["toGrains_z"][steps])
                print(f"rho {rho}: {abs(last - first + gained).max() / passed:.1e} of what was exchanged")
                self.assertLess(abs(last - first + gained).max(), 1e-9 * passed)
                self.assertGreater(abs(last - first).max(), 0.1 * passed)
                # The fluid keeps its volume, but for what the least void fraction cuts
                volume = numpy.array(table["fluidVolume"]) - table["volumeCut"]
                self.assertLess(abs(volume / (2000 * CELL_VOLUME - 5000 * math.pi / 6 * 1e-9) - 1).max(), 1e-12)
                self.assertLess(min(dictionaries.internal(times[-1].parent / "voidFraction")), 0.31)

    def test_momentum_of_water_and_air(self):
        """The same in interFoam: full of water, and with grains that cross a surface between water and air."""
        for name, alpha in (("water", "1"), ("surface", layers([1.0] * 5 + [0.5] + [0.0] * 9 + [0.3] + [1.0] * 4, 100))):
            with self.subTest(name):
                folder = self.new_folder()
                box.write(folder, steps=12, write_every=4, delta_t=2e-5, correctors="nOuterCorrectors 40; nCorrectors 3;",
                          ranks=1, decomposition="(1 1 1)")
                inter_foam(folder, alpha, walls=False, sigma=0, water_nu=1e-5)
                x, v = crowd(3000)
                box.script(folder, grains=box.grains(x, v, 1e-3), dt=2e-6)
                box.fv_options(folder, forces="(pressureGradient viscous)", voidFraction=FULL)
                self.foam("blockMesh", folder)
                self.foam("interFoam", folder)
                times = sorted(folder.glob("*/solidsFlux"), key=lambda path: float(path.parent.name))
                first, last = (self.of_mixture(path.parent) for path in (times[0], times[-1]))
                table = box.read_balance(folder)
                gained = numpy.array([sum(table[f"toGrains_{c}"][4:12]) for c in "xyz"])
                passed = sum(abs(p) for p in table["toGrains_z"][4:12])
                print(f"{name}: {abs(last - first + gained).max() / passed:.1e} of what was exchanged")
                self.assertLess(abs(last - first + gained).max(), 1e-7 * passed)
                self.assertLess(max(table["imbalance"]), 1e-9)

    def test_momentum_with_eddies(self):
        """The same with kEpsilon, which changes the viscosity behind the momentum equation of each step."""
        folder = self.new_folder()
        box.write(folder, steps=12, write_every=4, correctors=CONVERGED, ranks=1, decomposition="(1 1 1)")
        dictionaries.write(folder / "constant/turbulenceProperties",
                           "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }")
        for name, value, dimensions in (("k", 0.5, "0 2 -2"), ("epsilon", 50, "0 2 -3"), ("nut", 0, "0 2 -1")):
            dictionaries.write_field(folder, name, dimensions, value, {".*": "type cyclic;"})
        dictionaries.change(folder / "system/fvSolution", ('"U.*"', '"(U|k|epsilon).*"'))
        x, v = crowd(3000)
        box.script(folder, grains=box.grains(x, v, 1e-3))
        box.fv_options(folder, forces="(pressureGradient viscous)", voidFraction=FULL)
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        first, last = (of_fluid(folder / time, 1.2) for time in ("0.0004", "0.0012"))
        table = box.read_balance(folder)
        gained = numpy.array([sum(table[f"toGrains_{c}"][4:12]) for c in "xyz"])
        passed = sum(abs(p) for p in table["toGrains_z"][4:12])
        print(f"kEpsilon: {abs(last - first + gained).max() / passed:.1e} of what was exchanged")
        self.assertLess(abs(last - first + gained).max(), 1e-9 * passed)

    @staticmethod
    def of_mixture(folder):
        """Momentum of water and air between the grains with what they are owed [N s]."""
        alpha = numpy.array(dictionaries.internal(folder / "alpha.water"))
        rho = AIR + alpha[:, None] * (WATER - AIR)
        flux = values(folder / "U") - values(folder / "solidsFlux")
        debts = (values(folder / name).sum(0) for name in ("particleMomentumOwed", "momentumOfShares"))
        return 0.002 ** 3 * (rho * flux).sum(0) + sum(debts)

    def test_ranks(self):
        """1, 2 and 4 ranks: the same but for the order of sums and the tolerance of the solvers. Half of the box is
        empty, so that ranks without grains are among them."""
        x, v = crowd(1500, height=0.019)
        runs = [self.run_box(ranks, steps=6, grains=(x, v), diameter=1e-3, ranks_in_case=max(ranks, 1),
                             decomposition=f"(1 1 {max(ranks, 1)})", options={"voidFraction": FULL})
                for ranks in (0, 2, 4)]
        for run in runs[1:]:
            self.compare(runs[0], run, "0.0006", 1e-9)

    def test_without_grains(self):
        """Without a grain the fields are bit for bit those of the solver alone."""
        fluid = {"steps": 3, "velocity": "(0.1 0.2 0.3)", "walls": True}
        alone = self.run_box(options=False, **fluid)
        coupled = self.run_box(grains=([], []), boundary="f f f", options={"voidFraction": FULL}, **fluid)
        for field in ("U", "p", "phi"):
            a, b = ((f / "0.0003" / field).read_bytes() for f in (alone, coupled))
            self.assertEqual(a, b, field)

    def test_uniform_motion(self):
        """Fluid and grains that move alike keep moving alike, whatever the void fraction, and the pressure stays zero:
        no force acts. What is left is what the fluid pays back for the kicks that were left out: some 1/29 of a grain's
        volume (1e-3 of a cell's) has crossed a face too many or too few at any time, a hundredth of it per passage."""
        x, _ = crowd(3000, height=0.04)
        folder = self.run_box(steps=20, grains=(x, [(0, 0, 0.5)] * len(x)), diameter=1e-3, rho="rho [1 -3 0 0 0 0 0] 1000;",
                              velocity="(0 0 0.5)", nu=1e-6, options={"voidFraction": FULL})
        speeds = values(folder / "0.002/fluidVelocity") - [0, 0, 0.5]
        pressure = numpy.array(dictionaries.internal(folder / "0.002/p"))
        print(f"velocity off by {abs(speeds).max() / 0.5:.1e} U, pressure {abs(pressure).max() / 0.25:.1e} rho U^2")
        self.assertLess(abs(speeds).max(), 2e-3 * 0.5)
        self.assertLess(abs(pressure).max(), 2e-3 * 0.25)
        self.assertGreater(abs(values(folder / "0.002/solidsFlux")).max(), 0.1)

    def test_stiff_drag(self):
        """A dense crowd of grains at rest and at 1 m/s in water, which stop each other: drag coefficient times step
        over density up to 600, void fractions down to 0.3. Velocities die out or stay, none grows. More is
        not tried, since at nu dt/dx^2 of some 25 the stock solver alone is not stable."""
        rng = random.Random(1)
        x = [[rng.uniform(0, a) for a in (0.02, 0.02, 0.04)] for _ in range(4000)]
        v = [[0, 0, rng.choice((0, 1))] for _ in x]
        for formulation in ("SetI", "SetII"):
            for nu in (1e-4, 1e-2, 1e-1):
                with self.subTest(formulation=formulation, nu=nu):
                    folder = self.run_box(
                        steps=60, write_every=20, grains=(x, v), diameter=1.2e-3, density=8000.0, rho="rho [1 -3 0 0 0 0 0] 1000;", nu=nu,
                        options={"voidFraction": FULL, "drag": "Ergun", "formulation": formulation})
                    kappa = max(dictionaries.internal(folder / "0.002/dragCoefficient")) * 1e-4 / 1000
                    early, late = (abs(values(folder / time / "fluidVelocity")).max() for time in ("0.002", "0.006"))
                    print(f"{formulation}, drag coefficient x step / density {kappa:.1e}: {early:.3g}, {late:.3g} m/s")
                    self.assertGreater(kappa, 0.1 if nu < 1e-3 else 10)
                    self.assertLess(late, 1.2)
                    self.assertLess(late, 1.2 * early)

    def test_refused(self):
        """Before time is spent, with file, entry and remedy."""
        for options, words in (
                ({"voidFraction": box.void_fraction("fulll")}, ("equations", "fulll", "neglected")),
                ({"voidFraction": FULL, "coupling": "oneWay"}, ("equations full and coupling oneWay", "neglected")),
                ({"voidFraction": FULL, "forces": "(viscous)"}, ("equations full", "pressureGradient")),
                ({"voidFraction": FULL, "momentum": "explicit"}, ("equations full", "momentum implicit"))):
            with self.subTest(options=options):
                folder = self.new_folder()
                box.write(folder)
                box.script(folder, grains=box.grains(*box.swarm(3, 1)))
                box.fv_options(folder, **options)
                self.foam("blockMesh", folder)
                result = self.foam("pimpleFoam", folder, check=False)
                self.assertFails(result, "fvOptions", *words)
                self.assertNotRegex(result.output, box.SOLVED)

    def test_bounded_refused(self):
        """A bounded convection scheme would not keep momentum."""
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                folder = self.new_folder()
                box.write(folder, convection="upwind")
                box.script(folder, grains=box.grains(*box.swarm(3, 1)))
                box.fv_options(folder, voidFraction=FULL)
                schemes = folder / "system/fvSchemes"
                schemes.write_text(schemes.read_text().replace("Gauss upwind", "bounded Gauss upwind"))
                self.foam("blockMesh", folder)
                if ranks:
                    self.foam("decomposePar", folder)
                result = self.foam("pimpleFoam", folder, check=False, ranks=ranks)
                self.assertFails(result, "fvSchemes", "div(phi,U) is bounded", "without the word bounded")
                self.assertNotRegex(result.output, box.SOLVED)


if __name__ == "__main__":
    unittest.main()
