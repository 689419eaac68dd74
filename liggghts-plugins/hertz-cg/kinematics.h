/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_KINEMATICS_H
#define GRAINJET_KINEMATICS_H

#include "physics/contact/vector3.h"

namespace grainjet {

inline contact::Vector3 vector(const double *a) { return {a[0], a[1], a[2]}; }

/* Relative motion of the surfaces of two grains at the contact point. Grains is anything with the host's
   arrays x, v, omega and radius.                                                           */
struct Kinematics {
  contact::Vector3 delta;        // from j to i
  contact::Vector3 normal;       // unit
  double overlap;
  double armI, armJ;             // from the centres to the contact point
  contact::Vector3 velocity;     // of the centres
  contact::Vector3 spin;         // armI wi + armJ wj: n x spin is what rotation adds at the contact point
  contact::Vector3 turning;      // wi - wj
  double vn;
  contact::Vector3 vt;

  template <class Grains>
  Kinematics(const Grains &g, int i, int j, double distance)
  {
    delta = vector(g.x[i]) - vector(g.x[j]);
    normal = (1.0 / distance) * delta;
    overlap = g.radius[i] + g.radius[j] - distance;
    armI = g.radius[i] - 0.5 * overlap;
    armJ = g.radius[j] - 0.5 * overlap;
    velocity = vector(g.v[i]) - vector(g.v[j]);
    spin = armI * vector(g.omega[i]) + armJ * vector(g.omega[j]);
    turning = vector(g.omega[i]) - vector(g.omega[j]);
    vn = contact::dot(velocity, normal);
    vt = velocity - vn * normal + contact::cross(normal, spin);
  }

  // power [W] of the forces of a contact on this motion of its grains
  double power(const contact::Vector3 &force, const contact::Vector3 &twist, const contact::Vector3 &rolling) const
  {
    return contact::dot(force, velocity) - contact::dot(twist, spin) + contact::dot(rolling, turning);
  }
};

}

#endif
