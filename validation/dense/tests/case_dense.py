# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small versions of the dense verification: a bed between walls with slip, a suspension that settles, a porous plug that moves,
minimum fluidisation. The larger ones and their results: validation/dense/README.md."""
# label: long

import math
import unittest

import numpy

import fluidisation
import grainjet
import laws
import plug
import settling
from grainjet import coupled_box as box, dictionaries


class Dense(grainjet.Case):

    def test_bed_between_walls(self):
        """A bed from the floor to the outlet, in a channel two cells wide whose walls have slip: Ergun's pressure drop over all
        of it, and the same velocity in all cells. At a wall without slip the fluid between the grains has the wall's velocity."""
        rho, nu, cell, along, alpha, U = 1.2, 1.5e-5, 4e-3, 20, 0.4, 0.3
        spacing = cell/2
        d = spacing*(6*alpha/math.pi)**(1/3)
        slope = laws.ergun(1 - alpha, d, U, rho, rho*nu)
        case = self.new_folder()
        step = min(0.2*cell/U, 0.5*rho*U/slope)
        box.write(case, velocity=f"(0 0 {U})", walls=True, through=True, nu=nu, convection="upwind", delta_t=step, steps=60,
                  cells=f"2 2 {along}", size=[1e3*x for x in (2*cell, 2*cell, along*cell)])
        dictionaries.change(case/"0/U", ("noSlip", "slip"))
        dictionaries.change(case/"0/p", ("zlo { type zeroGradient; }", "zlo { type fixedFluxExtrapolatedPressure; }"))
        places = [[(n + 0.5)*spacing for n in (i, j, k)] for k in range(2*along) for j in range(4) for i in range(4)]
        box.script(case, dt=step/10, boundary="f f f", box=f"0 {2*cell} 0 {2*cell} 0 {along*cell}",
                   grains=box.grains(places, [(0, 0, 0)]*len(places), d, 1e11))
        box.fv_options(case, drag="Ergun", forces="(pressureGradient viscous)", voidFraction=box.void_fraction("full"))
        for program in ("blockMesh", "pimpleFoam"):
            self.foam(program, case)
        end = max((f.parent for f in case.glob("*/solidsFlux")), key=lambda f: float(f.name))
        p = rho*numpy.array(dictionaries.internal(end/"p")).reshape(along, 4).mean(1)
        measured = (p[0] - p[-2])/((along - 2)*cell)
        uneven = abs(numpy.array(dictionaries.internal(end/"U"))[:-4, 2]/U - 1).max()
        print(f"pressure drop over Ergun's {measured/slope:.5f}, velocity uneven by {uneven:.1e}")
        # As in case_fixed_bed of the coupling
        self.assertLess(abs(measured/slope - 1), 1e-4)
        self.assertLess(uneven, 1e-4)

    def test_settling(self):
        """Weight and drag in balance within 1 % and the return flow e u = - q, from crowded to dilute; no flux through any
        face, as the column is closed below."""
        for e in (0.5, 0.77, 0.99):
            with self.subTest(e=e):
                case = self.new_folder()
                settling.run(case, e)
                found = settling.result(case, e)
                print(f"{e}: " + ", ".join(f"{name} {value:.5g}" for name, value in found.items()))
                self.assertLess(abs(found["v/law"] - 1), 0.01)
                self.assertLess(abs(found["dp/weight"] - 1), 0.01)
                self.assertLess(abs(found["u/v"]/((1 - e)/e) - 1), 0.01)
                # To the solver's tolerance
                self.assertLess(found["flux"], 1e-9)

    def test_plug(self):
        """Bernoulli's pressure in a plug that moves through still fluid: 1 % too much with cells of two spacings (0.3 % with one,
        3 % with four). It is as smooth over time as the void fraction of the cell, which changes by 0.1 % as grains
        cross its faces; kicks in proportion to the inverse of the step would be 4 % in the mean, 10 % at most."""
        found = plug.run(self.new_folder(), plug.MESHES[2])
        print(f"pressure over Bernoulli's {found.pressure:.4f}, behind {found.behind:.4f}, roughness {found.roughness:.4f}, "
              f"largest deviation {found.largest:.4f}")
        self.assertLess(abs(found.pressure - 1), 0.02)
        self.assertLess(found.roughness, 0.003)
        self.assertLess(found.largest, 0.01)

    def test_fluidisation(self):
        """Air turned up: where the bed is lifted the air carries its weight within 1 %; U_mf is that of the law, layer by layer,
        within 3 %."""
        bed = fluidisation.Bed(grains=1000, across=3, height=0.056, hold=0, down=0, up=0.3, high=0.36)
        found = fluidisation.run(bed, self.new_folder())
        print(f"carried/weight {found.lifted:.4f}, {found.rising}")
        self.assertLess(abs(found.lifted - 1), 0.01)
        self.assertLess(abs(found.rising["ratio"] - 1), 0.03)


if __name__ == "__main__":
    unittest.main()
