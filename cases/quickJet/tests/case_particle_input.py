# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""particleInput: the numbers and surfaces that LIGGGHTS gets, from quickJet's parameters and others; entries
that are missing or do not fit are named and nothing is written."""

import math
import re
import shutil
import unittest

import grainjet
from grainjet import dictionaries

QUICK_JET = grainjet.ROOT/"cases"/"quickJet"


class ParticleInput(grainjet.Case):

    def setUp(self):
        super().setUp()
        (self.folder/"system").mkdir()
        shutil.copy(QUICK_JET/"particleInput", self.folder)
        shutil.copy(QUICK_JET/"system"/"parameters", self.folder/"system")

    def make(self, **changes):
        dictionaries.put(self.folder/"system"/"parameters", **changes)
        result = grainjet.run([self.folder/"particleInput"], self.folder.parent)
        self.assertEqual(result.code, 0, result)
        return dictionaries.values(self.folder/"system"/"parameters")

    def text(self, name):
        return (self.folder/"constant"/"particles"/name).read_text()

    def variables(self):
        return {name: float(value) for name, value in re.findall(r"(?m)^variable (\w+) +equal (\S+)$", self.text("parameters"))}

    def corners(self, name):
        return [tuple(map(float, corner)) for corner in
                re.findall(r"(?m)^  vertex (\S+) (\S+) (\S+)$", self.text(name + ".stl"))]

    def refused(self, *words):
        shutil.rmtree(self.folder/"constant", ignore_errors=True)
        self.assertFails(grainjet.run([self.folder/"particleInput"], self.folder), "particleInput: ", *words)
        self.assertFalse((self.folder/"constant").exists())

    def test_numbers(self):
        """Ten digits are written: 1e-9."""
        p = self.make()
        v = self.variables()
        for name in ("cg", "rhoParticle", "Uinsertion", "gravity", "insertionInterval"):
            self.assertEqual(v[name], p[name], name)
        for name, value in (
                ("demStep", 5e-6), ("massRate", 0.23*1.2*13*math.pi*0.0075**2), ("skin", 12*160e-6),
                ("binSize", 24*160e-6), ("boxRadius", 0.12), ("zInlet", -0.15), ("zEnd", 23.75*0.015)):
            self.assertAlmostEqual(v[name]/value, 1, delta=1e-9, msg=name)
        self.assertRegex(self.text("parameters"), r"(?m)^variable rolling +string off$")
        self.assertEqual(self.text("plate").count("\n"), 1)

    def test_surfaces(self):
        """On the corners of the fluid mesh, from plane to plane; nine digits."""
        p = self.make(nSide=5)
        R = p["D"]/2
        for name, planes, radii in (
                ("pipe", {-0.15, 0}, {R}), ("back", {0.25*0.015}, None),
                ("inlet", {-9.75*0.015}, {0, R - 80e-6*p["cg"]/2/math.cos(math.pi/20)})):
            places = self.corners(name)
            self.assertEqual(len(places), 3*20*(1 if name == "inlet" else 2))
            self.assertEqual({z for _, _, z in places}, planes)
            for x, y, _ in places:
                r = math.hypot(x, y)
                if radii:
                    self.assertLess(min(abs(r - radius) for radius in radii), 1e-10)
                else:       # on the pipe or just inside of the box of grains
                    side = max(abs(x), abs(y))
                    self.assertTrue(abs(r - R) < 1e-10 or abs(side - 0.999*0.12) < 1e-9, (x, y))
                # corners at 45 degrees and every 18 from there
                turn = (math.degrees(math.atan2(y, x)) - 45)/18
                self.assertTrue(r < 1e-12 or abs(turn - round(turn)) < 1e-6, (x, y))

    def test_sizes_and_plate(self):
        self.make(diameters="(60e-6 80e-6 110e-6)", massFractions="(0.2 0.5 0.3)", endPatch="plate", endType="wall",
                  rollingFriction=0.01, cg=1, couplingInterval=20)
        sizes = self.text("sizes")
        found = re.findall(r"(?m)^fix size\d all particletemplate/sphere (\d+) .* radius constant (\S+) ", sizes)
        self.assertEqual([float(radius) for _, radius in found], [3e-5, 4e-5, 5.5e-5])
        self.assertEqual(len({seed for seed, _ in found}), 3)
        self.assertIn("3 size1 0.2 size2 0.5 size3 0.3\n", sizes)
        self.assertRegex(self.text("plate"), r"(?m)^fix plate all plate/stats .* centre 0 0 0.36 .* radius 0.0525 rings 7 ")
        self.assertRegex(self.text("parameters"), r"(?m)^variable rolling +string cdt$")
        self.assertAlmostEqual(self.variables()["zEnd"], 24.25*0.015, delta=1e-10)
        # LIGGGHTS takes all of it
        script = """
            plugin load platestatsplugin.so
            units si
            atom_style granular
            atom_modify map array
            boundary f f f
            newton off
            communicate single vel yes
            include constant/particles/parameters
            region box block -0.2 0.2 -0.2 0.2 -0.2 0.4 units box
            create_box 1 box
            neighbor 0.01 bin
            soft_particles yes
            fix m1 all property/global youngsModulus peratomtype ${youngsModulus}
            fix m2 all property/global poissonsRatio peratomtype ${poissonsRatio}
            fix m3 all property/global coefficientRestitution peratomtypepair 1 ${restitution}
            fix m4 all property/global coefficientFriction peratomtypepair 1 ${friction}
            fix m5 all property/global coefficientRollingFriction peratomtypepair 1 ${rollingFriction}
            pair_style gran model hertz tangential history rolling_friction ${rolling}
            pair_coeff * *
            timestep ${demStep}
            include constant/particles/sizes
            include constant/particles/plate
            fix pipe all mesh/surface file constant/particles/pipe.stl type 1
            fix inlet all mesh/surface/planar file constant/particles/inlet.stl type 1
            fix move all nve/sphere
            run 1
        """
        self.liggghts(script)

    def test_times(self):
        """Round-off is borne, and half a fluid step, since OpenFOAM writes at the nearest step. With a plate no grains are counted at
        sampleStart, which may lie anywhere before endTime."""
        for changes in ({"sampleStart": 0.0601, "endTime": 0.1199}, {"writeInterval": 0.1/3, "sampleStart": 0.1, "endTime": 0.2},
                        {"writeInterval": 1e-3*math.pi, "sampleStart": f"{7e-3*math.pi:.10g}", "endTime": f"{0.9*math.pi:.10g}"},
                        {"sampleStart": 0, "endTime": 0.02, "writeInterval": 0.02},
                        {"endPatch": "plate", "writeInterval": 0.02, "sampleStart": 0.07, "endTime": 0.12, "plateRadius": 8}):
            with self.subTest(changes):
                self.make(**changes)

    def test_wrong_entries(self):
        path = self.folder/"system"/"parameters"
        good = path.read_text()
        for old, new, words in (
                ("massLoading     0.23;", "", ("system/parameters", "no entry massLoading")),
                ("D               0.015;", "D wide;", ("D must be a number", "'wide'")),
                ("massFractions   (1);", "massFractions (0.5 0.5);", ("1 diameters", "2 massFractions")),
                ("diameters       (80e-6);", "diameters (8 x);", ("diameters must be a number", "'x'")),
                ("diameters       (80e-6);", "diameters 80e-6;", ("diameters must be a list", "'8e-05'")),
                ("couplingInterval 10;", "couplingInterval 0;", ("couplingInterval must be larger than 0",)),
                ("subSteps        5;", "subSteps 1;", ("2.5e-05 s is 74 %", "Rayleigh time of a grain, 3.36e-05 s", "at least 38")),
                ("dParticle       80e-6;", "dParticle { 80e-6;", ("parameters",)),
                ("ranks           2;", "ranks 0;", ("ranks must be a whole number, 1 or more, not 0",)),
                ("ranks           2;", "ranks 1.5;", ("ranks must be a whole number, 1 or more, not 1.5",)),
                ("writeInterval   0.02;", "writeInterval 0;", ("writeInterval must be larger than 0",)),
                # a run that ends before or when the sampling begins, or whose end or beginning of sampling is not written
                ("endTime         0.12;", "endTime 0.05;", ("sampleStart = 0.06 s", "before endTime = 0.05 s", "endTime 0.08 or more", "writeInterval = 0.02")),
                ("endTime         0.12;", "endTime 0.06;", ("sampleStart = 0.06 s", "before endTime = 0.06 s", "endTime 0.08 or more")),
                ("sampleStart     0.06;", "sampleStart -0.02;", ("sampleStart must be 0 or more, not -0.02",)),
                ("endTime         0.12;", "endTime 0.11;", ("endTime = 0.11 s must be a multiple of writeInterval = 0.02 s", "make endTime 0.12")),
                ("writeInterval   0.02;", "writeInterval 0.2;", ("endTime = 0.12 s must be a multiple of writeInterval = 0.2 s", "make endTime 0.2")),
                ("sampleStart     0.06;", "sampleStart 0.07;", ("sampleStart = 0.07 s must be a multiple of writeInterval = 0.02 s", "make it 0.08")),
                ("sampleStart     0.06;", "sampleStart 0.11;", ("sampleStart = 0.11 s must be a multiple", "make it 0.1, or writeInterval smaller")),
                # 20 steps of 5e-6 s at 11.94 m/s against a fourth of 4 mm, and a disc before the inlet
                ("D               0.015;", "D 0.004;", ("take 1.19 mm", "= 1 mm", "make insertionLength 9.701 or less", "insertionInterval smaller")),
                ("pipeLength      10;", "pipeLength 5;", ("take 1.19 mm", "make insertionLength 4.92 or less")),
                ("endPatch        outlet;", "endPatch plate; boxRadius 3;", ("plateRadius = 3.5", "boxRadius = 3 ", "make plateRadius 3 or less"))):
            with self.subTest(new):
                path.write_text(good)
                dictionaries.change(path, (old, new))
                self.refused(*words)
        path.write_text(good)
        dictionaries.put(path, diameters="(1 2 3 4 5 6 7 8)", massFractions="(1 1 1 1 1 1 1 1)")
        self.refused("8 diameters", "1 to 7")
        path.unlink()
        self.refused("system/parameters")


if __name__ == "__main__":
    unittest.main()
