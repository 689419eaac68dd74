# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix plate/stats: every entry missing, misspelt, twice, of the wrong kind or out of range; a wall, units
or settings that it cannot work with. One error on every rank, before any step."""
# processors: 2
# label: long

import re
import struct
import unittest

from plate_case import D, PLANE, PLATE, PlateCase

GOOD = {"wall": "w", "centre": "0 0 0", "normal": "0 0 1", "radius": "0.005", "rings": "5",
        "file": "plate.csv", "every": "100", "events": "events.csv", "stats_start": "0"}
NUMBERS = ("", "1e", "nan", "inf", "-1", "0", "2.5", "1e9", "1e10", "1e300", "1e-320")
# those that each entry takes, without and with the grain on the plate; the word for the others
ENTRIES = {
    "centre": (("-1", "2.5", "1e9", "1e10"), ("0", "1e-320"), "centre"),
    "normal": ((), ("-1", "2.5", "1e9", "1e10"), "normal"),
    "radius": ((), ("2.5", "1e9", "1e10", "1e-320"), "radius"),
    "rings": ((), (), "rings"),
    "every": ((), ("1e9",), "every"),
    "stats_start": (("2.5", "1e9", "1e10", "1e300"), ("0", "1e-320"), "stats_start"),
}
VECTORS = {"centre": "0 0 {}", "normal": "0 0 {}"}


class BadInput(PlateCase):

    def setUp(self):
        super().setUp()
        self.data([(0, 0, D, 0, 0, -2.0)])

    def line(self, **entries):
        entries = {**GOOD, **entries}
        return "fix p all plate/stats " + " ".join(f"{k} {v}" for k, v in entries.items() if v is not None)

    def assertRefused(self, result, *words):
        self.assertFails(result, "Fix plate/stats (ID p)", *words)
        self.assertEqual(result.code, 1, result)                        # no signal
        self.assertEqual(result.output.count("ERROR"), 1, result)

    def refused(self, body, *words, ranks=0, **script):
        self.assertRefused(self.liggghts(self.script(f"{body}\nrun 1", **script), ranks, check=False), *words)

    def test_numbers(self):
        """A valid one is taken as it stands: the grain touches the plate at the end, if it is there."""
        inputs = [(entry, number) for entry in ENTRIES for number in NUMBERS]
        results = self.side_by_side(
            self.script(self.line(**{e: VECTORS.get(e, "{}").format(n)}) + "\nrun 300") for e, n in inputs)
        for (entry, number), result in zip(inputs, results):
            with self.subTest(f"{entry} {number}"):
                valid, touching, word = ENTRIES[entry]
                if number in valid + touching:
                    self.assertEqual(result.code, 0, result)
                    row = self.table(f"{result.folder.name}/plate.csv")["all"]
                    self.assertEqual(row["touching"], number in touching)
                else:
                    self.assertRefused(result, word)
                    self.assertNotIn("Setting up", result.output)

    def test_entries(self):
        lines = [("fix p all plate/stats", ("missing keyword wall",)),
                 (self.line(centre="0 0"), ("'normal' is not a number", "centre")),
                 (self.line(normal="0 0 0"), ("normal must not be zero",)),
                 (self.line(normal="1e200 0 0"), ("normal must have a length",)),
                 (self.line(rings="10001"), ("rings must be a whole number >= 1 and <= 10000",))]
        for entry, value in GOOD.items():
            if entry in ("wall", "centre", "normal", "radius", "rings", "file"):
                lines.append((self.line(**{entry: None}), (f"missing keyword {entry}",)))
            lines.append((f"{self.line()} {entry} {value}", (f"'{entry}' is given twice",)))
            lines.append((self.line(**{entry: None, entry + "x": value}), (f"'{entry}x'",)))
            lines.append((self.line(**{entry: None}) + f" {entry}", ("missing", entry)))
        results = self.side_by_side(self.script(f"{line}\nrun 1") for line, _ in lines)
        for (line, words), result in zip(lines, results):
            with self.subTest(line):
                self.assertRefused(result, *words)
        self.refused(self.line(rings="1e9"), "rings", ranks=2)

    def test_surroundings(self):
        plain = "fix w all wall/gran model hertz tangential history primitive type 1 zplane 0.0"
        for ranks in (0, 2):
            self.refused(PLATE.replace("wall w", "wall g"), "'g'", "fix wall/gran", ranks=ranks)
            self.refused(PLATE.replace("wall w", "wall nowhere"), "'nowhere'", "fix wall/gran", ranks=ranks)
            self.refused(PLATE, "store_force yes", wall=plain, ranks=ranks)
            self.refused(PLATE + "\ntimestep 0", "timestep > 0", ranks=ranks)
            self.refused(PLATE + "\nrun_style respa 1", "run_style verlet", ranks=ranks)
            for units in ("lj", "cgs"):
                self.refused(PLATE, "requires units si", units, units=units, ranks=ranks)
        self.liggghts(self.script(f"{PLATE}\nrun 1\nunfix p\nunfix w\nrun 1"))
        self.refused(f"{PLATE}\nrun 1\nunfix w\n{plain}", "store_force yes")

    def test_restart_of_another_plate(self):
        """What the restart file holds is of one plate; another one needs another ID, or statistics that
        begin anew."""
        self.data([(0.0005, 0, D, 0, 0, -2.0), (0.0015, 0, 5 * D, 0, 0, -2.0),
                   (0.0025, 0, 3 * D, 0, 0, -2.0)])    # the third touches when the restart file is written
        second = PLANE.replace("fix w ", "fix v ")
        self.liggghts(self.script(f"{PLATE}\nrun 1000\nwrite_restart r.restart", wall=PLANE + second))
        table = (self.folder / "plate.csv").read_text()
        read = "read_restart r.restart"
        for old, new, word in (("rings 5", "rings 4", "another number of rings"),
                               ("radius 0.005", "radius 0.0051", "another radius"),
                               ("centre 0 0 0", "centre 1e-4 0 0", "another centre"),
                               ("normal 0 0 1", "normal 0 0.1 1", "another normal"),
                               ("wall w", "wall v", "another wall ('w')")):
            self.refused(PLATE.replace(old, new), word, "another fix ID", read=read, ranks=2,
                         wall=PLANE + second)
            self.assertEqual((self.folder / "plate.csv").read_text(), table)
            self.liggghts(self.script(PLATE.replace(old, new).replace("fix p", "fix q") + "\nrun 10",
                                      read=read, wall=PLANE + second))
            (self.folder / "plate.csv").write_text(table)
        one = "group one id 1 2\n" + PLATE.replace("fix p all", "fix p one")
        self.refused(one, "another group ('all')", "another fix ID", read=read, ranks=2)
        anew = PLATE.replace("centre 0 0 0", "centre 0.0014 0 0") + " stats_start 0.0001"
        self.liggghts(self.script(f"{anew}\nrun 2000", read=read))
        event, = self.events()
        self.assertAlmostEqual(event["x"], 0.0001, delta=1e-9)
        row = self.table()["all"]
        self.assertEqual((row["collisions"], row["touching"], row["deleted"]), (1, 0, 0))
        # the same numbers by another way
        again = PLATE.replace("centre 0 0 0", "centre 0 0 1e-18").replace("normal 0 0 1", "normal 0 0 3.3")
        self.liggghts(self.script(f"{PLATE}\nrun 1000\nwrite_restart r.restart", wall=PLANE))
        self.liggghts(self.script(f"{again}\nrun 2000", read=read))
        self.assertEqual(self.table()["all"]["collisions"], 3)
        # version 0.6 wrote no group; what touches outside of this one is over without a result
        self.without_group("r.restart", "old.restart")
        for line, row in ((PLATE, (3, 0, 0)), (one, (2, 0, 1))):
            self.liggghts(self.script(f"{line}\nrun 2000", read="read_restart old.restart"), 2)
            found = self.table()["all"]
            self.assertEqual((found["collisions"], found["touching"], found["deleted"]), row)

    def without_group(self, name, old):
        """A restart file as version 0.6 wrote it: bytes of the fix's part, its size and format, no group."""
        data = (self.folder / name).read_bytes()
        group = struct.pack("<4d", 3, *b"all")
        at, = (match.start() - 12 for match in re.finditer(re.escape(struct.pack("<d", -3.0)), data)
               if struct.unpack_from("<i", data, match.start() - 12)[0]
               == 8 * struct.unpack_from("<d", data, match.start() - 8)[0])
        size = struct.unpack_from("<i", data, at)[0]
        part = data[at + 20:at + 4 + size]
        self.assertEqual(part.count(group), 1)
        (self.folder / old).write_bytes(data[:at] + struct.pack("<i2d", size - 32, size / 8 - 4, -2.0)
                                        + part.replace(group, b"") + data[at + 4 + size:])


if __name__ == "__main__":
    unittest.main()
