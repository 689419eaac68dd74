# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of bad input to the coupling share: a box of a few cells that is spoilt again and again."""

import pathlib
import shutil
import tempfile

import grainjet
from grainjet import coupled_box as box, dictionaries

WALL = 'boundaryField { ".*" { type zeroGradient; } }\n'

GRAIN = box.grains([(0.01, 0.01, 0.01)], [(0, 0, 1)])


class BadCase(grainjet.Case):
    """Each test gets a fresh copy of a small case, meshed and decomposed for 2 ranks."""

    @classmethod
    def setUpClass(cls):
        cls.base = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-bad-"))
        box.write(cls.base, walls=True, cells="2 2 4", steps=2, write_every=100)
        box.script(cls.base, grains=GRAIN, boundary="f f f")
        box.fv_options(cls.base)
        for command in (["blockMesh"], ["decomposePar"]):
            result = grainjet.run(command, cls.base)
            if result.code:
                raise AssertionError(result)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.base, ignore_errors=True)

    def fresh(self):
        """A fresh copy of the case; its folder."""
        folder = self.new_folder()
        shutil.copytree(self.base, folder)
        return folder

    def change(self, folder, path, *pairs):
        """Replace texts in a file of the case; each must be there."""
        dictionaries.change(folder / path, *pairs)

    def put(self, folder, path, text, cls="dictionary"):
        dictionaries.write(folder / path, text, cls)

    def field(self, folder, name, dimensions, value, patches=WALL):
        self.put(folder, f"0/{name}", f"dimensions {dimensions}; internalField uniform {value};\n{patches}",
                 "volVectorField" if "(" in value else "volScalarField")

    def turbulent(self, folder, model, *fields, kind="RAS", more=""):
        self.put(folder, "constant/turbulenceProperties",
                 f"simulationType {kind}; {kind} {{ {kind}Model {model}; turbulence on; printCoeffs off; {more} "
                 "delta cubeRootVol; cubeRootVolCoeffs { deltaCoeff 1; } }\n")
        for name in ("nut", *fields):
            values = {"k": ("[0 2 -2 0 0 0 0]", "0.1"), "epsilon": ("[0 2 -3 0 0 0 0]", "1"),
                      "omega": ("[0 0 -1 0 0 0 0]", "100"), "nut": ("[0 2 -1 0 0 0 0]", "0")}[name]
            self.field(folder, name, *values,
                       'boundaryField { ".*" { type calculated; value uniform 0; } }\n' if name == "nut" else WALL)
        self.change(folder, "system/fvSchemes", ("divSchemes {", "wallDist { method meshWave; } divSchemes {"))
        self.change(folder, "system/fvSolution", ('"U.*"', '"(U|k|epsilon|omega).*"'))

    def assertRefused(self, folder, *words, solver="pimpleFoam", ranks=0, steps=False, at_reading=False):
        """The run ends with exit code 1 and an error that holds all words; before the solver has
        solved for velocity or pressure, unless steps are allowed; at_reading: before the first time step.
        An error that several ranks find is printed once."""
        result = self.foam(solver, folder, ranks, check=False, timeout=60)
        if result.code != 1 or "FOAM FATAL" not in result.output:
            self.fail(f"not refused: exit code {result.code}\n{result.output[-1500:]}")
        message = result.output[result.output.index("FOAM FATAL"):]
        for word in words:
            self.assertIn(word, message)
        self.assertEqual(result.output.count("FOAM FATAL"), 1, result)
        if not steps:
            self.assertNotRegex(result.output, box.SOLVED)
        if at_reading:
            self.assertNotIn("\nTime = ", result.output)
        return result

    def assertRuns(self, folder, solver="pimpleFoam", ranks=0):
        result = self.foam(solver, folder, ranks, timeout=60)
        self.assertIn("\nEnd", result.output)
        return result
