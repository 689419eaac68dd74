# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Newton's third law in a liquid, counted without any number of the coupling's own table.

Grains have neither contacts nor walls, so what a grain gains is gravity plus what the fluid gives it.
Gravity and buoyancy, which has no reaction, are known by formula. The rest of m dv of all grains must be
what the fluid has lost. Grains are inserted, held by insert/stream, released, leave the mesh and the box,
and are deleted by massflow/mesh: all of that within coupling intervals.
"""
# processors: 2

import collections
import itertools
import math
import random
import re
import unittest

import grainjet
from grainjet import coupled_box as box, dictionaries

RHO, NU = 1000.0, 1e-5                  # a liquid, so that buoyancy is of the order of the weight
GRAVITY = (0.6 * 9.81, 0.8 * 9.81, 0.0)
DENSITY = 2500.0
DEM_STEP, INTERVAL, STEPS = 1e-5, 10, 35
LAST = INTERVAL * STEPS
HEIGHT = 0.04                           # of the mesh; the box of grains is higher
CELLS, CELL_VOLUME = (5, 5, 10), 0.004 ** 3

DUMP = ("dump d all custom 1 grains.dump id radius mass x y z vx vy vz fx fy fz "
        "f_release_fix_insert_stream[4] f_release_fix_insert_stream[5]\n"
        'dump_modify d sort id format "%d' + 13 * " %.17g" + '"')

# Grains of 1 mm are there from the start; grains of 0.5 mm are inserted, at steps that are no multiple
# of the coupling interval
FIXES = """
fix plane all mesh/surface file constant/plane.stl type 1
fix deletion all massflow/mesh mesh plane count once vec_side 0 0 1 delete_atoms yes
fix template all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.00025
fix sizes all particledistribution/discrete 32452843 1 template 1.0
region source block 0.002 0.018 0.002 0.018 0.004 0.012 units box
fix drops all insert/rate/region seed 49979687 distributiontemplate sizes nparticles 60 particlerate 20000 &
    insert_every 37 vel constant 0.3 0.2 -0.5 overlapcheck yes region source
fix face all mesh/surface/planar file constant/face.stl type 1
fix stream all insert/stream seed 86028157 distributiontemplate sizes nparticles 200 particlerate 20000 &
    overlapcheck yes all_in no vel constant 0.2 -0.1 -2 insertion_face face extrude_length 0.004
