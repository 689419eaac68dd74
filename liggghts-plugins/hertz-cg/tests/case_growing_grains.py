# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""Grains that change their size during a run (`fix adapt ... diameter`), as packings are made with it."""

import unittest

import granular as g
from grainjet import Case

D, BOX = 1e-3, 0.0125

GROW = """
compute rad all property/atom radius
variable grown atom {rate}*2.*c_rad
fix grow all adapt {every} atom diameter v_grown
"""


class Growing(Case):

    def setUp(self):
        super().setUp()
        (self.folder / "data").write_text(g.assembly(250, 0.0115, (D, 1.2 * D), speed=0.3, spin=100, clearance=0.02))

    def run_case(self, kind, ranks=0, boundary="f f f", every=10, rate=1.002, steps=1500, check=True, after=""):
        data = (self.folder / "data").read_text()
        if boundary == "f f f":     # room for walls around
            data = data.replace("0 0.0115", "-0.0005 0.012")
        (self.folder / "data.now").write_text(data)
        walls = "".join(f"fix w{i} all wall/gran model hertz tangential history primitive type 1 {wall}\n"
                        for i, wall in enumerate(f"{a}plane {at}" for a in "xyz" for at in (-0.0005, 0.012)))
        # the stock program does not count growth when it decides to search: it has to do so at each step
        often = "every 1 delay 0 check no" if kind == g.STOCK else "delay 0"
        script = (g.load(kind) + g.head(boundary)
                  + f"read_data data.now\nneighbor 0.0005 bin\nneigh_modify {often} contact_distance_factor 1.01\n" + g.MATERIAL
                  + g.contacts(kind) + (walls if boundary == "f f f" else "") + "fix i all nve/sphere\ntimestep 1e-6\n"
                  + GROW.format(rate=rate, every=every) + g.dump(500, f"dump.{kind}{ranks}") + f"run {steps}\n" + after)
        result = self.liggghts(script, ranks, check=check)
        return g.read_dump(self.folder / f"dump.{kind}{ranks}") if check else result

    def test_as_stock(self):
        """Radii grow by 35 %, several times the margin of a list; grains meet by growth alone too."""
        stock = self.run_case(g.STOCK)
        mine = self.run_case(g.PLUGIN)
        self.assertEqual(stock.keys(), mine.keys())
        for step in stock:
            away = max(abs(stock[step][i][k] - mine[step][i][k]) for i in stock[step] for k in g.X) / D
            print(f"step {step}: {away:.1e} diameters from stock")
            # round-off, grown in some hundred collisions
            self.assertLess(away, 1e-6)
        self.assertGreater(max(abs(row[k]) for row in stock[1500].values() for k in g.F), 0.0)

    def test_ranks_and_periodic_sides(self):
        """The size of a grain on another rank is told at the next step's search: between a change and that, one
        step in ten, a contact across ranks has one old radius, 0.2 % of it."""
        for boundary in ("f f f", "p p p"):
            one = self.run_case(g.PLUGIN, boundary=boundary, steps=500)
            for ranks in (2, 4):
                other = self.run_case(g.PLUGIN, ranks, boundary=boundary, steps=500)
                away = g.distance(one[500], other[500], 0.0115 if boundary == "p p p" else 1.0) / D
                print(f"{boundary}, {ranks} ranks: {away:.1e} diameters")
                self.assertLess(away, 2e-3)

    def test_larger_than_a_part_of_the_box(self):
        result = self.run_case(g.PLUGIN, 2, boundary="p p p", every=1, rate=1.01, steps=400, check=False)
        self.assertFails(result, "ERROR", "hertz/cg", "larger than a rank's part")


if __name__ == "__main__":
    unittest.main()
