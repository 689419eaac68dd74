# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the loader's tests share: their plugins and a script with nothing but a box."""

import grainjet
from grainjet import tables

PLUGINS = grainjet.ROOT / "lib/tests"

BOX = """
units si
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
region box block 0 1 0 1 0 1
create_box 1 box
neighbor 0.1 bin
timestep 1e-5
"""

# five steps counted from 3
COUNT = """
fix count all plugin/example 3
thermo_style custom step f_count
run 5
"""

USE = BOX + COUNT


def counts(output):
    """(step, value of fix `count`) of all thermo lines of a run's output."""
    return [tuple(row) for row in tables.thermo(output)]


class LoaderCase(grainjet.Case):
    """A folder in which the example plugin may be linked under its own or other names."""

    def plugin(self, name="exampleplugin.so", to=None, folder=""):
        target = self.folder / folder / (to or name)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes((PLUGINS / name).read_bytes())
        return target

    def each(self, script, **keywords):
        """The runs of a script without mpirun and on 2 ranks."""
        for ranks in (0, 2):
            yield self.liggghts(script, ranks=ranks, **keywords)

    def assertRefused(self, script, *words, **keywords):
        """Ends with one error that holds the words, without mpirun and on 2 ranks."""
        for result in self.each(script, check=False, **keywords):
            self.assertFails(result, *words)
            errors = result.errors
            self.assertEqual(len(errors), 1, result)
            for word in words:
                self.assertIn(word, errors[0])
