# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the comparison with DPMFoam rests on: its parcels, as dpm_case.py sets them up, collide with each
other and with a wall like coarse grains, and grains enter at the rate and with the velocities of the main job."""

import math
import statistics
import unittest

import numpy

import dpm_case
import grainjet
import run
from grainjet import dictionaries, fields

QUICK_JET = grainjet.ROOT/"cases"/"quickJet"
SPEED = 5.0      # m/s, of each of two grains against each other, and of one against the wall

MESH = dictionaries.block((0, 0, 0), (0.004, 0.004, 0.004), "4 4 4", {
    "pipeWall": ("wall", "xlo"), "inlet": ("patch", "zlo"), "outlet": ("patch", "zhi"),
    "entrainment": ("patch", "xhi ylo yhi")})


class Grains(grainjet.Case):

    def write(self, p, steps):
        """A box of fluid too thin to matter, two grains about to meet, one before the wall."""
        case, start, grain = self.folder, self.folder/"0", p["cg"]*p["dParticle"]
        dictionaries.write(case/"system/blockMeshDict", MESH)
        dpm_case.write_dictionaries(case, QUICK_JET, p, steps*p["fluidStep"], p["fluidStep"])
        dpm_case.write_cloud_properties(case, p, dpm_case.resolution_steps(p, 1, SPEED))
        for name, dimensions, value in (("U.air", "0 1 -1", "(0 0 0)"), ("p", "0 2 -2", 0), ("k.air", "0 2 -2", 0.1),
                                        ("nut.air", "0 2 -1", 0), ("epsilon.air", "0 2 -3", 1)):
            dictionaries.write_field(case, name, dimensions, value, {".*": f"type fixedValue; value uniform {value};"})
        gap = 1.01*grain
        middle = 0.0025
        dpm_case.write_parcels(
            start, [(middle - gap/2, middle, middle), (middle + gap/2, middle, middle), (gap/2, 0.0012, 0.0012)],
            [(SPEED, 0, 0), (-SPEED, 0, 0), (-SPEED, 0, 0)], p)
        dpm_case.write_cloud(start, "stream", [(0.0035, 0.0005, 0.0035)], {
            "tag": ("labelField", "0"), "soi": ("scalarField", "0"), "d": ("scalarField", f"{p['dParticle']:g}"),
            "U": ("vectorField", "(0 0 0)")}, first_id=3)

    def test_contacts_of_grains(self):
        # no weight and a very thin fluid; steps of 1/40 of a contact and finer
        p = {**run.parameters(QUICK_JET), "fluidStep": 1e-6, "gravity": 0.0, "rhoFluid": 1e-6}
        steps = 80
        self.write(p, steps)
        self.foam("blockMesh")
        self.foam("DPMFoam")
        radius = p["cg"]*p["dParticle"]/2
        mass = p["rhoParticle"]*4/3*math.pi*radius**3
        modulus = p["youngsModulus"]/(2*(1 - p["poissonsRatio"]**2))
        states = [fields.grains_at(self.folder/"postProcessing"/"grains", i*1e-6) for i in range(1, steps + 1)]
        places = numpy.array([x[:3, 0] for _, x, _ in states])
        ends = states[-1][2]["U"][:3, 0]
        for name, overlap, after, m, r, v in (
                ("pair", 2*radius - (places[:, 1] - places[:, 0]), ends[1] - ends[0], mass/2, radius/2, 2*SPEED),
                ("wall", radius - places[:, 2], ends[2], mass, radius, SPEED)):
            # Hertz without damping; damping for e = 0.926 takes 3 % off the overlap and adds 1 % to
            # the time, both only of a grain of this mass: that of a particle would give 0.43 of them
            largest = (15*m*v**2/(16*math.sqrt(r)*modulus))**0.4
            lasts = 2.9432*largest/v
            seen = (overlap > 0).sum()*1e-6
            print(f"{name}: largest overlap {overlap.max()/largest:.3f}, time {seen/lasts:.3f} of Hertz, "
                  f"restitution {after/v:.3f} ({p['restitution']:g})")
            self.assertAlmostEqual(overlap.max()/largest, 1, delta=0.05)
            self.assertAlmostEqual(seen/lasts, 1, delta=0.05 + 1e-6/lasts)
            self.assertAlmostEqual(after/v, p["restitution"], delta=0.01)

    def test_entering_grains(self):
        p = run.parameters(QUICK_JET)
        times, places, velocities = dpm_case.entering(p, 0.05)
        mass = p["rhoParticle"]*math.pi/6*(p["cg"]*p["dParticle"])**3
        rate = p["massLoading"]*p["rhoFluid"]*p["Umean"]*math.pi/4*p["D"]**2
        self.assertAlmostEqual(len(times)*mass/0.05/rate, 1, delta=1/len(times))
        # 4 standard errors of the sample
        n = len(velocities)
        for i, (mean, rms) in enumerate(((0, p["uRmsRadial"]), (0, p["uRmsRadial"]), (p["Uinsertion"], p["uRmsAxial"]))):
            sample = [u[i] for u in velocities]
            self.assertAlmostEqual(statistics.mean(sample), mean, delta=4*rms/n**0.5)
            self.assertAlmostEqual(statistics.stdev(sample), rms, delta=4*rms/(2*n)**0.5)
        # evenly over the disc: the mean of r^2 is half its square; 4 standard errors
        reach = p["D"]/2 - p["cg"]*p["dParticle"]/2
        squares = [(x*x + y*y)/reach**2 for x, y, _ in places]
        self.assertLess(max(squares), 1)
        self.assertAlmostEqual(statistics.mean(squares), 0.5, delta=4*12**-0.5/n**0.5)


if __name__ == "__main__":
    unittest.main()
