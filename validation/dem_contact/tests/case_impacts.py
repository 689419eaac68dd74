# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Impacts with closed-form results: Hertz, restitution, and the tests of Chung & Ooi, Granular Matter 13
(2011) 643, as far as they have one (elastic normal impacts; oblique ones that slide all the time)."""

import math
import unittest

from grainjet import Case, dumps, impacts as im, scripts

GLASS = im.Material(youngs=48e9, poisson=0.20, restitution=1.0, friction=0.35)              # test 1
ALLOY = im.Material(youngs=70e9, poisson=0.30, restitution=1.0, friction=0.0, rigid=True)   # test 2
OXIDE = im.Material(youngs=380e9, poisson=0.23, restitution=0.98, friction=0.092, rigid=True)   # tests 3, 4


class Impacts(Case):

    def history(self, material, ball, speed, plane):
        """Largest overlap, peak force and duration of one impact, from every step of it."""
        im.run(self.folder, material, ball, [im.Impact(speed)], plane=plane,
               extra=scripts.dump(1, "history", "id x fx", "h"))
        one, other = ([row for frame in dumps.frames(self.folder / "history") for row in frame.rows if row[0] == n]
                      for n in (1, 2))
        dt = im.hertz(material, ball, speed, plane)[2] / 2000
        radii = ball.radius * (1 + (im.LARGE if plane else 1))
        overlap = max(radii - (b[1] - a[1]) for a, b in zip(one, other))
        return overlap, max(abs(a[2]) for a in one), sum(a[2] != 0.0 for a in one) * dt

    def check_hertz(self, name, material, ball, speed, plane):
        found, expected = self.history(material, ball, speed, plane), im.hertz(material, ball, speed, plane)
        for quantity, a, b in zip(("overlap", "peak force", "duration"), found, expected):
            print(f"{name}: {quantity} {a:.6g}, Hertz {b:.6g}, {100 * (a / b - 1):+.3f} %")
            self.assertLess(abs(a / b - 1), 0.002)     # 2000 steps per contact

    def test_hertz(self):
        self.check_hertz("Chung & Ooi 1, glass", GLASS, im.Ball(0.010, 2800), 20.0, False)
        self.check_hertz("Chung & Ooi 2, Al alloy on a plane", ALLOY, im.Ball(0.10, 2699), 0.2, True)
        self.check_hertz("glass beads of 80 um", im.Material(5e6, 0.3, 1.0, 0.18), im.Ball(40e-6, 2950), 1.0, False)

    def test_cited_peak_force_of_test_1(self):
        """Peak force 10.7 kN and duration 40 us as printed in Chung & Ooi's figures 2 and 3, read off to 3 %."""
        _, force, duration = self.history(GLASS, im.Ball(0.010, 2800), 20.0, False)
        self.assertAlmostEqual(force, 10.7e3, delta=0.03 * 10.7e3)
        self.assertAlmostEqual(duration, 40e-6, delta=0.03 * 40e-6)

    def test_restitution_out_is_restitution_in(self):
        """Chung & Ooi 3, from 0.1 to 1, on a plane and between balls, at speeds a factor 100 apart. The
        tolerance is the explicit end of a contact, a step of 1/2000 of it or a few where it is long."""
        for e in (0.1, 0.2, 0.4, 0.6, 0.8, 0.98, 1.0):
            material = im.Material(380e9, 0.23, e, 0.0, rigid=True)
            for plane in (True, False):
                speeds = [im.Impact(0.04), im.Impact(0.4), im.Impact(4.0)]
                for impact, after in zip(speeds, im.run(self.folder, material, im.Ball(0.0025, 4000), speeds, plane)):
                    found = after.normal / impact.normal
                    self.assertAlmostEqual(found, e, delta=2e-3, msg=f"{impact}, plane {plane}")
            print(f"e in {e}, out {found:.5f}")

    def test_sliding_oblique_impacts(self):
        """Chung & Ooi 4: sliding throughout, e_t = 1 - mu (1 + e)/tan(angle), spin 5/2 mu (1 + e) vn/R.
        The dashpot's pull at the end of a contact lets friction act on a little more than (1 + e) vn."""
        ball, speed = im.Ball(0.0025, 4000), 3.9
        angles = [40, 45, 50, 55, 60, 65, 70, 75, 80]
        states = [im.Impact(speed * math.cos(math.radians(a)), speed * math.sin(math.radians(a))) for a in angles]
        mu, e = OXIDE.friction, OXIDE.restitution
        for angle, before, after in zip(angles, states, im.run(self.folder, OXIDE, ball, states, plane=True)):
            e_t = 1 - mu * (1 + e) / math.tan(math.radians(angle))
            spin = 2.5 * mu * (1 + e) * before.normal / ball.radius
            print(f"{angle} degrees: e_t {after.tangential / before.tangential:.5f} ({e_t:.5f}), "
                  f"spin {abs(after.spin):.2f} ({spin:.2f})")
            self.assertAlmostEqual(after.tangential / before.tangential, e_t, delta=5e-4)
            self.assertAlmostEqual(abs(after.spin), spin, delta=2e-3 * spin)

    def test_sliding_impacts_of_a_spinning_ball(self):
        """Chung & Ooi 6: a spinning ball falls on a plane; sliding throughout, the patch loses
        7/2 mu (1 + e) vn of its velocity. With e = 1, for the pull of the dashpot at the end of a contact
        would add to the friction (with the paper's e = 0.5 a quarter of it)."""
        material = im.Material(70e9, 0.33, 1.0, 0.4, rigid=True)
        ball, vn = im.Ball(0.1, 2700), 0.2
        ratios = [4.0, 5.0, 6.0, 8.0]
        states = [im.Impact(vn, 0.0, r * vn / ball.radius) for r in ratios]
        for ratio, after in zip(ratios, im.run(self.folder, material, ball, states, plane=True)):
            patch = abs(after.spin * ball.radius) - abs(after.tangential)
            recoil = ratio - 3.5 * material.friction * (1 + material.restitution)
            print(f"Vst/Vcn {ratio}: recoil {patch / vn:.4f} ({recoil:.4f})")
            self.assertAlmostEqual(patch / vn, recoil, delta=2e-3 * ratio)

    def test_equal_spheres_with_opposite_slip(self):
        """Chung & Ooi 5 and 7: two equal balls share the slip; sliding throughout, each loses the tangential
        impulse mu (1 + e) vn/2 and gains the spin 5/4 mu (1 + e) vn/R. Very stiff, so that they do not turn about each other meanwhile."""
        material = im.Material(70e14, 0.33, 0.98, 0.1)
        ball = im.Ball(0.01, 2700)
        states = [im.Impact(0.2, 0.4), im.Impact(0.2, 0.8)]
        for before, after in zip(states, im.run(self.folder, material, ball, states)):
            loss = material.friction * (1 + material.restitution) * before.normal
            self.assertAlmostEqual(before.tangential - after.tangential, loss, delta=3e-3 * loss)
            self.assertAlmostEqual(abs(after.spin), 1.25 * loss / ball.radius, delta=3e-3 * 1.25 * loss / ball.radius)

    def test_factor_does_not_change_the_dimensionless_impact(self):
        """f_cg 1, 2, 3, 5: the same velocities after, spin over f_cg; round-off in some thousand steps."""
        states = [im.Impact(0.5, 0.05), im.Impact(0.5, 0.3), im.Impact(2.0, 4.0)]
        material = im.Material(5e6, 0.3, 0.9, 0.18)
        one = im.run(self.folder, material, im.Ball(40e-6, 2950), states)
        for f in (2, 3, 5):
            for a, b in zip(one, im.run(self.folder, material, im.Ball(f * 40e-6, 2950), states, factor=f)):
                self.assertAlmostEqual(a.normal, b.normal, delta=1e-9)
                self.assertAlmostEqual(a.tangential, b.tangential, delta=1e-9)
                self.assertAlmostEqual(a.spin, f * b.spin, delta=1e-9 * abs(a.spin))


if __name__ == "__main__":
    unittest.main()
