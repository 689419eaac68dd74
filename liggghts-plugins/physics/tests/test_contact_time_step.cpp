/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/contact/material.h"
#include "physics/contact/time_step.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace grainjet::contact;

/* Column "% Rayleigh" of Table 4 in Weaver & Miskovic (2023), printed to one decimal. It follows
   from E = 5e5 Pa (not from the 5e6 Pa of the text), nu = 0.3 for glass, 0.37 for acrylic.    */
TEST(TimeStep, rayleighColumnOfTable4)
{
  struct Case { const char *name; double diameter, density, nu, dt, percent; };
  const Case cases[] = {
    {"Hardalupas1, 2", 80e-6, 2950, 0.30, 1e-6, 5.9},
    {"Hardalupas3, 4", 40e-6, 2420, 0.30, 5e-7, 6.6},
    {"Lau1", 40e-6, 1200, 0.37, 5e-7, 9.2},
    {"Lau2", 40e-6, 1200, 0.37, 2.5e-7, 4.6},
    {"Lau3", 40e-6, 1200, 0.37, 1.25e-7, 2.3},
  };
  for (const Case &c : cases) {
    const double percent = 100.0 * c.dt / rayleighTime(0.5 * c.diameter, c.density, 5e5, c.nu);
    EXPECT_NEAR(percent, c.percent, 0.05) << c.name;
    const double printed = 100.0 * c.dt / rayleighTime(0.5 * c.diameter, c.density, 5e6, c.nu);
    EXPECT_GT(printed, 2.0 * c.percent) << "the text's 5e6 Pa cannot be meant: " << c.name;
  }
}

// A grain has the particle's Rayleigh and Hertz times, f_cg times as long
TEST(TimeStep, bothTimesGrowWithTheSizeOfGrains)
{
  const double one = rayleighTime(40e-6, 2950, 5e5, 0.3);
  EXPECT_NEAR(rayleighTime(120e-6, 2950, 5e5, 0.3), 3.0 * one, 1e-12 * one);
  const double m = 4e-10, R = 20e-6, E = 2.7e5;
  EXPECT_NEAR(hertzTime(27.0 * m, 3.0 * R, E, 1.0), 3.0 * hertzTime(m, R, E, 1.0), 1e-12 * hertzTime(m, R, E, 1.0));
}

// 2.87 (...)^(1/5) is 2.9433 d_max/v with Hertz' d_max, to the three figures of the constant
TEST(TimeStep, hertzTimeIsTheDurationOfAnElasticImpact)
{
  const double m = 4e-10, R = 20e-6, E = 2.7e5, v = 3.0;
  const double overlap = std::pow(15.0 * m * v * v / (16.0 * std::sqrt(R) * E), 0.4);
  EXPECT_NEAR(hertzTime(m, R, E, v), 2.9432750643 * overlap / v, 3e-3 * hertzTime(m, R, E, v));
}
