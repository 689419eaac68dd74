# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""Folders and files of any name: of the installation, of plugins, of the working folder."""

import unittest

import grainjet
from loadercase import USE, LoaderCase, counts

# what shells, lists of folders, the dynamic linker and LIGGGHTS' own parser treat in some way
NAMES = ["two words", "a:b", "$LIB", "a $ORIGIN b", "it's", 'q"q', "Größe", "a&b", "a#b", "a(b)", "a;b", "a*b",
         "-in", "back\\slash", "tab\tb", "`id`", "%s%n", "50%"]


class Names(LoaderCase):

    def test_installation_and_working_folder(self):
        for name in NAMES:
            with self.subTest(name):
                for source in ("bin/liggghts-plugins", "lib/liggghtsloader.so"):
                    target = self.folder / name / source
                    target.parent.mkdir(parents=True)
                    target.write_bytes((grainjet.ROOT / source).read_bytes())
                    target.chmod(0o755)
                path = self.plugin(folder=f"{name}/lib")
                (self.folder / name / "in.test").write_text(
                    "plugin load exampleplugin.so" + USE + 'shell sh script\n')
                (self.folder / name / "script").write_text('echo "preload <$LD_PRELOAD>"\n')
                result = grainjet.run([self.folder / name / "bin/liggghts-plugins", "-in", "in.test"],
                                      self.folder / name, env={"LIGGGHTS_PLUGIN_PATH": ""})
                self.assertEqual(result.code, 0, result)
                self.assertIn(str(path), result.output)
                self.assertIn("preload <>", result.output)
                self.assertEqual(counts(result.output), [(0, 3), (5, 8)])

    def test_on_two_ranks(self):
        name = "a $LIB: b"
        for source in ("bin/liggghts-plugins", "lib/liggghtsloader.so"):
            target = self.folder / name / source
            target.parent.mkdir(parents=True)
            target.write_bytes((grainjet.ROOT / source).read_bytes())
            target.chmod(0o755)
        self.plugin(folder=f"{name}/lib")
        (self.folder / "in.test").write_text("plugin load exampleplugin.so" + USE)
        result = grainjet.run([*grainjet.mpirun(2), self.folder / name / "bin/liggghts-plugins", "-in", "in.test"],
                              self.folder, env={"LIGGGHTS_PLUGIN_PATH": ""})
        self.assertEqual(result.code, 0, result)
        self.assertEqual(counts(result.output), [(0, 3), (5, 8)])

    def test_plugin_named_in_the_script_and_in_the_search_path(self):
        """Quoted, as the page says; of the two kinds of quotes one must be left to quote with."""
        for name in NAMES:
            with self.subTest(name):
                named, found = self.plugin("commandplugin.so", folder=name), self.plugin(folder=f"path/{name}")
                quote = "'" if '"' in name else '"'
                (self.folder / "in.test").write_text(
                    f"plugin load {quote}{name}/commandplugin.so{quote}\nplugin_say hello\n"
                    + ("" if ":" in name else "plugin load exampleplugin.so" + USE))
                result = grainjet.run(["liggghts-plugins", "-in", "in.test"], self.folder,
                                      env={"LIGGGHTS_PLUGIN_PATH": f"/nowhere:{found.parent}"})
                self.assertEqual(result.code, 0, result)
                self.assertIn(f"Plugin style command plugin_say from {named}", result.output)
                self.assertIn("The plugin says: hello", result.output)
                if ":" not in name:
                    self.assertIn(f"Plugin style fix plugin/example from {found}", result.output)
                    self.assertEqual(counts(result.output), [(0, 3), (5, 8)])

    def test_several_files_with_the_linkers_words_in_their_names(self):
        """The linker remembers names, so each needs one of its own."""
        one, two = self.plugin(folder="$LIB"), self.plugin("commandplugin.so", folder="$LIB")
        result = self.liggghts('plugin load "$LIB/exampleplugin.so"\nplugin load "$LIB/commandplugin.so"\n'
                               'plugin_say hello\n')
        for path in (one, two):
            self.assertIn(str(path), result.output)
        self.assertIn("The plugin says: hello", result.output)


class ScriptsOfOtherSystems(LoaderCase):

    TEXT = "plugin load exampleplugin.so" + USE

    def run_bytes(self, contents):
        """Runs of a script: serial, 2 ranks, standard input."""
        (self.folder / "in.test").write_bytes(contents)
        yield grainjet.run(["liggghts-plugins", "-in", "in.test"], self.folder)
        yield grainjet.run([*grainjet.mpirun(2), "liggghts-plugins", "-in", "in.test"], self.folder)
        yield grainjet.run(["bash", "-c", "cat in.test | liggghts-plugins"], self.folder)

    def test_they_run(self):
        self.plugin()
        for contents in (b"\xef\xbb\xbf" + self.TEXT.encode(), self.TEXT.replace("\n", "\r\n").encode(),
                         b"\xef\xbb\xbf# a comment\r\n" + self.TEXT.replace("\n", "\r\n").encode(),
                         b"\xef\xbb\xbf" + self.TEXT.rstrip("\n").encode()):
            for result in self.run_bytes(contents):
                self.assertEqual(result.code, 0, result)
                self.assertEqual(counts(result.output), [(0, 3), (5, 8)])

    def refused(self, result, *words):
        self.assertEqual(result.code, 1, result)
        self.assertFails(result, *words)
        self.assertEqual(result.output.count("ERROR"), 1, result)

    def test_wide_characters(self):
        for encoding in ("utf-16", "utf-16-be", "utf-16-le", "utf-32"):
            for result in self.run_bytes(self.TEXT.encode(encoding)):
                self.assertEqual(result.code, 1, f"{encoding}: {result}")
            (self.folder / "in.test").write_bytes(self.TEXT.encode(encoding))
            self.refused(grainjet.run(["liggghts-plugins", "-in", "in.test"], self.folder), "not plain text", "UTF-8")

    def test_lines_that_end_in_cr(self):
        self.plugin()
        (self.folder / "in.test").write_bytes(("# a comment\n" + self.TEXT).replace("\n", "\r").encode())
        for ranks in (0, 2):
            self.refused(grainjet.run([*grainjet.mpirun(ranks), "liggghts-plugins", "-in", "in.test"], self.folder),
                         "CR alone", "LF")

    def test_a_folder_as_script(self):
        (self.folder / "scripts").mkdir()
        for ranks in (0, 2):
            self.refused(grainjet.run([*grainjet.mpirun(ranks), "liggghts-plugins", "-in", "scripts"], self.folder),
                         "cannot be read", "-in")


class Messages(LoaderCase):

    def test_error_of_one_rank_is_not_lost_in_a_pipe(self):
        """LIGGGHTS ends all ranks at once then, with its screen's buffer unwritten."""
        result = self.liggghts("variable x equal 1\nread_restart nosuchfile\n", check=False)
        self.assertFails(result, "Cannot open restart file nosuchfile")
        result = grainjet.run(["liggghts-plugins", "-in", "in.missing"], self.folder)
        self.assertFails(result, "Cannot open input script in.missing")


if __name__ == "__main__":
    unittest.main()
