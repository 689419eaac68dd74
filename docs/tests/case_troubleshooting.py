# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/troubleshooting.md has each message that a user can meet, and none that no program says."""

import re
import subprocess
import unittest

import grainjet
from grainjet import messages

PAGE = grainjet.ROOT / "docs/troubleshooting.md"
ROOMS = ("openfoam-libs", "liggghts-plugins", "cases", "Allwmake", "Alltest", "Allwclean", "environment", "CMakeLists.txt")
# - `a message`, `another one`: what it means and what to do
# A fault of Grainjet's own, names of arguments in an error that has words of its own, lines of a log or a table
NOT_MET = {"spectra of other edges", "fluid density rho (kg/m3)", "specific heat cp of the fluid (J/(kg K))",
           "LIGGGHTS...variable continued equal 1", "; gasMass [kg]: between the grains, with its debts, after the step before",
           "m/s and a Courant number of", "k...pressureGradient with turbulentPressure yes...turbulentPressure no",
           ", particles of diameter ... to ... m"}
ITEM = re.compile(r"(?ms)^- ((?:`[^`]+`,?\s+)*`[^`]+`):\s+(.+?)(?=^- |^#|\n\n|\Z)")


def entries(page):
    """(its messages, the explanation) of each item of the page."""
    return [(re.sub(r"\s+", " ", match[1])[1:-1].split("`, `"), match[2]) for match in ITEM.finditer(page)]


def shows(pattern, text):
    """Whether a message of the page, with ... for what varies, is that of a source: its parts in their order."""
    at = 0
    for part in pattern.split("..."):
        found = text.find(part.strip(), at)
        if found < 0:
            return False
        at = found + len(part.strip())
    return True


def all_messages():
    listed = subprocess.run(["git", "-c", f"safe.directory={grainjet.ROOT}", "ls-files", "-z", *ROOMS], cwd=grainjet.ROOT,
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if listed.returncode == 0:
        paths = [grainjet.ROOT / name for name in listed.stdout.decode().split("\0") if name]
    else:
        paths = [path for room in ROOMS for path in ([grainjet.ROOT / room] if (grainjet.ROOT / room).is_file()
                                                     else (grainjet.ROOT / room).rglob("*"))]
    return [message for path in sorted(paths) if path.is_file() and "tests" not in path.parts and "lnInclude" not in path.parts
            for message in messages.of_file(path)]


class Troubleshooting(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.said = all_messages()
        cls.page = PAGE.read_text()
        cls.entries = entries(cls.page)

    def test_messages_are_found(self):
        """One of each kind of source, so that a reader that finds nothing does not pass."""
        texts = [message.text.replace(messages.HOLE, "...") for message in self.said]
        for text in ("The mesh is a ... (entry dynamicFvMesh of",                      # OpenFOAM
                     "is given twice; state it once",                                  # LIGGGHTS
                     "the compiler '...' is not there",                                # shell
                     "reads no TOML: install the package python3-tomli",               # Python
                     "reaches beyond the box of grains, boxRadius =",                  # Python without .py
                     "has no line like: #define GRAINJET_VERSION"):                    # CMake
            self.assertTrue(any(text in other for other in texts), text)
        self.assertGreater(sum(message.is_sentence() for message in self.said), 400)

    def test_each_message_is_on_the_page(self):
        patterns = [pattern for found, _ in self.entries for pattern in found]
        missing = [f"{message.file}:{message.line}: {message.text.replace(messages.HOLE, '...')}" for message in self.said
                   if message.is_sentence() and message.text.replace(messages.HOLE, "...") not in NOT_MET and not any(shows(pattern, message.text) for pattern in patterns)]
        self.assertFalse(missing, f"{len(missing)} messages are not in {PAGE.name}:\n" + "\n".join(missing))

    def test_each_message_of_the_page_is_said(self):
        stale = [pattern for found, _ in self.entries for pattern in found
                 if not any(shows(pattern, message.text) for message in self.said)]
        self.assertFalse(stale, "no source says this:\n" + "\n".join(stale))

    def test_messages_of_the_page_can_be_told_apart(self):
        vague = [pattern for found, _ in self.entries for pattern in found if len(re.findall("[A-Za-z]", pattern)) < 9]
        self.assertFalse(vague, "too few letters to find a message by")

    def test_all_items_are_read(self):
        """An item in another form would be passed over."""
        items = [line for line in self.page.splitlines() if line.startswith("- `")]
        self.assertEqual(len(items), len(self.entries))


if __name__ == "__main__":
    unittest.main()
