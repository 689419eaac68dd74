# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""An OpenFOAM that is sourced but that nothing can be built for: one message before anything is compiled."""

import os
import shutil
import unittest

import grainjet
from grainjet import openfoam_tree

WMAKE = '#!/bin/sh\n[ "$1" != -show-cxx ] || echo g++ -std=c++11\n'
# whoever owns nothing
NOBODY = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]


class SourcedOpenFOAM(grainjet.Case):

    def setUp(self):
        super().setUp()
        wmake = self.folder/"wmake"
        wmake.write_text(WMAKE)
        wmake.chmod(0o755)
        self.tree = self.folder/"openfoam"
        self.env = openfoam_tree.make(self.tree, wmake)
        self.library = self.tree/"lib/libOpenFOAM.so"
        self.info = self.tree/"META-INFO/api-info"
        # a copy, which another user can read
        self.copy = self.folder/"grainjet"
        (self.copy/"lib").mkdir(parents=True)
        shutil.copytree(grainjet.ROOT/"openfoam-libs/tools", self.copy/"openfoam-libs/tools")
        for options in (grainjet.ROOT/"openfoam-libs").glob("*/Make/options"):
            copy = self.copy/options.relative_to(grainjet.ROOT)
            copy.parent.mkdir(parents=True)
            shutil.copy(options, copy)
        (self.copy/"Allwmake").write_text("#!/bin/bash\ncd \"$(dirname \"$0\")\"\n. openfoam-libs/tools/openfoam-environment\n"
                                          "echo \"compiling for $openfoam into $FOAM_USER_LIBBIN\"\n")
        (self.copy/"Allwmake").chmod(0o755)

    def build(self, user=(), **variables):
        return grainjet.run([*user, self.copy/"Allwmake"], self.folder, env={**self.env, **variables})

    def assertRefused(self, *words, user=(), **variables):
        result = self.build(user, **variables)
        self.assertFails(result, *words)
        self.assertEqual(result.output.count("Allwmake: "), 1, result)
        self.assertNotIn("compiling", result.output)
        return result

    def test_one_that_fits(self):
        result = self.build()
        self.assertEqual(result.code, 0, result)
        self.assertIn(f"compiling for {self.tree} (v1912) into {self.copy/'lib'}", result.output)

    def test_openfoam_org(self):
        self.info.unlink()
        for version in ("7", "11", "dev"):
            self.assertRefused(str(self.tree), f"version {version} of openfoam.org", "openfoam.com", WM_PROJECT_VERSION=version)
        self.assertRefused(str(self.tree), "not one of openfoam.com", WM_PROJECT_VERSION="v1812")

    def test_too_old(self):
        self.info.write_text("api=1906\n")
        self.assertRefused("version 1906", "older than v1912", WM_PROJECT_VERSION="v1906")

    def test_headers_and_library_of_two_versions(self):
        openfoam_tree.library(self.library, 2012)
        self.assertRefused("headers of v1912", str(self.library), "of v2012", "FOAM_LIBBIN")
        self.library.write_bytes(self.library.read_bytes().replace(b"foamVersion", b"formVersion"))
        self.assertRefused("headers of v1912", "unknown version")

    def test_not_compiled(self):
        self.library.unlink()
        self.assertRefused("no libraries", str(self.library), "Compile that OpenFOAM first")

    def test_not_compiled_whole(self):
        """Each library that Grainjet's are linked with: the linker would take a missing one from Debian's package."""
        for name in openfoam_tree.NEEDED:
            library = self.tree/f"lib/lib{name}.so"
            library.unlink()
            self.assertRefused("not compiled whole", str(library), "Compile the rest")
            library.touch()

    def test_another_processor(self):
        openfoam_tree.of_another_processor(self.library)
        self.assertRefused(str(self.library), "another processor (RISC-V)")
        self.library.write_text("not a library\n")
        self.assertRefused(str(self.library), "another processor (no library)")

    def test_no_wmake(self):
        self.assertRefused("wmake is not in PATH", PATH=os.pathsep.join(
            folder for folder in grainjet.ENV["PATH"].split(os.pathsep) if not os.path.exists(os.path.join(folder, "wmake"))))

    def test_folder_of_libraries(self):
        """Made if it is missing; one that cannot be written to, or made, is refused."""
        folder = self.folder/"new/lib"
        result = self.build(FOAM_USER_LIBBIN=folder)
        self.assertEqual(result.code, 0, result)
        self.assertTrue(folder.is_dir())
        self.assertRefused(str(self.library/"lib"), "cannot be written to", "FOAM_USER_LIBBIN",
                           FOAM_USER_LIBBIN=self.library/"lib")

        for name in ("libraries", "./lib", f"{self.folder}/my libraries", f"{self.folder}/a:b"):
            self.assertRefused(f"FOAM_USER_LIBBIN is '{name}'", "blanks", FOAM_USER_LIBBIN=name)
            self.assertFalse((self.folder/name).exists())

        folder.chmod(0o555)
        self.folder.chmod(0o755)
        user = NOBODY if os.geteuid() == 0 else []
        self.assertRefused(str(folder), "cannot be written to", "FOAM_USER_LIBBIN", user=user, FOAM_USER_LIBBIN=folder)
        shared = self.folder/"shared"
        shared.mkdir()
        shared.chmod(0o777)
        result = self.build(user, FOAM_USER_LIBBIN=shared)
        self.assertEqual(result.code, 0, result)


if __name__ == "__main__":
    unittest.main()
