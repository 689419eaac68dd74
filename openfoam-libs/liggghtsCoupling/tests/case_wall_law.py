# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The law of the wall at grains, in flows that are imposed on the mesh."""
# processors: 4
# label: long

import math
import random
import unittest

import grainjet
from grainjet import dictionaries, wall_flow
from grainjet.wall_flow import FLUID_VELOCITY, KAPPA, reichardt, spalding
import user_library

NU = 1.5e-5
SIZE, N = 0.02, 8                           # m, cells along y; of 6 x 8 x 6
CELL = SIZE / N
Y_PLUS = 30                                 # of the first cell centre
U_TAU = Y_PLUS * NU / (CELL / 2)
K = U_TAU ** 2 / 0.3
WALLS = {"ylo": ("wall", "ylo"), "yhi": ("wall", "yhi")}
PERIODIC = {side: (f"cyclic; neighbourPatch {other}", side)
            for side, other in (("xlo", "xhi"), ("xhi", "xlo"), ("zlo", "zhi"), ("zhi", "zlo"))}
BOX = f"0 {SIZE} 0 {SIZE} 0 {SIZE}"


def law(y):
    """Velocity at a distance from a wall."""
    return U_TAU * spalding(y * U_TAU / NU)


def wall_distance(p):
    return min(p[1], SIZE - p[1])


def in_the_wall_cells(n, seed, low=1e-6, high=CELL - 1e-6):
    rng = random.Random(seed)
    places = []
    for _ in range(n):
        y = rng.uniform(low, high)
        places.append([rng.uniform(1e-5, SIZE - 1e-5), rng.choice((y, SIZE - y)), rng.uniform(1e-5, SIZE - 1e-5)])
    return places


