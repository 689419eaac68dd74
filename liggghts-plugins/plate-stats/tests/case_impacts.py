# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix plate/stats: single impacts against Hertz and the closed form of a sliding impact,
and streams whose counts are known."""
# processors: 2

import math
import unittest

import numpy

from plate_case import D, MASS, PLANE, PLATE, PlateCase, hertz

QUANTITIES = {"normal_force_peak": "normal_force_peak", "tangential_force_peak": "tangential_force_peak",
              "normal_force": "normal_force", "tangential_force": "tangential_force",
              "impact_speed": "speed_before", "impact_angle": "angle", "duration": "duration",
              "energy_loss": "energy_loss"}


def stream():
    """300 grains whose collisions are known: (grains, expected count per ring). Rings are 1 mm
    wide; grain i touches the plate at 20 us + i 10 us, between 0.1 and 0.9 of its ring's
    width, with a speed and a direction of its own."""
    grains, count = [], [0] * 5
    for i in range(300):
        ring = (i * i + i // 7) % 7            # 5 and 6 are outside the plate
        r = (ring + 0.1 + 0.8 * ((i * 37) % 100) / 100) * 1e-3
        angle, time = 2.399963 * i, 2e-5 + 1e-5 * i
        vx, vy, vz = 0.5 * math.sin(i), 0.5 * math.cos(3 * i), -1.5 - 0.1 * (i % 11)
        grains.append((r * math.cos(angle) - vx * time, r * math.sin(angle) - vy * time,
                       D / 2 - vz * time, vx, vy, vz))
        if ring < 5:
            count[ring] += 1
    return grains, count


class Impacts(PlateCase):

    def test_hertz(self):
        """Peak force within 1 % and duration within 3 % of Hertz: what is left is the time
        step, 1/100 of the contact, and no energy is lost beyond what the integrator makes
        of it (0.1 %)."""
        for speed in (0.5, 2.0, 10.0):
            peak, duration = hertz(speed)
            self.data([(0, 0, D, 0, 0, -speed)])
            self.liggghts(self.script(
                f"{PLATE}\nrun {int(1.5 * (D / speed + duration) / (duration / 100))}",
                dt=duration / 100))
            row = self.table()["all"]
            self.assertEqual(row["collisions"], 1)
            self.assertAlmostEqual(row["normal_force_peak_mean"] / peak, 1, delta=0.01)
            self.assertAlmostEqual(row["duration_mean"] / duration, 1, delta=0.03)
            self.assertEqual(row["tangential_force_peak_mean"], 0)
            self.assertAlmostEqual(row["impact_speed_mean"], speed, delta=1e-9 * speed)
            self.assertEqual(row["impact_angle_mean"], 0)
            self.assertLess(abs(row["energy_loss_mean"]), 1e-3 * 0.5 * MASS * speed ** 2)
            # mean force times duration is the change of momentum: exact for velocity Verlet
            event, = self.events()
            gained = MASS * (event["speed_before"] + event["speed_after"])
            self.assertAlmostEqual(event["normal_force"] * event["duration"] / gained, 1, delta=1e-6)

    def test_restitution(self):
        """Energy lost is (1 - e^2) of the energy brought, e as it comes out of the contact law
        (LIGGGHTS' dashpot hits e within 1 % here)."""
        e = 0.8
        self.data([(0, 0, D, 0, 0, -2.0)])
        self.liggghts(self.script(f"{PLATE}\nrun 1500", e=e))
        event, = self.events()
        self.assertAlmostEqual(event["speed_after"] / event["speed_before"], e, delta=0.01)
        self.assertAlmostEqual(event["energy_loss"] / (0.5 * MASS * (2.0 ** 2 - event["speed_after"] ** 2)),
                               1, delta=1e-5)

    def test_oblique_sliding_impact(self):
        """Beyond tan(angle) = 7/2 mu (1 + e) the grain slides throughout: tangential force = mu
        normal force, dv_t = mu (1 + e) v_n, spin 5/2 dv_t/R (Walton 1993). Stiff, since
        LIGGGHTS shortens the lever by half the overlap; that and the tangential spring
        at first touch leave 1 %."""
        mu, vn, vt = 0.1, 2.0, 4.0
        self.assertGreater(vt / vn, 3.5 * mu * 2)
        for direction in (0.0, 0.7, 2.5):
            self.data([(0, 0, D, vt * math.cos(direction), vt * math.sin(direction), -vn)])
            self.liggghts(self.script(f"{PLATE}\nrun 3000", mu=mu, young=5e8, dt=1e-8))
            row, (event,) = self.table()["all"], self.events()
            self.assertAlmostEqual(row["impact_speed_mean"], math.hypot(vn, vt), delta=1e-8)
            self.assertAlmostEqual(row["impact_angle_mean"], math.degrees(math.atan2(vt, vn)), delta=1e-6)
            self.assertAlmostEqual(row["tangential_force_mean"] / (mu * row["normal_force_mean"]), 1,
                                   delta=0.01)
            self.assertAlmostEqual(
                row["tangential_force_peak_mean"] / (mu * row["normal_force_peak_mean"]), 1, delta=0.01)
            change = mu * 2 * vn
            after = math.hypot(vn, vt - change)
            self.assertAlmostEqual(event["speed_after"] / after, 1, delta=0.002)
            spin = 2.5 * change / (D / 2)
            lost = 0.5 * MASS * (vt ** 2 - (vt - change) ** 2 - 0.4 * (D / 2) ** 2 * spin ** 2)
            self.assertAlmostEqual(event["energy_loss"] / lost, 1, delta=0.01)
            self.assertAlmostEqual(event["x"], (D / 2 / vn) * vt * math.cos(direction), delta=1e-6)

    def test_stream(self):
        """Counts per ring and frequencies exact, moments those of the events, the same on any
        number of ranks."""
        grains, count = stream()
        tables = []
        for ranks in (0, 1, 2, 4):
            self.data(grains)
            self.liggghts(self.script(f"{PLATE}\nrun 10000\nrun 10000", dt=2e-7, pair="",
                                      processors="2 2 1" if ranks == 4 else "* 1 1",
                                      sort="0 0" if ranks == 1 else "10 0.001"), ranks)
            table, events = self.table(), self.events()
            self.assertEqual([table[f"ring{i}"]["collisions"] for i in range(1, 6)], count)
            self.assertEqual(table["all"]["collisions"], sum(count))
            self.assertEqual(len(events), sum(count))
            for region, row in table.items():
                self.assertEqual((row["touching"], row["deleted"]), (0, 0))
                self.assertAlmostEqual(row["time"], 20000 * 2e-7, delta=1e-12)
                self.assertAlmostEqual(row["frequency"] * row["time"], row["collisions"], delta=1e-6)
                self.assertEqual(row["particle_frequency"], row["frequency"])
                inside = [e for e in events
                          if row["r_in"] <= math.hypot(e["x"], e["y"]) < row["r_out"]]
                self.assertEqual(len(inside), row["collisions"])
                for name, column in QUANTITIES.items():
                    values = numpy.array([e[column] for e in inside])
                    scale = abs(values).max() or 1
                    # events carry 7 digits
                    self.assertAlmostEqual(row[f"{name}_mean"] / scale, values.mean() / scale, delta=1e-6)
                    self.assertAlmostEqual(row[f"{name}_variance"] / scale ** 2,
                                           values.var(ddof=1) / scale ** 2, delta=1e-6)
                    self.assertAlmostEqual(row[f"{name}_standard_error"] / scale,
                                           values.std(ddof=1) / math.sqrt(len(values)) / scale, delta=1e-6)
            tables.append((table, (self.folder / "plate.csv").read_text(),
                           (self.folder / "events.csv").read_text()))
        for other in tables[1:]:
            self.assertEqual(other[1:], tables[0][1:])

    def test_skewness_of_known_speeds(self):
        """Impact speeds 1, 2, 3, 10 m/s: mean 4, variance 50/3, g1 = 45/12.5^1.5."""
        self.data([(0.001 * i, 0, D, 0, 0, -v) for i, v in enumerate((1.0, 2.0, 3.0, 10.0))])
        self.liggghts(self.script(f"{PLATE}\nrun 2000"))
        row = self.table()["all"]
        self.assertAlmostEqual(row["impact_speed_mean"], 4, delta=1e-8)
        self.assertAlmostEqual(row["impact_speed_variance"], 50 / 3, delta=1e-7)
        self.assertAlmostEqual(row["impact_speed_skewness"], 45 / 12.5 ** 1.5, delta=1e-7)

    def test_two_bounces_on_two_plates(self):
        """A grain between two plates: every bounce is a collision of its own, on the right
        plate, from whichever side; without loss they come at equal intervals."""
        gap, speed = 4 * D, 4.0
        walls = PLANE + PLANE.replace("fix w ", "fix w2 ").replace("0.0 store", f"{gap!r} store")
        second = PLATE.replace("fix p", "fix p2").replace("wall w", "wall w2").replace(
            "centre 0 0 0 normal 0 0 1", f"centre 0 0 {gap!r} normal 0 0 1").replace("plate.csv", "top.csv")
        second = second.replace("events.csv", "top-events.csv")
        self.data([(0, 0, gap / 2, 0, 0, -speed)])
        peak, duration = hertz(speed)
        # contact times overlap the flight by the depth: distance between touches is gap - D
        period = 2 * ((gap - D) / speed + duration)
        steps = int(10.25 * period / 1e-7)
        self.liggghts(self.script(f"{PLATE}\n{second}\nrun {steps}", wall=walls))
        bottom, top = self.table()["all"], self.table("top.csv")["all"]
        self.assertEqual(bottom["collisions"], 10)
        self.assertEqual(top["collisions"], 10)
        times = [e["time"] for e in self.events()]
        numpy.testing.assert_allclose(numpy.diff(times), period, rtol=0.01)    # steps of 1e-7
        self.assertAlmostEqual(top["normal_force_peak_mean"] / peak, 1, delta=0.01)
        self.assertEqual(top["impact_angle_mean"], 0)

    def test_with_hertz_cg(self):
        """fix hertz/cg makes neighbour lists when it sees fit; the plate misses nothing: the
        table of the stock pair style, to the rounding of the printed digits."""
        grid = [-0.0045 + 0.001 * i for i in range(10)]
        self.data([(x, y, D + 0.0001 * ((i * 7 + j * 3) % 31), 3.0 * math.sin(i), 3.0 * math.sin(j),
                    -0.5 - 0.7 * ((i + j) % 10)) for i, x in enumerate(grid) for j, y in enumerate(grid)])
        tables = []
        for extra in ({}, {"pair": "fix c all hertz/cg", "before": "plugin load hertzcgplugin.so\n"}):
            self.liggghts(self.script(f"{PLATE}\nrun 10000", **extra), 2)
            tables.append(self.table())
        self.assertGreater(tables[0]["all"]["collisions"], 50)
        for region, row in tables[0].items():
            for key, value in row.items():
                numpy.testing.assert_allclose(tables[1][region][key], value, rtol=1e-8, atol=1e-14,
                                              err_msg=f"{region} {key}")

    def test_coarse_grained(self):
        """One grain stands for f_cg^3 particles: the file counts both."""
        self.data([(0.001 * i, 0, 2 * D, 0, 0, -2.0) for i in range(3)])
        cg = "plugin load hertzcgplugin.so\ncoarsegraining 2\n"
        self.liggghts(self.script(f"{PLATE}\nrun 2000", before=cg))
        row = self.table()["all"]
        self.assertEqual(row["collisions"], 3)
        self.assertAlmostEqual(row["particle_frequency"] / row["frequency"], 8, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
