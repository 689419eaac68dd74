# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of parameters against what Tables 1 to 4 print of derived quantities, and what happens
to wrong entries. Nothing is run."""

import json
import math
import runpy
import unittest

import grainjet
from grainjet import dictionaries
from common import table

CASES = grainjet.ROOT/"cases"

class Derived(unittest.TestCase):

    def setUp(self):
        self.table = table.Table()
        self.full = {name: self.table.run(name, "full") for name in self.table.cases}

    def test_all_seven_cases(self):
        self.assertEqual(list(self.full), ["Hardalupas1", "Hardalupas2", "Hardalupas3", "Hardalupas4",
                                           "Lau1", "Lau2", "Lau3"])

    def test_rayleigh_column_of_table_4(self):
        """Within the printed rounding, and half a per cent for what the paper does not state."""
        for name, s in self.full.items():
            printed = self.table.cases[name]["printed"]["rayleigh"]
            self.assertAlmostEqual(s["percentRayleigh"], printed, delta=0.05 + 0.005*printed, msg=name)

    def test_rayleigh_column_needs_the_lower_modulus(self):
        for name, s in self.full.items():
            stiff = 100*s["demStep"]/table.rayleigh_time(s["dParticle"]/2, s["rhoParticle"], 5e6,
                                                         s["poissonsRatio"])
            self.assertGreater(stiff, 2*self.table.cases[name]["printed"]["rayleigh"])

    def test_stokes_column_of_table_1(self):
        """St = rho d^2 U/(18 mu D). The paper's fluid has its own viscosity (nu = U D/Re gives 1.5e-5),
        and it rounds: 10 % for that. Lau2 and Lau3 are Lau1's times their velocities."""
        for name, s in self.full.items():
            nu = s["D"]*s["Umean"]/s["Re"]
            stokes = s["rhoParticle"]*s["dParticle"]**2*s["Umean"]/(18*s["rhoFluid"]*nu*s["D"])
            printed = self.table.cases[name]["printed"]["St"]
            self.assertAlmostEqual(stokes/printed, 1, delta=0.1, msg=name)
        printed = [self.table.cases[f"Lau{i}"]["printed"]["St"] for i in (1, 2, 3)]
        self.assertAlmostEqual(printed[1]/printed[0], 2)
        self.assertAlmostEqual(printed[2]/printed[0], 4)

    def test_cells_of_table_2(self):
        """3,806,397 and 3,440,578 hexahedra: the full meshes within 1 %."""
        for name, s in self.full.items():
            pipe = s["nSide"]**2 + 4*s["nRing"]*s["nSide"]
            cells = pipe*(s["nPipe"] + s["nJet"]) + 4*s["nAir"]*s["nSide"]*s["nJet"]
            printed = 3806397 if s["rig"] == "Hardalupas" else 3440578
            self.assertAlmostEqual(cells/printed, 1, delta=0.01, msg=name)

    def test_full_is_not_coarse_grained_and_takes_the_steps_of_table_4(self):
        for name, s in self.full.items():
            self.assertEqual((s["cg"], s["couplingInterval"], s["pipeLength"]), (1, 10, 45))
            step = self.table.cases[name]["demStep"]
            self.assertAlmostEqual(s["demStep"]/step, 1, places=9)
            self.assertAlmostEqual(s["fluidStep"]/(10*s["subSteps"]*step), 1, places=9)

    def test_sub_steps_are_a_whole_number(self):
        """0, halves and numbers of floating point: an error that names the run and the entry."""
        for wrong in (0, 2.5, 5.0):
            self.table.data["defaults"]["subSteps"] = wrong
            with self.assertRaisesRegex(table.TableError, "Lau2: subSteps = .* must be a whole number from 1 on"):
                self.table.run("Lau2", "quick")

    def test_sizes(self):
        """Within the range, number mean the nominal diameter, fractions of the mass that add to 1."""
        for name, s in self.full.items():
            low, high = s["sizeRange"]
            self.assertTrue(all(low <= d <= high for d in s["diameters"]), name)
            self.assertAlmostEqual(sum(s["massFractions"]), 1, places=12)
            numbers = [m/d**3 for m, d in zip(s["massFractions"], s["diameters"])]
            mean = sum(n*d for n, d in zip(numbers, s["diameters"]))/sum(numbers)
            self.assertAlmostEqual(mean/s["dParticle"], 1, places=9, msg=name)
        self.assertEqual(len(self.full["Hardalupas1"]["diameters"]), 5)
        self.assertEqual(len(self.full["Lau1"]["diameters"]), 1)

    def test_mass_loading_from_mean_mass(self):
        for s in self.full.values():
            fluid = s["rhoFluid"]*s["Umean"]*math.pi/4*s["D"]**2
            self.assertAlmostEqual(s["particlesPerSecond"]*s["meanParticleMass"]/fluid, s["massLoading"], places=9)

    def test_windows_of_time_are_whole_steps(self):
        for size in self.table.sizes:
            for name in [*self.table.cases, *(r for s in self.table.studies.values() for r in s["run"])]:
                s = self.table.run(name, size)
                for time in ("writeInterval", "sampleStart", "endTime"):
                    steps = s[time]/s["fluidStep"]
                    self.assertAlmostEqual(steps, round(steps), places=4, msg=f"{name} {size} {time}")
                parts = s["sampleStart"]/s["writeInterval"]
                self.assertAlmostEqual(parts, round(parts), places=6, msg=f"{name} {size}")

    def test_steps_keep_their_limits(self):
        for size in ("quick", "medium", "full"):
            for name in self.table.cases:
                s = self.table.run(name, size)
                smallest = min(s["diameters"])/s["dParticle"]
                self.assertLess(s["percentRayleigh"]/smallest, 20, f"{name} {size}")

    def test_nothing_that_the_table_makes_is_refused(self):
        """By the limits of quickJet's particleInput on times, the plate and room for an insertion."""
        particle_input = runpy.run_path(str(CASES/"quickJet"/"particleInput"))

        class Settings(dict):
            word = dict.__getitem__

        for size in self.table.sizes:
            for name in [*self.table.cases, *(r for s in self.table.studies.values() for r in s["run"])]:
                run = self.table.run(name, size)
                for settings in (run, self.table.coarse(run)):
                    if settings:
                        particle_input["check_times"](Settings(settings))
                        particle_input["check_plate"](Settings(settings))
                        particle_input["check_insertion"](Settings(settings))


