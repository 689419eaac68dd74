/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_ROLLING_H
#define GRAINJET_CONTACT_ROLLING_H

#include "physics/contact/hertz_mindlin.h"

namespace grainjet {
namespace contact {

/* Resistance to rolling, as the models of the same names in LIGGGHTS 3.8 `pair_style gran`. Torques
   [N m] act on grain 1, grain 2 gets the opposite; w = w1 - w2 is the relative rotation, without its
   part along the normal n unless `torsion` is set.

     CDT     constant directional torque (Ai et al., Powder Technol. 206 (2011) 269, model A):
             -mu_r kn d R* w/|w|
     EPSD    elastic-plastic spring and dashpot (same source, model C): spring kr = 2.25 kn mu_r^2 R*^2,
             torque at most mu_r |Fn| R*, dashpot 2 eta sqrt(I kr) while the spring is not at its limit,
             1/I = 1/(1.4 m1 R1^2) + 1/(1.4 m2 R2^2)
     EPSD2   spring kr = kt R*^2, the same limit, no dashpot (Iwashita & Oda, J. Eng. Mech. 124 (1998)
             285, as modified in LIGGGHTS)

   All of them scale with f_cg^3: kr and the limit with the cube of a length, I kr with its eighth
   power while w goes with its inverse.                                                        */
enum class Rolling { OFF, CDT, EPSD, EPSD2 };

// The two spheres of a contact
struct Spheres {
  double radius1, radius2;   // m
  double mass1, mass2;       // kg
};

// Moment of inertia of a sphere about the contact point over m R^2; of a disc (`dimension 2`): 1.5
const double SPHERE_ROLLS = 1.4;
const double DISC_ROLLS = 1.5;

inline Vector3 rollingTorque(const PairMaterial &m, const Stiffness &k, const Geometry &g,
                             const Vector3 &n, const Vector3 &relativeRotation, bool torsion = false)
{
  const double w = length(relativeRotation);
  if (w == 0.0) return {0.0, 0.0, 0.0};
  const double size = m.rollingFriction * k.normal * g.overlap * g.radius / w;
  const Vector3 torque = -size * relativeRotation;
  return torsion ? torque : without(torque, n);
}

inline double rollingStiffness(Rolling model, const PairMaterial &m, const Stiffness &k, double radius)
{
  if (model == Rolling::EPSD) return 2.25 * k.normal * m.rollingFriction * m.rollingFriction * radius * radius;
  return k.tangential * radius * radius;
}

/* EPSD and EPSD2. spring: torque of the rolling spring on grain 1 [N m], advanced over dt if `advance` is
   set (a state that is only looked at is evaluated as if a step were over, as the host does).  */
inline Vector3 rollingSpringTorque(Rolling model, const PairMaterial &m, const Stiffness &k, const Geometry &g,
                                   const Spheres &s, double inertia, double normalForce, const Vector3 &n,
                                   const Vector3 &relativeRotation, double dt, bool torsion, Vector3 &spring,
                                   bool advance)
{
  const Vector3 w = torsion ? relativeRotation : without(relativeRotation, n);
  const double kr = rollingStiffness(model, m, k, g.radius);
  Vector3 torque = spring - dt * kr * w;
  const double size = length(torque), limit = std::fabs(normalForce) * g.radius * m.rollingFriction;
  const bool full = size > limit;
  if (full) torque = (limit / size) * torque;
  if (advance) spring = torque;
  if (full || model != Rolling::EPSD) return torque;
  const double I1 = s.mass1 * s.radius1 * s.radius1, I2 = s.mass2 * s.radius2 * s.radius2;
  const double I = inertia * I1 * I2 / (I1 + I2);
  return torque - m.rollingDamping * 2.0 * std::sqrt(I * kr) * w;
}

// Energy [J] in a rolling spring
inline double rollingEnergy(double kr, const Vector3 &spring)
{
  return kr > 0.0 ? 0.5 * dot(spring, spring) / kr : 0.0;
}

}
}

#endif
