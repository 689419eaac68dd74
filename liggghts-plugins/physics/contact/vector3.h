/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_VECTOR3_H
#define GRAINJET_CONTACT_VECTOR3_H

#include <cmath>

namespace grainjet {
namespace contact {

// A vector in space, only what a contact law needs
struct Vector3 {
  double x, y, z;
};

inline Vector3 operator+(const Vector3 &a, const Vector3 &b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vector3 operator-(const Vector3 &a, const Vector3 &b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vector3 operator*(double s, const Vector3 &a)
{
  return {s * a.x, s * a.y, s * a.z};
}

inline double dot(const Vector3 &a, const Vector3 &b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector3 cross(const Vector3 &a, const Vector3 &b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vector3 &a)
{
  return std::sqrt(dot(a, a));
}

// what is left of a without its part along the unit vector n
inline Vector3 without(const Vector3 &a, const Vector3 &n)
{
  return a - dot(a, n) * n;
}

}
}

#endif
