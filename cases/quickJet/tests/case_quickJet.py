# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The main job, shrunk: the same Allrun on a coarser mesh with larger grains, in a copy of the
folder. What it must leave behind, what must hold in its results, and how it fails."""

import re
import shutil
import unittest

import numpy

import grainjet
from grainjet import dictionaries, fields, tables

QUICK_JET = grainjet.ROOT/"cases"/"quickJet"

# Every length of a cell and the time step twice those of the job, grains twice as large:
# Courant number and % Rayleigh stay the same, and so does the number of sub-steps
SHRUNK = {"cg": 4, "fluidStep": 5e-4, "nSide": 4, "nRing": 3, "nAir": 8, "nPipe": 38, "nJet": 32,
          "sampleStart": 0.06, "endTime": 0.1, "writeInterval": 0.02}


def shrunk_copy(folder):
    """The case in a folder of its own, with the coarser parameters."""
    case = folder/"quickJet"
    shutil.copytree(QUICK_JET, case, ignore=shutil.ignore_patterns(
        "tests", "log.*", "processor*", "postProcessing", "results", "polyMesh", "particles", "0",
        "0.[0-9]*", "[1-9]*"))
    grainjet.run(["./Allclean"], case)      # what the job itself has left, if it ran here before
    dictionaries.put(case/"system"/"parameters", **SHRUNK)
    return case


# Fewer cells than anybody would take, long or stretched ones: with SIMPLEC, or linearUpwind for k and epsilon, the steady flow diverges on most of these
COARSE = ({"pipeLength": 20, "insertionLength": 19.75, "nSide": 4, "nRing": 3, "nAir": 8, "nPipe": 80, "nJet": 42},
          {"pipeLength": 20, "insertionLength": 19.75, "nSide": 4, "nRing": 2, "nAir": 8, "nPipe": 30, "nJet": 30},
          {"pipeLength": 20, "insertionLength": 19.75, "nSide": 2, "nRing": 1, "nAir": 5, "nPipe": 15, "nJet": 16},
          {"nSide": 4, "nRing": 3, "nAir": 8, "nPipe": 38, "nJet": 32, "jetLength": 48},
          {"nSide": 4, "nRing": 3, "nAir": 8, "nPipe": 38, "nJet": 32, "jetGrading": 1},
          {"nSide": 4, "nRing": 3, "nAir": 4, "nPipe": 19, "nJet": 16})
STEADY = f'set -eu -o pipefail; root={grainjet.ROOT}; . "$root/cases/common/job.sh"; mesh_stage; steady_stage'


class QuickJet(grainjet.Case):

    def test_steady_start_on_coarse_meshes(self):
        """It ends, and the largest velocity lies between the bulk velocity and that on the axis of a laminar pipe, twice as much."""
        for mesh in COARSE:
            with self.subTest(mesh):
                case = self.new_folder()/"quickJet"
                shutil.copytree(QUICK_JET, case, ignore=shutil.ignore_patterns("tests", "log.*", "processor*", "postProcessing", "results"))
                grainjet.run(["./Allclean"], case)
                dictionaries.put(case/"system"/"parameters", ranks=1, **mesh)
                dictionaries.put(case/"spinUp/system/controlDict", writeFormat="ascii")
                job = grainjet.run(["bash", "-c", STEADY], case, timeout=300)
                self.assertEqual(job.code, 0, job)
                speeds = numpy.linalg.norm(dictionaries.internal(case/"0"/"U"), axis=1)
                self.assertLess(speeds.max(), 2*13)
                self.assertGreater(speeds.max(), 13)

    def test_a_steady_flow_that_diverged_is_refused(self):
        """A solver that ends well, as a diverged one may, whose last mass balance is out of all bounds or no number."""
        case = shrunk_copy(self.new_folder())
        dictionaries.put(case/"system"/"parameters", ranks=1)
        for sum_local in ("1.40702e+30", "2.5e+05", "nan", "-nan", "inf"):
            with self.subTest(sum_local):
                solver = f"simpleFoam() {{ echo 'time step continuity errors : sum local = {sum_local}, global = 1, cumulative = 1'; }}; "
                job = grainjet.run(["bash", "-c", solver + STEADY.replace("mesh_stage; ", "")], case)
                self.assertFails(job, f"the steady flow has diverged (continuity errors of {sum_local})")

    def test_job_and_its_results(self):
        case = shrunk_copy(self.folder)
        job = grainjet.run(["./Allrun"], case, timeout=800, env={"GRAINJET_PROGRESS": "2"})
        self.assertEqual(job.code, 0, job)

        # progress with time left, in words
        self.assertRegex(job.output, r"% done, \d+ s left, grains \d+ \(inserted \d+, left the box \d+")

        # check.py has judged fluxes, balance and velocities: nothing failed
        self.assertIn("All checks hold", job.output)
        for position in (0.1, 10, 20):
            profile = tables.read(case/f"postProcessing/profiles/0/plane_{position:g}D.dat")
            self.assertGreater(profile["crossings"].sum(), 0, position)
        for picture in ("results/profiles.png", "results/jet.png"):
            self.assertTrue((case/picture).read_bytes().startswith(b"\x89PNG"), picture)
        _, places, _ = fields.grains_at(case/"postProcessing/grains", SHRUNK["endTime"])
        self.assertGreater(len(places), 0)
        self.assertIn("z/D", (case/"results/summary.txt").read_text())
        time, mesh = fields.latest_mesh(case)           # by quickJet.foam, as ParaView does
        self.assertEqual(time, SHRUNK["endTime"])
        self.assertGreater(mesh.GetNumberOfCells(), 0)
        for field in ("U", "voidFraction"):
            self.assertTrue(mesh.GetCellData().HasArray(field), field)

        # a check that cannot fail is none: spoil the balance and it must
        balance = next((case/"postProcessing"/"liggghtsCoupling").glob("*/balance.dat"))
        self.assert_failed(case, balance, "inserted ", "inserted", lambda n: n + 100)      # 100 grains that are nowhere
        self.assert_failed(case, balance, "sub-steps: in a fluid step", "fluidChange", lambda change: 20*change)
        dictionaries.change(case/"log.pimpleFoam", ("\nEnd", "\nCourant Number mean: 0.1 max: 5.1\nEnd"))
        self.assert_failed(case, balance, "sub-steps: largest Courant number 5.1", "bytes", lambda n: n)
        # no grains were written when the sampling began: said instead of a wrong count
        dictionaries.put(case/"system/parameters", sampleStart=0.07)
        judged = grainjet.run([grainjet.ROOT/"cases"/"common"/"check.py", case], case)
        self.assertRegex(judged.output, "FAILED +crossings: grains were written at 0.0[68] s, not at sampleStart = 0.07 s.*a multiple of writeInterval")
        self.assertNotIn("crossings of", judged.output)

    def assert_failed(self, case, balance, words, column, spoil):
        """Of all checks those that begin with these words fail, and no others, if a column of the balance is another one."""
        kept = balance.read_text()
        lines = kept.splitlines()
        place = list(tables.read(balance)).index(column)
        for i, line in enumerate(lines):
            if line[:1] != "#":
                values = line.split("\t")
                values[place] = f"{spoil(float(values[place])):.17g}"
                lines[i] = "\t".join(values)
        balance.write_text("\n".join(lines) + "\n")
        judged = grainjet.run([grainjet.ROOT/"cases"/"common"/"check.py", case], case)
        balance.write_text(kept)
        self.assertNotEqual(judged.code, 0, judged)
        failed = re.findall(r"(?m)^ *FAILED +(.*)$", judged.output)
        self.assertEqual([text.startswith(words) for text in failed], [True]*len(failed), judged)
        self.assertGreater(len(failed), 0)

    def test_failing_solver_ends_the_job_with_its_message(self):
        case = shrunk_copy(self.folder)
        options = case/"system"/"fvOptions"
        options.write_text(options.read_text().replace("Gidaspow", "Gidaspov"))
        job = grainjet.run(["./Allrun"], case, timeout=300)
        self.assertFails(job, "Gidaspov", "log.pimpleFoam")
        self.assertFalse((case/"results"/"summary.txt").exists())


if __name__ == "__main__":
    unittest.main()