class Generated(grainjet.Case):
    """Folders of runs, without running them."""

    def allrun(self, *words):
        return grainjet.run([CASES/"Allrun", *words], self.folder, env={"GRAINJET_RUNS": str(self.folder/"runs")})

    def test_every_run_of_every_size_can_be_made(self):
        for words in (["quick"], ["medium"], ["full"], ["development", "mesh", "E", "interpolation", "cg",
                                                        "plate", "models", "model", "mesh-models",
                                                        "development-models", "quick"]):
            made = self.allrun("--generate", *words)
            self.assertEqual(made.code, 0, made)
        folder = self.folder/"runs"/"Lau3-full"
        text = (folder/"system"/"parameters").read_text()
        self.assertRegex(text, r"(?m)^D +0\.0127;")
        self.assertRegex(text, r"(?m)^Umean +48;")
        self.assertRegex(text, r"(?m)^planes +\(0\.2 10\);")
        self.assertIn("Lau3 full", (folder/"job.slurm").read_text())
        text = (self.folder/"runs"/"Lau1-models-quick"/"system"/"parameters").read_text()
        for entry in (r"D +0\.0127", "wallLaw +yes", "turbulentDispersion +Langevin", r"forces +\(pressureGradient .* SaffmanMei .*\)"):
            self.assertRegex(text, f"(?m)^{entry};")
        plate = (self.folder/"runs"/"plate15D-cg2-quick"/"system"/"parameters").read_text()
        self.assertRegex(plate, r"(?m)^endPatch +plate;")
        self.assertRegex(plate, r"(?m)^jetLength +15;")

    def test_larger_sizes_start_from_the_mesh_of_quick(self):
        """The folder coarse has the geometry of the run, the cells and iterations of quick; quick has no such folder."""
        self.allrun("--generate", "Lau1", "full")
        self.allrun("--generate", "Lau1", "quick")
        fine, coarse, quick = (dictionaries.values(self.folder/"runs"/name/"system"/"parameters")
                               for name in ("Lau1-full", "Lau1-full/coarse", "Lau1-quick"))
        for name in ("nSide", "nRing", "nAir", "nPipe", "nJet", "coreSide", "airGrading", "jetGrading", "spinUpIterations", "ranks"):
            self.assertEqual(coarse[name], quick[name], name)
        for name in ("D", "Umean", "Re", "pipeLength", "jetLength", "nozzleRadius", "endRadius", "widening"):
            self.assertEqual(coarse[name], fine[name], name)
        self.assertGreater(fine["nSide"], coarse["nSide"])
        self.assertFalse((self.folder/"runs"/"Lau1-quick"/"coarse").exists())

    def test_equals_quickJet_but_for_the_numbers(self):
        """A generated system/parameters has the names of quickJet's, in its order."""
        self.allrun("--generate", "Hardalupas1", "quick")
        names = []
        for path in (CASES/"quickJet", self.folder/"runs"/"Hardalupas1-quick"):
            lines = (path/"system"/"parameters").read_text().splitlines()
            names.append([line.split()[0] for line in lines if line and line[0].isalpha()])
        self.assertEqual(*names)

    def test_unknown_names_are_named(self):
        self.assertFails(self.allrun("--generate", "Hardalupas5"), "Hardalupas5", "Hardalupas1", "plate", "quick")
        self.assertFails(self.allrun("--generate", "Lau1", "huge"), "huge", "medium")
        self.assertFails(self.allrun("--generat"), "--generat", "--generate")
        self.assertFails(self.allrun("--ranks", "two"), "--ranks", "two")

    def test_changed_parameters_of_an_unfinished_run(self):
        self.allrun("--generate", "Lau1", "quick")
        path = self.folder/"runs"/"Lau1-quick"/"case.json"
        stated = json.loads(path.read_text())
        stated["settings"]["Umean"] = 11
        path.write_text(json.dumps(stated))
        self.assertFails(self.allrun("--generate", "Lau1", "quick"), "Umean", "--again")
        self.assertEqual(self.allrun("--generate", "Lau1", "quick", "--again").code, 0)

    def test_ranks_stay_as_the_run_was_begun(self):
        self.allrun("--generate", "Lau1", "full", "--ranks", "64")
        folder = self.folder/"runs"/"Lau1-full"
        self.assertIn("--ntasks=64", (folder/"job.slurm").read_text())
        self.assertEqual(grainjet.run(["bash", "-n", folder/"job.slurm"], self.folder).code, 0)
        again = self.allrun("--generate", "Lau1", "full")       # as the batch script calls it
        self.assertEqual(again.code, 0, again)
        self.assertIn("unfinished", again.output)
        self.assertFails(self.allrun("--generate", "Lau1", "full", "--ranks", "32"), "ranks", "--again")

    def test_wrong_entries_of_the_table(self):
        text = (CASES/"parameters.toml").read_text()
        for old, new, words in (
                ("massLoading = 0.23", "massLoadin = 0.23", ("massLoadin", "case.Hardalupas1")),
                ("massLoading = 0.23", "massLoading = 'much'", ("massLoading", "number", "case.Hardalupas1")),
                ("planes = [0.1, 10, 20]", "planes = 10", ("planes", "list", "rig.Hardalupas")),
                ('models = "paper"', 'models = "most"', ("most", "paper", "wallLaw")),
                ("[case.Hardalupas1]", "[case.Hardalupas1", ("line",))):
            path = self.folder/"table.toml"
            path.write_text(text.replace(old, new, 1))
            with self.assertRaises(table.TableError) as caught:
                table.Table(path).run("Hardalupas1", "quick")
            for word in words:
                self.assertIn(word, str(caught.exception))
        path.write_text(text.replace("cellLength = 0.2\n", "", 1))
        with self.assertRaises(table.TableError) as caught:
            table.Table(path).run("Hardalupas1", "quick")
        self.assertIn("cellLength", str(caught.exception))

    def test_python_without_a_reader_of_TOML(self):
        """As 3.10 is: the package python3-tomli does, without it the message names it."""
        script = "import sys; sys.modules['tomllib'] = None; import table; print(*table.Table().cases)"

        def read():
            return grainjet.run(["/usr/bin/python3", "-B", "-c", script], self.folder, env={"PYTHONPATH": f"{self.folder}:{CASES}/common"})

        (self.folder/"tomli.py").write_text("raise ModuleNotFoundError('No module named tomli')\n")
        self.assertFails(read(), "reads no TOML: install the package python3-tomli")
        # the same module under its other name
        (self.folder/"tomli.py").write_text("import sys\n\ndel sys.modules['tomllib']\nfrom tomllib import TOMLDecodeError, loads\n")
        result = read()
        self.assertEqual(result.output.split(), list(table.Table().cases), result)


if __name__ == "__main__":
    unittest.main()
