# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix plate/stats: collisions that meet a mesh edge, another rank, a restart, the end of the
run, a deletion or a kill; stats_start; bad input."""
# processors: 2

import math
import unittest

import grainjet
from grainjet import dumps
from plate_case import D, MESH, PLATE, PlateCase

class Tracking(PlateCase):

    def test_mesh_plate_equals_primitive_plate(self):
        """A disc of triangles gives the statistics of the plane: grains in the middle of
        triangles to the last digits, and also one that slides over an edge in contact."""
        middle = math.pi / 24
        grains = [(r * math.cos(middle + 2 * math.pi / 24 * k), r * math.sin(middle + 2 * math.pi / 24 * k),
                   D + 1e-4 * k, 0.2 * k, -0.1 * k, -2.0) for k, r in enumerate((0.0015, 0.0025, 0.0035))]
        grains.append((0.0042, -10e-6 - (D / 2) / 2.0 * 2.5, D, 0.0, 2.5, -2.0))
        self.data(grains)
        self.disc()
        tables = []
        for wall in ({}, {"wall": MESH}):
            self.liggghts(self.script(f"{PLATE}\nrun 4000", **wall), 2)
            tables.append(self.table()["all"])
            self.assertEqual([e["id"] for e in self.events()], [1, 4, 2, 3])
        plane, mesh = tables
        self.assertEqual(mesh["collisions"], 4)
        for key, value in plane.items():
            # coordinates in the STL file and the edge's two triangles leave some 1e-3
            if not math.isnan(value) and key.endswith(("_mean", "collisions", "touching", "deleted")):
                self.assertAlmostEqual(mesh[key], value, delta=2e-3 * abs(value) + 1e-12, msg=key)

    def test_several_plates_on_one_wall(self):
        """Two round plates on the same plane, each sees its own."""
        second = ("fix q all plate/stats wall w centre 0.004 0 0 normal 0 0 -1 radius 0.001 rings 1 "
                  "file second.csv")
        first = PLATE.replace("radius 0.005", "radius 0.001")
        self.data([(0, 0, D, 0, 0, -2.0), (0.0042, 0, 2 * D, 0, 0, -2.0),
                   (0.0038, 0, 3 * D, 0, 0, -2.0), (0.002, 0, D, 0, 0, -2.0)])
        self.liggghts(self.script(f"{first}\n{second}\nrun 3000"))
        self.assertEqual(self.table()["all"]["collisions"], 1)
        self.assertEqual(self.table("second.csv")["all"]["collisions"], 2)
        self.assertGreater(self.table("second.csv")["all"]["normal_force_mean"], 0)

    def test_migration_in_mid_collision(self):
        """A grain changes rank while it touches: the same line in the events file as on one
        rank, to the last digit."""
        vx, vz = 5.0, -2.0
        flight = (D / 2) / 2.0
        # touches at x = -25 um, travels about 50 um in contact: the ranks' border is at 0
        self.data([(-25e-6 - vx * flight, 0, D, vx, 0.0, vz)])
        written = []
        for ranks in (1, 2):
            self.liggghts(self.script(f"""
                {PLATE}
                dump d all custom 1 path.dump id x f_force_w[3]
                neigh_modify every 1 delay 0 check no
                run 600"""), ranks)
            written.append((self.folder / "events.csv").read_text())
        self.assertEqual(written[0].count("\n"), 2)
        self.assertEqual(written[1], written[0])
        rows = [row for frame in dumps.frames(self.folder / "path.dump") for row in frame.rows]
        touching = [x for _, x, force in rows if force > 0]
        self.assertLess(min(touching), -1e-5)
        self.assertGreater(max(touching), 1e-5)

    def test_restart_in_mid_collision(self):
        """Written in the middle of a contact, read by another number of ranks: the rest of the
        run is as without, bit for bit, statistics and events file."""
        self.data([(0.0005, 0, D, 1.0, 0, -2.0), (0.0015, 0, 3 * D, 0, 1.0, -2.0),
                   (0.0025, 0, 5 * D, 1.0, 1.0, -2.0)])
        body = f"{PLATE}\nrun 1050\n{{}}\nrun 2000"
        middle = self.liggghts(self.script(body.format(
            "write_restart mid.restart\nvariable t equal f_p[2]\nprint \"touching $t\"")))
        self.assertIn("touching 1", middle.output)
        self.assertEqual(len(self.events()), 3)
        through = (self.folder / "plate.csv").read_text(), (self.folder / "events.csv").read_text()
        for ranks in (1, 2):
            # the events file now holds lines that the restarted run writes again
            self.liggghts(self.script(f"{PLATE}\nrun 2000", read="read_restart mid.restart"), ranks)
            self.assertEqual((self.folder / "plate.csv").read_text(), through[0])
            self.assertEqual((self.folder / "events.csv").read_text(), through[1])

    def test_restart_with_changes(self):
        """Other rings: refused. Another stats_start: statistics begin anew. Another or a shorter
        events file: refused and left alone."""
        self.data([(0.0005, 0, D, 0, 0, -2.0), (0.0015, 0, 3 * D, 0, 0, -2.0)])
        self.liggghts(self.script(f"{PLATE}\nrun 1000\nwrite_restart r.restart"))
        read = "read_restart r.restart"
        result = self.liggghts(self.script(PLATE.replace("rings 5", "rings 4"), read=read), check=False)
        self.assertFails(result, "plate/stats", "another number of rings")
        for other in ("time\n", 1000 * "x" + "\n"):
            (self.folder / "events.csv").write_text(other)
            result = self.liggghts(self.script(PLATE, read=read), check=False)
            self.assertFails(result, "events.csv", "not the one")
            self.assertEqual((self.folder / "events.csv").read_text(), other)
        self.liggghts(self.script(f"{PLATE} stats_start 0.0001\nrun 2000".replace("events.csv", "e2.csv"),
                                  read=read))
        row = self.table()["all"]
        self.assertEqual(row["collisions"], 1)
        self.assertAlmostEqual(row["time"], 2000e-7, delta=1e-12)

    def test_still_touching_at_the_end(self):
        """Counts as touching, not as a collision."""
        self.data([(0, 0, D, 0, 0, -2.0)])
        self.liggghts(self.script(f"{PLATE}\nrun 250"))
        row = self.table()["ring1"]
        self.assertEqual((row["collisions"], row["touching"], row["deleted"]), (0, 1, 0))
        self.assertEqual(self.events(), [])

    def test_deleted_while_touching(self):
        """Counts as deleted; the others are not disturbed."""
        self.data([(0, 0, D, 0, 0, -2.0), (0.0015, 0, 4 * D, 0, 0, -2.0)])
        result = self.liggghts(self.script(f"""
            {PLATE}
            run 250
            group gone id 1
            delete_atoms group gone compress no
            run 2500
            variable c equal f_p[1]
            variable t equal f_p[2]
            variable d equal f_p[3]
            print "vector $c $t $d" """), 2)
        self.assertIn("vector 1 0 1", result.output)
        table = self.table()
        row = table["ring1"]
        self.assertEqual((row["collisions"], row["touching"], row["deleted"]), (0, 0, 1))
        self.assertEqual((table["ring2"]["collisions"], table["ring2"]["deleted"]), (1, 0))

    def test_stats_start(self):
        """Collisions that begin earlier do not count, and time counts from there."""
        self.data([(0.0005 + 0.001 * i, 0, D / 2 + 2.0 * 5e-5 * (i + 1), 0, 0, -2.0) for i in range(4)])
        self.liggghts(self.script(f"{PLATE} stats_start 0.000125\nrun 3000"))
        table = self.table()
        self.assertEqual([table[f"ring{i}"]["collisions"] for i in range(1, 6)], [0, 0, 1, 1, 0])
        self.assertAlmostEqual(table["all"]["time"], 3e-4 - 1.25e-4, delta=1e-12)
        self.assertEqual(len(self.events()), 2)

    def test_contact_from_before_does_not_count(self):
        """A grain that touches already when the fix is defined has no known beginning."""
        self.data([(0, 0, D, 0, 0, -2.0), (0.0015, 0, 4 * D, 0, 0, -2.0)])
        self.liggghts(self.script(f"run 250\n{PLATE}\nrun 2500"))
        row = self.table()["all"]
        self.assertEqual((row["collisions"], row["touching"], row["deleted"]), (1, 0, 0))

    def test_killed_run_leaves_a_readable_events_file(self):
        """Killed in full flow, early and late: every line is complete and the statistics file whole."""
        grains = [(-0.004 + 0.0004 * i, -0.004 + 0.0004 * j, D * (1 + 0.01 * ((7 * i + j) % 97)), 0, 0, -2.0)
                  for i in range(20) for j in range(20)]
        self.data(grains)
        script = self.script(f"{PLATE.replace('file', 'every 100 file')}\nrun 100000000", gravity=2e4, pair="")
        (self.folder / "in.test").write_text(script)
        events = self.folder / "events.csv"
        for size in (20000, 60000):
            for name in ("events.csv", "plate.csv"):
                (self.folder / name).unlink(missing_ok=True)
            with grainjet.start(["liggghts-plugins", "-in", "in.test"], self.folder, self.folder / "log") as run:
                run.wait_for(lambda: events.exists() and events.stat().st_size > size, f"{size} bytes of events")
            lines = events.read_text().split("\n")
            self.assertEqual(lines[-1], "")
            self.assertGreater(len(lines), 100)
            for line in lines[1:-1]:
                self.assertEqual(len([float(w) for w in line.split(",")]), 14, line)
            self.assertEqual(len(self.table()), 6)

    def test_defined_again(self):
        """The same ID once more replaces the fix, unfix removes it: statistics begin anew."""
        self.data([(0.0005, 0, D, 0, 0, -2.0), (0.0015, 0, 3 * D, 0, 0, -2.0)])
        self.liggghts(self.script(f"{PLATE}\nrun 800\n{PLATE}\nunfix p\n{PLATE}\nrun 2000"))
        self.assertEqual(self.table()["all"]["collisions"], 1)
        self.assertEqual([e["id"] for e in self.events()], [2])

    def test_plate_beside_the_wall_is_noticed(self):
        """Contacts of the wall, none on the plate: a warning, once."""
        self.data([(0, 0, D, 0, 0, -2.0)])
        result = self.liggghts(self.script(
            f"{PLATE.replace('centre 0 0 0', 'centre 0 0 0.01')}\nneigh_modify every 1 check no\n"
            "run 250\nrun 10\nrun 10"))
        self.assertEqual(result.output.count("none at the plate so far"), 1)


if __name__ == "__main__":
    unittest.main()
