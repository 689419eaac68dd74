# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The stock program's own example scripts with `pair_style gran model hertz`: the pair style goes out, the fix
comes in with the same words, nothing else changes. Both ways give the same energies and numbers of grains.

A measure of how far round-off may have grown is the stock program itself with its grains in another order
in memory: the plugin has to stay as close to it as that does, but for a factor 100, which allows for where the
first digits happen to change. By default the stock program remembers tangential springs of grains that have
parted until its next list; `neigh_modify contact_distance_factor` makes it forget at once, as the plugin does."""

import re
import shutil
import unittest

import grainjet
from grainjet import tables

# folder, script, step at which long runs end
RUN = (
    ("chute_wear", "in.chute_wear", 24000),
    ("cohesion", "in.cohesion", 10000),
    ("cohesion", "in.noCohesion", 10000),
    ("contactModels", "in.newModels", 4000),
    ("conveyor", "in.conveyor", 30000),
    ("heatTransfer_1", "in.heatGran", 6000),
    ("heatTransfer_2", "in.heatGran", 6000),
    ("hydrogel_multicontact", "in.hydrogel_default", 3000),
    ("insert_stream", "in.insert_stream", 20000),
    ("mesh_tet", "in.mesh_tet", 1000),
    ("packing", "in.packing", 20000),
)

# what is refused, and the words of the remedy
REFUSED = (
    ("multisphere_stone_restitution", "in.multisphere", ("multispheres", "use `pair_style gran`")),
    ("hydrogel_multicontact", "in.hydrogel_multicontact", ("surface must be default",)),
)


def with_fix(text):
    """The two edits of the recipe."""
    style = re.search(r"(?m)^\s*pair_style\s+gran\s+([^#\n]*).*$", text)
    text = text.replace(style.group(0), "plugin load hertzcgplugin.so")
    return re.sub(r"(?m)^\s*pair_coeff.*$", f"fix contacts all hertz/cg {style.group(1)}", text)


def counted(text):
    return with_fix(text) + '\nvariable met equal f_contacts[2]\nprint "collisions: ${met}."\n'


def forgetful(text):
    return re.sub(r"(?m)^(\s*pair_coeff.*)$", r"\1\nneigh_modify contact_distance_factor 1.05", text)


def reordered(text):
    return re.sub(r"(?m)^(\s*create_box.*)$", r"\1\natom_modify sort 0 0", text)


class StockExamples(grainjet.Case):

    def run_example(self, example, script, steps, name, edit, ranks=0, check=True):
        folder = self.folder / f"{example}-{script}-{name}"
        shutil.copytree(grainjet.liggghts_examples() / example, folder)
        (folder / "post").mkdir(exist_ok=True)
        text = (folder / script).read_text()
        if steps:
            text = re.sub(r"(?m)^run\s+(\d{4,}|\$\{\w+\})(\s+upto)?\s*$", f"run {steps} upto", text)
            text = re.sub(r"(?m)^thermo\s+\d+", "thermo 1000", text)
        (folder / script).write_text(edit(text))
        result = grainjet.run([*grainjet.mpirun(ranks), "liggghts-plugins", "-in", script], folder)
        if check:
            self.assertEqual(result.code, 0, result)
        return result

    def test_two_lines_changed(self):
        for example, script, steps in RUN:
            with self.subTest(script=script):
                stock = tables.thermo(self.run_example(example, script, steps, "stock", forgetful).output)
                other = tables.thermo(self.run_example(example, script, steps, "other", lambda t: reordered(forgetful(t))).output)
                printed = self.run_example(example, script, steps, "plugin", counted).output
                mine = tables.thermo(printed)
                collisions = int(re.search(r"(?m)^collisions: (\d+)", printed).group(1))
                self.assertGreater(len(stock), 3)
                self.assertEqual(len(stock), len(mine))
                equal, worst = 0, 0.0
                largest = [max(abs(row[k]) for row in stock) or 1.0 for k in range(len(stock[0]))]
                for a, b, c in zip(stock, other, mine):
                    self.assertEqual(a[:2], c[:2], "step and number of grains")
                    control = max(abs(x - y) / s for x, y, s in zip(a[2:], b[2:], largest[2:]))
                    difference = max(abs(x - y) / s for x, y, s in zip(a[2:], c[2:], largest[2:]))
                    # printed with 8 digits
                    self.assertLessEqual(difference, 100 * control + 1e-7, (script, a, b, c))
                    equal += control < 1e-4
                    worst = max(worst, difference)
                print(f"{script}: {int(stock[-1][1])} grains, {collisions} collisions, largest difference {worst:.1e}, "
                      f"{equal} of {len(stock)} rows before chaos")
                self.assertGreaterEqual(collisions, 5, "nothing is compared")
                self.assertGreater(equal, 3, "too wild to show anything")

    def test_continued_from_a_restart_file(self):
        """in.insert_stream_reset_timestep reads what in.insert_stream has written. A file of the stock program brings
        its pair style along, which has to be taken out."""
        for written_by in ("plugin", "stock"):
            first = self.run_example("insert_stream", "in.insert_stream", 8000, written_by,
                                     with_fix if written_by == "plugin" else str)
            self.assertIn("write_restart", first.output + (self.folder / f"insert_stream-in.insert_stream-{written_by}"
                                                           / "in.insert_stream").read_text())
            folder = self.folder / f"insert_stream-in.insert_stream-{written_by}"
            text = (folder / "in.insert_stream_reset_timestep").read_text()
            text = with_fix(re.sub(r"(?m)^run\s+\d{4,}.*$", "run 2000", text))
            if written_by == "stock":
                text = re.sub(r"(?m)^(fix contacts .*)$", r"pair_style none\n\1", text)
            (folder / "in.continued").write_text(text)
            result = grainjet.run(["liggghts-plugins", "-in", "in.continued"], folder)
            self.assertEqual(result.code, 0, result)
            self.assertGreater(tables.thermo(result.output)[-1][1], 20)

    def test_what_is_refused_says_so(self):
        for example, script, words in REFUSED:
            with self.subTest(script=script):
                result = self.run_example(example, script, 0, "plugin", with_fix, check=False)
                self.assertFails(result, "ERROR", "hertz/cg", *words)


if __name__ == "__main__":
    unittest.main()
