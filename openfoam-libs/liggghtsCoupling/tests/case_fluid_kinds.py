# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of fluid: buoyancy and gravity in each, momentum of fluid and grains, ranks and restart with water and air."""
# processors: 2
# label: long

import math
import unittest

import numpy

from crowded_box import values
from fluid_cases import AIR, WATER, boussinesq, buoyant_pimple, inter_foam, layers
import gas_box
from grainjet import coupled_box as box, dictionaries, dumps, scripts
from grainjet.coupled_box import swarm
import meshes

D, DENSITY, G = 1e-3, 2500.0, 9.81
VOLUME = math.pi / 6 * D ** 3
WEIGHT = VOLUME * DENSITY * G
GRAVITY = f"fix g all gravity {G} vector 0 0 -1"
CELLS, PER_LAYER, LAYERS, HEIGHT = "4 4 8", 16, 8, 0.005     # cells of 5 mm

# water below, 0.4 of a layer of cells at the surface, air above
SURFACE = [1.0] * 4 + [0.4] + [0.0] * 3


class Buoyancy(box.CoupledCase):
    """Grains at rest, one in the middle of a cell of each layer, in a closed box; no drag, so that they are at rest
    but for the some 1e-7 of a step. The force of the fluid on them, to 1e-6 of the weight of the fluid that they displace."""

    def forces(self, solver, kind, force="pressureGradient", steps=3, interpolation="cell", **fluid):
        """Force of the fluid on the grains of the layers [N], after some steps."""
        folder = self.new_folder()
        box.write(folder, walls=True, cells=CELLS, steps=steps, delta_t=1e-7, **fluid)
        kind(folder)
        x = [(0.0075, 0.0075, HEIGHT * (layer + 0.5)) for layer in range(LAYERS)]
        box.script(folder, grains=box.grains(x, [(0, 0, 0)] * LAYERS, D, DENSITY), boundary="f f f", gravity=GRAVITY, dt=1e-8,
                   end=scripts.dump(10 * steps, "grains.dump", "id f_fluidForce[1] f_fluidForce[2] f_fluidForce[3] fz"))
        box.fv_options(folder, drag=None, forces=f"{{ {force} {{}} }}", coupling="oneWay", interpolation=interpolation)
        self.foam("blockMesh", folder)
        self.foam(solver, folder)
        self.case = folder
        return dumps.last(folder / "grains.dump")

    def check(self, forces, densities):
        for layer, density in enumerate(densities):
            fx, fy, fz, total = forces[layer + 1]
            displaced = VOLUME * density * G
            self.assertLess(math.hypot(fx, fy), 1e-6 * displaced)
            self.assertAlmostEqual(fz, displaced, delta=1e-6 * displaced, msg=f"layer {layer}")
            self.assertAlmostEqual(total, displaced - WEIGHT, delta=1e-6 * (WEIGHT - displaced), msg=f"layer {layer}")

    def test_pimple_foam(self):
        """p without the hydrostatic part: the force buoyancy."""
        self.check(self.forces("pimpleFoam", lambda folder: None, "buoyancy", rho="rho [1 -3 0 0 0 0 0] 1000;"), [WATER] * LAYERS)

    def test_inter_foam(self):
        """In water, in the layer of the surface and in air; for any place of the height from which p_rgh counts."""
        for solver, height in (("interFoam", 0), ("interFoam", 0.3), ("interIsoFoam", 0)):
            def kind(folder, height=height):
                inter_foam(folder, layers(SURFACE, PER_LAYER), (0, 0, -G))
                dictionaries.write(folder / "constant/hRef", f"dimensions [0 1 0 0 0 0 0]; value {height};\n",
                                   "uniformDimensionedScalarField")
            with self.subTest(solver=solver, height=height):
                self.check(self.forces(solver, kind), [AIR + a * (WATER - AIR) for a in SURFACE])

    def test_full_of_water(self):
        """As in pimpleFoam, also with values interpolated to the grains' places."""
        for interpolation in ("cell", "cellPoint"):
            with self.subTest(interpolation=interpolation):
                forces = self.forces("interFoam", lambda folder: inter_foam(folder, "1", (0, 0, -G)), interpolation=interpolation)
                self.check(forces, [WATER] * LAYERS)

    def test_boussinesq(self):
        """Warm fluid above cold one: the weight is that of the fluid at its temperature."""
        T = [300 + 2.0 * layer for layer in range(LAYERS)]
        forces = self.forces("buoyantBoussinesqPimpleFoam", lambda folder: boussinesq(folder, layers(T, PER_LAYER), (0, 0, -G)),
                             rho="rho [1 -3 0 0 0 0 0] 1.2;")
        self.check(forces, [1.2 * (1 - 3e-3 * (t - 300)) for t in T])

    def test_buoyant_pimple_foam(self):
        """Still air: a perfect gas whose pressure falls as exp(-gz/RT)."""
        RT = 6.0221417930e26 * 1.38065e-23 / 28.9 * 300      # by OpenFOAM's constants
        *p, top = (1e5 * math.exp(-G * z / RT) for z in [*(HEIGHT * (layer + 0.5) for layer in range(LAYERS)), 0.04])
        forces = self.forces("buoyantPimpleFoam", lambda folder: buoyant_pimple(
            folder, layers(p, PER_LAYER), (0, 0, -G), (repr(top), repr(top * (1 + G * 0.04 / RT)))))
        self.check(forces, [pressure / RT for pressure in p])


