# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""Another build of LIGGGHTS than the one compiled for, and another library in the loader's place: errors."""

import subprocess
import unittest

import grainjet
from grainjet import host_library
from loadercase import PLUGINS, LoaderCase

STATE = """
import ctypes
host = ctypes.CDLL("{host}", mode=ctypes.RTLD_GLOBAL)
tell = ctypes.CDLL("{library}")
tell.host_stamp.restype = tell.host_misfit.restype = ctypes.c_char_p
print("stamp:", tell.host_stamp().decode())
for stamp in {stamps!r}:
    print("misfit:", tell.host_misfit(stamp.encode()).decode())
"""


def host_version(*library):
    return subprocess.run([grainjet.ROOT / "liggghts-plugins/loader/host-version", *library],
                          check=True, stdout=subprocess.PIPE, text=True).stdout.strip()


class HostBuild(LoaderCase):

    def stated(self, library, *stamps):
        """What a process with this library says of its LIGGGHTS, and of stamps."""
        (self.folder / "state.py").write_text(STATE.format(host=library, library=PLUGINS / "hostbuildlibrary.so",
                                                           stamps=stamps))
        result = grainjet.run(["/usr/bin/python3", "state.py"], self.folder)
        self.assertEqual(result.code, 0, result)
        lines = result.output.splitlines()
        return lines[0].removeprefix("stamp: "), [line.removeprefix("misfit:").strip() for line in lines[1:]]

    def test_script_and_process_say_the_same(self):
        """By build ID and, where there is none, by checksum; what is compiled with it then fits."""
        normal = host_version()
        self.assertRegex(normal, r"^LIGGGHTS-PUBLIC [0-9.]+, SMALLBIG [A-Za-z ]+, build [0-9a-f]{16,}$")
        other = host_library.copy(self.folder / "other", host_library.other_build)
        none = host_library.copy(self.folder / "none", host_library.no_build)
        self.assertRegex(host_version(none), r"^LIGGGHTS-PUBLIC [0-9.]+, SMALLBIG [A-Za-z ]+, checksum [0-9]+ [0-9]+$")

        stamps = [host_version(library) for library in (host_library.installed(), other, none)]
        self.assertEqual(stamps[0], normal)
        self.assertEqual(len(set(stamps)), 3, stamps)
        for n, library in enumerate((host_library.installed(), other, none)):
            stamp, misfits = self.stated(library, *stamps)
            self.assertEqual(stamp, stamps[n])
            for k, misfit in enumerate(misfits):
                if k == n:
                    self.assertEqual(misfit, "")
                else:
                    self.assertIn(f"was built for {stamps[k]}, but this is {stamps[n]}", misfit)

    def test_another_build_is_refused(self):
        (self.folder / "in.test").write_text("plugin list\n")
        for change in (host_library.other_build, host_library.no_build):
            library = host_library.copy(self.folder / change.__name__, change)
            for ranks in (0, 2):
                result = grainjet.run([*grainjet.mpirun(ranks), "liggghts-plugins", "-in", "in.test"], self.folder,
                                      env={"LIGGGHTS_ROOT": "", "LD_LIBRARY_PATH": str(library.parent)})
                self.assertFails(result, "The plugin loader was built for", host_version(),
                                 f"but this is {host_version(library)}", "./Allwmake")
                self.assertEqual(result.output.count("ERROR"), 1, result)
                self.assertNotIn("No plugins are loaded", result.output)

    def test_another_build_on_one_rank_only(self):
        library = host_library.copy(self.folder / "other", host_library.other_build)
        (self.folder / "in.test").write_text("plugin list\n")
        root = grainjet.mpirun(1)[1:-2]
        command = ["liggghts-plugins", "-in", "in.test"]
        other = ["env", "LIGGGHTS_ROOT=", f"LD_LIBRARY_PATH={library.parent}", *command]
        for first, second, rank in ((command, other, 1), (other, command, 0)):
            result = grainjet.run(["mpirun", *root, "-np", "1", *first, ":", "-np", "1", *second], self.folder, timeout=60)
            self.assertFails(result, f"but this is {host_version(library)}", f"(on rank {rank})")
            self.assertEqual(result.output.count("ERROR"), 1, result)

    def test_the_same_build_elsewhere_is_taken(self):
        library = host_library.copy(self.folder / "same", lambda content, parts: None)
        for ranks in (0, 2):
            (self.folder / "in.test").write_text("plugin list\n")
            result = grainjet.run([*grainjet.mpirun(ranks), "liggghts-plugins", "-in", "in.test"], self.folder,
                                  env={"LIGGGHTS_ROOT": "", "LD_LIBRARY_PATH": str(library.parent)})
            self.assertEqual(result.code, 0, result)
            self.assertIn("No plugins are loaded", result.output)


class Interposition(LoaderCase):

    def test_another_library_before_the_loader(self):
        (self.folder / "in.test").write_text("plugin list\n")
        first, loader = PLUGINS / "interposingcreate.so", grainjet.ROOT / "lib/liggghtsloader.so"
        for ranks in (0, 2):
            result = grainjet.run([*grainjet.mpirun(ranks), "env", f"LD_PRELOAD={first}:{loader}", "liggghts", "-in", "in.test"],
                                  self.folder, timeout=60)
            self.assertFails(result, "ERROR", "LAMMPS::create", str(first), str(loader), "comes first", "liggghts-plugins")
            self.assertEqual(result.code, 1, result)


if __name__ == "__main__":
    unittest.main()