class WallLaw(grainjet.Case):

    def case(self, velocity, sides=None, cells=f"6 {N} 6", k=None, epsilon=None, more="", fluid=None, **fields):
        """A box with its fields. velocity, k, epsilon: of a cell centre."""
        folder = self.new_folder()
        text = wall_flow.channel((SIZE,) * 3, cells, {**PERIODIC, **WALLS, **(sides or {})}) + more
        centres = wall_flow.mesh(folder, text, nu=NU, steps=1, **(fluid or {}))
        wall_flow.impose(folder, list(map(velocity, centres)), k=[k(p) if k else K for p in centres],
                         epsilon=[epsilon(p) if epsilon else U_TAU ** 3 / (KAPPA * wall_distance(p)) for p in centres],
                         **fields)
        return folder

    def sample(self, folder, places, columns=FLUID_VELOCITY, boundary="p f p", **arguments):
        return wall_flow.sample(folder, places, columns, box=BOX, boundary=boundary, **arguments)

    def assertClose(self, found, expected, tolerance, message=""):
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=tolerance, msg=f"{message}: {found}, not {expected}")

    def test_channel(self):
        """Spalding's law between wall and cell centre and up to the next cell, if that is what the cells have:
        to 2e-3 of the velocity in the centre, since nutUSpaldingWallFunction iterates for u_tau to 1 %."""
        folder = self.case(lambda p: (0.8 * law(wall_distance(p)), 0, 0.6 * law(wall_distance(p))))
        places = in_the_wall_cells(300, 1)
        for place, u in zip(places, self.sample(folder, places)):
            expected = law(wall_distance(place))
            self.assertClose(u, (0.8 * expected, 0, 0.6 * expected), 2e-3 * law(CELL / 2), place)

    def test_pipe(self):
        """A profile by another formula (Reichardt) on a pipe: rms error below 3 % of the velocity in the cell
        centre, where that of cellPoint is above 20 %."""
        u_tau, radius, y_plus = 0.55, 0.015, 30
        height = 2 * y_plus * NU / u_tau
        pipe = wall_flow.Pipe(radius, height)

        def u(p):
            return u_tau * reichardt(pipe.distance(p) * u_tau / NU)

        folder = self.new_folder()
        centres = wall_flow.mesh(folder, pipe.mesh(), nu=NU, steps=1)
        wall_flow.impose(folder, [(0, 0, u(p)) for p in centres], k=[u_tau ** 2 / 0.3] * len(centres),
                         epsilon=[u_tau ** 3 / (KAPPA * pipe.distance(p)) for p in centres])
        rng = random.Random(3)
        places = [pipe.place(rng, 0, height) for _ in range(1000)]
        error = {}
        for wall_law in ("yes", "no"):
            rows = wall_flow.sample(folder, places, box=pipe.box(), options={"wallLaw": wall_law})
            error[wall_law] = math.sqrt(sum((row[2] - u(p)) ** 2 for row, p in zip(rows, places)) / len(places)) / (
                u_tau * reichardt(y_plus))
        self.assertLess(error["yes"], 0.03)
        self.assertGreater(error["no"], 0.2)

    def test_moving_wall(self):
        """A wall that moves: the law holds for the velocity relative to it. One wall at rest."""
        speed = (3.0, 0.0, -1.0)

        def velocity(p):
            u = law(wall_distance(p))
            return (u + speed[0], 0, speed[2]) if p[1] < SIZE / 2 else (u, 0, 0)

        folder = self.case(velocity, wall_velocity={"ylo": speed})
        places = in_the_wall_cells(200, 2)
        for place, u in zip(places, self.sample(folder, places)):
            self.assertClose(u, velocity(place), 2e-3 * law(CELL / 2), place)

    def test_lid(self):
        """A wall that moves along another one, over fluid at rest and over one that is sheared: velocity stays between that
        of the walls and cells; 3 % are left to tetrahedra that have points on both walls."""
        speed = 5.0
        sides = {side: ("wall", side) for side in ("xlo", "xhi", "zlo", "zhi")}
        rng = random.Random(6)
        places = [[rng.uniform(1e-6, SIZE - 1e-6) for _ in range(2)] + [rng.uniform(1e-3, SIZE - 1e-3)] for _ in range(1000)]
        places += [[1e-7, 0.2 * SIZE + 6e-3 * SIZE * i, 0.5 * SIZE] for i in range(100)]
        for slope in (0, speed):
            folder = self.case(lambda p: (0, 0, slope * (1 - p[0] / SIZE)), sides=sides, cells=f"{N} {N} {N}",
                               epsilon=lambda p: 50.0, wall_velocity={"xlo": (0, 0, speed)})
            rows = self.sample(folder, places, boundary="f f f")
            for place, u in zip(places, rows):
                self.assertGreaterEqual(u[2], -0.03 * speed, place)
                self.assertLessEqual(u[2], 1.0001 * speed, place)
            for u in rows[1000:]:
                self.assertGreater(u[2], 0.99 * speed)

    def test_corner(self):
        """A square duct: in its corners the nearest wall counts, not the sum of both."""
        def distance(p):
            return min(wall_distance(p), p[0], SIZE - p[0])

        folder = self.case(lambda p: (0, 0, law(distance(p))), cells=f"{N} {N} 3",
                           sides={"xlo": ("wall", "xlo"), "xhi": ("wall", "xhi")})
        rng = random.Random(4)
        places = [[rng.choice((a, SIZE - a)) for a in (rng.uniform(1e-6, CELL) for _ in range(2))]
                  + [rng.uniform(1e-5, SIZE - 1e-5)] for _ in range(200)]
        for place, u in zip(places, self.sample(folder, places, boundary="f f p")):
            self.assertClose(u, (0, 0, law(distance(place))), 2e-3 * law(CELL / 2), place)

    def test_stagnation(self):
        """Flow against a plate: on its line of stagnation there is no friction and nothing to divide by. Beside it
        velocity is between a linear one and that of the cell centre. The flow is the same at all heights, which is not
        what the law has, so that the tetrahedra of a cell show: within 20 % of the difference between two centres and
        10 % of the velocity (cellPoint: up to 50 %). And a fluid at rest."""
        def velocity(p):
            return (500 * (p[0] - SIZE / 2), -250 * wall_distance(p), 0)

        # an odd number of cells along x: a row of them has no tangential velocity at all
        folder = self.case(velocity, cells=f"7 {N} 3", k=lambda p: 1.0)
        places = in_the_wall_cells(300, 5, high=CELL / 2)
        middle = [[SIZE / 2, y, 0.5 * SIZE] for y in (1e-9, 1e-5, CELL / 4)]
        rows = self.sample(folder, places + middle)
        for place, u in zip(places + middle, rows):
            self.assertTrue(all(map(math.isfinite, u)), u)
            if abs(place[0] - SIZE / 2) < SIZE / 2 - SIZE / 7:     # not at the periodic sides, where it jumps
                linear = 500 * (place[0] - SIZE / 2) * wall_distance(place) / (CELL / 2)
                full = 500 * (place[0] - SIZE / 2)
                margin = 0.2 * 500 * SIZE / 7
                self.assertGreaterEqual(u[0] * math.copysign(1, full), 0.9 * abs(linear) - margin)
                self.assertLessEqual(u[0] * math.copysign(1, full), 1.1 * abs(full) + margin)
                self.assertClose(u[2:], [0], 1e-12)
        folder = self.case(lambda p: (0, 0, 0))
        for u in self.sample(folder, places):
            self.assertClose(u, (0, 0, 0), 0)

    def test_ranks(self):
        """1 = 2 = 4 ranks, to round-off: a random flow in a duct, cut through its walls and corners."""
        rng = random.Random(6)
        flow = {}

        def velocity(p):
            return flow.setdefault(tuple(p), tuple(rng.gauss(1, 0.5) for _ in range(3)))

        places = [[rng.uniform(1e-6, SIZE - 1e-6) for _ in range(3)] for _ in range(1500)]
        rows = {}
        for ranks, decomposition in ((0, "(1 1 1)"), (2, "(2 1 1)"), (4, "(2 2 1)"), (4, "(1 1 4)")):
            folder = self.case(velocity, cells=f"{N} {N} 6", sides={"xlo": ("wall", "xlo"), "xhi": ("wall", "xhi")},
                               fluid={"ranks": ranks or 2, "decomposition": decomposition})
            rows[ranks, decomposition] = self.sample(folder, places, boundary="f f p", ranks=ranks)
        serial = rows.pop((0, "(1 1 1)"))
        for key, parallel in rows.items():
            for place, a, b in zip(places, serial, parallel):
                self.assertClose(b, a, 1e-10, (key, place))

    def test_continuous(self):
        """Two grains on both sides of a face, 2 nm apart, feel the same: between cells at the wall in any flow,
        at the top of these cells in a smooth one; and at the height of the cell centre."""
        rng, step = random.Random(7), 1e-9
        flow = {}

        def rough(p):
            return flow.setdefault(tuple(p), tuple(rng.gauss(1, 0.5) for _ in range(3)))

        def smooth(p):
            a, b = (2 * math.pi * x / SIZE for x in (p[0], p[2]))
            u = law(wall_distance(p))
            return (u * (1 + 0.2 * math.sin(a)), 0, u * 0.2 * math.cos(b))

        for velocity, faces, tolerance in ((rough, "side", 1e-4), (rough, "centre", 1e-4), (smooth, "top", 0.02)):
            with self.subTest(faces=faces):
                pairs = []
                for p in in_the_wall_cells(150, 8):
                    axis, at = {"side": (0, SIZE / 6 * rng.randint(1, 5)), "centre": (1, CELL / 2),
                                "top": (1, CELL)}[faces]
                    for side in (-step, step):
                        q = list(p)
                        q[axis] = at + side
                        pairs.append(q)
                rows = self.sample(self.case(velocity), pairs)
                for place, a, b in zip(pairs[::2], rows[::2], rows[1::2]):
                    self.assertClose(a, b, tolerance * law(CELL / 2), place)

    def test_only_at_walls_with_a_wall_function(self):
        """Bit for bit cellPoint beyond the second cell, and at a wall without nut (nutLowReWallFunction)."""
        folder = self.case(lambda p: (law(wall_distance(p)), 0, 0),
                           walls={"ylo": "nutUSpaldingWallFunction", "yhi": "nutLowReWallFunction"})
        rng = random.Random(9)
        places = [[rng.uniform(1e-5, SIZE - 1e-5) for _ in range(3)] for _ in range(500)]
        on, off = (self.sample(folder, places, options={"wallLaw": value}) for value in ("yes", "no"))
        changed = 0
        for place, a, b in zip(places, on, off):
            if place[1] > 2 * CELL:
                self.assertEqual(a, b, place)
            elif place[1] < CELL / 2:
                changed += a != b
        self.assertGreater(changed, 30)

    def test_without_nut(self):
        """Where nutkWallFunction gives no nut although y+ is 20, the solver has a linear profile, and so have we."""
        folder = self.case(lambda p: (law(wall_distance(p)), 0, 0), k=lambda p: 1e-8, nut="nutkWallFunction")
        places = [[SIZE / 12, share * CELL / 2, SIZE / 12] for share in (0.1, 0.3, 0.6, 0.9)]
        for place, u in zip(places, self.sample(folder, places)):
            self.assertClose(u, (law(CELL / 2) * place[1] / (CELL / 2), 0, 0), 1e-6)

    def test_laminar(self):
        """Bit for bit cellPoint, and said in the log."""
        folder = self.case(lambda p: (law(wall_distance(p)), 0, 0))
        dictionaries.write(folder / "constant/turbulenceProperties", "simulationType laminar;\n")
        places = in_the_wall_cells(200, 10)
        log = []
        on = self.sample(folder, places, log=log)
        self.assertIn("wallLaw changes nothing, since the flow is laminar", log[0])
        self.assertEqual(on, self.sample(folder, places, options={"wallLaw": "no"}))

    def shown(self, folder, places, quantity):
        """A quantity at grains, by a model of the tests that makes a force of it."""
        rows = self.sample(folder, places, wall_flow.SHOWN, options={
            "drag": None, "forces": f"{{ probe {{ shown {quantity}; }} }}"})
        return [row[0] / wall_flow.UNIT for row in rows]

    def test_turbulence(self):
        """k is constant down to y+ 6.9 and falls with y2 below; epsilon goes with 1/y down to y+ 11.5 and is
        constant below, from the wall up to the cell centre: exactly, in a channel in equilibrium."""
        folder = self.case(lambda p: (law(wall_distance(p)), 0, 0),
                           fluid={"libs": user_library.libs("probeModels")})
        places = in_the_wall_cells(200, 11, high=CELL / 2)
        for quantity, expected in (
                ("k", lambda y: K * min(1, 0.07 * 0.3 * y ** 2)),
                ("epsilon", lambda y: U_TAU ** 4 / NU / (KAPPA * max(y, 11.53)))):
            for place, value in zip(places, self.shown(folder, places, quantity)):
                y = wall_distance(place) * U_TAU / NU
                self.assertAlmostEqual(value, expected(y), delta=1e-3 * expected(y), msg=f"{quantity} {y}")


if __name__ == "__main__":
    unittest.main()
