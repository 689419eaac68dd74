# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix grain/motion against the stock nve/sphere, gravity and fix fluid/force in a step of their own.

200 grains of 1 mm fall on a floor and into each other, about 300 contacts in 370 steps. The operations on one
grain are the same; the weight is added before the contacts instead of behind them, and the impulse is summed in
another order. So free grains have the same digits, and others differ by round-off, which contacts magnify: 1e-12
of the largest number after 370 steps.
"""
# processors: 2
# label: long

import re
import signal
import subprocess
import unittest

import numpy

import grainjet
from grainjet import dumps, scripts
from motion_case import CLOUD, FLOOR, FLUID, MOTION, PAIR, SETTINGS, STATE, STOCK, WITHOUT, MotionCase

CLOSE = 1e-12
WIND = "fix f all fluid/force uniform 3 1 0.5 density 1.2 viscosity 1.5e-5 drag gidaspow buoyancy yes {}\n"
PLAYED = "fix f all fluid/force coupled\n"
PROBED = "fix d all exchange/probe 20 4.0 200.0 1e-5 2e-6 {}\n"


class EqualsStock(MotionCase):

    def script(self, pair="hertz/cg", columns=STATE, fluid="", probe="", more="", floor="", head=(), run="run 370",
               **moved):
        def text(kind):
            return (self.head(**dict(head)) + CLOUD + SETTINGS + PAIR[pair] + FLOOR.format(more=floor)
                    + self.moved(kind, fluid=fluid, **moved) + probe + more.replace("KIND", kind)
                    + self.dump(kind, columns) + run + "\n")
        return text

    def test_contacts_and_walls(self):
        """Both contact models, floor with stored forces, sorting in memory, and two ranks."""
        for pair in PAIR:
            for head in ({}, {"sort": "20 0.001"}):
                self.compare(self.script(pair, head=head), STATE, CLOSE, ranks=(0, 2), joined=True)

    def test_free_grains_have_the_same_digits(self):
        """No contact, so nothing is added in another order."""
        wind = WIND.format("")
        columns = STATE + " f_fluidForce[1] f_fluidForce[2] f_fluidForce[3]"
        script = self.script(fluid=wind, gravity="9.81 0.3 0 -1", columns=columns)
        self.compare(lambda kind: script(kind).replace("diameter 1e-3", "diameter 1e-4"), columns, 0.0, joined=True)

    def test_uniform_flow(self):
        for words, joined in (("", True), ("addedMass 0.5 magnus yes", True), ("rotation yes magnus yes", False)):
            self.compare(self.script(fluid=WIND.format(words), columns=STATE + " " + FLUID), STATE + " " + FLUID, CLOSE,
                         ranks=(0, 2), joined=joined)

    def test_coupled(self):
        """All that a coupling may ask for, played by a small plugin; also what it took (its vector)."""
        for words, more, joined in (("", "", True), ("nonReacting 5e-6 -3e-6", WITHOUT, True),
                                    ("nonReacting 5e-6 -3e-6 addedMass 2e-7", WITHOUT, True),
                                    ("torque 1e-12 500 1e-10 work", "", False)):
            columns = " ".join((STATE, FLUID, more)).strip()
            total = "thermo_style custom step atoms " + " ".join(f"f_f[{k}] f_d[{k}]" for k in (1, 2, 3)) + " f_f[4]\n" \
                "thermo_modify format float %.15g\nthermo 37\n"
            outputs = self.compare(self.script(fluid=PLAYED, probe=PROBED.format(words), columns=columns, more=total),
                                   columns, CLOSE, ranks=(2, 0), joined=joined)
            tables = [numpy.array([line.split() for line in text.splitlines() if len(line.split()) == 9
                                   and line.split()[0].isdigit()], dtype=float) for text in outputs]
            self.assertEqual(tables[0].shape, (11, 9))
            scale = abs(tables[0]).max(axis=0)
            scale[scale == 0.0] = 1.0
            numpy.testing.assert_allclose(tables[1] / scale, tables[0] / scale, rtol=0, atol=CLOSE)

    def test_frozen_grains_and_forces_of_the_script(self):
        """freeze and setforce see the weight, as they do behind a fix gravity; so does a fix gravity of the script."""
        groups = "group ice id <= 40\nvelocity ice set 0 0 0\ngroup held id 41:80\n"
        for more, joined in (("fix z ice freeze\n", True), ("fix s held setforce 1e-5 NULL NULL\n", False)):
            self.compare(self.script("gran", more=groups + more), STATE, CLOSE, joined=joined)
        self.compare(self.script(inside=False), STATE, CLOSE, joined=False)

    def test_grains_of_other_groups_rest(self):
        self.compare(self.grouped, STATE, CLOSE, joined=True)

    def grouped(self, kind):
        text = self.script("gran", group="moving", gravity="9.81 0 0 -1")(kind)
        return text.replace("fix m1 ", "group still id <= 40\nvelocity still set 0 0 0\n"
                            "group moving subtract all still\nfix m1 ", 1)

    def test_two_dimensions(self):
        def text(kind):
            script = self.script("gran", head={"dimension": 2, "boundary": "p p p"}, gravity="9.81 0 -1 0",
                                 more="fix e all enforce2d\n")(kind)
            script = script.replace("block 0 0.02 0 0.01 0 0.02", "block 0 0.02 0 0.01 -0.0006 0.0006")
            script = script.replace("0.0095 0.0002 0.006", "0.0095 -0.0001 0.0001").replace("zplane", "yplane")
            return script.replace("lattice sc 0.00125 origin 0.45 0.45 0.45", "lattice sq 0.00125 origin 0.45 0.45 0").replace("velocity all set v_vx v_vy v_vz",
                                                                      "velocity all set v_vx v_vy 0")
        self.compare(text, STATE, CLOSE)

    def test_plate_statistics(self):
        """plate/stats sees whole steps: the same files."""
        plate = "fix p all plate/stats wall w centre 0.01 0.005 0 normal 0 0 1 radius 0.02 rings 2 file KIND.csv events KIND.events\n"
        self.compare(self.script(floor="store_force yes", more=plate), STATE, CLOSE, joined=False)
        for name in ("csv", "events"):
            tables = [numpy.genfromtxt(self.folder / f"{kind}.{name}", delimiter=",", names=True, dtype=None, encoding=None)
                      for kind in (STOCK, MOTION)]
            self.assertGreater(len(tables[0]), 2)
            for field in tables[0].dtype.names:
                if tables[0][field].dtype.kind in "fi":
                    scale = max(abs(tables[0][field])) if name == "events" else 1.0
                    numpy.testing.assert_allclose(tables[1][field], tables[0][field], rtol=1e-6, atol=1e-6 * scale,
                                                  err_msg=field)

    def test_inserted_grains(self):
        """Grains that insert/stream still carries are put where they belong at the end of each step: joined steps
        leave them for the next one. Removal by an open side, and what the coupling is told of removed grains."""
        (self.folder / "face.stl").write_text(scripts.stl(*scripts.rectangle(
            (0.004, 0.002, 0.018), (0.016, 0.002, 0.018), (0.016, 0.008, 0.018), (0.004, 0.008, 0.018))))
        more = """
            fix face all mesh/surface/planar file face.stl type 1
            fix pt all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0004
            fix pd all particledistribution/discrete 15485867 1 pt 1.0
            fix in all insert/stream seed 86028157 distributiontemplate pd nparticles 300 &
                particlerate 100000 overlapcheck yes all_in no vel constant 0.0 0.0 -4.0 omega constant 0 50 0 &
                insertion_face face extrude_length 0.0015
        """
        columns = STATE + " " + FLUID
        script = self.script(fluid=PLAYED, probe=PROBED.format(""), columns=columns, more=more, run="run 1480",
                             head={"boundary": "f f f"})
        stock, motion = self.compare(lambda kind: script(kind).replace("dump d all custom 37", "dump d all custom 370"),
                                     columns, CLOSE, joined=True)
        self.assertIn("inserted", stock)

    def test_continued_runs(self):
        """Runs in parts, without set-up between them, and through a restart file: the same as with stock fixes."""
        parts = "run 100\nrun 70 pre no\nwrite_restart KIND.restart\nrun 50\nrun 150 every 30 \"print again\""
        def text(kind):
            return self.script(fluid=PLAYED, probe=PROBED.format(""), columns=STATE + " " + FLUID, run=parts)(kind).replace("KIND", kind)
        self.compare(text, STATE + " " + FLUID, CLOSE, ranks=(0, 2), joined=True)

        def again(kind):
            return (self.head() + f"read_restart {kind}.restart\n" + SETTINGS + PAIR["hertz/cg"] + FLOOR.format(more="")
                    + self.moved(kind, fluid=PLAYED) + PROBED.format("") + self.dump(kind, STATE + " " + FLUID)
                    + "run 126\n")
        self.compare(again, STATE + " " + FLUID, CLOSE, joined=True)

    def test_restart_files_on_signals(self):
        """SIGUSR1 at any moment: LIGGGHTS writes a restart file behind the present step. It holds grains at a whole step, where
        stock integration has them, to 1e-12 m (seen: 4e-18); half a step ahead they would be up to 5e-7 m away. Without
        contacts, so that most of a step is the pass in which the next one would begin."""
        def text(kind, run):
            return self.script(run=run, gravity="9.81 0 0 -1")(kind).replace("diameter 1e-3", "diameter 1e-5")
        (self.folder / "in.signal").write_text(text(MOTION, "undump d\nthermo 50\nrestart 1000000 step.*\nrun 3000"))
        program = ["env", f"LD_PRELOAD={grainjet.ROOT / 'lib' / 'liggghtsloader.so'}", "liggghts", "-in", "in.signal"]
        with subprocess.Popen(program, cwd=self.folder, env=grainjet.ENV, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True) as process:
            # at each line of thermo, which the program does not wait for
            for line in process.stdout:
                if re.match(r" *[1-9]\d* ", line):
                    process.send_signal(signal.SIGUSR1)
        files = {int(re.search(r"\d+", path.name)[0]): path.name
                 for path in self.folder.glob("restart_forced_liggghts_*.data")}
        self.assertGreater(len(files), 10)
        steps = sorted(files)[:20]

        # a file for each step, of which some are read
        self.liggghts(text(STOCK, "undump d\n" + scripts.dump(1, "stock.*", "id x y z") + f"run {steps[-1]}"))
        self.liggghts("clear\n".join(
            self.head() + f"read_restart {files[step]}\n" + SETTINGS + PAIR["hertz/cg"] + FLOOR.format(more="")
            + scripts.dump(1, f"forced.{step}", "id x y z") + "run 0\n" for step in steps))
        for step in steps:
            found, expected = (dumps.array(self.folder / f"{kind}.{step}") for kind in ("forced", "stock"))
            away = (found - expected)[:, 1:]
            period = numpy.array([0.02, 0.01, 1.0])    # a grain on a side is on both
            away -= period * numpy.round(away / period)
            self.assertLess(abs(away).max(), 1e-12, f"step {step}")

    def test_taken_out_again(self):
        """Behind unfix LIGGGHTS clears forces itself again."""
        def text(kind):
            return self.script(run="run 100")(kind) + ("unfix i\n" + "unfix g\n" * (kind == STOCK)
                                                       + self.moved(STOCK) + "run 85\n")
        self.compare(text, STATE, CLOSE)


if __name__ == "__main__":
    unittest.main()
