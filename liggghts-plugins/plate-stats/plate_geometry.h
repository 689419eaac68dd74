/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_PLATE_GEOMETRY_H
#define GRAINJET_PLATE_GEOMETRY_H

#include <cmath>

namespace grainjet {

/* A flat round plate, cut into concentric rings of equal width. It can be carried to another
   place as a rigid body.

   In the plate's plane a point has coordinates (a, b) from the centre. For a plate
   whose normal is along an axis of the laboratory they are its two other axes in cyclic
   order ((x, y) for a normal along z, either way); for an oblique one the first is that
   axis projected onto the plate.                                                     */
class PlateGeometry {
 public:

  // normal need not be of unit length, but its square must be a number > 0; radius > 0;
  // rings >= 1
  PlateGeometry(const double *centre, const double *normal, double radius, int rings)
    : radius_(radius), rings_(rings)
  {
    set(centre, normal);
    int main = 0;
    for (int i = 0; i < 3; i++)
      if (std::fabs(normal_[i]) > std::fabs(normal_[main])) main = i;
    const int next = (main + 1) % 3;
    for (int i = 0; i < 3; i++) a_[i] = (i == next) - normal_[next] * normal_[i];
    const double size = std::sqrt(dot(a_, a_));
    for (double &x : a_) x /= size;
    side_ = normal_[main] > 0 ? 1 : -1;    // (a, b) the same from either side
    set_b();
  }

  // The plate after a rigid motion that has brought its centre, its normal and its first
  // axis to these. What rounding has done to lengths and right angles is mended.
  void carry(const double *centre, const double *normal, const double *a)
  {
    set(centre, normal);
    const double across = dot(a, normal_);
    for (int i = 0; i < 3; i++) a_[i] = a[i] - across * normal_[i];
    const double size = std::sqrt(dot(a_, a_));
    for (double &x : a_) x /= size;
    set_b();
  }

  double radius() const { return radius_; }
  int rings() const { return rings_; }
  const double *centre() const { return centre_; }
  const double *normal() const { return normal_; }
  const double *a() const { return a_; }

  // height above the plane, on the side the normal points to (m)
  double height(const double *x) const { return along(x, normal_); }

  // coordinates in the plane (m)
  void project(const double *x, double *ab) const
  {
    ab[0] = along(x, a_);
    ab[1] = along(x, b_);
  }

  // the point of the plane with these coordinates
  void point(double a, double b, double *x) const
  {
    for (int i = 0; i < 3; i++) x[i] = centre_[i] + a * a_[i] + b * b_[i];
  }

  // ring 0 <= r < rings() of a point in the plane, -1 outside the plate. A ring holds its
  // inner edge and not its outer one.
  int ring(const double *ab) const
  {
    const double r = std::hypot(ab[0], ab[1]);
    if (!(r < radius_)) return -1;
    const int ring = static_cast<int>(r / radius_ * rings_);
    return ring < rings_ ? ring : rings_ - 1;
  }

  double innerRadius(int ring) const { return radius_ * ring / rings_; }

  static double dot(const double *p, const double *q)
  {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  }

 private:

  double centre_[3], normal_[3], a_[3], b_[3];
  double side_;
  double radius_;
  int rings_;

  void set(const double *centre, const double *normal)
  {
    const double length = std::sqrt(dot(normal, normal));
    for (int i = 0; i < 3; i++) {
      centre_[i] = centre[i];
      normal_[i] = normal[i] / length;
    }
  }

  void set_b()
  {
    for (int i = 0; i < 3; i++) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      b_[i] = side_ * (normal_[j] * a_[k] - normal_[k] * a_[j]);
    }
  }

  double along(const double *x, const double *axis) const
  {
    const double from[3] = {x[0] - centre_[0], x[1] - centre_[1], x[2] - centre_[2]};
    return dot(from, axis);
  }
};

}

#endif
