# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix grain/motion: whatever it cannot do is one clear error that names the fix, before the first step."""
# processors: 2
# label: long

import unittest

from motion_case import MotionCase, SETTINGS

WIND = "fix f all fluid/force uniform 1 0 0 density 1.2 viscosity 1.5e-5"
BODY = "group body id 1 2\n"


class MotionBadInput(MotionCase):

    def refused(self, lines, *words, ranks=0, style="granular", size="diameter 1e-3 density 2500"):
        script = self.head().replace("atom_style granular", "atom_style " + style)
        result = self.liggghts(script + f"""
            region box block 0 0.02 0 0.01 0 0.01 units box
            create_box 1 box
            create_atoms 1 single 0.004 0.005 0.005 units box
            create_atoms 1 single 0.006 0.005 0.005 units box
            set group all {size}
            {SETTINGS}
            {lines}
            run 1
        """, ranks, check=False)
        self.assertFails(result, "grain/motion (ID m)", *words)
        self.assertEqual(result.output.count("ERROR"), 1, result)
        self.assertNotIn("Loop time", result.output)

    def test_words(self):
        for words, said in (("gravity", ("missing the number after gravity",)),
                            ("gravity 9.81", ("missing direction of gravity, x",)),
                            ("gravity 9.81 0 0", ("missing direction of gravity, z",)),
                            ("gravity -9.81 0 0 1", ("gravity must be >= 0", "not -9.81")),
                            ("gravity 9.81 0 0 down", ("'down' is not a number", "direction of gravity, z")),
                            ("gravity nan 0 0 1", ("gravity", "nan")),
                            ("gravity 9.81 0 0 0", ("the direction of gravity is 0 0 0", "gravity 9.81 0 0 -1")),
                            ("gravity 1e300 0 0 1", ("gravity must be >= 0 and at most",)),
                            ("gravity 9.81 vector 0 0 -1", ("'vector' is not a number",)),
                            ("gravity 1 0 0 1 gravity 1 0 0 1", ("gravity is given twice",)),
                            ("fluid", ("missing the ID of a fix fluid/force",)),
                            ("fluids f", ("unknown keyword 'fluids'", "gravity, fluid"))):
            with self.subTest(words):
                self.refused(f"fix m all grain/motion {words}", *said)

    def test_fluid(self):
        for lines, said in (("fix m all grain/motion fluid f", ("no fix with ID f", "define a fix fluid/force")),
                            ("fix f all viscous 0\nfix m all grain/motion fluid f", ("fix fluid/force", "ID f is a viscous")),
                            (BODY + WIND.replace(" all ", " body ") + "\nfix m all grain/motion fluid f",
                             ("fix fluid/force (ID f) has another group",))):
            with self.subTest(lines):
                self.refused(lines, *said)

    def test_other_fixes(self):
        motion = "\nfix m all grain/motion gravity 9.81 0 0 -1"
        for line, said in (("fix i all nve/sphere", ("fix nve/sphere (ID i) integrates grains, too",)),
                           ("fix i body nve/sphere", ("fix nve/sphere (ID i) integrates grains, too",)),
                           ("fix i body move linear 1 0 0", ("fix move (ID i) integrates grains, too",)),
                           ("fix i all nve/limit absolute 0.1", ("fix nve/limit (ID i) integrates grains, too",)),
                           ("fix i body rigid single", ("fix rigid (ID i) moves clumps",)),
                           ("fix g all gravity 9.81 vector 0 0 -1", ("fix gravity (ID g) and the keyword gravity",)),
                           ("fix i all grain/motion", ("integrates grains, too",))):
            with self.subTest(line):
                self.refused(BODY + line + motion, *said)
        self.refused(BODY + "fix i all nve/sphere" + motion, "(ID i) integrates grains", ranks=2)

    def test_surroundings(self):
        self.refused("run_style respa 2 2\nfix m all grain/motion", "run_style verlet, not with respa")
        self.refused("fix m all grain/motion\nminimize 1e-4 1e-6 10 10", "minimize")
        self.refused("fix m all grain/motion", "without a radius or a mass above 0", size="diameter 0 density 2500")
        self.refused("fix m all grain/motion", "requires atom_style granular", style="atomic", size="type 1")


if __name__ == "__main__":
    unittest.main()
