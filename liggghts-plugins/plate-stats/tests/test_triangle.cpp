/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "plate-stats/triangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using grainjet::nearestOnTriangle;

// Face, each edge, each corner, by hand
TEST(Triangle, NearestPointByHand)
{
  const double corner[3][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const double cases[][6] = {{1, 1, 3, 1, 1, 0}, {1, 1, -3, 1, 1, 0}, {2, -5, 1, 2, 0, 0},
    {-2, 1, 1, 0, 1, 0}, {4, 4, 0, 2, 2, 0}, {-1, -1, 2, 0, 0, 0}, {9, -1, 0, 4, 0, 0},
    {-1, 7, 0, 0, 4, 0}};
  for (const auto &c : cases) {
    double nearest[3];
    const double square = nearestOnTriangle(corner, c, nearest);
    double expected = 0;
    for (int i = 0; i < 3; i++) {
      EXPECT_DOUBLE_EQ(nearest[i], c[3 + i]);
      expected += (c[i] - c[3 + i]) * (c[i] - c[3 + i]);
    }
    EXPECT_DOUBLE_EQ(square, expected);
  }
}

TEST(Triangle, WithoutArea)
{
  const double needle[3][3] = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, p[3] = {1.5, 3, 0};
  double nearest[3];
  EXPECT_DOUBLE_EQ(nearestOnTriangle(needle, p, nearest), 9);
  EXPECT_DOUBLE_EQ(nearest[0], 1.5);
  const double speck[3][3] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  EXPECT_DOUBLE_EQ(nearestOnTriangle(speck, p, nearest), 0.25 + 4 + 1);
}

// No point of a fine grid on the triangle is nearer, and some are nearly as near
TEST(Triangle, AgainstAGrid)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (int n = 0; n < 200; n++) {
    double corner[3][3], p[3], nearest[3];
    for (auto &c : corner)
      for (double &x : c) x = draw(random);
    for (double &x : p) x = 2 * draw(random);
    const double found = std::sqrt(nearestOnTriangle(corner, p, nearest));
    double grid = 1e9;
    const int fine = 60;
    for (int i = 0; i <= fine; i++)
      for (int j = 0; i + j <= fine; j++) {
        double square = 0;
        for (int k = 0; k < 3; k++) {
          const double x = corner[0][k] + (i * (corner[1][k] - corner[0][k])
            + j * (corner[2][k] - corner[0][k])) / fine;
          square += (x - p[k]) * (x - p[k]);
        }
        grid = std::min(grid, std::sqrt(square));
      }
    EXPECT_LE(found, grid + 1e-12);
    EXPECT_GE(found, grid - 0.06);    // spacing of the grid: 2 sqrt(3) / 60
  }
}
