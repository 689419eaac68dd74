# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# label: long
"""fix collision/stats in a gas of smooth elastic grains in equilibrium, against kinetic theory.

Per volume such a gas has 2 n^2 d^2 g sqrt(pi T/m) collisions in a second (Chapman & Cowling, 5.2, with Enskog's factor g of the
contact in 16.2), T/m being the variance of one component of velocity. g is the pair distribution at contact, by
Carnahan & Starling (1969) g = (1 - phi/2)/(1 - phi)^3. For grains that yield this counts those whose distance falls below d:
exact in equilibrium but for g, whose excess over 1 they lower by about one overlap in a diameter. The normal energy of a
collision, m* vn^2/2 with the density vn exp(-m vn^2/(4 T)) of approaching pairs, has the density exp(-E/T)/T, and so has the
tangential energy, of two components of velocity."""

import math
import unittest

from collision_case import CollisionCase, gas, mass
from scipy import stats

D, RHO, PHI, COUNT, SPEED = 0.001, 2500.0, 0.04, 1000, 1.0
DT, STEPS = 1.5e-6, 240000
BINS = 24

BODY = f"""
compute ke all ke
fix mean all ave/time 10 100 1000 c_ke file ke.txt
thermo 40000
thermo_style custom step f_k[1]
run {STEPS}
"""


class KineticTheory(CollisionCase):

    def test_frequency_and_spectra(self):
        grains, width = gas(COUNT, PHI, (D,), SPEED, seed=11)
        self.data(grains, width)
        m = mass(D, RHO)
        start = 4000 * DT
        self.liggghts(self.script(
            BODY, dt=DT, e=1.0, young=5e8, contact="fix c all hertz/cg tangential off",
            stats=f"fix k all collision/stats contact c energy {0.02 * m} {8 * m} {BINS} every {STEPS} file collisions.csv "
                  f"stats_start {start!r}"))
        energies = [float(line.split()[1]) for line in (self.folder / "ke.txt").read_text().split("\n")
                    if line and not line.startswith("#")][4:]
        # the gas as a whole does not move: three degrees of freedom less
        T = 2 / 3 * sum(energies) / len(energies) / (COUNT - 1)
        row = self.rows()["all", "all"]
        n = row["collisions"]
        g = (1 - PHI / 2) / (1 - PHI) ** 3
        # a grain meets the others, not itself
        pairs = COUNT * (COUNT - 1) / width ** 6
        frequency = 2 * pairs * D ** 2 * g * math.sqrt(math.pi * T / m)
        error = 1 / math.sqrt(n)
        print(f"{n:.0f} collisions: {row['frequency_per_volume']:.5g} 1/(s m3), theory {frequency:.5g}, "
              f"ratio {row['frequency_per_volume'] / frequency:.4f}, standard error at most {error:.4f}")
        self.assertLess(error, 0.0035)
        self.assertAlmostEqual(row["frequency_per_volume"] / frequency, 1.0, delta=0.01)
        self.assertAlmostEqual(row["frequency_per_grain_1"] * COUNT / width ** 3 / 2 / row["frequency_per_volume"], 1.0,
                               delta=1e-9)
        self.assertEqual(row["grains_1"], COUNT)
        self.assertEqual(row["lost"], 0)

        for quantity in ("normal_energy", "tangential_energy"):
            mean = row[f"{quantity}_mean"]
            print(f"{quantity}: mean {mean / T:.4f} T, skewness {row[quantity + '_skewness']:.3f} (2)")
            # four standard errors, and what the temperature varies by
            self.assertAlmostEqual(mean / T, 1.0, delta=4 * error + 1e-3)
            found = self.spectrum(quantity)
            expected = [n * (math.exp(-max(low, 0.0) / T) - math.exp(-high / T)) for low, high, _, _ in found]
            used = [(count, e) for (_, _, count, _), e in zip(found, expected) if e >= 5]
            chi2 = sum((count - e) ** 2 / e for count, e in used)
            probability = stats.chi2.sf(chi2, len(used))
            print(f"  chi square {chi2:.1f} of {len(used)} bins, probability {probability:.3f}")
            self.assertEqual(sum(count for _, _, count, _ in found), n)
            # a wrong law of 1e5 collisions gives thousands
            self.assertGreater(probability, 1e-3)

        spectrum = self.spectrum("normal_energy")
        self.assertAlmostEqual(sum(density * (high - low) for low, high, _, density in spectrum[1:-1]),
                               1 - (spectrum[0][2] + spectrum[-1][2]) / n, delta=1e-6)
        # the speed of approaching pairs: density g^3 exp(-m g^2/(4 T)), mean sqrt(T/m) 3/2 sqrt(pi)
        self.assertAlmostEqual(row["impact_speed_mean"] / (1.5 * math.sqrt(math.pi * T / m)), 1.0, delta=4 * error)


if __name__ == "__main__":
    unittest.main()
