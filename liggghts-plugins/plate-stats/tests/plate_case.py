# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains thrown at plates, for the tests of fix plate/stats."""

import concurrent.futures
import csv
import math
import shutil

import grainjet
from grainjet import scripts

D, RHO = 80e-6, 2950.0
MASS = math.pi / 6 * D ** 3 * RHO
YOUNG, POISSON = 5e6, 0.3

HEAD = """
    plugin load platestatsplugin.so
    atom_style granular
    atom_modify map array sort {sort}
    boundary {boundary}
    newton off
    communicate single vel yes
    units {units}
    processors {processors}
"""

MATERIAL = """
    neighbor 0.0002 bin
    neigh_modify delay 0 binsize 0.002
    fix m1 all property/global youngsModulus peratomtype {young}
    fix m2 all property/global poissonsRatio peratomtype {poisson}
    fix m3 all property/global coefficientRestitution peratomtypepair 1 {e}
    fix m4 all property/global coefficientFriction peratomtypepair 1 {mu}
    {pair}
    timestep {dt!r}
    fix g all gravity {gravity} vector 0 0 -1
"""

PAIR = "pair_style gran model hertz tangential history\npair_coeff * *"

PLANE = """
    fix w all wall/gran model hertz tangential history primitive type 1 zplane 0.0 store_force yes
"""

MESH = """
    fix disc all mesh/surface file disc.stl type 1
    fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes disc store_force yes
"""

PLATE = ("fix p all plate/stats wall w centre 0 0 0 normal 0 0 1 radius 0.005 rings 5 "
         "file plate.csv events events.csv")


def hertz(speed, young=YOUNG):
    """Peak force and duration of a normal elastic impact of a sphere on a plate of its own
    material (Johnson, Contact Mechanics, 11.4)."""
    modulus = young / (2 * (1 - POISSON ** 2))
    k = 4 / 3 * modulus * math.sqrt(D / 2)
    depth = (5 * MASS * speed ** 2 / (4 * k)) ** 0.4
    return k * depth ** 1.5, 2.94328 * depth / speed


class PlateCase(grainjet.Case):

    def data(self, grains, name="grains.data", bottom=-0.001):
        """A data file with grains (x, y, z, vx, vy, vz)."""
        (self.folder / name).write_text(scripts.data(
            [(1, D, RHO, g[:3], g[3:]) for g in grains], ((-0.01, 0.01), (-0.01, 0.01), (bottom, 0.02))))

    def script(self, body, e=1.0, mu=0.2, dt=1e-7, gravity=0.0, processors="* 1 1",
               read="read_data grains.data", before="", wall=PLANE, pair=PAIR, young=YOUNG,
               sort="0 0", boundary="f f f", units="si"):
        """Input script; pair="" for grains that do not know of each other."""
        material = MATERIAL.format(young=young, poisson=POISSON, e=e, mu=mu, dt=dt, gravity=gravity,
                                   pair=pair)
        return (HEAD.format(processors=processors, sort=sort, boundary=boundary, units=units) + before + f"\n{read}\n" + material + wall
                + "\nfix i all nve/sphere\n" + body)

    def disc(self, radius=0.006, sectors=24, height=0.0, name="disc.stl"):
        """An STL disc around the z axis, normal along z, cut like a cake."""
        corner = [(radius * math.cos(2 * math.pi * i / sectors),
                   radius * math.sin(2 * math.pi * i / sectors)) for i in range(sectors + 1)]
        (self.folder / name).write_text(scripts.stl(
            *(((0, 0, height), (*p, height), (*q, height)) for p, q in zip(corner, corner[1:]))))

    def side_by_side(self, scripts):
        """Results of short scripts, each in a folder of its own: most of their time is MPI's start."""
        def one(item):
            folder = self.folder / str(item[0])
            folder.mkdir()
            for file in self.folder.glob("*.data"):
                shutil.copy(file, folder)
            (folder / "in.test").write_text(item[1])
            result = grainjet.run(["liggghts-plugins", "-in", "in.test"], folder)
            result.folder = folder
            return result
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            return list(pool.map(one, enumerate(scripts)))

    def table(self, name="plate.csv"):
        """The statistics by region, numbers as floats."""
        with open(self.folder / name, newline="") as file:
            return {row["region"]: {k: float(v) for k, v in row.items() if k != "region"}
                    for row in csv.DictReader(file)}

    def events(self, name="events.csv"):
        with open(self.folder / name, newline="") as file:
            return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
