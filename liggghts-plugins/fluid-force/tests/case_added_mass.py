# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/force: added mass as effective mass, from spheres a thousand times lighter than the fluid on.

With constant coefficients the motion is integrated exactly, so that the tests assert round-off unless they say otherwise.
"""
# processors: 2

import math
import unittest

import numpy

from fluid_case import BOX, PROBE, READ, FluidCase
from grainjet import tables

RHO, NU, G = 1000.0, 1e-5, 9.81
D, C = 1e-3, 0.5
VOLUME = math.pi / 6 * D ** 3
DRAG = 3 * math.pi * RHO * NU * D                    # kg/s, Stokes

ALONE = """
    plugin load fluidforceplugin.so
    plugin load hertzcgplugin.so
    {coarse}
    atom_style granular
    atom_modify map array sort 0 0
    boundary f f f
    newton off
    communicate single vel yes
    units si
    region box block -{box} {box} -{box} {box} -{box} {box} units box
    create_box 1 box
    neighbor {skin} bin
    create_atoms 1 single 0 0 {z!r} units box
    set group all diameter {d!r} density {density!r}
    velocity all set 0.1 0 {vz!r} units box
    timestep {dt!r}
    fix f all fluid/force uniform {fluid}
    {fixes}
    fix i all nve/sphere
    variable vx equal vx[1]
    variable vz equal vz[1]
    variable fz equal fz[1]
    thermo_style custom step v_vx v_vz v_fz f_f[3]
    thermo_modify format float %.17g lost error
    thermo {every}
    run {steps}
