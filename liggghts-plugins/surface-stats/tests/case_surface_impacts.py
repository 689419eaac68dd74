# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix surface/stats: single impacts against exact values, against fix plate/stats, and against laws of
wear applied by hand."""
# processors: 2

import math
import unittest

from grainjet import dumps, scripts
from surface_case import D, MASS, PLUGINS, R, STATS, SurfaceCase, inclined, sheet

# oblique impacts, each within one triangle
GRAINS = [(0.0012, 0.0005, R + 2.0 * 200.5e-7, 0.6, 0.3, -2.0),
          (-0.0021, 0.0011, R + 3.0 * 300.5e-7, -0.4, 0.9, -3.0),
          (0.0007, -0.0034, R + 2.5 * 400.5e-7, 0.0, 0.0, -2.5),
          (0.0013, 0.0007, R + 2.0 * 500.5e-7, 0.5, 0.3, -2.0)]


class SurfaceImpacts(SurfaceCase):

    def test_flat_mesh_equals_plate(self):
        """Both fixes on one flat mesh find the same numbers, to the last digit written."""
        self.data(GRAINS)
        self.mesh(sheet())
        self.liggghts(self.script(
            f"{STATS}\nfix p all plate/stats wall w centre 0 0 0 normal 0 0 1 radius 0.005 rings 1 file plate.csv "
            "events plate-events.csv\nrun 3000", plugins=f"{PLUGINS}\nplugin load platestatsplugin.so"))
        mesh, plate = self.table()["all"], self.table("plate.csv")["all"]
        self.assertEqual(mesh["collisions"], 4)
        common = [key for key in plate if not key.startswith("r_")]
        self.assertGreater(len(common), 30)
        for key in common:
            self.assertEqual(f"{mesh[key]}", f"{plate[key]}", key)       # text: some are nan
        for ours, theirs in zip(self.events(), self.events("plate-events.csv")):
            for key in theirs:
                # events of plates have 7 digits
                self.assertAlmostEqual(ours[key], theirs[key], delta=1e-6 * abs(theirs[key]) + 1e-15, msg=key)

    def test_inclined_plate(self):
        """Speed, angle and energies of impacts on a plate turned by 30 degrees; by triangle and in total."""
        degrees = 30.0
        n = (-math.sin(math.radians(degrees)), 0.0, math.cos(math.radians(degrees)))
        self.mesh(sheet(height=inclined(degrees)))
        velocities = [(0.0, 0.0, -3.0), (1.0, 0.5, -2.0), (-0.5, 0.0, -1.0)]
        places = [(0.0012, 0.0005), (0.0013, 0.0004), (-0.0021, -0.0022)]
        grains = []
        for turn, ((x, y), v) in enumerate(zip(places, velocities)):
            back = (1.5 + 2.0 * turn) * D / -sum(a * b for a, b in zip(n, v))     # s, to where it comes from
            touch = (x, y, x * math.tan(math.radians(degrees)))
            grains.append(tuple(t + R * a - w * back for t, a, w in zip(touch, n, v)) + v)
        self.data(grains)
        self.liggghts(self.script(f"{STATS}\nrun 12000", pair=""))
        events = {e["id"]: e for e in self.events()}
        self.assertEqual(len(events), 3)
        total, across = 0.0, 0.0
        for i, v in enumerate(velocities, 1):
            speed = math.hypot(*v)
            normal = -sum(a * b for a, b in zip(n, v))
            self.assertAlmostEqual(events[i]["speed_before"] / speed, 1, delta=1e-8)
            # corners in the STL file have all digits: what is left is rounding, 9 digits are written
            self.assertAlmostEqual(events[i]["angle"], math.degrees(math.acos(normal / speed)), delta=1e-5)
            total += 0.5 * MASS * speed ** 2
            across += 0.5 * MASS * normal ** 2
        row = self.table()["all"]
        self.assertAlmostEqual(row["kinetic_energy_normal"] / across, 1, delta=1e-8)
        self.assertAlmostEqual(row["kinetic_energy_tangential"] / (total - across), 1, delta=1e-7)
        self.assertAlmostEqual(row["impact_mass"] / (3 * MASS), 1, delta=1e-8)
        self.assertAlmostEqual(row["impact_speed_rms"], math.sqrt(sum(math.hypot(*v) ** 2 for v in velocities) / 3),
                               delta=1e-8)
        self.assertAlmostEqual(row["area"], 0.012 ** 2 / n[2], delta=1e-12)
        fields = self.map()
        self.assertEqual(sum(fields["impacts"]), 3)
        for event in events.values():
            triangle = int(event["triangle"])
            inside = [e for e in events.values() if e["triangle"] == triangle]
            self.assertEqual(fields["triangle"][triangle], triangle)
            self.assertEqual(fields["impacts"][triangle], len(inside))
            self.assertAlmostEqual(fields["impact_speed_mean"][triangle],
                                   sum(e["speed_before"] for e in inside) / len(inside), delta=1e-8)
            self.assertAlmostEqual(fields["impact_angle_mean"][triangle],
                                   sum(e["angle"] for e in inside) / len(inside), delta=1e-6)
            self.assertAlmostEqual(fields["normal_force_peak"][triangle],
                                   max(e["normal_force_peak"] for e in inside), delta=1e-9)
            self.assertAlmostEqual(fields["energy_loss"][triangle] / sum(e["energy_loss"] for e in inside), 1, delta=1e-6)
        untouched = [k for k, n in enumerate(fields["impacts"]) if n == 0]
        self.assertTrue(all(math.isnan(fields["impact_speed_mean"][k]) for k in untouched))

    def test_sliding_over_an_edge(self):
        """A grain that crosses edges while it touches is one collision, of the triangle where it began; its
        sliding work is on all of them, and is that of a grain that slides throughout:
        speed of sliding u - 7/2 mu J/m, J the momentum given so far (1 %: as far as the law's lever is shortened)."""
        mu, vn, vt = 0.1, 2.0, 8.0
        flight = 2 * D / vn
        start = -30e-6                                       # an edge is at x = 0, contact takes 50 um and more
        self.data([(start - vt * flight, 0.0004, R + vn * flight, vt, 0.0, -vn)])
        self.mesh(sheet())
        self.liggghts(self.script(f"{STATS.replace('wall w', 'wall w wear archard K 1e-3 hardness 2e9')}\nrun 2000",
                                  mu=mu, e=1.0, dt=5e-8))
        event, = self.events()
        row, fields = self.table()["all"], self.map()
        self.assertEqual((row["collisions"], row["triangles_hit"]), (1, 1))
        first = int(event["triangle"])
        self.assertEqual([k for k, n in enumerate(fields["impacts"]) if n], [first])
        self.assertLess(event["x"], 0)
        worked = [k for k, w in enumerate(fields["sliding_work"]) if w > 0]
        self.assertEqual(len(worked), 2)
        self.assertIn(first, worked)
        self.assertAlmostEqual(sum(fields["sliding_work"]) / event["sliding_work"], 1, delta=1e-8)
        momentum = MASS * 2 * vn
        expected = vt * momentum - 3.5 * mu * momentum ** 2 / (2 * MASS)
        self.assertAlmostEqual(event["sliding_work"] / expected, 1, delta=0.01)
        for k in worked:
            self.assertAlmostEqual(fields["wear_volume"][k], 1e-3 / 2e9 * fields["sliding_work"][k], delta=1e-30)
            self.assertAlmostEqual(fields["wear_depth"][k], fields["wear_volume"][k] / fields["area"][k], delta=1e-20)

    def test_work_of_grains_that_stay(self):
        """A grain that slides on and on has no finished collision, but its work is there, also if it touched
        before the fix was defined: the wall's force times the speed at which its surface slides, step by step."""
        dt, steps = 1e-7, 5000
        self.data([(-0.001, 0.0004, R - 1e-7, 3.0, 0.0, 0.0)])
        self.mesh(sheet())
        self.liggghts(self.script(f"run 200\n{STATS}\n{scripts.dump(1, 'slip.dump', 'id vx omegay f_force_w[3]')}"
                                  f"run {steps}\n", mu=0.2, e=0.5, gravity=1000.0, dt=dt))
        row = self.table()["all"]
        self.assertEqual((row["collisions"], row["touching"]), (0, 0))       # its beginning is not known
        rows = [frame.rows[0] for frame in dumps.frames(self.folder / "slip.dump")][1:]
        self.assertEqual(len(rows), steps)
        work = sum((vx - spin * R) * force * dt for _, vx, spin, force in rows)
        self.assertGreater(work, 0)
        # 10 digits are written
        self.assertAlmostEqual(row["sliding_work"] / work, 1, delta=1e-8)
        self.assertGreater(sum(w > 0 for w in self.map()["sliding_work"]), 1)

    def test_wear_by_hand(self):
        """What a law gives for each event, added up, is the total of table and map."""
        def finnie(e):
            a = math.radians(90 - e["angle"])
            g = math.sin(2 * a) - 3 * math.sin(a) ** 2 if math.tan(a) < 1 / 3 else math.cos(a) ** 2 / 3
            return 1e-10 * e["mass"] * e["speed_before"] ** 2 * g

        def archard(e):
            return 1e-4 / 1e9 * e["sliding_work"]

        laws = {"finnie k 1e-10": finnie, "archard K 1e-4 hardness 1e9": archard,
                "dnv material steel": None, "oka abrasive SiO2 hardness 1.8e9": None,
                "ecrc brinell 150 density 7800 sharpness 0.5": None}
        self.mesh(sheet(height=inclined(50)))
        self.data([(0.0005 + 0.0009 * k, 0.0004 - 0.0003 * k, 0.0062 + 0.0001 * k, 0.3 * k, 0.5, -2.0 - k) for k in range(4)])
        body = ""
        for number, law in enumerate(laws):
            body += (f"fix s{number} all surface/stats mesh m wall w wear {law} file t{number}.csv vtk map{number}.vtp "
                     f"events e{number}.csv\n")
        self.liggghts(self.script(f"{body}run 30000\nvariable w equal f_s0[6]\nprint \"worn $w\"", pair="", mu=0.2), 2)
        for number, (law, by_hand) in enumerate(laws.items()):
            events, row = self.events(f"e{number}.csv"), self.table(f"t{number}.csv")["all"]
            self.assertGreaterEqual(len(events), 4)
            total = sum(e["wear_volume"] for e in events)
            self.assertGreater(total, 0, law)
            if by_hand:
                # 9 digits are written
                for e in events:
                    self.assertAlmostEqual(e["wear_volume"] / by_hand(e), 1, delta=1e-7, msg=law)
            self.assertAlmostEqual(row["wear_volume"] / total, 1, delta=1e-8, msg=law)
            self.assertAlmostEqual(sum(self.map(f"map{number}.vtp")["wear_volume"]) / total, 1, delta=1e-8, msg=law)

    def test_moving_mesh(self):
        """Mesh and grains with one more velocity: the same impacts on the same triangles, as the laws of motion
        do not know the difference but for rounding, and the map lies where the mesh is."""
        self.mesh(sheet())
        self.data(GRAINS)
        self.liggghts(self.script(f"{STATS}\nrun 2000"))
        rest, fields = self.events(), self.map()
        self.assertEqual(len(rest), 4)
        for wind in ((10.0, 0.0, 0.0), (2.0, -3.0, 1.5)):
            self.data([g[:3] + tuple(v + w for v, w in zip(g[3:], wind)) for g in GRAINS])
            self.liggghts(self.script(
                f"{STATS}\nfix v all move/mesh mesh m linear {wind[0]} {wind[1]} {wind[2]}\nrun 2000"), 2)
            for moved, still in zip(self.events(), rest):
                self.assertEqual((moved["id"], moved["triangle"]), (still["id"], still["triangle"]))
                for key in ("speed_before", "speed_after", "angle", "normal_force_peak", "energy_loss", "sliding_work"):
                    self.assertAlmostEqual(moved[key] / still[key] if still[key] else moved[key] + 1, 1, delta=1e-5, msg=key)
            moved = self.map()
            for key in ("impacts", "kinetic_energy_normal", "sliding_work", "area"):
                for a, b in zip(moved[key], fields[key]):
                    self.assertAlmostEqual(a, b, delta=1e-5 * abs(b) + 1e-20, msg=key)
            points = self.points()
            self.assertAlmostEqual(min(points[0::3]), -0.006 + wind[0] * 2e-4, delta=1e-9)
            self.assertAlmostEqual(max(points[2::3]), wind[2] * 2e-4, delta=1e-9)

    def test_coarse_grained(self):
        """A grain of factor 2 stands for 8 particles of half its size, in numbers, mass and wear."""
        self.mesh(sheet())
        self.data(GRAINS)
        oka = STATS.replace("wall w", "wall w wear oka abrasive SiO2 hardness 1.8e9")
        self.liggghts(self.script(f"{oka}\nrun 2000"))
        fine, fine_row = self.events(), self.table()["all"]
        self.liggghts(self.script(f"{oka}\nrun 2000", before="plugin load hertzcgplugin.so\ncoarsegraining 2"))
        row = self.table()["all"]
        self.assertEqual((row["collisions"], row["particles"]), (4, 32))
        self.assertAlmostEqual(row["impact_mass"] / fine_row["impact_mass"], 1, delta=1e-9)
        # the same mass in particles of half the size: (d/d')^0.19; the first touch may come a step later
        for coarse, e in zip(self.events(), fine):
            self.assertAlmostEqual(coarse["wear_volume"] / e["wear_volume"], 0.5 ** 0.19, delta=1e-6)
        particles = [s for s in self.spectra() if s["quantity"] == "kinetic_energy" and s["collisions"]]
        self.assertEqual(sum(s["particles"] for s in particles), 32)
        energy = [0.5 * MASS / 8 * e["speed_before"] ** 2 for e in fine]       # of one particle
        for s in particles:
            self.assertEqual(s["collisions"], sum(s["low"] <= e < s["high"] for e in energy))


if __name__ == "__main__":
    unittest.main()