"""

Grain = collections.namedtuple("Grain", "radius mass x v f inserted release")


def square(low, high, z, normal):
    """A square across z, in metres, as the text of an STL file."""
    corners = [(low, low), (high, low), (high, high), (low, high)]
    return "solid square\n" + "".join(
        f"facet normal 0 0 {normal}\n outer loop\n"
        + "".join("  vertex {} {} {}\n".format(*corners[i], z) for i in triangle)
        + " endloop\nendfacet\n" for triangle in ((0, 1, 2), (0, 2, 3))) + "endsolid square\n"


def first_grains():
    """Positions and velocities: some stay, some leave through the upper end of mesh and box, some
    cross the plane that deletes them."""
    rng = random.Random(12)

    def within(low, high):
        return [rng.uniform(a, b) for a, b in zip(low, high)]

    x = [within((0, 0, 0.002), (0.02, 0.02, 0.036)) for _ in range(40)]
    v = [[rng.gauss(0, 0.2) for _ in range(3)] for _ in x]
    for i in range(12):
        x.append(within((0, 0, 0.037), (0.02, 0.02, 0.0395)))
        v.append([0.1, -0.2, 2.5 + 0.2 * i])
    for _ in range(12):
        x.append(within((0.006, 0.006, 0.0115), (0.014, 0.014, 0.0145)))
        v.append([-0.1, 0.1, 2])
    return x, v


def write_fluid(folder):
    """Vortices in a box that is periodic in x and y and has slip walls at its ends: no momentum in x and
    y leaves it. Correctors until the equation is satisfied, since only then it keeps momentum."""
    k = 2 * math.pi / CELLS[0]
    values = "\n".join(
        f"({0.1 * math.sin(k * (j + 0.5)):.17g} {0.1 * math.sin(k * (i + 0.5)):.17g} 0)"
        for _, j, i in itertools.product(*map(range, reversed(CELLS))))
    for name, dimensions, start, end in (
            ("U", "0 1 -1", f"nonuniform List<vector> {math.prod(CELLS)}\n(\n{values}\n)", "slip"),
            ("p", "0 2 -2", "uniform 0", "zeroGradient")):
        dictionaries.write_field(folder, name, dimensions, start,
                                 f'"[xy].*" {{ type cyclic; }} "z.*" {{ type {end}; }}')


def read_dump(path):
    """All snapshots of the dump: {step: {id: Grain}}."""
    frames, rows = {}, {}
    with open(path) as lines:
        for line in lines:
            if line.startswith("ITEM: TIMESTEP"):
                rows = frames[int(next(lines))] = {}
            elif line.startswith("ITEM: NUMBER"):
                next(lines)
            elif line.startswith("ITEM: BOX"):
                next(lines), next(lines), next(lines)
            elif not line.startswith("ITEM"):
                tag, radius, mass, *c = map(float, line.split())
                rows[int(tag)] = Grain(radius, mass, c[:3], c[3:6], c[6:9], *map(int, map(round, c[9:])))
    return frames


class Life:
    """A grain from the step in which it begins to move freely to the last one that shows it.

    The force F(n) of step n acts in two kicks of half a step, at the end of step n and at the beginning of
    step n + 1. A grain that is inserted in step n comes between the two kicks of that step, and one that
    is deleted goes between them. insert/stream takes force and velocity back until the step of release."""

    def __init__(self, frames, tag):
        self.steps = [n for n in frames if tag in frames[n]]
        self.grains = [frames[n][tag] for n in self.steps]
        self.streamed = self.grains[0].inserted != 0
        self.released = not self.streamed or self.grains[0].release < self.steps[-1]
        self.born, self.gone = self.steps[0], self.steps[-1] < LAST
        self.first = self.grains[0].release if self.streamed else self.born

    def kicks(self):
        """(step of the force, number of half kicks with it)."""
        for n in self.steps:
            if self.released and n >= self.first and not (self.streamed and n == self.first):
                end_of_step = n > 0
                next_step = n < self.steps[-1] or self.gone
                yield n, end_of_step + next_step

    def first_velocity(self):
        """Velocity at the beginning of the free life; an inserted grain has had a half kick when it is first seen."""
        grain = self.grains[self.steps.index(self.first)]
        half = DEM_STEP / 2 if self.born > 0 and not self.streamed else 0
        return [v - half * f / grain.mass for v, f in zip(grain.v, grain.f)]

    def last_velocity(self):
        """Velocity at its end; a deleted grain has had a half kick since it was last seen."""
        grain = self.grains[-1]
        half = DEM_STEP / 2 if self.gone else 0
        return [v + half * f / grain.mass for v, f in zip(grain.v, grain.f)]

    def momentum_gained(self):
        """m dv over the free life."""
        if not self.released:
            return [0.0] * 3
        return [self.grains[-1].mass * (b - a) for a, b in zip(self.first_velocity(), self.last_velocity())]


def knows(frames, tag, n):
    """Whether the coupling has given the grain the force that acts in step n: it does so before each
    interval, for the grains that are in the mesh then."""
    start = 0 if n == 0 else INTERVAL * ((n - 1) // INTERVAL)
    grain = frames[start].get(tag)
    return grain is not None and 0 <= grain.x[2] <= HEIGHT


class Balance(grainjet.Case):

    def run_case(self, ranks, forces, momentum):
        folder = self.folder / f"case{len(list(self.folder.iterdir()))}"
        box.write(folder, steps=STEPS, delta_t=INTERVAL * DEM_STEP, ranks=2, decomposition="(2 1 1)", nu=NU,
                  rho=f"rho [1 -3 0 0 0 0 0] {RHO};", cells="{} {} {}".format(*CELLS), through=True,
                  correctors="nOuterCorrectors 10; nCorrectors 2;")
        write_fluid(folder)
        x, v = first_grains()
        # LIGGGHTS is cut in z, the fluid in x: half of the grains are on the other rank
        box.script(folder, grains=box.grains(x, v, 1e-3, DENSITY), dt=DEM_STEP, boundary="p p f",
                   box=f"0 0.02 0 0.02 -0.003 {HEIGHT + 0.003}", end=DUMP, fixes=FIXES,
                   gravity="fix g all gravity 9.81 vector 0.6 0.8 0",
                   processors=f"processors 1 1 {max(ranks, 1)}")
        (folder / "constant/plane.stl").write_text(square(0.004, 0.016, 0.015, 1))
        (folder / "constant/face.stl").write_text(square(0.004, 0.016, 0.022, -1))
        box.fv_options(folder, forces=forces, momentum=momentum)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.foam("pimpleFoam", folder, ranks)
        if ranks:
            self.foam("reconstructPar", folder)
        return folder

    def check_kicks(self, frames, lives):
        """The dump shows velocity Verlet: m dv of each step is that of the two kicks, to round-off (of
        velocities up to 5 m/s), and inserted grains begin with the velocity of their insertion. So kicks that
        no snapshot shows can be added by their force. The snapshot of step 0 is written before the coupling
        has given its first forces."""
        for tag, life in lives.items():
            if life.born > 0 and life.released:
                for seen, given in zip(life.first_velocity(), (0.2, -0.1, -2) if life.streamed else (0.3, 0.2, -0.5)):
                    self.assertAlmostEqual(seen, given, delta=1e-14, msg=f"grain {tag}")
            for n in range(max(life.first, life.born, 1) + 1, life.steps[-1] + 1) if life.released else ():
                a, b = frames[n - 1][tag], frames[n][tag]
                for k in range(3):
                    kick = DEM_STEP / 2 * (a.f[k] + b.f[k]) / a.mass
                    self.assertAlmostEqual(b.v[k] - a.v[k], kick, delta=1e-14, msg=f"grain {tag}, step {n}")

    def check_cover(self, frames, lives):
        """What the test is about has happened, and within intervals."""
        def off(steps):
            return sum(n % INTERVAL != 0 for n in steps)

        ends = {tag: life.grains[-1] for tag, life in lives.items() if life.gone}
        high = [tag for tag, grain in ends.items() if grain.x[2] > HEIGHT]
        self.assertGreater(off(lives[tag].steps[-1] for tag in high), 5)               # left the box
        self.assertGreater(off(lives[tag].steps[-1] for tag in ends if tag not in high), 5)     # deleted
        self.assertGreater(sum(not life.released for life in lives.values()), 5)     # held to the end
        self.assertGreater(off(life.first for life in lives.values() if life.streamed and life.released), 5)
        self.assertGreater(off(life.born for life in lives.values() if life.streamed), 5)
        self.assertGreater(off(life.born for life in lives.values() if not life.streamed), 5)
        last = frames[LAST]
        self.assertGreater(sum(grain.x[2] > HEIGHT for n in frames for grain in frames[n].values()), 100)
        self.assertGreater(sum(0 < grain.x[2] < HEIGHT for grain in last.values()), 40)

    def impulse_with_reaction(self, frames, lives, buoyancy):
        """N s, of all grains together; and the sum of its magnitudes over the grains."""
        parts = []
        for tag, life in lives.items():
            mass, volume = life.grains[0].mass, 4 / 3 * math.pi * life.grains[0].radius ** 3
            kicks = list(life.kicks())
            weight = sum(number for _, number in kicks) * mass
            displaced = RHO * volume * sum(number for n, number in kicks if knows(frames, tag, n)) if buoyancy else 0
            parts.append([gained - DEM_STEP / 2 * (weight - displaced) * g
                          for gained, g in zip(life.momentum_gained(), GRAVITY)])
        return [math.fsum(p[k] for p in parts) for k in range(3)], math.fsum(math.hypot(*p) for p in parts)

    def momentum_of_fluid(self, folder, time):
        values = dictionaries.internal(folder / time / "U")
        self.assertEqual(len(values), math.prod(CELLS))
        return [RHO * CELL_VOLUME * math.fsum(u[k] for u in values) for k in range(3)]

    def still_owed(self, folder, time):
        """N s that the linearised source carries over from the last step to the next one, which the fluid
        has not got yet: the field that a continued run finds, of all ranks."""
        files = list(folder.glob(f"processor*/{time}/particleMomentumOwed"))
        values = []
        for path in files or [folder / time / "particleMomentumOwed"]:
            text = path.read_text()
            body = text[text.index("value"):]
            values += [[float(c) for c in row.split()] for row in re.findall(r"\(([^()]+)\)", body)]
        self.assertEqual(len(values), math.prod(CELLS))
        return [math.fsum(v[k] for v in values) for k in range(3)]

    def check(self, ranks, forces, momentum):
        folder = self.run_case(ranks, forces, momentum)
        frames = read_dump(folder / "grains.dump")
        self.assertEqual(list(frames), list(range(LAST + 1)))
        lives = {tag: Life(frames, tag) for tag in sorted({tag for frame in frames.values() for tag in frame})}
        self.check_kicks(frames, lives)
        self.check_cover(frames, lives)

        grains, exchanged = self.impulse_with_reaction(frames, lives, "buoyancy" in forces)
        end = f"{LAST * DEM_STEP:.10g}"
        before, after = (self.momentum_of_fluid(folder, time) for time in ("0", end))
        owed = self.still_owed(folder, end) if momentum == "implicit" else [0.0] * 3
        table = box.read_balance(folder)
        booked = [math.fsum(table[f"toGrains_{c}"]) for c in "xyz"]

        # along z the fluid exchanges momentum with the slip walls, too
        fluid = math.hypot(*(a - b + g + o for a, b, g, o in list(zip(after, before, grains, owed))[:2]))
        wrong = math.hypot(*(b - g for b, g in zip(booked, grains)))
        print(f"\n{forces} {momentum}, {ranks or 1} ranks: exchanged {exchanged:.4g} N s; of that missing in the fluid "
              f"{fluid / exchanged:.2g}, in the table {wrong / exchanged:.2g}; imbalance of the table "
              f"{max(table['imbalance']):.2g}")
        self.assertGreater(exchanged, 1e-5)
        # The linear solver stops at a residual of 1e-14 of all terms of the equation, which are twice the
        # fluid's 1e-3 N s or less: 7e-16 N s in 35 steps, 1.2e-11 of the 6e-5 N s exchanged
        self.assertLess(fluid, 1.2e-11 * exchanged)
        # round-off: 200 grains, 350 steps, 1e-16 each
        self.assertLess(wrong, 7e-12 * exchanged)
        self.assertLess(max(table["imbalance"]), 1.2e-11)

    def test_forces_with_reaction(self):
        """Drag, pressure gradient and viscous force."""
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                self.check(ranks, "(pressureGradient viscous)", "implicit")

    def test_buoyancy(self):
        """The same with buoyancy, which has no reaction: the fluid feels neither what buoyancy gave to the
        grains nor what it would have given to those that were held, came, or had gone."""
        for ranks, momentum in itertools.product((0, 2), ("implicit", "explicit")):
            with self.subTest(ranks=ranks, momentum=momentum):
                self.check(ranks, "(pressureGradient viscous buoyancy)", momentum)


if __name__ == "__main__":
    unittest.main()
