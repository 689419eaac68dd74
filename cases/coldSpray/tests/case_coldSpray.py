# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# label: long
"""The cold spray case, shrunk: the same Allrun on a coarser mesh and for a shorter time, in a copy of the folder. Its parts that
judge it: the nozzle's theory and the flight of one sphere, against published values."""

import importlib.util
import math
import shutil
import unittest

import numpy

import grainjet
from grainjet import dictionaries

COLD = grainjet.ROOT/"cases"/"coldSpray"


def part(name):
    """A module of the case."""
    spec = importlib.util.spec_from_file_location(name, COLD/f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


flight = part("flight")
nozzle = part("nozzle")

# without the smallest, whose contacts need the small step
SHRUNK = {"nInlet": 36, "nCone": 80, "nJet": 50, "nRadial": 12, "nLip": 5, "nBeside": 10, "spinUpIterations": 700,
          "diameters": "(10e-6 20e-6 50e-6)", "massFractions": "(0.02 0.5 0.48)",
          "insertionPlace": -0.010, "insertionRadius": 0.0005, "Uinsertion": 80, "fluidStep": 4e-7, "couplingInterval": 200,
          "insertionInterval": 1000, "endTime": 0.00056, "writeInterval": 0.00028}
GENERATED = ("tests", "log.*", "processor*", "postProcessing", "results", "polyMesh", "particles", "begun", "0", "0.[0-9]*", "[1-9]*", "*.foam")


def copy(folder):
    case = folder/"coldSpray"
    shutil.copytree(COLD, case, ignore=shutil.ignore_patterns(*GENERATED))
    return case


class ColdSpray(grainjet.Case):

    def test_job_and_its_results(self):
        case = copy(self.folder)
        grainjet.run(["./Allclean"], case)
        dictionaries.put(case/"system"/"parameters", **SHRUNK)
        job = grainjet.run(["./Allrun"], case, timeout=800, env={"GRAINJET_PROGRESS": "2"})
        self.assertEqual(job.code, 0, job)
        self.assertIn("All checks hold", job.output)
        self.assertTrue((case/"results"/"coldSpray.png").read_bytes().startswith(b"\x89PNG"))
        # from 0.4 ms on, 2.9 million grains per second
        self.assertGreater(len((case/"postProcessing"/"plate"/"events.csv").read_text().splitlines()), 100)

        # checks that cannot fail are none: grains a tenth faster than the sphere on the axis
        dumps = sorted((case/"postProcessing").glob("ways.*.dump"), key=lambda path: int(path.name.split(".")[1]))
        for path in dumps:
            lines = path.read_text().splitlines()
            at = next(i for i, line in enumerate(lines) if line.startswith("ITEM: ATOMS")) + 1
            rows = [line.split() for line in lines[at:]]
            lines[at:] = [" ".join((*row[:4], str(1.1*float(row[4])), *row[5:])) for row in rows]
            path.write_text("\n".join(lines) + "\n")
        self.assertFails(grainjet.run([COLD/"check.py", case], case), "FAILED", "off the sphere on the axis")

    def test_bad_parameters(self):
        case = copy(self.folder)
        for name, value, words in (("insertionPlace", 0.01, "must lie in the contraction"), ("insertionRadius", 0.01, "larger than the nozzle"),
                                   ("throatDiameter", 0.006, "smaller than inletDiameter and exitDiameter"),
                                   ("lipDiameter", 0.003, "between exitDiameter and"), ("standOff", 0, "standOff must be larger than 0"),
                                   ("writeInterval", 0.002, "make endTime 0.002, or writeInterval one that divides it")):
            shutil.copy(COLD/"system"/"parameters", case/"system")
            dictionaries.put(case/"system"/"parameters", **{name: value})
            self.assertFails(grainjet.run(["./particleInput"], case), words)

    def test_nozzle_theory(self):
        """Tables of isentropic flow, gamma = 1.4 (NACA report 1135): M 2, A/A* 1.6875, p/p0 0.1278, T/T0 0.5556; M 3: 4.235, 0.02722, 0.3571."""
        p = {"inletDiameter": 8.0, "throatDiameter": 1.0, "exitDiameter": math.sqrt(4.2346), "contraction": 10.0, "inletLength": 1.0,
             "divergence": 20.0, "standOff": 1.0, "molWeight": 28.0134, "Cp": 3.5*8314.46/28.0134, "pStagnation": 1.0, "TStagnation": 1.0,
             "As": 1.401e-6, "Ts": 107.0}
        n = nozzle.Nozzle(p)
        self.assertAlmostEqual(n.gamma, 1.4, places=6)
        self.assertAlmostEqual(n.area_ratio(2), 1.6875, places=4)
        for x, M, pressure, T in ((20.0, 3.0, 0.02722, 0.3571),):
            state = n.at(x)
            self.assertAlmostEqual(state["M"], M, places=3)
            self.assertAlmostEqual(state["p"], pressure, places=5)
            self.assertAlmostEqual(state["T"], T, places=4)
        self.assertAlmostEqual(n.mach(1.6875, True), 2, places=3)
        self.assertAlmostEqual(n.mach(1.6875, False), 0.3722, places=3)
        # nitrogen at 300 K: 17.9e-6 Pa s
        self.assertAlmostEqual(n.viscosity(300)*1e6, 17.9, delta=0.1)

    def test_flight(self):
        """In a uniform gas a slow small sphere approaches the gas' velocity and temperature exponentially (Stokes, Nu = 2)."""
        p = {"Cp": 1038.7, "As": 1.401e-6, "Ts": 107.0}
        n = type("Gas", (), {"p": p, "R": 296.8, "gamma": 1.4, "viscosity": nozzle.Nozzle.viscosity})()
        x = numpy.linspace(0, 1, 5)
        gas = flight.Axis(x, numpy.full(5, 0.1), numpy.full(5, 1e7), numpy.full(5, 300.0), n)
        d, density, capacity, mu = 2e-7, 1000.0, 400.0, n.viscosity(300)
        tau = density*d*d/(18*mu)
        a, q = flight.rates(gas, d, density, capacity, 0.5, 0.0, 310.0)
        rho = 1e7/(n.R*300)
        self.assertAlmostEqual(a*tau/0.1, 1 + 0.15*(rho*0.1*d/mu)**0.687, delta=0.02)
        cv = p["Cp"] - n.R
        k = mu*cv*(1.32 + 1.77*n.R/cv)
        re, prandtl = rho*0.1*d/mu, mu*p["Cp"]/k
        self.assertAlmostEqual(q/(-10*6*k/(density*capacity*d*d)), 2 + 0.6*math.sqrt(re)*prandtl**(1/3), delta=0.01)
        # Loth's law at Re 1, M 1 as docs/theory-drag.md states it
        self.assertAlmostEqual(flight.loth(1, 1, 1.4), 4.76, delta=0.01)


if __name__ == "__main__":
    unittest.main()
