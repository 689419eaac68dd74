# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# label: long
"""The packages of this build, looked at and used without being installed: content, dependencies, version, no path of
the build; cases from the tarball. validation/packaging/clean_root installs the .deb in a system of its own."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import grainjet

BUILD = grainjet.ROOT/"build"
VERSION = re.search(r'VERSION "(.*)"', (grainjet.ROOT/"liggghts-plugins/host/grainjet_version.h").read_text())[1]
PLUGINS = ("hertzcgplugin.so", "collisionstatsplugin.so", "platestatsplugin.so", "surfacestatsplugin.so", "fluidforceplugin.so", "fluidheatplugin.so",
           "grainmotionplugin.so", "wallroughnessplugin.so")
LIBRARIES = ("libliggghtsCoupling.so", "libjetTurbulenceModels.so", "libparticleSamplingPlanes.so",
             "libjetVoFphaseTurbulenceModels.so", "libjetTwoPhaseMixtureTurbulenceModels.so")
CASES = ("quickJet/Allrun", "fluidBed/Allrun", "waterJet/Allrun", "sandblast/Allrun", "elbow/Allrun", "coldSpray/Allrun", "jetMill/Allrun",
         "tutorial/fluid/0/U", "tutorial/duct/0/U", "common/job.sh", "parameters.toml")
# what a run or a build leaves behind, and tests
SURPLUS = re.compile(r"/(tests|runs|__pycache__|postProcessing|processor\d+|polyMesh|\.git\w*|lnInclude)(/|$)|\.pyc$|/log\.")


def pack(kind, folder):
    """The path of the package of this kind, made in the folder."""
    made = grainjet.run(["cpack", "--config", BUILD/"CPackConfig.cmake", "-G", kind, "-B", folder], folder)
    if made.code:
        raise AssertionError(made)
    found = [path for path in folder.iterdir() if path.is_file()]
    assert len(found) == 1, found
    return found[0]


def installed(program):
    """Name and version of the package that a file is of."""
    name = subprocess.run(["dpkg-query", "-S", program], check=True, stdout=subprocess.PIPE, text=True).stdout.split(":")[0]
    version = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", name], check=True, stdout=subprocess.PIPE, text=True).stdout
    return name, version


class Package(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        (cls.folder/"made").mkdir()
        cls.package = pack(cls.KIND, cls.folder/"made")
        cls.tree = cls.folder/"tree"
        cls.tree.mkdir()
        subprocess.run([*cls.UNPACK, cls.package, *cls.TO, cls.tree], check=True)

    def assertClean(self, binaries, data):
        """All parts, nothing else; no path of the build in any of them."""
        for name in (*PLUGINS, *LIBRARIES, "liggghtsloader.so"):
            library = binaries/name
            self.assertTrue(library.is_file(), library)
            dynamic = subprocess.run(["readelf", "-d", library], check=True, stdout=subprocess.PIPE, text=True).stdout
            paths = re.findall(r"(?:RPATH|RUNPATH).*\[(.*)\]", dynamic)
            self.assertTrue(set(paths) <= {"$ORIGIN"}, f"{name}: {paths}")
        for name in CASES:
            self.assertTrue((data/"cases"/name).is_file(), name)
        for name in ("environment", "built-for", "validation/plots/profiles.py", "validation/testing/grainjet/tables.py"):
            self.assertTrue((data/name).is_file(), name)
        for path in self.tree.rglob("*"):
            self.assertIsNone(SURPLUS.search(str(path.relative_to(self.tree))), path)
            if path.is_file() and not path.is_symlink():
                content = path.read_bytes()
                for place in (grainjet.ROOT, pathlib.Path.home()/".cache"):
                    self.assertNotIn(str(place).encode() + b"/", content, path)
                self.assertFalse(path.stat().st_mode & 0o022, path)


class Deb(Package):
    KIND, UNPACK, TO = "DEB", ["dpkg-deb", "-x"], []

    def control(self, field):
        return subprocess.run(["dpkg-deb", "-f", self.package, field], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()

    def test_content(self):
        binaries, = self.tree.glob("usr/lib/*/grainjet")
        self.assertClean(binaries, self.tree/"usr/share/grainjet")
        # solvers find the libraries by links beside the folder
        for name in LIBRARIES:
            self.assertEqual(os.readlink(binaries.parent/name), f"grainjet/{name}")
        for link in (path for path in self.tree.rglob("*") if path.is_symlink()):
            self.assertTrue(link.exists(), f"{link} points nowhere")
        self.assertTrue(os.access(self.tree/"usr/bin/liggghts-plugins", os.X_OK))
        pages = self.tree/"usr/share/doc/grainjet"
        for name in ("copyright", "changelog.gz", "changelog.Debian.gz", "README.md", "docs/quickJet.md", "docs/images/quickJet.png"):
            self.assertTrue((pages/name).is_file(), name)

    def test_version(self):
        self.assertEqual(self.package.name.split("_")[:2], ["grainjet", f"{VERSION}-1"])
        self.assertEqual(self.control("Version"), f"{VERSION}-1")

    def test_dependencies(self):
        """The very build of LIGGGHTS, the version of OpenFOAM, and what the programs of the cases import."""
        depends = self.control("Depends").split(", ")
        library = subprocess.run(["bash", "-c", "ldd $(command -v liggghts) | sed -n 's/.*libliggghts.* => \\(.*\\) (.*/\\1/p'"],
                                 check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
        name, version = installed(os.path.realpath(library))
        self.assertIn(f"{name} (= {version})", depends)
        name, version = installed("/usr/lib/libOpenFOAM.so")
        upstream = version.rsplit("-", 1)[0]
        self.assertIn(f"{name} (>= {upstream})", depends)
        self.assertIn(f"{name} (<< {upstream}.)", depends)
        for name in ("liggghts", "openfoam", "openmpi-bin", "python3", "python3-numpy", "python3-scipy", "python3-matplotlib",
                     "python3-vtk9"):
            self.assertIn(name, depends)
        self.assertTrue([name for name in depends if name.startswith("libopenmpi")], depends)


class Tarball(Package):
    KIND, UNPACK, TO = "TXZ", ["tar", "xf"], ["--strip-components=1", "-C"]

    def user(self, command, folder, **variables):
        """A command of a user who has the tarball and neither this folder nor its environment."""
        clean = {name: "" for name in ("GRAINJET_DIR", "LD_LIBRARY_PATH", "LIGGGHTS_PLUGIN_PATH", "PYTHONPATH", "FOAM_USER_LIBBIN")}
        return grainjet.run(["bash", "-c", command], folder, env={**clean, "PATH": "/usr/bin:/bin", "WM_PROJECT_DIR": "", **variables})

    def test_content(self):
        self.assertIn(f"-{VERSION}-", self.package.name)
        self.assertClean(self.tree/"lib", self.tree)
        for name in ("COPYING", "README.md", "docs/CHANGELOG.md"):
            self.assertTrue((self.tree/name).is_file(), name)

    def test_environment(self):
        """As the folder that it was built in: plugins by bare name, libraries in a solver, cases in copies."""
        (self.folder/"in.plugins").write_text("".join(f"plugin load {name}\n" for name in PLUGINS))
        ran = self.user(f". {self.tree}/environment; liggghts-plugins -in in.plugins", self.folder)
        self.assertEqual(ran.code, 0, ran)
        for name in PLUGINS:
            self.assertIn(f"{self.tree}/lib/{name}", ran.output)

        case = self.folder/"jet"
        shutil.copytree(self.tree/"cases/quickJet", case)
        ran = self.user(f". {self.tree}/environment; ./particleInput && blockMesh && . $GRAINJET_DIR/cases/common/job.sh && "
                        "root=$GRAINJET_DIR prepare && cp -r 0.orig 0 && "
                        "foamDictionary system/controlDict -entry stopAt -set writeNow && pimpleFoam", case)
        self.assertEqual(ran.code, 0, ran)
        self.assertIn("liggghtsCoupling: grains", ran.output)

    def test_without_environment(self):
        """LIGGGHTS_PLUGIN_PATH alone, as a user of plugins has it."""
        ran = self.user(f"LIGGGHTS_PLUGIN_PATH={self.tree}/lib {self.tree}/bin/liggghts-plugins -in in.one", self.write_script())
        self.assertEqual(ran.code, 0, ran)
        self.assertIn("fix hertz/cg", ran.output)

    def write_script(self):
        (self.folder/"in.one").write_text("plugin load hertzcgplugin.so\nplugin list\n")
        return self.folder

    def test_another_openfoam(self):
        """Stops with both versions before anything runs."""
        built = self.tree/"built-for"
        text = built.read_text()
        self.addCleanup(built.write_text, text)
        built.write_text(re.sub("OpenFOAM v.*", "OpenFOAM v2412", text))
        case = self.folder/"other"
        shutil.copytree(self.tree/"cases/quickJet", case)
        ran = self.user(f". {self.tree}/environment; ./Allrun", case)
        self.assertNotEqual(ran.code, 0, ran)
        self.assertRegex(ran.output, r"is for OpenFOAM v2412, but v\d+ is the one that runs")
        self.assertFalse(list(case.glob("log.*")))

    def test_incomplete(self):
        """Stops before anything runs, and names the file."""
        case = self.folder/"incomplete"
        shutil.copytree(self.tree/"cases/quickJet", case)
        for name in ("lib/libliggghtsCoupling.so", "lib/fluidforceplugin.so", "built-for"):
            with self.subTest(name):
                (self.tree/name).rename(self.folder/"away")
                ran = self.user(f". {self.tree}/environment; ./Allrun", case)
                (self.folder/"away").rename(self.tree/name)
                self.assertNotEqual(ran.code, 0, ran)
                self.assertEqual(ran.output.count("\n"), 1, ran)
                self.assertIn(f"is not complete, there is no {self.tree/name}: install it again", ran.output)
                self.assertFalse(list(case.glob("log.*")))

    def test_folder_with_blanks(self):
        case = self.folder/"my jet"
        shutil.copytree(self.tree/"cases/quickJet", case)
        ran = self.user(f". {self.tree}/environment; ./Allrun", case)
        self.assertNotEqual(ran.code, 0, ran)
        self.assertEqual(ran.output, f"Allrun: the path '{case}' holds blanks or quotes, which OpenFOAM cannot handle: move it\n")

    def test_folder_that_cannot_be_written_to(self):
        case = self.folder/"shared"
        shutil.copytree(self.tree/"cases/quickJet", case)
        case.chmod(0o555)
        for folder in (self.folder, self.tree):
            folder.chmod(0o755)
        nobody = "setpriv --reuid=65534 --regid=65534 --clear-groups " if os.geteuid() == 0 else ""
        ran = self.user(f". {self.tree}/environment; {nobody}./Allrun", case)
        self.assertNotEqual(ran.code, 0, ran)
        self.assertIn("cannot be written to: copy it to one of your own", ran.output)


def load_tests(loader, tests, _):
    return unittest.TestSuite(loader.loadTestsFromTestCase(kind) for kind in (Deb, Tarball))


if __name__ == "__main__":
    if "DEB" not in (BUILD/"CPackConfig.cmake").read_text().split("CPACK_GENERATOR", 1)[1].split("\n")[0]:
        print("no .deb of this build: LIGGGHTS or OpenFOAM are no packages, or dpkg-dev is missing")
        sys.exit(77)
    unittest.main()
