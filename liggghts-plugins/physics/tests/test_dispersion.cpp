/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

// Turbulent dispersion against theory. Samples: the variance of n normal numbers has a relative
// standard error of sqrt(2/n); limits are four of them.

#include "physics/turbulence/eddy_walk.h"
#include "physics/turbulence/grain_random.h"
#include "physics/turbulence/langevin_step.h"
#include "physics/turbulence/wall_reflection.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace grainjet::turbulence;

namespace {

const double S = 0.7, T = 0.02;    // m/s, s
const double NO_SLIP[3] = {0, 0, 0};

SeenTurbulence homogeneous() { return {S, {0, 0, 0}, T, {0, 0, 0}}; }

struct Tracer {
  double xi[3], x[3] = {0, 0, 0};
};

// Six normal numbers of a grain in a step
std::array<double, 8> numbers(int grain, int step)
{
  std::array<double, 8> n;
  const GrainRandom random(1, grain, step);
  random.normals(0, n.data());
  random.normals(1, n.data() + 4);
  return n;
}

void start(std::vector<Tracer> &grains)
{
  for (size_t i = 0; i < grains.size(); i++) {
    const auto n = numbers(i, 0);
    std::copy(n.begin(), n.begin() + 3, grains[i].xi);
  }
}

double limit(double samples) { return 4 * std::sqrt(2 / samples); }

double square(double x) { return x * x; }

}

// Moments of standard normal numbers; the standard error of the fourth is sqrt(96/n)
TEST(GrainRandom, Normal)
{
  const int n = 400000;
  double sum[5] = {0, 0, 0, 0, 0}, product = 0;
  for (int i = 0; i < n / 4; i++) {
    double four[4];
    GrainRandom(7, i % 1000, i / 1000).normals(i % 3, four);
    for (double x : four)
      for (int k = 1; k <= 4; k++)
        sum[k] += std::pow(x, k) / n;
    product += four[0] * four[1] + four[1] * four[2] + four[2] * four[3];
  }
  EXPECT_NEAR(sum[1], 0, 4 / std::sqrt(n));
  EXPECT_NEAR(sum[2], 1, limit(n));
  EXPECT_NEAR(sum[3], 0, 4 * std::sqrt(15.0 / n));
  EXPECT_NEAR(sum[4], 3, 4 * std::sqrt(96.0 / n));
  EXPECT_NEAR(product / (0.75 * n), 0, 4 / std::sqrt(0.75 * n));
}

// Each part of the key counts, also the upper half of a long ID, and nothing else does
TEST(GrainRandom, Key)
{
  double a[4], b[4];
  GrainRandom(1, 5, 9).normals(0, a);
  GrainRandom(1, 5, 9).normals(0, b);
  for (int k = 0; k < 4; k++)
    EXPECT_EQ(a[k], b[k]);
  const GrainRandom others[] = {{2, 5, 9}, {1, 6, 9}, {1, 5, 10}, {1, 5 + (int64_t(1) << 32), 9},
                                {1, 5, 9 + (int64_t(1) << 32)}, {1, 5, 9, GrainRandom::ROUGHNESS}};
  for (const GrainRandom &other : others) {
    other.normals(0, b);
    EXPECT_NE(a[0], b[0]);
  }
  GrainRandom(1, 5, 9).normals(1, b);
  EXPECT_NE(a[0], b[0]);
}

