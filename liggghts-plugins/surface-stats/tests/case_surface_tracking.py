# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix surface/stats: any number of ranks, restarts, grains over edges and in corners, several meshes, files."""
# processors: 2
# label: long

import json
import math
import re
import struct
import unittest

from grainjet import scripts
from surface_case import D, R, STATS, SurfaceCase, inclined, sheet, wall

FILES = ("table.csv", "events.csv", "spectra.csv", "map.vtp")


def hills(x, y):
    return 4e-4 * math.sin(700 * x) * math.cos(500 * y)


def shower(n=150):
    """Grains over the sheet, each with a velocity of its own."""
    grains = []
    for i in range(n):
        x, y = 0.005 * math.cos(2.4 * i) * math.sqrt(i / n), 0.005 * math.sin(2.4 * i) * math.sqrt(i / n)
        grains.append((x, y, 8e-4 + 2e-5 * i, math.sin(i), math.cos(3 * i), -1.5 - 0.1 * (i % 11)))
    return grains


class SurfaceTracking(SurfaceCase):

    def written(self):
        return [(self.folder / name).read_bytes() for name in FILES]

    def test_ranks(self):
        """All files are the same, bit for bit, on 0 (no mpirun), 1, 2 and 4 ranks, with grains sorted or not. In
        valleys grains touch several triangles at once, whose forces LIGGGHTS adds in an order of the rank:
        there the same counts, and values to the rounding that this leaves (chaos of later bounces: 1e-8)."""
        stats = STATS.replace("wall w", "wall w wear oka abrasive SiO2 hardness 2e9")
        for height in (inclined(10), hills):
            self.mesh(sheet(n=9, half=0.0071, height=height))
            self.data(shower())
            first = None
            for ranks in (0, 1, 2, 4):
                self.liggghts(self.script(f"{stats}\nrun 5000\nrun 5000", pair="", mu=0.1, dt=2e-7, gravity=5000.0,
                                          processors="2 2 1" if ranks == 4 else "* 1 1",
                                          sort="0 0" if ranks == 1 else "10 0.001"), ranks)
                row = self.table()["all"]
                if first is None:
                    first, first_row = self.written(), row
                    self.assertGreater(row["collisions"], 180)
                    self.assertGreater(row["triangles_hit"], 50)
                    self.assertGreater(row["sliding_work"], 0)
                    self.assertEqual(row["deleted"], 0)
                elif height is hills:
                    for key, value in first_row.items():
                        self.assertAlmostEqual(row[key], value, delta=1e-8 * abs(value), msg=(ranks, key))
                else:
                    self.assertEqual(self.written(), first, ranks)

    def test_restart(self):
        """Written while grains touch, read by another number of ranks: the rest of the run is as without."""
        self.mesh(sheet(n=9, half=0.0071, height=inclined(10)))
        self.data(shower())
        stats = STATS.replace("wall w", "wall w wear archard K 1e-3 hardness 2e9").replace("map.vtp", "map*.vtp")
        settings = {"pair": "", "mu": 0.1, "dt": 2e-7, "gravity": 5000.0}
        middle = self.liggghts(self.script(
            f"{stats}\nrun 3000\nwrite_restart mid.restart\nvariable t equal f_s[2]\nprint \"touching $t\"\nrun 4000",
            **settings))
        self.assertGreaterEqual(int(re.search("touching ([0-9]+)", middle.output).group(1)), 1)
        names = ("table.csv", "events.csv", "spectra.csv", "map7000.vtp", "map.pvd")
        through = [(self.folder / name).read_bytes() for name in names]
        self.assertGreater(self.table()["all"]["collisions"], 100)
        for ranks in (1, 2):
            self.liggghts(self.script(f"{stats}\nrun 4000", read="read_restart mid.restart", **settings), ranks)
            for name, text in zip(names, through):
                self.assertEqual((self.folder / name).read_bytes(), text, name)
        # statistics of something else are refused, or begin anew
        for old, new, words in (("hardness 2e9", "hardness 3e9", "law of wear"),
                                ("wear archard K 1e-3 hardness 2e9", "", "law of wear"),
                                ("spectra spectra.csv", "spectra spectra.csv speed 1 10 5", "other bins")):
            result = self.liggghts(self.script(stats.replace(old, new), read="read_restart mid.restart", **settings), 2,
                                   check=False)
            self.assertFails(result, "Fix surface/stats (ID s)", words, "another fix ID")
        self.liggghts(self.script(f"{stats.replace('hardness 2e9', 'hardness 3e9')} stats_start 1e-4\nrun 4000",
                                  read="read_restart mid.restart", **settings))
        self.assertAlmostEqual(self.table()["all"]["time"], 4000 * 2e-7, delta=1e-12)

    def test_over_edges_and_corners(self):
        """Exactly over an edge or a corner of a flat mesh the impact belongs to the triangle with the lowest ID,
        whatever order triangles have on a rank."""
        triangles = sheet(n=4)
        self.mesh(triangles)
        places = [(0.0015, 0.0015), (0.0, 0.0), (0.003, 0.0015), (-0.003, -0.003), (0.0045, 0.0045), (-0.0012, 0.003)]
        self.data([(x, y, D + 1e-4 * k, 0.0, 0.0, -2.0) for k, (x, y) in enumerate(places)])

        def holds(triangle, x, y):
            """The place is in the triangle or on its edge."""
            (x0, y0, _), (x1, y1, _), (x2, y2, _) = triangle
            sides = [(a - c) * (y - d) - (b - d) * (x - c) for (a, b), (c, d) in
                     (((x1, y1), (x0, y0)), ((x2, y2), (x1, y1)), ((x0, y0), (x2, y2)))]
            return min(sides) >= -1e-12 or max(sides) <= 1e-12

        for ranks in (0, 2, 4):
            self.liggghts(self.script(f"{STATS}\nrun 6000", processors="2 2 1" if ranks == 4 else "* 1 1"), ranks)
            events = {e["id"]: e for e in self.events()}
            for i, (x, y) in enumerate(places, 1):
                here = [k for k, triangle in enumerate(triangles) if holds(triangle, x, y)]
                self.assertGreater(len(here), 1)
                self.assertEqual(events[i]["triangle"], here[0], (ranks, x, y))

    def test_the_triangle_below_the_grain(self):
        """Of a mesh that fills a periodic box, at rest and moved through its boundary: the triangle of each impact
        is the one whose corners hold the grain's place, the mesh drawn back to where it began."""
        n, half, speed = 8, 0.01, 3.0
        self.mesh(sheet(n, half))
        self.data([(1.9 * x + 1e-5, 1.9 * y, z, 5 * u, 5 * v, w) for x, y, z, u, v, w in shower()])
        for wind in (0.0, speed):
            move = f"fix v all move/mesh mesh m linear {wind} 0 0" if wind else ""
            self.liggghts(self.script(f"{STATS}\n{move}\nrun 4000\nrun 4000", pair="", dt=2e-7, gravity=5000.0,
                                      boundary="p p f"), 2)
            events = self.events()
            self.assertGreaterEqual(len(events), 150)
            for e in events:
                # a square is cut from its lowest corner to its highest one
                a = ((e["x"] - wind * e["time"] + half) % (2 * half)) * n / (2 * half)
                b = (e["y"] + half) * n / (2 * half)
                below = 2 * (n * int(a) + int(b)) + (a % 1 <= b % 1)
                self.assertEqual(e["triangle"], below, (wind, e))

    def test_two_meshes_in_a_corner(self):
        """A grain that flies into a corner of two meshes touches one, then also the other: one collision, of the
        mesh that it touches first. A mesh of the wall that is not named counts nothing."""
        self.mesh(sheet(), "floor.stl")
        side = scripts.rectangle((0.002, -0.006, -0.001), (0.002, 0.006, -0.001), (0.002, 0.006, 0.005), (0.002, -0.006, 0.005))
        self.mesh(side, "side.stl")
        meshes = wall(("floor", "floor.stl"), ("side", "side.stl"))
        # floor at 40 us, side at 42 us
        self.data([(0.002 - R - 1.0 * 42e-6, 0.0011, R + 2.0 * 40e-6, 1.0, 0.0, -2.0), (0.0, 0.0003, D, 0.0, 0.0, -2.0),
                   (0.0015, -0.0011, 0.002, 3.0, 0.0, 0.0)])
        both = STATS.replace("mesh m", "mesh floor mesh side")
        self.liggghts(self.script(f"{both}\nrun 3000", meshes))
        table = self.table()
        self.assertEqual([e["mesh"] for e in sorted(self.events(), key=lambda e: e["id"])], ["floor", "floor", "side"])
        self.assertEqual([table[r]["collisions"] for r in ("all", "floor", "side")], [3, 2, 1])
        self.assertEqual([table[r]["triangles"] for r in ("all", "floor", "side")], [34, 32, 2])
        self.assertAlmostEqual(table["all"]["area"], table["floor"]["area"] + table["side"]["area"], delta=1e-15)
        fields = self.map()
        self.assertEqual([sum(n for n, m in zip(fields["impacts"], fields["mesh"]) if m == k) for k in (0, 1)], [2, 1])
        self.liggghts(self.script(f"{STATS.replace('mesh m', 'mesh side')}\nrun 3000", meshes))
        # the first grain touches the side a little later
        self.assertEqual([e["id"] for e in self.events()], [1, 3])

    def test_touching_deleted_and_started(self):
        """As with plates: what goes on, what was deleted in contact, what began before stats_start."""
        self.mesh(sheet())
        self.data([(0.0005 + 0.001 * i, 0.0002, R + 2.0 * 5e-5 * (i + 1), 0, 0, -2.0) for i in range(4)])
        self.liggghts(self.script(f"{STATS} stats_start 0.000125\nrun 3000"))
        row = self.table()["all"]
        self.assertEqual((row["collisions"], row["touching"], row["deleted"]), (2, 0, 0))
        self.assertAlmostEqual(row["time"], 3e-4 - 1.25e-4, delta=1e-12)
        result = self.liggghts(self.script(f"""
            {STATS}
            run 550
            group gone id 1
            delete_atoms group gone compress no
            run 1
            variable c equal f_s[1]
            variable t equal f_s[2]
            variable d equal f_s[3]
            print "vector $c $t $d" """), 2)
        self.assertIn("vector 0 0 1", result.output)

    def test_a_step_again(self):
        """The same step after reset_timestep is another output: the map has what the table has."""
        self.mesh(sheet())
        self.data([(0.0012, 0.0005, D, 0, 0, -2.0), (-0.0012, 0.0005, R + 2.0 * 9e-5, 0, 0, -2.0)])
        self.liggghts(self.script(f"{STATS}\nrun 800\nreset_timestep 0\nrun 800"))
        self.assertEqual(self.table()["all"]["collisions"], 2)
        self.assertEqual(sum(self.map()["impacts"]), 2)

    def test_with_hertz_cg(self):
        """fix hertz/cg makes neighbour lists when it sees fit; nothing is missed: the impacts of the stock pair style."""
        self.mesh(sheet(n=9, half=0.0071, height=inclined(10)))
        self.data(shower(100))
        events = []
        for more in ({}, {"pair": "fix c all hertz/cg", "plugins": "plugin load surfacestatsplugin.so\nplugin load hertzcgplugin.so"}):
            self.liggghts(self.script(f"{STATS}\nrun 5000", dt=2e-7, gravity=5000.0, **more), 2)
            events.append(self.events())
        self.assertGreater(len(events[0]), 80)
        self.assertEqual([(e["id"], e["triangle"]) for e in events[1]], [(e["id"], e["triangle"]) for e in events[0]])
        for found, expected in zip(*events):
            self.assertAlmostEqual(found["speed_before"] / expected["speed_before"], 1, delta=1e-6)

    def test_empty_box(self):
        """No grain, ever: files of nothing, on ranks with and without triangles, of a mesh that moves."""
        self.mesh(sheet())
        for ranks in (0, 2):
            self.liggghts(self.script(
                f"{STATS}\nfix v all move/mesh mesh m linear 1 0 0.1\nrun 200\nrun 200",
                read="region box block -0.01 0.01 -0.01 0.01 -0.001 0.02 units box\ncreate_box 1 box"), ranks)
            row = self.table()["all"]
            self.assertEqual((row["collisions"], row["touching"], row["deleted"], row["triangles_hit"]), (0, 0, 0, 0))
            self.assertAlmostEqual(row["area"], 0.012 ** 2, delta=1e-15)
            self.assertEqual(sum(self.map()["impacts"]), 0)

    def test_series_and_formats(self):
        """A star gives a series with an index; the legacy format holds the same numbers."""
        self.mesh(sheet())
        self.data([(0.0012, 0.0005, D, 0.6, 0.3, -2.0)])
        for name, index in (("maps_*.vtp", "maps.pvd"), ("maps_*.vtk", "maps.vtk.series")):
            self.liggghts(self.script(f"{STATS.replace('map.vtp', name).replace('every 1000', 'every 500')}\nrun 1700"))
            text = (self.folder / index).read_text()
            files = [name.replace("*", str(step)) for step in (500, 1000, 1500, 1700)]
            self.assertEqual(re.findall(r"maps_[0-9]+\.vt[pk]", text), files)
            if index.endswith("series"):
                self.assertEqual([f["time"] for f in json.loads(text)["files"]], [5e-5, 1e-4, 1.5e-4, 1.7e-4])
            self.assertTrue(all((self.folder / file).exists() for file in files))
        fields = self.map("maps_1700.vtp")
        self.assertEqual(sum(fields["impacts"]), 1)
        legacy = (self.folder / "maps_1700.vtk").read_bytes()
        for name in ("impacts", "kinetic_energy_normal", "area"):
            head = f"{name} 1 32 double\n".encode()
            start = legacy.index(head) + len(head)
            self.assertEqual(list(struct.unpack_from(">32d", legacy, start)), fields[name])


if __name__ == "__main__":
    unittest.main()
