# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command of the measured pipes at tiny size: it runs, compares, uses finished runs again; the momentum of a periodic pipe
with grains is balanced; its comparison and wall law are right; what it says to wrong words."""
# label: long

import csv
import math
import unittest

import numpy

import grainjet
import pipe_profiles
from grainjet import programs, tables
from pipe_table import Pipes, version

COMMAND = grainjet.ROOT/"validation/pipes/pipes.py"


class Command(grainjet.Case):

    def call(self, *words):
        return programs.run([COMMAND, self.folder/"work", "--size", "tiny", "--results", self.folder/"results", *words], self.folder)

    def points(self):
        """Files in the form of the measured points, their numbers made up."""
        for name, text in {"tsuji1984_vertical_pipe/case01_w_average.csv": "0.0,15.6\n-0.5,15.6\n",
                           "tsuji1984_vertical_pipe/case01_w_particle_average.csv": "0.5,14.0\n0.8,14.0\n",
                           "huber_sommerfeld1998_pipe/p_velocity_exp_avg.csv": "1.0, -0.5\n1.0, 0.5\n"}.items():
            path = self.folder/"data"/name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return self.folder/"data"

    def rows(self):
        with (self.folder/"results/errors.csv").open() as file:
            return {(row["case"], row["model"]): row for row in csv.DictReader(file)}

    def test_runs_and_compares(self):
        """A vertical and a horizontal pipe; errors in the table are those of the difference to the points."""
        data = self.points()
        result = self.call("--data", data, "--cases", "tsuji-200-1", "huber", "--models", "base", "roughness+cell")
        self.assertEqual(result.code, 0, result)
        rows = self.rows()
        self.assertEqual(len(rows), 4)
        for (case, model), row in rows.items():
            self.assertTrue(0 < float(row["rms error particles"]) < 1, row)
            self.assertEqual(row["rms error gas"] == "", case == "huber")
            self.assertEqual((row["lost"], row["version"]), ("0", version()))
            self.assertAlmostEqual(float(row["loading"])/float(row["loading wanted"]), 1, delta=0.15)
        for case in ("tsuji-200-1", "huber"):
            self.assertTrue((self.folder/f"results/{case}_tiny.png").is_file())
        self.assertIn("no ", result.output)          # of the missing files
        before = (self.folder/"work/tsuji-200-1_tiny_base/finished.json").stat().st_mtime_ns
        result = self.call("--data", data, "--cases", "tsuji-200-1")
        self.assertEqual(result.code, 0, result)
        self.assertEqual((self.folder/"work/tsuji-200-1_tiny_base/finished.json").stat().st_mtime_ns, before)
        self.assertEqual(len(self.rows()), 4)

    def test_without_data(self):
        result = self.call("--cases", "tsuji-500-1")
        self.assertEqual(result.code, 0, result)
        self.assertIn("No measured points", result.output)
        self.assertFalse((self.folder/"results/errors.csv").exists())
        self.balance(self.folder/"work/tsuji-500-1_tiny_base", "tsuji-500-1")

    def balance(self, case, name):
        """The bulk velocity is held, so at any time the driving force carries wall friction and what the grains take from the
        gas (their weight, once they have stopped gaining speed). The friction comes from Spalding's law and the mean velocity of
        the cells at the wall, which is within some per cent in a flow that is still changing."""
        force = pipe_profiles.balance(case, Pipes().run(name, "tiny"))
        self.assertGreater(force["taken"], 0.1*force["drive"])
        self.assertAlmostEqual((force["friction"] + force["taken"])/force["drive"], 1, delta=0.05)
        # and the grains have it, but for one step
        self.assertAlmostEqual(force["received"]/force["taken"], 1, delta=0.02)
        t = tables.read(case/"postProcessing/liggghtsCoupling/0/balance.dat")
        self.assertEqual(t["outsideMesh"].max(), 0)
        self.assertEqual(t["leftBox"].max(), 0)

    def test_wrong_words(self):
        for words, said in ((("--cases", "tsuji"), "no case 'tsuji'; there are tsuji-200-1"),
                            (("--models", "base+magic"), "no model 'magic'; there are base"),
                            (("--cases", "huber", "--size", "giant"), "no size 'giant'; there are standard"),
                            (("--data", "nowhere"), "nowhere: no such folder")):
            result = self.call(*words)
            self.assertEqual(result.code, 1, result)
            self.assertIn(said, result.output)
            self.assertFalse((self.folder/"work").exists())


class Lost(grainjet.Case):

    def test_all_fates_count(self):
        """Of 100 grains 2 left the box, 1 was deleted, 3 vanished and 4 are outside of the mesh; before the end it was one more."""
        path = self.folder/"postProcessing/liggghtsCoupling/0/balance.dat"
        path.parent.mkdir(parents=True)
        path.write_text("# Time\tinserted\tpresent\tleftBox\tdeleted\tunaccounted\toutsideMesh\n"
                        "0.1\t100\t94\t2\t1\t3\t5\n0.2\t100\t94\t2\t1\t3\t4\n")
        self.assertEqual(pipe_profiles.lost(self.folder), 10)


class Comparison(unittest.TestCase):

    def test_difference(self):
        """A profile that is 0.3 and 0.5 too high at two points of three; the third lies where no grain came."""
        profile = {"position": numpy.array([0.1, 0.3, 0.5]), "value": numpy.array([10.0, 12.0, 14.0])}
        points = numpy.array([-0.2, 0.4, 0.9]), numpy.array([10.7, 12.5, 3.0])
        found = pipe_profiles.difference(profile, points, 2.0, symmetric=True)
        self.assertAlmostEqual(found["rms"], math.sqrt((0.15**2 + 0.25**2)/2))
        self.assertAlmostEqual(found["mean"], 0.2)
        self.assertEqual(found["missing"], 1)

    def test_spalding(self):
        """Linear at the wall, logarithmic far from it: u+ = ln(E y+)/0.41; and back to u_tau."""
        self.assertAlmostEqual(pipe_profiles.spalding(1), 1, delta=0.002)
        self.assertAlmostEqual(pipe_profiles.spalding(1000), math.log(9.8*1000)/0.41, delta=0.05)
        u = 0.7*pipe_profiles.spalding(0.7*1e-3/1.5e-5)
        self.assertAlmostEqual(pipe_profiles.friction_velocity(u, 1e-3, 1.5e-5), 0.7, delta=1e-6)

    def test_table(self):
        """All cases and models can be made; models add up."""
        pipes = Pipes()
        for case in pipes.data["case"]:
            for size in pipes.data["size"]:
                s = pipes.run(case, size)
                self.assertGreater(s["grains"], 0)
                self.assertLessEqual(s["demStep"]*s["couplingInterval"], s["fluidStep"]*(1 + 1e-12))
        both = pipes.model("wallLaw+lift+roughness")
        self.assertEqual(both["options"], {"wallLaw": "yes"})
        self.assertEqual(both["forces"], ["SaffmanMei", "Magnus", "fluidTorque"])
        self.assertEqual(len(both["script"]), 1)
        # a sphere twice as large counts eightfold
        self.assertAlmostEqual(pipes.run("tsuji-500-1", "coarse")["grains"], pipes.run("tsuji-500-1")["grains"]/8, delta=1)


if __name__ == "__main__":
    unittest.main()
