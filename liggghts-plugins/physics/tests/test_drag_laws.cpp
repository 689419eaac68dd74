/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/drag/drag_laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace grainjet::drag;

namespace {

const double RHO = 1.2, NU = 1.5e-5, D = 80e-6;
const double STOKES = 18 * RHO * NU / (D * D);
const double ROUND_OFF = 1e-9;    // the reference values are printed with ten digits

const std::vector<std::string> NAMES = {"stokes", "schillerNaumann", "wenYu", "ergun",
  "gidaspow", "diFelice", "kochHill", "beetstra"};

State state(double voidFraction, double re)
{
  return {voidFraction, re * NU / (voidFraction * D), D, RHO, NU};
}

double value(const std::string &name, double voidFraction, double re)
{
  const Law law = findLaw(name);
  return law(state(voidFraction, re));
}

struct Reference {
  double voidFraction, re;
  std::vector<double> law;    // in the order of NAMES, kg/(m3 s)
};

// Evaluated from the forces as the papers print them (Cd, areas, 3 pi mu d u), not from
// the rearranged forms of the headers, and divided by volume and slip velocity.
const std::vector<Reference> REFERENCES = {
    {1, 0.01, {5.062500000e+04, 5.094596398e+04, 5.094596398e+04, 4.921875000e+01, 5.094596398e+04, 4.988412211e+04, 5.064790781e+04, 5.065807621e+04}},
    {1, 1, {5.062500000e+04, 5.821875000e+04, 5.821875000e+04, 4.921875000e+03, 5.821875000e+04, 6.219471094e+04, 5.291578125e+04, 5.471950781e+04}},
    {1, 50, {5.062500000e+04, 1.622210154e+05, 1.622210154e+05, 2.460937500e+05, 1.622210154e+05, 1.806696945e+05, 1.651640625e+05, 1.725705854e+05}},
    {1, 500, {5.062500000e+04, 5.934360603e+05, 5.934360603e+05, 2.460937500e+06, 5.934360603e+05, 7.524718410e+05, 1.196015625e+06, 8.830982348e+05}},
    {1, 2000, {5.062500000e+04, 1.856250000e+06, 1.856250000e+06, 9.843750000e+06, 1.856250000e+06, 2.293554619e+06, 4.632187500e+06, 2.810597777e+06}},
    {0.95, 10, {5.062500000e+04, 8.888634022e+04, 1.003103793e+05, 7.401315789e+04, 1.003103793e+05, 1.085293509e+05, 1.132134656e+05, 1.185066251e+05}},
    {0.9, 100, {5.062500000e+04, 2.437736563e+05, 3.044576025e+05, 5.937500000e+05, 3.044576025e+05, 3.251602346e+05, 3.777782553e+05, 3.897300658e+05}},
    {0.8, 100, {5.062500000e+04, 2.600523870e+05, 4.159881963e+05, 7.207031250e+05, 7.207031250e+05, 4.177024053e+05, 4.614115143e+05, 5.243848169e+05}},
    {0.7, 30, {5.062500000e+04, 1.510070923e+05, 3.324488682e+05, 3.917410714e+05, 3.917410714e+05, 2.983360337e+05, 3.341735811e+05, 3.954491759e+05}},
    {0.55, 5, {5.062500000e+04, 8.522049274e+04, 3.586966737e+05, 3.899147727e+05, 3.899147727e+05, 3.081286497e+05, 4.380819250e+05, 4.485796611e+05}},
    {0.45, 300, {5.062500000e+04, 7.120515143e+05, 3.591312385e+06, 3.796875000e+06, 3.796875000e+06, 3.259056635e+06, 2.834872685e+06, 3.028354384e+06}}
};

}

TEST(DragLaws, ReferenceValues)
{
  for (const Reference &reference : REFERENCES)
    for (std::size_t i = 0; i < NAMES.size(); i++)
      EXPECT_NEAR(value(NAMES[i], reference.voidFraction, reference.re), reference.law[i],
        ROUND_OFF * reference.law[i])
        << NAMES[i] << " at eps " << reference.voidFraction << ", Re " << reference.re;
}

TEST(DragLaws, EveryLawInTheTableIsTested)
{
  for (const NamedLaw &entry : LAWS)
    EXPECT_EQ(std::count(NAMES.begin(), NAMES.end(), entry.name), 1) << entry.name;
}

// One sphere in creeping flow. Di Felice's Dallavalle form gives 4.8^2/24 of it, Ergun
// knows no such limit.
TEST(DragLaws, StokesLimitAtRest)
{
  const std::map<std::string, double> limit = {{"diFelice", 4.8 * 4.8 / 24}, {"ergun", 0}};
  for (const std::string &name : NAMES) {
    const double expected = limit.count(name) ? limit.at(name) : 1;
    EXPECT_NEAR(value(name, 1, 0) / STOKES, expected, 1e-14) << name;
  }
}

TEST(DragLaws, FiniteForAllVoidFractionsAtRest)
{
  for (const std::string &name : NAMES)
    for (double eps : {0.3, 0.36, 0.6, 0.61, 0.8, 0.81, 0.999, 1.0}) {
      const double v = value(name, eps, 0);
      EXPECT_TRUE(std::isfinite(v)) << name << " at eps " << eps;
      EXPECT_GE(v, 0) << name << " at eps " << eps;
    }
}

