# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag that stops fluid and grains against each other within a thousandth to a millionth of the fluid step: velocities stay
within those of the start, and momentum is kept."""
# processors: 1
# label: long

import random
import unittest

import numpy

from crowded_box import CELL_VOLUME, CONVERGED, of_fluid, values
from grainjet import coupled_box as box, dictionaries

STEP = 1e-4
GRAIN = 1.2e-3
WATER, AIR = 1000.0, 1.2
SIZE = (12, 12, 24)
NUMBER = 200                        # grains of the small box
# Drag coefficient x step/density: kinematic viscosity, coarse graining factor. A grain stands for cg^3 particles, so that drag
# is stiff with few grains while nu dt/dx^2 is 0.25 at most, which the stock solver bears
STIFF = {1e3: (1e-3, 18), 1e4: (1e-3, 55), 1e6: (1e-2, 200)}


class StiffDrag(box.CoupledCase):

    def crowd(self, kappa, equations, formulation="SetI", **fluid):
        """Water at rest with overlapping grains, half of them at rest and half at 1 m/s, void fractions down to 0.3. Folders of
        the times written."""
        rng = random.Random(1)
        nu, cg = STIFF[kappa]
        sides = [side / 1000 for side in SIZE]
        x = [[rng.uniform(0, side) for side in sides] for _ in range(864)]
        v = [[0, 0, rng.choice((0, 1))] for _ in x]
        folder = self.new_folder()
        box.write(folder, rho=f"rho [1 -3 0 0 0 0 0] {WATER};", nu=nu, size=SIZE, cells="6 6 12", **fluid)
        box.script(folder, grains=box.grains(x, v, GRAIN / cg, 8000.0), box=" ".join(f"0 {side}" for side in sides),
                   plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {cg} model_check warn")
        box.fv_options(folder, voidFraction=box.void_fraction(equations), drag="Ergun", formulation=formulation,
                       forces="(pressureGradient)")
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        self.table = box.read_balance(folder)
        times = sorted((path.parent for path in folder.glob("*/dragCoefficient")), key=lambda path: float(path.name))
        found = max(dictionaries.internal(times[-1] / "dragCoefficient")) * STEP / WATER
        self.assertGreater(found, kappa)
        self.assertLess(min(dictionaries.internal(times[-1] / "voidFraction")), 0.45)
        self.words = f"{equations}, {formulation}, drag coefficient x step / density {found:.1e}"
        return times

    def test_bounded(self):
        """Nothing moves faster than the fastest grain of the start (1 m/s), and nothing grows from the 20th to the 40th step."""
        for equations, formulation, kappas in (
                ("full", "SetI", STIFF), ("full", "SetII", (1e6,)), ("neglected", "SetI", (1e3, 1e6))):
            for kappa in kappas:
                with self.subTest(equations=equations, formulation=formulation, kappa=kappa):
                    times = self.crowd(kappa, equations, formulation, steps=40, write_every=20)
                    fluid = "fluidVelocity" if equations == "full" else "U"
                    most = [[abs(values(time / name)).max() for time in times] for name in (fluid, "particleVelocity")]
                    print(f"{self.words}: fluid {', '.join(f'{u:.3g}' for u in most[0])} m/s, "
                          f"grains {', '.join(f'{u:.3g}' for u in most[1])} m/s")
                    for speeds in most:
                        self.assertLess(max(speeds), 1.0)
                        self.assertLess(speeds[-1], 1.1 * speeds[0])
                        self.assertGreater(speeds[-1], 0.01)

    def small(self, equations, rho, cg, speed=0, velocity="(0 0 0)", held=False):
        """A few grains in a box of 64 cells, Stokes' drag. Folder."""
        rng = random.Random(1)
        x = [[rng.uniform(0, 0.008) for _ in range(3)] for _ in range(NUMBER)]
        folder = self.new_folder()
        box.write(folder, rho=f"rho [1 -3 0 0 0 0 0] {rho};", nu=1e-3, size=(8, 8, 8), cells="4 4 4", steps=60, write_every=20,
                  velocity=velocity)
        box.script(folder, grains=box.grains(x, [(0, 0, speed)] * NUMBER, 1e-3 / cg, 2500.0), box="0 0.008 0 0.008 0 0.008",
                   plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {cg} model_check warn")
        if held:
            dictionaries.change(folder / "constant/in.particles", ("fix move all nve/sphere", ""))
        box.fv_options(folder, voidFraction=box.void_fraction(equations), drag="Stokes", forces="(pressureGradient)")
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        tau = 2500.0 * (1e-3 / cg) ** 2 / (18 * rho * 1e-3)
        self.words = f"{equations}, {rho:g} kg/m3, step over response time {STEP / tau:.2g}"
        return folder

    def test_common_velocity(self):
        """Grains of 1 m/s spread over fluid whose volumetric flux is zero: both soon have their common velocity,
        also where grains follow the fluid within a step. With the full equations the fluid starts with - a/(1 - a) m/s, a the solid
        fraction. Within 2 % of 1 m/s, as the void fraction is cut at 0.3 in some cells. With the debt paid by 1/(1 + kappa) in a
        step the grains in air have 0.76 m/s or swing between 0 and 1 after 20 steps, and all diverges with full equations."""
        solid, volume = NUMBER * numpy.pi / 6 * 1e-9, 0.008 ** 3
        for equations, runs in (("full", ((AIR, 20), (AIR, 40), (AIR, 100), (WATER, 20))), ("neglected", ((AIR, 100),))):
            for rho, cg in runs:
                with self.subTest(equations=equations, rho=rho, cg=cg):
                    folder = self.small(equations, rho, cg, speed=1)
                    change = numpy.cumsum(box.read_balance(folder)["toGrains_z"]) / (solid * 2500.0)
                    fluid = rho * (volume - solid if equations == "full" else volume)
                    start = -rho * solid if equations == "full" else 0
                    common = (2500.0 * solid + start) / (2500.0 * solid + fluid)
                    print(f"{self.words}: {1 + change[19]:.4f}, {1 + change[-1]:.4f} m/s, common {common:.4f} m/s")
                    for step in (19, 59):
                        self.assertLess(abs(1 + change[step] - common), 0.02)

    def test_held(self):
        """Fluid of 1 m/s among grains that are held comes to rest, though each grain takes more momentum in a step than it
        could if it were free. With the slope of a free grain it swings ever wider and diverges within 20 steps."""
        for equations, rho, cg in (("full", AIR, 100), ("neglected", AIR, 100), ("full", WATER, 5), ("full", WATER, 100)):
            with self.subTest(equations=equations, rho=rho, cg=cg):
                folder = self.small(equations, rho, cg, velocity="(0 0 1)", held=True)
                most = [abs(values(folder / time / "U")).max() for time in ("0.002", "0.006")]
                print(f"held, {self.words}: {most[0]:.3g}, {most[1]:.3g} m/s")
                self.assertLess(most[0], 1)
                self.assertLess(most[1], 0.3)

    def test_momentum(self):
        """What the grains gain in the periodic box is what the fluid between them loses, to the tolerance of the solvers."""
        for equations in ("full", "neglected"):
            with self.subTest(equations=equations):
                times = self.crowd(1e6, equations, steps=12, write_every=4, correctors=CONVERGED)
                if equations == "full":
                    first, last = (of_fluid(time, WATER) for time in (times[0], times[-1]))
                else:
                    first, last = (WATER * CELL_VOLUME * values(time / "U").sum(0) + values(time / "particleMomentumOwed").sum(0)
                                   for time in (times[0], times[-1]))
                gained = numpy.array([sum(self.table[f"toGrains_{c}"][4:12]) for c in "xyz"])
                passed = sum(abs(p) for p in self.table["toGrains_z"][4:12])
                print(f"{self.words}: {abs(last - first + gained).max() / passed:.1e} of what was exchanged")
                self.assertLess(abs(last - first + gained).max(), 1e-9 * passed)


if __name__ == "__main__":
    unittest.main()
