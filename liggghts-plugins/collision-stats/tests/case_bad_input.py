# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""fix collision/stats: entries missing, misspelt, twice, of the wrong kind or out of range; contacts, regions and files that
it cannot work with. One error on every rank, before any step."""

import concurrent.futures
import os
import shutil
import unittest

import grainjet
from collision_case import CollisionCase

D = 0.001
GOOD = {"contact": "c", "region": "r", "bins": "x 0 0.01 4", "energy": "1e-9 1e-3 12", "speed": "1e-3 10 4", "force": "1e-6 1 6",
        "duration": "1e-6 1e-3 3", "every": "100", "file": "a.csv", "spectra": "b.csv", "stats_start": "0"}
REGION = "region r block 0 0.01 0 0.01 0 0.01 units box\n"
WALL = "fix w all wall/gran model hertz tangential history primitive type 1 zplane 0\n"


def line(**entries):
    return "fix k all collision/stats " + " ".join(f"{k} {v}" for k, v in {**GOOD, **entries}.items() if v is not None)


class BadInput(CollisionCase):

    def setUp(self):
        super().setUp()
        self.data([(1, D, 2500.0, (0.005, 0.005, 0.005), (0, 0, 0))], 0.01)

    def side_by_side(self, texts, ranks=0):
        """Results of short scripts, each in a folder of its own: most of their time is MPI's start."""
        def one(item):
            folder = self.new_folder_of(item[0])
            (folder / "in.test").write_text(item[1])
            result = grainjet.run([*grainjet.mpirun(ranks), "liggghts-plugins", "-in", "in.test"], folder)
            result.folder = folder
            return result
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            return list(pool.map(one, enumerate(texts)))

    def new_folder_of(self, n):
        folder = self.folder / f"run{n}"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        shutil.copy(self.folder / "grains.data", folder)
        return folder

    def assertRefused(self, result, *words):
        self.assertFails(result, "Fix collision/stats (ID k)", *words)
        self.assertEqual(result.code, 1, result)                        # no signal
        self.assertEqual(result.output.count("ERROR"), 1, result)
        self.assertNotIn("Setting up", result.output)

    def refuse(self, cases, ranks=0, **options):
        results = self.side_by_side((self.script("run 1", stats=text, **options) for text, _ in cases), ranks)
        for (text, words), result in zip(cases, results):
            with self.subTest(text):
                self.assertRefused(result, *words)

    def test_good(self):
        result, = self.side_by_side([self.script("run 1", stats=REGION + line())])
        self.assertEqual(result.code, 0, result)

    def test_entries(self):
        cases = [("fix k all collision/stats", ("missing keyword contact",)), (line(file=None), ("missing keyword file",)),
                 (line(region="nowhere"), ("no region with ID 'nowhere'",))]
        for entry, value in GOOD.items():
            cases += [(f"{REGION}{line()} {entry} {value}", (f"keyword {entry} is given twice",)),
                      (REGION + line(**{entry: None, entry + "x": value}), (f"unknown keyword '{entry}x'",)),
                      (f"{REGION}{line(**{entry: None})} {entry}", ("missing", entry))]
        self.refuse(cases)

    def test_numbers(self):
        cases = []
        for entry in ("energy", "speed", "force", "duration"):
            cases += [(REGION + line(**{entry: value}), words) for value, words in (
                ("0 1 5", (f"min of {entry} must be > 0",)), ("-1 1 5", (f"min of {entry} must be > 0",)),
                ("1e-3 1e-3 5", (f"{entry}: min must be below max",)), ("1e-3 1e-4 5", (f"{entry}: min must be below max",)),
                ("1e-3 1 0", (f"number of bins of {entry} must be a whole number",)),
                ("1e-3 1 2.5", (f"number of bins of {entry}",)), ("1e-3 1 100000", (f"number of bins of {entry}",)),
                ("1e-3 nan 5", ("'nan' is not a number", entry)), ("1e-3 inf 5", (f"max of {entry}",)),
                ("1e-3 1e 5", ("'1e' is not a number", entry)), ("1e-3 1", ("is not a number", f"number of bins of {entry}")))]
        cases += [(REGION + line(bins=value), words) for value, words in (
            ("r 0 1 2", ("axis of bins must be x, y or z, not 'r'",)), ("x 0 0 2", ("bins: low must be below high",)),
            ("x 1 0 2", ("bins: low must be below high",)), ("x 0 1 0", ("number of bins",)), ("x 0 1 1e9", ("number of bins",)),
            ("x 0 nan 2", ("'nan' is not a number",)))]
        cases += [(REGION + line(every=value), ("every must be a whole number",)) for value in ("0", "-5", "1.5", "1e10")]
        cases += [(REGION + line(stats_start=value), ("stats_start must be >= 0",)) for value in ("-1", "inf")]
        cases += [(REGION + line(bins="x 0 1 10000", energy="1e-9 1 10000", speed="1e-9 1 10000"), ("more than 400 MB", "fewer"))]
        self.refuse(cases)

    def test_contacts(self):
        self.refuse([(line(contact="nobody"), ("contact: no fix with ID 'nobody'",)),
                     (WALL + line(contact="w"), ("contact: fix 'w' has style wall/gran", "hertz/cg")),
                     (line(contact="i", region=None), ("contact: fix 'i' has style nve/sphere",))])
        self.refuse([(line(region=None), ("contact: no fix with ID 'c'",))],
                    contact="pair_style gran model hertz tangential history\npair_coeff * *")
        # gone between two runs, and there again
        gone, again = self.side_by_side(self.script(body, stats=line(region=None)) for body in (
            "run 1\nunfix c\nvariable a equal f_k[2]\nprint \"now $a\"\nrun 1", "run 1\nunfix c\nfix c all hertz/cg\nrun 1"))
        self.assertFails(gone, "Fix collision/stats (ID k): contact: no fix with ID 'c'")
        self.assertIn("now 0", gone.output)
        self.assertEqual(gone.output.count("ERROR"), 1)
        self.assertEqual(again.code, 0, again)

    def test_mesh_tet(self):
        """On two ranks refused as a region and as a member, not where it is a region of something else."""
        tet = "region t mesh/tet file tet.vtk scale 1. move 0. 0. 0. rotate 0. 0. 0. units box\nregion s sphere 0 0 0 0.001 units box\n"
        path = self.folder / "tet.vtk"
        path.write_text("# vtk DataFile Version 2.0\none tetrahedron\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0\n0.01 0 0\n"
                        "0 0.01 0\n0 0 0.01\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n")
        tet = REGION + tet.replace("tet.vtk", str(path))
        words = ("'t' is of style mesh/tet", "one rank")
        self.refuse([(tet + line(region="t"), words), (tet + "region u union 2 t s\n" + line(region="u"), words),
                     (tet + "region u union 2 t s\nregion v intersect 2 r u\n" + line(region="v"), words)], ranks=2)
        result, = self.side_by_side([self.script("run 1", stats=tet + "region u union 2 r s\n" + line(region="u"))], ranks=2)
        self.assertEqual(result.code, 0, result)

    def test_units(self):
        self.refuse([(line(region=None), ("requires units si, not cgs",))], units="cgs")

    def test_two_fixes(self):
        """On one fix hertz/cg: fine, with files of their own; the first may go again."""
        first = "fix j all collision/stats contact c file {}\n"
        good, *bad = self.side_by_side(self.script("run 1\nunfix j\nrun 1\nunfix k\nrun 1", stats=stats) for stats in (
            first.format("other.csv") + line(region=None), first.format("a.csv") + line(region=None),
            first.format("./b.csv") + line(region=None), "dump d all custom 1 a.csv id\n" + first.format("o.csv") + line(region=None)))
        self.assertEqual(good.code, 0, good)
        for result, words in zip(bad, (("'a.csv'", "(ID j)"), ("'b.csv'", "(ID j)"), ("'a.csv'", "dump d"))):
            self.assertRefused(result, *words)

    def test_files(self):
        (self.folder / "taken.csv").write_text("somebody's\n")
        os.symlink("nothing", self.folder / "link.csv")
        full = str(self.folder)
        self.refuse([(line(region=None, file=f"{full}/taken.csv"), ("taken.csv' exists and was not written by fix collision/stats",)),
                     (line(region=None, spectra=f"{full}/taken.csv"), ("taken.csv' exists and was not written by",)),
                     (line(region=None, file=f"{full}/link.csv"), ("link.csv' is a symbolic link",)),
                     (line(region=None, file="no/such/folder.csv"), ("cannot write file 'no/such/folder.csv",)),
                     (line(region=None, spectra="."), ("'.' is a directory",)),
                     (line(region=None, spectra="a.csv"), ("'file' and 'spectra' must be two",)),
                     (line(region=None, file="log.liggghts"), ("log.liggghts' is in use by this run",))])
        self.assertEqual((self.folder / "taken.csv").read_text(), "somebody's\n")
        # its own are replaced
        for _ in range(2):
            result = self.liggghts(self.script("run 1", stats=line(region=None)), check=False)
            self.assertEqual(result.code, 0, result)

    def test_on_all_ranks(self):
        """One message, no hang, also for what only the first rank sees."""
        self.refuse([(line(region="nowhere"), ("no region",)), (line(contact="nobody"), ("no fix",)),
                     (line(region=None, file="no/such/folder.csv"), ("cannot write file",)),
                     (line(energy="2 1 5"), ("min must be below max",))], ranks=2)


if __name__ == "__main__":
    unittest.main()