// The creeping-flow limits in a dense bed are linear in 1/eps-type functions that the papers
// state; 10 phi / eps^3 (Carman-Kozeny) is common to Koch-Hill and Beetstra there, the
// latter adding eps^2 (1 + 1.5 sqrt(phi)).
TEST(DragLaws, DenseCreepingLimits)
{
  const double eps = 0.5, phi = 0.5;
  const double carman = STOKES * 10 * phi / eps;
  EXPECT_NEAR(value("kochHill", eps, 0), carman, 1e-13 * carman);
  EXPECT_NEAR(value("beetstra", eps, 0),
    carman + STOKES * eps * eps * eps * (1 + 1.5 * std::sqrt(phi)), 1e-13 * carman);
  EXPECT_NEAR(value("ergun", eps, 0), STOKES * 150 / 18 * phi / eps, 1e-13 * carman);
  EXPECT_NEAR(value("wenYu", eps, 0), STOKES * std::pow(eps, -2.65), 1e-13 * carman);
}

// Laws of one sphere do not know their neighbours
TEST(DragLaws, SingleSphereLawsIgnoreTheVoidFraction)
{
  for (const char *name : {"stokes", "schillerNaumann"}) {
    const Law law = findLaw(name);
    State s = state(1, 40);
    const double alone = law(s);
    s.voidFraction = 0.5;
    EXPECT_EQ(law(s), alone) << name;
  }
}

// All others reduce the flow area: drag at equal slip velocity grows as the bed gets denser
TEST(DragLaws, DragGrowsWithSolidFraction)
{
  for (const char *name : {"wenYu", "ergun", "diFelice", "kochHill", "beetstra"})
    for (double slip : {1e-3, 0.1, 5.0}) {
      const Law law = findLaw(name);
      double before = 0;
      for (double eps = 0.98; eps > 0.4; eps -= 0.02) {
        const double now = law({eps, slip, D, RHO, NU});
        EXPECT_GT(now, before) << name << " at eps " << eps << ", slip " << slip;
        before = now;
      }
    }
}

// Relative jump across a value of Re or eps; 1e-9 aside is far less than any of the jumps
TEST(DragLaws, StatedDiscontinuities)
{
  const double aside = 1e-9;
  const auto acrossRe = [&](const char *name, double re) {
    return value(name, 0.9, re * (1 + aside)) / value(name, 0.9, re * (1 - aside)) - 1;
  };
  const auto acrossEps = [&](const char *name, double eps, double re) {
    const Law law = findLaw(name);
    const State s = state(eps, re);
    State below = s, above = s;
    below.voidFraction -= aside;
    above.voidFraction += aside;
    return law(below) / law(above) - 1;
  };
  for (const char *name : {"schillerNaumann", "wenYu", "gidaspow"}) {
    // schillerNaumann builds Re without eps
    const double re = std::string(name) == "schillerNaumann" ? 900 : 1000;
    EXPECT_NEAR(acrossRe(name, re), 0.44 / 0.438288140 - 1, 1e-6) << name;
  }
  for (const char *name : {"diFelice", "kochHill", "beetstra", "ergun"})
    EXPECT_NEAR(acrossRe(name, 1000), 0, 1e-7) << name;

  // Gidaspow: Ergun over Wen-Yu at eps 0.8 (table in docs/theory-drag.md)
  EXPECT_NEAR(1 / (1 + acrossEps("gidaspow", 0.8, 1)) - 1, -0.0578325, 1e-6);
  EXPECT_NEAR(1 / (1 + acrossEps("gidaspow", 0.8, 100)) - 1, -0.4228023, 1e-6);
  // Koch-Hill: at Re 0 only F0 jumps
  EXPECT_NEAR(acrossEps("kochHill", 0.6, 0), 18.518518519 / 18.327518001 - 1, 1e-6);
  for (const char *name : {"wenYu", "ergun", "diFelice", "beetstra"})
    for (double eps : {0.4, 0.6, 0.8})
      EXPECT_NEAR(acrossEps(name, eps, 50), 0, 1e-6) << name << " at eps " << eps;
}

TEST(DragLaws, Names)
{
  EXPECT_EQ(findLaw("gidaspow"), gidaspow);
  EXPECT_EQ(findLaw("Gidaspow"), nullptr);
  EXPECT_EQ(findLaw(""), nullptr);
  EXPECT_NE(lawNames().find("schillerNaumann, stokes"), std::string::npos);
}

// OpenFOAM ends the run for any of these. Void fractions above 1 come from interpolation
TEST(DragLaws, NoFloatingPointException)
{
  for (const NamedLaw &entry : LAWS)
    for (double eps : {0.3, 0.4, 0.6, 0.8, 1.0, 1.0 + 1e-15})
      for (double slip : {0.0, 1e-300, 1e-12, 1.0, 1e3}) {
        std::feclearexcept(FE_ALL_EXCEPT);
        volatile double drag = entry.law(State{eps, slip, D, RHO, NU});
        EXPECT_TRUE(std::isfinite(drag)) << entry.name << " eps " << eps << " slip " << slip;
        EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW))
          << entry.name << " eps " << eps << " slip " << slip;
      }
}

// Force with the original diameter: f_cg^3 particles of d feel what one grain of
// f_cg d with their total volume is given
TEST(DragLaws, GrainFeelsWhatItsParticlesFeel)
{
  const double cg = 3, slip = 2;
  const State particle = {1, slip, D, RHO, NU};
  const double one = gidaspow(particle) * M_PI / 6 * std::pow(D, 3) * slip;
  const double grainDiameter = cg * D;
  const State grain = {1, slip, grainDiameter / cg, RHO, NU};
  const double all = gidaspow(grain) * M_PI / 6 * std::pow(grainDiameter, 3) * slip;
  EXPECT_NEAR(all, std::pow(cg, 3) * one, 1e-13 * all);
}
