# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""surface.py: pictures of maps and spectra of fix surface/stats, in both file formats, and its errors."""

import re
import unittest

import matplotlib.image

import grainjet
from grainjet import scripts, surfaces

SURFACE = grainjet.ROOT / "validation" / "plots" / "surface.py"
D, RHO = 1e-4, 2500.0

SCRIPT = """
plugin load surfacestatsplugin.so
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
units si
read_data grains.data
neighbor 0.0002 bin
neigh_modify delay 0 binsize 0.002
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.8
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
timestep 1e-7
fix plate all mesh/surface file plate.stl type 1
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate store_force yes
fix s all surface/stats mesh plate wall w file plate.csv vtk plate.{ending} spectra spectra.csv wear dnv material steel
fix i all nve/sphere
run 800
"""


class SurfacePicture(grainjet.Case):

    def thrown(self, ending):
        """Six grains onto a square of four triangles; the map."""
        grains = [(1, D, RHO, (-0.0015 + 0.0006 * i, 0.0001 * i, 0.6 * D), (2.0, 0, -3.0 - i)) for i in range(6)]
        (self.folder / "grains.data").write_text(scripts.data(grains, ((-0.01, 0.01), (-0.01, 0.01), (-0.001, 0.01))))
        a, b, c, d = (-0.003, -0.003, 0), (0.003, -0.003, 0), (0.003, 0.003, 0), (-0.003, 0.003, 0)
        (self.folder / "plate.stl").write_text(scripts.stl(*((p, q, (0, 0, 0)) for p, q in ((a, b), (b, c), (c, d), (d, a)))))
        self.liggghts(SCRIPT.format(ending=ending))
        return surfaces.Surface(self.folder / f"plate.{ending}")

    def draw(self, *arguments):
        return grainjet.run([SURFACE, *arguments], self.folder)

    def test_map_and_spectra(self):
        for ending in ("vtp", "vtk"):
            surface = self.thrown(ending)
            self.assertEqual(surface.values["impacts"].sum(), 6)
            self.assertAlmostEqual(surface.areas().sum() / 3.6e-5, 1, delta=1e-6)       # of STL files, in single precision
            # a depth is a volume over the area
            self.assertAlmostEqual((surface.values["wear_depth"] * surface.values["area"]).sum() / surface.values["wear_volume"].sum(), 1,
                                   delta=1e-12)
        drawn = self.draw("plate.vtk", "--spectra", "spectra.csv", "--log", "--look", "1", "0", "-1", "--up", "0", "0", "1",
                          "--output", "pictures/plate.png")
        self.assertEqual(drawn.code, 0, drawn)
        self.assertTrue((self.folder / "pictures" / "plate.png").read_bytes().startswith(b"\x89PNG"))
        listed = self.draw("plate.vtk", "--list")
        self.assertIn("wear_volume", listed.output)

    def test_labels(self):
        """Axes have names, above stand quantity, file and time, which is that of the last step, and nothing reaches the edge of the picture.
        SVG files have what is written in comments."""
        self.thrown("vtp")
        for words, expected in (
                (("--average", "2e-3"), ("x, mm", "y, mm", "wear depth, mean within 2 mm", "plate.vtp at 8e-05 s")),
                (("--look", "0", "0", "1", "--length", "1", "--field", "wear_volume"), ("-x, m", "y, m", "wear volume")),
                (("--look", "1", "0", "-1", "--up", "0", "0", "1"), ("-y, mm", "along (0.71 0 0.71), mm"))):
            with self.subTest(words=words):
                self.assertEqual(self.draw("plate.vtp", *words, "--output", "plate.svg").code, 0)
                written = re.findall("<!-- (.*?) -->", (self.folder / "plate.svg").read_text())
                self.assertLessEqual(set(expected), set(written))
        self.assertEqual(self.draw("plate.vtp").code, 0)
        pixels = matplotlib.image.imread(self.folder / "surface.png")[..., :3]
        for edge in (pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]):
            self.assertEqual(edge.min(), 1)

    def test_average_and_largest(self):
        """Four equal triangles: within 1 mm each has only itself, within 10 mm all have the mean, which is the removed volume over the area."""
        surface = self.thrown("vtp")
        depth = surface.values["wear_depth"]
        for radius, largest in (("1e-3", depth.max()), ("1e-2", surface.values["wear_volume"].sum() / surface.areas().sum())):
            drawn = self.draw("plate.vtp", "--average", radius)
            self.assertEqual(drawn.code, 0, drawn)
            found = re.search(r"largest wear_depth: (\S+) m at \((\S+) (\S+) (\S+)\) m", drawn.output)
            self.assertAlmostEqual(float(found[1]) / largest, 1, delta=1e-3)    # as printed
            if radius == "1e-3":
                centre = surface.centres()[depth.argmax()]
                for printed, there in zip(found.groups()[1:], centre):
                    self.assertAlmostEqual(float(printed), there, delta=1e-7)

    def test_errors(self):
        self.thrown("vtp")
        self.assertFails(self.draw("plate.vtp", "--field", "wear"), "no quantity wear", "wear_depth")
        self.assertFails(self.draw("plate.vtp", "--up", "0", "0", "1"), "--up")
        self.assertFails(self.draw("plate.vtp", "--average", "0"), "--average must be above 0")
        self.assertFails(self.draw("none.vtp"), "none.vtp", "no such file")
        self.assertFails(self.draw("plate.vtp", "--spectra", "plate.csv"), "plate.csv is no table of spectra")


if __name__ == "__main__":
    unittest.main()
