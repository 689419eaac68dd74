# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix surface/stats: entries missing, misspelt, twice or out of range; meshes and walls that it cannot work with;
files that are not its own. One error on every rank, before any step."""
# processors: 2
# label: long

import concurrent.futures
import os
import unittest

import grainjet
from grainjet import scripts
from surface_case import D, STATS, SurfaceCase, sheet, wall

LINE = "fix s all surface/stats mesh m wall w file table.csv"
TWO = (("m", "m.stl"), ("other", "other.stl"))
PLANE = "fix w all wall/gran model hertz tangential history primitive type 1 zplane 0.0 store_force yes"


class SurfaceBadInput(SurfaceCase):

    def setUp(self):
        super().setUp()
        self.data([(0.0012, 0.0005, D, 0, 0, -2.0)])
        self.mesh(sheet())
        self.mesh(scripts.rectangle((0.005, -0.006, 0), (0.005, 0.006, 0), (0.005, 0.006, 0.005), (0.005, -0.006, 0.005)),
                  "other.stl")

    def assertRefused(self, result, *words):
        self.assertFails(result, "Fix surface/stats (ID s)", *words)
        self.assertEqual(result.code, 1, result)                        # no signal
        self.assertEqual(result.output.count("ERROR"), 1, result)
        self.assertNotIn("Setting up", result.output)

    def refused(self, body, *words, ranks=0, **settings):
        self.assertRefused(self.liggghts(self.script(f"{body}\nrun 1", **settings), ranks, check=False), *words)

    def test_lines(self):
        """Each of these lines, and the words of its error."""
        lines = [
            ("fix s all surface/stats", ("missing keyword mesh",)),
            (LINE.replace("mesh m", ""), ("missing keyword mesh",)),
            (LINE.replace("wall w", ""), ("missing keyword wall",)),
            (LINE.replace("file table.csv", ""), ("missing keyword file",)),
            (f"{LINE} mesh", ("missing ID of a fix mesh/surface after 'mesh'",)),
            (f"{LINE} mesh m", ("mesh 'm' is given twice",)),
            (f"{LINE} mesh nowhere", ("mesh 'nowhere'", "is not the ID of a fix mesh/surface")),
            (f"{LINE} mesh g", ("mesh 'g' is a fix gravity",)),
            (LINE.replace("wall w", "wall nowhere"), ("wall 'nowhere'", "fix wall/gran")),
            (LINE.replace("wall w", "wall g"), ("wall 'g'", "fix wall/gran")),
            (f"{LINE} wall w", ("'wall' is given twice",)),
            (f"{LINE} walls w", ("unknown keyword 'walls'", "valid keywords are mesh, wall")),
            (f"{LINE} every 0", ("every must be a whole number",)),
            (f"{LINE} every 2.5", ("every must be a whole number",)),
            (f"{LINE} stats_start -1", ("stats_start must be >= 0",)),
            (f"{LINE} wear", ("law of wear", "finnie, oka, dnv, ecrc, archard")),
            (f"{LINE} wear rust", ("unknown law of wear 'rust'", "finnie, oka, dnv, ecrc, archard")),
            (f"{LINE} wear archard K 1e-4", ("wear archard", "'hardness' missing")),
            (f"{LINE} wear archard K 1e-4 hardness", ("wear archard", "'hardness' has no value")),
            (f"{LINE} wear archard K nan hardness 1e9", ("wear archard", "'K' must be a number")),
            (f"{LINE} wear archard hardness 1e9 K 1e-4 hardnes 1e9", ("wear archard has no coefficient 'hardnes'", "it has K (")),
            (f"{LINE} wear finnie k 1e-9 wear finnie k 1e-9", ("'wear' is given twice",)),
            (f"{LINE} vtk map.stl", ("must end with .vtp or .vtk",)),
            (f"{LINE} vtk maps*/a.vtp", ("may have one *, in the name",)),
            (f"{LINE} vtk a*b*.vtp", ("may have one *",)),
            (f"{LINE} energy 1e-9 1 10", ("give spectra <path>",)),
            (f"{LINE} spectra s.csv energy 1 1 10", ("must be above the lowest",)),
            (f"{LINE} spectra s.csv energy 0 1 10", ("lowest value after 'energy' must be > 0",)),
            (f"{LINE} spectra s.csv speed 1 10 0", ("number of bins after 'speed'",)),
            (f"{LINE} spectra s.csv speed 1 10", ("missing", "number of bins")),
        ]

        def one(number, line):
            folder = self.folder / str(number)
            folder.mkdir()
            for name in ("grains.data", "m.stl", "other.stl"):
                os.link(self.folder / name, folder / name)
            (folder / "in.test").write_text(self.script(f"{line}\nrun 1"))
            return grainjet.run(["liggghts-plugins", "-in", "in.test"], folder)

        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            results = list(pool.map(one, range(len(lines)), [line for line, _ in lines]))
        for (line, words), result in zip(lines, results):
            with self.subTest(line):
                self.assertRefused(result, *words)

    def test_walls_and_meshes(self):
        for ranks in (0, 2):
            self.refused(LINE, "needs the keywords store_force yes", ranks=ranks, wall=wall(options=""))
            self.refused(LINE, "wall 'w' is primitive and has no meshes", ranks=ranks,
                         wall="fix m all mesh/surface file m.stl type 1\n" + PLANE)
            self.refused(LINE.replace("mesh m", "mesh other"), "mesh 'other' is none of wall 'w', whose meshes are m",
                         ranks=ranks, wall=wall() + "\nfix other all mesh/surface file other.stl type 1")
            self.refused(LINE, "requires units si, not cgs", ranks=ranks, units="cgs")
            self.refused(LINE + "\ntimestep 0", "timestep > 0", ranks=ranks)
        # the wall goes away, and the mesh comes back as another one
        self.liggghts(self.script(f"{LINE}\nrun 1\nunfix s\nunfix w\nunfix m\nrun 1"))
        result = self.liggghts(self.script(
            f"{LINE}\nrun 1\nunfix w\nunfix m\n{wall(('m', 'other.stl'))}\nrun 1"), 2, check=False)
        self.assertFails(result, "Fix surface/stats (ID s)", "mesh 'm' has 2 triangles, but 32 when the fix was defined")

    def test_restart_of_another_mesh(self):
        self.liggghts(self.script(f"{STATS}\nrun 100\nwrite_restart r.restart", wall=wall(*TWO)))
        for line, words in ((STATS.replace("mesh m", "mesh other"), "other meshes"),
                            (STATS.replace("mesh m", "mesh m mesh other"), "other meshes, or in another order (m)")):
            self.refused(line, words, "another fix ID", read="read_restart r.restart", wall=wall(*TWO), ranks=2)
        self.refused(f"group one id 1\n{STATS.replace('fix s all', 'fix s one')}", "another group ('all')", "another fix ID",
                     read="read_restart r.restart", wall=wall(*TWO), ranks=2)

    def test_files(self):
        """What is not its own is never overwritten, and no two outputs share a file."""
        kept = self.folder / "keep"
        kept.write_text("what somebody has measured\n")
        (self.folder / "keep.vtp").write_text("<?xml version=\"1.0\"?>\n<VTKFile/>\n")
        (self.folder / "series.pvd").write_text("<VTKFile/>\n")
        for text in (LINE.replace("table.csv", "keep"), f"{LINE} events keep", f"{LINE} spectra keep", f"{LINE} vtk keep.vtp",
                     f"{LINE} vtk series_*.vtp"):
            self.refused(text, "not overwritten")
        for text in (LINE.replace("table.csv", "no/such/table.csv"), f"{LINE} events no/such/e.csv",
                     f"{LINE} spectra no/such/s.csv", f"{LINE} vtk no/such/m.vtp", f"{LINE} vtk no/such/m*.vtp"):
            self.refused(text, "no/such", "No such file", ranks=2)
        for text in (f"{LINE} events table.csv", f"{LINE} spectra ./table.csv", f"{LINE} events t.vtp vtk t.vtp",
                     f"{LINE} events table.csv.new", f"{LINE} vtk a_*.vtp events a.pvd"):
            self.refused(text, "are one file")
        self.assertEqual(kept.read_text(), "what somebody has measured\n")
        both = "plugin load surfacestatsplugin.so\nplugin load platestatsplugin.so"
        plate = "fix p all plate/stats wall w centre 0 0 0 normal 0 0 1 radius 0.005 rings 1 file table.csv"
        self.refused(f"{plate}\n{LINE}", "'table.csv' is that of fix plate/stats (ID p)", plugins=both, ranks=2)
        self.refused(f"{LINE.replace('fix s ', 'fix r ').replace('table', 'a')} vtk m_*.vtp\n{LINE} vtk m_*.vtp",
                     "is that of fix surface/stats (ID r)")
        # a star stands for any step, in either name
        other = LINE.replace("fix s ", "fix r ").replace("table", "a")
        for first, second in (("m_*.vtp", "m_500.vtp"), ("m_500.vtp", "m_*.vtp"), ("m_1*.vtp", "m_*0.vtp")):
            self.refused(f"{other} vtk {first}\n{LINE} vtk {second}",
                         f"'{second}' is that of fix surface/stats (ID r), which writes '{first}'")
        self.refused(f"{LINE} vtk m_*.vtp events m_20.vtp", "are one file")
        for first, second in (("m_*.vtp", "m_a.vtp"), ("m_*.vtp", "m_.vtp"), ("m_*.vtp", "m*_5.vtp")):
            self.liggghts(self.script(f"{other} vtk {first}\n{LINE} vtk {second}\nrun 0"))
        # fix collision/stats, before and after
        more = {"pair": "fix c all hertz/cg", "plugins": "\n".join(
            f"plugin load {name}plugin.so" for name in ("surfacestats", "hertzcg", "collisionstats"))}
        between = "fix k all collision/stats contact c file table.csv spectra sp.csv"
        (self.folder / "table.csv").unlink()
        self.refused(f"{between}\n{LINE}", "'table.csv' is that of fix collision/stats (ID k)", ranks=2, **more)
        self.refused(f"{between.replace('table', 'k')}\n{LINE} spectra sp.csv", "'sp.csv' is that of fix collision/stats (ID k)", **more)
        for line, words in ((between, "'table.csv' is that of fix surface/stats (ID s)"),
                            (between.replace("table.csv", "k.csv").replace("sp.csv", "m_7.vtp"),
                             "'m_7.vtp' is that of fix surface/stats (ID s), which writes 'm_*.vtp'")):
            result = self.liggghts(self.script(f"{LINE} vtk m_*.vtp\n{line}\nrun 1", **more), 2, check=False)
            self.assertFails(result, "Fix collision/stats (ID k)", words)
            self.assertNotIn("Setting up", result.output)
        # its own files are replaced
        for _ in range(2):
            self.liggghts(self.script(f"{STATS.replace('map.vtp', 'map*.vtp')}\nrun 1000"))
        self.assertEqual(self.table()["all"]["collisions"], 1)


if __name__ == "__main__":
    unittest.main()