// Taylor 1921: <x2> = 2 s2 T (t - T (1 - exp(-t/T))), for intervals from far below to far above T
TEST(Langevin, Taylor)
{
  const SeenTurbulence seen = homogeneous();
  const double ratios[] = {0.01, 0.1, 1.0, 10.0};
  const LangevinStep steps[] = {{seen, 0.01 * T, 0, NO_SLIP}, {seen, 0.1 * T, 0, NO_SLIP},
                                {seen, T, 0, NO_SLIP}, {seen, 10 * T, 0, NO_SLIP}};
  std::vector<Tracer> grains[4];
  for (auto &of_ratio : grains) {
    of_ratio.resize(100000);
    start(of_ratio);
  }
  const double samples = 3.0 * grains[0].size();
  for (int n = 1; n <= 50; n++) {
    double sum[4] = {0, 0, 0, 0}, speeds[4] = {0, 0, 0, 0};
    for (size_t i = 0; i < grains[0].size(); i++) {
      const auto normals = numbers(i, n);
      for (int j = 0; j < 4; j++) {
        Tracer &g = grains[j][i];
        double mean[3];
        steps[j].advance(normals.data(), g.xi, mean);
        for (int k = 0; k < 3; k++) {
          g.x[k] += ratios[j] * T * mean[k];
          sum[j] += square(g.x[k]) / samples;
          speeds[j] += square(g.xi[k]) / samples;
        }
      }
    }
    if (n != 1 && n != 10 && n != 50) continue;
    for (int j = 0; j < 4; j++) {
      const double t = n * ratios[j] * T, exact = 2 * S*S * T * (t + T * std::expm1(-t / T));
      printf("dt/T %g, t/T %g: <x2> over theory %.5f, <xi2> %.5f\n", ratios[j], t / T,
             sum[j] / exact, speeds[j]);
      EXPECT_NEAR(sum[j] / exact, 1, limit(samples)) << ratios[j] << ' ' << n;
      EXPECT_NEAR(speeds[j], 1, limit(samples)) << ratios[j] << ' ' << n;
    }
  }
}

// Grains with inertia in homogeneous turbulence: <v2> = s2 T/(T + tau), and diffusivity s2 T for any tau. All
// is linear, so that the moments of the step are summed up without a sample: nothing but its
// own error is left. It is that of a mean velocity that is held over the interval.
TEST(Langevin, GrainsWithInertia)
{
  for (double stokes : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    const double tau = stokes * T;
    const double dt = 0.2 * std::min(T, tau);
    const LangevinInterval step(dt, T, tau);
    const GrainWay way(dt, 1 / tau);

    // covariances with xi, v and x, of which one component is enough
    double vv = 0, vxi = 0, xx = 0, xxi = 0, xv = 0, late = 0;
    const int steps = int(30 * (T + tau) / dt);
    for (int n = 1; n <= steps; n++) {
      // mean = S/dt (integral xi + kick_integral n1 + own_integral n2)
      const double m = S / dt * step.integral, m1 = S / dt * step.kick_integral,
                   m2 = S / dt * step.own_integral, mm = m*m + m1*m1 + m2*m2;
      const double k = way.kept, l = 1 - way.kept, o = way.own_velocity, f = way.fluid;
      const double vm = m * vxi, xm = m * xxi;

      const double new_xx = xx + o*o * vv + f*f * mm + 2 * (o * xv + f * xm + o * f * vm);
      const double new_xv = k * xv + l * xm + o * (k * vv + l * vm) + f * (k * vm + l * mm);
      const double ximean = step.kept * m + step.kick * m1;
      xxi = step.kept * (xxi + o * vxi) + f * ximean;
      const double new_vv = k*k * vv + l*l * mm + 2 * k * l * vm;
      vxi = step.kept * k * vxi + l * ximean;
      vv = new_vv;
      xv = new_xv;
      xx = new_xx;
      if (n == steps / 2) late = xx;
    }
    const double found = vv / (S*S * T / (T + tau));
    const double diffusivity = (xx - late) / (2 * dt * (steps - steps / 2)) / (S*S * T);
    printf("St %g: <v2> over theory %.5f, diffusivity over theory %.5f\n", stokes, found, diffusivity);
    EXPECT_NEAR(found, 1, 0.01) << stokes;
    EXPECT_NEAR(diffusivity, 1, 1e-3) << stokes;
  }
}

