# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""particleSamplingPlanes: input that is refused before the first step, odd case paths, edits during the run."""

# processors: 2
# label: long

import unittest

import numpy

import ballistic_stream as stream
import grainjet
from grainjet import dictionaries, releases

SOLVER = "icoUncoupledKinematicParcelFoam"
WRONG = (                            # words of the error; the entries
    (("planes is missing or empty",), {"planes": "()"}),
    (("planes is missing or empty",), {"planes": None}),
    (("planes must be a list",), {"planes": "1"}),
    (("planes has 1 twice",), {"planes": "(1 2 1)"}),
    (("planes has 0.1 twice",), {"planes": "(0.1 0.10)"}),
    (("give the same file, plane_0.1D.dat",), {"planes": "(0.1 0.10000000000001)"}),
    (("planes has 20, outside the mesh", "from 0 to 10"), {"planes": "(1 20)"}),
    (("planes has -1, outside the mesh",), {"planes": "(-1 1)"}),
    (("planes has 1e+300",), {"planes": "(1e300)"}),
    (("radialBins 0",), {"radialBins": 0}),
    (("radialBins 1000000000",), {"radialBins": 1000000000}),
    (("more than 100000 rings",), {"radialBins": 10000, "planes": "(" + " ".join(map(str, range(11))) + ")"}),
    (("maxRadius -1",), {"maxRadius": -1}),
    (("maxRadius 1e+300",), {"maxRadius": "1e300"}),
    (("word 'nan'", "maxRadius"), {"maxRadius": "nan"}),
    (("diameter 0",), {"diameter": 0}),
    (("diameter 1e+300",), {"diameter": "1e300"}),
    (("axis (0 0 0)",), {"axis": "(0 0 0)"}),
    (("origin (1e+300 0 0)",), {"origin": "(1e300 0 0)"}),
    (("axis passes the mesh",), {"origin": "(5 0 0)"}),
    (("'origin' not found",), {"origin": None}),
    (("sizeClasses", "ascending"), {"sizeClasses": "(2e-3 1e-3)"}),
    (("sizeClasses has -1",), {"sizeClasses": "(-1 1e-3)"}),
    (("Unknown binning equal", "equalWidth", "equalArea"), {"binning": "equal"}),
    (("Unknown entry maxRadus", "maxRadius"), {"maxRadus": 3}),
    (("executeControl",), {"executeControl": "writeTime"}),
    (("timeStart 1e+300",), {"timeStart": "1e300"}),
    (("timeEnd 1 must lie after timeStart 2",), {"timeStart": 2, "timeEnd": 1}),
    (("timeEnd 0 ", "nothing would be sampled"), {"timeEnd": 0}),
    (("writeInterval 0",), {"writeControl": "runTime", "writeInterval": 0}),
    (("writePrecision 1000000000",), {"writePrecision": 1000000000}),
    (("region foo", "region0"), {"region": "foo"}),
    (("No cloud nobody", "kinematicCloud"), {"cloud": "nobody"}),
    (("No cloud liggghts", "kinematicCloud"), {"cloud": "liggghts"}),
)


class Input(grainjet.Case):

    def assertRefused(self, words, ranks=0, **changes):
        stream.control(self.folder, 0.05, functions=stream.sampling(**changes))
        result = self.foam(SOLVER, ranks=ranks, check=False)
        self.assertFails(result, "FOAM FATAL IO ERROR", releases.nested("controlDict", "functions", "profiles"), *words)
        self.assertNotIn("Time = 0.01", result.output, "before the first step")

    def test_refused(self):
        stream.write(self.folder, 0.05)
        self.foam("blockMesh")
        for words, changes in WRONG:
            with self.subTest(changes):
                self.assertRefused(words, **changes)
        self.foam("decomposePar")
        for words, changes in WRONG[6:7] + WRONG[-2:]:
            with self.subTest(changes, ranks=2):
                self.assertRefused(words, ranks=2, **changes)

    def test_any_length_of_the_axis(self):
        stream.write(self.folder, 0.2)
        self.foam("blockMesh")
        tables = set()
        for length in ("1", "1e200", "1e-200"):
            stream.control(self.folder, 0.2, functions=stream.sampling(axis=f"(0 0 {length})"))
            self.foam(SOLVER)
            tables.add((self.folder/"postProcessing/profiles/0/plane_1D.dat").read_text())
        self.assertEqual(len(tables), 1)

    def test_steady_solver(self):
        stream.write(self.folder, 5)
        self.foam("blockMesh")
        dictionaries.write_all(self.folder, {
            "constant/transportProperties": "DT [0 2 -1 0 0 0 0] 1;",
            "system/fvSolution": "solvers {} SIMPLE {}"})
        dictionaries.write_field(self.folder, "T", "[0 0 0 1 0 0 0]", 1, {".*": "type zeroGradient;"})
        dictionaries.change(self.folder/"system/fvSchemes",
                            ("ddtSchemes { default none;", "ddtSchemes { default steadyState;"))
        self.assertFails(self.foam("scalarTransportFoam", check=False), "FOAM FATAL IO ERROR", "samples in time", "steadyState")

    def test_folder_that_cannot_be_made(self):
        stream.write(self.folder, 0.05)
        self.foam("blockMesh")
        (self.folder/"postProcessing").write_text("a file")
        self.assertRefused(("postProcessing/profiles/0", "cannot be made"))

    def test_case_path(self):
        for name in ("a(1)", "b+c,d=e", "h\u00fcgel", "x[1]{2}"):
            with self.subTest(name):
                folder = self.folder/name
                stream.write(folder, 0.2)
                self.foam("blockMesh", folder)
                self.foam(SOLVER, folder)
                self.assertGreater(numpy.loadtxt(folder/"postProcessing/profiles/0/plane_1D.dat")[:, 1].sum(), 0)


