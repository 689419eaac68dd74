/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "wall-collisions/collision.h"
#include "plate-stats/plate_geometry.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using grainjet::Collision;
using grainjet::PlateGeometry;

namespace {

const double ORIGIN[3] = {0, 0, 0};

PlateGeometry plate(double nx, double ny, double nz, int rings = 4)
{
  const double normal[3] = {nx, ny, nz};
  return PlateGeometry(ORIGIN, normal, 2.0, rings);
}

int ring(const PlateGeometry &p, double a, double b)
{
  const double ab[2] = {a, b};
  return p.ring(ab);
}

}

// A ring holds its inner edge and not its outer one; all numbers here are exact
TEST(PlateGeometry, RingsAndTheirEdges)
{
  const PlateGeometry p = plate(0, 0, 1);
  EXPECT_EQ(ring(p, 0, 0), 0);
  EXPECT_EQ(ring(p, 0.5, 0), 1);
  EXPECT_EQ(ring(p, 0, -0.5), 1);
  EXPECT_EQ(ring(p, std::nextafter(0.5, 0), 0), 0);
  EXPECT_EQ(ring(p, -1.5, 0), 3);
  EXPECT_EQ(ring(p, std::nextafter(2.0, 0), 0), 3);
  EXPECT_EQ(ring(p, 2.0, 0), -1);
  EXPECT_EQ(ring(p, 0, 17), -1);
  EXPECT_EQ(ring(p, std::nan(""), 0), -1);
  EXPECT_EQ(p.innerRadius(0), 0);
  EXPECT_EQ(p.innerRadius(3), 1.5);
}

// Rounding of r/R n must never give a ring beyond the last
TEST(PlateGeometry, JustInsideTheRimForManyRings)
{
  for (int rings = 1; rings < 500; rings++)
    EXPECT_EQ(ring(plate(0, 0, 1, rings), std::nextafter(2.0, 0), 0), rings - 1) << rings;
}

TEST(PlateGeometry, CoordinatesAreTheLaboratorysOwn)
{
  const double x[3] = {0.1, 0.2, 0.3};
  double ab[2];
  for (double side : {1.0, -5.0}) {    // the same from either side, any length
    plate(0, 0, side).project(x, ab);
    EXPECT_DOUBLE_EQ(ab[0], 0.1);
    EXPECT_DOUBLE_EQ(ab[1], 0.2);
    plate(side, 0, 0).project(x, ab);
    EXPECT_DOUBLE_EQ(ab[0], 0.2);
    EXPECT_DOUBLE_EQ(ab[1], 0.3);
    plate(0, side, 0).project(x, ab);
    EXPECT_DOUBLE_EQ(ab[0], 0.3);
    EXPECT_DOUBLE_EQ(ab[1], 0.1);
    EXPECT_DOUBLE_EQ(plate(0, 0, side).height(x), side > 0 ? 0.3 : -0.3);
  }
}

// For any direction: the axes are orthonormal and point() undoes project()
TEST(PlateGeometry, ObliquePlates)
{
  const double centre[3] = {1, -2, 3};
  for (const auto &n : {std::array<double, 3>{1, 2, 3}, {-3, 1, 1e-3}, {0.2, -5, 0.1}, {1, 1, 1}}) {
    const PlateGeometry p(centre, n.data(), 1, 1);
    double origin[3], a[3], b[3];
    p.point(0, 0, origin);
    p.point(1, 0, a);
    p.point(0, 1, b);
    for (int i = 0; i < 3; i++) {
      EXPECT_EQ(origin[i], centre[i]);
      a[i] -= centre[i];
      b[i] -= centre[i];
    }
    EXPECT_NEAR(PlateGeometry::dot(a, a), 1, 1e-14);
    EXPECT_NEAR(PlateGeometry::dot(b, b), 1, 1e-14);
    EXPECT_NEAR(PlateGeometry::dot(a, b), 0, 1e-14);
    EXPECT_NEAR(PlateGeometry::dot(a, p.normal()), 0, 1e-14);
    EXPECT_NEAR(PlateGeometry::dot(b, p.normal()), 0, 1e-14);

    double x[3], ab[2];
    p.point(0.3, -0.4, x);
    p.project(x, ab);
    EXPECT_NEAR(ab[0], 0.3, 1e-14);
    EXPECT_NEAR(ab[1], -0.4, 1e-14);
    EXPECT_NEAR(p.height(x), 0, 1e-14);
  }
}

// A rigid motion takes the coordinates of a point along, from either side; rounding in the
// axes is mended
TEST(PlateGeometry, CarriedAlong)
{
  const double start[3] = {1, -2, 3}, end[3] = {-4, 0.5, 2}, turn = 0.7;
  const double c = std::cos(turn), s = std::sin(turn);
  const auto rotated = [&](const double *x, double *y) {    // about y
    y[0] = c * x[0] + s * x[2];
    y[1] = x[1];
    y[2] = -s * x[0] + c * x[2];
  };
  for (double side : {1.0, -2.0}) {
    const double normal[3] = {0.3 * side, 0.1 * side, side};
    PlateGeometry p(start, normal, 1, 4);
    double x[3], moved[3], from[3], ab[2], after[2], n[3], a[3];
    p.point(0.3, -0.45, x);
    for (int i = 0; i < 3; i++) x[i] += 0.01 * p.normal()[i];
    p.project(x, ab);
    const double height = p.height(x);
    for (int i = 0; i < 3; i++) from[i] = x[i] - start[i];
    rotated(from, moved);
    for (int i = 0; i < 3; i++) moved[i] += end[i];
    rotated(p.normal(), n);
    rotated(p.a(), a);
    for (int i = 0; i < 3; i++) {
      n[i] *= 1 + 1e-6;
      a[i] = 0.999 * a[i] + 1e-9 * n[i];
    }
    p.carry(end, n, a);
    p.project(moved, after);
    EXPECT_NEAR(after[0], ab[0], 1e-14);
    EXPECT_NEAR(after[1], ab[1], 1e-14);
    EXPECT_NEAR(p.height(moved), height, 1e-14);
    EXPECT_EQ(p.ring(after), p.ring(ab));
  }
}

// Three steps by hand: normal forces 1, 3, 2 along (0,0,-1), tangential 3-4-5 triangles
TEST(Collision, PeaksSumsAndMeans)
{
  Collision c = Collision();
  const double normal[3] = {0, 0, -1};
  const double forces[3][3] = {{3, 4, -1}, {0, 0, -3}, {6, 8, -2}};
  for (const auto &f : forces) c.addStep(f, normal, 0.5);
  EXPECT_EQ(c.steps, 3);
  EXPECT_EQ(c.duration, 1.5);
  EXPECT_EQ(c.normalPeak, 3);
  EXPECT_EQ(c.tangentialPeak, 10);
  EXPECT_EQ(c.normalMean(), 2);
  EXPECT_EQ(c.tangentialMean(), 5);
}

// A law that only attracts has a negative peak, not 0
TEST(Collision, AttractionHasANegativePeak)
{
  Collision c = Collision();
  const double normal[3] = {1, 0, 0}, weak[3] = {-1, 0, 0}, strong[3] = {-2, 0, 0};
  c.addStep(strong, normal, 1);
  c.addStep(weak, normal, 1);
  EXPECT_EQ(c.normalPeak, -1);
}
