# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What ./Allwmake makes of its argument, of CXX and of the OpenFOAM that is sourced, and a build without tests.

Allwmake itself runs, in a copy; the programs that it calls are replaced by ones that write down how they are called.
"""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

import grainjet
from grainjet import host_library, openfoam_tree

# what the programs do besides writing down their call; `id` makes a superuser of everybody
PROGRAMS = {
    "cmake": "", "wmake": '[ "$1" != -show-cxx ] || echo g++ -std=c++11', "wmakeLnInclude": "", "apt-get": "",
    "apt-cache": 'case "$UNKNOWN" in *" $2 "*) ;; *) echo "  Candidate: 1.0" ;; esac',
    "dpkg-query": 'case "$3" in *Version*) echo "$PYTHON"; exit ;; esac; case "$ABSENT" in *" $4 "*) ;; *) printf installed ;; esac',
    "id": "echo 0",
    "g++": 'case "$*" in *-dM*) echo "#define __GNUC__ 12" ;; *) echo "g++ $VERSION" ;; esac',
    "clang++": 'case "$*" in *-dM*) echo "#define __GNUC__ 4"; echo "#define __clang__ 1" ;; *) echo "clang $VERSION" ;; esac',
    "othercompiler": "",
}
SILENT = ("apt-cache", "dpkg-query", "id", "g++", "clang++", "othercompiler")    # only asked for something
LIBRARIES = ("jetTurbulenceModels", "particleSamplingPlanes", "liggghtsCoupling", "jetVoFphaseTurbulenceModels",
             "jetTwoPhaseMixtureTurbulenceModels", "jetReactingPhaseTurbulenceModels")
OF_TESTS = ("libgtest-dev", "python3", "python3-numpy", "python3-scipy", "python3-matplotlib", "python3-vtk9")


class Allwmake(grainjet.Case):

    def setUp(self):
        super().setUp()
        self.copy = self.folder / "grainjet"
        products = shutil.ignore_patterns("lnInclude", "linux*", "tests", "*.[CH]")
        shutil.copytree(grainjet.ROOT / "openfoam-libs", self.copy / "openfoam-libs", ignore=products)
        (self.copy / "liggghts-plugins").mkdir()
        shutil.copytree(grainjet.ROOT / "liggghts-plugins/loader", self.copy / "liggghts-plugins/loader", ignore=products)
        shutil.copy(grainjet.ROOT / "Allwmake", self.copy)

        self.calls = self.folder / "calls"
        programs = self.folder / "programs"
        programs.mkdir()
        for name, action in PROGRAMS.items():
            note = "" if name in SILENT else f'echo "$(basename "$PWD"): {name} $*" >> {self.calls}\n'
            (programs / name).write_text(f"#!/bin/bash\n{note}{action}\n")
            (programs / name).chmod(0o755)

        # an OpenFOAM as a user sources it
        foam = self.folder / "openfoam"
        self.env = {**openfoam_tree.make(foam, programs / "wmake"), "PATH": f"{programs}:{grainjet.ENV['PATH']}",
                    "ABSENT": "", "UNKNOWN": "", "PYTHON": "3.11.2-1", "VERSION": "1", "LIGGGHTS_ROOT": ""}
        self.phases = foam / "src/phaseSystemModels/reactingEulerFoam"
        self.phases.mkdir(parents=True)

    def allwmake(self, *arguments, **variables):
        """Its result, and the calls of the programs."""
        self.calls.write_text("")
        result = grainjet.run([self.copy / "Allwmake", *arguments], self.copy, env={**self.env, **variables})
        return result, self.calls.read_text().splitlines()

    def assertRefused(self, words, *arguments, **variables):
        """One message with these words, and nothing is installed, configured or compiled before."""
        result, calls = self.allwmake(*arguments, **variables)
        self.assertFails(result, *words)
        self.assertEqual(result.output.count("Allwmake: "), 1, result)
        self.assertEqual([call for call in calls if "-show-cxx" not in call], [])

    def one(self, calls, program):
        found = [call for call in calls if f": {program} " in call]
        self.assertEqual(len(found), 1, calls)
        return found[0]

    def test_all_of_it(self):
        result, calls = self.allwmake()
        self.assertEqual(result.code, 0, result)
        self.assertIn(" -DGRAINJET_TESTS=ON ", self.one(calls, "cmake -S"))
        for library in LIBRARIES:
            self.assertIn(f"{library}: wmake -s libso", calls)

    def test_phases_of_another_version(self):
        """Where their headers lie elsewhere the library for them is left out, and the rest is built."""
        for folder, built in (("reactingEuler", True), ("elsewhere", False)):
            with self.subTest(folder):
                self.phases = self.phases.rename(self.phases.parent / folder)
                result, calls = self.allwmake()
                self.assertEqual(result.code, 0, result)
                self.assertEqual([f"{library}: wmake -s libso" in calls for library in LIBRARIES], [True]*5 + [built])

    def test_turbulence_of_DPMFoam(self):
        """From v2012 on its header lies with the solver; an OpenFOAM without it is told apart."""
        words = "jetKEpsilon for DPMFoam and MPPICFoam is left out"
        foam = self.env["WM_PROJECT_DIR"]
        for release, there, told in ((1912, False, False), (2012, False, True), (2506, True, False)):
            with self.subTest(release=release):
                (foam / "META-INFO/api-info").write_text(f"api={release}\npatch=0\n")
                openfoam_tree.library(foam / "lib/libOpenFOAM.so", release)
                if there:
                    header = foam / ("applications/solvers/lagrangian/DPMFoam/DPMTurbulenceModels/"
                                     "DPMIncompressibleTurbulenceModel.H")
                    header.parent.mkdir(parents=True)
                    header.write_text("")
                result, _ = self.allwmake()
                self.assertEqual(result.code, 0, result)
                self.assertEqual(words in result.output, told, result)

    def test_without_tests(self):
        """No package for tests is asked for, the plugins' tests are off, all products are built."""
        absent = " ".join(["", *OF_TESTS, ""])
        result, calls = self.allwmake("-no-tests", ABSENT=absent)
        self.assertEqual(result.code, 0, result)
        self.assertIn(" -DGRAINJET_TESTS=OFF ", self.one(calls, "cmake -S"))
        self.one(calls, "cmake --build")
        for library in LIBRARIES:
            self.assertIn(f"{library}: wmake -s libso", calls)
        self.assertEqual([call for call in calls if "apt-get" in call], [])

        # the same with tests: these packages and no others
        _, calls = self.allwmake(ABSENT=absent)
        self.assertTrue(self.one(calls, "apt-get").endswith(" install " + " ".join(OF_TESTS)), calls)

    def test_packages_of_web_pages(self):
        """Installed with those for tests; an archive without them refuses nothing."""
        absent = " mkdocs mkdocs-material libjs-katex "
        result, calls = self.allwmake(ABSENT=absent)
        self.assertEqual(result.code, 0, result)
        self.assertTrue(self.one(calls, "apt-get").endswith(" install" + absent.rstrip()), calls)
        result, calls = self.allwmake(ABSENT=absent, UNKNOWN=" mkdocs-material ")
        self.assertEqual(result.code, 0, result)
        self.assertTrue([call for call in calls if "apt-get" in call][-1].endswith(" install mkdocs libjs-katex"), calls)
        result, calls = self.allwmake("-no-tests", ABSENT=absent)
        self.assertEqual([call for call in calls if "apt-get" in call], [])
        result, calls = self.allwmake(ABSENT=absent, UNKNOWN=absent)
        self.assertEqual(result.code, 0, result)
        self.assertEqual([call.split(": ")[1] for call in calls if "apt-get" in call], ["apt-get -q update"])

    def test_reader_of_TOML(self):
        """A package of its own for a Python before 3.11, where scripts are wanted."""
        for python, arguments, wanted in (("3.10.6-1~22.04", (), True), ("3.11.2-1", (), False), ("3.10.6-1~22.04", ("-no-tests",), False)):
            with self.subTest(python=python, arguments=arguments):
                _, calls = self.allwmake(*arguments, ABSENT=" python3-tomli ", PYTHON=python)
                self.assertEqual([call.endswith(" install python3-tomli") for call in calls if "apt-get" in call], [True]*wanted)

    def test_packages(self):
        """Made last, of what has been built; the package that makes them is asked for then only."""
        for arguments, tests in ((["-package"], "ON"), (["-no-tests", "-package"], "OFF"), (["-package", "-no-tests"], "OFF")):
            with self.subTest(arguments):
                result, calls = self.allwmake(*arguments, ABSENT=" dpkg-dev ")
                self.assertEqual(result.code, 0, result)
                self.assertIn(f" -DGRAINJET_TESTS={tests} ", self.one(calls, "cmake -S"))
                self.assertTrue(self.one(calls, "apt-get").endswith(" install dpkg-dev"), calls)
                self.assertTrue(calls[-1].endswith("cmake --build build --target package"), calls)
        _, calls = self.allwmake(ABSENT=" dpkg-dev ")
        self.assertEqual([call for call in calls if "apt-get" in call or "package" in call], [])

    def test_packages_that_the_system_has_not(self):
        """Which one, what takes its place; nothing is installed, after the lists have been fetched once."""
        for package, remedy in (("liggghts", "LIGGGHTS_ROOT"), ("libliggghts-dev", "LIGGGHTS_ROOT"),
                                ("librandom123-dev", "universe"), ("python3-vtk9", "-no-tests")):
            with self.subTest(package):
                result, calls = self.allwmake(ABSENT=f" cmake {package} ", UNKNOWN=f" {package} ")
                self.assertFails(result, "in none of the archives", f": {package}\n", remedy, "Nothing has been")
                self.assertEqual([call.split(": ")[1] for call in calls], ["apt-get -q update"])

        # without an OpenFOAM that is sourced
        result, calls = self.allwmake(ABSENT=" openfoam ", UNKNOWN=" openfoam ", WM_PROJECT_DIR="")
        self.assertFails(result, "in none of the archives", "openfoam: source an OpenFOAM of openfoam.com")
        self.assertEqual([call.split(": ")[1] for call in calls], ["apt-get -q update"])

    def test_liggghts_of_ones_own(self):
        """LIGGGHTS_ROOT: Debian's packages of it are not asked for, and CMake gets it; what cannot be used is refused."""
        absent = " liggghts libliggghts-dev "
        _, calls = self.allwmake(ABSENT=absent)
        self.assertTrue(self.one(calls, "apt-get").endswith(" install liggghts libliggghts-dev"), calls)

        root = host_library.root(self.folder / "liggghts")
        result, calls = self.allwmake(ABSENT=absent, LIGGGHTS_ROOT=root)
        self.assertEqual(result.code, 0, result)
        self.assertIn(f" -DLIGGGHTS_ROOT={root}", self.one(calls, "cmake -S"))
        self.assertEqual([call for call in calls if "apt-get" in call], [])

        (root / "bin/liggghts").unlink()
        self.assertRefusedByLiggghts("no program bin/liggghts", LIGGGHTS_ROOT=root)

    def assertRefusedByLiggghts(self, *words, **variables):
        """One message before anything is configured or compiled."""
        result, calls = self.allwmake(**variables)
        self.assertFails(result, *words)
        self.assertEqual(result.output.count("host-version: "), 1, result)
        self.assertEqual([call for call in calls if "cmake" in call or "libso" in call], [])

    def test_libraries_of_an_earlier_build(self):
        """Those in lib go where they are now put elsewhere, so that only one of each is found."""
        (self.copy / "lib").mkdir()
        earlier = [self.copy / "lib" / name for name in ("libliggghtsCoupling.so", "hertzcgplugin.so")]
        for path in earlier:
            path.write_text("")
        for folder, left in ((None, earlier), (self.copy / "lib/../lib", earlier), (self.folder / "user/lib", earlier[1:])):
            result, _ = self.allwmake(**({"FOAM_USER_LIBBIN": folder} if folder else {}))
            self.assertEqual(result.code, 0, result)
            self.assertEqual([path for path in earlier if path.exists()], left, folder)

    def test_unknown_arguments(self):
        for arguments in (["-notests"], ["-no-tests", "more"], ["-help"], ["all"]):
            with self.subTest(arguments):
                self.assertRefused(["unknown argument: " + " ".join(arguments), "./Allwmake [-no-tests] [-package]"], *arguments)

    def test_compiler(self):
        """The compiler of CXX, else the one of OpenFOAM, for the plugins as well."""
        for variables, compiler in (({}, "g++"), ({"CXX": "g++"}, "g++"), ({"CXX": "clang++", "WM_COMPILER": "Clang"}, "clang++")):
            with self.subTest(variables):
                result, calls = self.allwmake(**variables)
                self.assertEqual(result.code, 0, result)
                self.assertIn(f"/programs/{compiler} ", self.one(calls, "cmake -S"))

    def test_compilers_that_are_refused(self):
        self.assertRefused(["'nocompiler' is not there", "clang"], CXX="nocompiler")
        self.assertRefused(["'othercompiler'", "neither g++ nor clang++"], CXX="othercompiler")
        self.assertRefused(["'clang++'", "set up for Gcc", "WM_COMPILER=Clang"], CXX="clang++")
        self.assertRefused(["'g++'", "set up for Clang", "WM_COMPILER=Gcc"], CXX="g++", WM_COMPILER="Clang")

    def test_mpi_that_is_refused(self):
        """Of OpenFOAM and LIGGGHTS, which share the ranks."""
        pstream = pathlib.Path(self.env["FOAM_LIBBIN"]) / "my-mpi/libPstream.so"
        openfoam_tree.library_of_mpi(pstream, "libmpich.so.12")
        self.assertRefused([str(self.folder / "openfoam"), "uses the MPI libmpich.so.12", str(host_library.installed()), "libmpi.so.40"],
                           FOAM_MPI="my-mpi")
        openfoam_tree.library_of_mpi(pstream, "libmpi.so.40")
        result, _ = self.allwmake(FOAM_MPI="my-mpi")
        self.assertEqual(result.code, 0, result)

    def test_precision_that_is_refused(self):
        for precision in ("SP", "SPDP"):
            self.assertRefused([f"precision {precision}", "WM_PRECISION_OPTION=DP"], WM_PRECISION_OPTION=precision)

    def test_objects_of_another_compiler_are_dropped(self):
        self.allwmake()
        products = [self.copy / "build/CMakeCache.txt",
                    *(self.copy / "openfoam-libs" / library / "Make/linux64/a.o" for library in LIBRARIES)]

        def kept(**variables):
            """Which products are still there after a run with these variables."""
            for path in products:
                path.parent.mkdir(exist_ok=True)
                path.write_text("")
            result, _ = self.allwmake(**variables)
            self.assertEqual(result.code, 0, result)
            return [path.exists() for path in products]

        self.assertEqual(kept(), [True]*len(products))
        self.assertEqual(kept(VERSION="2"), [False]*len(products))
        self.assertEqual(kept(VERSION="2"), [True]*len(products))
        self.assertEqual(kept(VERSION="2", CXX="clang++", WM_COMPILER="Clang"), [False]*len(products))

        # the same compiler by another path: CMake would drop the options that it is given
        products[0].write_text("CMAKE_CXX_COMPILER:STRING=/elsewhere/clang++\n")
        self.assertEqual(self.allwmake(VERSION="2", CXX="clang++", WM_COMPILER="Clang")[0].code, 0)
        self.assertFalse(products[0].exists())


