# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The `plugin` command in stock LIGGGHTS: load, list, clear, and what it survives."""

import unittest

import grainjet
from grainjet import bad_input, pages
from loadercase import BOX, COUNT, USE, LoaderCase, counts


class PluginCommand(LoaderCase):

    def test_load_makes_the_style_known(self):
        self.plugin()
        script = "plugin load exampleplugin.so" + USE
        for result in self.each(script):
            self.assertEqual(counts(result.output), [(0, 3), (5, 8)])

    def test_without_load_the_style_is_unknown(self):
        self.plugin()
        self.assertRefused(BOX + "fix count all plugin/example 3\n", 'Invalid fix style: "plugin/example"')

    def test_load_after_the_box(self):
        self.plugin()
        script = BOX + "plugin load exampleplugin.so\n" + COUNT
        for result in self.each(script):
            self.assertEqual(counts(result.output), [(0, 3), (5, 8)])

    def test_errors_of_the_style_keep_their_form(self):
        self.plugin()
        self.assertRefused("plugin load exampleplugin.so" + BOX + "fix count all plugin/example\n",
                           "Fix plugin/example (id count): expected: fix ID group plugin/example <start>")

    def test_loading_twice_is_harmless(self):
        self.plugin()
        script = (f"plugin load exampleplugin.so\nplugin load ./exampleplugin.so\n"
                  f"plugin load {self.folder}/exampleplugin.so\n" + USE +
                  "plugin load exampleplugin.so\nrun 5\nplugin list\n")
        for result in self.each(script):
            self.assertEqual(counts(result.output), [(0, 3), (5, 8), (5, 8), (10, 13)])
            self.assertEqual(result.output.count("fix plugin/example:"), 1, result)

    def test_list_names_file_style_info_and_author(self):
        path = self.plugin()
        for result in self.each("plugin list\nplugin load exampleplugin.so\nplugin list\n"):
            before, after = result.output.split("Loaded plugins:")
            self.assertIn("No plugins are loaded", before)
            self.assertIn(str(path.resolve()), after)
            self.assertIn("fix plugin/example: counts time steps (author: Grainjet developers)", after)
            log = (self.folder / "log.liggghts").read_text()
            self.assertIn("fix plugin/example: counts time steps", log)

    def test_a_command_as_plugin(self):
        self.plugin("commandplugin.so")
        script = "plugin load commandplugin.so\nplugin list\nplugin_say hello\nclear\nplugin_say again\n"
        for result in self.each(script):
            self.assertIn("command plugin_say: not stated (author: not stated)", result.output)
            self.assertIn("The plugin says: hello", result.output)
            self.assertIn("The plugin says: again", result.output)
        self.assertRefused("plugin load commandplugin.so\nplugin clear\nplugin_say hello\n",
                           "Unknown command: plugin_say hello")

    def test_clear_forgets_the_styles(self):
        self.plugin()
        script = ("plugin load exampleplugin.so" + USE +
                  "unfix count\nthermo_style one\nplugin clear\nplugin list\n")
        for result in self.each(script):
            self.assertIn("No plugins are loaded", result.output)
        invalid = 'Invalid fix style: "plugin/example"'
        self.assertRefused(script + "fix count all plugin/example 3\n", invalid)
        self.assertRefused(script + "clear\n" + BOX + "fix count all plugin/example 3\n", invalid)

    def test_clear_with_the_style_in_use_is_an_error(self):
        path = self.plugin()
        self.assertRefused("plugin load exampleplugin.so" + BOX + "fix count all plugin/example 3\nplugin clear\n",
                           "plugin clear", "fix count", "plugin/example", str(path.resolve()), "unfix count")

    def test_load_again_after_clear(self):
        self.plugin()
        script = "plugin load exampleplugin.so\nplugin clear\nplugin load exampleplugin.so" + USE
        for result in self.each(script):
            self.assertEqual(counts(result.output), [(0, 3), (5, 8)])

    def test_clear_without_plugins(self):
        for result in self.each("plugin clear\nplugin list\n"):
            self.assertIn("No plugins are loaded", result.output)

    def test_each_word_of_the_page_spoilt(self):
        """A word of the page that this table lacks fails; one with the host's own message is Unknown command."""
        entries = {"load": bad_input.Entry("file", "exampleplugin.so"), "list": bad_input.Entry("none", ""),
                   "clear": bad_input.Entry("none", "")}
        page = (grainjet.ROOT / "docs/loader.md").read_text()
        words = [name.split()[0] for name in pages.table_of_page(page, "Commands")]
        self.assertEqual([word for word in words if word in entries], list(entries))
        self.plugin()
        for word, entry in entries.items():
            lines = [f"plugin {bad_input.misspelt(word)} {entry.good}", f"plugin {word} {entry.good} {entry.good or 'x'}",
                     f"plugin {word.upper()} {entry.good}", f'plugin "{word} {entry.good}"']
            lines += [f"plugin {word} {text}" for _, text, _ in bad_input.values(entry.kind)] if entry.good else []
            for line in lines:
                with self.subTest(line):
                    result = self.liggghts(line + "\n", check=False)
                    self.assertEqual(result.code, 1, result)
                    self.assertEqual(result.output.count("ERROR"), 1, result)
                    self.assertRegex(result.output, "Illegal plugin command|plugin load: there is no file")

    def test_illegal_words(self):
        for line in ("plugin", "plugin load", "plugin load a.so b.so", "plugin list all",
                     "plugin clear now", "plugin unload a.so"):
            with self.subTest(line=line):
                self.assertRefused(line + "\n", f"Illegal plugin command '{line}'",
                                   "plugin load <file>, plugin list or plugin clear")


