/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/lift/magnus.h"
#include "physics/lift/mean_lift.h"
#include "physics/lift/saffman_mei.h"
#include "physics/lift/spin_torque.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

using namespace grainjet::lift;

namespace {

const double RHO = 1.2, NU = 1.5e-5, D = 80e-6, MU = RHO * NU;
const double ROUND_OFF = 1e-9;    // the reference values are printed with twelve digits

}

// Evaluated from the form as Mei prints it, with 25 digits
TEST(SaffmanMei, ReferenceValues)
{
  const double values[][3] = {{0.01, 0.001, 0.999074566087}, {1, 0.5, 0.920605857867},
    {10, 2, 0.434124336689}, {39, 5, 0.102448961187}, {41, 5, 0.0828516746964}, {100, 40, 0.234339924042}};
  for (const auto &v : values) EXPECT_NEAR(meiFactor(v[0], v[1]) / v[2], 1, ROUND_OFF) << "Re " << v[0];
}

// The force of the other form, rho V 3 C/(2 pi sqrt(Re_w)) with C = 6.46 g. Saffman's constant is
// printed as 1.615, a quarter of 6.46
TEST(SaffmanMei, BothForms)
{
  for (double slip : {0.1, 3.0, 30.0})
    for (double vorticity : {10.0, 1e4}) {
      const double re = slip * D / NU, shearRe = vorticity * D * D / NU;
      const double expected = RHO * M_PI / 6 * D * D * D * 3 * 6.46 * meiFactor(re, shearRe)
        / (2 * M_PI * std::sqrt(shearRe));
      EXPECT_NEAR(saffmanMei(D, RHO, NU, slip, vorticity) / expected, 1, 1e-13);
    }
}

// Saffman's lift at Re = 0, whatever the shear; and without shear no force
TEST(SaffmanMei, Limits)
{
  for (double shearRe : {0.0, 1e-6, 1.0, 1e3}) EXPECT_DOUBLE_EQ(meiFactor(0, shearRe), 1);
  EXPECT_NEAR(meiFactor(1e-6, 10), 1, 3e-4);     // 1 + 0.1 sqrt(Re) 0.3314 sqrt(Re_w/2)
  EXPECT_EQ(saffmanMei(D, RHO, NU, 1.0, 0.0) * 0.0, 0);
  EXPECT_NEAR(saffmanMei(D, RHO, NU, 1.0, 1e-40) * 1e-40, 0, 1e-30);
}

// At Re = 40 the fit as printed falls by (1 - a) exp(-4), no more: 0.0524 is 0.3314/sqrt(40) to 4e-6
TEST(SaffmanMei, FallAt40)
{
  for (double shearRe : {0.5, 4.0, 30.0}) {
    const double a = 0.3314 * std::sqrt(shearRe / 80);
    const double fall = meiFactor(std::nextafter(40.0, 0.0), shearRe) - meiFactor(40, shearRe);
    EXPECT_NEAR(fall, (1 - a) * std::exp(-4), 1e-5);
    EXPECT_LT(fall, 0.0184);
  }
}

// Evaluated from Oesterle & Bui Dinh and from Lun & Liu as printed; the smaller one counts
TEST(Magnus, ReferenceValues)
{
  const double values[][4] = {{0.01, 0.01, 0.998756844426, 1}, {0.5, 5, 0.91964897469, 1},
    {0.5, 0.05, 1.04841499511, 1}, {10, 20, 0.757172905056, 0.425099472076},
    {20, 120, 0.433586816152, 0.350081490787}, {100, 600, 0.124710516814, 0.25227998674},
    {140, 20, 2.2121829787, 0.240315055035}, {1000, 500, 0.900441374917, 0.20032913079}};
  for (const auto &v : values)
    EXPECT_NEAR(spinLiftFactor(v[0], v[1]) / std::min(v[2], v[3]), 1, ROUND_OFF) << "Re " << v[0];
}

// pi/8 rho d^3 at small Re, never more
TEST(Magnus, RubinowAndKeller)
{
  EXPECT_DOUBLE_EQ(spinLiftFactor(0, 0), 1);
  EXPECT_DOUBLE_EQ(spinLiftFactor(0, 100), 1);
  EXPECT_NEAR(spinLiftFactor(1e-4, 1e-4), 1, 1e-4);
  EXPECT_NEAR(magnus(D, RHO, NU, 1e-9, 1e-3), M_PI / 8 * RHO * D * D * D, 1e-6 * RHO * D * D * D);
  for (double re : {0.0, 1e-3, 0.5, 1.0, 20.0, 140.0, 1e3, 1e6})
    for (double spinRe : {0.0, 1e-12, 1e-3, 1.0, 50.0, 1e4, 1e8}) {
      const double c = spinLiftFactor(re, spinRe);
      EXPECT_LE(c, 1) << re << ' ' << spinRe;
      EXPECT_GE(c, 0) << re << ' ' << spinRe;
    }
}

// For a fast spin C_L = C Re_W/Re tends to 0.45; continuous at Re = 1
TEST(Magnus, FastSpinAndContinuity)
{
  for (double re : {10.0, 100.0}) EXPECT_NEAR(spinLiftFactor(re, 1e6 * re) * 1e6, 0.45, 1e-6);
  for (double spinRe : {0.1, 10.0})
    EXPECT_NEAR(spinLiftFactor(1 - 1e-12, spinRe), spinLiftFactor(1 + 1e-12, spinRe), 1e-11);
}