class Edits(grainjet.Case):
    """controlDict is changed half-way through a run."""

    END = 0.4

    def run_case(self, name, edited=None):
        folder = self.folder/name
        stream.write(folder, self.END)
        self.foam("blockMesh", folder)
        update = f"""edit
{{
    type timeActivatedFileUpdate; libs (utilityFunctionObjects); fileToUpdate "{folder}/system/controlDict";
    timeVsFile ((-1 "{folder}/before") (0.2 "{folder}/after"));
}}
"""
        for name, functions in (("after", edited or stream.sampling()), ("before", stream.sampling())):
            stream.control(folder, self.END, functions=functions + update, interval=5,
                           extra="runTimeModifiable yes; OptimisationSwitches { fileModificationSkew 0; }")
            (folder/name).write_text((folder/"system/controlDict").read_text())
        log = self.foam(SOLVER, folder).output
        return log, (folder/"postProcessing/profiles/0/plane_1D.dat").read_text()

    def test_the_run_goes_on_as_it_began(self):
        _, unedited = self.run_case("unedited")
        for i, changes in enumerate((
                {"planes": "(3 4)"}, {"radialBins": 7}, {"planes": "()"}, {"diameter": 0}, {"maxRadus": 3},
                {"cloud": "nobody"}, {"axis": "(0 0 0)", "reset": "maybe"},
                {"writeControl": "timeStep", "writeInterval": 3}, {"timeStart": 0.1, "timeEnd": 5})):
            with self.subTest(changes):
                log, table = self.run_case(f"edit{i}", stream.sampling(**changes))
                self.assertEqual(log.count("this one goes on as it began"), 1)
                self.assertIn("profiles in", log)
                self.assertEqual(table, unedited)

    def test_added_by_an_edit(self):
        _, unedited = self.run_case("unedited")
        right = stream.sampling().replace("profiles", "second")
        for name, wrong in (("planes", stream.sampling(planes="()")), ("region", stream.sampling(region="foo")),
                            ("cloud", stream.sampling(cloud="nobody"))):
            log, table = self.run_case(name, stream.sampling() + right + wrong.replace("profiles", "third"))
            self.assertEqual(table, unedited)
            self.assertIn("loading function object 'third'", log)
            # in a folder of its own: the time at which it was added
            self.assertIn("sampled time = 0.2 s", (self.folder/name/"postProcessing/second/0.2/plane_1D.dat").read_text())
            self.assertFalse((self.folder/name/"postProcessing/third").exists())

    def test_window_closed_by_an_edit(self):
        # What has been sampled by then is written: the step in which the edit is seen is not
        log, table = self.run_case("closed", stream.sampling(timeEnd=0.1))
        self.assertIn("goes on as it began", log)
        self.assertRegex(table, "sampled time = 0.(19|2|20) s")

    def test_window_moved_by_an_edit(self):
        log, table = self.run_case("moved", stream.sampling(timeStart=0.3))
        self.assertIn("was not executed between the steps", log)
        self.assertRegex(table, "sampled time = 0.(29|3) s")


if __name__ == "__main__":
    unittest.main()
