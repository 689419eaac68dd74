# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""Where plugin files are searched, and files that are refused."""

import subprocess
import unittest

import grainjet
from loadercase import PLUGINS, USE, LoaderCase, counts


class Search(LoaderCase):

    LOAD = "plugin load exampleplugin.so\n"

    def loaded(self, script, env=None):
        """The file that a script's first `plugin load` took, the same serial and parallel."""
        (self.folder / "in.test").write_text(script)
        found = set()
        for ranks in (0, 2):
            command = [*grainjet.mpirun(ranks), "liggghts-plugins", "-in", "in.test"]
            result = grainjet.run(command, self.folder, env=env)
            self.assertEqual(result.code, 0, result)
            line, = (line for line in result.output.splitlines() if line.startswith("Plugin style"))
            found.add(line.split(" from ")[1])
        self.assertEqual(len(found), 1, found)
        return found.pop()

    def test_order_of_the_places(self):
        first = self.plugin(folder="first")
        second = self.plugin(folder="second")
        path = {"LIGGGHTS_PLUGIN_PATH": f"/nowhere::{first.parent}:{second.parent}"}
        self.assertEqual(self.loaded(self.LOAD, path), str(first.resolve()))
        first.unlink()
        self.assertEqual(self.loaded(self.LOAD, path), str(second.resolve()))
        here = self.plugin()
        self.assertEqual(self.loaded(self.LOAD, path), str(here.resolve()))

    def test_beside_the_loader(self):
        # a copy of the whole installation, so that nothing is put into the real one
        for source in ("bin/liggghts-plugins", "lib/liggghtsloader.so"):
            target = self.folder / "copy" / source
            target.parent.mkdir(parents=True)
            target.write_bytes((grainjet.ROOT / source).read_bytes())
            target.chmod(0o755)
        beside = self.plugin(folder="copy/lib")
        (self.folder / "in.test").write_text(self.LOAD)
        for ranks in (0, 2):
            result = grainjet.run(
                [*grainjet.mpirun(ranks), self.folder / "copy/bin/liggghts-plugins", "-in", "in.test"],
                self.folder, env={"LIGGGHTS_PLUGIN_PATH": ""})
            self.assertEqual(result.code, 0, result)
            self.assertIn(str(beside.resolve()), result.output)

    def test_a_path_is_taken_as_it_is(self):
        other = self.plugin(folder="other")
        self.plugin()
        self.assertEqual(self.loaded("plugin load other/exampleplugin.so\n"), str(other.resolve()))
        self.assertEqual(self.loaded(f"plugin load {other}\n"), str(other.resolve()))

    def test_a_folder_of_that_name_is_passed_over(self):
        (self.folder / "exampleplugin.so").mkdir()
        other = self.plugin(folder="other")
        found = self.loaded(self.LOAD, {"LIGGGHTS_PLUGIN_PATH": str(other.parent)})
        self.assertEqual(found, str(other.resolve()))

    def test_ranks_with_different_folders_take_the_same_file(self):
        left, right = self.plugin(folder="left"), self.plugin(folder="right")
        script = self.folder / "in.test"
        script.write_text(self.LOAD + USE)
        command = ["liggghts-plugins", "-in", script]
        root = grainjet.mpirun(1)[1:-2]
        result = grainjet.run(
            ["mpirun", *root, "-np", "1", "-wdir", left.parent, *command,
             ":", "-np", "1", "-wdir", right.parent, *command], self.folder)
        self.assertEqual(result.code, 0, result)
        self.assertIn(f"from {left.resolve()}", result.output)
        self.assertEqual(counts(result.output), [(0, 3), (5, 8)])


class Refused(LoaderCase):

    def test_missing_file_names_the_places(self):
        self.assertRefused(
            "plugin load nosuchplugin.so\n",
            "there is no file 'nosuchplugin.so'", f"{self.folder.resolve()} (working folder)",
            f"{grainjet.ROOT}/lib (LIGGGHTS_PLUGIN_PATH)", "add the folder of the file to LIGGGHTS_PLUGIN_PATH")

    def test_missing_path(self):
        self.assertRefused("plugin load ./nosuchplugin.so\n", "there is no file './nosuchplugin.so'",
                           str(self.folder.resolve()), "Check the path")

    def test_text_file(self):
        (self.folder / "exampleplugin.so").write_text(20 * "plugin load me\n")
        self.assertRefused("plugin load exampleplugin.so\n", f"{self.folder.resolve()}/exampleplugin.so",
                           "cannot be loaded", "invalid ELF header", "compiled")

    def test_library_without_entry_point(self):
        path = self.plugin("noentryplugin.so")
        self.assertRefused("plugin load noentryplugin.so\n", str(path.resolve()),
                           "not a LIGGGHTS plugin", "liggghtsplugin_init")

    def test_entry_point_that_tells_nothing(self):
        path = self.plugin("nodescriptionplugin.so")
        self.assertRefused("plugin load nodescriptionplugin.so\n", str(path.resolve()), "not a LIGGGHTS plugin")

    def test_plugin_for_another_version(self):
        path = self.plugin("wronghostplugin.so")
        host = subprocess.run([grainjet.ROOT / "liggghts-plugins/loader/host-version"],
                              check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
        self.assertRefused("plugin load wronghostplugin.so\n", str(path.resolve()),
                           "was built for LIGGGHTS-PUBLIC 2.0.0", f"this is {host}", "Build it again")

    def test_plugin_that_calls_what_the_host_lacks(self):
        path = self.plugin("unresolvedplugin.so")
        self.assertRefused("plugin load unresolvedplugin.so\n", str(path.resolve()),
                           "does not fit this LIGGGHTS", "function_of_another_host")

    def test_style_that_the_host_has(self):
        path = self.plugin("conflictplugin.so")
        self.assertRefused("plugin load conflictplugin.so\n", str(path.resolve()), "fix nve/sphere",
                           "LIGGGHTS itself has already")

    def test_style_of_another_plugin(self):
        one, two = self.plugin(), self.plugin(to="second.so")
        self.assertRefused("plugin load exampleplugin.so\nplugin load second.so\n", str(two.resolve()),
                           "fix plugin/example", str(one.resolve()), "Load only one")

    def test_unknown_kind_of_style(self):
        path = self.plugin("kindplugin.so")
        self.assertRefused("plugin load kindplugin.so\n", str(path.resolve()), "unknown kind 'pair'")

    def test_needed_library_missing_on_one_rank_ends_all(self):
        """One rank that cannot open the file must not leave the other one waiting."""
        path = self.plugin("needslibraryplugin.so")
        script = self.folder / "in.test"
        script.write_text("plugin load needslibraryplugin.so\nplugin list\n")
        command = ["liggghts-plugins", "-in", script]
        whole = ["env", f"LD_LIBRARY_PATH={PLUGINS}", *command]
        root = grainjet.mpirun(1)[1:-2]

        fine = grainjet.run(["mpirun", *root, "-np", "2", *whole], self.folder)
        self.assertEqual(fine.code, 0, fine)
        self.assertIn("fix plugin/example", fine.output)

        for first, second, rank in ((command, whole, 0), (whole, command, 1)):
            result = grainjet.run(
                ["mpirun", *root, "-np", "1", *first, ":", "-np", "1", *second], self.folder)
            self.assertFails(result, str(path.resolve()), "libneededlibrary.so", f"(on rank {rank})")
            self.assertNotIn("Loaded plugins", result.output)
            self.assertEqual(result.output.count("ERROR"), 1, result)


if __name__ == "__main__":
    unittest.main()
