/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/drag/drag_laws.h"
#include "physics/drag/gas_drag.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

using namespace grainjet::drag;

namespace {

const double RHO = 0.9, D = 20e-6, C = 400;

// The viscosity follows from Mach and Reynolds number
GasState state(double re, double mach, double gamma = 1.4, double voidFraction = 1)
{
  const double slip = mach * C;
  return {{voidFraction, slip, D, RHO, voidFraction * slip * D / re}, C, gamma};
}

// Cd out of what a law gives
template<class LAW>
double dragCoefficient(const LAW &law, const GasState &gas)
{
  return law(gas) * 4 * D / (3 * RHO * gas.flow.slipSpeed);
}

// Of free molecules that are reflected diffusely by a wall of the gas' temperature (Schaaf & Chambre 1958)
double freeMolecules(double mach, double gamma)
{
  const double s = mach * std::sqrt(gamma / 2);
  return (1 + 2 * s * s) * std::exp(-s * s) / (s * s * s * std::sqrt(M_PI))
    + (4 * std::pow(s, 4) + 4 * s * s - 1) * std::erf(s) / (2 * std::pow(s, 4)) + 2 * std::sqrt(M_PI) / (3 * s);
}

// Change of a law over a place in Re or M
template<class LAW>
double jump(const LAW &law, double re, double mach, double factorRe, double factorMach)
{
  return dragCoefficient(law, state(re * factorRe, mach * factorMach))
    / dragCoefficient(law, state(re / factorRe, mach / factorMach)) - 1;
}

const double STEP = 1 + 1e-9;

}

// Evaluated from the correlations as printed, with 30 digits: Re, M, gamma; Cd of Loth et al., of Henderson for a sphere
// of the gas' temperature and of 2.5 times it
TEST(GasDrag, ReferenceValues)
{
  const double values[][6] = {
    {1e-3, 0.1, 1.4, 48.843464804, 49.548243911, 68.470479552},
    {0.1, 0.5, 1.4, 9.8055070772, 11.540574516, 14.853626524},
    {1, 1, 1.4, 4.762281161, 6.671478479, 7.642241512},
    {1, 2, 1.4, 2.9574650589, 2.6036548214, 2.8698839417},
    {10, 0.3, 1.4, 3.7857725959, 3.9345219946, 3.9345263254},
    {20, 1.2, 1.667, 2.4265295952, 2.406706815, 2.44333728},
    {44.99999999, 3, 1.4, 1.7068625347, 1.5139818749, 1.5934563287},
    {50, 0.2, 1.4, 1.5296219904, 1.5413394194, 1.5413394194},
    {100, 0.85, 1.4, 1.2546705844, 1.1708054837, 1.1708054837},
    {100, 1.6, 1.4, 1.4519925537, 1.4579649902, 1.5243031289},
    {1000, 0.6, 1.4, 0.52734944967, 0.52790403969, 0.52790403969},
    {1000, 1.25, 1.667, 0.99743666574, 0.91297205758, 0.92223275012},
    {20000, 2.5, 1.4, 1.0445923297, 0.99425371772, 1.0002420483}};
  for (const auto &v : values) {
    const GasState gas = state(v[0], v[1], v[2]);
    EXPECT_NEAR(dragCoefficient(loth, gas) / v[3], 1, 1e-8) << v[0] << ' ' << v[1];
    EXPECT_NEAR(dragCoefficient(Henderson(1), gas) / v[4], 1, 1e-8) << v[0] << ' ' << v[1];
    EXPECT_NEAR(dragCoefficient(Henderson(2.5), gas) / v[5], 1, 1e-8) << v[0] << ' ' << v[1];
  }
}

// Without Mach number both are near the drag in a liquid. Loth: Schiller & Naumann within 1 % to Re 200; then below Clift &
// Gauvin, 24/Re (1 + 0.15 Re^0.687) + 0.42/(1 + 42500/Re^1.16), for its term in G: as docs/theory-drag.md says
TEST(GasDrag, SlowGas)
{
  for (double re : {0.01, 0.3, 5.0, 45.0, 46.0, 100.0, 200.0}) {
    const GasState gas = state(re, 1e-6 * re);
    EXPECT_NEAR(loth(gas) / schillerNaumann(gas.flow), 1, 0.01) << re;
  }
  const double loths[][2] = {{500, 1.000}, {5000, 0.975}, {2e4, 0.946}};
  for (const auto &v : loths) {
    const double re = v[0], clift = 24 / re * (1 + 0.15 * std::pow(re, 0.687)) + 0.42 / (1 + 42500 * std::pow(re, -1.16));
    EXPECT_NEAR(dragCoefficient(loth, state(re, 1e-6)) / clift, v[1], 0.001) << re;
  }
  const double henderson[][2] = {{0.01, 0.995}, {1, 0.982}, {10, 1.022}, {100, 0.997}, {200, 0.992}, {500, 1.035}, {999, 1.125}};
  for (const auto &v : henderson) {
    const GasState gas = state(v[0], 1e-6 * v[0]);
    EXPECT_NEAR(Henderson(1)(gas) / schillerNaumann(gas.flow), v[1], 0.002) << v[0];
  }
}

