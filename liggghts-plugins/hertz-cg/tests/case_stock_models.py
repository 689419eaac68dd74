# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The words of the stock `pair_style gran model hertz` mean the same after `fix hertz/cg`: forces and torques
of both programs on the same grains, with and without coarse graining, and the energy they keep."""

import unittest

import granular as g
from grainjet import Case

# Both programs add up the same few terms in another order
SAME_STATE = 1e-9

LAWS = (
    "rolling_friction cdt torsionTorque on",
    "rolling_friction epsd",
    "rolling_friction epsd torsionTorque on",
    "rolling_friction epsd2",
    "limitForce on",
    "tangential_damping off",
    "cohesion sjkr",
    "cohesion sjkr2",
    "cohesion sjkr tangential_reduce on",
    "cohesion sjkr rolling_friction epsd limitForce on tangential_damping off",
)


class StockModels(Case):

    def run_case(self, kind, words, ranks=0, tangential="history", before="", factor=1, dimension=3):
        folder = f"{kind}{ranks}"
        # the command is the plugin's, the law is the stock one where there is no fix
        load = "plugin load hertzcgplugin.so\n"
        more = f"coarsegraining {factor} model_check warn\n" if factor > 1 else ""
        more += f"dimension {dimension}\n"
        script = (load + g.head("p p p", more) + "read_data data\nneighbor 0.0005 bin\nneigh_modify delay 0\n"
                  + g.MATERIAL + before + self.law(kind, words, tangential) + "fix i all nve/sphere\n"
                  + ("fix flat all enforce2d\n" if dimension == 2 else "")
                  + "timestep 1e-7\n" + g.dump(10, f"dump.{folder}") + "run 20\nrun 10\n")
        self.liggghts(script, ranks, name=f"in.{folder}")
        return g.read_dump(self.folder / f"dump.{folder}")

    def law(self, kind, words, tangential):
        """Written as a user would: the same words after either name."""
        words = f"model hertz tangential {tangential} {words}"
        if kind == g.STOCK:
            return f"pair_style gran {words}\npair_coeff * *\n"
        return f"fix c all hertz/cg {words}\n"

    def compare(self, words, ranks=(0,), **options):
        stock = self.run_case(g.STOCK, words, **options)
        for n in ranks:
            plugin = self.run_case(g.PLUGIN, words, ranks=n, **options)
            for step in stock:
                force = g.difference(stock[step], plugin[step], g.F)
                torque = g.difference(stock[step], plugin[step], g.T)
                self.assertLess(force, SAME_STATE, (words, step, n))
                self.assertLess(torque, SAME_STATE, (words, step, n))
        return stock

    def setUp(self):
        super().setUp()
        (self.folder / "data").write_text(
            g.assembly(300, 0.0145, (0.001, 0.0014, 0.002), speed=0.5, spin=300))

    def test_each_word(self):
        plain = self.compare("")
        for words in LAWS:
            with self.subTest(words=words):
                other = self.compare(words, ranks=(0, 2))
                changed = max(g.difference(plain[step], other[step], g.F + g.T) for step in plain)
                self.assertGreater(changed, 1e-6, "these words change nothing here: nothing was tested")

    def test_tangential_without_history(self):
        self.compare("", ranks=(0, 2), tangential="no_history")
        self.compare("rolling_friction epsd2", tangential="no_history")

    def test_frozen_grains(self):
        self.compare("cohesion sjkr rolling_friction epsd", ranks=(0, 2),
                     before="group ice id <= 60\nvelocity ice set 0 0 0\nfix z ice freeze\n")

    def test_coarse_graining(self):
        """The law is evaluated for the particles and scaled; each of these is self-similar, so the stock
        program's evaluation on the grain itself gives the same (it says that it was not made for it)."""
        for words in LAWS:
            with self.subTest(words=words):
                self.compare(words, factor=2)

    def test_two_dimensions(self):
        """The inertia of epsd's dashpot is that of a disc there."""
        text = g.assembly(60, 0.0145, (0.001, 0.0014, 0.002), speed=0.5, spin=300)
        before, rest = text.split("\nAtoms\n\n")
        rows, after = rest.split("\nVelocities\n\n")
        rows = [row.split() for row in rows.strip().split("\n")]
        speeds = [row.split() for row in after.strip().split("\n")]
        (self.folder / "data").write_text(
            before.replace("0 0.0145 zlo zhi", "-0.00725 0.00725 zlo zhi") + "\nAtoms\n\n"
            + "".join(" ".join(row[:6] + ["0"]) + "\n" for row in rows) + "\nVelocities\n\n"
            + "".join(" ".join(row[:3] + ["0"] + ["0", "0"] + row[6:]) + "\n" for row in speeds))
        self.compare("rolling_friction epsd", dimension=2)


if __name__ == "__main__":
    unittest.main()
