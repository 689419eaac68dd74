# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""fix hertz/cg chooses its reach again during a run that starts in an empty box, with meshes that stand still and that
move: the same grains as with the stock pair style, on any number of ranks, and continued bit for bit."""

import re
import unittest

import granular as g
from grainjet import Case, scripts

BOX = 0.02


class Reach(Case):

    def setUp(self):
        super().setUp()
        (self.folder / "floor.stl").write_text(scripts.stl(*g.square(0.0095, 0.0, parts=20)))

    def script(self, kind, name, boundary="f f f", neighbor="neighbor 0.0005 bin", grains=300, move="", tail="run 2000",
               source=None, filled="0.004 0.018", wall=True):
        insert = f"""fix p1 all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0004
fix p2 all particletemplate/sphere 15485867 atom_type 2 density constant 2500 radius constant 0.0005
fix pd all particledistribution/discrete 32452843 2 p1 0.4 p2 0.6
region fill block -0.009 0.009 -0.009 0.009 {filled} units box
fix in all insert/pack seed 32452867 distributiontemplate pd insert_every once overlapcheck yes all_in yes &
  vel uniform 0.1 -0.3 -1. 0.5 0.5 0.5 particles_in_region {grains} region fill ntry_mc 10000
"""
        mesh = f"""fix mesh all mesh/surface file floor.stl type 1
{move}
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes mesh
"""
        return (g.load(kind) + g.head(boundary) + (source or """region r block -0.01 0.01 -0.01 0.01 -0.002 0.02 units box
create_box 2 r
""") + neighbor + "\n" + g.MATERIAL + g.contacts(kind) + mesh * wall + insert * (source is None) + f"""
fix i all nve/sphere
timestep 1e-6
thermo 1000000
thermo_modify lost ignore
{tail}
write_dump all custom dump.{name} {' '.join(g.COLUMNS)} modify sort id format """
                + '"%d' + " %.17g" * (len(g.COLUMNS) - 1) + '"\n')

    def final(self, kind, ranks=0, **options):
        self.printed = self.liggghts(self.script(kind, "end", **options), ranks, name="in.end").output
        return list(g.read_dump(self.folder / "dump.end").values())[-1]

    def test_the_reach_follows_the_grains(self):
        """Ghosts of a periodic box: as few after one long run from an empty box as after one that begins with grains."""
        def ghosts(tail):
            self.final(g.PLUGIN, boundary="p p f", grains=1500, wall=False, tail=tail)
            return float(re.findall(r"^Nghost: +(\S+) ave", self.printed, re.M)[-1])
        one, two = ghosts("run 3000"), ghosts("run 1\nrun 2999")
        print(f"ghosts: {one:.0f} after one run, {two:.0f} after two")
        self.assertLess(one, 1.3 * two)
        self.assertGreater(two, 0)

    def test_equals_stock_on_meshes(self):
        moves = {"still": "", "shaken": "fix move all move/mesh mesh mesh wiggle amplitude 0. 0. 0.0005 period 0.004",
                 "tilted": "fix move all move/mesh mesh mesh rotate origin 0. 0. 0. axis 1. 0. 0. period 0.3"}
        for label, move in moves.items():
            options = dict(move=move, tail="run 3000", grains=120, filled="0.001 0.008")
            # the stock program forgets the springs of parted grains at once only with this setting
            stock = self.final(g.STOCK, neighbor="neighbor 0.0005 bin\nneigh_modify delay 0 contact_distance_factor 1.05",
                               **options)
            turned = sum(row[6] > 0.0 for row in stock.values())
            self.assertGreater(turned, 20, "grains have to bounce off the floor")
            for neighbor in ("0.0005", "0", "0.01"):
                for ranks in (0, 2) if neighbor == "0.0005" else (0,):
                    with self.subTest(label, neighbor=neighbor, ranks=ranks):
                        plugin = self.final(g.PLUGIN, ranks, neighbor=f"neighbor {neighbor} bin", **options)
                        x = max(abs(stock[i][k] - plugin[i][k]) for i in stock for k in g.X) / 1e-3
                        print(f"{label}, neighbor {neighbor}, {ranks or 1} rank(s): differs by {x:.1e} diameters from stock")
                        # round-off, and its growth in a few contacts of a grain
                        self.assertLess(x, 1e-7)

    def test_continued_bit_for_bit(self):
        """From a file of the middle of the run, before and after the reach has changed; no grain touches the floor."""
        options = dict(boundary="p p f", grains=600, filled="0.008 0.018")
        whole = self.final(g.PLUGIN, tail="restart 150 r.*\nrun 1200", **options)
        for step in (150, 300, 900):
            with self.subTest(step=step):
                continued = self.final(g.PLUGIN, source=f"read_restart r.{step}\n", tail="run 1200 upto", **options)
                self.assertEqual(whole, continued)


if __name__ == "__main__":
    unittest.main()