// C_R of Dennis et al. and of Stokes as printed, T = C_R rho/2 (d/2)^5 W^2. Where they meet, 31.7 for the 32
// of the literature, both agree
TEST(SpinTorque, ReferenceValues)
{
  for (double spinRe : {1.0, 31.0, 33.0, 100.0, 1000.0, 4000.0}) {
    const double spin = spinRe * NU / (D * D);
    const double coefficient =
      spinRe < 32 ? 64 * M_PI / spinRe : 12.9 / std::sqrt(spinRe) + 128.4 / spinRe;
    const double printed = coefficient * RHO / 2 * std::pow(D / 2, 5) * spin * spin;
    EXPECT_NEAR(M_PI * MU * D * D * D * spinTorqueFactor(spinRe) * spin / printed, 1, 1e-12) << spinRe;
  }
  EXPECT_EQ(spinTorqueFactor(0), 1);
  EXPECT_EQ(spinTorqueFactor(31.7), 1);
  EXPECT_NEAR(spinTorqueFactor(32), 1, 0.002);
}

// Against the decay in 1e5 steps of the midpoint rule, whose error is some t (f dt)^2/6, 4e-7 at the most; across the
// switch and on both sides of it
TEST(SpinTorque, MeanOverADecay)
{
  for (double start : {20.0, 32.0, 60.0, 1000.0, 4000.0})
    for (double elapsed : {1e-9, 1e-3, 0.3, 2.0, 8.0}) {
      double spinRe = start;
      const int n = 100000;
      const double h = elapsed / n;
      for (int i = 0; i < n; i++) {
        const double middle = spinRe * (1 - 0.5 * h * spinTorqueFactor(spinRe));
        spinRe -= h * middle * spinTorqueFactor(middle);
      }
      const double kept = std::exp(-meanSpinTorqueFactor(start, elapsed) * elapsed);
      EXPECT_NEAR(kept * start / spinRe, 1, 4e-7) << start << ' ' << elapsed;
    }
  EXPECT_EQ(meanSpinTorqueFactor(0, 1), 1);
  EXPECT_EQ(meanSpinTorqueFactor(31.7, 1e3), 1);
  EXPECT_NEAR(meanSpinTorqueFactor(1000, 1e-12), spinTorqueFactor(1000), 1e-9);
  EXPECT_NEAR(meanOfDecay(1e-12), 1, 1e-12);
  EXPECT_DOUBLE_EQ(meanOfDecay(2), (1 - std::exp(-2)) / 2);
}

namespace {

// One kick: v after it
void kick(double *v, const double *wind, const double *f, const double *L, double b, double h, double mass)
{
  const grainjet::drag::ExponentialDrag drag(b, h, mass);
  double slip[3];
  for (int k = 0; k < 3; k++) slip[k] = wind[k] - v[k];
  const MeanLift lift(slip, f, L, b, h, mass);
  for (int k = 0; k < 3; k++) {
    const double other = f[k] + lift.force[k];
    v[k] += h / mass * (other + drag.slip * slip[k] - drag.other * other);
  }
}

}

// m ds/dt = - b s - s x L, L along z: s turns as exp(-(b + i L) t/m). Second order: halving the kick divides the
// error by four
TEST(MeanLift, Spiral)
{
  const double mass = 1, b = 2, wind[3] = {1, 0, 0.5}, f[3] = {0, 0, 0}, L[3] = {0, 0, 3}, end = 1;
  double errors[2];
  for (int run = 0; run < 2; run++) {
    const int n = 100 << run;
    double v[3] = {0, 0, 0};
    for (int i = 0; i < n; i++) kick(v, wind, f, L, b, end / n, mass);
    // s x L = (s_y L, - s_x L, 0)
    const double decay = std::exp(-b * end);
    const double exact[3] = {1 - decay * std::cos(3 * end), -decay * std::sin(3 * end), 0.5 * (1 - decay)};
    errors[run] = std::hypot(v[0] - exact[0], v[1] - exact[1], v[2] - exact[2]);
  }
  EXPECT_LT(errors[0], 1e-4);
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.1);
}

// Kicks a thousand times longer than the drag takes, with a lift ten times the drag: the steady state
// b s + s x L = - f at once, and never away from it
TEST(MeanLift, SteadyStateOfALongKick)
{
  const double mass = 1, b = 1, wind[3] = {0, 0, 0}, f[3] = {0, 0, -1}, L[3] = {0, 10, 0};
  double v[3] = {5, 5, 5};
  for (int i = 0; i < 20; i++) kick(v, wind, f, L, b, 1000, mass);
  // s = - v: s_x - 10 s_z = 0, s_y = 0, s_z + 10 s_x = 1
  EXPECT_NEAR(-v[2], 1.0 / 101, 1e-6);
  EXPECT_NEAR(-v[0], 10.0 / 101, 1e-6);
  EXPECT_NEAR(v[1], 0, 1e-6);
}

// OpenFOAM ends the run for any of these
TEST(Lift, NoFloatingPointException)
{
  for (double slip : {0.0, 1e-300, 1e-12, 1.0, 1e3})
    for (double spin : {0.0, 1e-300, 1e-12, 1.0, 1e7}) {
      std::feclearexcept(FE_ALL_EXCEPT);
      volatile double s = saffmanMei(D, RHO, NU, slip, spin), m = magnus(D, RHO, NU, slip, spin),
        t = meanSpinTorqueFactor(spin * D * D / NU, 0.01);
      EXPECT_TRUE(std::isfinite(s) && std::isfinite(m) && std::isfinite(t)) << slip << ' ' << spin;
      EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)) << slip << ' ' << spin;
    }
}
