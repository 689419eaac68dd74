/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/drag/drag_laws.h"
#include "physics/drag/shaped_drag.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

using namespace grainjet::drag;

namespace {

const double RHO = 1.2, NU = 1.5e-5, D = 80e-6;

// Cd at void fraction 1 out of what a law gives
template<class LAW>
double dragCoefficient(const LAW &law, double re)
{
  const double slip = re * NU / D;
  return law(State{1, slip, D, RHO, NU}) * M_PI / 6 * D * D * D * slip
    / (M_PI / 8 * D * D * RHO * slip * slip);
}

}

// Evaluated from the correlations as printed, with 25 digits: sphericity, Re, Haider & Levenspiel, Ganser
TEST(ShapedDrag, ReferenceValues)
{
  const double values[][4] = {
    {1, 0.01, 2422.1051017, 2413.0392643}, {1, 1, 28.469906291, 26.683330218},
    {1, 100, 1.1498446433, 0.80478804662}, {1, 10000, 0.43963476376, 0.43958211533},
    {0.906, 0.01, 2433.2837751, 2501.630695}, {0.906, 10, 4.513791905, 4.4159669976},
    {0.906, 1000, 0.67808439932, 0.73554655245}, {0.806, 1, 30.63751428, 31.38776326},
    {0.806, 100, 1.2845675499, 1.4989260547}, {0.806, 10000, 1.3915410737, 1.3600360244},
    {0.67, 0.01, 2512.5362669, 2792.0581682}, {0.67, 10, 5.397054288, 6.264869786},
    {0.67, 1000, 2.1331946109, 1.8369829993}};
  for (const auto &v : values) {
    EXPECT_NEAR(dragCoefficient(HaiderLevenspiel(v[0]), v[1]) / v[2], 1, 1e-9) << v[0] << ' ' << v[1];
    EXPECT_NEAR(dragCoefficient(Ganser(v[0]), v[1]) / v[3], 1, 1e-9) << v[0] << ' ' << v[1];
  }
}

// Ganser's Stokes range is the sphere's drag times (1 + 2/sqrt(phi))/3, Haider & Levenspiel's the sphere's
TEST(ShapedDrag, AtRest)
{
  const State rest = {1, 0, D, RHO, NU};
  for (double phi : {0.1, 0.5, 0.8, 1.0}) {
    EXPECT_NEAR(HaiderLevenspiel(phi)(rest) / stokes(rest), 1, 1e-12) << phi;
    EXPECT_NEAR(Ganser(phi)(rest) / stokes(rest), (1 + 2 / std::sqrt(phi)) / 3, 1e-12) << phi;
  }
}

// A sphere by both laws over Schiller & Naumann, as docs/theory-drag.md says
TEST(ShapedDrag, Sphere)
{
  const double values[][3] = {{1, 1.03, 0.97}, {100, 1.05, 0.74}, {999, 1.10, 0.85}};
  for (const auto &v : values) {
    const double sphere = dragCoefficient(schillerNaumann, v[0]);
    EXPECT_NEAR(dragCoefficient(HaiderLevenspiel(1), v[0]) / sphere, v[1], 0.006) << v[0];
    EXPECT_NEAR(dragCoefficient(Ganser(1), v[0]) / sphere, v[2], 0.006) << v[0];
  }
}

// The flatter, the larger: at Re = 100 from sphericity 1 downwards
TEST(ShapedDrag, GrowsWithTheShape)
{
  for (double re : {1.0, 100.0, 1e4})
    for (double phi = 0.9; phi > 0.5; phi -= 0.1) {
      EXPECT_GT(dragCoefficient(Ganser(phi), re), dragCoefficient(Ganser(phi + 0.1), re)) << re << ' ' << phi;
      if (re > 1e3) continue;
      EXPECT_GT(dragCoefficient(HaiderLevenspiel(phi), re),
        0.98 * dragCoefficient(HaiderLevenspiel(phi + 0.1), re)) << re << ' ' << phi;
    }
}

// eps^-2.65 at the superficial Re, as Wen & Yu
TEST(ShapedDrag, VoidFraction)
{
  for (double eps : {0.45, 0.9}) {
    const State dense = {eps, 2, D, RHO, NU}, lone = {1, 2 * eps, D, RHO, NU};
    const double wenAndYu = wenYu(dense) / wenYu(lone);
    EXPECT_NEAR(HaiderLevenspiel(0.8)(dense) / HaiderLevenspiel(0.8)(lone) / wenAndYu, 1, 1e-12);
    EXPECT_NEAR(Ganser(0.8)(dense) / Ganser(0.8)(lone) / wenAndYu, 1, 1e-12);
  }
}

TEST(ShapedDrag, Names)
{
  for (const char *name : {"haiderLevenspiel", "ganser"}) {
    const ShapedLaw *law = findShapedLaw(name);
    ASSERT_NE(law, nullptr);
    EXPECT_NE(shapedLawNames().find(name), std::string::npos);
    EXPECT_GT(law->make(0.8)(State{1, 1, D, RHO, NU}), 0);
  }
  EXPECT_EQ(findShapedLaw("gidaspow"), nullptr);
}

// OpenFOAM ends the run for any of these. Void fractions above 1 come from interpolation
TEST(ShapedDrag, NoFloatingPointException)
{
  for (double phi : {HaiderLevenspiel::LEAST, Ganser::LEAST, 0.5, 1.0})
    for (double eps : {0.3, 1.0, 1.0 + 1e-15})
      for (double slip : {0.0, 1e-300, 1e-12, 1.0, 1e3}) {
        const State state = {eps, slip, D, RHO, NU};
        std::feclearexcept(FE_ALL_EXCEPT);
        volatile double a = HaiderLevenspiel(phi)(state), b = Ganser(phi)(state);
        EXPECT_TRUE(std::isfinite(a) && std::isfinite(b)) << phi << ' ' << eps << ' ' << slip;
        EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)) << phi << ' ' << eps << ' ' << slip;
      }
}
