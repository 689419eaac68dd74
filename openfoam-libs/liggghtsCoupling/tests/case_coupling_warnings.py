# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of LIGGGHTS in the solver's log: each once, with its count at the end, from any rank."""
# processors: 2

import re
import unittest

import bad_case
import grainjet
from grainjet import coupled_box as box

PLUGIN = f"plugin load {grainjet.ROOT}/lib/tests/warningplugin.so"


class Warnings(bad_case.BadCase):

    def case(self, fixes, **script):
        folder = self.fresh()
        box.script(folder, grains=bad_case.GRAIN, boundary="f f f", plugins=PLUGIN, fixes=fixes, **script)
        return folder

    def counts(self, output):
        """{first words of a warning: (times printed, count at the end, words at the end)}."""
        head, _, summary = output.partition("Warnings of LIGGGHTS, with the latest words of each:\n")
        result = {}
        for count, plural, words in re.findall(r"(?m)^    (\d+) time(s?): (.*) \(\S+:\d+\)$", summary):
            self.assertEqual(plural, "" if count == "1" else "s")
            name = words.split(" at step")[0]
            self.assertNotIn(name, result)
            result[name] = (head.count(f": {name} at step"), int(count), words)
        self.assertEqual(len(result), head.count("FOAM Warning : LIGGGHTS"), output)
        return result

    def test_each_once_with_a_count(self):
        """Two fluid steps of ten DEM steps; the end gives one more."""
        folder = self.case("fix a all plugin/warn 0 1 first\nfix b all plugin/warn 0 5 second\nfix d all plugin/warn -1 20 all")
        for ranks in (0, 2):
            output = self.assertRuns(folder, ranks=ranks).output
            self.assertEqual(self.counts(output), {
                "first": (1, 21, "first at step 0"), "second": (1, 5, "second at step 0"), "all": (1, 2, "all at step 0")})
            self.assertIn("FOAM Warning : LIGGGHTS: first at step 1\n    source ", output)
            self.assertIn("log of LIGGGHTS log.liggghts", output)
            self.assertEqual((folder / "log.liggghts").read_text().count("WARNING: first at step"), 21)

    def test_of_another_rank(self):
        folder = self.case("fix a all plugin/warn 1 4 other\nfix b all plugin/warn 0 10 both\nfix d all plugin/warn 1 10 both")
        output = self.assertRuns(folder, ranks=2).output
        # the first two at step 10 and at the end, of either rank
        self.assertEqual(self.counts(output), {"other": (1, 6, "other at step 0"), "both": (1, 6, "both at step 0")})
        self.assertIn("FOAM Warning : LIGGGHTS on rank 1: other at step", output)
        self.assertIn("FOAM Warning : LIGGGHTS: both at step 10\n", output)

    def test_in_the_script(self):
        """The line is told; a warning of the script comes before the first momentum equation is solved."""
        folder = self.case("fix a all plugin/warn 0 3 early", end="run 6")
        lines = (folder / "constant/in.particles").read_text().splitlines()
        for ranks in (0, 2):
            result = self.foam("pimpleFoam", folder, ranks, check=False, timeout=60)
            self.assertEqual(result.code, 0, result)
            before = result.output[:re.search(box.SOLVED, result.output).start()]
            self.assertIn("FOAM Warning : LIGGGHTS: early at step 3", before)
            self.assertIn(f"script constant/in.particles, line {lines.index('run 6') + 1}: run 6", before)
            # twice and at the end of the run of the script, then six times (steps 9 ... 24) and at the end
            self.assertEqual(self.counts(result.output)["early"][1], 10)

    def test_none(self):
        folder = self.fresh()
        for ranks in (0, 2):
            self.assertNotIn("Warnings of LIGGGHTS", self.assertRuns(folder, ranks=ranks).output)

    def test_before_an_error(self):
        """Told although the run has no end; of another rank, too, if that rank's message is the one that is heard."""
        folder = self.case('fix a all plugin/warn 0 7 early\nfix stop all print 9 "$(1/0)"')
        for ranks in (0, 2):
            result = self.assertRefused(folder, "LIGGGHTS stopped", ranks=ranks, steps=True)
            self.assertIn("FOAM Warning : LIGGGHTS: early at step 7", result.output)
            self.assertNotIn("Warnings of LIGGGHTS", result.output)


if __name__ == "__main__":
    unittest.main()
