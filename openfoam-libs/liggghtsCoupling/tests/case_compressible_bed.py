# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixed beds in a gas with the full void-fraction equations: the drag law's pressure drop, of a gas of constant density
and of one that expands on its way through the bed."""
# processors: 2
# label: long

import unittest

import numpy

import gas_box
from gas_box import CV, GAMMA, R, T0, field
from grainjet import coupled_box as box

FULL = box.void_fraction("full")
RHO, NU = 1.2, 1.5e-5

# A bed as that of case_fixed_bed.py: a cubic lattice, out of step with the cells
CELL, ACROSS, ALONG = 4e-3, 2, 40       # cubes
BED, MIDDLE = range(5, 35), (17, 22)    # layers of cells
SPACING, OFFSET = CELL / 2, (0.13, 0.21, 0.29)


class Bed:
    """A bed of solid fraction alpha, crossed at the Reynolds number U d/nu, or with the velocity U."""

    def __init__(self, alpha, reynolds=None, velocity=None):
        self.alpha, self.diameter = alpha, SPACING * (6 * alpha / numpy.pi) ** (1 / 3)
        self.velocity = velocity or reynolds * NU / self.diameter
        drag = self.ergun(self.velocity) * (1 - alpha)
        self.time_step = float(f"{min(0.2 * CELL / self.velocity, 0.5 * RHO * self.velocity / drag):.6g}")

    def ergun(self, u, rho=RHO):
        """Ergun, Chem. Eng. Prog. 48 (1952) 89, of the superficial velocity, Pa/m."""
        viscous, inertial = 150 * RHO * NU * self.alpha ** 2 * u / self.diameter ** 2, 1.75 * rho * self.alpha * u ** 2 / self.diameter
        return (viscous + inertial) / (1 - self.alpha) ** 3


def through_bed(bed, flux, p, temperature, length, n=2000):
    """Pressure (Pa) behind a length of bed in a perfect gas that gets no heat, of the pressure and temperature before it and the
    mass flux rho e u: d(p + rho u^2)/dz = - Ergun, c_p T + u^2/2 = const. By the midpoint rule."""
    e, cp = 1 - bed.alpha, CV + R

    def velocity(p):
        # c_p T + u^2/2 = total with T = p e u/(flux R)
        a = cp * p * e / (flux * R)
        return -a + (a * a + 2 * total) ** 0.5

    u = flux * R * temperature / (e * p)
    total = cp * temperature + u * u / 2

    def slope(p):
        u, h = velocity(p), 1e-6 * p
        du = (velocity(p + h) - velocity(p - h)) / (2 * h)
        return -bed.ergun(e * u, flux / (e * u)) / (1 + flux / e * du)

    dz = length / n
    for _ in range(n):
        p += dz * slope(p + dz / 2 * slope(p))
    return p


class GasBed(gas_box.GasCase):

    def run_bed(self, bed, ranks=0, steps=100, correctors=6, outer=1, offset=OFFSET, **more):
        """Run it; fields of each layer of cells at the end, the flux of mass that enters, kg/m2 s, and by how much that
        through the layers differs at most, relative."""
        dt = more.pop("time_step", bed.time_step)
        across = range(2 * ACROSS)
        positions = [[(n + 0.5 + shift) * SPACING for n, shift in zip((i, j, k), offset)]
                     for k in range(2 * BED.start, 2 * BED.stop) for j in across for i in across]
        width, length = ACROSS * CELL, ALONG * CELL
        options = {"voidFraction": FULL, "drag": "Ergun", "forces": "(pressureGradient)", **more.pop("options", {})}
        folder = self.run_gas(
            ranks, steps=steps, grains=(positions, [(0, 0, 0)] * len(positions)), boundary="p p f", density=1e11,
            diameter=bed.diameter, box_of_grains=f"0 {width} 0 {width} 0 {length}", dem_step=dt / 10, delta_t=dt,
            velocity=f"(0 0 {bed.velocity!r})", mu=RHO * NU, through=True, convection=more.pop("convection", "upwind"),
            cells=f"{ACROSS} {ACROSS} {ALONG}", size=[1e3 * CELL * n for n in (ACROSS, ACROSS, ALONG)],
            correctors=f"nOuterCorrectors {outer}; nCorrectors {correctors};",
            processors="processors 1 1 2" if ranks else "", options=options, **more)
        end = max((f.parent for f in folder.glob("*/voidFraction")), key=lambda f: float(f.name))
        layers = {name: field(end / name).reshape(ALONG, ACROSS ** 2, -1).mean(1)[:, -1]
                  for name in ("p", "T", "U", "voidFraction", "k", "epsilon", "nuTilda") if (end / name).exists()}
        phi = field(end / "phi")
        # the faces between layers carry all of the mean flow
        through = numpy.sort(phi[abs(phi) > 0.5 * abs(phi).max() * (1 - bed.alpha)])
        self.assertEqual(len(through), ACROSS ** 2 * (ALONG - 1))
        rho = more["gas_density"] if "gas_density" in more else layers["p"][0] / (R * T0)
        entering, e = rho * bed.velocity, layers["voidFraction"]
        expected = numpy.sort(numpy.repeat(2 / (e[1:] + e[:-1]), ACROSS ** 2))
        return layers, entering, abs(through / (entering * CELL ** 2) - expected).max()

    def drop(self, bed, *args, **more):
        """Measured - dp/dz in the middle of the bed, Pa/m, and the largest difference of the flux of mass. The gas has a constant
        density; its pressure is low, so that the smallest drops, 1e-6 Pa per cell, are well above round-off."""
        layers, _, flux = self.run_bed(bed, *args, gas="rhoConst", gas_density=RHO, pressure=1.0, **more)
        low, high = MIDDLE
        return (layers["p"][low] - layers["p"][high]) / (CELL * (high - low)), flux

    def assertErgun(self, bed, **more):
        slope, flux = self.drop(bed, **more)
        print(f"alpha_s {bed.alpha} Re {bed.velocity * bed.diameter / NU:.3g} {more}: "
              f"measured/Ergun - 1 = {slope / bed.ergun(bed.velocity) - 1:.1e}, flux {flux:.1e}")
        self.assertLess(abs(slope / bed.ergun(bed.velocity) - 1), 5e-3)
        self.assertLess(flux, 1e-6)

    def test_ergun(self):
        """Ergun's pressure drop in the middle, within 0.5 %, of a gas of constant density, from dense to dilute and from viscous
        to inertial; the mass through each layer is what enters."""
        for alpha in (0.6, 0.5, 0.3, 0.1, 0.01):
            for reynolds in (0.01, 17, 1000):
                with self.subTest(alpha=alpha, reynolds=reynolds):
                    self.assertErgun(Bed(alpha, reynolds), steps=120 if alpha >= 0.5 else 60)

    def assertExpands(self, bed, outer=2, correctors=3, **more):
        """The drop of pressure between two layers in the bed, within 0.5 %; what enters leaves. The grains lie in the middle of
        their cells on average, along the bed: else their density, that of the cell, is not that of their place."""
        layers, entering, flux = self.run_bed(bed, outer=outer, correctors=correctors, offset=(*OFFSET[:2], 0), **more)
        p, temperature, (low, high) = layers["p"], layers["T"], (10, 30)
        expected = through_bed(bed, entering, p[low], temperature[low], CELL * (high - low))
        off = (p[low] - p[high]) / (p[low] - expected) - 1
        print(f"alpha_s {bed.alpha} U {bed.velocity:.3g} {more}: p {p[low]:.6g} to {p[high]:.6g}, expected {expected:.6g}, "
              f"drop off by {off:.1e}, flux by {flux:.1e}")
        self.assertGreater(p[low] / p[high], 1.15)
        self.assertLess(abs(off), 5e-3)
        self.assertLess(flux, 1e-3)

    def test_expanding_gas(self):
        """Air that expands to 0.8 of its density in the bed: Ergun's drop at the place's density, and what accelerates the gas, within
        0.5 %. Upwind would take the density in the flux of transonic solvers half a cell upstream: 2.5 % off."""
        fast = {"steps": 400, "time_step": 4e-5, "convection": "limitedLinear 1"}
        for bed, more in ((Bed(0.6, velocity=4.0), {"steps": 400, "time_step": 2e-4}),
                          (Bed(0.1, velocity=30.0), fast),
                          (Bed(0.1, velocity=30.0), {**fast, "energy": "h", "transonic": True}),
                          (Bed(0.1, velocity=30.0), {**fast, "solver": "sonicFoam"}),
                          (Bed(0.1, velocity=30.0), {**fast, "consistent": True, "transonic": True})):
            with self.subTest(alpha=bed.alpha, **more):
                self.assertExpands(bed, **more)

    def test_consistent(self):
        """SIMPLEC in rhoPimpleFoam."""
        for alpha, reynolds in ((0.6, 17), (0.3, 0.01), (0.1, 1000)):
            with self.subTest(alpha=alpha, reynolds=reynolds):
                self.assertErgun(Bed(alpha, reynolds), steps=120 if alpha >= 0.5 else 60, consistent=True)

    def test_turbulence_models(self):
        """Ergun's drop with a model of k and epsilon."""
        libs = '("libliggghtsCoupling.so" "libjetTurbulenceModels.so")'
        for model in ("kEpsilon", "jetKEpsilon"):
            with self.subTest(model=model):
                bed = Bed(0.3, 1000)
                self.assertErgun(bed, steps=60, turbulence=model, libs=libs, k=1e-3 * bed.velocity ** 2, epsilon=bed.velocity ** 3)

    def test_transport(self):
        """The gas carries k or nuTilda through the bed, where no eddy makes or destroys them: its path is no source of them, only
        the divergence of u is, by 2/3 k div u, of k. Without the void fraction in the equation there would be e times as much in
        the bed."""
        for model, name, more in (("kEpsilon", "k", {"coefficients": "Cmu 1e-12;", "epsilon": 1e-6}),
                                  # Ce is of the model, from v2112 on of all LES models
                                  ("kEqn", "k", {"simulation": "LES", "coefficients": "Ck 1e-12; Ce 1e-6;", "les_entries": "Ce 1e-6;"}),
                                  ("SpalartAllmaras", "nuTilda", {"coefficients": "Cb1 1e-12;", "nu_tilda": 1e-6})):
            with self.subTest(model=model):
                layers, _, _ = self.run_bed(Bed(0.3, velocity=1.0), steps=200, time_step=2e-3, gas="rhoConst", gas_density=RHO,
                                            pressure=1.0, turbulence=model, **more)
                e = layers["voidFraction"]
                u = numpy.concatenate(([1.0], 2 / (e[1:] + e[:-1]), [1.0]))     # at faces
                expected = numpy.cumprod(1 / (1 + 2 / 3 * (u[1:] / u[:-1] - 1))) if name == "k" else numpy.ones(len(e))
                value = layers[name] / more.get("nu_tilda", 1.0)
                print(f"{model}, {name} in the bed {value[20]:.6f}, expected {expected[20]:.6f}, "
                      f"behind it {value[-1]:.6f}, {expected[-1]:.6f}")
                # at the bed's ends the gas' own viscosity acts on k, too: nu/(U cell) = 4e-3 of a difference between layers
                self.assertLess(abs(value / expected - 1).max(), 1e-3)

    def test_ranks(self):
        """Serial and 2 ranks, whose cut lies in the middle of the bed, to the solvers' tolerance."""
        bed = Bed(0.6, 17)
        serial, parallel = (self.drop(bed, ranks, steps=20)[0] for ranks in (0, 2))
        self.assertLess(abs(parallel / serial - 1), 1e-9)


if __name__ == "__main__":
    unittest.main()
