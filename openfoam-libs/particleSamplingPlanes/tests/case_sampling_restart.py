# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""particleSamplingPlanes: a restart continues the averages or says why not; it never begins anew unasked."""

# processors: 2
# label: long

import shutil
import unittest

import numpy

import ballistic_stream as stream
import grainjet
from grainjet import dictionaries, releases

SOLVER = "icoUncoupledKinematicParcelFoam"
BREAK, END = 0.4, 0.8            # s; fields are written every 0.2 s
STATE = "uniform/particleSamplingPlanes/profiles"


class Restart(grainjet.Case):

    def start(self, name="case", functions=None, ranks=0, end=BREAK):
        folder = self.folder/name
        stream.write(folder, end, functions=functions)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.foam(SOLVER, folder, ranks=ranks)
        return folder

    def go_on(self, folder, functions=None, ranks=0, start="latestTime", check=True):
        stream.control(folder, END, start=start, functions=functions)
        return self.foam(SOLVER, folder, ranks=ranks, check=check)

    def table(self, folder, start, plane="1"):
        return (folder/f"postProcessing/profiles/{start}/plane_{plane}D.dat").read_text()

    def assertSame(self, one, other):
        """Counts are equal; places of parcels lose their last digits in OpenFOAM's files."""
        one, other = (numpy.array([line.split() for line in text.splitlines() if line[0] != "#"], float) for text in (one, other))
        self.assertGreater(one[:, 1].sum(), 0)
        self.assertEqual(list(one[:, 1]), list(other[:, 1]))
        numpy.testing.assert_allclose(one, other, rtol=1e-8, atol=1e-10)

    def test_without_the_file_of_openfoam(self):
        # which a killed run may lack: OpenFOAM writes it after the fields
        unbroken = self.start("unbroken", end=END)
        folder = self.start()
        shutil.rmtree(folder/f"{BREAK}/uniform/functionObjects")
        self.go_on(folder)
        self.assertSame(self.table(folder, BREAK), self.table(unbroken, 0))

    def test_with_triggers(self):
        functions = stream.sampling(triggerStart=1, controlMode="timeOrTrigger")
        unbroken = self.start("unbroken", functions, end=END)
        folder = self.start("case", functions)
        self.go_on(folder, functions)
        self.assertSame(self.table(folder, BREAK), self.table(unbroken, 0))

    def test_missing(self):
        for ranks in (0, 2):
            folder = self.start(f"ranks{ranks}", ranks=ranks)
            for part in folder.glob(f"processor*/{BREAK}") if ranks else [folder/f"{BREAK}"]:
                (part/STATE).unlink()
            tables = self.table(folder, 0)
            result = self.go_on(folder, ranks=ranks, check=False)
            self.assertFails(result, "FOAM FATAL IO ERROR", f"{BREAK}/{STATE}", f"time {BREAK} is missing", "reset yes",
                             releases.nested("controlDict", "functions", "profiles"))
            self.assertNotIn(f"Time = {BREAK + stream.DT:g}\n", result.output, "before the first step")
            self.assertEqual(self.table(folder, 0), tables)

            log = self.go_on(folder, stream.sampling(reset="yes"), ranks=ranks).output
            self.assertIn("begins anew and forgets", log)
            self.assertIn(f"sampled time = {END - BREAK:g} s", self.table(folder, BREAK))

    def test_the_remedy_works(self):
        unbroken = self.start("unbroken", end=END)
        folder = self.start()
        (folder/f"{BREAK}"/STATE).unlink()
        shutil.rmtree(folder/f"{BREAK}")
        self.go_on(folder)
        self.assertSame(self.table(folder, "0.2"), self.table(unbroken, 0))

    def test_missing_where_only_tables_tell(self):
        # the first time written, or earlier ones purged
        folder = self.start(end=0.2)
        (folder/"0.2"/STATE).unlink()
        self.assertFails(self.go_on(folder, check=False), "time 0.2 is missing", "reset yes")

    def test_cut_short(self):
        folder = self.start()
        path = folder/f"{BREAK}"/STATE
        whole = path.read_text()
        for size in (0, 300, len(whole)//2, whole.index("complete")):
            with self.subTest(size):
                path.write_text(whole[:size])
                self.assertFails(self.go_on(folder, check=False), "FOAM FATAL IO ERROR", f"{BREAK}/{STATE}", "cut short", "reset yes")

    def test_of_another_time(self):
        folder = self.start()
        for time in ("0", "0.2"):
            shutil.rmtree(folder/time)
        (folder/f"{BREAK}").rename(folder/"0")
        shutil.rmtree(folder/"postProcessing")
        (folder/"0/uniform/time").unlink()
        self.assertFails(self.go_on(folder, check=False), f"up to time {BREAK}, not 0", "reset yes")

    def test_other_planes(self):
        folder = self.start()
        for changes in ({"planes": "(1 2)"}, {"radialBins": 3}, {"maxRadius": 0.7}, {"axis": "(0.1 0 1)"}, {"sizeClasses": "(0 1)"}):
            with self.subTest(changes):
                self.assertFails(self.go_on(folder, stream.sampling(**changes), check=False), "reset yes", STATE)

    def test_new_at_a_restart(self):
        # no error: nothing can have been sampled before
        late = stream.sampling(timeStart=0.5)
        for name, before, after in (("added", "", None), ("later", late, late)):
            with self.subTest(name):
                folder = self.start(name, before)
                log = self.go_on(folder, after).output
                self.assertIn("profiles: crossings", log)
        # a run made again from its start has states and tables of the first one
        folder = self.start("again", late, end=0.7)
        for path in folder.glob("0.*/uniform"):
            shutil.rmtree(path)
        stream.control(folder, END, functions=late)
        dictionaries.change(folder/"system/controlDict", ("startTime 0;", "startTime 0.4;"))
        self.foam(SOLVER, folder)
        folder = self.start("zero")
        self.assertNotIn("continues", self.go_on(folder, start="startTime").output)

    def test_collated(self):
        unbroken = self.start("unbroken", end=END)
        folder = self.folder/"case"
        stream.write(folder, BREAK)
        self.foam("blockMesh", folder)
        handler = {"FOAM_FILEHANDLER": "collated"}
        run = [*grainjet.mpirun(2), SOLVER, "-parallel"]
        for command in (["decomposePar"], run):
            self.assertEqual(grainjet.run(command, folder, env=handler).code, 0)
        stream.control(folder, END, start="latestTime")
        result = grainjet.run(run, folder, env=handler, timeout=100)
        self.assertEqual(result.code, 0, result)
        self.assertIn(f"continues with {BREAK} s", result.output)
        self.assertFalse((folder/"processor0").exists())
        self.assertSame(self.table(folder, BREAK), self.table(unbroken, 0))


if __name__ == "__main__":
    unittest.main()