class Survival(LoaderCase):

    def test_the_clear_command(self):
        self.plugin()
        script = "plugin load exampleplugin.so" + 3 * (USE + "clear\n") + "plugin list\n"
        for result in self.each(script):
            self.assertEqual(counts(result.output), 3 * [(0, 3), (5, 8)])
            self.assertEqual(result.output.count("fix plugin/example:"), 1, result)

    def test_include(self):
        self.plugin()
        (self.folder / "in.styles").write_text("plugin load exampleplugin.so\n")
        (self.folder / "in.use").write_text(USE)
        script = "include in.styles\ninclude in.use\nclear\ninclude in.styles\ninclude in.use\n"
        for result in self.each(script):
            self.assertEqual(counts(result.output), 2 * [(0, 3), (5, 8)])

    def test_jump(self):
        self.plugin()
        script = ("variable i loop 3\nlabel again\nplugin load exampleplugin.so" + USE +
                  "clear\nnext i\njump SELF again\n")
        for result in self.each(script):
            self.assertEqual(counts(result.output), 3 * [(0, 3), (5, 8)])

    def test_restart(self):
        self.plugin()
        for result in self.each("plugin load exampleplugin.so" + USE + "write_restart restart.bin\n"):
            again = ("plugin load exampleplugin.so\nunits si\natom_style granular\n"
                     "atom_modify map array sort 0 0\nboundary f f f\nnewton off\ncommunicate single vel yes\n"
                     "read_restart restart.bin\nneighbor 0.1 bin\ntimestep 1e-5\n"
                     "fix count all plugin/example 100\nthermo_style custom step f_count\nrun 5\n")
            for second in self.each(again):
                self.assertEqual(counts(second.output), [(5, 8), (10, 13)])

    def test_unfix_and_fix_again(self):
        self.plugin()
        script = ("plugin load exampleplugin.so" + USE +
                  "thermo_style one\nunfix count\nfix count all plugin/example 50\n"
                  "thermo_style custom step f_count\nrun 5\n")
        for result in self.each(script):
            self.assertEqual(counts(result.output), [(0, 3), (5, 8), (5, 50), (10, 55)])


class Partitions(LoaderCase):

    def test_each_partition_loads_by_itself(self):
        self.plugin()
        script = "plugin load exampleplugin.so" + USE
        self.liggghts(script, ranks=2, args=["-partition", "2x1", "-plog", "log.part", "-pscreen", "screen.part"])
        for part in (0, 1):
            log = (self.folder / f"log.part.{part}").read_text()
            self.assertEqual(counts(log), [(0, 3), (5, 8)])


if __name__ == "__main__":
    unittest.main()
