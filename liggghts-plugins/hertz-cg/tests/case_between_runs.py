# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""What happens to the grains between runs and in an empty box: fix hertz/cg against the stock pair style. A grain that
is nowhere, or gets there too fast, ends the run with one message that names it."""

import unittest

import granular as g
from grainjet import Case

BOX, SMALL, LARGE = 0.012, 0.0006, 0.0016

# commands between two runs in the middle of collisions
BETWEEN = {
    "delete_atoms group": "group few id <= 25\ndelete_atoms group few compress no",
    "delete_atoms region": "region part block 0 0.004 INF INF INF INF units box\ndelete_atoms region part compress no",
    "displace_atoms move": "group few id <= 25\ndisplace_atoms few move 0.0002 0 0 units box",
    "displace_atoms across a side": "displace_atoms all move 0.005 0.004 0.003 units box",
    "set velocity": "set atom 3 vx 2.0\nset atom 7 vy -2.0",
    "velocity": "velocity all set 0.5 NULL NULL sum yes units box",
    "set position": "set atom 3 x 0.0061\nset atom 3 y 0.0003",
    "set size": "set type 1 diameter 0.0007 density 2500",
    "set larger than all before": "set atom 5 diameter 0.0019 density 3000",
    "set type": "set atom 5 type 2\nset atom 6 type 1",
    "reset_timestep back": "reset_timestep 0",
    "reset_timestep on": "reset_timestep 123456789",
    "timestep": "timestep 2e-6",
    "create_atoms": "create_atoms 2 single 0.0119 0.006 0.006\nset atom 111 diameter 0.0016 density 2500",
    "change_box size": "change_box all x final 0 0.013 units box",
    "change_box boundary": "change_box all boundary p p m",
    "change_box remap": "change_box all z scale 1.05 remap units box",
    "neighbor": "neighbor 0.001 bin\nneigh_modify delay 5",
    "communicate": "communicate multi vel yes",
    "unfix and fix": "unfix i\nfix i all nve/sphere",
    "write_restart write_data": "write_restart r\nwrite_data d",
}

# those after which other grains are neighbours across ranks
BORDERS = ("delete_atoms group", "displace_atoms across a side", "set position", "set larger than all before",
           "create_atoms", "change_box size", "change_box boundary", "communicate")

EMPTY = """region box block 0 0.01 0 0.01 0 0.01 units box
create_box 2 box
"""

CREATE = """create_atoms 1 single 0.004 0.005 0.005
create_atoms 2 single 0.006 0.005 0.005
set type 1 diameter 0.001 density 2500
set type 2 diameter 0.0016 density 2500
set type 1 vx 1
set type 2 vx -1
"""


class BetweenRuns(Case):

    def final(self, kind, source, run, ranks=0, boundary="p p p", before="", neighbor="neighbor 0.0005 bin"):
        script = (g.load(kind) + g.head(boundary) + source + neighbor + "\n" + g.MATERIAL + before + "\n"
                  + g.contacts(kind) + "fix i all nve/sphere\ntimestep 1e-6\nthermo 1000000\n" + run
                  + f"\nwrite_dump all custom dump.end {' '.join(g.COLUMNS)} modify sort id format "
                  + '"%d' + " %.17g" * (len(g.COLUMNS) - 1) + '"\n')
        self.printed = self.liggghts(script, ranks, name="in.end").output
        return list(g.read_dump(self.folder / "dump.end").values())[-1]

    def test_commands_between_runs(self):
        (self.folder / "data").write_text(
            g.assembly(110, BOX, (SMALL, LARGE), speed=1.0, spin=300, clearance=0.02, stream=(1.0, -0.5, 0.2)))
        for label, commands in BETWEEN.items():
            with self.subTest(label):
                run = f"run 700\n{commands}\nrun 0\nrun 500"
                # the stock program forgets the springs of parted grains at once only with this setting
                stock = self.final(g.STOCK, "read_data data\n", run,
                                   neighbor="neighbor 0.0005 bin\nneigh_modify contact_distance_factor 1.05")
                for ranks in (0, 2) if label in BORDERS else (0,):
                    plugin = self.final(g.PLUGIN, "read_data data\n", run, ranks)
                    box = BOX if label != "change_box size" else 0.013
                    x = g.distance(stock, plugin, box) / LARGE
                    print(f"{label}, {ranks or 1} rank(s): differs by {x:.1e} diameters from stock")
                    # round-off, and its growth in one or two contacts of a grain
                    self.assertLess(x, 1e-9)

    def test_changes_without_a_new_set_up(self):
        """After `pre no` the search is left to the fix: grains created, deleted or moved are found, and one that is
        larger than all known is an error."""
        run = "run 100\n{}\nrun 3000 pre no"
        for label, commands in (("moved", "set type 1 x 0.002\nset type 2 x 0.0085"), ("slower", "set type 2 vx -0.5"),
                                ("deleted", "group one type 2\ndelete_atoms group one compress no"),
                                ("created", "create_atoms 1 single 0.005 0.002 0.005\nset atom 3 diameter 0.001")):
            for ranks in (0, 2):
                with self.subTest(label, ranks=ranks):
                    plugin = self.final(g.PLUGIN, EMPTY + CREATE, run.format(commands), ranks)
                    stock = self.final(g.STOCK, EMPTY + CREATE, run.format(commands).replace(" pre no", ""), ranks)
                    self.assertLess(g.distance(stock, plugin, 0.01), 1e-9)
        for ranks in (0, 2):
            bad = self.failing(run.format("set type 1 diameter 0.002 density 2500"), ranks)
            self.assertFails(bad, "ERROR", "is larger than the largest known", "pre no")

    def failing(self, run, ranks, boundary="p p p", source=EMPTY + CREATE):
        script = (g.load(g.PLUGIN) + g.head(boundary) + source + "neighbor 0.0005 bin\n" + g.MATERIAL
                  + g.contacts(g.PLUGIN) + "fix i all nve/sphere\ntimestep 1e-6\nthermo 1000000\n" + run + "\n")
        result = self.liggghts(script, ranks, check=False, name="in.bad")
        self.assertEqual(result.output.count("ERROR"), 1, result)
        return result

    def test_an_empty_box_is_a_normal_state(self):
        wall = "fix w all wall/gran model hertz tangential history primitive type 1 zplane 0\n"
        for ranks in (0, 2):
            for neighbor in ("neighbor 0.0005 bin", "neighbor 0 bin"):
                for before in ("", wall):
                    with self.subTest(ranks=ranks, neighbor=neighbor, before=before):
                        # the material needs to know both types, so they are there later
                        run = ("run 10\nrun 0\nrun 0\n" + CREATE + "run 3000\ngroup all2 type 1 2\n"
                               "delete_atoms group all2 compress no\nrun 10\nwrite_restart r\nrun 10\n" + CREATE + "run 1500")
                        plugin = self.final(g.PLUGIN, EMPTY, run, ranks, before=before, neighbor=neighbor)
                        alone = self.final(g.PLUGIN, EMPTY, CREATE + "run 1500", ranks, before=before, neighbor=neighbor)
                        self.assertEqual([row[1:] for row in plugin.values()], [row[1:] for row in alone.values()])
                        self.assertLess(min(row[4] * (-1) ** i for i, row in enumerate(plugin.values())), 0.0)

    def test_all_leave_and_the_run_goes_on(self):
        for ranks in (0, 2):
            self.final(g.PLUGIN, EMPTY + CREATE, "thermo_modify lost ignore\nset group all vz 100\nrun 400\nrun 10",
                       ranks, boundary="p p f")
            self.assertIn("for 10 steps with 0 atoms", self.printed)

    def test_a_grain_that_is_nowhere_is_named(self):
        for run, words in (("set atom 2 vx 1e300\nrun 100", "no finite position or velocity"),
                           ("set atom 2 vx 1e6\nrun 100", "got further than into the next part of the box"),
                           ("set atom 2 vx 1e90\nrun 100", "got further than into the next part of the box"),
                           ("timestep 1e3\nrun 100", "got further than into the next part of the box"),
                           ("timestep 1e300\nrun 100", "got further than into the next part of the box"),
                           ("fix push all addforce 1e308 0 0\nrun 100", "no finite position or velocity")):
            for ranks in (0, 2):
                with self.subTest(run, ranks=ranks):
                    self.assertFails(self.failing(run, ranks), "ERROR", "Fix hertz/cg", "grain", words, "time step")


if __name__ == "__main__":
    unittest.main()
