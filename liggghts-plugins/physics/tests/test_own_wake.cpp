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

// Velocity under a unit force after a number of steps, in F/(rho nu L), for D = nu dt/L^2 and
// P = w L/nu
double velocity(const Response &response, double size, double D, double P, int steps)
{
  const Step step(response, size, D, P * D);
  double u[2] = {0.0, 0.0};
  for (int n = 0; n < steps; n++)
    for (int i = 0; i < 2; i++) u[i] = (u[i] + step.gain[i] * D) * step.kept[i];
  return u[0] + u[1];
}

}

// A steady force in fluid at rest: two thirds of Watson's integral for the cubic lattice, 0.252731,
// if the sample is that of the cell. Two exponentials for a tail like t^(-3/2): 10 %.
TEST(OwnWake, StokesFlowOnTheMesh)
{
  EXPECT_NEAR(velocity(CELL, 0.0, 0.01, 0.0, 10000) / (2.0 / 3.0 * 0.252731), 1.0, 0.10);
}

// One step that is too short for any diffusion: two thirds of the impulse are not taken up by the
// pressure. The two modes fit the time from 0.1 L^2/nu on: 15 %.
TEST(OwnWake, FirstMoment)
{
  EXPECT_NEAR(velocity(CELL, 0.0, 1e-6, 0.0, 1) / 1e-6 / (2.0 / 3.0), 1.0, 0.15);
}

// A fast body leaves a cell after L/w: u goes with 1/w, and viscosity does not matter
TEST(OwnWake, FastBody)
{
  for (const Response &response : {CELL, CELL_POINT}) {
    const double slow = velocity(response, 0.5, 1e-4, 1e3, 1000), fast = velocity(response, 0.5, 1e-5, 1e4, 1000);
    EXPECT_NEAR(slow / fast, 10.0, 0.2);
  }
}

// cellPoint mixes in the cells around, and dividing the force spreads it: both show less of it
TEST(OwnWake, SmallerWhereItIsSpread)
{
  for (double P : {0.0, 1.0, 10.0, 100.0}) {
    const double D = 0.1 / (1.0 + P);
    EXPECT_LT(velocity(CELL_POINT, 0.0, D, P, 5000), 0.8 * velocity(CELL, 0.0, D, P, 5000));
    for (const Response &response : {CELL, CELL_POINT})
      EXPECT_LT(velocity(response, 1.0, D, P, 5000), velocity(response, 0.0, D, P, 5000));
  }
}

// Whatever the step, the speed and the size: modes only fade, and answer in the direction of the force
TEST(OwnWake, NeverGrows)
{
  for (const Response &response : {CELL, CELL_POINT})
    for (double size : {0.0, 0.3, 1.0, 50.0})
      for (double D : {0.0, 1e-12, 1e-3, 1.0, 1e12})
        for (double C : {0.0, 1e-12, 1.0, 1e12}) {
          const Step step(response, size, D, C);
          for (int i = 0; i < 2; i++) {
            EXPECT_GT(step.gain[i], 0.0);
            EXPECT_GE(step.kept[i], 0.0);
            EXPECT_LE(step.kept[i], 1.0);
          }
        }
}

// Diffusion is implicit in the solver as here, so the end does not depend on the step
TEST(OwnWake, EndDoesNotDependOnTheStep)
{
  EXPECT_NEAR(velocity(CELL_POINT, 0.2, 1.0, 0.0, 1000) / velocity(CELL_POINT, 0.2, 0.01, 0.0, 10000), 1.0, 1e-6);
}
