# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# label: long
"""LIGGGHTS_ROOT names program, library and headers of one LIGGGHTS; mixtures and builds that cannot be used are refused."""

import os
import subprocess
import unittest

import grainjet
from grainjet import host_library
from loadercase import PLUGINS, LoaderCase

HOST_VERSION = grainjet.ROOT / "liggghts-plugins/loader/host-version"
OTHERS = ("LIGGGHTS-PFM 22.05.12", "LIGGGHTS-INL 4.0.0-r1")

# what a library has to show of itself, and nothing else of LIGGGHTS
STUB = """
extern "C" const char version[] = "LIGGGHTS-PUBLIC 3.8.0, compiled for a test";
extern "C" {{
void landmark() asm("_ZN9LAMMPS_NS6LAMMPS11post_createEv");
void landmark() {{}}
{functions}
}}
"""
INTEGERS = {"SMALLSMALL": "ii", "SMALLBIG": "li", "BIGBIG": "ll"}       # of bigint and tagint, in the names of functions
OPEN_MPI, INT_MPI = "_ZN9LAMMPS_NS6LAMMPSC1EiPPcP19ompi_communicator_t", "_ZN9LAMMPS_NS6LAMMPSC1EiPPci"
SUPERQUADRICS = "_ZN9LAMMPS_NS19AtomVecSuperquadricC1EPNS_6LAMMPSE"
VTK = "_ZN9LAMMPS_NS7DumpVTKC1EPNS_6LAMMPSE"

# a program that holds LIGGGHTS in itself, as far as anyone can see from outside
STATIC = """
#include <stdio.h>
int main() { puts("LIGGGHTS-PUBLIC 3.8.0, compiled for a test"); return 0; }
"""

STATE = """
import ctypes
host = ctypes.CDLL("{library}", mode=ctypes.RTLD_GLOBAL)
tell = ctypes.CDLL("{teller}")
tell.host_stamp.restype = tell.host_misfit.restype = ctypes.c_char_p
print(tell.host_stamp().decode())
print(tell.host_misfit(b"{stamp}").decode())
"""


