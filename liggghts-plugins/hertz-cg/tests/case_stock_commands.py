# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""Stock computes, fixes and commands that ask the pair style for its contacts, beside fix hertz/cg: they
give what they give beside the stock pair style, on the same grains."""

import re
import unittest

import granular as g
from grainjet import Case

# Both programs add up the same few terms in another order
SAME_STATE = 1e-9

NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?$")

HEAT = """
fix h1 all property/global thermalConductivity peratomtype 50. 30.
fix h2 all property/global thermalCapacity peratomtype 1. 2.
fix heat all heat/gran/conduction initial_temperature 300. {more}
group warm id <= 150
run 0
set group warm property/atom Temp 500.
"""


def rows(path, every=False):
    """The numbers of a text file, a list a line; only the longest lines, which are those of the table, or
    every line of numbers."""
    found = []
    for line in path.read_text().split("\n"):
        words = line.split()
        if words and all(NUMBER.match(word) for word in words):
            found.append([float(word) for word in words])
    longest = max(map(len, found), default=0)
    return [row for row in found if every or len(row) == longest]


class StockCommands(Case):

    def setUp(self):
        super().setUp()
        self.box = 0.0145
        (self.folder / "data").write_text(
            g.assembly(300, self.box, (0.001, 0.0014, 0.002), speed=0.5, spin=300))

    def run_case(self, kind, commands, ranks=0, words="", steps=20, head="", before="", boundary="p p p"):
        name = f"{kind}{ranks}"
        script = (g.load(kind) + g.head(boundary, head) + "read_data data\nneighbor 0.0005 bin\nneigh_modify delay 0\n"
                  + g.MATERIAL + before + g.contacts(kind, words=words) + "fix i all nve/sphere\ntimestep 1e-7\n"
                  + commands.replace("OUT", f"out.{name}") + f"\nrun {steps}\n")
        return self.liggghts(script, ranks, name=f"in.{name}").output

    def compare(self, commands, key=1, ranks=(0, 2), tolerance=SAME_STATE, smallest=1, same_ranks=False, **options):
        """What both write into OUT, line by line after sorting by the first `key` numbers; differences over
        the largest magnitude of a column. same_ranks: the stock program, too, depends on their number."""
        self.run_case(g.STOCK, commands, **options)
        stock = sorted(rows(self.folder / "out.stock0"), key=lambda row: row[:key])
        self.assertGreaterEqual(len(stock), smallest)
        for column in range(key, len(stock[0])):
            self.assertTrue(any(row[column] for row in stock), f"column {column} is nothing but zeros")
        for n in ranks:
            if same_ranks and n:
                self.run_case(g.STOCK, commands, ranks=n, **options)
                stock = sorted(rows(self.folder / f"out.stock{n}"), key=lambda row: row[:key])
            self.run_case(g.PLUGIN, commands, ranks=n, **options)
            plugin = sorted(rows(self.folder / f"out.plugin{n}"), key=lambda row: row[:key])
            self.assertEqual(len(stock), len(plugin))
            for column in range(len(stock[0])):
                scale = max(abs(row[column]) for row in stock) or 1.0
                for a, b in zip(stock, plugin):
                    self.assertLessEqual(abs(a[column] - b[column]), tolerance * scale, (column, a, b))
        return stock

    def dump(self, columns, more="", every=10):
        # with x at the end rows are longer than those of the box in the file's head
        return (f"{more}\ndump o all custom {every} OUT id {columns} x\n"
                'dump_modify o sort id format "%d' + " %.17g" * (1 + len(columns.split())) + '"\n')

    def test_contact_stress(self):
        self.compare(self.dump(" ".join(f"c_s[{n}]" for n in range(1, 7)), "compute s all stress/atom"))
        self.compare(self.dump(" ".join(f"c_s[{n}]" for n in range(1, 7)), "compute s all stress/atom pair"),
                     words="cohesion sjkr")

    def test_pressure(self):
        values = " ".join(f"${{p{n}}}" for n in range(1, 7))
        self.compare("compute p all pressure thermo_temp\n"
                     + "".join(f"variable p{n} equal c_p[{n}]\n" for n in range(1, 7))
                     + f'fix out all print 10 "{values}" file OUT screen no\n', key=0)

    def test_averages_on_cells(self):
        for kind in (g.STOCK, g.PLUGIN):
            self.run_case(kind, "fix e all ave/euler nevery 1 cell_size_relative 3 parallel no\n"
                          f"dump o all euler/vtk 20 {kind}*.vtk\n")
        stock, plugin = (rows(self.folder / f"{kind}20.vtk", every=True) for kind in (g.STOCK, g.PLUGIN))
        self.assertEqual(len(stock), len(plugin))
        pressures = (self.folder / f"{g.STOCK}20.vtk").read_text().split("SCALARS pressure")[1].split("SCALARS")[0]
        self.assertTrue(any(float(line) for line in pressures.split("\n")[2:] if NUMBER.match(line.strip())),
                        "no pressure anywhere: nothing is compared")
        for a, b in zip(stock, plugin):
            self.assertEqual(len(a), len(b))
            for x, y in zip(a, b):
                # dumped with few digits
                self.assertAlmostEqual(x, y, delta=1e-5 * abs(x) + 1e-9)

    def test_contacts_one_by_one(self):
        """`dump local` of all that compute pair/gran/local knows. It evaluates the law anew with the
        velocities of the end of the step."""
        words = "id pos vel force force_normal force_tangential torque torque_normal torque_tangential history contactArea delta contactPoint"
        for law, history in (("", 3), ("cohesion sjkr rolling_friction epsd", 6)):
            columns = 3 + 6 + 6 + 18 + history + 1 + 1 + 3
            command = (f"compute l all pair/gran/local {words}\n"
                       f"dump o all local 20 OUT " + " ".join(f"c_l[{n}]" for n in range(1, columns + 1)) + "\n"
                       'dump_modify o format "' + " ".join(["%.17g"] * columns) + '"\n')
            # the two may list a pair in either order: seen from the smaller ID
            seen = {}
            for kind, ranks in ((g.STOCK, 0), (g.PLUGIN, 0), (g.STOCK, 2), (g.PLUGIN, 2)):
                self.run_case(kind, command, ranks, words=law)
                pairs = seen[kind, ranks] = {}
                for row in rows(self.folder / f"out.{kind}{ranks}"):
                    self.assertEqual(len(row), columns)
                    pos, ids, vel = row[0:6], row[12:15], row[6:12]
                    sign, order = (1, ids[:2]) if ids[0] < ids[1] else (-1, ids[1::-1])
                    if sign < 0:
                        pos, vel = pos[3:] + pos[:3], vel[3:] + vel[:3]
                    force = [sign * x for x in row[15:24]]
                    kept = [sign * x for x in row[33:33 + history]]
                    area, delta, point = row[-5:-4], row[-4:-3], row[-3:]
                    pairs.setdefault(tuple(order), []).append((pos, vel, force, kept, area, delta, point))
            # ranks know the velocities of others' grains of half a step before: like is compared with like
            for ranks in (0, 2):
                stock, mine = seen[g.STOCK, ranks], seen[g.PLUGIN, ranks]
                self.assertGreater(len(stock), 50)
                self.assertEqual(stock.keys(), mine.keys())
                for pair in stock:
                    self.assertEqual(len(stock[pair]), len(mine[pair]))
                    for theirs, ours in zip(sorted(stock[pair]), sorted(mine[pair])):
                        for part in range(7):
                            scale = max(map(abs, theirs[part])) or 1.0
                            limit = SAME_STATE * scale + (1e-15 if part >= 4 else 0)
                            for x, y in zip(theirs[part], ours[part]):
                                self.assertLessEqual(abs(x - y), limit, (law, ranks, pair, part, theirs, ours))

    def test_numbers_of_contacts_and_neighbours(self):
        self.compare(self.dump("c_c", "compute c all contact/atom"))
        self.compare(self.dump("c_c", "compute c all contact/atom skin 0.0002"))
        self.compare(self.dump("c_c", "compute c all contact/atom/gran"))
        self.compare(self.dump("c_c", "compute c all contact/atom/gran skin 0.0004", every=20))
        self.compare(self.dump("c_c", "compute c all coord/atom 0.0015"))
        self.compare(self.dump("c_c", "compute c all cluster/atom 0.0012"))
        self.compare(self.dump("c_c", "compute c all centro/atom 4"))

    def test_radial_distribution(self):
        # both take the largest cut-off of the pair style
        self.compare("compute r all rdf 20\nfix out all ave/time 10 1 10 c_r file OUT mode vector\n", key=2, smallest=20)

    def test_time_step_check(self):
        self.compare("fix ts all check/timestep/gran 1 0.1 0.1\nvariable a equal f_ts[1]\nvariable b equal f_ts[2]\n"
                     'fix out all print 10 "${a} ${b}" file OUT screen no\n', key=0)
        warned = self.run_case(g.PLUGIN, "fix ts all check/timestep/gran 1 0.0001 0.00001\n")
        self.assertIn("time-step is", warned)

    def test_conduction_of_heat(self):
        for more in ("", "contact_area projection", "contact_area constant 1e-9"):
            with self.subTest(more=more):
                found = self.compare(self.dump("f_Temp[0] f_heatFlux[0]", HEAT.format(more=more)))
                self.assertGreater(max(abs(row[2]) for row in found), 0.0, "no heat flows: nothing is compared")

    def test_heat_of_each_contact(self):
        self.compare(HEAT.format(more="") + "compute l all pair/gran/local heatFlux\n"
                     "compute t all reduce max c_l[1]\ncompute u all reduce min c_l[1]\n"
                     # the flux of a pair turns round with the order in which it is listed
                     "variable t equal (c_t-c_u+abs(c_t+c_u))/2\n"
                     'fix out all print 10 "${t}" file OUT screen no\n', key=0, same_ranks=True)

    def test_weighted_continuum(self):
        columns = " ".join(f"f_stressTensor_[{n}]" for n in range(1, 10))
        self.compare(self.dump(columns, "fix w all continuum/weighted kernel_radius 0.0014 kernel_type Top_Hat compute stress"),
                     same_ranks=True)

    def test_sum_of_normal_forces(self):
        self.compare(self.dump("f_sum_normal_force_", "fix sum_normal_force_ all property/atom sum_normal_force_ scalar no no no 0"),
                     ranks=(0,))

    def test_overlapping_grains_deleted(self):
        """Of grains on a grid every second has another one near it, which goes. Which of the two it is
        depends on the order of the host's lists."""
        text = "pairs\n\n125 atoms\n2 atom types\n" + "".join(f"0 {self.box} {a}lo {a}hi\n" for a in "xyz") + "\nAtoms\n\n"
        places = [[0.001 + 0.0029 * n for n in (i % 5, i // 5 % 5, i // 25)] for i in range(100)]
        places += [[x + 0.0005, y, z] for x, y, z in places[:50:2]]
        for i, place in enumerate(places, 1):
            text += f"{i} 1 0.001 2500 " + " ".join(map(repr, place)) + "\n"
        (self.folder / "data").write_text(text)
        for kind in (g.STOCK, g.PLUGIN):
            for ranks in (0, 2):
                printed = self.run_case(kind, "run 1\ndelete_atoms overlap 0.0007 all all\n" + self.dump("y z"), ranks)
                self.assertIn("Deleted 25 atoms, new total = 100", printed)

    def test_potential_energy_is_that_of_the_stock_pair_style(self):
        """None: neither books what its contacts hold there."""
        for kind in (g.STOCK, g.PLUGIN):
            self.run_case(kind, "compute e all pe/atom\ncompute p all pe\nvariable p equal c_p\n"
                          'fix out all print 10 "p ${p}" file printed screen no\n' + self.dump("c_e", every=20))
            self.assertEqual({row[1] for row in rows(self.folder / f"out.{kind}0")}, {0.0})
            printed = re.findall(r"(?m)^p (\S+)", (self.folder / "printed").read_text())
            self.assertEqual({float(x) for x in printed}, {0.0})


if __name__ == "__main__":
    unittest.main()
