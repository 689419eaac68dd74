# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""What a user may get wrong with fix hertz/cg and coarsegraining: one clear error each, serial and on
two ranks, with an exit code other than 0."""

import unittest

from grainjet import Case

DATA = """two grains

2 atoms
2 atom types
0 0.01 xlo xhi
0 0.01 ylo yhi
0 0.01 zlo zhi

Atoms

1 1 0.001 2500 0.004 0.005 0.005
2 {type} 0.001 2500 0.0049 0.005 0.005
"""

VALUES = {
    "youngsModulus": "peratomtype 5.e6 5.e6",
    "poissonsRatio": "peratomtype 0.3 0.3",
    "coefficientRestitution": "peratomtypepair 2 0.9 0.9 0.9 0.9",
    "coefficientFriction": "peratomtypepair 2 0.3 0.3 0.3 0.3",
}

TEMPLATE = "fix t all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0005\n"


class BadInput(Case):

    def script(self, values=None, fix="fix c all hertz/cg\n", before="", head="", newton="off",
               ghosts="communicate single vel yes\n", dt=1e-6, type=2, after=""):
        (self.folder / "data").write_text(DATA.format(type=type))
        materials = dict(VALUES, **(values or {}))
        return (f"plugin load hertzcgplugin.so\natom_style granular\natom_modify map array\n"
                f"boundary p p p\nnewton {newton}\n{ghosts}units si\n{head}read_data data\n"
                + "neighbor 0.0005 bin\n"
                + "".join(f"fix p_{name} all property/global {name} {value}\n"
                          for name, value in materials.items() if value)
                + before + fix + f"fix i all nve/sphere\ntimestep {dt}\n" + after + "run 10\n")

    def bad(self, *words, ranks=(0,), **options):
        """It ends with one error that says all these words."""
        for ranks in ranks:
            result = self.liggghts(self.script(**options), ranks, check=False)
            self.assertFails(result, "ERROR", *words)
            self.assertEqual(result.output.count("ERROR"), 1, result)

    def test_good_input_is_accepted(self):
        self.liggghts(self.script())

    def test_two_contact_laws(self):
        pair = "pair_style gran model hertz tangential history\npair_coeff * *\n"
        self.bad("hertz/cg", "pair_style gran", before=pair, ranks=(0, 2))
        self.bad("hertz/cg", "pair_style gran", after=pair)
        self.bad("hertz/cg", "twice", after="fix c2 all hertz/cg\n")

    def test_missing_property(self):
        for name in VALUES:
            with self.subTest(name=name):
                self.bad("hertz/cg", f"'{name}' is missing", values={name: None})
        self.bad("hertz/cg", "'coefficientRollingFriction' is missing", fix="fix c all hertz/cg rolling cdt\n")
        # without friction there is no coefficient to miss
        self.liggghts(self.script({"coefficientFriction": None}, fix="fix c all hertz/cg tangential off\n"))

    def test_impossible_values(self):
        self.bad("'youngsModulus' of type 2 is -5e+06", values={"youngsModulus": "peratomtype 5.e6 -5.e6"},
                 ranks=(0, 2))
        self.bad("'youngsModulus' of type 1 is 0", values={"youngsModulus": "peratomtype 0. 5.e6"})
        self.bad("'poissonsRatio' of type 1 is 0.6", values={"poissonsRatio": "peratomtype 0.6 0.3"})
        for e in ("0.", "-0.1", "1.1"):
            self.bad("'coefficientRestitution' of type 1 and 2", "(0, 1]",
                     values={"coefficientRestitution": f"peratomtypepair 2 0.9 {e} {e} 0.9"})
        self.bad("'coefficientFriction' of type 2 and 2 is -0.3",
                 values={"coefficientFriction": "peratomtypepair 2 0.3 0.3 0.3 -0.3"})
        self.bad("youngsModulus", "Length not correct", values={"youngsModulus": "peratomtype 5.e6"})

    def test_keywords(self):
        for words, expected in (
                ("tangential", "missing value after 'tangential': history, no_history or off"),
                ("tangential spring", "tangential must be history, no_history or off, not 'spring'"),
                ("rolling luding", "rolling must be off, cdt, epsd or epsd2, not 'luding'"),
                ("rolling_friction epsd3", "rolling_friction must be off, cdt, epsd or epsd2"),
                ("rolling cdt rolling_friction cdt", "are the same keyword"),
                ("model hertz", "needs `tangential` after `model hertz`"),
                ("model hooke", "model must be hertz, not 'hooke'"),
                ("surface multicontact", "surface must be default"),
                ("cohesion easo", "cohesion must be off, sjkr or sjkr2"),
                ("limitForce yes", "limitForce must be off or on, not 'yes'"),
                ("tangential_damping", "missing value after 'tangential_damping'"),
                ("viscous on", "unknown keyword 'viscous'; valid keywords are model, "),
                ("torsionTorque on", "only with rolling"),
                ("tangential_reduce on", "only with cohesion"),
                ("tangential off tangential_damping off", "only with friction"),
                ("computeElasticPotential on", "unknown keyword 'computeElasticPotential'"),
                ("timestep_check 0 0.1 warn", "must be a whole number >= 1"),
                ("timestep_check 10 -0.1 warn", "must be > 0"),
                ("timestep_check 10 0.1", "missing value after 'timestep_check N fraction': warn or error"),
                ("timestep_check 10 0.1 stop", "must be warn or error, not 'stop'"),
                ("overlap_check x", "not a number"),
                ("cohesion sjkr", "'cohesionEnergyDensity' is missing"),
                ("rolling epsd", "'coefficientRollingFriction' is missing"),
                ("sticky 1", "unknown keyword 'sticky'")):
            with self.subTest(words=words):
                result = self.liggghts(self.script(fix=f"fix c all hertz/cg {words}\n"), check=False)
                self.assertFails(result, "ERROR", "hertz/cg", expected)

    def test_host_settings(self):
        self.bad("newton off", newton="on")
        self.bad("communicate single vel yes", ghosts="")
        self.bad("neigh_modify exclude", after="neigh_modify exclude type 1 1\n")
        self.bad("neigh_modify once", after="neigh_modify once yes\n")

    def test_coarsegraining(self):
        self.bad("coarsegraining", ">= 1", "0.5", head="coarsegraining 0.5\n", ranks=(0, 2))
        self.bad("coarsegraining", ">= 1", "two", head="coarsegraining two\n")
        self.bad("coarsegraining", "error or warn", head="coarsegraining 2 model_check maybe\n")
        self.bad("coarsegraining", "needs a factor", head="coarsegraining\n")
        self.bad("coarsegraining", "twice", head="coarsegraining 2\ncoarsegraining 2\n")
        self.bad("coarsegraining", "after a particle template", before=TEMPLATE + "coarsegraining 2\n")
        self.bad("coarsegraining", "as many as there are atom types", before="coarsegraining 2 2 2\n")
        self.liggghts(self.script(before="coarsegraining 2\n" + TEMPLATE))

    def test_models_that_liggghts_takes_for_inconsistent(self):
        wall = ("fix m all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 0.1\n"
                "fix w all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 zplane 0\n")
        self.bad("rolling model cdt", head="coarsegraining 2\n", after=wall)
        result = self.liggghts(self.script(head="coarsegraining 2 model_check warn\n", after=wall))
        self.assertIn("WARNING", result.output)

    def test_types_of_different_factor(self):
        self.bad("grains", "(type 1, f_cg 2)", "(type 2, f_cg 3)", "different coarse-graining factors",
                 before="coarsegraining 2 3\n", ranks=(0, 2))
        # the same factors without such a contact
        self.liggghts(self.script(before="coarsegraining 2 3\n", type=1))

    def test_grains_larger_than_a_subdomain(self):
        data = DATA.format(type=1).replace("0 0.01 zlo zhi", "0 0.0008 zlo zhi").replace(" 0.005\n", " 0.0004\n")
        script = self.script(type=1)
        (self.folder / "data").write_text(data)
        self.assertFails(self.liggghts(script, check=False), "ERROR", "hertz/cg", "larger than a rank's part")

    def test_time_step(self):
        check = "fix c all hertz/cg timestep_check 5 0.2 {}\n"
        self.bad("hertz/cg", "of the Rayleigh time", "allows 20 %", fix=check.format("error"), dt=1e-4,
                 ranks=(0, 2))
        result = self.liggghts(self.script(fix=check.format("warn"), dt=1e-4))
        self.assertIn("WARNING: Fix hertz/cg: time step 0.0001 is", result.output)
        result = self.liggghts(self.script(fix=check.format("warn"), dt=1e-7))
        self.assertNotIn("WARNING: Fix hertz/cg: time step", result.output)

    def test_deep_overlaps_are_counted_and_reported(self):
        # 0.1 mm of a radius of 0.5 mm
        result = self.liggghts(self.script(fix="fix c all hertz/cg overlap_check 0.15\n"))
        self.assertIn("1 contacts since the start were deeper than 0.15 of the smaller radius, the deepest 0.2",
                      result.output)
        result = self.liggghts(self.script(fix="fix c all hertz/cg overlap_check 0.25\n"))
        self.assertNotIn("deeper than", result.output)

    def test_grains_at_the_same_place(self):
        script = self.script(type=1)
        (self.folder / "data").write_text(DATA.format(type=1).replace("0.0049", "0.004"))
        for ranks in (0, 2):
            self.assertFails(self.liggghts(script, ranks, check=False), "ERROR", "grains 1", "same centre")


if __name__ == "__main__":
    unittest.main()
