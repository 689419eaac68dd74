# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/force coupled: torque, and the state of models, on several ranks and over restarts; bad requests.

The coupling is played by a small plugin (fix_exchange_probe.h). Its states begin with 0.25, 1.25 ... and gain
vx, 2 vx ... at every exchange, so a number that came to another grain shows.
"""
# processors: 2

import math
import struct
import unittest

import numpy

from fluid_case import BOX, PROBE, READ, FluidCase

INERTIA = 0.1 * FluidCase.MASS * FluidCase.DIAMETER ** 2
STATES = "state memory 3 state one 1"


def probe(every, requests=STATES):
    """A script's lines for fix fluid/force and what plays its coupling."""
    return f"""
        plugin load {PROBE}
        fix f all fluid/force coupled
        fix d all exchange/probe {every} 8.0 300.0 2e-8 1e-9 {requests}
    """


class States(FluidCase):

    DUMP = ("dump d all custom 200 {} id vy vx f_fluidState_memory[1] f_fluidState_memory[2] "
            'f_fluidState_memory[3] f_fluidState_one\ndump_modify d format "%d' + 6 * " %.17g" + '"')

    def test_moves_with_the_grain(self):
        """Periodic box, grains that cross ranks and are sorted: bit for bit as on one rank. The wind is uniform,
        since ranks differ in when they put a grain back to the other side of the box."""
        finals = []
        for ranks, sort in ((0, "0 0"), (2, "10 0.001"), (4, "0 0")):
            result = self.liggghts(self.head(sort=sort) + BOX + self.CLOUD + f"""
                {probe(50).replace("300.0", "0")}
                fix i all nve/sphere
                {self.VARIABLES}
                {self.DUMP.format("end.dump")}
                run 1000
                {self.PRINT}
            """, ranks)
            self.assertEqual(self.values(result.output)["wrong"], 0)
            finals.append(self.dump("end.dump"))
        one = finals[0]
        numpy.testing.assert_allclose(one[:, 4] - 1.25, 2 * (one[:, 3] - 0.25), rtol=1e-12, atol=1e-12)
        numpy.testing.assert_array_equal(one[:, 6], one[:, 3])
        self.assertEqual(len(set(one[:, 3])), self.GRAINS)    # no two are alike
        for other in finals[1:]:
            numpy.testing.assert_array_equal(other, one)

    def test_new_grains_have_the_initial_state(self):
        """Inserted all along the run, beside others: the probe counts those that have not."""
        result = self.liggghts(self.head(boundary="f f f") + BOX + self.CLOUD + f"""
            {self.MATERIAL}
            {probe(10)}
            fix pt all particletemplate/sphere 15485863 atom_type 1 density constant 2950 &
                radius constant 4e-5 volume_limit 1e-16
            fix pd all particledistribution/discrete 32452843 1 pt 1.0
            region half block 0.011 0.019 0.001 0.009 0.001 0.009 units box
            fix in all insert/pack seed 86028121 distributiontemplate pd vel constant 1 0 0 &
                insert_every 37 overlapcheck no all_in yes particles_in_region 2500 region half
            fix i all nve/sphere
            {self.VARIABLES}
            run 300
            {self.PRINT}
        """, 2)
        end = self.values(result.output)
        self.assertGreater(end["atoms"] + end["removed"], self.GRAINS + 500)
        self.assertGreater(end["removed"], 100)
        self.assertEqual(end["wrong"], 0)

    def test_restart(self):
        """From the middle of a run: bit for bit as if it had not stopped. From between two runs and with
        another number of ranks: what was written is read."""
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {probe(50)}
            fix i all nve/sphere
            {self.DUMP.format("whole.dump")}
            restart 120 r.*
            run 200
            write_restart end.restart
        """, 2)
        whole = self.dump("whole.dump")
        self.liggghts(self.head() + READ.format(name="r.120") + f"""
            {probe(50)}
            fix i all nve/sphere
            {self.DUMP.format("rest.dump")}
            run 80
        """, 2)
        numpy.testing.assert_array_equal(self.dump("rest.dump"), whole)

        for ranks, fluid in ((1, probe(50)), (4, "fix f all fluid/force coupled")):
            self.liggghts(self.head() + READ.format(name="end.restart") + f"""
                {fluid}
                fix i all nve/sphere
                {self.DUMP.format("read.dump")}
                run 0
            """, ranks)
            numpy.testing.assert_array_equal(self.dump("read.dump"), whole)

    def test_state_that_no_model_asks_for(self):
        """It ends with the run of the coupling that does not ask: the next one begins with the initial values.
        One that joins does so, too."""
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {probe(50, "state memory 3")}
            fix i all nve/sphere
            run 100
            write_restart 1.restart
        """)
        self.liggghts(self.head() + READ.format(name="1.restart") + f"""
            {probe(50, "state one 1")}
            fix i all nve/sphere
            run 100
            write_restart 2.restart
        """)
        self.liggghts(self.head() + READ.format(name="2.restart") + f"""
            fix f all fluid/force coupled
            fix i all nve/sphere
            dump d all custom 100 end.dump id f_fluidState_one
            dump_modify d format "%d %.17g"
            run 0
        """)
        self.assertGreater(len(set(self.dump("end.dump")[:, 1])), 1000)
        result = self.liggghts(self.head() + READ.format(name="2.restart") + """
            fix f all fluid/force coupled
            fix i all nve/sphere
            dump d all custom 100 end.dump id f_fluidState_memory[1]
            run 0
        """, check=False)
        self.assertFails(result, "Could not find dump custom fix ID")


