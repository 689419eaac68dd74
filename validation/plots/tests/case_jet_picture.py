# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""jet.py: picture and animation of a small coupled box, and what it says without frames."""

import unittest

import grainjet
from grainjet import coupled_box as box, fields

JET = grainjet.ROOT / "validation" / "plots" / "jet.py"
GRAINS = "grains { type vtkCloud; libs (lagrangianFunctionObjects); cloud liggghts; writeControl timeStep; writeInterval 2; }"


class JetPicture(grainjet.Case):

    def draw(self, *arguments):
        return grainjet.run([JET, ".", "--diameter", "0.005", *arguments], self.folder)

    def test_picture_and_animation(self):
        box.write(self.folder, steps=8, write_every=4, cells="4 4 8", velocity="(0 0 1)", walls=True, through=True, functions=GRAINS)
        box.script(self.folder, grains=box.grains([(0.01, 0.0001, 0.01), (0.012, 0.0001, 0.02)], [(0, 0, 2), (0, 0, 2)]))
        box.fv_options(self.folder, coupling="oneWay")
        self.foam("blockMesh")
        self.foam("pimpleFoam")
        (self.folder / "box.foam").touch()

        # the written time nearest to one
        self.assertEqual([fields.mesh_at(self.folder, time)[0] for time in (0, 3e-4, 6.1e-4, 1)], [0, 4e-4, 8e-4, 8e-4])
        self.assertEqual(fields.latest_mesh(self.folder)[0], 8e-4)
        # the plane y = 0 cuts the walls at both sides, 8 faces along the box
        walls = fields.wall_lines(self.folder)
        self.assertEqual(walls.shape, (16, 2, 3))
        self.assertEqual(set(walls[:, :, 0].round(6).flat), {0, 0.02})
        self.assertAlmostEqual(abs(walls[:, 1, 2] - walls[:, 0, 2]).sum(), 0.08, delta=1e-8)     # VTK reads points in single precision
        times = fields.grain_times(self.folder / "postProcessing/grains")
        self.assertEqual(len(times), 4)

        drawn = self.draw("--output", "pictures/box.png")
        self.assertEqual(drawn.code, 0, drawn)
        self.assertTrue((self.folder / "pictures/box.png").read_bytes().startswith(b"\x89PNG"))

        drawn = self.draw("--animate", "6e-4", "--output", "box.gif")
        self.assertEqual(drawn.code, 0, drawn)
        data = (self.folder / "box.gif").read_bytes()
        self.assertTrue(data.startswith(b"GIF89a"))
        self.assertEqual(data.count(b"\x21\xf9\x04"), 3)        # frames at 2e-4, 4e-4, 6e-4 s

        self.assertFails(self.draw("--animate", "1e-4", "--output", "none.gif"), "no two times of grains", "write them more often")


if __name__ == "__main__":
    unittest.main()
