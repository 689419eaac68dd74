# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""Parts of two builds side by side: plugins, loaders and the coupling state Grainjet's version."""

import re
import subprocess
import unittest

import grainjet
from loadercase import PLUGINS, LoaderCase

HEADER = (grainjet.ROOT / "liggghts-plugins/host/grainjet_version.h").read_text()
VERSION = re.search(r'#define GRAINJET_VERSION "(.*)"', HEADER).group(1)


class Versions(LoaderCase):

    def test_one_version_for_both_builds(self):
        """It stands in the header alone; CMake's is that one, and the first entry of the changes is for it."""
        cache = (grainjet.ROOT / "build/CMakeCache.txt").read_text()
        self.assertIn(f"CMAKE_PROJECT_VERSION:STATIC={VERSION}\n", cache)
        self.assertNotIn(VERSION, (grainjet.ROOT / "CMakeLists.txt").read_text())
        changes = re.findall(r"(?m)^## (\S+), \d{4}-\d\d-\d\d$", (grainjet.ROOT / "docs/CHANGELOG.md").read_text())
        self.assertEqual(changes[0], VERSION)

    def test_the_list_of_plugins_begins_with_it(self):
        for script in ("plugin list\n", "plugin load hertzcgplugin.so\nplugin list\n"):
            result = self.liggghts(script)
            self.assertEqual(result.output.splitlines().count(f"Grainjet {VERSION}"), 1, result)

    def test_every_part_is_stamped(self):
        for name in ("hertzcgplugin", "collisionstatsplugin", "platestatsplugin", "surfacestatsplugin", "fluidforceplugin", "fluidheatplugin",
                     "grainmotionplugin", "wallroughnessplugin", "liggghtsloader"):
            file = grainjet.ROOT / f"lib/{name}.so"
            symbols = subprocess.run(["nm", "-D", file], check=True, stdout=subprocess.PIPE, text=True).stdout
            self.assertIn("liggghtsplugin_grainjet", symbols, name)
            self.assertIn(VERSION.encode(), file.read_bytes(), name)

    def test_plugin_of_another_version(self):
        path = self.plugin("othergrainjetplugin.so")
        self.assertRefused("plugin load othergrainjetplugin.so\n", str(path.resolve()),
                           "was built with Grainjet 0.0.9", f"this is Grainjet {VERSION} ({grainjet.ROOT}/lib/liggghtsloader.so)", "./Allwmake")

    def test_plugin_without_version_and_with_another_description(self):
        path = self.plugin("unstampedplugin.so")
        self.assertRefused("plugin load unstampedplugin.so\n", str(path.resolve()),
                           "was built with an earlier Grainjet", f"this is Grainjet {VERSION}", "./Allwmake")

    def test_two_loaders(self):
        (self.folder / "in.test").write_text("plugin list\n")
        for ranks in (0, 2):
            result = grainjet.run(
                [*grainjet.mpirun(ranks), "env", f"LD_PRELOAD={grainjet.ROOT}/lib/liggghtsloader.so",
                 PLUGINS / "couplingprogram", PLUGINS / "othergrainjetlibrary.so", "in.test"], self.folder)
            self.assertFails(result, "Two plugin loaders", "othergrainjetlibrary.so of Grainjet 0.0.9",
                             f"liggghtsloader.so of Grainjet {VERSION}", "./Allwmake")
            self.assertEqual(result.output.count("ERROR"), 1, result)


if __name__ == "__main__":
    unittest.main()
