# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turbulent dispersion in coupled runs: homogeneous turbulence against theory, the same on any number of ranks
and after a restart, nothing without turbulence. The turbulence is frozen (turbulence off), and the flow at
rest. The steps themselves are tested by physics/tests/test_dispersion.cpp, with large samples."""
# label: long
# processors: 2

import math
import random
import unittest

import numpy

import grainjet
from grainjet import coupled_box as box, dictionaries, dumps, scripts

RHO, NU = 1.2, 1.5e-5
K, EPSILON, SCT = 0.6, 40.5, 0.7
S = math.sqrt(2 * K / 3)                    # m/s
T = 1.5 * 0.09 * K / EPSILON / SCT          # s; nut = 0.09 k2/epsilon: 2.857 ms
DT = 1e-4                                   # s, an interval
COLUMNS = "id xu yu zu vx vy vz"
SIDES = (("xlo", 0), ("xhi", 0.02), ("ylo", 0), ("yhi", 0.02), ("zlo", 0), ("zhi", 0.04))


def turbulence(folder, k=K, epsilon=EPSILON, model="kEpsilon", walls=False, more="turbulence off; kMin 0;"):
    """A k-epsilon model with these fields; walls with k as it is in the cells, and no wall function."""
    dictionaries.write(folder / "constant/turbulenceProperties",
                       f"simulationType RAS; RAS {{ RASModel {model}; printCoeffs off; {more} }}\n")
    kind = "zeroGradient" if walls else "cyclic"
    for name, dimensions, value in (("k", "0 2 -2", k), ("epsilon", "0 2 -3", epsilon), ("nut", "0 2 -1", 0)):
        patches = "calculated; value uniform 0" if walls and name == "nut" else kind
        dictionaries.write_field(folder, name, dimensions, value, f'".*" {{ type {patches}; }}')
    dictionaries.change(folder / "system/fvSolution", ('"U.*"', '"(U|k|epsilon).*"'))


class Dispersion(grainjet.Case):

    def prepare(self, name, grains, dispersion="Langevin", steps=20, diameter=2e-5, density=1000.0,
                forces="{ drag { model Stokes; } }", boundary="p p p", processors="", fields=None, fixes="",
                options=None, every=None, nu=NU, interval=10, **fluid):
        folder = self.folder / name
        box.write(folder, steps=steps, delta_t=DT, nu=nu, walls=boundary == "f f f", **fluid)
        box.script(folder, grains=box.grains(*grains, diameter, density), boundary=boundary, fixes=fixes,
                   processors=processors, dt=DT / interval,
                   end=scripts.dump(every or interval * steps, "grains.dump", COLUMNS))
        box.fv_options(folder, **{"coupling": "oneWay", "drag": None, "forces": forces, "interpolation": "cell",
                                  "couplingInterval": interval, "turbulentDispersion": dispersion, **(options or {})})
        if fields is not False:
            turbulence(folder, walls=boundary == "f f f", **(fields or {}))
        return folder

    def run_case(self, folder, ranks=0):
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        return self.foam("pimpleFoam", folder, ranks)

    def at_rest(self, n, seed=5):
        x, _ = box.swarm(n, seed)
        return x, [(0, 0, 0)] * n

    # ---- theory

    def test_homogeneous(self):
        """1500 grains from rest, 3 components: the standard error of a variance is sqrt(2/4500), 2.1 %. Four of them.
        tau/T 0.05: <v2> = s2 T/(T + tau); displacement from rest at long times 2 s2 T t, less what is lost
        at the start: from the moments of the linear equations, integrated here."""
        n, steps = 1500, 200
        tau = 0.05 * T
        diameter = math.sqrt(18 * RHO * NU * tau / 1000.0)
        grains = self.at_rest(n)
        for model in ("Langevin", "discreteRandomWalk"):
            with self.subTest(model=model):
                word = f"{{ model {model}; {'Sct 0.7' if model == 'Langevin' else 'CL 0.15'}; seed 3; }}"
                folder = self.prepare(model, grains, word, steps=steps, diameter=diameter)
                result = self.run_case(folder)
                self.assertIn(f"Turbulent dispersion: {model}, seed 3", result.output)
                rows = dumps.array(folder / "grains.dump")
                way = rows[:, 1:4] - numpy.array(grains[0])
                v2, x2 = (rows[:, 4:7] ** 2).mean(), (way ** 2).mean()
                time, shape = (T, math.exp) if model == "Langevin" else (0.15 * K / EPSILON, None)
                v2_exact, x2_exact = moments(time, tau, steps * DT, shape is None)
                print(f"\n{model}: <v2> {v2:.5f}, theory {v2_exact:.5f}; <x2> {x2:.4e}, theory {x2_exact:.4e}")
                tolerance = 4 * math.sqrt(2 / (3 * n))
                self.assertLess(abs(v2 / v2_exact - 1), tolerance)
                self.assertLess(abs(x2 / x2_exact - 1), tolerance)

    def test_crossing(self):
        """Heavy grains that fly fast through the fluid see its eddies for T/b: the diffusivity along their way
        is that over the one across."""
        n, steps, w = 1500, 150, 4 * S
        x, _ = box.swarm(n, 8)
        tau = 1.0                            # s: the slip stays
        folder = self.prepare("crossing", (x, [(0, 0, w)] * n), steps=steps, density=1e6,
                              diameter=math.sqrt(18 * RHO * NU * tau / 1e6))
        self.run_case(folder)
        v = dumps.array(folder / "grains.dump")[:, 4:7]
        t = steps * DT
        # dv = u'/tau dt: <v2> = 2 s2 Tb (t - Tb (1 - exp(-t/Tb)))/tau2, but for t/tau of 1.5 %
        for k, name, factor in ((0, "normal", 4), (1, "normal", 4), (2, "along", 1)):
            time = T / math.sqrt(1 + factor * 0.64 * 16)
            exact = 2 * S * S * time * (t + time * math.expm1(-t / time)) / tau ** 2
            found = v[:, k].var()
            print(f"{name}: <v'2> {found:.4e}, theory {exact:.4e}")
            self.assertLess(abs(found / exact - 1), 4 * math.sqrt(2 / n) + 0.015)

    def test_shear(self):
        """Light grains in a flow along z that changes across it, U = 60 m/s sin(2 pi x/20 mm). Where they come to in an interval
        the flow is faster or slower by about s. They follow it, and so see eddies for T: the spread across is that in still
        fluid. With that difference as their slip it is 0.42 of it."""
        n, steps, tau = 1500, 100, 0.005 * T
        x, _ = box.swarm(n, 12)
        folder = self.prepare("shear", (x, [(0, 0, 60 * math.sin(100 * math.pi * p[0])) for p in x]), steps=steps,
                              diameter=math.sqrt(18 * RHO * NU * tau / 1000.0), options={"interpolation": "cellPoint"})
        dictionaries.write_field(folder, "U", "0 1 -1", "nonuniform List<vector> 2000 (" + " ".join(
            f"(0 0 {60 * math.sin(math.pi * (0.2 * (i % 10) + 0.1)):.6f})" for i in range(2000)) + ")", '".*" { type cyclic; }')
        result = self.run_case(folder)
        self.assertNotIn("is long for", result.output)
        way = dumps.array(folder / "grains.dump")[:, 1] - numpy.array(x)[:, 0]
        found, exact = (way ** 2).mean(), moments(T, tau, steps * DT, False)[1]
        print(f"\nacross the shear: <x2> {found:.4e}, theory {exact:.4e}")
        self.assertLess(abs(found / exact - 1), 4 * math.sqrt(2 / n))

    def test_interval(self):
        """A warning, once, if more than a tenth of the grains is moved in an interval by a fifth of an eddy and more: T/4
        for light grains; heavy ones hardly move. None with a smaller share, and none with eddies ten times as long."""
        for light, epsilon, ranks in ((6, 7, 0), (6, 7, 2), (5, 7, 0), (50, 0.7, 0)):
            with self.subTest(light=light, epsilon=epsilon, ranks=ranks):
                folder = self.prepare(f"interval{light}{ranks}", self.at_rest(50), steps=3, processors="processors 1 1 2" if ranks else "",
                                      fields={"epsilon": epsilon * EPSILON})
                with open(folder / "constant/new.grains", "a") as script:
                    script.write(f"set atom 1*{light} density 5\n")
                output = self.run_case(folder, ranks).output
                self.assertEqual(output.count("turbulentDispersion Langevin: deltaT 0.0001 s is long for 12 % of the grains"),
                                 int(light == 6))
                self.assertEqual(output.count("is long for"), int(light == 6))

    def test_lift_at_walls(self):
        """A warning of SaffmanMei where walls have no dispersion to take grains off them; none in laminar flow."""
        lift = "{ drag { model Stokes; } SaffmanMei {} }"
        for i, (word, boundary, fields, said) in enumerate((("none", "f f f", None, 1), ("Langevin", "f f f", None, 0),
                                                            ("none", "p p p", None, 0), ("none", "f f f", False, 0))):
            with self.subTest(word=word, boundary=boundary, fields=fields):
                folder = self.prepare(f"lift{i}", self.at_rest(5), word, steps=1, forces=lift, boundary=boundary, fields=fields)
                self.assertEqual(self.run_case(folder).output.count("SaffmanMei without turbulentDispersion"), said)

    # ---- nothing to do

    def test_nothing(self):
        """Bit for bit the motion without dispersion: with k = 0, and with laminar flow, which the log says."""
        grains = box.swarm(40, 4)
        same = {}
        for name, word, fields in (("none", "none", {"k": 0}), ("zero", "Langevin", {"k": 0}),
                                   ("walk", "discreteRandomWalk", {"k": 0}),
                                   ("laminar", "{ model Langevin; Sct 1; }", False), ("absent", None, False)):
            folder = self.prepare(name, grains, word, fields=fields)
            result = self.run_case(folder)
            self.assertEqual("Langevin has nothing to do: the flow is laminar" in result.output, name == "laminar")
            same[name] = (folder / "grains.dump").read_text()
        for name, text in same.items():
            self.assertEqual(text, same["none"], name)

    # ---- ranks and restart

    def crowd(self):
        """Grains that cross the cuts in x and z, and some that hit walls."""
        rng = random.Random(3)
        x = [(0.01 + rng.uniform(-4e-4, 4e-4), 0.0005 + 0.0005 * i, 0.02 + rng.uniform(-4e-4, 4e-4))
             for i in range(38)]
        x += [(0.0002, 0.001 + 0.001 * i, 0.02) for i in range(18)]
        return x, [(rng.uniform(-0.5, 0.5), 0, rng.uniform(-0.5, 0.5)) for _ in x]

    WALLS, ALL_WALLS = ("\n".join(
        f"fix w{side} all wall/gran model hertz tangential history primitive type 1 {side[0]}plane {at}" for side, at in sides)
        for sides in (SIDES[:4], SIDES))

    # in x, across the cuts of the fluid
    VARYING = "nonuniform List<scalar> 2000 (" + " ".join(f"{0.3 + 0.02 * (i % 10):.3f}" for i in range(2000)) + ")"

    def crowded(self, name, model="Langevin", ranks=0, steps=20, k=VARYING, interpolation="cellPoint",
                **case):
        return self.prepare(name, self.crowd(), f"{{ model {model}; seed 7; }}", steps=steps, boundary="f f f",
                            fixes=self.WALLS, diameter=2e-4, density=2500.0, nu=100 * NU, fields={"k": k},
                            options={"interpolation": interpolation}, **case)

    def test_ranks(self):
        """The same on 1, 2 and 4 ranks, with walls: bit for bit where k is uniform, taken from the cell, and its
        gradient made of differences. Where it varies, gradients and interpolated values are sums in another order:
        to round-off of 20 steps. LIGGGHTS is cut in z, the fluid in x."""
        for model, k, tolerance in (("Langevin", K, 0), ("Langevin", self.VARYING, 1e-12), ("discreteRandomWalk", K, 0)):
            with self.subTest(model=model, tolerance=tolerance):
                found = {}
                for ranks in (0, 2, 4):
                    folder = self.crowded(f"{model}{ranks}{tolerance}", model, ranks, k=k, interpolation="cellPoint" if tolerance else "cell", processors=f"processors 1 1 {ranks}" if ranks else "",
                                          decomposition="(4 1 1)" if ranks == 4 else "(2 1 1)")
                    dictionaries.change(folder / "system/fvSchemes", ("gradSchemes {", "gradSchemes { grad(k) leastSquares;"))
                    if ranks:
                        dictionaries.put(folder / "system/decomposeParDict", numberOfSubdomains=ranks)
                    self.run_case(folder, ranks)
                    found[ranks] = dumps.array(folder / "grains.dump")
                self.assertEqual(len(found[0]), 56)
                for ranks in (2, 4):
                    self.assertLessEqual(numpy.abs(found[0] - found[ranks]).max(), tolerance, f"{ranks} ranks")

    def test_restart(self):
        """20 steps in one run and in two, serial and on 2 ranks: bit for bit."""
        for model in ("Langevin", "discreteRandomWalk"):
            for ranks in (0, 2):
                with self.subTest(model=model, ranks=ranks):
                    case = dict(model=model, ranks=ranks, write_every=10, decomposition="(2 1 1)",
                                processors="processors 1 1 2" if ranks else "", every=200)
                    whole = self.crowded(f"whole{model}{ranks}", **case)
                    self.run_case(whole, ranks)
                    parts = self.crowded(f"parts{model}{ranks}", steps=10, **case)
                    self.run_case(parts, ranks)
                    dictionaries.put(parts / "system/controlDict", endTime=20 * DT)
                    result = self.foam("pimpleFoam", parts, ranks)
                    self.assertIn("56 continued grains", result.output)
                    self.assertEqual(*(dumps.last(f / "grains.dump") for f in (whole, parts)))

    # ---- walls

    def test_walls(self):
        """Light grains between two walls stay where the flow leaves them: none sticks. Without the mirror
        three times as many lie in the tenth at the walls (of binomial standard error below)."""
        n, steps = 1500, 150
        x, v = box.swarm(n, 9)
        tau = 0.02 * T
        folder = self.prepare("walls", (x, v), steps=steps, boundary="f f f", fixes=self.ALL_WALLS, nu=1000 * NU,
                              interval=50, diameter=math.sqrt(18 * RHO * 1000 * NU * tau / 1000.0))
        self.run_case(folder)
        rows = dumps.array(folder / "grains.dump")
        self.assertEqual(len(rows), n)
        share = [(numpy.minimum(c, size - c) < 0.05 * size).sum() for c, size in zip(rows[:, 1:4].T, (0.02, 0.02, 0.04))]
        error = math.sqrt(0.1 * 0.9 * n)
        print(f"\nin the tenth at the walls: {share} of {n}, evenly spread {0.1 * n:.0f} +- {error:.0f}")
        for count in share:
            self.assertLess(abs(count - 0.1 * n), 4 * error)

    def test_symmetry(self):
        """Planes of symmetry mirror the fluctuation as walls do: the same grains bit for bit, with k and U of the cell and
        walls of LIGGGHTS at both."""
        found = []
        for kind in ("wall", "symmetryPlane", "symmetry"):
            folder = self.crowded(kind, k=K, interpolation="cell")
            if kind != "wall":
                dictionaries.change(folder / "system/blockMeshDict", *((f"{x} {{ type wall", f"{x} {{ type {kind}") for x in ("xlo", "xhi")))
                for field in ("U", "p", "k", "epsilon", "nut"):
                    text = (folder / "0" / field).read_text().rstrip().removesuffix("}")
                    (folder / "0" / field).write_text(f'{text}"x.*" {{ type {kind}; }}\n}}\n')
            self.run_case(folder)
            found.append((folder / "grains.dump").read_text())
        self.assertEqual(found[0], found[1])
        self.assertEqual(found[0], found[2])

    def test_wall_functions(self):
        """Ten coarse cells between walls, k higher at the walls and as in the cell there, T of the logarithmic law:
        proportional to the distance. Light grains stay evenly spread over the cells, to the error of the sample (from 10 groups of grains)
        and 3 % for a linear interpolation between cells that T rises over several times."""
        n, steps, groups = 3000, 600, 10
        y = [min(i + 0.5, 9.5 - i) * 0.002 for i in range(10)]
        k = [0.3 - 15 * d for d in y]
        epsilon = [0.09 * a * a / (0.41 * 0.3 * d) for a, d in zip(k, y)]
        tau = 5e-5
        folder = self.prepare("coarse", self.at_rest(n, 11), steps=steps, boundary="f f f", fixes=self.ALL_WALLS,
                              nu=1000 * NU, interval=50, every=1000, options={"interpolation": "cellPoint"},
                              diameter=math.sqrt(18 * RHO * 1000 * NU * tau / 1000.0),
                              fields={name: dictionaries.nonuniform(200 * values) for name, values in (("k", k), ("epsilon", epsilon))})
        self.run_case(folder)
        shares = []
        for frame in dumps.frames(folder / "grains.dump")[6:]:
            x = frame.array()[:, 1]
            self.assertEqual(len(x), n)
            cell = numpy.minimum(x, 0.02 - x) // 0.002
            shares.append([[5 * (cell[g::groups] == i).mean() for i in range(5)] for g in range(groups)])
        mean = numpy.mean(shares, axis=0)
        error = mean.std(axis=0, ddof=1) / math.sqrt(groups)
        print("\nfrom the wall:", *(f"{m:.3f} +- {e:.3f}" for m, e in zip(mean.mean(axis=0), error)))
        self.assertLess(max(error), 0.035)
        for share, e in zip(mean.mean(axis=0), error):
            self.assertLess(abs(share - 1), 0.03 + 4 * e)

    # ---- pressure

    def test_turbulent_pressure(self):
        """A k that rises in x at 20 m/s2, no pressure, no flow: by default a grain feels V rho 2/3 grad(k), with
        turbulentPressure no nothing; the log says which."""
        grains = ([(0.011, 0.01, 0.02)], [(0, 0, 0)])
        k = "nonuniform List<scalar> 2000 (" + " ".join(f"{0.3 + 0.04 * (i % 10):.3f}" for i in range(2000)) + ")"
        for entry, exact in (("", 2 / 3 * 20 * RHO / 1000.0), ("turbulentPressure no;", 0)):
            for formulation in ("SetI", "SetII"):
                with self.subTest(entry=entry, formulation=formulation):
                    folder = self.prepare(f"p{entry[-3:-1]}{formulation}", grains, "none", steps=1,
                                          boundary="f f f", fields={"k": k}, forces=f"{{ pressureGradient {{ {entry} }} }}",
                                          options={"formulation": formulation})
                    result = self.run_case(folder)
                    self.assertEqual("pressureGradient (without 2k/3)" in result.output, not entry)
                    vx = dumps.last(folder / "grains.dump")[1][3]
                    self.assertAlmostEqual(vx / DT, exact, delta=1e-9)

    # ---- two-way

    def test_two_way(self):
        """The drag of the fluctuation reacts on the fluid: the momentum of both is kept, with
        sources of turbulence, too."""
        folder = self.prepare("two", box.swarm(300, 6), options={"coupling": "twoWay", "turbulenceSources": "ChenWood", "forces":
                              "{ drag {} pressureGradient {} viscous {} }"}, diameter=2e-4, density=2500.0, steps=20,
                              fields={"more": "turbulence on;"})
        self.run_case(folder)
        balance = box.read_balance(folder)
        self.assertLess(max(balance["imbalance"]), 1e-10)


def moments(time, tau, t, linear):
    """<v2> and <x2> at t of grains from rest: the correlation of u' is exp(-t/T), or falls linearly to zero over
    the life 2 T of an eddy."""
    n = 400
    h = t / n
    at = (numpy.arange(n) + 0.5) * h
    lag = numpy.abs(at[:, None] - at[None, :])
    R = S * S * (numpy.maximum(0, 1 - lag / (2 * time)) if linear else numpy.exp(-lag / time))
    a = numpy.exp(-(t - at) / tau) / tau * h
    b = -numpy.expm1(-(t - at) / tau) * h
    return a @ R @ a, b @ R @ b


if __name__ == "__main__":
    unittest.main()
