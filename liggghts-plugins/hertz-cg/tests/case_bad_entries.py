# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""Every word of fix hertz/cg spoilt in every way: one error each that names the fix, and no run."""

import concurrent.futures
import unittest

import granular as g
import grainjet
from grainjet import bad_input, pages
from grainjet.bad_input import Entry

ENTRIES = {
    "model": Entry("choice", "hertz"),
    "surface": Entry("choice", "default"),
    "tangential": Entry("choice", "history", required=True),    # after `model hertz`
    "rolling": Entry("choice", "epsd", required=True),          # for torsionTorque
    "torsionTorque": Entry("on", "on"),
    "limitForce": Entry("on", "on"),
    "tangential_damping": Entry("on", "off"),
    "cohesion": Entry("choice", "sjkr", required=True),         # for tangential_reduce
    "tangential_reduce": Entry("on", "on"),
    "timestep_check": Entry("check", "10 0.5 warn"),
    "overlap_check": Entry("positive", "0.1"),
}
KINDS = {
    "on": [("another word", "perhaps"), ("yes", "yes"), ("a number", "1")],
    "check": [(f"steps: {what}", f"{text} 0.5 warn", must) for what, text, must in bad_input.values("count")
              if what != "a thousand million"]
    + [(f"fraction: {what}", f"10 {text} warn", must) for what, text, must in bad_input.values("positive")]
    + [("another action", "10 0.5 stop"), ("no action", "10 0.5"), ("no fraction", "10")],
}


class BadEntries(grainjet.Case):

    def setUp(self):
        super().setUp()
        (self.folder / "data").write_text(g.assembly(20, 0.0085, (0.001, 0.0014), speed=0.5, spin=300))

    def end(self, line, ranks=0, name="in.test"):
        script = (g.load(g.PLUGIN) + g.head() + "read_data data\nneighbor 0.0005 bin\n" + g.MATERIAL
                  + f"fix c all hertz/cg {line}\nfix i all nve/sphere\ntimestep 1e-7\nrun 2\n")
        return self.liggghts(script, ranks, check=False, name=name, args=["-log", "none"])

    def test_the_page_has_these_entries(self):
        page = (grainjet.ROOT / "docs/fix_hertz_cg.md").read_text()
        names = [name.split()[0] for name in pages.table_of_page(page, "Syntax")]
        self.assertEqual([name for name in names if name != "rolling_friction"], list(ENTRIES))

    def test_each_entry(self):
        every = bad_input.spoil(ENTRIES, KINDS)
        lines = [" ".join(f"{key} {value}" for key, value in bad.replace(ENTRIES)) for bad in every]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda n: self.end(lines[n], name=f"in.{n}"), range(len(lines))))
        for bad, result in zip(every, results):
            with self.subTest(f"{bad.entry}: {bad.what}"):
                errors = result.errors
                if bad.must_fail:
                    self.assertEqual(result.code, 1, result)
                    self.assertEqual(len(errors), 1, result)
                    self.assertIn("ix hertz/cg (ID c)", errors[0])
                else:
                    self.assertEqual((result.code, errors), (0, []), result)

    def test_good_ones(self):
        line = " ".join(f"{key} {entry.good}" for key, entry in ENTRIES.items())
        for ranks in (0, 2):
            self.assertEqual(self.end(line, ranks).code, 0)


if __name__ == "__main__":
    unittest.main()
