# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""Libraries that are cut short, half written, empty or no libraries: one message, no crash."""

import random
import unittest

import grainjet
from loadercase import LoaderCase


def damaged(whole):
    """(what is wrong, contents): a file as a full disk or an interrupted copy leaves it."""
    size = len(whole)
    page = 4096
    # headers, then spread over the file, then around the last pages, which hold what the linker changes
    ends = [1, 63, 64, 500] + [size * i // 8 for i in range(1, 8)] + [size - 3 * page, size - page, size - 64, size - 1]
    yield "empty", b""
    for end in ends:
        yield f"ends after {end} bytes", whole[:end]
    for end in (0, 64, size // 3, size - page):
        yield f"zeros from {end} on", whole[:end] + bytes(size - end)
    yield "random bytes", random.Random(1).randbytes(size)
    yield "random bytes after the start", whole[:16] + random.Random(2).randbytes(size - 16)
    yield "text", b"plugin load me\n" * 500


class DamagedPlugin(LoaderCase):

    def refused(self, contents, ranks):
        path = self.folder / "exampleplugin.so"
        path.write_bytes(contents)
        result = self.liggghts("plugin load exampleplugin.so\n", ranks=ranks, check=False)
        self.assertGreater(result.code, 0, result)      # not by a signal
        errors = result.errors
        self.assertEqual(len(errors), 1, result)
        self.assertRegex(errors[0], "is damaged|cannot be loaded")
        self.assertIn(str(path.resolve()), errors[0])

    def test_serial(self):
        whole = self.plugin().read_bytes()
        for what, contents in damaged(whole):
            with self.subTest(what):
                self.refused(contents, 0)

    def test_two_ranks(self):
        whole = self.plugin().read_bytes()
        for contents in (b"", whole[:64], whole[:len(whole) // 2], whole[:-1]):
            with self.subTest(len(contents)):
                self.refused(contents, 2)

    def test_message_names_both_sizes(self):
        whole = self.plugin().read_bytes()
        (self.folder / "exampleplugin.so").write_bytes(whole[:5000])
        self.assertRefused("plugin load exampleplugin.so\n", "ends after 5000 bytes", f"should have {len(whole)}")


class DamagedLoader(LoaderCase):

    def setUp(self):
        super().setUp()
        for source in ("bin/liggghts-plugins", "lib/liggghtsloader.so"):
            target = self.folder / "copy" / source
            target.parent.mkdir(parents=True)
            target.write_bytes((grainjet.ROOT / source).read_bytes())
            target.chmod(0o755)

    def test_runs_or_says_so(self):
        """What is missing at the very end are tables that nobody needs: then it works."""
        loader = self.folder / "copy/lib/liggghtsloader.so"
        (self.folder / "in.test").write_text("plugin list\n")
        refused = 0
        for what, contents in damaged(loader.read_bytes()):
            with self.subTest(what):
                loader.write_bytes(contents)
                result = grainjet.run([self.folder / "copy/bin/liggghts-plugins", "-in", "in.test"], self.folder)
                if result.code == 0:
                    self.assertIn("No plugins are loaded", result.output)
                    continue
                refused += 1
                self.assertEqual(result.code, 1, result)
                self.assertFails(result, str(loader), "cannot be loaded", "./Allwmake")
                self.assertEqual(result.output.count("liggghts-plugins:"), 1, result)
        self.assertGreater(refused, 10)


if __name__ == "__main__":
    unittest.main()