// Crossing trajectories: diffusivity s2 T/b along the slip and across it; on the way (1, 2, 2)/3
TEST(Langevin, CrossingTrajectories)
{
  const SeenTurbulence seen = homogeneous();
  const double slip[3] = {S, 2 * S, 2 * S};    // 3 s
  const double b[2] = {std::sqrt(1 + 0.64 * 9), std::sqrt(1 + 4 * 0.64 * 9)};
  for (double ratio : {0.05, 2.0}) {
    const double dt = ratio * T;
    std::vector<Tracer> grains(20000);
    start(grains);
    const LangevinStep step(seen, dt, 0, slip);
    const int steps = int(20 * T / dt);
    for (int n = 1; n <= steps; n++)
      for (size_t i = 0; i < grains.size(); i++) {
        double mean[3];
        step.advance(numbers(i, n).data(), grains[i].xi, mean);
        for (int k = 0; k < 3; k++)
          grains[i].x[k] += dt * mean[k];
      }
    double along = 0, across = 0;
    for (const Tracer &g : grains) {
      along += square((g.x[0] + 2 * g.x[1] + 2 * g.x[2]) / 3) / grains.size();
      across += square((g.x[1] - g.x[2]) / std::sqrt(2.0)) / grains.size();
    }
    const double found[2] = {along, across}, t = steps * dt;
    for (int k = 0; k < 2; k++) {
      const double Tb = T / b[k];
      const double exact = 2 * S*S * Tb * (t + Tb * std::expm1(-t / Tb));
      printf("dt/T %g: b %.4f, <x2> over theory %.4f\n", ratio, b[k], found[k] / exact);
      EXPECT_NEAR(found[k] / exact, 1, limit(grains.size()));
    }
  }
}

// Well mixed: tracers in a slot in which s rises from 0.3 of that in the middle and T from 0.1 of it stay
// evenly spread, for intervals of 0.1 to 10 T. The coefficients of the start of the interval
// alone give 1.25 to 2.8 times as many in the outermost twentieth. Groups of grains are
// independent: their scatter is the standard error. Beyond four of it, 1 % is left to the
// step's own second order.
TEST(Langevin, WellMixed)
{
  const double normals[2][3] = {{-1, 0, 0}, {1, 0, 0}};    // width 1, s in the middle 1
  const int groups = 20, count = 4000, bins = 5;
  for (double ratio : {0.1, 1.0, 10.0}) {
    // long enough to mix, with a path of at most a twentieth of the slot
    const double dt = ratio < 1 ? 0.01 : 0.05, time = dt / ratio;
    const int steps = ratio < 1 ? 500 : 800;
    std::vector<Tracer> grains(count);
    start(grains);
    for (int i = 0; i < count; i++)
      grains[i].x[0] = (i / groups + 0.5) / (count / groups);

    std::vector<double> share(groups * bins, 0.0);
    for (int n = 1; n <= steps; n++)
      for (int i = 0; i < count; i++) {
        Tracer &g = grains[i];
        const double side = g.x[0] < 0.5 ? 1 : -1, y = std::min(g.x[0], 1 - g.x[0]);
        const SeenTurbulence seen = {0.3 + 1.4 * y, {1.4 * side, 0, 0},
                                     time * (0.1 + 1.8 * y), {1.8 * time * side, 0, 0}};
        double mean[3];
        LangevinStep(seen, dt, 0, NO_SLIP).advance(numbers(i, n).data(), g.xi, mean);
        double way[3] = {dt * mean[0], dt * mean[1], dt * mean[2]};
        reflect_at_wall(g.x[0], normals[0], way, g.xi, mean);
        reflect_at_wall(1 - g.x[0], normals[1], way, g.xi, mean);
        g.x[0] += dt * mean[0];
        ASSERT_TRUE(g.x[0] > -1e-12 && g.x[0] < 1 + 1e-12);
        const double place = std::min(g.x[0], 1 - g.x[0]);
        const int bin = std::min(bins - 1, std::max(0, int(2 * bins * place)));
        share[i % groups * bins + bin] += double(bins) * groups / count / steps;
      }

    printf("dt/T %g:", ratio);
    for (int bin = 0; bin < bins; bin++) {
      double sum = 0, squares = 0;
      for (int j = 0; j < groups; j++) {
        sum += share[j * bins + bin] / groups;
        squares += square(share[j * bins + bin]) / groups;
      }
      const double error = std::sqrt((squares - sum * sum) / (groups - 1));
      printf(" %.3f +- %.3f", sum, error);
      EXPECT_NEAR(sum, 1, 0.01 + 4 * error) << ratio << ' ' << bin;
      EXPECT_LT(error, 0.025);
    }
    printf("\n");
  }
}

