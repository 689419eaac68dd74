# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The file `environment`: which Grainjet of several comes first, what is left of the user's own lists."""

import shutil
import unittest

import grainjet

LISTS = {"PATH": "bin", "LD_LIBRARY_PATH": "lib", "LIGGGHTS_PLUGIN_PATH": "lib", "PYTHONPATH": "validation/testing"}


class Environment(grainjet.Case):

    def setUp(self):
        super().setUp()
        self.places = [self.folder/name for name in ("one", "another place")]
        for place in self.places:
            place.mkdir()
            shutil.copy(grainjet.ROOT/"environment", place)

    def after(self, *places, **variables):
        """The variables of a shell that has none but these and then sources the places one after the other."""
        command = "set -eu; " + "; ".join(f". '{place}/environment'" for place in places) + "; env -0"
        settings = [f"{name}={value}" for name, value in {"PATH": "/usr/bin:/bin", **variables}.items()]
        result = grainjet.run(["env", "-i", *settings, "bash", "-c", command], self.folder)
        self.assertEqual(result.code, 0, result)
        return dict(line.split("=", 1) for line in result.output.split("\0") if line)

    def test_once(self):
        for times in (1, 3):
            env = self.after(*[self.places[0]]*times)
            self.assertEqual(env["GRAINJET_DIR"], str(self.places[0]))
            for name, part in LISTS.items():
                rest = ":/usr/bin:/bin" if name == "PATH" else ""
                self.assertEqual(env[name], f"{self.places[0]}/{part}{rest}", name)

    def test_the_last_one_comes_first(self):
        """Also if it was there before: program, plugins and libraries are those of one Grainjet."""
        one, other = self.places
        env = self.after(one, other, one, LD_LIBRARY_PATH="/usr/local/lib")
        for name, part in LISTS.items():
            rest = {"PATH": ":/usr/bin:/bin", "LD_LIBRARY_PATH": ":/usr/local/lib"}.get(name, "")
            self.assertEqual(env[name], f"{one}/{part}:{other}/{part}{rest}", name)

    def test_libraries_of_OpenFOAM(self):
        """Those in lib, or else in FOAM_USER_LIBBIN, before those of another Grainjet."""
        one, other = self.places
        for former in ("", f"/openfoam/lib:/user/lib:{other}/lib"):
            env = self.after(other, one, FOAM_USER_LIBBIN="/user/lib", LD_LIBRARY_PATH=former)
            self.assertEqual(env["LD_LIBRARY_PATH"].replace("/openfoam/lib", "").strip(":"), f"{one}/lib:/user/lib:{other}/lib")

    def test_lists_of_the_user_stay(self):
        plugins = f":/my plugins:/x*y::{self.places[0]}/libraries:"
        self.assertEqual(self.after(self.places[0], LIGGGHTS_PLUGIN_PATH=plugins)["LIGGGHTS_PLUGIN_PATH"],
                         f"{self.places[0]}/lib:{plugins}")

    def test_path_with_a_colon(self):
        """No list of folders can hold it."""
        place = self.folder/"a:b"
        place.mkdir()
        shutil.copy(grainjet.ROOT/"environment", place)
        result = grainjet.run(["bash", "-c", f". '{place}/environment' || echo refused"], self.folder)
        self.assertEqual(result.output, f"environment: the path '{place}' holds a colon, which separates the folders of PATH: "
                                        "move Grainjet\nrefused\n")

    def test_liggghts_of_ones_own(self):
        root = self.folder/"liggghts"
        (root/"bin").mkdir(parents=True)
        (root/"bin/liggghts").write_text("#!/bin/sh\n")
        (root/"bin/liggghts").chmod(0o755)
        env = self.after(self.places[0], self.places[0], LIGGGHTS_ROOT=root)
        self.assertEqual(env["PATH"], f"{root}/bin:{self.places[0]}/bin:/usr/bin:/bin")
        self.assertEqual(env["LD_LIBRARY_PATH"], f"{root}/lib:{root}/lib64:{self.places[0]}/lib")


if __name__ == "__main__":
    unittest.main()
