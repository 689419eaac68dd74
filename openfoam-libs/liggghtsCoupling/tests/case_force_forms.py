# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The two ways to write forces: the short form (entries drag and forces) and the dictionary."""
# processors: 2

import unittest

import bad_case
from grainjet import coupled_box as box, dumps
from grainjet.coupled_box import swarm
import user_library

FILE = "constant/fvOptions"
DUMP = ("dump d all custom 20 grains.*.dump id vx vy vz f_fluidDragCoefficient\n"
        'dump_modify d sort id format "%d' + 4 * " %.17g" + '"')


class ForceForms(bad_case.BadCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        path = cls.base / "system/controlDict"
        path.write_text(path.read_text().replace('("libliggghtsCoupling.so")', user_library.libs("probeModels")))
        x, v = swarm(30, 5, low=(0.002,) * 3, high=(0.018, 0.018, 0.038))
        cls.velocities = {tag: list(u) for tag, u in enumerate(v, 1)}
        box.script(cls.base, grains=box.grains(x, v), boundary="f f f", end=DUMP,
                   gravity="fix g all gravity 9.81 vector 0 0 -1")

    def result(self, forces, drag=None, ranks=0):
        """Velocities and drag coefficients of all grains after two fluid steps, and what the log says."""
        folder = self.fresh()
        box.fv_options(folder, drag=drag, forces=forces)
        run = self.assertRuns(folder, ranks=ranks)
        said = [line.strip() for line in run.output.splitlines() if line.strip().startswith("Forces:")]
        self.assertEqual(len(said), 1)
        return dumps.last(folder / "grains.20.dump"), said[0].split(":", 1)[1].split()

    # ---- both say the same

    def test_same_result(self):
        """Bit for bit: a list, and a dictionary with the same models in the same order."""
        for drag, listed, dictionary, said in (
                (None, None, "{ drag {} }", "drag (Gidaspow)"),
                ("Gidaspow", "()", "{ drag { model Gidaspow; } }", "drag (Gidaspow)"),
                ("WenYu", "(viscous buoyancy)", "{ drag { model WenYu; } viscous {} buoyancy {} }",
                 "drag (WenYu) viscous buoyancy")):
            with self.subTest(dictionary=dictionary):
                short, long = self.result(listed, drag), self.result(dictionary)
                self.assertEqual(" ".join(long[1]), said)
                self.assertEqual(short, long)
                self.assertNotEqual(short[0][1][:3], self.velocities[1])

    def test_same_on_two_ranks(self):
        """Names and lines of a dictionary that the master has read reach the other ranks."""
        forces = "{ drag { model Stokes; } pressureGradient {} }"
        one, two = self.result(forces), self.result(forces, ranks=2)
        self.assertEqual(one[1], two[1])
        for tag, row in one[0].items():
            for a, b in zip(row, two[0][tag]):
                # round-off of the pressure's solver, 1e-13
                self.assertAlmostEqual(a, b, delta=1e-11)

    def test_no_forces(self):
        """An empty dictionary is no force at all, not even drag: grains fall freely."""
        found, said = self.result("{}")
        self.assertEqual(said, ["none"])
        for tag, (*v, coefficient) in found.items():
            self.assertEqual(coefficient, 0)
            self.assertEqual(v[:2], self.velocities[tag][:2])
            self.assertAlmostEqual(v[2], self.velocities[tag][2] - 9.81 * 2e-4, delta=1e-12)

    def test_drag_stays_out(self):
        """A dictionary without drag has none."""
        found, said = self.result("{ buoyancy {} }")
        self.assertEqual(said, ["buoyancy"])
        self.assertEqual({row[3] for row in found.values()}, {0})

    # ---- order

    def test_order(self):
        """Models act in the order of the dictionary: one that changes the velocity of the fluid as the
        grain sees it counts for the drag law after it, not for that before it."""
        probe = "probe { shift (0 0 5); }"
        before, said = self.result(f"{{ {probe} drag {{}} }}")
        self.assertEqual(said, ["probe", "drag", "(Gidaspow)"])
        after, said = self.result(f"{{ drag {{}} {probe} }}")
        self.assertEqual(said, ["drag", "(Gidaspow)", "probe"])
        plain, _ = self.result("{ drag {} }")
        for tag in plain:
            # a grain at 1 m/s that is blown at with 5 m/s has a larger coefficient
            self.assertGreater(before[tag][3], 1.2 * plain[tag][3])
            self.assertLess(after[tag][3], 1.1 * plain[tag][3])
            # both are blown upwards
            self.assertGreater(after[tag][2], plain[tag][2])
            self.assertGreater(before[tag][2], after[tag][2])

    # ---- refused

    def refused(self, *words, ranks=(0, 2), **entries):
        for n in ranks:
            with self.subTest(ranks=n, **entries):
                folder = self.fresh()
                box.fv_options(folder, **entries)
                result = self.assertRefused(folder, FILE, *words, ranks=n, steps=True)
                self.assertEqual(result.output.count("FOAM FATAL"), 1, result)
                self.assertFalse((folder / "log.liggghts").exists())

    def test_drag_in_both(self):
        self.refused("drag WenYu and a dictionary of forces", "drag { model WenYu; }", drag="WenYu", forces="{ viscous {} }")

    def test_drag_in_the_list(self):
        self.refused("drag stands in the list", forces="(drag viscous)", drag=None, ranks=(0,))

    def test_twice(self):
        self.refused("viscous", "twice", forces="(viscous viscous)", ranks=(0,))
        self.refused("viscous", "twice", drag=None, forces="{ viscous {} buoyancy {} viscous {} }")
        self.refused("model", "twice", drag=None, forces="{ drag { model WenYu; model Ergun; } }", ranks=(0,))

    def test_entry_without_a_dictionary(self):
        self.refused("viscous has no dictionary", "viscous { }", drag=None, forces="{ drag {} viscous; }")
        self.refused("drag has no dictionary", drag=None, forces="{ drag Gidaspow; }", ranks=(0,))

    def test_neither_list_nor_dictionary(self):
        self.refused("forces", drag=None, forces="viscous", ranks=(0,))
        self.refused("forces", drag=None, forces="3")

    def test_unknown_names(self):
        self.refused("Unknown force visco", drag=None, forces="{ visco {} }", ranks=(0,))
        self.refused("Unknown force visco", drag=None, forces="(visco)", ranks=(0,))
        self.refused("Unknown drag Gidaspov", "Gidaspow", drag="Gidaspov", forces="()", ranks=(0,))
        self.refused("Unknown entry", "It takes none", drag=None, forces="{ viscous { x 1; } }", ranks=(0,))

    def test_buoyancy_without_gravity(self):
        """Known only when the script has run."""
        folder = self.fresh()
        self.change(folder, "constant/in.particles", ("fix g all gravity 9.81 vector 0 0 -1", ""))
        box.fv_options(folder, drag=None, forces="{ buoyancy {} }")
        self.assertRefused(folder, FILE, "buoyancy needs gravity", "fix gravity", steps=True)


if __name__ == "__main__":
    unittest.main()