"""


class AddedMass(FluidCase):

    def alone(self, density, dt, steps, fluid, every=1, fixes="", z=0.0, vz=0.05, coarse="", d=D, box=1e4):
        """Rows of step, vx, vz, force (m dv/dt), force of the fluid."""
        script = ALONE.format(density=density, dt=dt, steps=steps, fluid=fluid, every=every, fixes=fixes, z=z, vz=vz,
                              coarse=coarse, d=d, box=box, skin=0.1 * box)
        return numpy.array(tables.thermo(self.liggghts(script).output))

    WATER = f"0 0 0 density {RHO} viscosity {NU} drag stokes buoyancy yes addedMass {C}"
    GRAVITY = f"fix g all gravity {G} vector 0 0 -1"

    def test_sphere_in_water(self):
        """(m + m_a) dv/dt = (m - m_f) g - b v: an exponential with time (m + m_a)/b. An added mass as a force of the
        step before would diverge below m = m_a at any step; drag alone would be limited to 2 m/b. Printed
        are means of two half-step velocities: a factor cosh(dt/2 tau) in the distance from the end."""
        for ratio in (0.001, 0.1, 1.0, 2.5):
            tau = (ratio + C) * RHO * VOLUME / DRAG
            end = -(ratio - 1) * RHO * VOLUME * G / DRAG
            for step in (0.02, 0.5, 100.0):
                dt = step * tau
                with self.subTest(ratio=ratio, step=step, limit=2 * ratio / (ratio + C) / step):
                    rows = self.alone(ratio * RHO, dt, 60, self.WATER, fixes=self.GRAVITY, vz=0.05)
                    left = numpy.exp(-rows[1:, 0] * step) * math.cosh(step / 2)
                    # after one step and more everything is at its end for 100 tau
                    first = 1 if step > 10 else 0
                    left = numpy.zeros(59) if step > 10 else left
                    scale = abs(end) + 0.05
                    numpy.testing.assert_allclose(rows[1 + first:, 2] / scale, (end + (0.05 - end) * left) / scale,
                                                  rtol=0, atol=1e-11)
                    numpy.testing.assert_allclose(rows[1 + first:, 1], 0.1 * left, rtol=0, atol=1e-11)

    def test_first_moment(self):
        """A light sphere at rest begins with (m_f - m) g/(m + m_a), 2 g for a bubble. What LIGGGHTS prints is m dv/dt,
        and the fluid's part of it all but gravity."""
        mass, fluid = 1.0 * VOLUME, RHO * VOLUME
        rows = self.alone(1.0, 1e-9, 1, self.WATER, fixes=self.GRAVITY, vz=0.0)
        a = (fluid - mass) * G / (mass + C * fluid)
        self.assertGreater(a, 19.5)
        numpy.testing.assert_allclose(rows[1, 3:], [mass * a, mass * (a + G)], rtol=1e-4)    # drag of 1 ns; x at 0.1 m/s

    def test_newton_drag(self):
        """Quadratic drag, gas bubble of 4 mm: the terminal velocity is met at a step of 1000 times the relaxation time of the
        bare mass."""
        d, nu = 4e-3, 1e-6
        v = math.sqrt(4 / 3 * G * d / 0.44 * (1 - 0.001))
        self.assertGreater(v * d / nu, 1000)
        tau = 0.001 * RHO * math.pi / 6 * d ** 3 * v / ((1 - 0.001) * RHO * math.pi / 6 * d ** 3 * G)
        fluid = f"0 0 0 density {RHO} viscosity {nu} drag schillerNaumann buoyancy yes addedMass {C}"
        rows = self.alone(0.001 * RHO, 1000 * tau, 400, fluid, fixes=self.GRAVITY, vz=0.0, d=d)
        numpy.testing.assert_allclose(rows[-1, 2], v, rtol=1e-6)

    def test_same_for_every_coarse_graining(self):
        """The added mass is that of all the particles of a grain: the path is the particle's."""
        fluid = self.WATER.replace("stokes", "schillerNaumann")
        one, two = (self.alone(100.0, 1e-4, 100, fluid, fixes=self.GRAVITY, coarse=coarse)
                    for coarse in ("", "coarsegraining 2.0 model_check warn"))
        numpy.testing.assert_allclose(two[:, 1:3], one[:, 1:3], rtol=0, atol=1e-11)
        numpy.testing.assert_allclose(two[1:, 4], 8 * one[1:, 4], rtol=1e-9, atol=1e-15)

    def bounce(self, restitution, added):
        """Speed after the impact on a wall, and how long the contact lasted, in a fluid without drag."""
        d, density, speed, dt = 1e-3, 1000.0, 0.1, 2e-7
        fluid = "0 0 0 density 1000 viscosity 1e-12 drag stokes" + (f" addedMass {added}" if added else "")
        rows = self.alone(density, dt, 3000, fluid, z=d / 2 + 1e-6, vz=-speed, box=0.1, fixes=f"""
            fix m1 all property/global youngsModulus peratomtype 5.e6
            fix m2 all property/global poissonsRatio peratomtype 0.3
            fix m3 all property/global coefficientRestitution peratomtypepair 1 {restitution}
            fix m4 all property/global coefficientFriction peratomtypepair 1 0.0
            fix c all hertz/cg
            fix w all wall/gran model hertz tangential history primitive type 1 zplane 0.0
        """)
        return rows[-1, 2] / speed, numpy.count_nonzero(abs(rows[:, 3]) > 1e-12) * dt

    def test_contact(self):
        """Elastic: the speed comes back, and the contact lasts ((m + m_a)/m)^(2/5) times as long (Hertz), to a step of a
        hundredth. With damping: the law damps for the bare mass, so that its ratio falls by sqrt(m/(m + m_a)) and the restitution
        rises: beta = ln e/sqrt(ln^2 e + pi^2) times that root. The law itself keeps e to 0.5 % or so."""
        bare, wet = self.bounce(1.0, 0), self.bounce(1.0, C)
        self.assertAlmostEqual(wet[0], 1, delta=1e-3)
        self.assertAlmostEqual(wet[1] / bare[1] / (1 + C) ** 0.4, 1, delta=0.01)

        log = math.log(0.8)
        beta = -log / math.hypot(log, math.pi) / math.sqrt(1 + C)
        expected = math.exp(-math.pi * beta / math.sqrt(1 - beta ** 2))
        bare, wet = self.bounce(0.8, 0)[0], self.bounce(0.8, C)[0]
        print(f"\nrestitution 0.8: {bare:.4f} without, {wet:.4f} with added mass, {expected:.4f} expected")
        self.assertAlmostEqual(wet - bare, expected - 0.8, delta=0.005)

    def probe(self, every, more="", shear=300.0):
        return f"""
            plugin load {PROBE}
            fix f all fluid/force coupled
            fix d all exchange/probe {every} 8.0 {shear} {self.B} {self.FX} addedMass {self.ADDED!r} {more}
        """

    # drag with and without reaction, constant forces of both kinds, and an added mass twice the grain's
    B, DRAG_WITHOUT, FX, FZ, STEP = 2e-8, 3e-8, 2e-7, -8e-7, 1e-5
    ADDED = 2 * FluidCase.MASS

    def closes(self, ranks, sort, without):
        """Impulses of 500 steps of free grains under gravity, against their velocities alone."""
        more = f"nonReacting {self.DRAG_WITHOUT} {self.FZ}" if without else ""
        result = self.liggghts(self.head(sort=sort) + BOX + self.CLOUD + f"""
            {self.probe(50, more)}
            fix g all gravity {G} vector 0 -1 0
            fix i all nve/sphere
            {self.VARIABLES}
            run 0
            {self.PRINT}
            run 500
            {self.PRINT}
        """, ranks)
        start, end = (self.values(text) for text in result.output.split("Loop time")[1:])
        p = [numpy.array([values["p" + k] for k in "xyz"]) for values in (start, end)]
        weight = numpy.array([0, -self.GRAINS * self.MASS * G * self.STEP, 0])
        gained = p[1] - p[0] - 500 * weight
        with_reaction = numpy.array([end["i" + k] for k in "xyz"])
        scale = abs(gained).max()
        if not without:
            numpy.testing.assert_allclose(with_reaction / scale, gained / scale, rtol=0, atol=1e-12)
            return
        # The first exchange comes behind the kicks of step 50, so the bare mass falls for 50 steps and the first half of the
        # next one. Then drag, both constant forces and gravity act on m + m_a
        felt = self.GRAINS * 449.5 * self.STEP
        moved = (p[1] - p[0] - 50.5 * weight) * (self.MASS + self.ADDED) / self.MASS
        drag = moved - 449.5 * weight - numpy.array([self.FX * felt, 0, self.FZ * felt])
        without_reaction = numpy.array([end["n" + k] for k in "xyz"])
        expected = self.DRAG_WITHOUT / (self.B + self.DRAG_WITHOUT) * drag + numpy.array([0, 0, self.FZ * felt])
        numpy.testing.assert_allclose(with_reaction + without_reaction, gained, rtol=0, atol=1e-12 * scale)
        numpy.testing.assert_allclose(without_reaction, expected, rtol=0, atol=1e-12 * scale)

    def test_impulse(self):
        """What the fluid gave is the change of momentum less gravity's, and of that the forces without reaction are booked apart."""
        for ranks, sort in ((0, "0 0"), (2, "10 0.001"), (4, "0 0")):
            for without in (False, True):
                with self.subTest(ranks=ranks, without=without):
                    self.closes(ranks, sort, without)

    DUMP = ("dump d all custom 200 {} id vx vy vz f_fluidImpulse[1] f_fluidImpulse[2] f_fluidImpulse[3] "
            "f_fluidForce[1] f_fluidAddedMass\n" 'dump_modify d format "%d' + 8 * " %.17g" + '"')

    def test_restart_and_ranks(self):
        """From the middle of a run bit for bit; the same on any number of ranks. In wind without shear: the probe takes
        it at positions that a rank may have wrapped already."""
        whole = {}
        for ranks in (1, 2, 4):
            self.liggghts(self.head() + BOX + self.CLOUD + f"""
                {self.probe(75, shear=0.0)}
                fix i all nve/sphere
                {self.DUMP.format("whole.dump")}
                restart 120 r.*
                run 200
            """, ranks)
            whole[ranks] = self.dump("whole.dump")
            numpy.testing.assert_array_equal(whole[ranks], whole[1])
            self.assertEqual(whole[ranks][0, 8], self.ADDED)
        self.liggghts(self.head() + READ.format(name="r.120") + f"""
            {self.probe(75, shear=0.0)}
            fix i all nve/sphere
            {self.DUMP.format("rest.dump")}
            run 80
        """, 4)
        numpy.testing.assert_array_equal(self.dump("rest.dump"), whole[4])

    def test_coupling_that_no_longer_asks(self):
        """Without a coupling the added mass of the restart file stays; the next coupling that does not ask ends it."""
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {self.probe(50)}
            fix i all nve/sphere
            restart 100 r.*
            run 100
        """, 2)
        for coupling, expected in (("", self.ADDED), (f"fix d all exchange/probe 500 8.0 300.0 0 {self.FX}", 0.0)):
            result = self.liggghts(self.head() + READ.format(name="r.100") + f"""
                plugin load {PROBE}
                fix f all fluid/force coupled
                {coupling}
                fix i all nve/sphere
                compute most all reduce max f_fluidAddedMass
                variable most equal c_most
                thermo_style custom step c_most
                run 5
                print "most = ${{most}}"
            """, 2)
            self.assertAlmostEqual(self.vector(result, ["most"])[0], expected, delta=1e-14 * self.ADDED)

    def test_new_and_held_grains(self):
        """Grains carried by insert/stream get nothing until their release, and inserted ones have no added mass until the next
        exchange. All that fluid and insertion gave is in the momentum."""
        self.triangles("face.stl", 0.004, 0.002, 0.008)
        result = self.liggghts(self.head(boundary="f f f") + BOX + self.CLOUD + f"""
            {self.MATERIAL}
            {self.probe(10)}
            fix pt all particletemplate/sphere 15485863 atom_type 1 density constant {self.DENSITY} &
                radius constant {self.DIAMETER / 2} volume_limit 1e-16
            fix pd all particledistribution/discrete 32452843 1 pt 1.0
            fix face all mesh/surface/planar file face.stl type 1
            fix in all insert/stream seed 86028157 distributiontemplate pd nparticles 20000 &
                particlerate 100000 overlapcheck no all_in no vel constant 2 0 0 &
                insertion_face face extrude_length 0.001
            fix i all nve/sphere
            {self.VARIABLES}
            run 0
            {self.PRINT}
            run 600
            {self.PRINT}
        """, 2)
        start, end = (self.values(text) for text in result.output.split("Loop time")[1:])
        inserted = end["atoms"] + end["removed"] - start["atoms"]
        self.assertGreater(inserted, 300)
        self.assertGreater(end["removed"], 100)
        p = [numpy.array([values[kind + k] for k in "xyz"]) for values, kind in ((start, "p"), (end, "p"), (end, "l"), (end, "i"))]
        gained = p[1] + p[2] - p[0]
        gained[0] -= inserted * self.MASS * 2
        scale = abs(p[2]).max()
        numpy.testing.assert_allclose(p[3] / scale, gained / scale, rtol=0, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