class Root(LoaderCase):

    def say(self, *arguments, root=None):
        """What host-version prints, with this LIGGGHTS_ROOT."""
        return grainjet.run([HOST_VERSION, *arguments], self.folder, env={"LIGGGHTS_ROOT": str(root or "")})

    def said(self, *arguments, root=None):
        result = self.say(*arguments, root=root)
        self.assertEqual(result.code, 0, result)
        return result.output.strip()

    def refused(self, root, *words):
        """By host-version, whatever it is asked for, in one line."""
        for arguments in ((), ("-flags",)):
            result = self.say(*arguments, root=root)
            self.assertFails(result, *words)
            self.assertEqual(len(result.output.splitlines()), 1, result)

    def launched(self, root, program=None, **variables):
        (self.folder / "in.test").write_text("plugin list\n")
        return grainjet.run([program or "liggghts-plugins", "-in", "in.test"], self.folder, timeout=60,
                            env={"LIGGGHTS_ROOT": str(root), **variables})

    def compiled(self, source, to, *options):
        path = self.folder / (to.name + ".cpp")
        path.write_text(source)
        to.parent.mkdir(parents=True, exist_ok=True)
        to.unlink(missing_ok=True)
        result = grainjet.run(["c++", *options, path, "-o", to], self.folder)
        self.assertEqual(result.code, 0, result)
        return to

    def test_all_parts_come_from_it(self):
        root = host_library.root(self.folder / "root", host_library.other_build)
        self.assertEqual(self.said("-program", root=root), str(root / "bin/liggghts"))
        library = self.said("-library", root=root)
        self.assertEqual(os.path.dirname(library), str(root / "lib"))
        self.assertEqual(self.said("-headers", root=root), str(root / "include"))
        stamp = self.said(root=root)
        self.assertEqual(stamp, self.said(library))
        self.assertNotEqual(stamp, self.said(host_library.installed()))

        # and the launcher runs that program with that library
        self.assertFails(self.launched(root), f"but this is {stamp}", "LIGGGHTS_ROOT")
        same = host_library.root(self.folder / "same")
        result = self.launched(same)
        self.assertEqual(result.code, 0, result)
        self.assertIn("No plugins are loaded", result.output)

    def test_incomplete_and_mixed(self):
        self.refused(host_library.root(self.folder / "a root"), "a root", "blanks")
        root = self.folder / "root"
        for words in ("bin/liggghts", str(root)):
            self.refused(root, "LIGGGHTS_ROOT", words)
            self.assertFails(self.launched(root), "liggghts-plugins: LIGGGHTS_ROOT", words)

        host_library.root(root)
        headers = root / "include/liggghts"
        theirs = headers.resolve()
        headers.unlink()
        self.refused(root, "headers", "include/liggghts/lammps.h")
        headers.mkdir()
        for header in theirs.glob("*.h"):
            (headers / header.name).symlink_to(header)
        self.said(root=root)
        (headers / "version_liggghts.h").unlink(missing_ok=True)
        (headers / "version_liggghts.h").write_text('#define LIGGGHTS_VERSION "LIGGGHTS-INL 4.0.0, compiled by me"\n')
        self.refused(root, "LIGGGHTS-INL 4.0.0", "LIGGGHTS-PUBLIC 3.8.0", "mixed")

        # a root beside a program that is linked with the library of another one
        lonely = host_library.root(self.folder / "lonely")
        library, = (lonely / "lib").iterdir()
        other = self.folder / "elsewhere" / library.name
        other.parent.mkdir()
        library.rename(other)
        result = grainjet.run([HOST_VERSION], self.folder,
                              env={"LIGGGHTS_ROOT": str(lonely), "LD_LIBRARY_PATH": str(other.parent)})
        self.assertFails(result, str(other), "outside LIGGGHTS_ROOT", "mixed")
        result = self.launched(lonely, LD_LIBRARY_PATH=str(other.parent))
        self.assertFails(result, "liggghts-plugins: ", str(other), "outside LIGGGHTS_ROOT", f"{lonely}/lib")

    def test_other_versions(self):
        for name in OTHERS:
            root = host_library.root(self.folder / name.split()[0], host_library.other_version(name))
            self.refused(root, name, "public version 3.8.0 only")
            self.assertFails(self.launched(root), f"but this is {name}", "public version 3.8.0 only")

    def test_library_that_calls_its_own_functions(self):
        root = host_library.root(self.folder / "symbolic", host_library.symbolic)
        self.refused(root, "calls its own functions", "-Bsymbolic", "-fno-semantic-interposition")
        result = self.launched(root)
        self.assertFails(result, "LIGGGHTS calls its own functions", "-Bsymbolic", "-fno-semantic-interposition")
        self.assertNotIn("Unknown command", result.output)

    def test_static_program(self):
        root = host_library.root(self.folder / "root")
        self.compiled(STATIC, root / "bin/liggghts")
        self.refused(root, "holds LIGGGHTS in itself", "make auto", "docs/loader.md")
        result = self.launched(root)
        self.assertFails(result, "holds LIGGGHTS in itself", "make auto", "docs/loader.md")
        self.assertNotIn("compiled for a test", result.output)     # it has not run

        # behind a script
        (root / "bin/liggghts").rename(root / "bin/program")
        (root / "bin/liggghts").write_text(f'#!/bin/sh\nexec "{root}/bin/program" "$@"\n')
        (root / "bin/liggghts").chmod(0o755)
        self.refused(root, "is a script")
        self.assertFails(self.launched(root), "holds LIGGGHTS in itself")

        # one that no loader can reach
        self.compiled(STATIC, root / "bin/liggghts", "-static")
        self.refused(root, "holds LIGGGHTS in itself")
        result = self.launched(root)
        self.assertFails(result, "static program", "docs/loader.md")
        self.assertNotIn("compiled for a test", result.output)

    def test_another_kind_of_machine(self):
        root = host_library.root(self.folder / "root")
        library, = (root / "lib").iterdir()
        host_library.foreign(library)
        result = self.say(library)
        self.assertFails(result, str(library), "another kind of machine", "AArch64")
        host_library.foreign(root / "bin/liggghts")
        self.refused(root, "bin/liggghts is for another kind of machine", "AArch64")

        host_library.foreign(self.plugin())
        self.assertRefused("plugin load exampleplugin.so\n", "exampleplugin.so' is for another kind of machine (aarch64",
                           "build it on this one")

    def test_options_of_a_library(self):
        """As the script finds them by nm, and a process by the linker."""
        stamps = {}
        for name, (big, tag) in INTEGERS.items():
            for more, words in (((), ""), ((SUPERQUADRICS,), " superquadrics"), ((SUPERQUADRICS, VTK), " superquadrics VTK")):
                symbols = (f"_ZN9LAMMPS_NS6Modify15addstep_computeE{big}", f"_ZN9LAMMPS_NS6Domain5unmapEPd{tag}", OPEN_MPI, *more)
                library = self.stub(f"{name}{len(more)}", *symbols)
                stamp = self.said(library)
                self.assertRegex(stamp, f"^LIGGGHTS-PUBLIC 3.8.0, {name} OpenMPI{words}, build [0-9a-f]+$")
                stamps[name, words] = stamp
                (self.folder / "state.py").write_text(STATE.format(
                    library=library, teller=PLUGINS / "hostbuildlibrary.so", stamp=stamps["SMALLSMALL", ""]))
                result = grainjet.run(["/usr/bin/python3", "state.py"], self.folder)
                self.assertEqual(result.code, 0, result)
                lines = result.output.splitlines()
                self.assertEqual(lines[0], stamp)
                if name != "SMALLSMALL":
                    self.assertIn(f"Only the former has SMALLSMALL. Only the latter has {name}{words}.", lines[1])
                elif words:
                    self.assertIn(f"Only the latter has{words}.", lines[1])
                    self.assertNotIn("former", lines[1])
                else:
                    self.assertEqual(lines[1], "")

    def stub(self, name, *symbols):
        functions = "\n".join(f'void f{n}() asm("{symbol}"); void f{n}() {{}}' for n, symbol in enumerate(symbols))
        return self.compiled(STUB.format(functions=functions), self.folder / f"lib{name}.so", "-shared", "-fPIC", "-Wl,--build-id")

    def test_mpi_of_a_library(self):
        integers = ("_ZN9LAMMPS_NS6Modify15addstep_computeEl", "_ZN9LAMMPS_NS6Domain5unmapEPdi")
        self.assertIn(" SMALLBIG MPICH,", self.said(self.stub("mpich", *integers, INT_MPI)))
        self.assertFails(self.say(self.stub("stubs", *integers, INT_MPI, "MPI_Init")), "without MPI", "STUBS")
        self.assertFails(self.say(self.stub("other", *integers)), "neither Open MPI nor MPICH")
        self.assertFails(self.say(self.stub("hidden", OPEN_MPI)), "sizes of its integers", "visibility")

    def test_compiled_with_other_options(self):
        """A plugin whose integers are not those that its stamp states does not compile."""
        source = grainjet.ROOT / "liggghts-plugins/loader/tests/exampleplugin.cpp"
        stamp, flags = self.said(), self.said("-flags").split()
        mpi = subprocess.run(["mpicxx", "--showme:compile"], check=True, stdout=subprocess.PIPE, text=True).stdout.split()
        self.assertIn("-DLAMMPS_", flags[0])
        for integers in INTEGERS:
            result = grainjet.run(
                ["c++", "-std=c++17", "-fsyntax-only", "-DOMPI_SKIP_MPICXX", f'-DLIGGGHTSPLUGIN_HOST="{stamp}"',
                 f"-DLAMMPS_{integers}", *flags[1:], f"-I{grainjet.ROOT}/liggghts-plugins", *mpi, source], self.folder)
            if flags[0] == f"-DLAMMPS_{integers}":
                self.assertEqual(result.code, 0, result)
            else:
                self.assertFails(result, f"integers than LAMMPS_{integers}", "host-version -flags")

    def test_cmake(self):
        """CMake refuses what host-version refuses, and another root than the environment's."""
        root = host_library.root(self.folder / "root", host_library.other_version(OTHERS[0]))
        configure = ["cmake", "-S", grainjet.ROOT, "-B", self.folder / "build", "-DGRAINJET_TESTS=OFF"]
        result = grainjet.run([*configure, f"-DLIGGGHTS_ROOT={root}"], self.folder, env={"LIGGGHTS_ROOT": str(root)})
        self.assertFails(result, OTHERS[0], "public version")
        result = grainjet.run([*configure, f"-DLIGGGHTS_ROOT={self.folder}"], self.folder, env={"LIGGGHTS_ROOT": str(root)})
        self.assertFails(result, "for CMake", str(root), "in the")

    def test_unknown_arguments(self):
        for arguments in (("-version",), ("-flags", "-library"), ("",)):
            self.assertFails(self.say(*arguments), "unknown arguments", "host-version [-program")


if __name__ == "__main__":
    unittest.main()
