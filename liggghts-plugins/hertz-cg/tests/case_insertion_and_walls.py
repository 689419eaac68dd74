# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""A jet of grains that is inserted during the run, streams through a pipe (primitive wall), hits a plate
(mesh wall) and leaves through the open end: fix hertz/cg against the stock pair style."""

import unittest

import granular as g
from grainjet import Case, scripts


class InsertionAndWalls(Case):

    def setUp(self):
        super().setUp()
        (self.folder / "face.stl").write_text(scripts.stl(*g.square(0.0025, 0.001)))
        (self.folder / "plate.stl").write_text(scripts.stl(*g.square(0.002, 0.017, parts=5)))

    def run_case(self, kind, ranks=0, steps=8000, sideways="0.1"):
        name = f"{kind}{ranks}{sideways}"
        script = g.load(kind) + g.head("f f f") + """
region r block -0.006 0.006 -0.006 0.006 -0.004 0.02 units box
create_box 2 r
neighbor 0.0005 bin
neigh_modify delay 0
""" + "neigh_modify contact_distance_factor 1.05\n" * (kind == g.STOCK) + g.MATERIAL + g.contacts(kind) + f"""
fix p1 all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0004
fix p2 all particletemplate/sphere 15485867 atom_type 2 density constant 2500 radius constant 0.0005
fix pd all particledistribution/discrete 32452843 2 p1 0.4 p2 0.6
fix face all mesh/surface/planar file face.stl type 1
fix in all insert/stream seed 32452867 distributiontemplate pd nparticles 400 vel constant {sideways} 0. 2. &
  particlerate 20000 overlapcheck yes all_in no insertion_face face extrude_length 0.002
fix plate all mesh/surface file plate.stl type 1
fix wp all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate
fix wc all wall/gran model hertz tangential history primitive type 1 zcylinder 0.0045 0 0
fix g all gravity 9.81 vector 0 0 -1
fix i all nve/sphere
timestep 2e-6
thermo 1000
thermo_modify lost ignore
variable in equal f_in[1]
{g.dump(1000, "dump." + name)}
run {steps}
""" + ("variable n equal f_c[2]\nprint 'collisions $n'\n" if kind == g.PLUGIN else "")
        self.printed = self.liggghts(script, ranks, name=f"in.{name}").output
        return g.read_dump(self.folder / f"dump.{name}")

    @staticmethod
    def inside(frame, margin=0.0008):
        """Grains away from the open ends; outside of them a grain is gone only at the next search, whose
        step may differ."""
        return {i: row for i, row in frame.items()
                if -0.004 + margin < row[3] < 0.02 - margin and max(abs(row[1]), abs(row[2])) < 0.006 - margin}

    def differences(self, a, b):
        """Largest distance of the same grain [diameters] by step."""
        out = {}
        for step in sorted(a):
            one, other = self.inside(a[step]), self.inside(b[step])
            self.assertEqual(one.keys(), other.keys(), f"step {step}")
            out[step] = max((abs(one[i][k] - other[i][k]) for i in one for k in g.X), default=0.0) / 1e-3
        return out

    def test_same_jet_on_one_two_and_four_ranks(self):
        """In front of the plate grains meet often and round-off grows fast. The measure of it is what the
        stock program makes of one last digit in the velocity at the inlet."""
        stock = self.run_case(g.STOCK)
        control = self.differences(stock, self.run_case(g.STOCK, sideways="0.10000000000000002"))
        for ranks in (0, 2, 4):
            plugin = self.run_case(g.PLUGIN, ranks)
            for step, x in self.differences(stock, plugin).items():
                print(f"{ranks or 1} rank(s), step {step}, {len(stock[step])} grains: positions differ by {x:.1e} "
                      f"diameters, stock with another last digit by {control[step]:.1e}")
                self.assertLessEqual(x, max(100 * control[step], 1e-9))
            collisions = int(self.printed.split("collisions ")[1].split()[0])
            self.assertGreater(collisions, 50)

    def test_grains_bounce_and_leave(self):
        frames = self.run_case(g.PLUGIN, ranks=2, steps=16000)
        last = max(frames)
        inserted = max(max(frame) for frame in frames.values() if frame)
        turned = {i for frame in frames.values() for i, row in frame.items() if row[6] < 0}
        print(f"{inserted} inserted, {len(turned)} turned back, {len(frames[last])} inside at the end")
        self.assertGreater(inserted - len(frames[last]), 20)
        self.assertGreater(len(turned), 20)


if __name__ == "__main__":
    unittest.main()
