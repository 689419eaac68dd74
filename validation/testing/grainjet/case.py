# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A test with a folder of its own."""

import os
import pathlib
import shutil
import tempfile
import unittest

from grainjet.programs import mpirun, run


class Case(unittest.TestCase):
    """A test with a fresh folder of its own, kept if GRAINJET_KEEP is set."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-"))

    def tearDown(self):
        if os.environ.get("GRAINJET_KEEP"):
            print(f"kept: {self.folder}")
        else:
            shutil.rmtree(self.folder, ignore_errors=True)

    def new_folder(self):
        """The path of a further folder inside that of the test; not made yet."""
        return self.folder / str(len(list(self.folder.iterdir())))

    def liggghts(self, script, ranks=0, program="liggghts-plugins", args=(), check=True, name="in.test"):
        """Run an input script (text) under the launcher; 0 ranks: without mpirun."""
        (self.folder / name).write_text(script)
        result = run([*mpirun(ranks), program, "-in", name, *args], self.folder)
        if check:
            self.assertEqual(result.code, 0, result)
        return result

    def foam(self, solver, case=None, ranks=0, check=True, timeout=600):
        """Run an OpenFOAM program in a case folder; in parallel on `ranks` ranks if not 0."""
        parallel = ["-parallel"] if ranks else []
        result = run([*mpirun(ranks), solver, *parallel], case or self.folder, timeout)
        if check:
            self.assertEqual(result.code, 0, result)
        return result

    def assertFails(self, result, *words):
        """The run ended by itself with a code other than 0 and printed all these words."""
        self.assertNotEqual(result.code, 0, result)
        self.assertTrue(all(words), "an empty word is in every output")
        for word in words:
            self.assertIn(word, result.output)
