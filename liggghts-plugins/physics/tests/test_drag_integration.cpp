/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/drag/exponential_drag.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using grainjet::drag::ExponentialDrag;

namespace {

const double MASS = 7.9e-10, DT = 1e-6;

double step(double v, double wind, double other, double tau, double h)
{
  const ExponentialDrag drag(MASS / tau, h, MASS);
  const double force = other + drag.slip * (wind - v) - drag.other * other;
  return v + h * force / MASS;
}

}

// tau dv/dt = u - v + tau f/m has v = w + (v0 - w) exp(-t/tau), w = u + tau f/m. Rounding per
// step is of the order of 1e-16 of the largest velocity; 1000 steps of random sign.
TEST(ExponentialDrag, ExactForConstantOtherForce)
{
  const double wind = 10, other = MASS * 9.81;
  for (double tau : {1e3 * DT, 50 * DT, DT, 0.1 * DT, 1e-3 * DT, 1e-9 * DT}) {
    const double terminal = wind + tau * other / MASS;
    double v = -3;
    for (int i = 1; i <= 1000; i++) {
      v = step(v, wind, other, tau, DT);
      const double exact = terminal + (-3 - terminal) * std::exp(-i * DT / tau);
      ASSERT_NEAR(v, exact, 1e-13 * 13) << "tau/dt " << tau / DT << ", step " << i;
    }
  }
}

TEST(ExponentialDrag, NoDragLeavesTheOtherForceAlone)
{
  const ExponentialDrag drag(0, DT, MASS);
  EXPECT_EQ(drag.slip, 0);
  EXPECT_EQ(drag.other, 0);
}

// For tau << dt the grain has the fluid's velocity after one step, whatever it had before
TEST(ExponentialDrag, StiffLimit)
{
  EXPECT_NEAR(step(-100, 10, 0, 1e-3 * DT, DT), 10, 1e-12);
  EXPECT_NEAR(step(1e6, 10, 0, 1e-12 * DT, DT), 10, 1e-9);    // 1e-15 of the change
}

// Reference: 1 - phi1 = 1 + expm1(-x)/x in 64-bit mantissa, x from nearly 0 to past the
// point where the series takes over
TEST(ExponentialDrag, FactorsForAnyRatio)
{
  for (double x = 1e-12; x < 1e4; x *= 1.3) {
    const ExponentialDrag drag(x, 1, 1);
    const long double exact = 1 + expm1l(-static_cast<long double>(x)) / x;
    // 1e-18: what the reference loses by cancellation at small x; 4.5e-16: two roundings of
    // phi1, once it is no longer taken from the series
    EXPECT_NEAR(drag.other, static_cast<double>(exact),
      1e-15 * exact + 1e-18 + (x < 0.05 ? 0 : 4.5e-16)) << x;
    EXPECT_NEAR(drag.slip, static_cast<double>(-expm1l(-static_cast<long double>(x))),
      1e-15 * std::min(x, 1.0)) << x;
  }
}

// Splitting a kick in two halves changes nothing: the scheme is the exact solution
TEST(ExponentialDrag, SemigroupProperty)
{
  for (double tau : {100 * DT, DT, 0.01 * DT}) {
    const double other = 1e-3 * MASS / tau;
    const double once = step(2, 5, other, tau, DT);
    const double twice = step(step(2, 5, other, tau, DT / 2), 5, other, tau, DT / 2);
    EXPECT_NEAR(once, twice, 1e-13);
  }
}
