# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input to the model heat: one message that says what to do, on every rank, before time is spent."""
# processors: 2

import shutil
import unittest

import bad_case
import gas_box
import heat_box
from grainjet import coupled_box as box, dictionaries

PLUGIN = "plugin load fluidheatplugin.so"
FIXES = heat_box.fixes(800.0, 400.0)
HEAT = heat_box.forces()


class HeatErrors(bad_case.BadCase):

    def prepare(self, solver="rhoPimpleFoam", fixes=FIXES, options=None, steps=2, **case):
        """A small box with a grain that moves, decomposed for 2 ranks."""
        folder = self.new_folder()
        (box if solver == "pimpleFoam" else gas_box).write(folder, walls=True, cells="2 2 4", steps=steps, **case)
        box.script(folder, grains=bad_case.GRAIN, boundary="f f f", fixes=fixes, plugins=PLUGIN)
        box.fv_options(folder, **(HEAT if options is None else options))
        for command in ("blockMesh", "decomposePar"):
            self.foam(command, folder)
        return folder

    def test_no_thermodynamics(self):
        for forces in (HEAT, {"forces": "(heat)"}):
            for ranks in (0, 2):
                with self.subTest(forces=forces, ranks=ranks):
                    self.assertRefused(self.prepare("pimpleFoam", options=forces), "The model heat needs specificHeat",
                                       "thermophysicalProperties", "rhoPimpleFoam, sonicFoam or buoyantPimpleFoam", ranks=ranks)

    def test_isothermal_solver(self):
        """The fix in the script of a solver without energy equation: momentum only, said once; the grain keeps its temperature."""
        result = self.assertRuns(self.prepare("pimpleFoam", options={}))
        self.assertEqual(result.output.count("exchange momentum only, and the grains keep their temperature"), 1, result)

    def test_fix_and_model(self):
        for fixes, options, words in (
                ("", HEAT, ("constant/in.particles", "no fix fluid/heat coupled", "the model heat", "thermalCapacity peratomtype",
                             "fix heat all fluid/heat coupled temperature <K")),
                (FIXES.replace("coupled temperature 400.0", "uniform 300 1.2 1.5e-5 1005 0.7"), HEAT, ("no fix fluid/heat coupled",)),
                (FIXES, {}, ("fix fluid/heat coupled, but forces has no model heat", "heat { model RanzMarshall; }"))):
            for ranks in (0, 2):
                with self.subTest(fixes=fixes, options=options, ranks=ranks):
                    self.assertRefused(self.prepare(fixes=fixes, options=options), *words, solver="rhoPimpleFoam", ranks=ranks)

    def test_material_and_temperature(self):
        for fixes, words in (
                ("fix heat all fluid/heat coupled temperature 400", ("thermalCapacity is missing", "property/global thermalCapacity")),
                (heat_box.fixes(-5.0, 400.0), ("thermalCapacity", "must be > 0")),
                (heat_box.fixes(800.0, -5.0), ("temperature", "-5")),
                (FIXES + "set group all property/atom Temp -5\n", ("temperature of grain 1 is -5 K",)),
                ("fix heat all fluid/heat coupled\n", ("grains have no temperature",))):
            with self.subTest(fixes=fixes):
                self.assertRefused(self.prepare(fixes=fixes), *words, solver="rhoPimpleFoam")

    def test_cold_gas(self):
        """A gas at no temperature."""
        folder = self.prepare()
        dictionaries.change(folder / "0/T", ("internalField uniform 300.0", "internalField uniform 0"))
        result = self.foam("rhoPimpleFoam", folder, check=False, timeout=60)
        self.assertNotEqual(result.code, 0)

    def test_entries(self):
        for options, words in (
                (heat_box.forces("model Nusselt;"), ("Nusselt", "RanzMarshall", "Gunn", "Whitaker")),
                (heat_box.forces("recovery maybe;"), ("recovery",)),
                (heat_box.forces("Nu 2;"), ("Nu", "recovery")),
                (heat_box.forces(drag="model Henderson; temperatureRatio 1.2;"), ("temperatureRatio together with the model heat", "Remove"))):
            with self.subTest(options=options):
                self.assertRefused(self.prepare(options=options), "fvOptions", *words, solver="rhoPimpleFoam")

    def test_unknown_viscosity(self):
        """Whitaker needs the viscosity at the surface."""
        folder = self.prepare(options=heat_box.forces("model Whitaker;"))
        dictionaries.change(folder / "constant/thermophysicalProperties", ("transport const", "transport polynomial"),
                            ("thermo eConst", "thermo hPolynomial"), ("energy sensibleInternalEnergy", "energy sensibleEnthalpy"),
                            ("equationOfState perfectGas", "equationOfState icoPolynomial"), ("hePsiThermo", "heRhoThermo"),
                            ("mixture\n{", "mixture\n{ equationOfState { rhoCoeffs<8> (1.2 0 0 0 0 0 0 0); }"),
                            ("Hf 0;", "Hf 0; Sf 0; CpCoeffs<8> (1005 0 0 0 0 0 0 0);"),
                            ("Pr 0.7;", "Pr 0.7; muCoeffs<8> (1.8e-5 0 0 0 0 0 0 0); kappaCoeffs<8> (0.026 0 0 0 0 0 0 0);"))
        self.assertRefused(folder, "model Whitaker needs the viscosity", "transport polynomial", "RanzMarshall", solver="rhoPimpleFoam")

    def test_continued_without_heat(self):
        """What grains have given and the gas has not received yet would be lost."""
        folder = self.prepare()
        self.assertRuns(folder, "rhoPimpleFoam")
        box.end_at(folder, 4)
        box.script(folder, grains=bad_case.GRAIN, boundary="f f f")
        box.fv_options(folder)
        self.assertRefused(folder, "without the model heat", "particleHeatOwed", solver="rhoPimpleFoam")

    def test_left_over_fields(self):
        """A debt of heat of a former run whose other files were removed: not that of a run with new grains."""
        folder = self.prepare(write_every=2)
        self.assertRuns(folder, "rhoPimpleFoam")
        time = max((path.parent for path in folder.glob("*/particleHeatOwed")), key=lambda path: float(path.name))
        names = ("particleTemperature", "particleHeatSource", "particleHeatOwed", "heatOfLostGrains")
        fields = {name: (time / name).read_bytes() for name in names}
        box.end_at(folder, 4)
        for path in [time / "uniform/liggghts.restart", time / "uniform/liggghtsCouplingProperties", *time.glob("particle*"),
                     *time.glob("*OfLostGrains"), time / "voidFraction", time / "dragCoefficient"]:
            path.unlink()
        shutil.rmtree(folder / "postProcessing")
        for name in names:
            with self.subTest(name=name):
                (time / name).write_bytes(fields[name])
                self.assertRefused(folder, "new grains", name, solver="rhoPimpleFoam")
                (time / name).unlink()

    def test_continued_with_explicit_momentum(self):
        """Such a run has no debts of energy, and asks for no file of them."""
        folder = self.prepare(options={**HEAT, "momentum": "explicit"})
        self.assertRuns(folder, "rhoPimpleFoam")
        box.end_at(folder, 4)
        self.assertRuns(folder, "rhoPimpleFoam")


if __name__ == "__main__":
    unittest.main()
