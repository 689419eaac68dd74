# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The real programs, run as a user runs them: with the environment of `source environment`."""

import os
import pathlib
import signal
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]


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


def openfoam_library(name):
    """A library for OpenFOAM, as programs find it: in lib, or in FOAM_USER_LIBBIN where it was built for that."""
    for folder in ENV["LD_LIBRARY_PATH"].split(":"):
        file = pathlib.Path(folder, f"{name}.so")
        if folder and file.is_file():
            return file
    raise AssertionError(f"no {name}.so in {ENV['LD_LIBRARY_PATH']}: run ./Allwmake")


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

    @property
    def errors(self):
        """The lines in which LIGGGHTS reports an error."""
        return [line for line in self.output.splitlines() if "ERROR" in line]

    def __repr__(self):
        return f"exit code {self.code}\n{self.output}"


def _popen(command, folder, env, stdout):
    return subprocess.Popen(
        [str(c) for c in command], cwd=folder, env={**ENV, "PWD": str(folder), **(env or {})},
        stdin=subprocess.DEVNULL, stdout=stdout, stderr=subprocess.STDOUT, start_new_session=True)


def run(command, folder, timeout=600, env=None):
    """Run a command in a folder; a hang is a failure, with what had been printed."""
    process = _popen(command, folder, env, subprocess.PIPE)
    try:
        output, _ = process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, _ = process.communicate()
        raise AssertionError(
            f"no end after {timeout} s: {command}\n{output.decode(errors='replace')[-3000:]}")
    return Run(process.returncode, output.decode(errors="replace"))


def done(command, folder, log, timeout=7200):
    """Run a program that must succeed; its output goes to a file in the folder, and is returned."""
    result = run(command, folder, timeout)
    (folder / log).write_text(result.output)
    if result.code:
        raise SystemExit(f"{command[0]} failed, see {folder / log}\n{result.output[-3000:]}")
    return result.output


class Started:
    """A program that works while the test goes on; its output goes to a file. Used in `with`, which
    kills it at the end, with all its processes."""

    def __init__(self, command, folder, log, env=None):
        self.command, self.log = command, pathlib.Path(log)
        with open(self.log, "w") as file:
            self.process = _popen(command, folder, env, file)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.kill()

    def kill(self):
        """End it and all its processes at once, by a signal that no program can catch."""
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()

    def printed(self):
        """What it has printed so far."""
        return self.log.read_text(errors="replace")

    def wait_for(self, condition, what, seconds=120):
        """Wait until a condition holds; what it returned. It is asked again and again, so that no speed of the
        machine matters. A failure: the program ends before, or the time is over."""
        deadline = time.monotonic() + seconds
        while True:
            ended = self.process.poll() is not None      # before the last look
            found = condition()
            if found:
                return found
            if ended or time.monotonic() > deadline:
                raise AssertionError(
                    f"{what} did not come {'before the end' if ended else f'within {seconds} s'} of {self.command}:\n"
                    f"{self.printed()[-3000:]}")
            time.sleep(0.01)

    def wait_for_words(self, words, start=0, seconds=120):
        """Wait until it has printed words, behind a place in its output; the output."""
        return self.wait_for(lambda: (lambda text: text if words in text[start:] else "")(self.printed()),
                             f"'{words}'", seconds)


def start(command, folder, log, env=None):
    """Start a command in a folder: Started."""
    return Started(command, folder, log, env)
