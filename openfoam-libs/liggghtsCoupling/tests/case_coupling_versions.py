# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A fix fluid/force or a plugin of another Grainjet beside this coupling: an error, no wrong forces."""
# processors: 2

import subprocess
import unittest

import grainjet
from grainjet import coupled_box as box

PLUGINS = grainjet.ROOT / "lib/tests"


class Versions(grainjet.Case):

    def refused(self, plugin, *words):
        for ranks in (0, 2):
            folder = self.folder / f"{ranks}"
            box.write(folder)
            box.script(folder, grains=box.grains([(0.01, 0.01, 0.01)], [(0, 0, 1)]))
            box.fv_options(folder)
            script = folder / "constant/in.particles"
            text = script.read_text()
            self.assertIn("plugin load fluidforceplugin.so", text)
            script.write_text(text.replace("fluidforceplugin.so", str(PLUGINS / plugin)))
            self.foam("blockMesh", folder)
            if ranks:
                self.foam("decomposePar", folder)
            result = self.foam("pimpleFoam", folder, ranks, check=False, timeout=60)
            self.assertFails(result, "FOAM FATAL", "Grainjet", "./Allwmake", *words)
            self.assertNotRegex(result.output, box.SOLVED)

    def test_exchange_without_a_version(self):
        self.refused("earlierfluidforceplugin.so", "constant/in.particles", "fix fluid/force")

    def test_plugin_of_another_version(self):
        self.refused("othergrainjetplugin.so", "was built with Grainjet 0.0.9")

    def test_library_is_stamped(self):
        library = grainjet.openfoam_library("libliggghtsCoupling")
        symbols = subprocess.run(["nm", "-D", library], check=True, stdout=subprocess.PIPE, text=True).stdout
        self.assertIn("liggghtsplugin_grainjet", symbols)


if __name__ == "__main__":
    unittest.main()
