# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix plate/stats on a wall that moves: speeds, angles and energies against the surface, a plate
that goes along with its mesh."""
# processors: 2
# label: long

import math
import unittest

from grainjet import scripts
from plate_case import D, MASS, MESH, PLANE, PLATE, PlateCase

R = D / 2
COLUMNS = ("speed_before", "speed_after", "angle", "normal_force_peak", "tangential_force_peak", "duration",
           "normal_force", "tangential_force", "energy_loss")
# an oblique impact on each of a few triangles; the first touch is in mid-step, where rounding
# does not bring it into the next one
GRAINS = [(0.0012, 0.0005, R + 2.0 * 200.5e-7, 0.6, 0.3, -2.0),
          (-0.0021, 0.0011, R + 3.0 * 300.5e-7, -0.4, 0.9, -3.0),
          (0.0007, -0.0033, R + 2.5 * 400.5e-7, 0.0, 0.0, -2.5)]


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


class MovingPlate(PlateCase):

    def setUp(self):
        super().setUp()
        self.disc()

    def hit(self, grains, move="", wall=MESH, steps=1500, ranks=0, plate=PLATE, bottom=-0.001, **more):
        """Events of these grains on a wall, with a line that moves it."""
        self.data(grains, bottom=bottom)
        self.liggghts(self.script(f"{plate}\n{move}\nrun {steps}", wall=wall,
                                  **{"e": 0.8, "mu": 0.3, **more}), ranks)
        return self.events()

    def assertSameEvents(self, found, expected, relative, columns=COLUMNS):
        self.assertEqual([e["id"] for e in found], [e["id"] for e in expected])
        for f, e in zip(found, expected):
            for column in columns:
                self.assertAlmostEqual(f[column], e[column], delta=relative * abs(e[column]) + 1e-15,
                                       msg=(column, f, e))

    def test_uniform_motion_changes_nothing(self):
        """Grains and plate with one more velocity, along the plate or its normal: the events of the
        plate at rest, energies as well, as the laws of motion do not know the difference, but for
        the rounding of larger positions and 7 digits in the file."""
        rest = self.hit(GRAINS)
        self.assertEqual(len(rest), 3)
        for wind in ((10.0, 0.0, 0.0), (0.0, 0.0, 1.0), (2.0, -3.0, -1.5)):
            moved = [g[:3] + tuple(v + w for v, w in zip(g[3:], wind)) for g in GRAINS]
            for mover in (f"linear {wind[0]} {wind[1]} {wind[2]}",
                          "linear/variable v_vx v_vy v_vz"):
                variables = "\n".join(f"variable v{c} equal {w}" for c, w in zip("xyz", wind))
                events = self.hit(moved, f"{variables}\nfix mv all move/mesh mesh disc {mover}")
                self.assertSameEvents(events, rest, 1e-5)
                self.assertSameEvents(events, rest, 1e-5, "xy")    # from the centre, wherever that is
            row = self.table()["all"]
            self.assertEqual((row["collisions"], row["touching"], row["deleted"]), (3, 0, 0))

    def test_a_workpiece_under_a_nozzle(self):
        """20 m/s straight down on a plate that passes at 10 m/s, or that comes up at 1 m/s."""
        for move, speed, angle in (("10 0 0", math.hypot(20, 10), math.degrees(math.atan2(10, 20))),
                                   ("0 0 1", 21, 0)):
            event, = self.hit([(0, 0, 5 * D, 0, 0, -20.0)], f"fix mv all move/mesh mesh disc linear {move}",
                              dt=2e-8, young=5e7)
            self.assertAlmostEqual(event["speed_before"], speed, delta=1e-5)
            self.assertAlmostEqual(event["angle"], angle, delta=1e-4)
            # what is lost is less than what the grain brought, seen from the plate
            self.assertLess(event["energy_loss"], 0.5 * MASS * speed ** 2)
            if angle == 0:
                lost = 0.5 * MASS * (speed ** 2 - event["speed_after"] ** 2)
                self.assertAlmostEqual(event["energy_loss"] / lost, 1, delta=1e-5)

    def test_vibrations(self):
        """Along the normal: speed against the surface, whose velocity LIGGGHTS' formula gives."""
        amplitude, period, phase = 4e-5, 6e-4, 0.7
        w = 2 * math.pi / period
        for mover, surface in (
                (f"wiggle amplitude 0 0 {amplitude} period {period}",
                 lambda t: amplitude * w * math.cos(w * t)),
                (f"viblin axis 0 0 1 order 1 amplitude {amplitude} phase {phase} period {period}",
                 lambda t: -amplitude * w * math.sin(w * t + phase))):
            for flight in (1e-4, 2.2e-4, 3.7e-4):
                event, = self.hit([(0.001, 0.0003, R + 2.0 * flight, 0, 0, -2.0)],
                                  f"fix mv all move/mesh mesh disc {mover}", steps=6000)
                self.assertAlmostEqual(event["speed_before"], 2.0 + surface(event["time"]), delta=1e-5)
                self.assertAlmostEqual(event["angle"], 0, delta=1e-5)
                end = event["time"] + event["duration"]
                # energies are against the surface of their moment
                lost = 0.5 * MASS * (event["speed_before"] ** 2 - event["speed_after"] ** 2)
                self.assertAlmostEqual(event["energy_loss"], lost, delta=1e-5 * MASS)
                self.assertGreater(abs(surface(end) - surface(event["time"])), 0.001)

    def test_rotations(self):
        """Spinning and tilting discs: velocity of the surface at the contact, a normal and axes
        that turn. Period and angle as the mover's formula gives them at the contact."""
        period, beat, swing = 0.012, 0.003, 8.0
        w, b, small = 2 * math.pi / period, 2 * math.pi / beat, math.radians(swing)
        whole = lambda t: (w * t, w)
        rocking = lambda t: (small * math.sin(b * t), small * b * math.cos(b * t))
        vibrating = lambda t: (small * (math.cos(b * t) - 1), -small * b * math.sin(b * t))
        for mover, axis, motion in (
                (f"rotate origin 0 0 0 axis 0 0 1 period {period}", (0, 0, 1), whole),
                (f"rotate origin 0 0 0 axis 0 1 0 period {period}", (0, 1, 0), whole),
                ("rotate/variable origin 0 0 0 axis 0 1 0 omega v_omega", (0, 1, 0), whole),
                (f"riggle origin 0 0 0 axis 0 1 0 period {beat} amplitude {swing}", (0, 1, 0), rocking),
                (f"vibrot origin 0 0 0 axis 0 1 0 order 1 amplitude {small} phase 0 period {beat}",
                 (0, 1, 0), vibrating)):
            with self.subTest(mover):
                velocity = (0.5, 0.2, -2.0)
                event, = self.hit([(0.0011, 0.0004, 0.001 if axis[1] else 2 * D, *velocity)],
                                  f"variable omega equal {w}\nfix mv all move/mesh mesh disc {mover}",
                                  steps=9000, bottom=-0.004)
                angle, rate = motion(event["time"])
                c, s = math.cos(angle), math.sin(angle)
                if axis[2]:
                    first, second, n = (c, s, 0), (-s, c, 0), (0, 0, 1)
                else:
                    first, second, n = (c, 0, -s), (0, 1, 0), (s, 0, c)
                point = [event["x"] * p + event["y"] * q for p, q in zip(first, second)]
                surface = cross([rate * x for x in axis], point)
                relative = [v - u for v, u in zip(velocity, surface)]
                speed = math.sqrt(dot(relative, relative))
                # steps of LIGGGHTS' rotation add up to an angle that differs by one step in riggle
                self.assertAlmostEqual(event["speed_before"], speed, delta=2e-4)
                self.assertAlmostEqual(event["angle"],
                                       math.degrees(math.acos(abs(dot(relative, n)) / speed)), delta=0.02)
                self.assertGreater(max(abs(u) for u in surface), 0.1)

    def test_belts(self):
        """A surface that moves without going anywhere: surface_vel, surface_ang_vel of a mesh, shear
        of a primitive wall. As the plate at rest under grains that move the other way."""
        wind, turn = 3.0, 600.0
        rest = self.hit([g[:3] + (g[3] - wind, g[4], g[5]) for g in GRAINS])
        belts = [MESH.replace("type 1\n", f"type 1 surface_vel {wind} 0 0\n", 1),
                 "variable belt equal 3\n" + MESH.replace("type 1\n", "type 1 surface_vel 3 0 0\n", 1),
                 PLANE.replace("store_force", f"shear x {wind} store_force")]
        for wall in belts:
            events = self.hit(GRAINS, wall=wall)
            self.assertSameEvents(events, rest, 1e-5)
        wall = MESH.replace("type 1\n", f"type 1 surface_ang_vel origin 0 0 0 axis 0 0 1 omega {turn}\n", 1)
        for event in self.hit(GRAINS, wall=wall):
            v = GRAINS[int(event["id"]) - 1][3:]
            relative = (v[0] + turn * event["y"], v[1] - turn * event["x"], v[2])
            self.assertAlmostEqual(event["speed_before"], math.sqrt(dot(relative, relative)), delta=1e-4)

    def test_shearing_cylinder(self):
        """Along its axis and around it, the latter as an angular velocity."""
        reach = 0.009
        wall = f"fix w all wall/gran model hertz tangential history primitive type 1 zcylinder {reach} 0 0 " \
               "shear {} store_force yes"
        plate = PLATE.replace("centre 0 0 0 normal 0 0 1", f"centre {reach} 0 0.005 normal 1 0 0")
        for shear, speed in (("z 3", 3.0), ("x 300", 300 * reach), ("y 300", 300 * reach)):
            event, = self.hit([(reach - R - 1e-4, 0, 0.005, 2.0, 0, 0)], wall=wall.format(shear), plate=plate)
            # the law takes the distance of the grain's centre from the axis for the wall's: R/reach less
            self.assertAlmostEqual(event["speed_before"], math.hypot(2, speed), delta=speed * R / reach)

    def test_two_movers_on_one_mesh(self):
        """A spinning disc that is carried sideways: the movers' velocities add up."""
        turn, wind = 500.0, 4.0
        period = 2 * math.pi / turn
        event, = self.hit([(0.0015, 0.0, 2 * D, wind, 0, -2.0)], f"""
            fix mv1 all move/mesh mesh disc linear {wind} 0 0
            fix mv2 all move/mesh mesh disc rotate origin 0 0 0 axis 0 0 1 period {period!r}""")
        reach = math.hypot(event["x"], event["y"])
        self.assertAlmostEqual(reach, 0.0015, delta=1e-6)    # against the centre that goes along
        self.assertAlmostEqual(event["speed_before"], math.hypot(2.0, turn * reach), delta=1e-3)

    def test_only_one_of_two_meshes_moves(self):
        """A workpiece over a table, in one wall: what hits the workpiece counts against it, on the
        plate that went along; what hits the table counts against the table."""
        self.disc(radius=0.002, height=0.001, name="piece.stl")
        wall = """
            fix disc all mesh/surface file disc.stl type 1
            fix piece all mesh/surface file piece.stl type 1
            fix w all wall/gran model hertz tangential history mesh n_meshes 2 meshes disc piece store_force yes
        """
        plates = PLATE.replace("centre 0 0 0", "centre 0 0 0.001").replace("0.005", "0.002")
        plates += "\nfix q all plate/stats wall w centre 0 0 0 normal 0 0 1 radius 0.005 rings 1 " \
                  "file table.csv events table-events.csv"
        wind = 5.0
        grains = [(0.0005 + wind * 3e-5, 0, 0.001 + R + 6e-5, 0, 0, -2.0),
                  (-0.004, 0, R + 1e-4, 0, 0, -2.0)]
        for ranks in (0, 2):
            piece, = self.hit(grains, f"fix mv all move/mesh mesh piece linear {wind} 0 0", wall=wall,
                              plate=plates, ranks=ranks)
            table, = self.events("table-events.csv")
            self.assertEqual((piece["id"], table["id"]), (1, 2))
            self.assertAlmostEqual(piece["speed_before"], math.hypot(2, wind), delta=1e-6)
            self.assertAlmostEqual(piece["x"], 0.0005, delta=2e-6)
            self.assertAlmostEqual(table["speed_before"], 2, delta=1e-9)
            self.assertEqual(table["angle"], 0)

    def test_a_thin_workpiece(self):
        """Thinner than a grain: what hits the table where the plate was is not on the plate. A workpiece
        of two meshes that move alike is one plate."""
        thin = R / 2
        for name, half in (("left.stl", -1), ("right.stl", 1)):
            (self.folder / name).write_text(scripts.stl(
                ((0, -0.002, thin), (0, 0.002, thin), (half * 0.002, 0, thin))))
        wall = """
            fix disc all mesh/surface file disc.stl type 1
            fix left all mesh/surface file left.stl type 1
            fix right all mesh/surface file right.stl type 1
            fix w all wall/gran model hertz tangential history mesh n_meshes 3 meshes disc left right store_force yes
        """
        wind = 12.0
        plate = PLATE.replace("centre 0 0 0", f"centre -0.0003 0 {thin!r}").replace("0.005", "0.002")
        move = "\n".join(f"fix mv{m} all move/mesh mesh {m} linear {wind} 0 0" for m in ("left", "right"))
        grains = [(-0.0005 + wind * 3e-5, 0, thin + R + 6e-5, 0, 0, -2.0),      # left half
                  (0.0006 + wind * 4e-5, 0, thin + R + 8e-5, 0, 0, -2.0),       # right half
                  (-0.0003, 0, R + 2.0 * 5e-4, 0, 0, -2.0)]                     # table, workpiece gone
        for ranks in (0, 2):
            events = self.hit(grains, move, wall=wall, plate=plate, steps=6000, ranks=ranks)
            self.assertEqual([e["id"] for e in events], [1, 2])
            for event, place in zip(events, (-0.0002, 0.0009)):
                self.assertAlmostEqual(event["speed_before"], math.hypot(2, wind), delta=1e-5)
                self.assertAlmostEqual(event["x"], place, delta=3e-6)

    def test_servo(self):
        """A mesh that LIGGGHTS' servo moves: full speed until it is loaded, upwards here."""
        wall = MESH.replace("mesh/surface file", "mesh/surface/stress/servo file").replace(
            "type 1\n", "type 1 com 0 0 0 ctrlPV force axis 0 0 1 target_val 1e-3 vel_max 0.5 kp 5\n", 1)
        for event in self.hit(GRAINS, wall=wall):
            v = GRAINS[int(event["id"]) - 1][3:]
            self.assertAlmostEqual(event["speed_before"], math.hypot(v[0], v[1], v[2] - 0.5), delta=1e-6)
        self.assertEqual(self.table()["all"]["collisions"], 3)

    def test_ranks(self):
        """A plate that passes from one rank to the next, and at first lies on one only: the same
        files for any number of ranks."""
        self.disc(radius=0.002)
        wind = 8.0
        grains = [(-0.0015 + 0.0003 * i + wind * 4e-5 * (i + 1), 0.0001 * (i % 7) - 0.0003,
                   R + 2.0 * 4e-5 * (i + 1), 0.3, 0.1 * i, -2.0) for i in range(10)]
        move = f"fix mv all move/mesh mesh disc linear {wind} 0.5 0.2"
        files = []
        for ranks in (0, 2, 4):
            self.assertEqual(len(self.hit(grains, move, steps=6000, ranks=ranks,
                                          plate=PLATE.replace("0.005", "0.002"))), 10)
            files.append([(self.folder / name).read_text() for name in ("plate.csv", "events.csv")])
        self.assertEqual(files[1], files[0])
        self.assertEqual(files[2], files[0])

    def test_periodic_box(self):
        """A plate that leaves a periodic box comes back on the other side, as its mesh does."""
        self.disc(radius=0.003)
        wind = 20.0
        flight = 6e-4                                         # 12 mm: half a box and more
        grains = [(0.0005 + (wind - 0.5) * flight - 0.02, 0.0004, R + 2.0 * flight, 0.5, 0, -2.0)]
        event, = self.hit(grains, f"fix mv all move/mesh mesh disc linear {wind} 0 0", steps=8000,
                          plate=PLATE.replace("0.005", "0.003"), boundary="p p f", mu=0.1)
        self.assertAlmostEqual(event["speed_before"], math.hypot(wind - 0.5, 2.0), delta=1e-5)
        self.assertAlmostEqual(event["x"], 0.0005, delta=4e-6)

    def test_a_plate_that_stops(self):
        """It stays where its motion has left it, and is at rest there; defined once more, a plate lies
        where the script then says."""
        wind, steps = 5.0, 2000
        shift = wind * steps * 1e-7
        self.data([(shift + 0.002, 0, R + 2.0 * 3e-4, 0, 0, -2.0)])
        self.liggghts(self.script(f"""
            {PLATE}
            fix mv all move/mesh mesh disc linear {wind} 0 0
            run {steps}
            unfix mv
            fix q all plate/stats wall w centre 0 0 0 normal 0 0 1 radius 0.005 rings 1 file q.csv events q-events.csv
            run 3000""", wall=MESH))
        event, = self.events()
        self.assertAlmostEqual(event["speed_before"], 2.0, delta=1e-9)
        self.assertAlmostEqual(event["x"], 0.002, delta=1e-9)
        event, = self.events("q-events.csv")
        self.assertAlmostEqual(event["x"], 0.002 + shift, delta=1e-9)

    def test_restart_of_a_moving_plate(self):
        """Read on another number of ranks: written in mid-flight, files as without the restart, bit for
        bit. In mid-contact LIGGGHTS itself differs: its mesh has no velocity in the first half
        step after a restart, which lacks 8 % of that step's force (0.1 % of the collision)."""
        grains = [(0.001, 0.0002, D, 0.5, 0, -2.0), (0.0021, 0.0007, 4 * D, 5.0, 1.0, -2.0),
                  (-0.0012, 0.001, 9 * D, 0.3, 0, -2.0)]
        moves = ("linear 5 1 0.2", "wiggle amplitude 1e-4 0 3e-5 period 1e-3",
                 "rotate origin 0.0002 0 0 axis 0 1 1 period 0.1")
        names = ("plate.csv", "events.csv")
        for move in moves:
            for steps, touching in ((150, 0), (280, 1)):
                self.data(grains)
                body = f"{PLATE}\nfix mv all move/mesh mesh disc {move}\n"
                result = self.liggghts(self.script(
                    f"{body}run {steps}\nwrite_restart mid.restart\nvariable t equal f_p[2]\n"
                    "print \"touching $t\"\nrun 4000", wall=MESH, e=0.8))
                self.assertIn(f"touching {touching}", result.output, move)
                through = [(self.folder / name).read_text() for name in names]
                expected = self.events()
                self.assertEqual(len(expected), 3)
                for ranks in (0, 2) if move == moves[0] else (2,):
                    self.liggghts(self.script(f"{body}run 4000", read="read_restart mid.restart", wall=MESH,
                                              e=0.8), ranks)
                    if touching:
                        self.assertSameEvents(self.events(), expected, 2e-3, (*COLUMNS, "x", "y"))
                    else:
                        self.assertEqual([(self.folder / name).read_text() for name in names], through, move)
        # the mesh under another name begins where its file says, the plate of the restart does not
        self.liggghts(self.script(f"{PLATE}\nfix mv all move/mesh mesh disc {moves[0]}\nrun 100\n"
                                  "write_restart moved.restart", wall=MESH))
        other = MESH.replace("disc all", "piece all").replace("meshes disc", "meshes piece")
        for ranks in (0, 2):
            result = self.liggghts(self.script(PLATE, read="read_restart moved.restart", wall=other), ranks,
                                   check=False)
            self.assertFails(result, "Fix plate/stats (ID p)", "mesh 'disc'", "another fix ID")

    def test_empty_box(self):
        """No grain, ever: tables of nothing, on ranks with and without triangles."""
        for ranks in (0, 2):
            self.liggghts(self.script(f"{PLATE}\nfix mv all move/mesh mesh disc linear 1 0 0.1\nrun 200\nrun 200",
                                      wall=MESH, read="region box block -0.01 0.01 -0.01 0.01 -0.001 0.02 "
                                      "units box\ncreate_box 1 box"), ranks)
            row = self.table()["all"]
            self.assertEqual((row["collisions"], row["touching"], row["deleted"]), (0, 0, 0))
            self.assertAlmostEqual(row["time"], 400e-7, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
