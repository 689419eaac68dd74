# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Utilities on a coupled case: they make its options, but run no grain and write nothing of a run."""
# processors: 2

import hashlib
import unittest

import grainjet
from grainjet import coupled_box as box
from grainjet.coupled_box import swarm

FUNCTIONS = """
    profiles
    {
        type        particleSamplingPlanes;
        libs        ("libparticleSamplingPlanes.so");
        cloud       liggghts;
        origin      (0.01 0.01 0);
        axis        (0 0 1);
        diameter    0.01;
        planes      (1 2 3);
        radialBins  3;
        maxRadius   1;
    }
    grains
    {
        type        vtkCloud;
        libs        ("liblagrangianFunctionObjects.so");
        cloud       liggghts;
        writeControl writeTime;
    }
"""

NO_PARTICLES = "post-processing has no particles of cloud liggghts at hand"

# what is run, and on how many ranks; those that make the functions of controlDict say so of the planes
UTILITIES = (
    (["foamDictionary", "constant/fvOptions", "-entry", "particles/couplingInterval", "-value"], 0, False),
    (["foamDictionary", "system/controlDict"], 0, False),
    (["checkMesh"], 0, False),
    (["postProcess"], 0, True),
    (["postProcess", "-latestTime"], 0, True),
    (["pimpleFoam", "-postProcess"], 0, True),
    (["pimpleFoam", "-postProcess"], 2, True),
)

# these write a field into each time and change nothing else
FIELDS = (
    (["postProcess", "-func", "mag(U)"], 0, "mag(U)"),
    (["pimpleFoam", "-postProcess", "-func", "CourantNo"], 0, "Co"),
    (["pimpleFoam", "-postProcess", "-func", "vorticity"], 2, "vorticity"),
)


def content(folder):
    """All files of a case, each with a checksum."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in folder.rglob("*") if path.is_file()}


class Utilities(grainjet.Case):

    def setUp(self):
        super().setUp()
        box.write(self.folder, steps=40, write_every=20, functions=FUNCTIONS, cells="4 4 8")
        x, v = swarm(50, 3, rms=0.1)
        box.script(self.folder, grains=box.grains(x, v))
        box.fv_options(self.folder)
        self.foam("blockMesh")

    def utility(self, command, ranks):
        parallel = ["-parallel"] if ranks else []
        result = grainjet.run([*grainjet.mpirun(ranks), *command, *parallel], self.folder)
        self.assertEqual(result.code, 0, result)
        self.assertNotIn("FOAM FATAL", result.output)
        return result.output

    def assertNoRun(self, files):
        for name in files:
            for word in ("balance.dat", "log.liggghts", "liggghts.restart", "liggghtsCouplingProperties",
                         "voidFraction", "plane_", ".vtp"):
                self.assertNotIn(word, name)

    def check(self, fresh):
        """All utilities, one after the other: what was there stays byte by byte."""
        for command, ranks, functions in UTILITIES:
            with self.subTest(command=command, ranks=ranks):
                before = content(self.folder)
                output = self.utility(command, ranks)
                self.assertEqual(content(self.folder), before)
                self.assertEqual(output.count(NO_PARTICLES), 1 if functions else 0, output)
        for command, ranks, name in FIELDS:
            with self.subTest(command=command, ranks=ranks):
                before = content(self.folder)
                self.utility(command, ranks)
                after = content(self.folder)
                new = sorted(set(after) - set(before))
                self.assertGreaterEqual(len(new), 1 if fresh else 3)
                self.assertEqual([path for path in new if path.split("/")[-1] != name], [])
                self.assertEqual({path: after[path] for path in before}, before)
                if fresh:
                    self.assertNoRun(after)

    def test_fresh_case(self):
        """No former run: nothing of a run appears, and none is missed."""
        self.utility(["decomposePar"], 0)
        self.assertNoRun(content(self.folder))
        self.check(fresh=True)

        # and the case has been left fit for its run
        result = self.foam("pimpleFoam")
        self.assertIn("50 new grains", result.output)
        self.assertEqual(len(box.read_balance(self.folder)["Time"]), 40)

    def test_finished_case(self):
        """Tables, profiles, grains and log of the run stay as they are."""
        self.utility(["decomposePar"], 0)
        self.foam("pimpleFoam", ranks=2)
        self.utility(["reconstructPar"], 0)
        ran = content(self.folder)
        for name in ("postProcessing/liggghtsCoupling/0/balance.dat", "postProcessing/profiles/0/plane_1D.dat",
                     "log.liggghts", "0.004/uniform/liggghts.restart"):
            self.assertIn(name, ran)
        self.check(fresh=False)

        # decomposed anew, the run goes on
        self.utility(["decomposePar", "-force", "-latestTime"], 0)
        control = self.folder / "system/controlDict"
        control.write_text(control.read_text().replace("endTime 0.004;", "endTime 0.005;"))
        result = self.foam("pimpleFoam", ranks=2)
        self.assertIn("50 continued grains", result.output)

    def test_run_that_is_over(self):
        """A solver started at its end time makes no step: no grain is run, and nothing changes."""
        self.foam("pimpleFoam")
        before = content(self.folder)
        output = self.utility(["pimpleFoam"], 0)
        self.assertNotIn("grains", output)
        self.assertEqual(content(self.folder), before)

    def test_without_a_script(self):
        """A script that cannot run is no matter for a utility; the solver refuses it."""
        (self.folder / "constant/in.particles").unlink()
        self.utility(["pimpleFoam", "-postProcess"], 0)
        result = self.foam("pimpleFoam", check=False)
        self.assertFails(result, "FOAM FATAL", "in.particles", "not found")


    def test_bad_entry(self):
        """A utility that makes options refuses one, as the solver does; others never see it."""
        options = self.folder / "constant/fvOptions"
        options.write_text(options.read_text().replace("minimum 0.3", "minimum 3"))
        for command in (["decomposePar"], ["checkMesh"], ["postProcess"]):
            self.utility(command, 0)
        for command, ranks in ((["pimpleFoam", "-postProcess"], 0), (["pimpleFoam", "-postProcess"], 2), (["pimpleFoam"], 0)):
            result = grainjet.run([*grainjet.mpirun(ranks), *command, *["-parallel"][:ranks]], self.folder, timeout=60)
            self.assertFails(result, "FOAM FATAL", "minimum 3 ", "above 0 and below 1")
            self.assertEqual(result.output.count("FOAM FATAL"), 1, result)
        self.assertNoRun(content(self.folder))


if __name__ == "__main__":
    unittest.main()
