# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of triangles with values per triangle, in files of VTK: of fix surface/stats and dump mesh/vtk."""

import pathlib

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


class Surface:
    """points (n, 3), triangles (m, 3) as indices of points, values: name -> (m,) or (m, k) per triangle, and the time in s, None if
    the file does not say it."""

    def __init__(self, path):
        path = pathlib.Path(path)
        if not path.is_file():
            raise FileNotFoundError(f"{path}: no such file")
        if path.suffix not in (".vtk", ".vtp"):
            raise ValueError(f"{path}: a surface is a file ending in .vtk or .vtp")
        reader = vtk.vtkXMLPolyDataReader() if path.suffix == ".vtp" else vtk.vtkPolyDataReader()
        if path.suffix == ".vtk":
            reader.ReadAllScalarsOn()
            reader.ReadAllVectorsOn()
            reader.ReadAllFieldsOn()
        reader.SetFileName(str(path))
        reader.Update()
        data = reader.GetOutput()
        if not data or not data.GetNumberOfPolys():
            raise ValueError(f"{path}: holds no triangles")
        self.points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        cells = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
        if len(cells) != 3 * data.GetNumberOfPolys():
            raise ValueError(f"{path}: holds polygons other than triangles")
        self.triangles = cells.reshape(-1, 3)
        time = data.GetFieldData().GetArray("TimeValue")
        self.time = time.GetValue(0) if time else None
        arrays = data.GetCellData()
        self.values = {arrays.GetArrayName(i): vtk_to_numpy(arrays.GetArray(i)) for i in range(arrays.GetNumberOfArrays())}

    def corners(self):
        """(m, 3, 3): corners of each triangle."""
        return self.points[self.triangles]

    def centres(self):
        return self.corners().mean(axis=1)

    def area_vectors(self):
        """(m, 3): normal times area of each triangle, by the order of its corners."""
        a, b, c = numpy.moveaxis(self.corners(), 1, 0)
        return 0.5 * numpy.cross(b - a, c - a)

    def areas(self):
        return numpy.linalg.norm(self.area_vectors(), axis=1)
