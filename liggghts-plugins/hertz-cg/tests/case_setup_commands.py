# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""Every variant of the commands that set up a run: fix hertz/cg gives what the stock pair style gives, or refuses in
words that name the remedy. Rows of docs/stock_commands.md."""

import random
import re
import unittest

import granular as g
from grainjet import Case

BOX, SMALL, LARGE = 0.012, 0.0006, 0.0016
STEPS = 1500

# What a grain's position may differ by, in diameters: round-off and its growth over the one or two
# contacts a grain has in this time
SAME = 1e-9

# label: what stands before the box and after it, how it runs; ranks; own: the stock program has to run the
# same way, since it sets up anew in the middle of contacts
WORKS = {
    "communicate single": dict(ranks=(0, 2), communicate="single vel yes"),
    "communicate multi": dict(ranks=(0, 2, 4), communicate="multi vel yes"),
    "communicate single cutoff": dict(ranks=(0, 2), communicate="single cutoff 0.004 vel yes"),
    "communicate multi cutoff": dict(ranks=(0, 2), communicate="multi cutoff 0.004 vel yes"),
    "communicate multi, small cutoff": dict(ranks=(0, 2), communicate="multi cutoff 1e-5 vel yes"),
    "newton off on": dict(head="newton off on", ranks=(2,)),
    "processors 2 1 1": dict(head="processors 2 1 1", ranks=(2,)),
    "processors * 2 *": dict(head="processors * 2 *", ranks=(2,)),
    "processors grid numa": dict(head="processors * * * grid numa", ranks=(2,)),
    "processors grid twolevel": dict(head="processors * * * grid twolevel 2 * * *", ranks=(2,)),
    "processors grid onelevel map xyz": dict(head="processors * * 1 grid onelevel map zyx", ranks=(2, 4)),
    "processors map cart/reorder": dict(head="processors * * * map cart/reorder", ranks=(2,)),
    "processors file": dict(head="processors * * * file map.txt", ranks=(2,)),
    "neighbor nsq": dict(neighbor="neighbor 0.0005 nsq"),
    "neighbor multi": dict(neighbor="neighbor 0.0005 multi"),
    "neighbor 0": dict(neighbor="neighbor 0 bin"),
    "neighbor larger than the box": dict(ranks=(0, 2), neighbor="neighbor 0.05 bin"),
    "neigh_modify every delay": dict(neighbor="neighbor 0.0005 bin\nneigh_modify every 10 delay 20"),
    "neigh_modify every, huge": dict(neighbor="neighbor 0.0005 bin\nneigh_modify every 2000000000 delay 0"),
    "neigh_modify check no": dict(neighbor="neighbor 0.0005 bin\nneigh_modify delay 0 check no"),
    "neigh_modify page one": dict(neighbor="neighbor 0.0005 bin\nneigh_modify page 50000 one 50"),
    "neigh_modify binsize": dict(neighbor="neighbor 0.0005 bin\nneigh_modify binsize 0.001"),
    "neigh_modify contact_distance_factor": dict(neighbor="neighbor 0.0005 bin\nneigh_modify contact_distance_factor 1.1"),
    "atom_modify map hash": dict(head="atom_modify map hash"),
    "atom_modify sort off": dict(head="atom_modify sort 0 0"),
    "atom_modify sort": dict(head="atom_modify sort 50 0.001"),
    "atom_modify first": dict(ranks=(0, 2), before="group half id <= 40\natom_modify first half"),
    "units cgs": dict(own=True, head="units cgs\nsoft_particles yes"),
    "units lj": dict(own=True, head="units lj\nsoft_particles yes"),
    "run in pieces": dict(ranks=(0, 2), run="run 500\nrun 0\nrun 0\nrun 1000"),
    "run pre no": dict(ranks=(0, 2), run="run 500\nrun 0 pre no post no\nrun 1000 pre no post no"),
    "run upto start stop": dict(run=f"run 500 start 0 stop {STEPS}\nrun {STEPS} upto"),
    "run every NULL": dict(own=True, run=f"run {STEPS} every 250 NULL"),
    "run every command": dict(own=True, run=f'run {STEPS} every 250 "print piece"'),
    "run pre no every command": dict(run=f'run {STEPS} pre no every 250 "print piece"'),
    "run_time": dict(own=True, run="run_time 1e-3\nrun 500"),
    "run_style verlet": dict(before="run_style verlet"),
    "displace and back": dict(ranks=(0, 2), run="run 500\ndisplace_atoms all move 0.003 0 0 units box\n"
                                  f"displace_atoms all move -0.003 0 0 units box\nrun {STEPS - 500}"),
}

REFUSED = {
    "newton on": (dict(head="newton on"), "newton off"),
    "communicate vel no": (dict(communicate="single vel no"), "communicate single vel yes"),
    "communicate group": (dict(before="group half id <= 40\natom_modify first half\n"
                                      "communicate single group half vel yes"), "communicate single group all vel yes"),
    "neigh_modify include": (dict(before="group half id <= 40\natom_modify first half\nneigh_modify include half"),
                             "neigh_modify include all"),
    "neigh_modify exclude": (dict(before="neigh_modify exclude type 1 1"), "neigh_modify exclude none"),
    "neigh_modify once": (dict(before="neigh_modify once yes"), "leave it out"),
    "run_style respa": (dict(before="run_style respa 2 2"), "run_style verlet"),
    "minimize": (dict(run="minimize 1e-4 1e-6 10 10"), "run"),
    "deformed box": (dict(before="fix squeeze all deform 1 x scale 0.9"), "remove fix squeeze"),
    "slanted box": (dict(run="change_box all triclinic\nrun 10"), "region ... block"),
    "other units": (dict(head="units real"), "units si"),
}


def flat(n, box, diameter):
    """A data file of n grains in a sheet a tenth of a grain thick."""
    rng, side = random.Random(1), int(n ** 0.5) + 1
    pitch = box / side
    text = f"sheet\n\n{n} atoms\n2 atom types\n0 {box} xlo xhi\n0 {box} ylo yhi\n"
    text += f"{-0.05 * diameter} {0.05 * diameter} zlo zhi\n\nAtoms\n\n"
    for i in range(n):
        x, y = ((k + 0.5) * pitch + rng.uniform(-1, 1) * 0.4 * (pitch - 1.02 * diameter) for k in divmod(i, side))
        text += f"{i + 1} {1 + i % 2} {0.8 * diameter} 2500 {x!r} {y!r} 0\n"
    text += "\nVelocities\n\n"
    for i in range(n):
        text += f"{i + 1} {rng.gauss(0, 1)!r} {rng.gauss(0, 1)!r} 0 0 0 {rng.gauss(0, 300)!r}\n"
    return text


class SetupCommands(Case):

    def script(self, kind, name, head="", communicate="single vel yes", neighbor="neighbor 0.0005 bin", before="",
               run=f"run {STEPS}", boundary="p p p", own=False):
        return (g.load(kind) + g.head(boundary, f"communicate {communicate}\n{head}") + "read_data data\n"
                + neighbor + "\n" + g.MATERIAL + before + "\n" + g.contacts(kind)
                + "fix i all nve/sphere\ntimestep 1e-6\nthermo 1000000\n" + run
                + f"\nwrite_dump all custom dump.{name} {' '.join(g.COLUMNS)} modify sort id format "
                + '"%d' + " %.17g" * (len(g.COLUMNS) - 1) + '"\n')

    def final(self, kind, ranks=0, **options):
        printed = self.liggghts(self.script(kind, "end", **options), ranks, name="in.end").output
        self.searches = int(re.findall(r"^Neighbor list builds = (\d+)", printed, re.M)[-1])
        return list(g.read_dump(self.folder / "dump.end").values())[-1]

    def data(self, inside=False):
        """A swarm that streams through the box; a few dozen collisions, also across sides and ranks."""
        stream = (0.0, 0.0, 0.0) if inside else (1.0, -0.5, 0.2)
        (self.folder / "data").write_text(
            g.assembly(110, BOX, (SMALL, LARGE), speed=1.0, spin=300, clearance=0.02, stream=stream))

    def test_works_as_stock(self):
        self.data()
        stock = self.final(g.STOCK)
        first = self.final(g.STOCK, run="run 0")
        moved = sum(abs(stock[i][4] - first[i][4]) > 1e-3 for i in stock)
        self.assertGreater(moved, 30, "the grains have to collide")
        for label, options in WORKS.items():
            for ranks in options.get("ranks", (0,)):
                with self.subTest(label, ranks=ranks):
                    script = {key: value for key, value in options.items() if key != "ranks"}
                    expected = self.final(g.STOCK, **script) if options.get("own") else stock
                    x = g.distance(expected, self.final(g.PLUGIN, ranks, **script), BOX) / LARGE
                    print(f"{label}, {ranks or 1} rank(s): differs by {x:.1e} diameters from stock")
                    self.assertLess(x, SAME)

    def test_types_of_unlike_size(self):
        """A large and a small grain meet across a side of the box and where two ranks meet, one of each type on either
        side. With `multi` each type has its own cut-off, which is to reach the other type's surface."""
        rows = [(1, 0.01, 0.05, 0.05, -1), (2, 0.09, 0.05, 0.05, 1), (1, 0.04, 0.02, 0.05, 1), (2, 0.06, 0.02, 0.05, -1),
                (2, 0.01, 0.08, 0.05, -1), (1, 0.09, 0.08, 0.05, 1), (2, 0.04, 0.08, 0.02, 1), (1, 0.06, 0.08, 0.02, -1)]
        sides = "".join(f"0 0.1 {a}lo {a}hi\n" for a in "xyz")
        text = f"pairs\n\n{len(rows)} atoms\n2 atom types\n{sides}\nAtoms\n\n"
        for i, (kind, x, y, z, _) in enumerate(rows, 1):
            text += f"{i} {kind} {0.012 if kind == 1 else 0.003} 2500 {x} {y} {z}\n"
        text += "\nVelocities\n\n" + "".join(f"{i} {row[4]} 0 0 0 0 0\n" for i, row in enumerate(rows, 1))
        (self.folder / "data").write_text(text)
        for communicate in ("single vel yes", "multi vel yes"):
            options = dict(communicate=communicate, run="run 12000", head="processors * 1 1")
            stock = self.final(g.STOCK, **options)
            self.assertTrue(all(stock[i][4] * row[4] < 0 for i, row in enumerate(rows, 1) if row[0] == 2), "they have to bounce")
            for ranks in (0, 2, 4):
                x = g.distance(stock, self.final(g.PLUGIN, ranks, **options), 0.1) / 0.003
                print(f"{communicate}, {ranks or 1} rank(s): differs by {x:.1e} diameters from stock")
                self.assertLess(x, SAME)

    def test_ghosts_of_the_fix_own_group(self):
        self.data()
        group = "group half id <= 40\natom_modify first half\n"
        def only(communicate, ranks):
            text = self.script(g.PLUGIN, "end", before=group + communicate).replace("fix c all", "fix c half")
            self.liggghts(text, ranks, name="in.end")
            return list(g.read_dump(self.folder / "dump.end").values())[-1]
        x = g.distance(only("", 0), only("communicate single group half vel yes", 2), BOX) / LARGE
        print(f"ghosts of a group: differs by {x:.1e} diameters from all ghosts")
        self.assertLess(x, SAME)

    def test_boundaries(self):
        """Also shrink-wrapped ones. Grains outside of a fixed box are gone only at the next search, so they are
        compared where both programs have them."""
        self.data(inside=True)
        for boundary in ("f f f", "m m m", "s s s", "fs sm p", "p f m"):
            with self.subTest(boundary):
                options = dict(boundary=boundary, before="thermo_modify lost ignore")
                # the stock program forgets the springs of parted grains at once only with this setting
                stock = self.final(g.STOCK, neighbor="neighbor 0.0005 bin\nneigh_modify contact_distance_factor 1.05",
                                   **options)
                self.assertGreater(len(stock), 60)
                for ranks in (0, 2):
                    plugin = self.final(g.PLUGIN, ranks, **options)
                    both = stock.keys() & plugin.keys()
                    self.assertGreaterEqual(len(both), len(stock) - 5)
                    x = g.distance({i: stock[i] for i in both}, {i: plugin[i] for i in both}, BOX) / LARGE
                    print(f"{boundary}, {ranks or 1} rank(s): differs by {x:.1e} diameters from stock")
                    self.assertLess(x, SAME)

    def test_thin_two_dimensional_box(self):
        """Its thickness has no meaning, so it is usually less than a grain."""
        (self.folder / "data").write_text(flat(60, BOX, LARGE))
        options = dict(head="dimension 2", before="fix flat all enforce2d")
        stock, first = self.final(g.STOCK, **options), self.final(g.STOCK, run="run 0", **options)
        self.assertGreater(sum(abs(stock[i][4] - first[i][4]) > 1e-3 for i in stock), 10, "the grains have to collide")
        for ranks in (0, 2):
            x = g.distance(stock, self.final(g.PLUGIN, ranks, **options), BOX) / LARGE
            print(f"dimension 2, {ranks or 1} rank(s): differs by {x:.1e} diameters from stock")
            self.assertLess(x, SAME)
            self.assertLess(self.searches, STEPS / 10)

    def test_refused_with_the_remedy(self):
        self.data()
        for label, (options, remedy) in REFUSED.items():
            for ranks in (0, 2) if "communicate" in label else (0,):
                with self.subTest(label, ranks=ranks):
                    result = self.liggghts(self.script(g.PLUGIN, "bad", **options), ranks, check=False, name="in.bad")
                    self.assertFails(result, "ERROR", remedy)
                    self.assertEqual(result.output.count("ERROR"), 1, result)


if __name__ == "__main__":
    unittest.main()
