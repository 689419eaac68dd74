# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The time-step report of fix hertz/cg: against the stock `fix check/timestep/gran`, and Table 4 of Weaver &
Miskovic, Fluids 8 (2023) 215."""

import re
import unittest

import granular as g
from grainjet import Case


def printed(result, name):
    return [float(word) for word in re.search(rf"^{name} (.*)$", result.output, re.M).group(1).split()]


class TimeStep(Case):

    def test_equals_the_stock_report(self):
        """Two types, three sizes. The stock fix puts the mass of a whole grain where the Hertz time has the
        effective mass, half of it, so that its Hertz time is 4^(1/5) = 1.32 times the duration of an impact;
        the plugin's is that duration (tested in physics/tests)."""
        (self.folder / "data").write_text(
            g.assembly(300, 0.016, (0.001, 0.0014, 0.002), speed=0.5, spin=0, clearance=0.02))
        common = "read_data data\nneighbor 0.0005 bin\n" + g.MATERIAL
        end = "fix i all nve/sphere\ntimestep 2e-6\n{}run 100\nprint 'report {}'\n"
        stock = self.liggghts(
            g.head() + common + g.contacts(g.STOCK)
            + end.format("fix t all check/timestep/gran 1 1 1 warn no error no\n"
                         "variable a equal 100*f_t[1]\nvariable b equal 100*f_t[2]\n"
                         "thermo_style custom step v_a v_b\nthermo 1\n", "$a $b"))
        plugin = self.liggghts(
            g.load(g.PLUGIN) + g.head() + common + g.contacts(g.PLUGIN)
            + end.format("variable a equal f_c[4]\nvariable b equal f_c[5]\n", "$a $b"), ranks=2)
        a, b = printed(stock, "report"), printed(plugin, "report")
        print(f"% Rayleigh and % Hertz: stock {a}, plugin {b}")
        self.assertGreater(min(a), 0.0)
        for x, y in zip(a, (b[0], b[1] / 4 ** 0.2)):
            self.assertAlmostEqual(x, y, delta=1e-9 * x)

    def test_rayleigh_column_of_table_4(self):
        """5.9, 6.6, 9.2, 4.6 and 2.3 %, printed to one decimal, with E = 5e5 Pa (the 5e6 of the text is an
        erratum). For grains the Rayleigh time is f_cg times as long."""
        for name, d, density, nu, dt, percent in (
                ("Hardalupas1", 80e-6, 2950, 0.30, 1e-6, 5.9), ("Hardalupas3", 40e-6, 2420, 0.30, 5e-7, 6.6),
                ("Lau1", 40e-6, 1200, 0.37, 5e-7, 9.2), ("Lau2", 40e-6, 1200, 0.37, 2.5e-7, 4.6),
                ("Lau3", 40e-6, 1200, 0.37, 1.25e-7, 2.3)):
            for factor in (1, 2):
                result = self.liggghts(
                    g.load(g.PLUGIN) + g.head(more=f"coarsegraining {factor}\n")
                    + f"""region r block 0 0.01 0 0.01 0 0.01 units box
create_box 1 r
fix m1 all property/global youngsModulus peratomtype 5.e5
fix m2 all property/global poissonsRatio peratomtype {nu}
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.926
fix m4 all property/global coefficientFriction peratomtypepair 1 0.18
fix p all particletemplate/sphere 15485863 atom_type 1 density constant {density} radius constant {d / 2} volume_limit 1e-18
fix pd all particledistribution/discrete 32452843 1 p 1.0
fix in all insert/pack seed 32452867 distributiontemplate pd maxattempt 10 insert_every once overlapcheck yes &
  vel constant 1 0 0 region r particles_in_region 5
fix c all hertz/cg
fix i all nve/sphere
timestep {dt}
variable a equal f_c[4]
run 1
print 'report $a'
""")
                found = printed(result, "report")[0]
                print(f"{name}, f_cg {factor}: {found:.2f} % ({percent} % in Table 4)")
                self.assertAlmostEqual(found * factor, percent, delta=0.05)


if __name__ == "__main__":
    unittest.main()
