# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields and grains of an OpenFOAM case as numpy arrays, read by VTK.

The fields must be reconstructed; the case needs an (empty) file ending in `.foam`.
"""

import json
import pathlib
import re

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def latest_mesh(case):
    """(time in s, unstructured grid with cell fields) of the latest time of a case."""
    return mesh_at(case, float("inf"))


def mesh_at(case, time):
    """The same of the written time nearest to `time`."""
    reader, chosen = _reader(pathlib.Path(case), time)
    reader.CreateCellToPointOff()
    reader.Update()
    return chosen, reader.GetOutput().GetBlock(0)


def _reader(case, time):
    """(reader of the case set to the written time nearest to `time`, that time)"""
    marker = next(case.glob("*.foam"), None)
    if marker is None:
        raise FileNotFoundError(f"{case}: no file ending in .foam; `touch case.foam` makes one")
    reader = vtk.vtkOpenFOAMReader()
    reader.SetFileName(str(marker))
    reader.UpdateInformation()
    times = vtk_to_numpy(reader.GetTimeValues())
    chosen = times[-1] if time > times[-1] else min(times, key=lambda written: abs(written - time))
    reader.SetTimeValue(chosen)
    return reader, chosen


def axial_slice(grid, field, normal=(0, 1, 0), offset=1e-7):
    """Cut the mesh with the plane through the origin; values are interpolated to the points.

    A plane in which faces of the mesh lie would cut cells on both sides or none, hence the
    offset in m. Returns points (n, 3), triangles (m, 3) and the field at the points."""
    to_points = vtk.vtkCellDataToPointData()
    to_points.SetInputData(grid)
    plane = vtk.vtkPlane()
    plane.SetNormal(*normal)
    plane.SetOrigin(*(offset*component for component in normal))
    cutter = vtk.vtkCutter()
    cutter.SetCutFunction(plane)
    cutter.SetInputConnection(to_points.GetOutputPort())
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(cutter.GetOutputPort())
    triangles.Update()
    cut = triangles.GetOutput()
    corners = vtk_to_numpy(cut.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
    return (vtk_to_numpy(cut.GetPoints().GetData()), corners,
            vtk_to_numpy(cut.GetPointData().GetArray(field)))


def wall_lines(case, time=float("inf"), normal=(0, 1, 0), offset=1e-7):
    """The same plane cuts the patches of type wall in lines: their ends (n, 2, 3) in m, at the written time nearest to `time`."""
    case = pathlib.Path(case)
    boundary = (case/"constant/polyMesh/boundary").read_text(errors="replace")
    walls = re.findall(r"(\w+)\s*\{[^{}]*\btype\s+wall\s*;", boundary)
    reader, _ = _reader(case, time)
    reader.DisableAllPatchArrays()
    for name in walls:
        reader.SetPatchArrayStatus(f"patch/{name}", 1)
    reader.Update()
    plane = vtk.vtkPlane()
    plane.SetNormal(*normal)
    plane.SetOrigin(*(offset*component for component in normal))
    lines = [numpy.empty((0, 2, 3))]
    for surface in _surfaces(reader.GetOutput()):
        cutter = vtk.vtkCutter()
        cutter.SetCutFunction(plane)
        cutter.SetInputData(surface)
        cutter.Update()
        cut = cutter.GetOutput()
        if cut.GetNumberOfLines():
            ends = vtk_to_numpy(cut.GetLines().GetData()).reshape(-1, 3)[:, 1:]
            lines.append(vtk_to_numpy(cut.GetPoints().GetData())[ends])
    return numpy.concatenate(lines)


def _surfaces(blocks):
    """All surfaces in a tree of blocks."""
    for i in range(blocks.GetNumberOfBlocks()):
        block = blocks.GetBlock(i)
        if isinstance(block, vtk.vtkMultiBlockDataSet):
            yield from _surfaces(block)
        elif isinstance(block, vtk.vtkPolyData):
            yield block


def at(grid, field, points):
    """The cell field at points (n, 3): the values of the cells that they lie in, nan outside."""
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(numpy.array(points, dtype=float).reshape(-1, 3)))
    asked = vtk.vtkPolyData()
    asked.SetPoints(places)
    probe = vtk.vtkProbeFilter()
    probe.SetInputData(asked)
    probe.SetSourceData(grid)
    probe.Update()
    data = probe.GetOutput().GetPointData()
    inside = vtk_to_numpy(data.GetArray(probe.GetValidPointMaskArrayName())) > 0
    return numpy.where(inside, vtk_to_numpy(data.GetArray(field)), numpy.nan)


def grain_times(folder):
    """Times in s of the files that a vtkCloud wrote below folder."""
    return [entry["time"] for entry in _series(folder)[1]]


def _series(folder):
    """(folder of the files, entries with `name` and `time`)"""
    series = sorted(pathlib.Path(folder).glob("*.series"))
    if not series:
        raise FileNotFoundError(f"{folder}: no grains (*.vtp.series) written there")
    return series[0].parent, json.loads(series[0].read_text())["files"]


def grains_at(folder, time):
    """(time in s, positions (n, 3), fields) of the grains that a vtkCloud wrote below folder, from
    the file nearest to a time."""
    there, files = _series(folder)
    chosen = min(files, key=lambda entry: abs(entry["time"] - time))
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(there/chosen["name"]))
    reader.Update()
    cloud = reader.GetOutput()
    if not cloud.GetNumberOfPoints():
        return chosen["time"], numpy.empty((0, 3)), {}
    data = cloud.GetPointData()
    fields = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
              for i in range(data.GetNumberOfArrays())}
    return chosen["time"], vtk_to_numpy(cloud.GetPoints().GetData()), fields
