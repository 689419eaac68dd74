# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains thrown at meshes, for the tests of fix surface/stats."""

import csv
import math
import re
import struct

import grainjet
from grainjet import scripts

D, RHO = 80e-6, 2950.0
R = D / 2
MASS = math.pi / 6 * D ** 3 * RHO

SCRIPT = """
    {plugins}
    atom_style granular
    atom_modify map array sort {sort}
    boundary {boundary}
    newton off
    communicate single vel yes
    units {units}
    processors {processors}
    {before}
    {read}
    neighbor 0.0002 bin
    neigh_modify delay 0 binsize 0.002
    fix m1 all property/global youngsModulus peratomtype {young}
    fix m2 all property/global poissonsRatio peratomtype 0.3
    fix m3 all property/global coefficientRestitution peratomtypepair 1 {e}
    fix m4 all property/global coefficientFriction peratomtypepair 1 {mu}
    {pair}
    timestep {dt!r}
    fix g all gravity {gravity} vector 0 0 -1
    {wall}
    fix i all nve/sphere
"""

PLUGINS = "plugin load surfacestatsplugin.so"
PAIR = "pair_style gran model hertz tangential history\npair_coeff * *"
SETTINGS = {"plugins": PLUGINS, "sort": "0 0", "boundary": "f f f", "units": "si", "processors": "* 1 1", "before": "",
            "read": "read_data grains.data", "young": 5e6, "e": 0.8, "mu": 0.3, "pair": PAIR, "dt": 1e-7,
            "gravity": 0.0}

FILES = "every 1000 file table.csv vtk map.vtp events events.csv spectra spectra.csv"
STATS = f"fix s all surface/stats mesh m wall w {FILES}"


def wall(*meshes, more="", options="store_force yes"):
    """A wall of meshes m, or of (ID, file) each."""
    meshes = meshes or (("m", "m.stl"),)
    lines = [f"fix {name} all mesh/surface file {file} type 1 {more}" for name, file in meshes]
    names = " ".join(name for name, _ in meshes)
    return "\n".join([*lines, "fix w all wall/gran model hertz tangential history mesh "
                      f"n_meshes {len(meshes)} meshes {names} {options}"])


def sheet(n=4, half=0.006, height=lambda x, y: 0.0):
    """A square of 2 n n triangles around the z axis; height(x, y) bends it."""
    at = [-half + 2 * half * i / n for i in range(n + 1)]

    def corner(i, j):
        return at[i], at[j], height(at[i], at[j])

    return [triangle for i in range(n) for j in range(n) for triangle in scripts.rectangle(
        corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1))]


def inclined(degrees):
    """Height of a sheet that is turned about the y axis; its normal is (-sin, 0, cos)."""
    return lambda x, y: x * math.tan(math.radians(degrees))


def read_vtp(path):
    """Points, triangles and cell data of a .vtp file with raw appended blocks."""
    data = path.read_bytes()
    start = data.index(b"_", data.index(b"<AppendedData")) + 1
    head = data[:start].decode()

    def array(name, kind, size):
        offset = int(re.search(f'Name="{name}"[^>]*offset="([0-9]+)"', head).group(1))
        length, = struct.unpack_from("<Q", data, start + offset)
        return list(struct.unpack_from(f"<{length // size}{kind}", data, start + offset + 8))

    cells = head[head.index("<CellData>"):]
    fields = {name: array(name, "d", 8) for name in re.findall('Name="([a-z_]+)"', cells)}
    return array("Points", "d", 8), array("connectivity", "q", 8), fields


class SurfaceCase(grainjet.Case):

    def data(self, grains, name="grains.data", box=((-0.01, 0.01), (-0.01, 0.01), (-0.008, 0.02))):
        """A data file with grains (x, y, z, vx, vy, vz)."""
        (self.folder / name).write_text(scripts.data([(1, D, RHO, g[:3], g[3:]) for g in grains], box))

    def mesh(self, triangles, name="m.stl"):
        (self.folder / name).write_text(scripts.stl(*triangles))

    def script(self, body, wall=wall(), **settings):
        return SCRIPT.format(wall=wall, **{**SETTINGS, **settings}) + body

    def table(self, name="table.csv"):
        """The statistics by region, numbers as floats."""
        with open(self.folder / name, newline="") as file:
            return {row["region"]: {k: float(v) for k, v in row.items() if k != "region"}
                    for row in csv.DictReader(file)}

    def events(self, name="events.csv"):
        with open(self.folder / name, newline="") as file:
            return [{k: v if k == "mesh" else float(v) for k, v in row.items()} for row in csv.DictReader(file)]

    def spectra(self, name="spectra.csv"):
        with open(self.folder / name, newline="") as file:
            return [{k: v if k == "quantity" else float(v) for k, v in row.items()} for row in csv.DictReader(file)]

    def map(self, name="map.vtp"):
        """Cell data of a map."""
        return read_vtp(self.folder / name)[2]

    def points(self, name="map.vtp"):
        """Coordinates of the points of a map, in one list."""
        return read_vtp(self.folder / name)[0]