class BadRequests(FluidCase):

    def refused(self, states, *words, ranks=0, before="", read=None):
        start = READ.format(name=read) if read else BOX + self.CLOUD
        result = self.liggghts(self.head() + start + f"""
            {before}
            {probe(50, states)}
            fix i all nve/sphere
            run 1
        """, ranks, check=False)
        self.assertFails(result, *words)
        self.assertEqual(result.output.count("ERROR"), 1, result)

    def test_states(self):
        for ranks in (0, 2):
            self.refused("state a/b 1", "Fix fluid/force (ID f)", "'a/b'", "letters, digits and _", ranks=ranks)
        self.refused("state m 2 state m 3", "Fix fluid/force (ID f)", "'m' has 2 numbers", "asks for 3", "another name")
        self.refused("state m 0", "Fix fluid/force (ID f)", "'m'", "at least one number", "not 0")
        self.refused("state m 1", "Fix fluid/force (ID f)", "fluidState_m", "another ID",
                     before="fix fluidState_m all property/atom fluidState_m scalar no no no 0.")

    def test_other_size_than_in_the_restart_file(self):
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {probe(50, "state m 2")}
            fix i all nve/sphere
            run 1
            write_restart m.restart
        """)
        self.refused("state m 3", "Fix fluid/force (ID f)", "'m' has 2 numbers", "restart file", read="m.restart", ranks=2)

    def test_restart_file_of_another_layout(self):
        """The layout is the first number of the fix in the file."""
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {probe(50)}
            fix i all nve/sphere
            run 1
            write_restart m.restart
        """)
        path = self.folder / "m.restart"
        content = path.read_bytes()
        mark = b"fluid/force\0"
        place = content.index(mark) + len(mark) + 4    # the length is between the two
        self.assertEqual(struct.unpack("d", content[place:place + 8]), (4.0,))
        path.write_bytes(content[:place] + struct.pack("d", 1.0) + content[place + 8:])
        for ranks in (0, 2):
            self.refused(STATES, "Fix fluid/force", "another version of Grainjet", read="m.restart", ranks=ranks)

    def test_unfix_and_again(self):
        """Everything requested goes with the fix and may be requested anew."""
        fluid = probe(1, "nonReacting 1e-8 0 torque 1e-17 0 0 state m 3")
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            {fluid}
            fix i all nve/sphere
            run 2
            unfix d
            unfix f
            {probe(1, "state m 2")}
            run 2
            unfix d
            {fluid.replace("state m 3", "")}
            run 2
        """, 2)


class Torque(FluidCase):

    def spin(self, torque, dt, steps, omega, ranks=0):
        """Spin of a single grain at each step under the probe's torque, which begins after step 1."""
        result = self.liggghts(self.head() + BOX + f"""
            create_atoms 1 single 0.003 0.003 0.003 units box
            set group all diameter {self.DIAMETER} density {self.DENSITY} omegaz {omega}
            timestep {dt!r}
            plugin load {PROBE}
            fix f all fluid/force coupled
            fix d all exchange/probe 1 0 0 0 0 {torque}
            fix i all nve/sphere
            compute w all property/atom omegaz
            compute s all reduce sum c_w f_fluidTorque[3]
            thermo_style custom step c_s[1] c_s[2]
            thermo_modify format float %.17g
            thermo 1
            run {steps}
        """, ranks)
        rows = [line.split() for line in result.output.splitlines()]
        rows = [[float(word) for word in row] for row in rows if len(row) == 3 and row[0].isdigit()]
        return numpy.array(rows)

    def test_decay(self):
        """exp(-C t / I) in fluid at rest. The torque is there from the end of step 2 on, with a whole kick for the
        half that is left; whole-step values carry the factor cosh(dt / 2 tau) of the mean of two half-step ones."""
        tau = 1e-4
        for dt in (tau / 20, 2 * tau):
            rows = self.spin(f"torque {INERTIA / tau!r} 0 0", dt, 20, 100)[2:]
            expected = 100 * numpy.exp(-(rows[:, 0] - 1.5) * dt / tau) * math.cosh(dt / (2 * tau))
            numpy.testing.assert_allclose(rows[:, 1], expected, rtol=1e-10)

    def test_terminal_spin(self):
        """Spin of the fluid plus torque by coefficient; the coefficient far faster than the step, too."""
        for tau, ranks in ((1e-5, 0), (1e-9, 2)):
            c = INERTIA / tau
            rows = self.spin(f"torque {c!r} 50 {30 * c!r}", 1e-5, 100, 100, ranks=ranks)
            numpy.testing.assert_allclose(rows[-10:, 1], 80, rtol=1e-12)
            numpy.testing.assert_allclose(rows[-10:, 2] / c, 0, atol=1e-9)

    def test_constant_torque(self):
        """Without a coefficient: T t / I, first half kick at the end of step 2."""
        torque = 1e-3 * INERTIA
        rows = self.spin(f"torque 0 0 {torque!r}", 1e-5, 50, 0)[2:]
        numpy.testing.assert_allclose(rows[:, 1], 1e-3 * (rows[:, 0] - 1.5) * 1e-5, rtol=1e-12)
        numpy.testing.assert_array_equal(rows[:, 2], torque)

    def test_no_number(self):
        result = self.liggghts(self.head() + BOX + self.CLOUD + f"""
            plugin load {PROBE}
            fix f all fluid/force coupled
            fix d all exchange/probe 1 0 0 0 0 torque 1e-17 nan 0
            fix i all nve/sphere
            run 10
        """, 2, check=False)
        self.assertFails(result, "Fix fluid/force (ID f): the fluid's torque on grain", "in step 2", "rad/s")

    def test_restart(self):
        """From the middle of a run, bit for bit; grains that spin under torque."""
        fluid = f"""
            plugin load {PROBE}
            fix f all fluid/force coupled
            fix d all exchange/probe 75 8.0 300.0 2e-8 1e-9 torque {INERTIA / 1e-3!r} 50 {1e3 * INERTIA!r}
            fix i all nve/sphere
        """
        dump = ("dump d all custom 200 {} id omegax omegaz f_fluidTorque[1] f_fluidTorque[3] f_fluidSpin[3] "
                'f_fluidSpinCoefficient f_fluidExplicitTorque[3]\ndump_modify d format "%d' + 7 * " %.17g" + '"')
        self.liggghts(self.head() + BOX + self.CLOUD + f"""
            set group all omegax 10
            {fluid}
            {dump.format("whole.dump")}
            restart 120 r.*
            run 200
        """, 2)
        self.liggghts(self.head() + READ.format(name="r.120") + f"""
            {fluid}
            {dump.format("rest.dump")}
            run 80
        """, 2)
        whole = self.dump("whole.dump")
        self.assertGreater(abs(whole).min(), 0)
        numpy.testing.assert_array_equal(self.dump("rest.dump"), whole)


if __name__ == "__main__":
    unittest.main()
