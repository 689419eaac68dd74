/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/turbulence/grain_random.h"
#include "physics/wall/rough_wall.h"

#include <gtest/gtest.h>

#include <cmath>

using grainjet::contact::Vector3;
using grainjet::turbulence::GrainRandom;
using namespace grainjet::wall;

namespace {

const double DEGREE = HALF_PI / 90.0;
const int N = 200000;
const Vector3 UP = {0, 0, 1};

struct Moments {
  double along = 0, along2 = 0, across = 0, across2 = 0;
  double least = 1;      // of the component against the facet
};

// Inclinations of the facets that a grain meets which flies along x, at an angle to the wall
Moments met(double angle, double deviation)
{
  const Vector3 velocity = {3.0 * std::cos(angle), 0, -3.0 * std::sin(angle)};
  Moments m;
  for (int grain = 0; grain < N; grain++) {
    const Vector3 n = facet(UP, velocity, deviation, GrainRandom(7, grain, 11));
    const double a = std::atan(n.x / n.z), b = std::atan(n.y / n.z);
    m.along += a / N;
    m.along2 += a * a / N;
    m.across += b / N;
    m.across2 += b * b / N;
    m.least = std::min(m.least, -dot(n, velocity));
  }
  return m;
}

}

/* The distribution is that of the inclination times the component against the facet. Over all facets, so for steep
   impacts: mean a = - s^2 cot(angle) (sin(angle - a) under a normal distribution), mean b = 0, and the deviations
   s within terms of s^4. Statistical errors: s/sqrt(N) and s^2 sqrt(2/N), of which four are allowed. */
TEST(RoughWall, FacesTheGrainMoreOften)
{
  const double s = 5 * DEGREE;
  for (double angle : {25 * DEGREE, 45 * DEGREE, 80 * DEGREE}) {
    const Moments m = met(angle, s);
    EXPECT_NEAR(m.along, -s * s / std::tan(angle), 4 * s / std::sqrt(N) + s * s * s * s) << angle;
    EXPECT_NEAR(m.across, 0.0, 4 * s / std::sqrt(N)) << angle;
    EXPECT_NEAR(m.across2, s * s, 4 * s * s * std::sqrt(2.0 / N) + 2 * s * s * s * s) << angle;
    EXPECT_NEAR(m.along2, s * s, 4 * s * s * std::sqrt(2.0 / N) + 2 * s * s * s * s) << angle;
  }
}

/* Grazing: only facets that face the grain are hit. For an angle of 0 the distribution is a exp(-a^2/2s^2), of mean s sqrt(pi/2) */
TEST(RoughWall, ShadowEffect)
{
  const double s = 5 * DEGREE, angle = 1e-4 * DEGREE;
  const Moments m = met(angle, s);
  EXPECT_GT(m.least, 0.0);
  EXPECT_NEAR(m.along, -s * std::sqrt(HALF_PI), 4 * s / std::sqrt(N) + s * s * s);
}

TEST(RoughWall, HeadOnHasNoDirection)
{
  const double s = 3 * DEGREE;
  const Moments m = met(90 * DEGREE, s);
  EXPECT_NEAR(m.along, 0.0, 4 * s / std::sqrt(N));
  EXPECT_NEAR(m.across, 0.0, 4 * s / std::sqrt(N));
}

TEST(RoughWall, SmoothWhereNothingIsToBeTurned)
{
  const Vector3 leaving = {1, 0, 0.1}, coming = {1, 0, -0.1};
  EXPECT_EQ(facet(UP, leaving, 0.1, GrainRandom(1, 1, 1)).z, 1.0);
  EXPECT_EQ(facet(UP, coming, 0.0, GrainRandom(1, 1, 1)).z, 1.0);
  EXPECT_EQ(length(turn(UP, UP)), 0.0);
}

// turn() takes a to b, its opposite takes it back, and lengths stay
TEST(RoughWall, Turns)
{
  const Vector3 a = {0, 0.6, 0.8}, v = {1.0, -2.0, 0.5};
  const Vector3 b = facet(a, v, 0.15, GrainRandom(1, 5, 1));
  const Vector3 rotation = turn(a, b);
  ASSERT_GT(length(rotation), 0.01);
  EXPECT_LT(length(turned(a, rotation) - b), 1e-15);
  const Vector3 there = turned(v, rotation);
  EXPECT_NEAR(length(there), length(v), 1e-15);
  EXPECT_LT(length(turned(there, -1.0 * rotation) - v), 2e-15);
}
