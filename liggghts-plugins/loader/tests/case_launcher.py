# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""The launcher is the stock program: input, exit code, environment; and the loader's own guards."""

import shutil
import unittest

import grainjet
from loadercase import PLUGINS, USE, LoaderCase, counts

LOADER = grainjet.ROOT / "lib/liggghtsloader.so"
LOAD_AND_USE = "plugin load exampleplugin.so" + USE


class Launcher(LoaderCase):

    def test_script_from_standard_input(self):
        self.plugin()
        (self.folder / "in.test").write_text(LOAD_AND_USE)
        for ranks in (0, 2):
            command = " ".join([*grainjet.mpirun(ranks), "liggghts-plugins < in.test"])
            result = grainjet.run(["bash", "-c", command], self.folder)
            self.assertEqual(result.code, 0, result)
            self.assertEqual(counts(result.output), [(0, 3), (5, 8)])

    def test_arguments_and_exit_code_pass_through(self):
        script = 'print "value ${v}"\n'
        result = self.liggghts(script, args=["-log", "log.other", "-var", "v", "with blank"])
        self.assertIn("value with blank", result.output)
        self.assertTrue((self.folder / "log.other").exists())
        failed = self.liggghts("nosuchcommand\n", check=False)
        self.assertEqual(failed.code, 1, failed)
        self.assertIn("Unknown command: nosuchcommand", failed.output)

    def test_through_a_link_in_another_folder(self):
        self.plugin()
        (self.folder / "in.test").write_text(LOAD_AND_USE)
        (self.folder / "link").symlink_to(grainjet.ROOT / "bin/liggghts-plugins")
        result = grainjet.run(["./link", "-in", "in.test"], self.folder)
        self.assertEqual(counts(result.output), [(0, 3), (5, 8)])

    def test_programs_started_by_liggghts_run_without_the_loader(self):
        for ranks in (0, 2):
            for given in ("", "libm.so.6", "libm.so.6:libdl.so.2"):
                (self.folder / "in.test").write_text("shell sh script\n")
                (self.folder / "script").write_text('echo "$LD_PRELOAD" > preload\n')
                result = grainjet.run([*grainjet.mpirun(ranks), "liggghts-plugins", "-in", "in.test"],
                                      self.folder, env={"LD_PRELOAD": given})
                self.assertEqual(result.code, 0, result)
                self.assertEqual((self.folder / "preload").read_text().strip(), given)

    def test_liggghts_as_a_wrapper_script(self):
        self.plugin()
        (self.folder / "in.test").write_text(LOAD_AND_USE + "shell sh script\n")
        (self.folder / "script").write_text('echo "preload <$LD_PRELOAD>"\n')
        stock = shutil.which("liggghts", path=grainjet.ENV["PATH"])
        wrapper = self.folder / "tools/liggghts"
        wrapper.parent.mkdir()
        wrapper.write_text('#!/bin/sh\necho "wrapped"\nexec ' + stock + ' "$@"\n')
        wrapper.chmod(0o755)
        result = grainjet.run(["liggghts-plugins", "-in", "in.test"], self.folder,
                              env={"PATH": f"{wrapper.parent}:{grainjet.ENV['PATH']}"})
        self.assertEqual(counts(result.output), [(0, 3), (5, 8)], result)
        self.assertIn("wrapped", result.output)
        self.assertIn("preload <>", result.output)

    def test_missing_loader_and_missing_liggghts(self):
        lonely = self.folder / "bin/liggghts-plugins"
        lonely.parent.mkdir()
        lonely.write_bytes((grainjet.ROOT / "bin/liggghts-plugins").read_bytes())
        lonely.chmod(0o755)
        result = grainjet.run([lonely], self.folder)
        self.assertFails(result, "liggghtsloader.so is missing", "Allwmake")

        tools = self.folder / "tools"
        tools.mkdir()
        for name in ("sh", "dirname", "readlink"):
            (tools / name).symlink_to(f"/usr/bin/{name}")
        result = grainjet.run([grainjet.ROOT / "bin/liggghts-plugins"], self.folder, env={"PATH": str(tools)})
        self.assertFails(result, "no program liggghts in PATH")

    def test_mpirun_of_another_MPI(self):
        """It would start the same run several times. Seen by the variable of MPICH's, where LIGGGHTS knows of one rank."""
        (self.folder / "in.test").write_text("plugin list\n")
        for ranks, size, fault in ((0, "2", True), (0, "1", False), (0, "", False), (2, "2", False)):
            result = grainjet.run([*grainjet.mpirun(ranks), "env", f"PMI_SIZE={size}", "liggghts-plugins", "-in", "in.test"], self.folder)
            with self.subTest(ranks=ranks, size=size):
                if fault:
                    self.assertFails(result, "mpirun of another MPI has started 2 ranks", "uses Open MPI", "unset PMI_SIZE")
                    self.assertEqual(result.output.count("ERROR"), 1, result)
                else:
                    self.assertEqual(result.code, 0, result)


class Guards(LoaderCase):

    def test_loader_for_another_version(self):
        (self.folder / "in.test").write_text("plugin list\n")
        for ranks in (0, 2):
            result = grainjet.run(
                [*grainjet.mpirun(ranks), "env", f"LD_PRELOAD={PLUGINS}/wronghostloader.so", "liggghts", "-in", "in.test"],
                self.folder)
            self.assertFails(result, "loader was built for LIGGGHTS-PUBLIC 2.0.0", "Build it again")
            self.assertEqual(result.output.count("ERROR"), 1, result)

    def coupled(self, ranks, **env):
        """A program that opens a coupling library, which holds the loader as well."""
        self.plugin()
        (self.folder / "in.test").write_text(LOAD_AND_USE + "clear\n" + USE + "plugin list\n")
        assignments = [f"{name}={value}" for name, value in env.items()]
        result = grainjet.run([*grainjet.mpirun(ranks), "env", *assignments, PLUGINS / "couplingprogram",
                               PLUGINS / "couplinglibrary.so", "in.test"], self.folder)
        self.assertEqual(result.code, 0, result)
        self.assertEqual(counts(result.output), 2 * [(0, 3), (5, 8)])
        self.assertEqual(result.output.count("Plugin style"), 1, result)
        self.assertEqual(result.output.count("fix plugin/example:"), 1, result)

    def test_inside_a_coupling_library(self):
        for ranks in (0, 2):
            self.coupled(ranks)

    def test_inside_a_coupling_library_and_preloaded(self):
        for ranks in (0, 2):
            self.coupled(ranks, LD_PRELOAD=LOADER)


if __name__ == "__main__":
    unittest.main()
