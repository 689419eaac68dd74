# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""LIGGGHTS of another build, and libraries that come before the coupling: errors with words, exit code 1."""
# processors: 2

import re
import subprocess
import unittest

import bad_case
import grainjet
from grainjet import host_library

TESTS = grainjet.ROOT / "lib/tests"
COUPLING = grainjet.openfoam_library("libliggghtsCoupling")


class Host(bad_case.BadCase):

    def refused(self, *words, **variables):
        """Serial and on 2 ranks, with these environment variables in front of the usual ones."""
        for ranks in (0, 2):
            folder = self.fresh()
            settings = [f"{name}={value}" for name, value in variables.items()]
            command = ["env", *settings, "pimpleFoam", *(["-parallel"] if ranks else [])]
            result = grainjet.run([*grainjet.mpirun(ranks), *command], folder, timeout=60)
            with self.subTest(variables=variables, ranks=ranks):
                self.assertEqual(result.code, 1, result)
                self.assertFails(result, "FOAM FATAL", *words)

    def test_another_build(self):
        version = subprocess.run([grainjet.ROOT / "liggghts-plugins/loader/host-version"],
                                 check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
        usual = grainjet.ENV["LD_LIBRARY_PATH"]
        for change in (host_library.other_build, host_library.no_build):
            library = host_library.copy(self.folder / change.__name__, change)
            self.refused(f"The coupling was built for {version}, but this is", "./Allwmake",
                         LD_LIBRARY_PATH=f"{library.parent}:{usual}")

    def test_another_library_brings_a_function(self):
        for name, function in (("interposingcreate", "LAMMPS::create"), ("interposingerror", "Error::all")):
            library = TESTS / f"{name}.so"
            self.refused(f"takes its function {function} from {library} and not from {COUPLING}", "LD_PRELOAD", "libs",
                         LD_PRELOAD=library)

    def test_liggghts_comes_first(self):
        library = host_library.installed()
        self.refused(f"from {library} and not from {COUPLING}", "LD_PRELOAD", LD_PRELOAD=library)

    def test_liggghts_is_an_earlier_entry_of_libs(self):
        library = host_library.installed()
        for ranks in (0, 2):
            folder = self.fresh()
            self.change(folder, "system/controlDict", ('libs ("lib', f'libs ("{library}" "lib'))
            self.assertRefused(folder, f"from {library} and not from {COUPLING}", "libs in system/controlDict", ranks=ranks)

    def test_liggghts_calls_itself(self):
        library = host_library.copy(self.folder / "symbolic", host_library.symbolic)
        self.refused("calls its own functions", "-Bsymbolic",
                     LD_LIBRARY_PATH=f"{library.parent}:{grainjet.ENV['LD_LIBRARY_PATH']}")

    def test_mpirun_without_parallel(self):
        """Each rank would compute the whole flow, and LIGGGHTS share the grains among them."""
        folder = self.fresh()
        result = grainjet.run([*grainjet.mpirun(2), "pimpleFoam"], folder, timeout=60)
        self.assertFails(result, "FOAM FATAL", "mpirun has started 2 ranks, but the solver computes on 1", "-parallel")
        self.assertEqual(result.output.count("FATAL ERROR"), 1, result)
        result = grainjet.run(["env", "PMI_SIZE=2", "pimpleFoam"], folder, timeout=60)
        self.assertFails(result, "FOAM FATAL", "mpirun of another MPI has started 2 ranks")

    def test_a_preloaded_loader_does_no_harm(self):
        for ranks in (0, 2):
            folder = self.fresh()
            result = grainjet.run(
                [*grainjet.mpirun(ranks), "env", f"LD_PRELOAD={grainjet.ROOT}/lib/liggghtsloader.so", "pimpleFoam",
                 *(["-parallel"] if ranks else [])], folder, timeout=60)
            self.assertEqual(result.code, 0, result)
            self.assertIn("\nEnd", result.output)

    def test_all_functions_of_the_error_hook_are_checked(self):
        symbols = subprocess.run(["nm", "-D", "--defined-only", COUPLING], check=True, stdout=subprocess.PIPE, text=True)
        defined = {line.split()[-1] for line in symbols.stdout.splitlines() if "_ZN9LAMMPS_NS5Error" in line}
        source = (grainjet.ROOT / "openfoam-libs/liggghtsCoupling/session/liggghtsSessionEnds.C").read_text()
        self.assertEqual(set(re.findall(r'"(_ZN9LAMMPS_NS5Error\w+)"', source)), defined)


if __name__ == "__main__":
    unittest.main()
