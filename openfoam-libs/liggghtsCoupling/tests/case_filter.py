# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter of the void fraction: what it keeps, how far it spreads, walls, ranks, restart, and bad input. For the
pressure drop of a bed on meshes with cells below and above the grains see case_filter_bed.py."""
# processors: 4
# label: long

import math
import random
import unittest

import numpy

import crowded_box
from grainjet import coupled_box as box, dictionaries

LENGTH = 6e-3                       # three cells of the box of 10 x 10 x 20 cells
DIAMETER, DENSITY = 1e-3, 2500.0
VOLUME = math.pi / 6 * DIAMETER ** 3
ROUND_OFF = 1e-14
STEPS = 4.0


def void_fraction(length, equations="full", model="divided"):
    return f"{{ model {model}; minimum 0.3; equations {equations}; filter {{ length {length!r}; }} }}"


def crowd(n=1500, seed=3, size=(0.02, 0.02, 0.04)):
    rng = random.Random(seed)
    x = [[rng.uniform(1e-3, a - 1e-3) for a in size] for _ in range(n)]
    v = [[rng.gauss(mean, 0.2) for mean in (0.1, 0.2, 0.5)] for _ in range(n)]
    return x, v


def read(folder, time, name):
    return numpy.array(dictionaries.internal(folder / time / name))


def kernel_of_plane(x):
    """What a plane becomes after four implicit steps without cells, for the bandwidth 1: by its Fourier transform."""
    k = (numpy.arange(20000) + 0.5) * 0.01
    transform = (1 + k ** 2 / (4 * STEPS)) ** -STEPS
    return numpy.array([numpy.sum(transform * numpy.cos(k * s)) for s in x]) * 0.01 / math.pi


class Filter(box.CoupledCase):

    def after_a_step(self, length, ranks=0, grains=None, solver="", **options):
        """One step of the box: its fields are of the places where the grains began."""
        fluid = {key: options.pop(key) for key in ("walls", "cells", "size", "box_of_grains", "boundary", "diameter")
                 if key in options}
        folder = self.new_folder()
        box.write(folder, steps=1, ranks=max(ranks, 1), decomposition=f"(1 1 {max(ranks, 1)})",
                  **{key: value for key, value in fluid.items() if key in ("walls", "cells", "size")})
        if solver:
            dictionaries.change(folder / "system/fvSolution", ("solvers\n{", "solvers\n{\n    grainFilter " + solver))
        x, v = grains or crowd()
        box.script(folder, grains=box.grains(x, v, fluid.get("diameter", DIAMETER), DENSITY),
                   boundary=fluid.get("boundary", "p p p"), box=fluid.get("box_of_grains", "0 0.02 0 0.02 0 0.04"))
        values = {"voidFraction": void_fraction(length), "forces": "(pressureGradient)", **options}
        box.fv_options(folder, **values)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.output = self.foam("pimpleFoam", folder, ranks).output
        if ranks:
            self.foam("reconstructPar", folder)
        return folder

    def test_conservation(self):
        """Volume and flux of the grains, and the momentum that the fluid receives, are kept to round-off:
        serial and on 4 ranks, with periodic sides and walls, and with a linear solver that stops early."""
        loose = "{ solver PCG; preconditioner DIC; tolerance 0; relTol 0.05; }"
        x, v = crowd()
        cell = 0.002 ** 3
        volume, flux = VOLUME * len(x), VOLUME * numpy.sum(v, 0)
        fields = []
        for case in ({}, {"ranks": 4}, {"walls": True, "boundary": "f f f"}, {"solver": loose}):
            with self.subTest(case=case):
                folder = self.after_a_step(LENGTH, grains=(x, v), **case)
                solid = 1 - read(folder, "0.0001", "voidFraction")
                q = read(folder, "0.0001", "solidsFlux")
                source = read(folder, "0.0001", "particleMomentumSource")
                given = [box.read_balance(folder)[f"toGrains_{c}"][0] for c in "xyz"]
                self.assertLess(solid.max(), 0.69)
                errors = [abs(solid.sum() * cell / volume - 1), abs(q.sum(0) * cell / flux - 1).max()]
                momentum = abs(source.sum(0) * cell * 1e-4 / given + 1).max()
                print(f"{case}: volume, flux {errors}, momentum of the fluid {momentum:.1e}")
                for error in (*errors, momentum):
                    self.assertLess(error, ROUND_OFF)
                fields.append(solid)
        unequal = [abs(f - fields[0]).max() / fields[0].max() for f in fields]
        print(f"differences to the first {unequal}")
        self.assertLess(unequal[1], 1e-11)
        self.assertGreater(unequal[3], 1e-6)

    def point(self, length, n=21):
        """Solid volumes around a grain that lies as a whole in the middle cell of n^3, and the cells' places."""
        size = 2e-3 * n
        limits = f"0 {size} 0 {size} 0 {size}"
        folder = self.after_a_step(
            length, grains=([[size / 2] * 3], [(0, 0, 1)]), cells=f"{n} {n} {n}", size=[1e3 * size] * 3,
            box_of_grains=limits, voidFraction=void_fraction(length, model="centre"))
        solid = (1 - read(folder, "0.0001", "voidFraction")).reshape(n, n, n) * 8e-9 / VOLUME
        return solid, (numpy.arange(n) - n // 2) * 2e-3

    def test_second_moment(self):
        """A point becomes a cloud of the second moment 3 b^2/2, that of the Gaussian of bandwidth b, and in each direction
        that of four implicit steps on these cells, which Fourier's series gives exactly."""
        for length in (3e-3, 4e-3):
            with self.subTest(length=length):
                solid, x = self.point(length)
                moment = sum(numpy.tensordot(solid, x ** 2, (axis, 0)).sum() for axis in range(3))
                waves = 2 * math.pi * numpy.arange(len(x)) / len(x)
                decay = (1 + (length / 2e-3) ** 2 / (4 * STEPS) * (2 - 2 * numpy.cos(waves))) ** -STEPS
                exact = numpy.array([numpy.mean(decay * numpy.cos(waves * s / 2e-3)) for s in x])
                planes = [solid.sum(tuple({0, 1, 2} - {axis})) for axis in range(3)]
                off = max(abs(plane - exact).max() for plane in planes)
                print(f"b {length}: second moment/(3 b^2/2) - 1 = {moment / (1.5 * length ** 2) - 1:.1e}, planes off by {off:.1e}")
                # What lies beyond the box's half, 5 b and more, comes in from the other side
                self.assertLess(abs(moment / (1.5 * length ** 2) - 1), 1e-4)
                # To the tolerance of the linear solver
                self.assertLess(off, 1e-10)
                self.assertGreaterEqual(solid.min(), 0)

    def test_number_of_steps(self):
        """Of a plane's amount four steps put 4.1 % elsewhere than the Gaussian does, as grainFilter.H says."""
        x = (numpy.arange(600) + 0.5) * 0.01
        off = abs(kernel_of_plane(x) - numpy.exp(-x ** 2) / math.sqrt(math.pi)).sum() * 0.01
        self.assertAlmostEqual(off, 0.041, delta=0.001)

    def test_walls_reflect(self):
        """A grain near a corner of walls: as with its seven images in a periodic box of twice the size."""
        x, n = [0.003, 0.005, 0.007], 10
        walls = self.after_a_step(LENGTH, grains=([x], [(0, 0, 1)]), walls=True, boundary="f f f", cells=f"{n} {n} {n}",
                                  size=(20, 20, 20), box_of_grains="0 0.02 0 0.02 0 0.02")
        images = [[(a, 0.04 - a)[i >> k & 1] for k, a in enumerate(x)] for i in range(8)]
        double = self.after_a_step(LENGTH, grains=(images, [(0, 0, 1)] * 8), cells=f"{2 * n} {2 * n} {2 * n}",
                                   size=(40, 40, 40), box_of_grains="0 0.04 0 0.04 0 0.04")
        a = 1 - read(walls, "0.0001", "voidFraction").reshape(n, n, n)
        b = 1 - read(double, "0.0001", "voidFraction").reshape(2 * n, 2 * n, 2 * n)[:n, :n, :n]
        print(f"largest difference {abs(a - b).max() / a.max():.1e}, total {a.sum() * 8e-9 / VOLUME - 1:.1e}")
        # The void fraction's last digit is 1e-16, the solid fraction 1e-3
        self.assertLess(abs(a - b).max(), 1e-11 * a.max())
        self.assertLess(abs(a.sum() * 8e-9 / VOLUME - 1), 1e-11)

    def test_ranks(self):
        """1, 2 and 4 ranks agree to the solvers' tolerance; half of the box is empty, so that there are ranks without
        grains, which the filter may give some."""
        x, v = crowd(size=(0.02, 0.02, 0.019))
        for equations in ("full", "neglected"):
            with self.subTest(equations=equations):
                runs = [self.run_box(ranks, steps=6, grains=(x, v), diameter=DIAMETER, ranks_in_case=max(ranks, 1),
                                     decomposition=f"(1 1 {max(ranks, 1)})",
                                     options={"voidFraction": void_fraction(LENGTH, equations)})
                        for ranks in (0, 2, 4)]
                for run in runs[1:]:
                    self.compare(runs[0], run, "0.0006", 1e-9)

    def test_momentum(self):
        """What the grains gain in a periodic box is what the fluid between them loses, as without a filter
        (case_full_equations): to the tolerance of the solvers."""
        folder = self.run_box(
            steps=12, write_every=4, grains=crowded_box.crowd(), diameter=DIAMETER, nu=1e-5, correctors=crowded_box.CONVERGED,
            options={"voidFraction": void_fraction(LENGTH)})
        times = sorted(folder.glob("*/solidsFlux"), key=lambda path: float(path.parent.name))
        first, last = (crowded_box.of_fluid(path.parent, 1.2) for path in (times[0], times[-1]))
        table = box.read_balance(folder)
        gained = numpy.array([sum(table[f"toGrains_{c}"][4:12]) for c in "xyz"])
        passed = sum(abs(p) for p in table["toGrains_z"][4:12])
        print(f"{abs(last - first + gained).max() / passed:.1e} of what was exchanged")
        self.assertLess(abs(last - first + gained).max(), 1e-9 * passed)
        self.assertGreater(abs(last - first).max(), 0.1 * passed)

    def test_uniform_motion(self):
        """Fluid and grains that move alike: volumes of cells follow the grains in jumps, which make the velocity
        uneven. With the filter a hundred times less."""
        x, _ = crowded_box.crowd(3000, height=0.04)
        uneven = []
        for length in (LENGTH, 0):
            folder = self.run_box(
                steps=20, grains=(x, [(0, 0, 0.5)] * len(x)), diameter=DIAMETER, rho="rho [1 -3 0 0 0 0 0] 1000;",
                velocity="(0 0 0.5)", nu=1e-6, options={"voidFraction": void_fraction(length)})
            speeds = crowded_box.values(folder / "0.002/fluidVelocity") - [0, 0, 0.5]
            uneven.append(abs(speeds).max() / 0.5)
        print(f"velocity off by {uneven[0]:.1e} of its value, without a filter {uneven[1]:.1e}")
        self.assertLess(uneven[0], 1e-5)
        self.assertLess(uneven[0], 0.01 * uneven[1])

    def test_restart(self):
        """A run in two parts has the fields of one in one part, bit for bit."""
        grains = crowd(300)
        options = {"voidFraction": void_fraction(LENGTH), "interpolation": "cell"}
        whole = self.run_box(steps=20, write_every=10, grains=grains, diameter=DIAMETER, options=options)
        parts = self.run_box(steps=10, write_every=10, grains=grains, diameter=DIAMETER, options=options)
        box.end_at(parts, 20)
        self.foam("pimpleFoam", parts)
        for field in ("U", "p", "phi", "voidFraction", "particleVelocity", "solidsFlux", "dragCoefficient",
                      "particleMomentumSource", "particleMomentumOwed", "fluidVelocity"):
            a, b = ((f / "0.002" / field).read_bytes() for f in (whole, parts))
            self.assertEqual(a, b, field)

    def test_length_zero(self):
        """No filter: bit for bit as without the entry."""
        grains = crowd(300)
        for equations in ("full", "neglected"):
            runs = [self.run_box(steps=4, grains=grains, diameter=DIAMETER, options={"voidFraction": entry})
                    for entry in (box.void_fraction(equations), void_fraction(0, equations))]
            for field in ("U", "p", "voidFraction", "particleVelocity", "particleMomentumSource"):
                a, b = ((f / "0.0004" / field).read_bytes() for f in runs)
                self.assertEqual(a, b, (equations, field))

    def test_cells_empty_again(self):
        """When the last grain has left the mesh, no cell holds anything of it."""
        folder = self.run_box(
            steps=20, walls=True, boundary="f f f", grains=([[0.01, 0.01, 0.0398]], [(0, 0, 1)]), diameter=2e-4,
            options={"voidFraction": void_fraction(LENGTH)}, write_every=1)
        self.assertLess(min(dictionaries.internal(folder / "0.0001/voidFraction")), 1)
        for field, value in (("voidFraction", 1), ("dragCoefficient", 0)):
            self.assertEqual(set(dictionaries.internal(folder / "0.002" / field)), {value}, field)
        self.assertEqual(abs(read(folder, "0.002", "solidsFlux")).max(), 0)

    def test_refused(self):
        """Before anything is solved, with file, entry and remedy, on all ranks."""
        for entry, more, words in (
                ("length -1;", {}, ("length -1", "from 0")),
                ("length x;", {}, ("length x",)),
                ("", {}, ("length", "missing")),
                ("length 0; width 1;", {}, ("width",)),
                ("length 1e-3;", {}, ("length 0.001 m", "smaller than the smallest cell", "0 for no filter")),
                ("length 0.05;", {}, ("length 0.05", "larger than the mesh")),
                ("length 4e-3;", {"selfDisturbance": "yes"}, ("selfDisturbance yes", "length 0"))):
            for ranks in (0, 2):
                with self.subTest(entry=entry, ranks=ranks):
                    folder = self.new_folder()
                    box.write(folder)
                    box.script(folder, grains=box.grains(*box.swarm(3, 1)))
                    box.fv_options(folder, voidFraction=f"{{ model divided; filter {{ {entry} }} }}", **more)
                    self.foam("blockMesh", folder)
                    if ranks:
                        self.foam("decomposePar", folder)
                    result = self.foam("pimpleFoam", folder, ranks, check=False)
                    self.assertFails(result, "fvOptions", *words)
                    self.assertNotRegex(result.output, box.SOLVED)


if __name__ == "__main__":
    unittest.main()
