/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/wall/spalding.h"
#include "physics/wall/spalding_table.h"
#include "physics/wall/wall_turbulence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using grainjet::wall::Spalding;
using grainjet::wall::SpaldingTable;
using grainjet::wall::WallTurbulence;

namespace {

// The formula in long double: 11 bits more than what is tested, so that the difference of the
// exponential and its series keeps 1e-15 from z = 0.01 on
long double formula(long double u, long double kappa, long double E)
{
  const long double z = kappa * u;
  return u + (std::exp(z) - 1 - z - z * z / 2 - z * z * z / 6) / E;
}

std::vector<double> powersOfTen(double first, double last)
{
  std::vector<double> values;
  for (double e = first; e <= last; e += 0.125) values.push_back(std::pow(10.0, e));
  return values;
}

}

TEST(Spalding, IsTheFormula)
{
  const Spalding law;
  for (double u = 0.03; u < 60; u *= 1.1) {
    const double exact = double(formula(u, 0.41L, 9.8L));
    EXPECT_NEAR(law.yPlus(u), exact, 4e-15 * exact) << u;
  }
}

// Places of the curve, from the formula by bisection
TEST(Spalding, KnownValues)
{
  const Spalding law;
  EXPECT_NEAR(law.uPlus(5), 4.890975, 1e-6);
  EXPECT_NEAR(law.uPlus(30), 13.068058, 1e-6);
  EXPECT_NEAR(law.uPlus(7.5) / law.uPlus(30), 0.531, 0.0005);
  EXPECT_NEAR(law.uPlus(10) / law.uPlus(100), 0.511, 0.0005);
}

TEST(Spalding, InverseOverAllScales)
{
  for (double kappa : {0.38, 0.41}) {
    for (double E : {5.0, 9.8}) {
      const Spalding law(kappa, E);
      for (double y : powersOfTen(-12, 15)) {
        const double u = law.uPlus(y);
        // The error of u+ is that of y+ over the slope, and y+ is good to some digits of its terms
        EXPECT_NEAR(law.yPlus(u), y, 2e-14 * y) << y;
      }
    }
  }
}

TEST(Spalding, LinearAtTheWallLogFarFromIt)
{
  const Spalding law;
  EXPECT_EQ(law.ratio(0), 1);
  EXPECT_EQ(law.uPlus(0), 0);
  // the first term that is left out at the wall: kappa^4 y^3/(24 E)
  for (double y : {1e-9, 1e-3, 0.1})
    EXPECT_NEAR(1 - law.ratio(y), std::pow(0.41, 4) * y * y * y / (24 * 9.8), 1e-7 + 1e-4 * y * y * y);
  for (double y : {1e5, 1e7, 1e10})
    EXPECT_NEAR(law.uPlus(y), std::log(9.8 * y) / 0.41, 2e-3);
}

TEST(Spalding, SlopeIsTheDerivative)
{
  const Spalding law;
  for (double u : {1e-3, 0.7, 1.2, 1.25, 8.0, 13.0, 25.0}) {
    const double h = 1e-4 * u;
    const double difference = (law.yPlus(u + h) - law.yPlus(u - h)) / (2 * h);
    EXPECT_NEAR(law.slope(u), difference, 1e-6 * difference) << u;
  }
}

// More and more slowly away from the wall, so that a velocity between is never above that at y_P
TEST(Spalding, RisesAndBends)
{
  const Spalding law;
  double u = 0, ratio = 1;
  for (double y : powersOfTen(-3, 6)) {
    EXPECT_GT(law.uPlus(y), u);
    EXPECT_LE(law.ratio(y), ratio);
    u = law.uPlus(y);
    ratio = law.ratio(y);
  }
}

// Within 1e-7 also between the nodes and at both ends; the wall's own limit is exact
TEST(SpaldingTable, IsTheLaw)
{
  for (double E : {5.0, 9.8}) {
    const Spalding law(0.41, E);
    const SpaldingTable table(law);
    for (double e = -12; e < 9; e += 0.00317) {
      const double y = std::pow(10.0, e);
      EXPECT_NEAR(table.uPlus(y), law.uPlus(y), 1e-7 * law.uPlus(y)) << y;
    }
    EXPECT_EQ(table.uPlus(0), 0);
    EXPECT_EQ(table.ratio(0), 1);
  }
}

TEST(SpaldingTable, Continuous)
{
  const SpaldingTable table{Spalding()};
  for (int octave = 0; octave < 23; ++octave)
    for (int i = 0; i < 32; ++i) {
      const double node = std::ldexp(1 + i / 32.0, octave) - 1, step = 1e-12 * (1 + node);
      if (node > 0) {
        EXPECT_NEAR(table.uPlus(node - step), table.uPlus(node + step), 1e-8) << node;
      }
    }
}

TEST(WallTurbulence, LogLayer)
{
  const WallTurbulence shapes;
  for (double y : {12.0, 30.0, 300.0}) {
    EXPECT_EQ(shapes.k(y), 1);
    EXPECT_DOUBLE_EQ(shapes.epsilon(y), 1 / y);
  }
}

TEST(WallTurbulence, Sublayer)
{
  const WallTurbulence shapes;
  // k = 0.07 y+^2 with k = 1/sqrt(Cmu) in the log layer
  for (double y : {0.0, 1.0, 4.0, 6.8}) EXPECT_NEAR(shapes.k(y) / 0.3, 0.07 * y * y, 1e-12);
  EXPECT_EQ(shapes.epsilon(0), shapes.epsilon(11));
  EXPECT_NEAR(shapes.epsilon(0) / 0.41, 0.21, 0.005);
  // continuous at the edges
  for (double edge : {1 / std::sqrt(0.07 * 0.3), 11.53}) {
    EXPECT_NEAR(shapes.k(edge * (1 + 1e-9)), shapes.k(edge * (1 - 1e-9)), 1e-8);
    EXPECT_NEAR(shapes.epsilon(edge * (1 + 1e-9)), shapes.epsilon(edge * (1 - 1e-9)), 1e-9);
  }
}
