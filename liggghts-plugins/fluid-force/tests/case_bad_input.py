# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/force: every bad value is one clear error that names the fix, and ends the run."""
# processors: 2
# label: long

import unittest

import grainjet

SCRIPT = """
    plugin load fluidforceplugin.so
    atom_style {style}
    atom_modify map array sort 0 0
    boundary {boundary}
    newton off
    communicate single vel yes
    units {units}
    region box {box} units box
    create_box 1 box
    neighbor 0.1 bin
    timestep 1e-5
    create_atoms 1 single 0 0 0 units box
    {fixes}
    fix i all nve/sphere
    run 1
"""

AIR = "density 1.2 viscosity 1.5e-5"


class BadInput(grainjet.Case):

    def script(self, fixes, style="granular", units="si", box="block -1 1 -1 1 -1 1", boundary="f f f"):
        return SCRIPT.format(fixes=fixes, style=style, units=units, box=box, boundary=boundary)

    def refused(self, fixes, *words, ranks=0, **changes):
        result = self.liggghts(self.script(fixes, **changes), ranks, check=False)
        self.assertFails(result, "fluid/force", *words)
        self.assertEqual(result.output.count("ERROR"), 1, result)

    def test_style_and_values(self):
        for line, words in (
                ("", ("missing style", "coupled or uniform")),
                ("couple", ("'couple'", "coupled, uniform")),
                ("coupled yes", ("no keywords", "'yes'")),
                ("uniform 1 0", ("missing", "ux uy uz")),
                (f"uniform 1 0 density {AIR}", ("'density' is not a number", "ux uy uz")),
                (f"uniform 1 0 nan {AIR}", ("'nan'",)),
                ("uniform 1 0 0 viscosity 1.5e-5", ("missing keyword density", "density 1.2")),
                ("uniform 1 0 0 density 1.2", ("missing keyword viscosity", "viscosity 1.5e-5")),
                ("uniform 1 0 0 density", ("missing the number after density",)),
                ("uniform 1 0 0 density -1.2 viscosity 1.5e-5", ("density must be > 0, from 1e-12 to 1e+12, not -1.2",)),
                ("uniform 1 0 0 density 1.2 viscosity 0", ("viscosity must be > 0, from 1e-12 to 1e+12",)),
                ("uniform 1 0 0 density 1.2kg viscosity 1", ("'1.2kg' is not a number",)),
                (f"uniform 1 0 0 {AIR} drag Gidaspow",
                 ("'Gidaspow'", "gidaspow, wenYu, ergun, schillerNaumann, stokes, diFelice, "
                  "kochHill, beetstra, haiderLevenspiel, ganser")),
                (f"uniform 1 0 0 {AIR} drag ganser", ("drag ganser needs the keyword sphericity, from 0.09 to 1:", "sphericity 0.8")),
                (f"uniform 1 0 0 {AIR} drag haiderLevenspiel sphericity 0.02",
                 ("sphericity of drag haiderLevenspiel must be from 0.026 to 1, not 0.02",)),
                (f"uniform 1 0 0 {AIR} sphericity -1 drag haiderLevenspiel",
                 ("sphericity of drag haiderLevenspiel must be from 0.026 to 1, not -1",)),
                (f"uniform 1 0 0 {AIR} sphericity 0.8 drag ganser sphericity 0.8", ("sphericity is given twice",)),
                (f"uniform 1 0 0 {AIR} sphericity 80 drag ganser", ("sphericity of drag ganser must be from 0.09 to 1, not 80",)),
                (f"uniform 1 0 0 {AIR} sphericity 0.8", ("gidaspow is a law of spheres",)),
                (f"uniform 1 0 0 {AIR} magnus maybe", ("magnus must be yes or no",)),
                (f"uniform 1 0 0 {AIR} drag", ("missing", "drag law")),
                (f"uniform 1 0 0 {AIR} buoyancy on", ("buoyancy must be yes or no", "'on'")),
                (f"uniform 1 0 0 {AIR} rotation", ("missing the word yes or no after rotation",)),
                (f"uniform 1 0 0 {AIR} addedMass", ("missing the number after addedMass",)),
                (f"uniform 1 0 0 {AIR} addedMass 0", ("addedMass must be > 0, from 1e-06 to 100",)),
                (f"uniform 1 0 0 {AIR} addedMass 500", ("addedMass must be from 1e-06 to 100", "500")),
                (f"uniform 1 0 0 {AIR} lift yes", ("unknown keyword 'lift'", "buoyancy")),
        ):
            with self.subTest(line):
                self.refused(f"fix f all fluid/force {line}", "(ID f)", *words)

    def test_surroundings(self):
        good = f"fix f all fluid/force uniform 1 0 0 {AIR}"
        for fixes, words in (
                (f"{good} buoyancy yes", ("buoyancy", "fix gravity")),
                (f"{good}\nfix h all fluid/force coupled", ("already one with ID f",)),
                (f"{good}\nfix z all freeze", ("freeze", "without them")),
                (f"{good}\nrun_style respa 2 2", ("respa",)),
        ):
            with self.subTest(fixes):
                self.refused(fixes, *words)
        self.refused(good, "units si", units="cgs")
        self.refused(good, "granular", style="atomic")
        self.refused("fix f all fluid/force coupled", "orthogonal",
                     box="prism -1 1 -1 1 -1 1 0.1 0 0")

    def test_magnus_without_rotation(self):
        """A warning, and the run goes on."""
        for rotation, warnings in (("no", 1), ("yes", 0)):
            result = self.liggghts(self.script(f"fix f all fluid/force uniform 1 0 0 {AIR} magnus yes rotation {rotation}"), 2)
            self.assertEqual(result.output.count("magnus yes without rotation yes"), warnings, result)

    def test_box_that_changes(self):
        """Behind this fix the box becomes another one, or another fix changes it during the run."""
        self.refused("fix f all fluid/force coupled\nchange_box all triclinic", "orthogonal", ranks=2)
        self.refused("fix f all fluid/force coupled\nfix d all deform 1 x scale 1.1", "fix deform (ID d)", "box", ranks=2,
                     boundary="p f f")
        # style uniform has no mesh
        self.liggghts(self.script(f"fix f all fluid/force uniform 1 0 0 {AIR}\nfix d all deform 1 x scale 1.1",
                                  boundary="p f f"))

    def test_on_two_ranks(self):
        """One message, all ranks end, no hang."""
        self.refused(f"fix f all fluid/force uniform 1 0 0 {AIR} drag none", "'none'", ranks=2)
        self.refused(f"fix f all fluid/force uniform 1 0 0 {AIR} buoyancy yes", "gravity", ranks=2)

    def test_unfix_and_again(self):
        """unfix takes the per-grain state away; the fix can be defined anew, and redefined."""
        good = f"fix f all fluid/force uniform 1 0 0 {AIR}"
        self.liggghts(self.script(f"""
            {good}
            unfix f
            {good} rotation yes
            {good}
            unfix f
            fix f all fluid/force coupled
        """))


if __name__ == "__main__":
    unittest.main()