class Surface(box.CoupledCase):

    def test_moving_surface(self):
        """Water pushes air up a channel at 10 m/s, without acceleration: the gradient of pressure stays rho g in each cell.
        interFoam moves the surface before it asks for sources; with that density and the pressure before, the
        surface's hydrostatic pressure would be felt beside it: 0.7 of the weight of water here."""
        folder = self.new_folder()
        box.write(folder, walls=True, through=True, velocity="(0 0 10)", cells="2 2 20", steps=4, delta_t=4e-5, write_every=1,
                  correctors="nOuterCorrectors 3; nCorrectors 3;")
        inter_foam(folder, layers([1.0] * 10 + [0.5] + [0.0] * 9, 4), (0, 0, -G))
        for name, inlet, outlet in (("alpha.water", "type fixedValue; value uniform 1;", "type zeroGradient;"),
                                    ("p_rgh", "type fixedFluxPressure; value uniform 0;", "type fixedValue; value uniform 0;")):
            dictionaries.change(folder / "0" / name, ("\n}\n", f"\nzlo {{ {inlet} }} zhi {{ {outlet} }}\n}}\n"))
        dictionaries.change(folder / "0/U", ("noSlip", "slip"))
        x = [(0.005, 0.005, 0.002 * (layer + 0.5)) for layer in range(20)]
        box.script(folder, grains=box.grains(x, [(0, 0, 0)] * 20, 2e-4, DENSITY), boundary="f f f", gravity=GRAVITY, dt=4e-6,
                   end=scripts.dump(40, "grains.dump", "id f_fluidForce[3]"))
        box.fv_options(folder, drag=None, forces="{ pressureGradient {} }", coupling="oneWay", interpolation="cell")
        self.foam("blockMesh", folder)
        self.foam("interFoam", folder)
        alpha = [dictionaries.internal(folder / time / "alpha.water")[::4] for time in ("0.00012", "0.00016")]
        self.assertGreater(max(abs(a - b) for a, b in zip(*alpha)), 0.1)
        water = math.pi / 6 * 2e-4 ** 3 * WATER * G
        felt = [force / water for force, in dumps.last(folder / "grains.dump").values()]
        off = max(abs(f - a - (1 - a) * AIR / WATER) for f, a in zip(felt, alpha[0]))
        print(f"off by {off:.1e} of the weight of water")
        self.assertLess(off, 0.01)

    def test_surface_tension_is_not_felt(self):
        """A cube of water in air without gravity, in the pressure of its surface tension: the gradient of p that balances
        it would act on grains at the surface with V sigma K grad(alpha). A twentieth of that is allowed: what the
        flow that makes a drop of the cube needs."""
        folder = self.new_folder()
        box.write(folder, walls=True, cells="10 10 20", steps=3, delta_t=1e-6)
        inside = [all(3 <= i < 7 for i in (c % 10, c // 10 % 10, c // 100 - 5)) for c in range(2000)]
        inter_foam(folder, dictionaries.nonuniform([float(a) for a in inside]))
        x = [((i + 0.5) * 0.002, 0.0091, 0.0191) for i in range(10)]
        box.script(folder, grains=box.grains(x, [(0, 0, 0)] * len(x), 2e-4), boundary="f f f", dt=1e-7,
                   end=scripts.dump(30, "grains.dump", "id f_fluidForce[1]"))
        box.fv_options(folder, drag=None, forces="{ pressureGradient {} }", coupling="oneWay", interpolation="cell")
        self.foam("blockMesh", folder)
        self.foam("interFoam", folder)
        felt = max(abs(f) for f, in dumps.last(folder / "grains.dump").values())
        p = dictionaries.internal(folder / "3e-06/p")
        row = [p[i + 10 * 4 + 100 * 9] for i in range(10)]
        jump = max(abs(b - a) for a, b in zip(row, row[2:])) / 0.004
        print(f"felt {felt / (math.pi / 6 * 2e-4 ** 3):.3g} N/m3, gradient of p {jump:.3g}")
        self.assertGreater(jump, 1000)
        self.assertLess(felt, 0.05 * math.pi / 6 * 2e-4 ** 3 * jump)


class NeutralGrain(box.CoupledCase):

    def speed(self, solver, kind, density, equations="neglected", formulation="SetI", forces="{ drag { model Gidaspow; } pressureGradient {} }", **fluid):
        """Largest velocities of a grain as heavy as the fluid at rest around it, and of that fluid, after 20 steps of 1 ms [m/s]."""
        folder = self.new_folder()
        box.write(folder, walls=True, cells=CELLS, steps=20, delta_t=1e-3, **fluid)
        kind(folder)
        box.script(folder, grains=box.grains([(0.0105, 0.0111, 0.0212)], [(0, 0, 0)], 2e-3, density), boundary="f f f", gravity=GRAVITY,
                   dt=1e-4, end=scripts.dump(200, "grains.dump", box.MOTION))
        box.fv_options(folder, drag=None, forces=forces, formulation=formulation, voidFraction=box.void_fraction(equations))
        self.foam("blockMesh", folder)
        self.foam(solver, folder)
        end = max((f.parent for f in folder.glob("*/U")), key=lambda f: float(f.name))
        return max(abs(u) for u in dumps.last(folder / "grains.dump")[1][3:6]), abs(values(end / "U")).max()

    def test_at_rest(self):
        """Grain and fluid stay at rest, where the pressure holds the weight of the fluid, too: buoyancy has no reaction on a fluid that has the
        whole cell's weight. With one, one of 2 mm had sunk to 17 mm/s after 0.6 s. To 1e-9 of free fall, the tolerance of the solvers."""
        def water(folder):
            inter_foam(folder, "1", (0, 0, -G))

        def warm(folder):
            boussinesq(folder, "300", (0, 0, -G))
        for equations, formulation in (("neglected", "SetI"), ("neglected", "SetII"), ("full", "SetI"), ("full", "SetII")):
            for solver, kind, density, more in (
                    ("interFoam", water, WATER, {}), ("buoyantBoussinesqPimpleFoam", warm, 1000.0, {"rho": "rho [1 -3 0 0 0 0 0] 1000;"})):
                with self.subTest(equations=equations, formulation=formulation, solver=solver):
                    grain, fluid = self.speed(solver, kind, density, equations, formulation, **more)
                    print(f"{solver} {equations} {formulation}: grain {grain:.1e} m/s, fluid {fluid:.1e} m/s")
                    self.assertLess(max(grain, fluid), 1e-9 * G * 0.02)


class ObliqueFaces(box.CoupledCase):

    def test_reconstruct(self):
        """A build of OpenFOAM whose fvc::reconstruct is wrong in cells with oblique faces is told from one where it is right: the
        one stops with an error, in the other one a grain in still water feels the weight that it displaces."""
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                folder = self.new_folder()
                box.write(folder, walls=True, steps=2, delta_t=1e-6)
                inter_foam(folder, "1", (0, 0, -G))
                box.script(folder, grains=box.grains([(0.0075, 0.0075, 0.01)], [(0, 0, 0)], D, DENSITY), boundary="f f f",
                           gravity=GRAVITY, dt=1e-7, end=scripts.dump(20, "grains.dump", "id f_fluidForce[3]"))
                box.fv_options(folder, drag=None, forces="{ pressureGradient {} }", coupling="oneWay")
                meshes.tetrahedra(folder)
                if ranks:
                    meshes.decompose(folder, ranks)
                result = self.foam("interFoam", folder, ranks, check=False)
                if result.code:
                    self.assertFails(result, "fvc::reconstruct", "not normal to the axes", "polyMesh")
                    self.assertNotRegex(result.output, box.SOLVED)
                else:
                    displaced = VOLUME * WATER * G
                    self.assertAlmostEqual(dumps.last(folder / "grains.dump")[1][0], displaced, delta=1e-4 * displaced)


class WaterAndAir(box.CoupledCase):
    """Grains that fall through water and air in a periodic box, two-way."""

    ALPHA = layers([0.0] * 5 + [0.5] + [1.0] * 9 + [0.3] + [0.0] * 4, 100)

    def run_inter_foam(self, ranks=0, steps=5, write_every=None, into=None, count=300, outer=2, equations="neglected"):
        """In a new folder, or on in one; with this number of grains, or, for None, without the coupling."""
        folder = into or self.new_folder()
        if not into:
            box.write(folder, steps=steps, write_every=write_every, velocity="(0 0 0.1)",
                      correctors=f"nOuterCorrectors {outer}; nCorrectors 3;", ranks=max(ranks, 1),
                      decomposition=f"(1 1 {max(ranks, 1)})")
            inter_foam(folder, self.ALPHA, walls=False, sigma=0, water_nu=1e-5)
            if count is not None:
                x, v = swarm(count, 9, mean=(0, 0, 0.5))
                box.script(folder, grains=box.grains(x, v, D, DENSITY), end=scripts.dump(50, "grains.dump", box.MOTION))
                box.fv_options(folder, voidFraction=box.void_fraction(equations), subSteps=1)
            self.foam("blockMesh", folder)
            if ranks:
                self.foam("decomposePar", folder)
        self.foam("interFoam", folder, ranks)
        return folder

    @staticmethod
    def momentum(folder, time, step):
        """That of the fluid with what it is owed, and of the grains [N s]."""
        alpha = numpy.array(dictionaries.internal(folder / time / "alpha.water"))
        rho = AIR + alpha * (WATER - AIR)
        U = numpy.array(dictionaries.internal(folder / time / "U"))
        fluid = 0.002 ** 3 * (rho[:, None] * U).sum(0) + values(folder / time / "particleMomentumOwed").sum(0)
        motion, = (frame.array() for frame in dumps.frames(folder / "grains.dump") if frame.step == step)
        return fluid, VOLUME * DENSITY * motion[:, 4:7].sum(0)

    def test_momentum(self):
        """Fluid and grains together keep their momentum, though density differs by a factor of 800 from cell to
        cell: to 1e-9 of what was exchanged, the tolerance of the solvers. The same when the run goes on with five sub-steps
        in a step."""
        folder = self.run_inter_foam(steps=10, write_every=5, outer=12)
        fluid, grains = zip(*(self.momentum(folder, time, step) for time, step in (("0.0005", 50), ("0.001", 100))))
        dictionaries.put(folder / "constant/fvOptions", subSteps=5)
        dictionaries.put(folder / "system/controlDict", deltaT="5e-4", endTime="0.0015", writeInterval=1)
        self.run_inter_foam(into=folder)
        later = self.momentum(folder, "0.0015", 150)
        fluid, grains = (*fluid, later[0]), (*grains, later[1])
        for i, start in enumerate(("0", "0.001")):
            passed = abs(grains[i + 1] - grains[i]).max()
            lost = abs(fluid[i + 1] - fluid[i] + grains[i + 1] - grains[i]).max()
            print(f"lost {lost / passed:.1e} of {passed:.2e} N s")
            self.assertGreater(passed, 1e-6)
            self.assertLess(lost, 1e-9 * passed)
            self.assertLess(max(box.read_balance(folder, start)["imbalance"]), 1e-10)

    def test_ranks(self):
        """2 ranks give what one gives, but for the order of sums and the tolerance of the solvers."""
        one, two = self.run_inter_foam(), self.run_inter_foam(2)
        self.foam("reconstructPar", two)
        self.compare(one, two, "0.0005", 1e-9)

    def test_restart(self):
        """A continued run gives the digits of one that was not stopped, if pcorr leaves the flux as it is: interFoam
        corrects it at each start."""
        for equations, more in (("neglected", ()), ("full", ("fluidVelocity", "momentumOfShares", "feltViscousStress"))):
            with self.subTest(equations=equations):
                whole, parts = (self.run_inter_foam(steps=steps, write_every=5, equations=equations) for steps in (10, 5))
                box.end_at(parts, 10)
                self.run_inter_foam(into=parts)
                for name in ("U", "p_rgh", "phi", "alpha.water", "voidFraction", "particleMomentumOwed", *more):
                    a, b = ((f / "0.001" / name).read_bytes() for f in (whole, parts))
                    self.assertTrue(a == b, name)
                a, b = (dumps.last(f / "grains.dump") for f in (whole, parts))
                self.assertEqual(a, b)

    def test_without_grains(self):
        """The fields of the stock solver, bit for bit."""
        alone, coupled = (self.run_inter_foam(count=count) for count in (None, 0))
        for name in ("U", "p_rgh", "phi", "alpha.water"):
            a, b = ((f / "0.0005" / name).read_bytes() for f in (alone, coupled))
            self.assertEqual(a, b, name)


class TurbulenceSources(box.CoupledCase):

    def decay(self, name, solver, model):
        """Mean of k in the box after 20 steps. Air of 1.2 kg/m3 in all solvers."""
        folder = self.folder / f"{name}{model}"
        common = {"steps": 20, "velocity": "(0 0 1)"}
        if solver == "rhoPimpleFoam":
            gas_box.write(folder, pressure=AIR * gas_box.R * gas_box.T0, mu=AIR * 1.5e-5, **common)
        else:
            box.write(folder, **common)
        if solver == "interFoam":
            inter_foam(folder, "0", walls=False)
        dictionaries.write(folder / "constant/turbulenceProperties",
                           "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }")
        for field, value, dimension in (("k", 0.5, "0 2 -2"), ("epsilon", 50, "0 2 -3"), ("nut", 0, "0 2 -1"),
                                        ("alphat", 0, "1 -1 -1")):
            dictionaries.write_field(folder, field, dimension, value, {".*": "type cyclic;"})
        box.script(folder, grains=box.grains(*swarm(3000, 4, mean=(0, 0, 1), rms=0)))
        box.fv_options(folder, turbulenceSources=model)
        dictionaries.change(folder / "system/fvSolution", ("solvers\n{", 'solvers\n{ "(k|epsilon).*" { solver PBiCGStab; '
                                                          "preconditioner DILU; tolerance 1e-14; relTol 0; }"))
        self.foam("blockMesh", folder)
        self.foam(solver, folder)
        return numpy.mean(dictionaries.internal(folder / "0.002/k"))

    def test_all_kinds_alike(self):
        """Grains damp k by the same in equations with the density and without it. Velocities differ a little, as
        momentum predictors do, and with them production of k: 1e-5 of the damping is allowed, which a missing factor
        of the density, 1.2, would exceed by far."""
        solvers = ("pimpleFoam", "interFoam", "rhoPimpleFoam")
        damping = [self.decay(solver, solver, "none") - self.decay(solver, solver, "ChenWood") for solver in solvers]
        print("damping of k", *(f"{solver} {d:.8g}" for solver, d in zip(solvers, damping)))
        self.assertGreater(damping[0], 0.005)
        for d in damping[1:]:
            self.assertAlmostEqual(d, damping[0], delta=1e-5 * damping[0])


if __name__ == "__main__":
    unittest.main()
