# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A coupled run ends as a run of LIGGGHTS does: each fix gets its post_run, whatever has ended the time loop;
and what fixes have found is on disk with each restart file."""
# processors: 2

import csv
import os
import re
import shutil
import signal
import time
import unittest

import grainjet
from grainjet import dumps
from grainjet import coupled_box as box

# Nothing is due within a run: no table (every), no events (gathered each 1000 DEM steps)
PLATE = """
fix w all wall/gran model hertz tangential history primitive type 1 zplane 0.0 store_force yes
fix p all plate/stats wall w centre 0.01 0.01 {z} normal 0 0 1 radius 0.004 rings 2 &
    file plate.csv events events.csv every 1000000000
"""
PLUGINS = "plugin load platestatsplugin.so\nplugin load hertzcgplugin.so"

# Two grains hit the plate, after 0.7 ms and after 1.3 ms; two more meet in the air, and sink into each
# other by more than fix hertz/cg allows
GRAINS = box.grains([(0.01, 0.01, 0.0008), (0.0115, 0.01, 0.0014), (0.005, 0.015, 0.010), (0.005, 0.015, 0.0108)],
                    [(0, 0, -1), (0, 0, -1), (0, 0, 4), (0, 0, -4)])


class End(grainjet.Case):

    def case(self, name, plate=PLATE.format(z=0), fixes="", end="", modifiable="no", tables="", **fluid):
        folder = self.folder / name
        (folder / tables).mkdir(parents=True)
        box.write(folder, **{"walls": True, "cells": "4 4 8", "steps": 33, "write_every": 100000, **fluid})
        box.script(folder, grains=GRAINS, end=end, boundary="f f f", box="0 0.02 0 0.02 -0.001 0.04", plugins=PLUGINS,
                   fixes="fix c all hertz/cg tangential history\n" + plate.replace("plate.csv", tables + "plate.csv") + fixes)
        box.fv_options(folder)
        control = folder / "system/controlDict"
        text = control.read_text()
        self.assertIn("runTimeModifiable no", text)
        control.write_text(text.replace("runTimeModifiable no", f"runTimeModifiable {modifiable}"))
        for command in ("blockMesh", "decomposePar"):
            self.foam(command, folder)
        return folder

    def rows(self, folder, name="plate.csv"):
        with open(folder / name) as file:
            return list(csv.DictReader(file))

    def solver(self, folder, ranks):
        """Output of a run that must end well, from a state without former results."""
        for name in ("plate.csv", "events.csv"):
            (folder / name).unlink(missing_ok=True)
        return self.foam("pimpleFoam", folder, ranks, timeout=60).output

    def assertEnded(self, folder, output, last):
        """All of post_run is there, for the time of the last step."""
        self.assertEqual(re.findall(r"\nTime = (\S+)", output)[-1], f"{last:g}")
        whole = self.rows(folder)[0]
        self.assertEqual(whole["region"], "all")
        # both are printed with 10 digits
        self.assertAlmostEqual(float(whole["time"]), last, delta=1e-9 * last)
        self.assertEqual((whole["collisions"], whole["touching"]), ("2", "0"))
        self.assertEqual([row["id"] for row in self.rows(folder, "events.csv")], ["1", "2"])
        self.assertEqual(output.count("contacts since the start were deeper"), 2, output)   # warning and summary

    def test_end_time(self):
        folder = self.case("plain")
        for ranks in (0, 2):
            self.assertEnded(folder, self.solver(folder, ranks), 0.0033)

    def test_other_ends(self):
        """Orders to stop, which are there when the run starts or come from a function object."""
        condition = """ended { type runTimeControl; libs ("libutilityFunctionObjects.so");
            conditions { when { type maxDuration; duration 0.0025; } } satisfiedAction end; }"""
        for name, edit, fluid in (
                ("nextWrite", ("stopAt endTime", "stopAt nextWrite"), {"write_every": 21, "steps": 50}),
                ("runTimeControl", None, {"functions": condition, "steps": 50})):
            folder = self.case(name, **fluid)
            if edit:
                control = folder / "system/controlDict"
                text = control.read_text()
                self.assertIn(edit[0], text)
                control.write_text(text.replace(*edit))
            for ranks in (0, 2):
                output = self.solver(folder, ranks)
                last = float(re.findall(r"\nTime = (\S+)", output)[-1])
                self.assertLess(last, 0.0045)
                self.assertEnded(folder, output, last)

    def running(self, folder, ranks=0):
        """A run without a foreseen end, to be used in `with`."""
        parallel = ["-parallel"] if ranks else []
        return grainjet.start([*grainjet.mpirun(ranks), "pimpleFoam", *parallel], folder, folder / "log",
                              env={"PWD": str(folder)})

    def test_signal_that_asks_to_stop(self):
        """OpenFOAM's stopAtWriteNowSignal: the run writes and ends."""
        folder = self.case("signal", steps=1000000,
                           control=f"OptimisationSwitches {{ stopAtWriteNowSignal {int(signal.SIGUSR2)}; }}")
        with self.running(folder) as process:
            process.wait_for_words("\nTime = 0.005\n")
            process.process.send_signal(signal.SIGUSR2)
            code = process.process.wait(60)
        output = (folder / "log").read_text()
        self.assertEqual(code, 0, output[-2000:])
        last = float(re.findall(r"\nTime = (\S+)", output)[-1])
        self.assertTrue((folder / f"{last:.10g}" / "uniform/liggghts.restart").exists())
        self.assertEnded(folder, output, last)

    def stopped_without_writing(self, folder, ranks, before=lambda: None):
        """Exit code and output of a run that controlDict stops by noWriteNow in its course."""
        control = folder / "system/controlDict"
        with self.running(folder, ranks) as process:
            process.wait_for_words("\nTime = 0.005\n")
            before()
            control.write_text(control.read_text().replace("stopAt endTime", "stopAt noWriteNow"))
            # OpenFOAM takes a file for changed if it is newer by more than ten seconds
            os.utime(control, (time.time() + 60, time.time() + 60))
            code = process.process.wait(60)
        return code, (folder / "log").read_text()

    def test_stop_without_writing(self):
        for ranks in (0, 2):
            folder = self.case(f"stop{ranks}", steps=1000000, modifiable="yes")
            code, output = self.stopped_without_writing(folder, ranks)
            self.assertEqual(code, 0, output[-2000:])
            last = re.findall(r"\nTime = (\S+)", output)[-1]
            self.assertFalse((folder / ("processor0" if ranks else ".") / last).exists())
            self.assertEnded(folder, output, float(last))

    def test_a_table_that_cannot_be_written_at_the_end(self):
        """Its folder has vanished meanwhile: an error as any other."""
        for ranks in (0, 2):
            folder = self.case(f"vanished{ranks}", steps=1000000, modifiable="yes", tables="tables/")
            code, output = self.stopped_without_writing(folder, ranks, lambda: shutil.rmtree(folder / "tables"))
            self.assertEqual(code, 1, output[-2000:])
            message = output[output.index("FOAM FATAL"):]
            self.assertIn("Fix plate/stats (ID p): cannot write file 'tables/plate.csv.new'", message)
            self.assertNotIn("Warnings of LIGGGHTS", output)

    def test_plate_beside_its_wall(self):
        # the fix looks for such grains when neighbour lists are made
        folder = self.case("beside", plate=PLATE.format(z=0.03) + "neigh_modify every 1 check no")
        for ranks in (0, 2):
            output = self.solver(folder, ranks)
            self.assertIn("FOAM Warning", output)
            self.assertEqual(output.count("wall 'w' has touched grains, but none at the plate"), 2, output)

    def test_an_error_is_no_end(self):
        """The run stops in step 250, after the restart file of step 200: its table stays as it was there."""
        folder = self.case("error", write_every=20, fixes='\nfix stop all print 250 "$(1/0)"')
        for ranks in (0, 2):
            for name in ("plate.csv", "events.csv"):
                (folder / name).unlink(missing_ok=True)
            result = self.foam("pimpleFoam", folder, ranks, check=False, timeout=60)
            self.assertEqual(result.code, 1, result)
            self.assertIn("FOAM FATAL", result.output)
            self.assertNotIn("Warnings of LIGGGHTS", result.output)
            self.assertAlmostEqual(float(self.rows(folder)[0]["time"]), 0.002, delta=1e-12)
            self.assertEqual(len(self.rows(folder, "events.csv")), 2)

    def test_killed_run(self):
        """Whenever a run is killed: table, events and log are as new as the restart file."""
        for ranks in (0, 2):
            folder = self.case(f"killed{ranks}", write_every=20, steps=1000000, end="thermo 200")
            first = folder / ("processor0" if ranks else ".") / "0.002/uniform/liggghts.restart"
            with self.running(folder, ranks) as process:
                process.wait_for(first.exists, str(first))
            written = float(self.rows(folder)[0]["time"])
            self.assertGreaterEqual(written, 0.002 * (1 - 1e-9))
            self.assertAlmostEqual(written / 0.002, round(written / 0.002), delta=1e-6)
            self.assertEqual(len(self.rows(folder, "events.csv")), 2)
            self.assertIn("contacts since the start were deeper", (folder / "log.liggghts").read_text())
            # a line of the log at each restart file, which LIGGGHTS leaves in memory until there are dozens
            self.assertRegex((folder / "log.liggghts").read_text(), rf"(?m)^ *{round(written / 1e-5)} +4 ")

    def test_writing_changes_nothing(self):
        """Grains and table of a run with write times and of one without."""
        dump = "\ndump d all custom 330 grains.*.txt id x y z vx vy vz omegax omegay omegaz\ndump_modify d format \"%d" + 9 * " %.17g" + '"'
        for ranks in (0, 2):
            results = []
            for name, every in (("without", 100000), ("with", 5)):
                folder = self.case(f"{name}{ranks}", fixes=dump, write_every=every)
                self.solver(folder, ranks)
                grains = dumps.last(folder / "grains.330.txt")
                self.assertEqual(len(grains), 4)
                results.append((grains, (folder / "plate.csv").read_text()))
            self.assertEqual(*results)


if __name__ == "__main__":
    unittest.main()
