# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of LIGGGHTS reach the user with the script, its line and the name of the log; bad script and log
files are refused before LIGGGHTS starts. Exit code 1, never a signal."""
# processors: 2
# label: long

import shutil
import unittest

import bad_case
from grainjet import coupled_box as box


class ScriptErrors(bad_case.BadCase):

    def refused(self, *words, ranks=(0,), files=None, options=None, **script):
        for n in ranks:
            folder = self.fresh()
            box.script(folder, **{"grains": bad_case.GRAIN, "boundary": "f f f", **script})
            box.fv_options(folder, **(options or {}))
            for path, content in (files or {}).items():
                (folder / path).write_bytes(content)
            with self.subTest(words=words, ranks=n):
                self.assertRefused(folder, *words, ranks=n)

    # where the script is wrong

    def test_line_of_a_command(self):
        folder = self.fresh()
        box.script(folder, grains=bad_case.GRAIN, boundary="f f f", end="# above\ntimestep abc")
        lines = (folder / "constant/in.particles").read_text().splitlines()
        number = lines.index("timestep abc") + 1
        for ranks in (0, 2):
            self.assertRefused(folder, "LIGGGHTS stopped", f"script constant/in.particles, line {number}: timestep abc",
                               "log of LIGGGHTS log.liggghts", ranks=ranks)

    def test_included_file(self):
        self.refused("constant/more, line 2: nonsense 1", end="include constant/more",
                     files={"constant/more": b"# first\nnonsense 1\n"})

    def test_name_of_the_log(self):
        self.refused("log of LIGGGHTS log.other", end="nonsense", options={"log": '"log.other"'})

    def test_label_and_variable(self):
        self.refused("Label wasn't found", "jump looks for: nowhere", end="jump SELF nowhere", ranks=(0, 2))
        self.refused("line", "print ${nosuch}", "constant/in.particles", end="print ${nosuch}")

    def test_quit(self):
        self.refused("quit", "constant/in.particles", "line", end="quit", ranks=(0, 2))

    def test_geometry_files(self):
        mesh = "fix m all mesh/surface file constant/wall.stl type 1"
        for content in (b"", b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0.01"):
            self.refused("LIGGGHTS stopped", "constant/wall.stl", "constant/in.particles", fixes=mesh,
                         files={"constant/wall.stl": content})
        self.refused("LIGGGHTS stopped", "constant/none.stl", "line", fixes=mesh.replace("wall", "none"))

    def test_plugin_cut_short(self):
        self.refused("constant/cut.so", "line", plugins="plugin load constant/cut.so",
                     files={"constant/cut.so": b"\x7fELF\x02\x01\x01" + 100 * b"\0"})

    # its text

    def test_encoding(self):
        folder = self.fresh()
        good = (folder / "constant/in.particles").read_bytes()
        file = folder / "constant/in.particles"
        for content, words in (
                (b"\xef\xbb\xbf" + good, ["byte order mark"]),
                (good.decode().encode("utf-16"), ["not a text file"]),
                (good.replace(b"\n", b"\r"), ["carriage returns"]),
                (b"", ["is empty"]), (b" \n\n", ["is empty"]),
                (b"# nothing\n", ["no simulation box"]),
                (good.replace(b"units si", b"units\xc2\xa0si"), ["not plain ASCII", "line"])):
            with self.subTest(words=words):
                file.write_bytes(content)
                self.assertRefused(folder, "constant/in.particles", *words)
        # line ends of Windows do no harm
        file.write_bytes(good.replace(b"\n", b"\r\n"))
        self.assertRuns(folder)

    def test_byte_order_mark_in_an_included_file(self):
        self.refused("constant/more, line 1", "byte order mark", end="include constant/more",
                     files={"constant/more": b"\xef\xbb\xbfthermo 10\n"})

    # its time step

    def test_time_step(self):
        for value in ("0", "-1e-5", "1e300", "1e-300"):
            self.refused("timestep", "constant/in.particles", dt=value, ranks=(0, 2) if value == "0" else (0,))
        self.refused("timestep", "constant/in.particles", "line", dt="nan")
        self.refused("timestep", "line", dt="")

    def test_no_time_step(self):
        folder = self.fresh()
        self.change(folder, "constant/in.particles", ("timestep 1e-05", ""))
        self.assertRefused(folder, "timestep", "constant/in.particles", "couplingInterval")

    def test_time_step_zero_with_an_insertion(self):
        """Its fixes divide by the step before the check comes."""
        self.refused("timestep", "constant/in.particles", dt="0", fixes="""
            fix pts all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 1e-4
            fix pdd all particledistribution/discrete 32452843 1 pts 1
            region in block 0.002 0.018 0.002 0.018 0.002 0.038 units box
            fix ins all insert/rate/region seed 49979687 distributiontemplate pdd nparticles 10 particlerate 1000 &
                insert_every 10 overlapcheck yes region in""")

    # its numbers

    def test_numbers_that_no_grain_has(self):
        for what in ({"density": 1e-300}, {"density": 1e300}, {"diameter": 1e-300}, {"diameter": 1e300}):
            # by the coupling or, with a force that is no number, by fix fluid/force
            self.refused("constant/in.particles", "grain 1", "radius",
                         grains=box.grains([(0.01, 0.01, 0.01)], [(0, 0, 1)], **what))
        self.refused("constant/in.particles", "grain 2", "speed", ranks=(0, 2),
                     grains=box.grains([(0.01, 0.01, 0.01), (0.01, 0.01, 0.03)], [(0, 0, 1), (0, 0, 1e300)]))
        self.refused("constant/in.particles", "gravity", gravity="fix g all gravity 1e300 vector 0 0 -1")

    # the log

    def test_log(self):
        for ranks in (0, 2):
            self.refused("log", "nodir/log", "folder that does not exist", "constant/fvOptions", ranks=(ranks,),
                         options={"log": '"nodir/log"'})
        self.refused("log", "constant", "is a folder", "constant/fvOptions", options={"log": '"constant"'})

    def test_log_never_overwrites_input(self):
        for name in ("constant/in.particles", "system/controlDict", "constant/mine"):
            folder = self.fresh()
            (folder / "constant/mine").write_text("my results\n")
            before = (folder / name).read_text()
            box.fv_options(folder, log=f'"{name}"')
            self.assertRefused(folder, "log", name, "not a log of LIGGGHTS", "constant/fvOptions")
            self.assertEqual((folder / name).read_text(), before)

    def test_log_of_a_former_run_is_overwritten(self):
        folder = self.fresh()
        self.assertRuns(folder)
        self.assertTrue((folder / "log.liggghts").stat().st_size > 0)
        self.assertRuns(folder)
        box.fv_options(folder, log="none")
        (folder / "log.liggghts").unlink()
        self.assertRuns(folder)
        self.assertFalse((folder / "log.liggghts").exists())

    # the case's path

    def test_unusual_paths(self):
        """Characters that OpenFOAM lets pass, but that mean something in a script of LIGGGHTS."""
        for name in ("a$b", "${x}", "a#b", "a&b", "a(b)", "ä", "a%b", "a*b", "a;b", "a\\b"):
            with self.subTest(name=name):
                folder = self.folder / "path" / name
                shutil.copytree(self.base, folder)
                self.change(folder, "system/controlDict", ("writeInterval 100", "writeInterval 1"))
                self.assertRuns(folder)
                self.assertTrue((folder / "0.0002/uniform/liggghts.restart").exists())


if __name__ == "__main__":
    unittest.main()
