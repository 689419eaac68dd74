#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of the elbow case, and what must hold in its results. Exit code 1 if anything does not.

    check.py [folder of the case]
"""

import pathlib
import sys

import numpy

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1]/"common"), str(pathlib.Path(__file__).resolve().parent)]
import bend
import check as jet                 # judges and prints


class Results:

    def __init__(self, case):
        self.bend = bend.Bend(case)

    def table(self):
        b, p = self.bend, self.bend.p
        yield (f"Sand of {1e6*p['dParticle']:g} um in air of {p['Umean']:g} m/s, pipe {1e3*p['D']:g} mm, r/D = {p['bendRadius']:g}; "
               f"Stokes number {b.stokes():.0f}; {1e3*p['endTime']:g} ms")
        yield ""
        yield f"Outer line (within {bend.HALF_STRIP:g} degrees of it around the pipe)"
        yield "along the bend      hits    first     speed    angle from the surface     wear depth"
        yield "degrees                     hits       m/s    degrees                   um/kg of sand"
        for low in range(0, 90, 10):
            inside = b.outer & (b.along >= low) & (b.along < low + 10)
            n, wear = inside.sum(), b.events["wear_volume"][inside].sum()
            mean = [x[inside].mean() if n else numpy.nan for x in (b.speed, numpy.degrees(b.angle))]
            yield (f"{low:3d} - {low + 10:3d}        {n:8d} {(inside & b.first).sum():8d}    {mean[0]:6.2f}    {mean[1]:6.2f}"
                   f"                 {1e6*wear/b.area(10)/b.sand:10.1f}")
        yield ""
        yield "Largest wear depth along the outer line, degrees from the beginning of the bend (law by hand, standard error)"
        for name, law in bend.LAWS.items():
            all_hits, first = b.maximum(law), b.maximum(law, b.first)
            yield f"  {name:16s}  all hits {all_hits[0]:5.1f} +- {all_hits[1]:3.1f}    first hits {first[0]:5.1f} +- {first[1]:3.1f}"
        yield f"  straight flight hits at {b.straight(0):.1f} from the axis, at {b.straight(-1):.1f} from the inner side of the pipe"
        yield "  published: 29 to 42 (measured: 12.7 mm, r/D 1.5, 45.72 m/s, 300 um; J. Fluids Eng. 138 (2016) 044501),"
        yield "             45 to 55 (computed, standard bend of 90 degrees, air and sand; Eng. Proc. 45 (2023) 28)"
        yield ""
        yield (f"Wear, mm3/kg of sand: bend {self.per_kg(b.in_bend):.3f}, of it by first hits {self.per_kg(b.in_bend & b.first):.3f}; "
               f"pipe behind it {self.per_kg(~b.in_bend):.3f}")

    def per_kg(self, where):
        return 1e9*self.bend.events["wear_volume"][where].sum()/self.bend.sand

    def checks(self):
        b, volume = self.bend, self.bend.map.values["wear_volume"]
        checks = []
        for region, where, number in (("bend", b.in_bend, 0), ("behind", ~b.in_bend, 1)):
            hand, total = b.by_hand(where), float(b.totals[region]["wear_volume"])
            of_map = volume[b.map.values["mesh"] == number].sum()
            checks.append((abs(total/hand - 1) < 1e-6 and abs(of_map/hand - 1) < 1e-6,
                           f"{region}: wear {1e9*total:.6g} mm3, of the map {1e9*of_map:.6g}; the law by hand on {where.sum()} logged hits "
                           f"gives {1e9*hand:.6g}"))
        # the mesh is a prism of 24 sides, which lies up to 0.9 % of the radius inside the circle; contacts are deep
        e, R = b.events, b.R
        x, z = e["x"][b.in_bend], e["z"][b.in_bend]
        away = numpy.hypot(numpy.hypot(x - b.radius, z) - b.radius, e["y"][b.in_bend])/R
        checks.append((abs(away - 1 + b.p["cg"]*b.p["dParticle"]/2/R).max() < 0.03,
                       f"hits of the bend lie at {away.min():.3f} to {away.max():.3f} of the radius (a grain's radius inside)"))
        unaccounted = abs(b.balance["unaccounted"]).max()
        checks.append((unaccounted == 0, f"grains unaccounted for at any step: {unaccounted:.0f}"))
        outside = b.balance["outsideMesh"].max()
        checks.append((outside == 0, f"grains outside the mesh at any step: {outside:.0f}"))
        inner = b.events["wear_volume"][b.in_bend & (abs(b.around) > 90)].sum()/b.events["wear_volume"][b.in_bend].sum()
        checks.append((inner < 0.5, f"share of the inner half of the bend in its wear: {inner:.3f} (below 0.5)"))
        return checks


if __name__ == "__main__":
    sys.exit(jet.judge(Results(jet.case())))
