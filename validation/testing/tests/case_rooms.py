# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The house rules that can be checked without running anything.

Dependencies run one way, source files stay short and begin with a banner of one style, one thing has one name,
nothing generated is kept.
"""

import os
import pathlib
import re
import subprocess
import unittest

import grainjet
from grainjet import host_library

SOURCES = {".cpp", ".h", ".C", ".H"}
LINES = 400                     # longer files hold more than one responsibility
BANNER = ("Grainjet: coarse-grained CFD-DEM for particle-laden jets",
          "Copyright (C) 2026 The Grainjet developers",
          "SPDX-License-Identifier: GPL-3.0-or-later")
# each has a word of the field: owner, remote, send, receive, add, remove, exchange
WORDS = re.compile(r"(?i)(?<![a-z])(?:guest|visitor|travel+er|travelling|homeless|admit|doors?(?![a-z])|soon\()")
INCLUDE = re.compile(r'(?m)^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def kept():
    """All files of the project: tracked ones, or without git all that are no product."""
    listed = subprocess.run(["git", "-c", f"safe.directory={grainjet.ROOT}", "ls-files", "-z"],
                            cwd=grainjet.ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if listed.returncode == 0:
        paths = [grainjet.ROOT / name for name in listed.stdout.decode().split("\0") if name]
        return [path for path in paths if path.is_file()]
    skipped = {"build", "lib", "bin", "lnInclude", "__pycache__"}
    return [path for path in grainjet.ROOT.rglob("*")
            if path.is_file() and not skipped & set(path.relative_to(grainjet.ROOT).parts)]


def sources(folder=""):
    return [path for path in kept()
            if path.suffix in SOURCES and (grainjet.ROOT / folder) in path.parents]


def includes(path):
    return INCLUDE.findall(path.read_text())


def named(path):
    return str(path.relative_to(grainjet.ROOT))


class Rooms(unittest.TestCase):

    def assertNone(self, offenders, rule):
        self.assertFalse(offenders, f"{rule}:\n" + "\n".join(offenders))

    def test_physics_includes_only_itself(self):
        """physics/ is shared by both halves: standard headers and its own only."""
        physics = grainjet.ROOT / "liggghts-plugins/physics"
        allowed = re.compile(r"[a-z_]+|gtest/gtest\.h|(float|math|stdint|stddef)\.h")

        def own(path, name):
            return name.startswith("physics/") or physics in (path.parent / name).resolve().parents

        self.assertNone(
            [f"{named(path)}: {name}" for path in sources("liggghts-plugins/physics")
             for name in includes(path) if not allowed.fullmatch(name) and not own(path, name)],
            "physics/ includes something else than itself and the standard library")

    def test_plugins_know_no_openfoam(self):
        self.assertNone(
            [f"{named(path)}: {name}" for path in sources("liggghts-plugins")
             for name in includes(path) if name.endswith((".H", ".C"))],
            "liggghts-plugins includes OpenFOAM")

    def test_openfoam_libraries_see_liggghts_only_through_interfaces(self):
        """Physics, the exchange with fix fluid/force and fluid/heat and the loader; not a plugin's insides."""
        interfaces = re.compile(r"physics/.*|loader/.*|host/.*|fluid-(force|heat)/fluid_(force|heat)_exchange\.h")
        rooms = {path.name for path in (grainjet.ROOT / "liggghts-plugins").iterdir() if path.is_dir()}
        self.assertNone(
            [f"{named(path)}: {name}" for path in sources("openfoam-libs") for name in includes(path)
             if name.split("/")[0] in rooms and not interfaces.fullmatch(name)],
            "openfoam-libs includes the inside of a plugin")

    def test_classes_of_liggghts_are_not_declared_anew(self):
        """A second declaration is not compared with the first by anyone, and results are wrong without a word."""
        body = re.compile(r"(?m)^[ \t]*(?:class|struct)\s+(\w+)[^;{()]*\{")
        headers = list((host_library.part("-headers") / "liggghts").glob("*.h"))
        theirs = {name for header in headers for name in body.findall(header.read_text(errors="replace"))}
        # ours without those within another class, which are indented
        outer = re.compile(body.pattern.replace("[ \\t]*", ""))
        self.assertLessEqual({"Fix", "FixWallGran", "Input", "LAMMPS", "Modify"}, theirs)

        plugins = [path for path in sources("liggghts-plugins") if "LAMMPS_NS" in path.read_text()]
        session = [path for path in sources("openfoam-libs") if "LAMMPS_NS" in path.read_text()]
        self.assertTrue(plugins and session)
        self.assertNone(
            [f"{named(path)}: {name}" for path in plugins + session for name in outer.findall(path.read_text()) if name in theirs],
            "a class of LIGGGHTS is declared anew")

    def test_members_of_liggghts_are_reached_in_one_way(self):
        """By grainjet::Expose of one header: no second template for it, no other keyword for private."""
        tricks = re.compile(r"#\s*define\s+(?:private|protected)\b|friend typename Tag::type|-fno-access-control")
        self.assertEqual(
            [named(path) for path in sources() if tricks.search(path.read_text())], ["liggghts-plugins/host/expose_member.h"])

    def test_source_files_are_short(self):
        self.assertNone(
            [f"{named(path)}: {count} lines" for path in sources()
             if (count := len(path.read_text().splitlines())) > LINES],
            f"files of more than {LINES} lines")

    def test_one_banner_per_language(self):
        """OpenFOAM's in openfoam-libs, that of LAMMPS in liggghts-plugins, comments in scripts and CMake files."""
        scripts = {".py", ".sh", ".cmake"}

        def expected(path, text):
            if path.suffix in {".C", ".H"}:
                return "/*" + 75 * "-" + "*\\\n" + "".join(f"    {line}\n" for line in BANNER)
            if path.suffix in {".cpp", ".h"}:
                return "/* " + 70 * "-" + "\n" + "".join(f"   {line}\n" for line in BANNER) + 73 * "-" + " */\n"
            if path.suffix in scripts or text.startswith("#!") or path.name in ("CMakeLists.txt", "environment"):
                first = text[:text.index("\n") + 1] if text.startswith("#!") else ""
                return first + "".join(f"# {line}\n" for line in BANNER)
            return ""

        texts = [(path, path.read_text(errors="replace")) for path in kept() if path.suffix != ".png"]
        checked = [(path, text) for path, text in texts if expected(path, text)]
        self.assertLessEqual({"openfoam-libs", "liggghts-plugins", "cases", "validation"},
                             {path.relative_to(grainjet.ROOT).parts[0] for path, _ in checked})
        self.assertNone([named(path) for path, text in checked if not text.startswith(expected(path, text))],
                        "another banner, or none")

    def test_one_name_for_one_thing(self):
        self.assertNone(
            [f"{named(path)}: {line.strip()}" for path in kept()
             if path.suffix in SOURCES | {".py", ".md", ".sh"} and path != pathlib.Path(__file__).resolve()
             for line in path.read_text().splitlines() if WORDS.search(line)],
            "words that the project does not use")

    def test_tests_share_by_the_package_and_wait_for_conditions(self):
        """What several test folders need is in the package grainjet; no test imports another one."""
        refused = re.compile(r"(?m)^.*(?:\bsys\.path\b|\btime\.sleep\b|^\s*(?:import|from) case_\w+).*$")
        self.assertNone(
            [f"{named(path)}: {found}" for path in kept()
             if path.suffix == ".py" and "tests" in path.parts and path != pathlib.Path(__file__).resolve()
             for found in refused.findall(path.read_text())],
            "a test changes Python's path, sleeps, or imports another test")

    def test_no_products_are_kept(self):
        products = {".o", ".so", ".a", ".dep", ".pyc", ".log"}
        self.assertNone([named(path) for path in kept() if path.suffix in products], "products in the repository")

    def test_programs_can_be_started(self):
        """Files with a first line that names an interpreter are executable, shell ones parse."""
        for path in kept():
            with path.open("rb") as file:
                first = file.readline()
            if not first.startswith(b"#!"):
                continue
            self.assertTrue(os.access(path, os.X_OK), f"{named(path)} is not executable")
            shell = pathlib.Path(first.decode().split()[-1]).name
            if shell in ("sh", "bash"):
                checked = subprocess.run([shell, "-n", str(path)], stderr=subprocess.PIPE, text=True)
                self.assertEqual(checked.returncode, 0, checked.stderr)


if __name__ == "__main__":
    unittest.main()
