# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""Bookkeeping of fix hertz/cg: kinetic + elastic + dissipated energy of grains in a periodic box."""

import re
import unittest

import granular as g
from grainjet import Case


class Energy(Case):

    def energies(self, ranks=0, dt=5e-7, time=6e-3, factor=1, rolling="off", tangential="history", e=None,
                 end="", source="read_data data\n", words=""):
        """Rows of (kinetic, elastic, dissipated, contacts now, collisions) over the run."""
        material = g.MATERIAL
        if e is not None:
            material = re.sub(r"(coefficientRestitution peratomtypepair 2).*", rf"\1 {e} {e} {e} {e}", material)
        steps = round(time / dt)
        result = self.liggghts(
            g.load(g.PLUGIN) + g.head(more=f"coarsegraining {factor}\n") + source
            + "neighbor 0.0005 bin\n" + material + g.contacts(g.PLUGIN, tangential, rolling, words=words)
            + f"""fix i all nve/sphere
timestep {dt}
compute k all ke
compute r all erotate/sphere
variable k equal c_k+c_r
variable e equal f_c[6]
variable d equal f_c[7]
variable n equal f_c[1]
variable c equal f_c[2]
fix out all print {steps // 20} "row ${{k}} ${{e}} ${{d}} ${{n}} ${{c}}"
run {steps}
{end}""", ranks)
        rows = [list(map(float, line.split()[1:])) for line in result.output.split("\n")
                if re.match(r"row -?[0-9]", line)]
        self.assertGreater(len(rows), 10, result)
        return rows

    def setUp(self):
        super().setUp()
        (self.folder / "data").write_text(
            g.assembly(600, 0.0145, (0.001, 0.0012), speed=0.5, spin=300, clearance=0.02))

    def assertConserved(self, rows, tolerance):
        sums = [sum(row[:3]) for row in rows]
        error = max(abs(s / sums[0] - 1.0) for s in sums)
        lost = rows[-1][2] / sums[0]
        print(f"sum of energies kept to {error:.1e} of it; {100 * lost:.1f} % dissipated in "
              f"{rows[-1][4]:.0f} collisions")
        self.assertLess(error, tolerance)
        return lost

    def test_sum_is_conserved(self):
        """A contact lasts about 150 us, 300 steps. With the work of a force taken by the mean of the two ends of
        a step the books follow velocity Verlet exactly but for the arms of the torques, which change
        by overlap/radius during a contact, and for contacts still open: some 1e-6."""
        for rolling in ("off", "cdt"):
            rows = self.energies(rolling=rolling)
            self.assertGreater(max(row[3] for row in rows), 5)
            self.assertGreater(rows[-1][4], 800)
            lost = self.assertConserved(rows, 2e-5)
            self.assertGreater(lost, 0.1, "a case that dissipates")

    def test_cohesion_and_rolling_springs_keep_energy(self):
        """Cohesion is conservative: smooth elastic grains lose nothing with it, and what two that hold each
        other have is negative. A rolling spring changes its stiffness with the overlap, so it gives back
        a little more or less than it took: that counts as dissipated, and the sum stays."""
        for words in ("cohesion sjkr", "cohesion sjkr2"):
            rows = self.energies(tangential="off", e=1.0, words=words)
            lost = self.assertConserved(rows, 5e-6)
            self.assertLess(abs(lost), 5e-6)
        for rolling, words in (("epsd", ""), ("epsd2", "cohesion sjkr limitForce on")):
            rows = self.energies(rolling=rolling, words=words)
            lost = self.assertConserved(rows, 2e-5)
            self.assertGreater(lost, 0.1)

    def test_ranks_share_the_sums(self):
        """The same numbers on 1, 2 and 4 ranks, but for round-off and its growth in the collisions."""
        one = self.energies(time=2e-3)[-1]
        for ranks in (2, 4):
            other = self.energies(ranks=ranks, time=2e-3)[-1]
            self.assertEqual(one[3:], other[3:])
            for a, b in zip(one[:3], other[:3]):
                self.assertAlmostEqual(a, b, delta=1e-6 * one[0])

    def test_smooth_elastic_grains_lose_nothing(self):
        rows = self.energies(tangential="off", e=1.0)
        lost = self.assertConserved(rows, 5e-6)
        # what is called dissipated then is the error of the integration, nothing else
        self.assertLess(abs(lost), 5e-6)

    def test_grains_that_overlap_at_the_start(self):
        """Their springs hold energy that no work of this run has put there."""
        (self.folder / "data").write_text(g.assembly(600, 0.0145, (0.001, 0.0012), speed=0.5, spin=300, seed=8))
        rows = self.energies(time=2e-4, dt=1e-7)
        self.assertGreater(rows[0][1], 0.0)
        self.assertConserved(rows, 1e-4)

    def test_restart_keeps_the_books(self):
        rows = self.energies(time=2e-3, end="write_restart r\n")
        more = self.energies(time=2e-3, source="read_restart r\n")
        self.assertConserved([rows[0]] + more, 2e-5)


if __name__ == "__main__":
    unittest.main()
