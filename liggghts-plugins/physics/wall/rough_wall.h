/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_ROUGH_WALL_H
#define GRAINJET_ROUGH_WALL_H

#include "physics/contact/vector3.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace grainjet {
namespace wall {

using contact::Vector3;
using contact::cross;
using contact::dot;
using contact::length;

static constexpr double HALF_PI = 1.5707963267948966;

// Inclinations beyond so many standard deviations are left out
static constexpr double MOST_DEVIATIONS = 4.0;

// Draws after which the wall is taken as smooth. A grain that grazes a wall hits one facet in
// about ten, so the chance that it comes to that is none.
static constexpr uint32_t MOST_DRAWS = 2000;

/* Normal of the facet of a rough wall that a grain hits: the stochastic model of Sommerfeld and Huber, Int. J. Multiphase
   Flow 25 (1999) 1457. The wall consists of facets whose inclinations are normally distributed with mean zero and standard
   deviation `deviation` (rad). A grain meets a facet with a probability in proportion to the component of its velocity against
   it: facets that face it are hit more often, those that lie in the lee are not hit at all (shadow effect). The model has
   the inclination in the plane of the impact; here the facets are inclined across it as well, by the same law, since the roughness
   has no direction.

   normal: of the smooth wall, towards the grain, of length 1. velocity: of the grain against the wall. A grain that does not
   approach the wall has the smooth one. Random: normals(n, four) gives four independent standard normal numbers of draw n. */
template<class Random>
Vector3 facet(const Vector3 &normal, const Vector3 &velocity, double deviation, const Random &random)
{
  const double speed = length(velocity);
  if (!(dot(velocity, normal) < 0.0)) return normal;

  const Vector3 direction = 1.0 / speed * velocity;
  Vector3 along = contact::without(direction, normal);
  if (length(along) < 1e-6) {      // head-on: any direction will do
    const Vector3 axis = std::fabs(normal.x) < 0.5 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    along = contact::without(axis, normal);
  }
  along = 1.0 / length(along) * along;
  const Vector3 across = cross(normal, along);

  // the largest component of the direction against any facet
  const double most = MOST_DEVIATIONS * deviation;
  const double incidence = std::asin(std::min(1.0, -dot(direction, normal)));
  const double bound = std::sin(std::min(HALF_PI, incidence + most));

  for (uint32_t draw = 0; draw < MOST_DRAWS; draw++) {
    double four[4];
    random.normals(draw, four);
    const double a = deviation * four[0], b = deviation * four[1];
    if (std::fabs(a) > most || std::fabs(b) > most) continue;
    const Vector3 tilted = normal + std::tan(a) * along + std::tan(b) * across;
    const Vector3 n = 1.0 / length(tilted) * tilted;

    // the squares of two standard normal numbers make one that is uniform between 0 and 1
    const double uniform = std::exp(-0.5 * (four[2] * four[2] + four[3] * four[3]));
    if (uniform * bound < -dot(direction, n)) return n;
  }
  return normal;
}

/* The rotation (axis times angle in rad) that turns the unit vector a into b by the shortest way */
inline Vector3 turn(const Vector3 &a, const Vector3 &b)
{
  const Vector3 axis = cross(a, b);
  const double size = length(axis);
  if (size == 0.0) return {0, 0, 0};
  return std::atan2(size, dot(a, b)) / size * axis;
}

// v turned by a rotation (Rodrigues); its length stays
inline Vector3 turned(const Vector3 &v, const Vector3 &rotation)
{
  const double angle = length(rotation);
  if (angle == 0.0) return v;
  const Vector3 k = 1.0 / angle * rotation;
  return std::cos(angle) * v + std::sin(angle) * cross(k, v) + (1.0 - std::cos(angle)) * dot(k, v) * k;
}

}
}

#endif
