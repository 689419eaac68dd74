# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing grains does not touch the run, and a run continues from any write time as if it had not
stopped: bit for bit, serial and on 2 ranks.

The grains are a crowd that touches each other, a flat wall and a mesh wall while it is written,
crosses from one rank to the other, leaves the box and is deleted by a mesh.
"""
# processors: 2
# label: long

import shutil
import unittest

import grainjet
from grainjet import coupled_box as box, dumps, scripts
from grainjet.coupled_box import end_at, swarm

FIELDS = ("U", "p", "phi", "voidFraction", "particleVelocity", "dragCoefficient",
          "particleMomentumSource", "particleMomentumOwed")

DUMP = scripts.dump(100, "grains.*.dump", box.MOTION + " omegax omegay omegaz")

WALLS = """
fix m5 all property/global coefficientRollingFriction peratomtypepair 1 0.1
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix plate all mesh/surface file plate.stl type 1
fix slope all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate
fix face all mesh/surface/planar file face.stl type 1
fix out all massflow/mesh mesh face vec_side 0. 0. 1. count once delete_atoms yes
"""

INSERTION = """
fix template all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0004
fix grains all particledistribution/discrete 32452843 1 template 1.0
region source block 0.002 0.018 0.002 0.018 0.012 0.018 units box
fix source all insert/pack seed 86028121 distributiontemplate grains vel constant 0 0.2 -0.5 &
    insert_every 130 overlapcheck yes all_in yes particles_in_region 15 region source
"""


class Writes(grainjet.Case):

    def write(self, name, steps, every, sort="0 0", insertion=False, ranks=0,
              contacts="fix contacts all hertz/cg rolling cdt\n"):
        folder = self.folder / name
        box.write(folder, steps=steps, write_every=every, walls=True)
        x, v = swarm(250, 5, high=(0.02, 0.02, 0.011), mean=(0.6, 0, 0), rms=0.6)
        box.script(
            folder, grains=box.grains(x, v, 1e-3), end=DUMP, boundary="f f f",
            gravity="fix g all gravity 9.81 vector 0 0 -1", plugins="plugin load hertzcgplugin.so",
            processors="processors 2 1 1" if ranks else "",
            fixes=WALLS + contacts + (INSERTION if insertion else ""))
        script = folder / "constant/in.particles"
        script.write_text(script.read_text().replace("sort 0 0", f"sort {sort}"))
        # a slope in the middle of the crowd, and above it a face that deletes what crosses it
        (folder / "plate.stl").write_text(scripts.stl(*scripts.rectangle(
            (0.012, 0, 0), (0.02, 0, 0.006), (0.02, 0.02, 0.006), (0.012, 0.02, 0))))
        (folder / "face.stl").write_text(scripts.stl(*scripts.rectangle(
            (0, 0, 0.0115), (0.02, 0, 0.0115), (0.02, 0.02, 0.0115), (0, 0.02, 0.0115))))
        box.fv_options(folder, interpolation="cell")
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        return folder

    def assertSame(self, a, b, steps, ranks):
        """All grains at all their dumps, and all fields at the end."""
        for step in range(100, 10 * steps + 1, 100):
            one, other = (dumps.last(f / f"grains.{step}.dump") for f in (a, b))
            self.assertEqual(one, other, f"grains of DEM step {step}")
        for part in [f"processor{k}/" for k in range(ranks)] or [""]:
            for field in FIELDS:
                one, other = ((f / part / f"{steps * 1e-4:g}" / field).read_bytes() for f in (a, b))
                self.assertEqual(one, other, part + field)

    def run_parts(self, ranks, **options):
        """60 steps in three runs; one writes once, one twice."""
        parts = self.write("parts", 23, 23, ranks=ranks, **options)
        self.foam("pimpleFoam", parts, ranks)
        end_at(parts, 41)
        self.foam("pimpleFoam", parts, ranks)
        end_at(parts, 60)
        control = parts / "system/controlDict"
        control.write_text(control.read_text().replace("writeInterval 23", "writeInterval 60"))
        result = self.foam("pimpleFoam", parts, ranks)
        self.assertIn("continued grains", result.output)
        return parts

    def check(self, ranks=0, continues=True, **options):
        whole = self.write("whole", 60, 60, ranks=ranks, **options)
        often = self.write("often", 60, 1, ranks=ranks, **options)
        for folder in (whole, often):
            self.foam("pimpleFoam", folder, ranks)
        self.assertSame(whole, often, 60, ranks)
        if continues:
            self.assertSame(whole, self.run_parts(ranks, **options), 60, ranks)
        balance = box.read_balance(whole)
        if "hertz/cg" in options.get("contacts", "hertz/cg"):
            self.assertGreater(min(balance["contacts"][k] for k in (22, 40)), 0)
        self.assertGreater(balance["deleted"][-1], balance["deleted"][40] + 5)
        return balance

    def test_serial(self):
        self.check()

    def test_serial_with_sorting(self):
        """Grains are sorted in memory every 30 steps."""
        self.check(sort="30 0.002")

    def test_parallel(self):
        self.check(ranks=2, sort="30 0.002")

    def test_stock_pair_style(self):
        """Contacts of LIGGGHTS itself."""
        stock = "pair_style gran model hertz tangential history\npair_coeff * *\n"
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                for part in self.folder.iterdir():
                    shutil.rmtree(part)
                self.check(ranks=ranks, contacts=stock)

    def test_writes_and_insertion(self):
        """LIGGGHTS draws other random places for grains that are inserted after a restart."""
        balance = self.check(insertion=True, continues=False)
        self.assertGreater(balance["inserted"][-1], balance["inserted"][22])


if __name__ == "__main__":
    unittest.main()