// Both tend to free molecules within their own error, 6 %
TEST(GasDrag, RarefiedGas)
{
  for (double gamma : {1.4, 1.667})
    for (double mach : {0.1, 0.5, 1.0, 2.0, 5.0}) {
      const GasState gas = state(1e-6, mach, gamma);
      EXPECT_NEAR(dragCoefficient(loth, gas) / freeMolecules(mach, gamma), 0.97, 0.04) << mach;
      EXPECT_NEAR(dragCoefficient(Henderson(1), gas) / freeMolecules(mach, gamma), 0.97, 0.04) << mach;
    }
}

// Where the laws change their form, as docs/theory-drag.md says. Henderson's is continuous
TEST(GasDrag, Jumps)
{
  for (double mach : {0.01, 0.1, 0.3, 0.5, 0.8, 0.9, 1.0, 1.2, 1.5, 2.0, 3.0, 5.0})
    EXPECT_LT(std::fabs(jump(loth, 45, mach, STEP, 1)), 0.018) << mach;
  EXPECT_NEAR(jump(loth, 45, 1, STEP, 1), 0.0177, 0.0003);
  const double inMach[][3] = {{0.01, 1, 0.0008}, {1, 1, 0.0059}, {44, 1, 0.0261}, {100, 1, -0.0076}, {1e4, 1, -0.0024},
    {100, 0.8, 0.0016}, {1000, 0.8, 0.0297}, {1e4, 0.8, 0.0492}, {1000, 1.5, 0.0002}};
  for (const auto &v : inMach) EXPECT_NEAR(jump(loth, v[0], v[1], 1, STEP), v[2], 1e-4) << v[0] << ' ' << v[1];
  for (double re : {0.01, 1.0, 44.0, 100.0, 1e4})
    for (double mach : {1.0, 1.75}) EXPECT_NEAR(jump(Henderson(1), re, mach, 1, STEP), 0, 1e-7) << re << ' ' << mach;
}

// In a suspension the voidage function is that of Wen & Yu
TEST(GasDrag, Suspension)
{
  for (double re : {1.0, 300.0}) {
    const GasState lone = state(re, 0.7), crowd = state(re, 0.7, 1.4, 0.6);
    const double factor = std::pow(0.6, -2.65) * crowd.flow.viscosity / lone.flow.viscosity;
    // the viscosity of `crowd` differs, and with it the Knudsen number only by the void fraction that it has in it
    EXPECT_NEAR(loth(crowd) / loth(lone) / factor, 1, 1e-12) << re;
    EXPECT_NEAR(Henderson(1)(crowd) / Henderson(1)(lone) / factor, 1, 1e-12) << re;
  }
}

// At rest finite and, like anywhere, without a floating-point exception, for which OpenFOAM ends the run
TEST(GasDrag, NoExceptions)
{
  std::feclearexcept(FE_ALL_EXCEPT);
  double least = 1e300;
  for (double viscosity : {1e-9, 1e-5, 1.0})
    for (double slip : {0.0, 1e-300, 1e-30, 1e-9, 1e-3, 1.0, 399.0, 400.0, 401.0, 2e3, 1e4})
      for (double voidFraction : {0.3, 1.0, 1.0 + 1e-12}) {
        const GasState gas = {{voidFraction, slip, D, RHO, viscosity}, C, 1.4};
        for (double value : {loth(gas), Henderson(1)(gas), Henderson(0.01)(gas), Henderson(100)(gas)}) {
          EXPECT_TRUE(std::isfinite(value)) << slip << ' ' << viscosity;
          least = std::min(least, value);
        }
      }
  EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));
  EXPECT_GT(least, 0);
}

// At rest Stokes' drag with the slip of a rarefied gas: Kn 0.1 by Loth's 1/(1 + Kn (2.514 + 0.8 exp(-0.55/Kn)))
TEST(GasDrag, AtRest)
{
  const double kn = 0.1, viscosity = kn * D * C / std::sqrt(0.7 * M_PI);
  const GasState gas = {{1, 0, D, RHO, viscosity}, C, 1.4};
  EXPECT_NEAR(loth(gas) / stokes(gas.flow), 1 / (1 + kn * (2.514 + 0.8 * std::exp(-5.5))), 1e-12);
}
