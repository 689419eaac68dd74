# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix fluid/heat: every bad value is one clear error that names the fix, and ends the run."""
# processors: 2
# label: long

import re
import unittest

from heat_case import AIR, HeatCase, ONE

CAPACITY = "fix c all property/global thermalCapacity peratomtype 800"

SCRIPT = """
    plugin load fluidheatplugin.so
    plugin load fluidforceplugin.so
    atom_style {style}
    atom_modify map array sort 0 0
    boundary f f f
    newton off
    communicate single vel yes
    units {units}
    region box block 0 0.02 0 0.01 0 0.01 units box
    create_box 1 box
    neighbor 0.0005 bin
    timestep 1e-5
    {grains}
    {fixes}
    fix i all nve/sphere
    run 1
"""


class BadInput(HeatCase):

    def bad_script(self, fixes, style="granular", units="si", grains=ONE):
        return SCRIPT.format(fixes=fixes, style=style, units=units, grains=grains)

    def refused(self, fixes, *words, ranks=0, **changes):
        result = self.liggghts(self.bad_script(fixes, **changes), ranks, check=False)
        self.assertFails(result, "Fix fluid/heat (ID h)", *words)
        # LIGGGHTS' own lines; an end by MPI_Abort may leave others
        self.assertEqual(len(re.findall(r"(?m)^ERROR(?: on proc \d+)?: ", result.output)), 1, result)

    def test_style_and_values(self):
        for line, words in (
                ("", ("missing style", "coupled or uniform")),
                ("couple", ("'couple'", "coupled, uniform")),
                ("coupled", ("grains have no temperature", "temperature <K>", "fix Temp all property/atom Temp scalar yes yes no 300")),
                ("coupled yes", ("unknown keyword 'yes'", "temperature")),
                ("coupled temperature", ("missing the number after temperature",)),
                ("coupled temperature 0", ("temperature must be > 0",)),
                ("coupled temperature -20", ("temperature must be > 0", "-20")),
                ("coupled temperature inf", ("temperature must be from", "inf")),
                ("coupled temperature 300K", ("'300K' is not a number",)),
                ("coupled temperature 300 temperature 300", ("temperature is given twice",)),
                ("uniform", ("missing", "fluid temperature T (K)", "'uniform T rho nu cp Pr'")),
                ("uniform 300 1.2 1.5e-5 1005", ("missing Prandtl number Pr",)),
                (f"uniform -1 {AIR}", ("fluid temperature T (K)", "must be > 0")),
                ("uniform 300 0 1.5e-5 1005 0.7", ("fluid density rho (kg/m3)", "must be > 0")),
                ("uniform 300 1.2 nan 1005 0.7", ("'nan' is not a number", "kinematic viscosity nu (m2/s)")),
                ("uniform 300 1.2 1.5e-5 -1005 0.7", ("specific heat cp of the fluid (J/(kg K))", "must be > 0")),
                (f"uniform 300 {AIR} velocity 1 0", ("missing", "the fluid velocity ux uy uz after 'velocity'")),
                (f"uniform 300 {AIR} velocity 1 0 4e8", ("the fluid velocity ux uy uz", "4e8")),
                (f"uniform 300 {AIR} nusselt RanzMarshall", ("unknown nusselt law 'RanzMarshall'", "ranzMarshall, gunn, whitaker")),
                (f"uniform 300 {AIR} nusselt", ("missing name of a law after 'nusselt'",)),
                (f"uniform 300 {AIR} recovery on", ("recovery must be yes or no", "'on'")),
                (f"uniform 300 {AIR} conductivity 0.02", ("unknown keyword 'conductivity'", "velocity, nusselt, recovery, temperature")),
        ):
            with self.subTest(line):
                self.refused(f"{CAPACITY}\nfix h all fluid/heat {line}", *words)

    def test_surroundings(self):
        good = f"fix h all fluid/heat uniform 300 {AIR}"
        property_temp = "fix Temp all property/atom Temp scalar yes yes no 300"
        for fixes, changes, words in (
                (good, {}, ("material property thermalCapacity is missing",
                            "fix <id> all property/global thermalCapacity peratomtype <J/(kg K) of each atom type>")),
                (f"{CAPACITY.replace('800', '0')}\n{good}", {}, ("thermalCapacity (fix c) of atom type 1 is 0 J/(kg K)", "> 0")),
                (f"{CAPACITY.replace('800', '-800')}\n{good}", {}, ("thermalCapacity (fix c) of atom type 1 is -800",)),
                (f"{CAPACITY}\nfix k all property/global thermalConductivity peratomtype 0\n{good}", {},
                 ("thermalConductivity (fix k) of atom type 1 is 0 W/(m K)",)),
                (f"{CAPACITY}\n{property_temp}\n{good} temperature 300", {}, ("there is a property Temp already (fix Temp)",)),
                (f"{CAPACITY}\n{property_temp}\nfix h all fluid/heat coupled temperature 300", {}, ("property Temp already",)),
                (f"{CAPACITY}\n{good}", {"units": "cgs"}, ("requires units si",)),
                (f"{CAPACITY}\n{good}", {"style": "atomic", "grains": ""}, ("requires atom_style granular",)),
                (f"{CAPACITY}\nfix fluidHeat all setforce 0 0 0\n{good}", {},
                 ("the script has a fix with ID fluidHeat, which is the name of a property of this fix",)),
                (f"{CAPACITY}\nfix g all fluid/heat coupled temperature 300\n{good}", {}, ("there is already one with ID g",)),
                (f"{CAPACITY}\n{property_temp.replace('300', '0')}\n{good}", {},
                 ("the temperature of grain 1 is 0 K, but must be > 0 and finite",)),
                (f"{CAPACITY}\n{good} temperature 300\nset group all property/atom Temp -5", {},
                 ("the temperature of grain 1 is -5 K",)),
        ):
            with self.subTest(fixes):
                self.refused(fixes, *words, **changes)
                self.refused(fixes, *words, ranks=2, **changes)

    def test_fix_fluid_force(self):
        """A fluid that fix fluid/force states otherwise."""
        force = "fix f all fluid/force uniform 8 0 0 density {} viscosity {}"
        good = f"fix h all fluid/heat uniform 300 {AIR}"
        for fixes, words in (
                (force.format(1.2, 1.5e-5) + f"\n{good} velocity 8 0 0", ("keyword velocity next to fix fluid/force (ID f)",)),
                (f"{good}\n" + force.format(1.3, 1.5e-5), ("density is 1.2 here and 1.3 in fix fluid/force (ID f)",)),
                (force.format(1.2, 1.6e-5) + f"\n{good}", ("viscosity is 1.5e-05 here and 1.6e-05 in fix fluid/force (ID f)",)),
                (f"fix f all fluid/force coupled\n{good}", ("style uniform next to fix fluid/force (ID f) of style coupled",)),
        ):
            with self.subTest(fixes):
                self.refused(f"{CAPACITY}\n{fixes}", *words)
        self.liggghts(self.bad_script(f"{CAPACITY}\n{force.format(1.2, 1.5e-5)}\n{good}"))

    def test_order_of_heat_gran(self):
        """Stock fix heat/gran makes Temp anew: behind this fix it would take the temperatures away."""
        self.refused(f"""
            {CAPACITY}
            fix k all property/global thermalConductivity peratomtype 1
            fix m1 all property/global youngsModulus peratomtype 5.e6
            fix m2 all property/global poissonsRatio peratomtype 0.3
            fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
            fix m4 all property/global coefficientFriction peratomtypepair 1 0.2
            pair_style gran model hertz tangential history
            pair_coeff * *
            fix h all fluid/heat uniform 300 {AIR}
            fix s all heat/gran initial_temperature 350
        """, "(ID s) has replaced the temperatures; put it before fix fluid/heat")

    def test_temperatures_that_do_not_restart(self):
        for word, warnings in (("yes", 0), ("no", 1)):
            result = self.liggghts(self.bad_script(f"{CAPACITY}\nfix Temp all property/atom Temp scalar {word} yes no 300\n"
                                                   f"fix h all fluid/heat uniform 300 {AIR}"))
            self.assertEqual(result.output.count("WARNING: Fix fluid/heat (ID h): the temperatures of the property Temp (fix Temp) "
                                                 "are not kept in restart files"), warnings)

    def test_fluid_that_cannot_be(self):
        """What a coupling may hand over: no number, absolute zero, a negative coefficient."""
        for settings, words in (
                ("set group all property/atom fluidTemperature 0", ("temperature of grain 1 is", "that of the fluid 0 K")),
                ("set group all property/atom fluidTemperature -1e9", ("temperature of grain 1 is -",)),
                ("set group all property/atom fluidHeatCoefficient -1", ("coefficient of the grain is -1 W/K",)),
        ):
            with self.subTest(settings):
                self.refused(f"{CAPACITY}\nfix h all fluid/heat coupled temperature 300\n"
                             f"set group all property/atom fluidHeatCoefficient 1\n{settings}", *words)


if __name__ == "__main__":
    unittest.main()
