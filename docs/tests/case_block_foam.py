# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The blocks for OpenFOAM, each read by the solver in the file that it is for: unknown entries, words and models are errors."""
# label: long

import re
import unittest

import grainjet
from grainjet import blocks, coupled_box, dictionaries
from grainjet.pages import FOLLOWED, table_of_page

COUPLING = set(table_of_page((grainjet.ROOT / "docs/liggghtsCoupling.md").read_text(), "Entries"))
# other tests read these: models of a library that they build; the inlet's profile over its faces; solvers of a fluid with a surface
ELSEWHERE = {**FOLLOWED, "docs/new_model.md": "openfoam-libs/liggghtsCoupling/tests/case_user_models.py",
             "docs/theory-turbulence.md": "openfoam-libs/jetTurbulenceModels/tests/case_inlet.py"}
FIELDS = {"k": ("0 2 -2", 0.1), "epsilon": ("0 2 -3", 1.0), "nut": ("0 2 -1", 1e-4), "decompositionWeights": ("0 0 0", 1.0)}


def first_level(text):
    """The names at the first level of a dictionary."""
    text = re.sub(r"//[^\n]*", "", text)
    while re.search(r"\{[^{}]*\}", text):
        text = re.sub(r"\{[^{}]*\}", ";", text)
    return {entry.split()[0] for entry in text.split(";") if entry.split()}


def coupling_of(text):
    """The text of fvOptions with a block of entries of the coupling, or None."""
    if "liggghtsCoupling;" in text:
        return text
    names = first_level(text)
    if not names or names - COUPLING - {"selfDisturbance"}:
        return None
    needed = "" if "couplingInterval" in names else "couplingInterval 10;"
    return f'particles {{ type liggghtsCoupling; script "constant/in.particles"; {needed}\n{text}\n}}'


def file_of(text):
    """Where a block belongs."""
    names = first_level(text)
    if coupling_of(text):
        return "fvOptions"
    for name, file in (("simulationType", "turbulenceProperties"), ("functions", "controlDict"), ("libs", "controlDict"),
                       ("rho", "transportProperties"), ("numberOfSubdomains", "decomposeParDict"), ("solvers", "fvSolution")):
        if name in names:
            return file
    return None


class FoamBlocks(grainjet.Case):

    def setUp(self):
        super().setUp()
        coupled_box.write(self.folder, cells="2 2 2", steps=0, write_every=1, walls=True)
        dictionaries.write(self.folder / "system/blockMeshDict", dictionaries.block(
            (-0.05, -0.05, -0.1), (0.05, 0.05, 0.5), "2 2 6", {side: ("wall", side) for side in dictionaries.SIDES}))
        coupled_box.script(self.folder, grains=coupled_box.grains([(0.011, 0.009, 0.02)], [(0, 0, 0)]))
        coupled_box.fv_options(self.folder)
        self.good = (self.folder / "constant/fvOptions").read_text()
        self.control = (self.folder / "system/controlDict").read_text()
        self.decompose = (self.folder / "system/decomposeParDict").read_text()
        self.solution = (self.folder / "system/fvSolution").read_text()
        for name, (dimensions, value) in FIELDS.items():
            dictionaries.write_field(self.folder, name, dimensions, value, '".*" { type zeroGradient; }')
        self.foam("blockMesh")

    def read(self, text):
        """What the solver says to a block in its file; the rest of the case is a good one. Function objects are read with
        the first step, which LIGGGHTS makes with one grain; all else without one."""
        file = file_of(text)
        write, constant, system = dictionaries.write, self.folder / "constant", self.folder / "system"
        (constant / "fvOptions").write_text(self.good)
        if coupling_of(text):
            write(constant / "fvOptions", coupling_of(text))
        write(constant / "turbulenceProperties", text if file == "turbulenceProperties" else "simulationType laminar;")
        write(constant / "transportProperties", "transportModel Newtonian; nu 1.5e-5;" + (text if file == "transportProperties" else "rho 1.2;"))
        control = self.control.replace('libs ("libliggghtsCoupling.so");', 'libs ("libliggghtsCoupling.so" "libjetTurbulenceModels.so");')
        if file == "controlDict":
            if "functions" in first_level(text):
                control = control.replace("endTime 0.0;", "endTime 1e-4;")
            control = re.sub(r"(?m)^libs .*$" if "libs" in first_level(text) else r"functions \{  \}", "", control) + text
        (system / "controlDict").write_text(control)
        (system / "decomposeParDict").write_text(self.decompose if file != "decomposeParDict" else "")
        (system / "fvSolution").write_text(self.solution)
        if file == "fvSolution":        # of a case with an outlet; this one has walls all around
            write(system / file, text + "\nPIMPLE { pRefCell 0; pRefValue 0; }")
        if "libs" in first_level(text) and "libliggghtsCoupling.so" not in text:
            write(constant / "fvOptions", "")
        if file == "decomposeParDict":
            write(system / file, text)
            return grainjet.run(["decomposePar", "-force"], self.folder)
        return grainjet.run(["pimpleFoam"], self.folder)

    def test_the_pages(self):
        found = [block for block in blocks.of_pages() if block.language == "foam" and block.page not in ELSEWHERE]
        self.assertGreater(len(found), 12)
        for block in found:
            with self.subTest(block.place):
                self.assertIsNotNone(file_of(block.text), "no file is known for these entries")
                result = self.read(block.text)
                self.assertEqual(result.code, 0, result)
                self.assertIn("End", result.output)

    def test_broken_blocks_are_found(self):
        for text in ("particles { type liggghtsCoupling; script \"constant/in.particles\"; couplingIntervall 10; }",
                     "forces { drag { model Gidaspov; } }", "turbulentDispersion { model Langevin; Sct 0.7; seeds 1; }",
                     "simulationType RAS; RAS { RASModel jetKEpsilom; turbulence on; printCoeffs on; }",
                     "functions { profiles { type particleSamplingPlanes; libs (\"libparticleSamplingPlanes.so\"); cloud liggghts; } }",
                     "numberOfSubdomains 2; method simpel;"):
            with self.subTest(text):
                self.assertNotEqual(self.read(text).code, 0)

    def test_what_is_read_elsewhere(self):
        for test in ELSEWHERE.values():
            self.assertTrue((grainjet.ROOT / test).is_file(), test)


if __name__ == "__main__":
    unittest.main()
