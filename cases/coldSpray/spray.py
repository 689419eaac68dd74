# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the cold spray case left: gas in sections and on the axis, ways of the grains, hits of the plate."""

import math
import pathlib

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import flight
import nozzle
from grainjet import dictionaries, dumps, fields, tables

NEAR = 0.3                      # of the radius of the exit: what counts as near the axis
SHOCK = 0.004                   # m before the plate: upstream of the bow shock

# Copper. Density, melting point and tensile strength (annealed): ASM Handbook 2, C11000
STRENGTH, MELTING, ROOM = 220e6, 1356.0, 293.0


def assadi(density, T):
    """Critical velocity of Assadi, Gaertner, Stoltenhoff & Kreye, Acta Mater. 51 (2003) 4379: density in g/cm3, temperatures in
    degrees C, strength in MPa."""
    return 667 - 14*1e-3*density + 0.08*(MELTING - 273.15) + 0.1*1e-6*STRENGTH - 0.4*(T - 273.15)


def schmidt(density, capacity, T):
    """Critical velocity of Schmidt, Gaertner, Assadi & Kreye, Acta Mater. 54 (2006) 729, with their factors 1.2 and 0.3."""
    strength = STRENGTH*(1 - (T - ROOM)/(MELTING - ROOM))
    return numpy.sqrt(1.2*4*strength/density + 0.3*capacity*(MELTING - T))


class Gas:
    """The flow of the latest time of a case, between the cells linear."""

    def __init__(self, case, n):
        self.n = n
        case = pathlib.Path(case)
        if not any(case.glob("*.foam")):
            (case/"gas.foam").touch()
        self.time, grid = fields.latest_mesh(case)
        to_points = vtk.vtkCellDataToPointData()
        to_points.SetInputData(grid)
        to_points.Update()
        self.grid = to_points.GetOutput()

    def at(self, x, r):
        """{name: values} of M, p, T, U, rho at places (x, r) in the plane of the grains; NaN outside."""
        x, r = numpy.broadcast_arrays(numpy.asarray(x, float), numpy.asarray(r, float))
        places = vtk.vtkPoints()
        places.SetData(numpy_to_vtk(numpy.column_stack((x.ravel(), r.ravel(), numpy.zeros(x.size)))))
        asked = vtk.vtkPolyData()
        asked.SetPoints(places)
        probe = vtk.vtkProbeFilter()
        probe.SetInputData(asked)
        probe.SetSourceData(self.grid)
        probe.Update()
        data = probe.GetOutput().GetPointData()
        inside = vtk_to_numpy(data.GetArray(probe.GetValidPointMaskArrayName())) > 0
        U, p, T = (vtk_to_numpy(data.GetArray(name)).astype(float) for name in ("U", "p", "T"))
        speed, p, T = (numpy.where(inside, v, numpy.nan) for v in (numpy.linalg.norm(U, axis=1), p, T))
        with numpy.errstate(invalid="ignore", divide="ignore"):
            return {"U": U[:, 0], "p": p, "T": T, "M": speed/numpy.sqrt(self.n.gamma*self.n.R*T), "rho": p/(self.n.R*T)}

    def section(self, x, points=200):
        """Means over the mass flow through a section of the nozzle, with the mass flow [kg/s] of the whole circle, the state on the axis
        (key axis) and the displacement thickness of the boundary layer [m]."""
        # the wedge's wall is flat and lies inside the circle in its middle
        R = self.n.radius(x)*math.cos(math.radians(0.5*self.n.p["wedgeAngle"]))
        r = (numpy.arange(points) + 0.5)/points*R
        s = self.at(x, r)
        inside = numpy.isfinite(s["p"])
        s, r = {name: v[inside] for name, v in s.items()}, r[inside]
        flux = s["rho"]*s["U"]
        flow = 2*math.pi*(flux*r).sum()*R/points
        axis = {name: v[0] for name, v in s.items()}
        area = flow/(axis["rho"]*axis["U"])
        return {**{name: (v*flux*r).sum()/(flux*r).sum() for name, v in s.items()}, "flow": flow, "axis": axis,
                "displacement": R - math.sqrt(area/math.pi)}

    def axis(self, begin):
        """On the axis from `begin` to the plate."""
        x = numpy.linspace(begin, self.n.plate - 1e-6, 3000)
        s = self.at(x, 1e-6)
        inside = numpy.isfinite(s["p"])
        return flight.Axis(x[inside], s["U"][inside], s["p"][inside], s["T"][inside], self.n)


