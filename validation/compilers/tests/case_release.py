# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""check-release: what it does with the OpenFOAM that Grainjet is built with, and which trees it refuses."""

import pathlib
import shutil
import subprocess
import unittest

import grainjet

CHECK = grainjet.ROOT / "openfoam-libs/tools/check-release"
PARTS = ("src/OpenFOAM", "src/finiteVolume", "wmake/makefiles", "wmake/rules", "etc", "META-INFO")


def built_with():
    """The tree of the build: the one that is sourced, or Debian's."""
    done = subprocess.run(["bash", "-c", '. openfoam-libs/tools/openfoam-environment && echo "$WM_PROJECT_DIR"'],
                          cwd=grainjet.ROOT, stdout=subprocess.PIPE, text=True, check=True)
    return pathlib.Path(done.stdout.splitlines()[-1])


class WrongTrees(grainjet.Case):

    def setUp(self):
        super().setUp()
        self.tree = self.folder / "OpenFOAM"
        for part in PARTS:
            (self.tree / part).mkdir(parents=True)
        (self.tree / "etc/bashrc").write_text("")
        self.api = self.tree / "META-INFO/api-info"
        self.api.write_text("api=2412\npatch=0\n")

    def assertRefused(self, *words, arguments=()):
        """Code 2 and one message, before anything is compiled."""
        result = grainjet.run([CHECK, self.tree, *arguments], self.folder)
        self.assertEqual(result.code, 2, result)
        self.assertEqual(result.output.count("check-release: "), 1, result)
        self.assertNotIn("Traceback", result.output)
        for word in words:
            self.assertIn(word, result.output)

    def test_no_folder(self):
        self.tree = self.folder / "nowhere"
        self.assertRefused("there is no folder", "nowhere")

    def test_no_OpenFOAM(self):
        shutil.rmtree(self.tree)
        self.tree.mkdir()
        self.assertRefused("is not an unpacked OpenFOAM")

    def test_openfoam_org(self):
        self.api.unlink()
        self.assertRefused("not an OpenFOAM of openfoam.com, v1912 or later", "openfoam.org are not supported")

    def test_without_a_part(self):
        shutil.rmtree(self.tree / "src")
        self.assertRefused("is not complete", "lacks src/OpenFOAM, src/finiteVolume")

    def test_without_a_release(self):
        self.api.write_text("patch=0\n")
        self.assertRefused("has no line 'api=<release>'")

    def test_too_old(self):
        self.api.write_text("api=1906\n")
        self.assertRefused("is OpenFOAM v1906", "v1912 or later")

    def test_unknown_compiler(self):
        (self.tree / "src/OpenFOAM/lnInclude").mkdir()
        self.assertRefused("the compiler 'nocompiler' is not there", arguments=["--compiler", "nocompiler"])

    def test_unknown_library(self):
        self.assertRefused("there is no library 'jets'", "liggghtsCoupling, ", "userModels", arguments=["jets"])


class OwnTree(grainjet.Case):

    def copied(self, fault):
        """check-release in a copy whose jetTurbulenceModels has this in a header."""
        copy = self.folder / "grainjet"
        products = shutil.ignore_patterns("lnInclude", "linux*", "tests")
        for part in ("openfoam-libs", "liggghts-plugins"):
            shutil.copytree(grainjet.ROOT / part, copy / part, ignore=products, dirs_exist_ok=True)
        header = copy / "openfoam-libs/jetTurbulenceModels/jetKEpsilon/coefficientChecks.H"
        text = (grainjet.ROOT / header.relative_to(copy)).read_text()
        header.write_text(text.replace("namespace Foam\n{\n", "namespace Foam\n{\n" + fault, 1))
        return grainjet.run([copy / CHECK.relative_to(grainjet.ROOT), built_with(), "--first",
                             "jetTurbulenceModels", "particleSamplingPlanes"], self.folder, timeout=300)

    def test_that_it_compiles_and_how_it_fails(self):
        """Warnings and errors, each on a line with its source; a warning of OpenFOAM's headers is none."""
        good = self.copied("")
        self.assertEqual(good.code, 0, good)
        self.assertIn(": 2 sources of 2 libraries, 0 with errors, 0 with warnings", good.output)

        faults = {"inline int whole(double x) { return (int)x; }\n": ("old-style cast", "0 with errors, 1 with warnings"),
                  "int undeclared(nothing);\n": ("nothing", "1 with errors, 0 with warnings"),
                  "struct base { virtual void f(); virtual ~base(); };\nstruct derived : base { void f(); };\n":
                  ("can be marked override", "0 with errors, 1 with warnings")}
        for fault, (word, count) in faults.items():
            with self.subTest(fault):
                bad = self.copied(fault)
                self.assertEqual(bad.code, 1, bad)
                lines = [line for line in bad.output.splitlines() if "error: " in line]
                self.assertEqual(len(lines), 1, bad)
                self.assertTrue(lines[0].startswith("jetTurbulenceModels/jetKEpsilon/coefficientChecks.C: "), bad)
                self.assertIn(word, lines[0])
                self.assertIn(count, bad.output)

    def test_tree_without_links(self):
        """A tree that only holds what is unpacked, which stays as it was."""
        bare = self.folder / "bare"
        tree = built_with()
        links = shutil.ignore_patterns("lnInclude", "platforms")
        for part in ("src/OpenFOAM", "src/OSspecific", "src/finiteVolume", "src/meshTools", "wmake", "etc", "bin", "META-INFO"):
            shutil.copytree(tree / part, bare / part, ignore=links)
        before = sorted(bare.rglob("*"))
        result = grainjet.run([CHECK, bare, "--first", "particleSamplingPlanes"], self.folder, timeout=300)
        self.assertEqual(result.code, 0, result)
        self.assertEqual(sorted(bare.rglob("*")), before)


if __name__ == "__main__":
    unittest.main()
