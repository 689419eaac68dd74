/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_HERTZ_MINDLIN_H
#define GRAINJET_CONTACT_HERTZ_MINDLIN_H

#include "physics/contact/material.h"
#include "physics/contact/vector3.h"

#include <cmath>

namespace grainjet {
namespace contact {

/* The Hertz-Mindlin spring-dashpot with tangential history, Weaver & Miskovic (2023),
   Eqs. (16), (17) and appendix A:

     kn = 4/3 E* sqrt(R* d)      Sn = 2 E* sqrt(R* d)      gamma_n = -2 sqrt(5/6) beta sqrt(Sn m*)
     kt =   8 G* sqrt(R* d)      St = 8 G* sqrt(R* d)      gamma_t = -2 sqrt(5/6) beta sqrt(St m*)
     Fn = kn d - gamma_n vn                                 (repulsive if positive)
     Ft = -kt s - gamma_t vt, or -mu |Fn| s/|s| once kt |s| > mu |Fn|

   n is the unit vector from grain 2 to grain 1, velocities are those of 1 relative to 2 at
   the contact point, s is the tangential spring, forces act on grain 1. The normal force is
   not cut off when the dashpot makes it attractive at the end of a contact: that is what
   makes the restitution exact, and what the stock LIGGGHTS model `hertz` does.        */

// One contact at one instant
struct Geometry {
  double overlap;     // m, d > 0
  double radius;      // m, R*: 1/R* = 1/R1 + 1/R2
  double mass;        // kg, m*: 1/m* = 1/m1 + 1/m2; the other's mass if one is immovable
};

struct Stiffness {
  double normal;            // N/m, kn
  double tangential;        // N/m, kt
  double normalDamping;     // kg/s, gamma_n
  double tangentialDamping; // kg/s, gamma_t
};

struct Force {
  double normal;        // N, Fn along n
  Vector3 tangential;   // N, Ft, perpendicular to n
};

inline Stiffness stiffness(const PairMaterial &m, const Geometry &g)
{
  const double twoRootFiveSixths = 1.82574185835055380;   // 2 sqrt(5/6)
  const double a = std::sqrt(g.radius * g.overlap);       // radius of the contact area
  Stiffness k;
  const double Sn = 2.0 * m.youngs * a;
  k.normal = 4.0 / 3.0 * m.youngs * a;
  k.tangential = 8.0 * m.shear * a;
  k.normalDamping = twoRootFiveSixths * m.damping * std::sqrt(Sn * g.mass);
  k.tangentialDamping = twoRootFiveSixths * m.damping * std::sqrt(k.tangential * g.mass);
  return k;
}

// Let the tangential spring s [m] grow with the tangential velocity over dt and turn it
// into the present tangential plane
inline void advanceSpring(Vector3 &spring, const Vector3 &n, const Vector3 &vt, double dt)
{
  spring = without(spring + dt * vt, n);
}

// Spring and dashpot along n, the only force of a contact without friction
inline double normalForce(const Stiffness &k, double overlap, double vn)
{
  return k.normal * overlap - k.normalDamping * vn;
}

/* Tangential force with a spring, at most `limit` [N]. When the contact slides, the spring keeps the
   length that carries the limit if `shorten` is set (it is left alone where a state is only looked
   at).                                                                                          */
inline Vector3 tangentialForce(const Stiffness &k, double limit, const Vector3 &vt, Vector3 &spring, bool shorten)
{
  const double stretched = length(spring);
  const double elastic = k.tangential * stretched;
  if (elastic <= limit) return -k.tangential * spring - k.tangentialDamping * vt;
  const double ratio = limit / elastic;
  const Vector3 force = -k.tangential * ratio * spring;
  if (shorten) spring = ratio * spring;
  return force;
}

// Force of the contact; `shorten` as in tangentialForce()
inline Force hertzMindlin(const PairMaterial &m, const Stiffness &k, double overlap, double vn,
                          const Vector3 &vt, Vector3 &spring, bool shorten)
{
  Force f;
  f.normal = normalForce(k, overlap, vn);
  f.tangential = tangentialForce(k, m.friction * std::fabs(f.normal), vt, spring, shorten);
  return f;
}

// Energy [J] in the springs: Hertz 2/5 kn d^2 = 8/15 E* sqrt(R*) d^(5/2), tangential kt s^2/2
inline double elasticEnergy(const Stiffness &k, double overlap, const Vector3 &spring)
{
  return 0.4 * k.normal * overlap * overlap + 0.5 * k.tangential * dot(spring, spring);
}

}
}

#endif
