/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/heat/lumped_temperature.h"
#include "physics/heat/nusselt.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

using namespace grainjet::heat;

namespace {

const double D = 50e-6, NU = 1.5e-5;

// The slip speed follows from the Reynolds number |ur| d/nu
State state(double re, double prandtl, double voidFraction = 1, double viscosityRatio = 1)
{
  return {voidFraction, re * NU / D, D, NU, prandtl, viscosityRatio};
}

}

// Evaluated from the correlations as printed, with 50 digits. Tolerance: roots and powers of doubles. Gunn's Reynolds
// number has the superficial velocity: Re/eps here gives Re there
TEST(Nusselt, ReferenceValues)
{
  const double exact = 1e-14;
  EXPECT_NEAR(ranzMarshall(state(100, 0.7)) / 7.3274240104556042506, 1, exact);
  EXPECT_NEAR(whitaker(state(1000, 0.7)) / 18.169527955451324660, 1, exact);
  EXPECT_NEAR(whitaker(state(1000, 5, 1, 2)) / 44.218580410947374012, 1, exact);
  EXPECT_NEAR(gunn(state(50 / 0.4, 0.7, 0.4)) / 16.680465558828180353, 1, exact);
  EXPECT_NEAR(gunn(state(50, 0.7)) / 6.5030366855518965757, 1, exact);
  EXPECT_NEAR(gunn(state(2000 / 0.7, 0.7, 0.7)) / 52.631567763145416772, 1, exact);
}

// Conduction into a fluid at rest around a lone sphere: 2, without a floating-point exception, which would
// end OpenFOAM
TEST(Nusselt, Rest)
{
  std::feclearexcept(FE_ALL_EXCEPT);
  for (const NamedNusselt &entry : NUSSELT_LAWS) EXPECT_EQ(entry.law(state(0, 0.7)), 2) << entry.name;
  EXPECT_DOUBLE_EQ(gunn(state(0, 0.7, 0.5)), 7 - 5 + 1.25);
  EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));
}

// Flow, a larger Prandtl number and, by Gunn, a denser bed transfer more heat
TEST(Nusselt, Grows)
{
  for (const NamedNusselt &entry : NUSSELT_LAWS)
    for (double re = 0.01; re < 1e4; re *= 3) {
      EXPECT_GT(entry.law(state(3 * re, 0.7)), entry.law(state(re, 0.7))) << entry.name << re;
      EXPECT_GT(entry.law(state(re, 7)), entry.law(state(re, 0.7))) << entry.name << re;
    }
  EXPECT_GT(gunn(state(10 / 0.4, 0.7, 0.4)), gunn(state(10 / 0.7, 0.7, 0.7)));
  EXPECT_EQ(ranzMarshall(state(10, 0.7, 0.4)), ranzMarshall(state(10, 0.7)));
}

// Two correlations of one thing, lone spheres in air, whose data scatter by 25 % or so (Whitaker 1972)
TEST(Nusselt, Agree)
{
  for (double re = 3.5; re < 200; re *= 1.5)
    EXPECT_NEAR(whitaker(state(re, 0.71)) / ranzMarshall(state(re, 0.71)), 1, 0.25) << re;
}

TEST(Nusselt, Names)
{
  EXPECT_EQ(findNusselt("gunn"), gunn);
  EXPECT_EQ(findNusselt("Gunn"), nullptr);
  EXPECT_EQ(nusseltNames(), "ranzMarshall, gunn, whitaker");
}

// Air at M 2 past a particle at rest: T = 300 K, c = 347.2 m/s, u = 694.4 m/s, u^2/(2 cp) = 0.8 T since
// (gamma - 1)/2 M^2 = 0.8: the recovery temperature is T (1 + 0.8 r)
TEST(LumpedTemperature, Recovery)
{
  const double gamma = 1.4, R = 287, T = 300, prandtl = 0.7056;    // r = 0.84
  EXPECT_DOUBLE_EQ(recoveryFactor(prandtl), 0.84);
  const double speed = 2 * std::sqrt(gamma * R * T);
  EXPECT_NEAR(recoveryTemperature(T, speed, gamma * R / (gamma - 1), prandtl) / (T * (1 + 0.8 * 0.84)), 1, 1e-15);
  EXPECT_EQ(recoveryTemperature(T, 0, 1005, 0.7), T);
}

// A grain of f^3 particles takes f^3 times the heat of one of them at any f, and has their Biot number
TEST(LumpedTemperature, CoarseGrains)
{
  const double nusselt = 5, k = 0.025, kp = 2;
  const double one = grainCoefficient(nusselt, k, D, 1);
  EXPECT_NEAR(one / (nusselt * k / D * M_PI * D * D), 1, 1e-15);
  for (double f : {2.0, 3.7, 20.0}) {
    EXPECT_NEAR(grainCoefficient(nusselt, k, D, f) / (f * f * f * one), 1, 1e-14) << f;
    EXPECT_NEAR(biot(grainCoefficient(nusselt, k, D, f), D, f, kp) / biot(one, D, 1, kp), 1, 1e-14) << f;
  }
  // h d/(6 kp) with h = Nu k/d
  EXPECT_NEAR(biot(one, D, 1, kp) / (nusselt * k / (6 * kp)), 1, 1e-15);
}

// 1 - exp(-x) with 40 digits, on both sides of the change at 1e-3. Tolerance: rounding of doubles
TEST(LumpedTemperature, HeatingFraction)
{
  const double values[][2] = {
    {1e-12, 9.9999999999950000000000016666666666663e-13}, {1e-6, 9.9999950000016666662500000833333194444464e-7},
    {9.9e-4, 9.8951011167648308985965609210525925994e-4}, {9.99999e-4, 9.9949916762450799906940108110108894877e-4},
    {1e-3, 9.9950016662500833319446428323440252976e-4}, {0.1, 0.095162581964040426835750940550563537881},
    {1, 0.63212055882855767840447622983853913255}, {40, 0.99999999999999999575164574470841100467}};
  for (const double *v : values) EXPECT_NEAR(heatingFraction(v[0]) / v[1], 1, 4e-16) << v[0];
  EXPECT_EQ(heatingFraction(0), 0);
  EXPECT_EQ(heatingFraction(1e300), 1);
}

// Many short steps go the way of one long one. Tolerance: rounding of each step
TEST(LumpedTemperature, AnyTimeStep)
{
  for (int steps : {10, 1000, 100000}) {
    double left = 1;
    for (int n = 0; n < steps; n++) left -= heatingFraction(2.0 / steps) * left;
    EXPECT_NEAR(left / std::exp(-2.0), 1, 1e-15 * steps) << steps;
  }
}
