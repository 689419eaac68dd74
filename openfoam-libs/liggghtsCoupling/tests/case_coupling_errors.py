# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input to the coupling: one clear error on every rank, exit code not 0, no hang."""
# processors: 2
# label: long

import unittest

import grainjet
from grainjet import coupled_box as box, dictionaries

GRAIN = box.grains([(0.01, 0.01, 0.01)], [(0, 0, 1)])


class BadInput(grainjet.Case):

    def fails(self, *words, options=None, script=None, fluid=None, keep_script=True):
        """Serial and on 2 ranks the run ends with an error that holds all words, before the solver
        has solved for velocity or pressure: at the latest in the first momentum equation."""
        for ranks in (0, 2):
            with self.subTest(ranks=ranks, words=words):
                folder = self.folder / f"{len(list(self.folder.iterdir()))}"
                box.write(folder, **(fluid or {}))
                if keep_script:
                    box.script(folder, **{"grains": GRAIN, **(script or {})})
                box.fv_options(folder, **(options or {}))
                self.foam("blockMesh", folder)
                if ranks:
                    self.foam("decomposePar", folder)
                result = self.foam("pimpleFoam", folder, ranks, check=False, timeout=60)
                self.assertFails(result, *words)
                self.assertEqual(result.output.count("FOAM FATAL"), 1, result)
                self.assertNotRegex(result.output, box.SOLVED)

    # the dictionary

    def test_missing_script(self):
        self.fails("fvOptions", "script", "constant/in.particles", "not found", keep_script=False)

    def test_no_script_entry(self):
        self.fails("script", "fvOptions", options={"script": None})

    def test_no_interval(self):
        self.fails("couplingInterval", "fvOptions", options={"couplingInterval": None})

    def test_interval_not_positive(self):
        self.fails("couplingInterval -5", "fvOptions", options={"couplingInterval": "-5"})

    def test_misspelt_entry(self):
        self.fails("Unknown entry interpoltion", "fvOptions", "interpolation",
                   options={"interpoltion": "cell"})

    def test_misspelt_entry_of_a_model(self):
        self.fails("Unknown entry minimm", "fvOptions", "voidFraction", "minimum",
                   options={"voidFraction": "{ model divided; minimm 0.3; }"})

    def test_unknown_coupling(self):
        self.fails("coupling threeWay", "twoWay", "oneWay", options={"coupling": "threeWay"})

    def test_unknown_drag(self):
        self.fails("drag Newton", "Gidaspow", "KochHill", options={"drag": "Newton"})

    def test_unknown_void_fraction(self):
        self.fails("model", "bricks", "divided", "centre",
                   options={"voidFraction": "{ model bricks; }"})

    def test_void_fraction_minimum(self):
        self.fails("minimum", "fvOptions", options={"voidFraction": "{ model divided; minimum -1; }"})

    def test_unknown_force(self):
        self.fails("forces", "magic", "pressureGradient", "viscous", "buoyancy",
                   options={"forces": "(magic)"})

    def test_unknown_interpolation(self):
        self.fails("interpolation", "cubic", "cellPoint", options={"interpolation": "cubic"})

    def test_unknown_momentum(self):
        self.fails("momentum", "semi", "implicit", "explicit", options={"momentum": "semi"})

    # the fluid's case

    def test_no_density(self):
        self.fails("rho", "transportProperties", fluid={"rho": ""})

    def test_negative_density(self):
        self.fails("rho", "transportProperties", "positive",
                   fluid={"rho": "rho [1 -3 0 0 0 0 0] -1.2;"})

    def test_interval_with_an_adjustable_time_step(self):
        self.fails("couplingInterval is for a fixed step", "fvOptions", "adjustTimeStep", "controlDict",
                   fluid={"control": "adjustTimeStep yes; maxCo 0.5;"})

    def test_time_step_that_changes_in_a_running_case(self):
        """Refused in the first step that is another, by what has changed it."""
        for ranks, new, words in ((0, "deltaT 2e-4", "Set deltaT to 0.0001, or couplingInterval to 20"),
                                  (2, "deltaT 2e-4", "Set deltaT to 0.0001, or couplingInterval to 20"),
                                  (2, "adjustTimeStep yes; maxCo 0.5; deltaT 1e-4", "adjustTimeStep yes cannot be set in a run")):
            with self.subTest(ranks=ranks, new=new):
                folder = self.new_folder()
                box.write(folder, walls=True, cells="2 2 4", control="OptimisationSwitches { fileModificationSkew 0; }")
                box.script(folder, grains=GRAIN)
                box.fv_options(folder)
                self.foam("blockMesh", folder)
                controls = folder / "system/controlDict"
                dictionaries.change(controls, ("runTimeModifiable no", "runTimeModifiable yes"))
                others = [folder / name for name in ("system/first", "system/second")]
                dictionaries.change(controls, ("functions {", f"""functions
{{ update {{ type timeActivatedFileUpdate; libs ("libutilityFunctionObjects.so"); fileToUpdate "{controls}";
timeVsFile ((-1 "{others[0]}") (0.0005 "{others[1]}")); }} """))
                others[0].write_text(controls.read_text())
                others[1].write_text(controls.read_text().replace("deltaT 0.0001", new))
                if ranks:
                    self.foam("decomposePar", folder)
                result = self.foam("pimpleFoam", folder, ranks, check=False, timeout=60)
                self.assertFails(result, words, "Time = 0.0005", box.SOLVED.split("(")[0])
                self.assertEqual(result.output.count("FOAM FATAL"), 1, result)

    # the script

    def test_script_error(self):
        self.fails("LIGGGHTS stopped", "Unknown command: nonsense", script={"end": "nonsense 1 2 3"})

    def test_script_error_of_a_fix(self):
        self.fails("LIGGGHTS stopped", "fix nve/sphere", script={"fixes": "fix twice all nve/sphere bad"})

    def test_plugin_missing(self):
        self.fails("LIGGGHTS stopped", "nosuchplugin.so", script={"plugins": "plugin load nosuchplugin.so"})

    def test_no_fluid_force(self):
        self.fails("constant/in.particles", "fix fluid/force coupled", script={"end": "unfix fluid"})

    def test_wrong_units(self):
        self.fails("units", "si", script={"plugins": "", "grains": "", "end": "clear\nunits lj\n"
                   "region b block 0 1 0 1 0 1\ncreate_box 1 b"})

    def test_time_steps_do_not_fit(self):
        self.fails("not couplingInterval DEM steps", "0.0001", "3e-05", "couplingInterval 10",
                   script={"dt": 3e-6})

    def test_no_gravity_for_buoyancy(self):
        self.fails("buoyancy", "fix gravity", options={"forces": "(buoyancy)"})

    # geometry

    def test_boxes_apart(self):
        self.fails("no part in common", "constant/in.particles", script={
            "box": "1 1.02 0 0.02 0 0.04", "boundary": "f f f",
            "grains": box.grains([(1.01, 0.01, 0.01)], [(0, 0, 1)])})

    def test_no_grain_in_a_cell(self):
        self.fails("None of the 1 grains", "constant/in.particles", script={
            "box": "0 0.1 0 0.1 0 0.1", "boundary": "f f f",
            "grains": box.grains([(0.05, 0.05, 0.05)], [(0, 0, 1)])})


if __name__ == "__main__":
    unittest.main()