class Spray:

    def __init__(self, case):
        case = pathlib.Path(case)
        self.p = p = dictionaries.values(case/"system"/"parameters")
        self.n = n = nozzle.Nozzle(p)
        self.isentropic = Gas(case/"isentropic", n)
        self.gas = Gas(case, n)
        self.axis = self.gas.axis(p["insertionPlace"])
        results = case/"postProcessing"
        self.balance = tables.history(results/"liggghtsCoupling", "balance")
        self.ways = self._ways(results)
        self.hits = self._hits(results)
        self.flights = {}

    def _ways(self, results):
        """{ID: array of rows time, diameter, x, y, vx, vy, T}"""
        step = self.p["fluidStep"]/self.p["couplingInterval"]
        rows, ids = [], []
        for path in sorted(results.glob("ways.*.dump"), key=lambda f: int(f.name.split(".")[1])):
            frame = dumps.frames(path)[-1]
            if frame.rows:
                data = numpy.array(frame.rows)
                ids.append(data[:, 0])
                rows.append(numpy.column_stack((numpy.full(len(data), frame.step*step), data[:, 1:])))
        ids, rows = numpy.concatenate(ids), numpy.concatenate(rows)
        order = numpy.argsort(ids, kind="stable")
        ids, rows = ids[order], rows[order]
        at = numpy.flatnonzero(numpy.diff(ids)) + 1
        return {int(i): way for i, way in zip(ids[numpy.concatenate(([0], at))], numpy.split(rows, at))}

    def _hits(self, results):
        """First hits: columns of the events with the grain's diameter, radius on the plate and mass."""
        e = numpy.atleast_1d(numpy.genfromtxt(results/"plate"/"events.csv", delimiter=",", names=True))
        e = e[numpy.argsort(e["time"], kind="stable")]
        _, first = numpy.unique(e["id"], return_index=True)
        e = e[numpy.sort(first)]
        e = e[[int(i) in self.ways for i in e["id"]]]
        d = numpy.array([self.ways[int(i)][0, 1] for i in e["id"]])
        return {**{name: e[name] for name in e.dtype.names}, "d": d, "r": numpy.hypot(e["x"], e["y"]),
                "mass": self.p["rhoParticle"]*math.pi/6*d**3}

    def passing(self, x, d, near=None):
        """(speed along the axis, temperature, distance from it) of the grains of a size where they first pass x, each between the two
        times of the dump around it; near: only those within this distance of the axis."""
        found = []
        for way in self.ways.values():
            i = numpy.argmax(way[:, 2] > x)
            if abs(way[0, 1]/d - 1) < 1e-6 and i > 0:
                a, b = way[i - 1], way[i]
                s = (x - a[2])/(b[2] - a[2])
                found.append((1 - s)*a + s*b)
        rows = numpy.array(found).reshape(-1, 7)
        if near is not None:
            rows = rows[rows[:, 3] < near]
        return rows[:, 4], rows[:, 6], rows[:, 3]

    def flight(self, d):
        """The flight of one sphere along the axis: x, v, T, t; to the place where its front touches the plate."""
        if d not in self.flights:
            p = self.p
            self.flights[d] = flight.fly(self.axis, d, p["rhoParticle"], p["heatCapacity"], p["insertionPlace"], p["Uinsertion"],
                                         p["TInsertion"], self.n.plate - 0.5*d)
        return self.flights[d]

    def critical(self, T):
        """Critical velocities by the two formulas."""
        p = self.p
        return assadi(p["rhoParticle"], T), schmidt(p["rhoParticle"], p["heatCapacity"], T)
