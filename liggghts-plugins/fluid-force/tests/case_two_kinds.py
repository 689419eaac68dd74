# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/force: impulse of forces with and without reaction on the fluid, each counted independently.

What the fluid gave the grains is told from their velocities alone: the change of their momentum, less what
gravity, insertion and removal did. Forces are played by a small plugin (fix_exchange_probe.h): drag b with
and drag c without reaction, constant forces fx (with) along x and fz (without) along z.

Tolerance 1e-12: a thousand kicks of some 1e-16 relative, and sums of 2000 grains printed with 15 digits.
"""
# processors: 2

import unittest

import numpy

from fluid_case import BOX, PROBE, READ, FluidCase

G, STEP = 9.81, 1e-5
B, C, FX, FZ = 2e-8, 3e-8, 2e-7, -8e-7
SHARE = C / (B + C)


class TwoKinds(FluidCase):

    def probe(self, every, b=B, c=C):
        return f"""
            plugin load {PROBE}
            fix f all fluid/force coupled
            fix d all exchange/probe {every} 8.0 300.0 {b} {FX} nonReacting {c} {FZ}
        """

    def momentum(self, values, names="p"):
        return numpy.array([values[names + k] for k in "xyz"])

    def closes(self, gained, taken, with_reaction, without, steps):
        """gained: by forces of the fluid alone. steps: between the exchange that began the forces and
        that which took the impulses; the first half kick of these was without them."""
        felt = self.GRAINS * (steps - 0.5) * STEP
        constant = numpy.array([FX * felt, 0, FZ * felt])
        expected = numpy.array([0, 0, FZ * felt]) + SHARE * (gained - constant)
        scale = abs(gained).max()
        self.assertGreater(abs(expected[2]) / scale, 0.01)
        numpy.testing.assert_allclose(without / scale, expected / scale, rtol=0, atol=1e-12)
        numpy.testing.assert_allclose(with_reaction / scale, (gained - expected) / scale, rtol=0, atol=1e-12)
        numpy.testing.assert_allclose(taken, with_reaction + without, rtol=0, atol=1e-12 * scale)

    def test_each_kind_against_velocities(self):
        """Free grains under drag of both kinds, both forces and gravity, moving through the ranks."""
        for ranks, sort in ((0, "0 0"), (2, "10 0.001"), (4, "0 0")):
            result = self.liggghts(self.head(sort=sort) + BOX + self.CLOUD + f"""
                {self.probe(50)}
                fix g all gravity {G} vector 0 -1 0
                fix i all nve/sphere
                {self.VARIABLES}
                run 0
                {self.PRINT}
                run 500
                {self.PRINT}
            """, ranks)
            start, end = (self.values(text) for text in result.output.split("Loop time")[1:])
            self.assertEqual(end["atoms"], self.GRAINS)
            gained = self.momentum(end) - self.momentum(start)
            gained[1] += self.GRAINS * self.MASS * G * 500 * STEP
            kinds = self.momentum(end, "i"), self.momentum(end, "n")
            self.closes(gained, gained, *kinds, 450)

    def test_restart_between_exchanges(self):
        """A file from between two runs, 20 steps after an exchange: the impulses go on, each kind its own, and
        so does the half kick that is still to come."""
        first = self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {self.probe(50)}
            fix g all gravity {G} vector 0 -1 0
            fix i all nve/sphere
            {self.VARIABLES}
            run 0
            {self.PRINT}
            run 120
            {self.PRINT}
            write_restart half.restart
        """, 2)
        start, half = (self.values(text) for text in first.output.split("Loop time")[1:])
        for ranks in (1, 2):
            second = self.liggghts(self.head() + READ.format(name="half.restart") + f"""
                {self.probe(50)}
                fix g all gravity {G} vector 0 -1 0
                fix i all nve/sphere
                {self.VARIABLES}
                run 80
                {self.PRINT}
            """, ranks)
            end = self.values(second.output)
            gained = self.momentum(end) - self.momentum(start)
            gained[1] += self.GRAINS * self.MASS * G * 200 * STEP
            kinds = [self.momentum(half, kind) + self.momentum(end, kind) for kind in "in"]
            self.closes(gained, gained, *kinds, 150)

    DUMP = ("dump d all custom 200 {} id vx vy vz f_fluidImpulse[1] f_fluidImpulse[2] f_fluidImpulse[3] "
            "f_fluidNonReactingImpulse[1] f_fluidNonReactingImpulse[2] f_fluidNonReactingImpulse[3] "
            "f_fluidNonReactingApplied[3] f_fluidNonReactingForce[3] f_fluidNonReactingCoefficient "
            "f_fluidForce[3] f_fluidOwner[1] f_fluidOwner[2] f_fluidOwner[3]\n"
            'dump_modify d format "%d' + 16 * " %.17g" + '"')

    def test_restart_from_the_middle_of_a_run(self):
        """The file of `restart`: bit for bit as if the run had not stopped, with all that is kept per grain."""
        # the last exchange at step 150, so that 50 steps of impulse are in the dump
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {self.probe(75)}
            fix i all nve/sphere
            {self.DUMP.format("whole.dump")}
            restart 120 r.*
            run 200
        """, 2)
        self.liggghts(self.head() + READ.format(name="r.120") + f"""
            {self.probe(75)}
            fix i all nve/sphere
            {self.DUMP.format("rest.dump")}
            run 80
        """, 2)
        whole = self.dump("whole.dump")
        self.assertGreater(abs(whole[:, 4:14]).min(axis=0).max(), 0)
        numpy.testing.assert_array_equal(self.dump("rest.dump"), whole)

    def test_state_is_held_without_a_coupling(self):
        """A script that goes on without the coupling, and a run before the coupling comes: what was requested is
        there and the forces are held. To the last digit, a set-up between the runs in both cases."""
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {self.probe(50)}
            fix i all nve/sphere
            run 120
            unfix d
            write_restart held.restart
            {self.DUMP.format("through.dump")}
            run 80
        """, 2)
        self.liggghts(self.head() + READ.format(name="held.restart") + f"""
            fix f all fluid/force coupled
            fix i all nve/sphere
            {self.DUMP.format("held.dump")}
            run 80
            plugin load {PROBE}
            fix d all exchange/probe 50 8.0 300.0 {B} {FX} nonReacting {C} {FZ}
            undump d
            {self.DUMP.format("late.dump")}
            run 0
        """, 2)
        through = self.dump("through.dump")
        self.assertGreater(abs(through[:, 9]).min(), 0)
        numpy.testing.assert_array_equal(self.dump("held.dump"), through)
        late = self.dump("late.dump")
        for kept in (slice(0, 10), slice(11, 13), slice(14, 17)):    # the set-up changes the force alone
            numpy.testing.assert_array_equal(late[:, kept], through[:, kept])

    def test_coupling_that_no_longer_asks(self):
        """Forces without reaction are in the file, the next coupling has none: they end at once, and their last
        half kick is booked as theirs. The rest goes with reaction."""
        first = self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {self.probe(50, b=0, c=0)}
            fix i all nve/sphere
            {self.VARIABLES}
            restart 100 r.*
            run 100
            {self.PRINT}
        """, 2)
        half = self.values(first.output)
        second = self.liggghts(self.head() + READ.format(name="r.100") + f"""
            plugin load {PROBE}
            fix f all fluid/force coupled
            fix d all exchange/probe 50 8.0 300.0 0 {FX}
            fix i all nve/sphere
            {self.VARIABLES}
            compute n all reduce sum f_fluidNonReactingImpulse[1] f_fluidNonReactingImpulse[3]
            variable rest equal c_n[2]
            thermo_style custom step c_p[1] c_p[2] c_p[3] c_n[1] c_n[2]
            run 50
            print "rest = ${{rest}}"
            {self.PRINT}
        """, 2)
        end = self.values(second.output)
        last = self.GRAINS * FZ * STEP / 2
        self.assertAlmostEqual(self.vector(second, ["rest"])[0] / last, 1, delta=1e-12)
        gained = self.momentum(end) - self.momentum(half)
        scale = self.GRAINS * FX * 50 * STEP
        numpy.testing.assert_allclose(gained / scale, [1, 0, last / scale], rtol=0, atol=1e-10)    # a difference of p
        numpy.testing.assert_allclose(self.momentum(end, "i") / scale, [1, 0, 0], rtol=0, atol=1e-12)

    def test_insertion_stream_loss_and_deletion(self):
        """Grains held by insert/stream, released, inserted, leaving through fixed boundaries and deleted by a
        fix massflow/mesh: the momentum of all closes. Without drag each kind has a direction of its own, so each
        closes by itself; with drag the sum does."""
        self.triangles("face.stl", 0.004, 0.002, 0.008)
        self.triangles("plane.stl", 0.0155, 0, 0.01)
        for ranks, b, c in ((1, 0, 0), (2, 0, 0), (2, B, C)):
            result = self.liggghts(self.head(boundary="f f f") + BOX + self.CLOUD + f"""
                {self.MATERIAL}
                fix plane all mesh/surface/planar file plane.stl type 1
                fix count all massflow/mesh mesh plane count once vec_side -1 0 0 delete_atoms yes
                {self.probe(10, b, c)}
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
            """, ranks)
            start, end = (self.values(text) for text in result.output.split("Loop time")[1:])
            inserted = end["atoms"] + end["removed"] - start["atoms"]
            self.assertGreater(inserted, 300)
            self.assertGreater(end["deleted"], 50)
            self.assertGreater(end["removed"] - end["deleted"], 100)
            gained = self.momentum(end) + self.momentum(end, "l") - self.momentum(start)
            gained[0] -= inserted * self.MASS * 2
            taken, without = self.momentum(end, "i"), self.momentum(end, "n")
            scale = abs(self.momentum(end, "l")).max()
            numpy.testing.assert_allclose((taken + without) / scale, gained / scale, rtol=0, atol=1e-12)
            if b == 0:
                self.assertEqual(list(taken[1:]), [0, 0])
                self.assertEqual(list(without[:2]), [0, 0])
                self.assertGreater(abs(taken[0]), 1e-3 * scale)
                # both forces felt for the same time by the same grains
                self.assertAlmostEqual(taken[0] / FX / (without[2] / FZ), 1, delta=1e-12)

    def test_absurd_force_of_one_kind(self):
        """A sum that looks sound does not hide it."""
        result = self.liggghts(self.head() + BOX + self.CLOUD + f"""
            plugin load {PROBE}
            fix f all fluid/force coupled
            fix d all exchange/probe 1 0 0 0 0 nonReacting 0 1e31
            fix i all nve/sphere
            run 10
        """, 2, check=False)
        self.assertFails(result, "Fix fluid/force (ID f): the force on grain", "without reaction on the fluid")


if __name__ == "__main__":
    unittest.main()
