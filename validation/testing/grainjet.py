"""What the case-level tests share: running the real programs in a fresh folder.

Tests are plain `unittest` files; this module holds no physics and no tolerances.
"""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def environment():
    """The environment a user has after `source environment`."""
    printed = subprocess.run(
        ["bash", "-c", f"source '{ROOT}/environment' && env -0"],
        check=True, stdout=subprocess.PIPE).stdout.decode()
    env = dict(item.split("=", 1) for item in printed.split("\0") if "=" in item)
    env["OMPI_MCA_rmaps_base_oversubscribe"] = "1"   # more ranks than cores is a normal test
    env["OMPI_MCA_mpi_yield_when_idle"] = "1"        # and waiting ranks let the others work
    env["OMPI_MCA_btl_vader_single_copy_mechanism"] = "none"
    return env


ENV = environment()


def mpirun(ranks):
    """The command prefix for a parallel run, empty for 0 ranks (no mpirun at all)."""
    if not ranks:
        return []
    root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    return ["mpirun", *root, "-np", str(ranks)]


def liggghts_examples():
    """The folder of LIGGGHTS' own tutorials, of the installed version; fetched on first use and then kept."""
    fetch = subprocess.run([ROOT / "openfoam-libs/tools/debian-source", "liggghts", "examples"],
                           stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if fetch.returncode:
        raise AssertionError(f"no sources of LIGGGHTS to take its examples from:\n{fetch.stderr}")
    return pathlib.Path(fetch.stdout.strip()) / "examples/LIGGGHTS/Tutorials_public"


class Run:
    """Exit code and output of a finished program."""

    def __init__(self, code, output):
        self.code, self.output = code, output

    def __repr__(self):
        return f"exit code {self.code}\n{self.output}"


def run(command, folder, timeout=600, env=None):
    """Run a command in a folder; a hang is a failure, with what had been printed."""
    process = subprocess.Popen(
        [str(c) for c in command], cwd=folder, env={**ENV, "PWD": str(folder), **(env or {})},
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        start_new_session=True)
    try:
        output, _ = process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        output, _ = process.communicate()
        raise AssertionError(
            f"no end after {timeout} s: {command}\n{output.decode(errors='replace')[-3000:]}")
    return Run(process.returncode, output.decode(errors="replace"))


class Case(unittest.TestCase):
    """A test with a fresh folder of its own, kept if GRAINJET_KEEP is set."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="grainjet-"))

    def tearDown(self):
        if os.environ.get("GRAINJET_KEEP"):
            print(f"kept: {self.folder}")
        else:
            shutil.rmtree(self.folder, ignore_errors=True)

    def liggghts(self, script, ranks=0, program="liggghts-plugins", args=(), check=True, name="in.test"):
        """Run an input script (text) under the launcher; 0 ranks: without mpirun."""
        (self.folder / name).write_text(script)
        result = run([*mpirun(ranks), program, "-in", name, *args], self.folder)
        if check:
            self.assertEqual(result.code, 0, result)
        return result

    def foam(self, solver, case=None, ranks=0, check=True, timeout=600):
        """Run an OpenFOAM program in a case folder; in parallel on `ranks` ranks if not 0."""
        parallel = ["-parallel"] if ranks else []
        result = run([*mpirun(ranks), solver, *parallel], case or self.folder, timeout)
        if check:
            self.assertEqual(result.code, 0, result)
        return result

    def assertFails(self, result, *words):
        """The run ended by itself with a code other than 0 and printed all these words."""
        self.assertNotEqual(result.code, 0, result)
        for word in words:
            self.assertIn(word, result.output)
