# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of the fluid at grains, for flows in which they are known. A model of the tests makes a force of
the quantity; interpolation is that of the cell, so that nothing but the quantity itself is seen."""
# processors: 2

import itertools
import math
import unittest

import bad_case
from grainjet import coupled_box as box, dictionaries, dumps
from grainjet.coupled_box import end_at
import user_library

DIAMETER, NU, RHO = 2e-4, 1.5e-5, 1.2
UNIT = 1e-15                            # N per unit of the quantity, as the model has it
CELL = 0.002                            # m, of 10 x 10 x 20 cells
DUMP = ("dump d all custom 10 grains.*.dump id x y z f_fluidExplicitForce[1] f_fluidExplicitForce[2] "
        'f_fluidExplicitForce[3]\ndump_modify d sort id format "%d' + 6 * " %.17g" + '"')

# in the middle of cells, so that their place is known while they hardly move
PLACES = [tuple((i + 0.5) * CELL for i in place)
          for place in ((0, 0, 0), (3, 7, 12), (9, 4, 19), (5, 5, 10), (1, 8, 3))]


class Quantities(bad_case.BadCase):

    def prepare(self, quantity, vector=False, steps=1, walls=False, more="", ranks=2):
        folder = self.new_folder()
        box.write(folder, steps=steps, walls=walls, ranks=ranks, rho=f"rho [1 -3 0 0 0 0 0] {RHO};", nu=NU,
                  libs=user_library.libs("probeModels"))
        box.script(folder, grains=box.grains(PLACES, [(0, 0, 0)] * len(PLACES), DIAMETER), end=DUMP,
                   boundary="f f f" if walls else "p p p")
        box.fv_options(folder, coupling="oneWay", drag=None, interpolation="cell",
                       forces=f"{{ probe {{ shown {quantity}; vector {'yes' if vector else 'no'}; }} }}")
        if more:
            with open(folder / "constant/fvOptions", "a") as file:
                file.write(more)
        return folder

    def run_case(self, folder, ranks=0):
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.foam("pimpleFoam", folder, ranks)

    def shown(self, folder, step):
        """{id: (place, value)} of the interval that ends at this DEM step."""
        rows = dumps.last(folder / f"grains.{step}.dump")
        self.assertEqual(len(rows), len(PLACES))
        return {tag: (row[:3], [f / UNIT for f in row[3:]]) for tag, row in rows.items()}

    def assertShown(self, folder, step, expected, relative=1e-12):
        """expected(place) gives the three components, or a scalar."""
        for tag, (_, found) in self.shown(folder, step).items():
            value = expected(PLACES[tag - 1])
            value = value if isinstance(value, tuple) else (value, 0.0, 0.0)
            scale = max(map(abs, value)) or 1.0
            for f, e in zip(found, value):
                self.assertAlmostEqual(f, e, delta=relative * scale, msg=f"grain {tag}: {found}, not {value}")

    def test_properties(self):
        for quantity, value in (("rho", RHO), ("nu", NU)):
            with self.subTest(quantity=quantity):
                folder = self.prepare(quantity)
                self.run_case(folder)
                self.assertShown(folder, 10, lambda _: value)

    def test_void_fraction(self):
        """Each grain lies in a cell of its own, as a whole."""
        folder = self.prepare("voidFraction")
        self.run_case(folder)
        self.assertShown(folder, 10, lambda _: 1 - math.pi / 6 * DIAMETER ** 3 / CELL ** 3)

    def test_wall_distance(self):
        """Between six walls."""
        folder = self.prepare("wallDistance", walls=True)
        dictionaries.change(folder / "system/fvSchemes", ("ddtSchemes", "wallDist { method meshWave; } ddtSchemes"))
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                self.run_case(folder, ranks)
                self.assertShown(folder, 10, lambda p: min(min(x, size - x) for x, size in zip(p, (0.02, 0.02, 0.04))), 1e-9)

    def test_turbulence(self):
        """k and epsilon of the first interval are those of the start time."""
        for quantity, value in (("k", 0.1), ("epsilon", 1)):
            with self.subTest(quantity=quantity):
                folder = self.prepare(quantity, walls=True)
                self.turbulent(folder, "kEpsilon", "k", "epsilon")
                self.run_case(folder)
                self.assertShown(folder, 10, lambda _: value)

    def test_acceleration_in_time(self):
        """A uniform flow under a uniform source of 100 m/s2: zero in the first interval, which knows no flow
        before, then the source, also right after the run has been continued."""
        source = """
push { type vectorSemiImplicitSource; vectorSemiImplicitSourceCoeffs { selectionMode all; volumeMode specific;
       injectionRateSuSp { U ((0 0 100) 0); } } }
"""
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                folder = self.prepare("DUDt", vector=True, steps=2, more=source)
                self.run_case(folder, ranks)
                self.assertShown(folder, 10, lambda _: (0.0, 0.0, 0.0))
                self.assertShown(folder, 20, lambda _: (0.0, 0.0, 100.0), 1e-9)
                end_at(folder, 3)
                self.foam("pimpleFoam", folder, ranks)
                self.assertShown(folder, 30, lambda _: (0.0, 0.0, 100.0), 1e-9)

    def test_acceleration_along_the_path(self):
        """Vortices, U = (sin kx cos ky, - cos kx sin ky, 0): U & grad(U) = (K sin kx cos kx, K sin ky cos ky, 0).
        "Gauss linear" takes the difference over two cells for a derivative: K = sin(k dx)/dx for k."""
        folder = self.prepare("DUDt", vector=True)
        k = 2 * math.pi / 0.02
        middle = [(i + 0.5) * CELL for i in range(10)]
        values = "".join(f"({math.sin(k * x) * math.cos(k * y)!r} {-math.cos(k * x) * math.sin(k * y)!r} 0)\n"
                         for _, y, x in itertools.product(range(20), middle, middle))
        dictionaries.change(folder / "0/U", ("uniform (0 0 0)", f"nonuniform List<vector> 2000 ({values})"))
        self.run_case(folder)
        K = math.sin(k * CELL) / CELL
        self.assertShown(folder, 10, lambda p: (K * math.sin(k * p[0]) * math.cos(k * p[0]),
                                                K * math.sin(k * p[1]) * math.cos(k * p[1]), 0.0), 1e-9)


if __name__ == "__main__":
    unittest.main()