class Plugins(unittest.TestCase):

    def configure(self, folder, tests):
        """CMake itself, where neither GoogleTest nor Python can be found."""
        return grainjet.run(["cmake", "-S", grainjet.ROOT, "-B", folder, f"-DGRAINJET_TESTS={tests}",
                             "-DCMAKE_DISABLE_FIND_PACKAGE_GTest=TRUE", "-DCMAKE_DISABLE_FIND_PACKAGE_Python3=TRUE"], folder)

    def test_without_tests(self):
        with tempfile.TemporaryDirectory(prefix="grainjet-") as folder:
            folder = pathlib.Path(folder)
            result = self.configure(folder, "OFF")
            self.assertEqual(result.code, 0, result)
            targets = subprocess.run(["cmake", "--build", folder, "--target", "help"], check=True,
                                     stdout=subprocess.PIPE, text=True).stdout
            for plugin in ("liggghtsloader", "hertzcgplugin", "collisionstatsplugin", "platestatsplugin", "surfacestatsplugin", "fluidforceplugin",
                           "fluidheatplugin", "grainmotionplugin", "wallroughnessplugin"):
                self.assertIn(plugin, targets)
            self.assertNotIn("exampleplugin", targets)
            self.assertNotIn("test_", targets)
            listed = grainjet.run(["ctest", "-N"], folder)
            self.assertNotIn("Test  #", listed.output)

    def test_with_tests_googletest_is_needed(self):
        with tempfile.TemporaryDirectory(prefix="grainjet-") as folder:
            result = self.configure(pathlib.Path(folder), "ON")
            self.assertNotEqual(result.code, 0, result)
            self.assertIn("GTest", result.output)


if __name__ == "__main__":
    unittest.main()
