/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/wake/own_wake.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace grainjet::wake;

namespace {

const double MIDDLE[3] = {0.0, 0.0, 0.0}, CORNER[3] = {1.0, 1.0, 1.0};

Place at(const double (&offset)[3], double size, bool linear)
{
  const double radius[3] = {size, size, size};
  return Place(offset, radius, linear);
}

// Velocity under a unit force after a number of steps, in F/(rho nu L), for D = nu dt/L^2 and
// P = w L/nu
double velocity(const Response &response, const Place &place, double D, double P, int steps)
{
  const Step step(response, place, D, P * D);
  double a[2] = {0.0, 0.0}, owed = 0.0, u = 0.0;
  for (int n = 0; n < steps; n++) u = step.advance(D, 0.0, a, owed);
  EXPECT_EQ(owed, 0.0);
  return u;
}

}

// In the middle of a cell all of it; at its corner the mean of eight cells: the same one and three, three
// and one neighbours
TEST(OwnWake, PairsOfCells)
{
  for (bool linear : {false, true}) {
    const Place middle = at(MIDDLE, 0.5, linear);
    EXPECT_EQ(middle.pairs[0], 1.0);
    EXPECT_EQ(middle.pairs[1] + middle.pairs[2] + middle.pairs[3], 0.0);
  }
  const Place corner = at(CORNER, 0.0, true);
  for (int n = 0; n < 4; n++) EXPECT_NEAR(corner.pairs[n], (n == 0 || n == 3 ? 1.0 : 3.0) / 8.0, 1e-14);

  // a sphere at the corner has an eighth in each cell, and is sampled from one of them
  const Place divided = at(CORNER, 0.5, false);
  for (int n = 0; n < 4; n++) EXPECT_NEAR(divided.pairs[n], (n == 0 || n == 3 ? 1.0 : 3.0) / 8.0, 1e-14);
}

// Shares: never negative, never more than one together
TEST(OwnWake, PairsAreShares)
{
  for (bool linear : {false, true})
    for (double size : {0.0, 0.2, 1.0, 7.0})
      for (double x : {-1.5, -1.0, -0.4, 0.0, 0.7, 1.0})
        for (double y : {-1.0, 0.0, 0.3}) {
          const double offset[3] = {x, y, 0.9};
          const Place place = at(offset, size, linear);
          double sum = 0.0;
          for (double share : place.pairs) {
            EXPECT_GE(share, 0.0);
            sum += share;
          }
          EXPECT_LE(sum, 1.0 + 1e-14);
          EXPECT_GT(sum, 0.5);
        }
}

// A steady force in the middle of a cell of fluid at rest: two thirds of Watson's integral for the cubic lattice,
// 0.252731, and more with the pressure of collocated meshes, up to a fifth. Two exponentials for a tail like t^(-3/2)
TEST(OwnWake, StokesFlowOnTheMesh)
{
  const double u = velocity(CELL, at(MIDDLE, 0.0, false), 0.01, 0.0, 10000) / (2.0 / 3.0 * 0.252731);
  EXPECT_GT(u, 0.85);
  EXPECT_LT(u, 1.2);
}

// A fast body leaves a cell after L/w: u goes with 1/w, and viscosity does not matter
TEST(OwnWake, FastBody)
{
  for (const Response &response : {CELL, CELL_POINT}) {
    const Place place = at(MIDDLE, 0.5, true);
    const double slow = velocity(response, place, 1e-4, 1e3, 1000), fast = velocity(response, place, 1e-5, 1e4, 1000);
    EXPECT_NEAR(slow / fast, 10.0, 0.2);
  }
}

// Between cells less of the own wake is seen than in the middle of one, at any speed
TEST(OwnWake, LessBetweenCells)
{
  for (double P : {0.0, 1.0, 10.0, 100.0}) {
    const double D = 0.1 / (1.0 + P);
    const double middle = velocity(CELL_POINT, at(MIDDLE, 0.2, true), D, P, 5000);
    const double corner = velocity(CELL_POINT, at(CORNER, 0.2, true), D, P, 5000);
    EXPECT_GT(corner, 0.0);
    EXPECT_LT(corner, 0.7 * middle);
  }
}

// In no place and for no size does the wake point against the force
TEST(OwnWake, WeightsArePositive)
{
  for (bool linear : {false, true})
    for (double size = 0.0; size < 1.5; size += 0.1)
      for (double x = 0.0; x <= 1.0; x += 0.05)
        for (double y = 0.0; y <= x; y += 0.05)
          for (double z = 0.0; z <= y; z += 0.05) {
            const double offset[3] = {x, y, z};
            const Step step(linear ? CELL_POINT : CELL, at(offset, size, linear), 0.1, 0.1);
            for (double weight : step.weight) ASSERT_GT(weight, 0.0) << linear << ' ' << size << ' ' << x << ' ' << y << ' ' << z;
          }
}

// Whatever the step and the speed: modes only fade
TEST(OwnWake, NeverGrows)
{
  for (const Response &response : {CELL, CELL_POINT})
    for (double D : {0.0, 1e-12, 1e-3, 1.0, 1e12})
      for (double C : {0.0, 1e-12, 1.0, 1e12}) {
        const Step step(response, at(CORNER, 1.0, true), D, C);
        for (double kept : step.kept) {
          EXPECT_GE(kept, 0.0);
          EXPECT_LE(kept, 1.0);
        }
      }
}

// Diffusion is implicit in the solver as here, so the end does not depend on the step
TEST(OwnWake, EndDoesNotDependOnTheStep)
{
  const Place place = at(MIDDLE, 0.2, true);
  EXPECT_NEAR(velocity(CELL_POINT, place, 1.0, 0.0, 1000) / velocity(CELL_POINT, place, 0.01, 0.0, 10000), 1.0, 1e-6);
}

// At rest, for any stiffness: the end is that of an explicit source, and nothing is owed any more
TEST(OwnWake, StiffDragComesLaterButWhole)
{
  const Place place = at(MIDDLE, 0.2, true);
  const double exact = velocity(CELL_POINT, place, 0.1, 0.0, 5000);
  const Step step(CELL_POINT, place, 0.1, 0.0);
  for (double kappa : {0.1, 1.0, 10.0, 100.0}) {
    double a[2] = {0.0, 0.0}, owed = 0.0;
    const double first = step.advance(0.1, kappa, a, owed);
    double answer = 0.0, whole = 0.0;
    for (int i = 0; i < 2; i++) {
      answer += step.ofCell[i] * step.still[i];
      whole += 0.1 * step.weight[i] * step.kept[i];
    }
    EXPECT_NEAR(first * (1.0 + kappa * answer) / whole, 1.0, 1e-12) << kappa;
    EXPECT_NEAR(owed / (0.1 * kappa * answer / (1.0 + kappa * answer)), 1.0, 1e-12) << kappa;

    double u = 0.0;
    for (int n = 0; n < 100000; n++) u = step.advance(0.1, kappa, a, owed);
    EXPECT_NEAR(u / exact, 1.0, 1e-6) << kappa;
    EXPECT_NEAR(owed, 0.0, 1e-6) << kappa;
  }
}