// Beside fluid nearly at rest T rises a millionfold from cell to cell, so that its gradient says nothing of
// the path in the interval. What it adds to the mean of xi stays below half of what is lost in the interval,
// or the rms itself if the interval is long; without the limit it would be 1e5 times the rms here.
TEST(Langevin, EdgeOfStillFluid)
{
  const double nothing[6] = {0, 0, 0, 0, 0, 0};
  for (double ratio : {0.01, 0.1, 1.0, 10.0}) {
    const SeenTurbulence seen = {S, {0, 0, 0}, T, {1e9 * T / S, 0, 0}};
    double xi[3] = {0, 0, 0}, mean[3];
    LangevinStep(seen, ratio * T, 0, NO_SLIP).advance(nothing, xi, mean);
    const double largest = std::min(0.5 * ratio, 1.0);
    EXPECT_GT(xi[0], 0);
    EXPECT_LE(xi[0], largest) << ratio;
    EXPECT_LE(mean[0], largest * S) << ratio;
  }
}

// The path of a tracer is folded at the wall; a grain that does not get there sees nothing of it
TEST(WallReflection, Folds)
{
  const double normal[3] = {0, 0, 1}, dt = 0.1;
  double xi[3] = {1, 2, 3}, mean[3] = {4, 5, 6};
  double way[3] = {0.4, 0.5, 0.6};
  EXPECT_FALSE(reflect_at_wall(0.61, normal, way, xi, mean));
  EXPECT_EQ(xi[2], 3);
  EXPECT_TRUE(reflect_at_wall(0.2, normal, way, xi, mean));
  EXPECT_EQ(xi[0], 1);
  EXPECT_EQ(xi[2], -3);
  EXPECT_EQ(mean[1], 5);
  EXPECT_NEAR(dt * mean[2], 0.2 - (0.6 - 0.2), 1e-15);
  EXPECT_NEAR(way[2], dt * mean[2], 1e-15);
  EXPECT_FALSE(reflect_at_wall(0.2, normal, way, xi, mean));
  // already in the wall: thrown back whole
  way[2] = 0.6;
  mean[2] = 6;
  EXPECT_TRUE(reflect_at_wall(-0.01, normal, way, xi, mean));
  EXPECT_NEAR(mean[2], -6, 1e-15);
}

// Diffusivity s2 life/2 for eddies that are longer and shorter than the interval, and variance of one component
TEST(EddyWalk, Dispersion)
{
  const double life = 2 * T;
  for (double ratio : {0.1, 1.0, 10.0, 100.0}) {
    const double dt = ratio * T;
    const int count = 20000, steps = std::max(10, int(20 / ratio));
    double sum = 0, xi2 = 0;
    for (int i = 0; i < count; i++) {
      double xi[3], x[3] = {0, 0, 0};
      const GrainRandom first(3, i, 0);
      EddyWalk(first).draw(xi);
      double left = life * (i + 0.5) / count;    // the start is nothing special
      for (int n = 1; n <= steps; n++) {
        double mean[3];
        const GrainRandom random(3, i, n);
        EddyWalk(random).advance(dt, [&](const double *) { return life; }, xi, left, mean);
        for (int k = 0; k < 3; k++)
          x[k] += S * dt * mean[k];
      }
      for (int k = 0; k < 3; k++) {
        sum += square(x[k]) / (3.0 * count);
        xi2 += square(xi[k]) / (3.0 * count);
      }
    }
    // a correlation that falls linearly to zero over the life of an eddy
    const double t = steps * dt, exact = S*S * (life * t - life*life / 3);
    printf("dt/T %g: <x2> over theory %.4f, <xi2> %.4f\n", ratio, sum / exact, xi2);
    EXPECT_NEAR(sum / exact, 1, limit(3.0 * count) + 0.005) << ratio;
    EXPECT_NEAR(xi2, 1, limit(3.0 * count)) << ratio;
  }
}

// L = tau w (1 - exp(-t/tau)) solved for t; a grain that never gets through is caught
TEST(EddyWalk, CrossingTime)
{
  const double t = crossing_time(0.01, 2, 0.02);
  EXPECT_NEAR(0.02 * 2 * -std::expm1(-t / 0.02), 0.01, 1e-15);
  EXPECT_NEAR(crossing_time(0.01, 2, 1e6), 0.005, 1e-9);
  EXPECT_GT(crossing_time(0.05, 2, 0.02), 1e20);
  EXPECT_GT(crossing_time(0.05, 2, 0), 1e20);
}
