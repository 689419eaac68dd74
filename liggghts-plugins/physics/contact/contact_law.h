/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_CONTACT_LAW_H
#define GRAINJET_CONTACT_CONTACT_LAW_H

#include "physics/contact/cohesion.h"
#include "physics/contact/hertz_mindlin.h"
#include "physics/contact/rolling.h"

namespace grainjet {
namespace contact {

/* HISTORY: spring with Coulomb limit and dashpot; NO_HISTORY: the dashpot alone, up to the Coulomb
   limit; OFF: none                                                                             */
enum class Tangential { HISTORY, NO_HISTORY, OFF };

// The law of a contact: Hertz-Mindlin, and what may be added to it. Defaults are the plain law
struct LawOptions {
  Tangential tangential = Tangential::HISTORY;
  bool tangentialDamping = true;        // dashpot beside the tangential spring
  bool limitForce = false;              // the normal force is never attractive
  Rolling rolling = Rolling::OFF;
  bool torsion = false;                 // rolling resistance also against rotation about the normal
  Cohesion cohesion = Cohesion::OFF;
  bool tangentialReduce = false;        // cohesion counts in the Coulomb limit
  double rollingInertia = SPHERE_ROLLS;

  bool plain() const
  {
    return tangential != Tangential::NO_HISTORY && tangentialDamping && !limitForce
      && rolling == Rolling::OFF && cohesion == Cohesion::OFF;
  }
  bool rollingSpring() const { return rolling == Rolling::EPSD || rolling == Rolling::EPSD2; }
};

// Motion of sphere 1 relative to 2 at the contact point
struct Motion {
  Vector3 normal;     // unit, from 2 to 1
  double vn;          // m/s
  Vector3 vt;         // m/s
  Vector3 turning;    // 1/s, w1 - w2
  double dt;          // s
};

// What a contact remembers
struct Springs {
  Vector3 tangential;   // m
  Vector3 rolling;      // N m, torque on 1
};

struct Load {
  Force force;          // on 1
  Vector3 rolling;      // N m, on 1
};

/* Force and torque of a contact with all that may be added to the plain law. Springs move on by one step
   if `advance` is set.                                                                          */
inline Load contactLoad(const PairMaterial &m, const LawOptions &law, Stiffness k, const Geometry &g,
                        const Spheres &s, const Motion &motion, Springs &springs, bool advance)
{
  const Vector3 zero = {0.0, 0.0, 0.0};
  Load load = {{normalForce(k, g.overlap, motion.vn), zero}, zero};
  if (law.limitForce && load.force.normal < 0.0) load.force.normal = 0.0;
  double pressed = load.force.normal;    // what friction goes by

  if (law.cohesion != Cohesion::OFF) {
    load.force.normal -= m.cohesionEnergy * cohesionArea(law.cohesion, s, g.overlap);
    if (law.tangentialReduce) pressed = load.force.normal;
  }

  const double limit = m.friction * std::fabs(pressed);
  if (law.tangential == Tangential::HISTORY) {
    if (!law.tangentialDamping) k.tangentialDamping = 0.0;
    load.force.tangential = tangentialForce(k, limit, motion.vt, springs.tangential, advance);
  } else if (law.tangential == Tangential::NO_HISTORY) {
    const double damping = law.tangentialDamping ? k.tangentialDamping : 0.0, slip = length(motion.vt);
    load.force.tangential = -(limit < damping * slip ? limit / slip : damping) * motion.vt;
  }

  if (law.rolling == Rolling::CDT)
    load.rolling = rollingTorque(m, k, g, motion.normal, motion.turning, law.torsion);
  else if (law.rollingSpring())
    load.rolling = rollingSpringTorque(law.rolling, m, k, g, s, law.rollingInertia, pressed, motion.normal,
                                       motion.turning, motion.dt, law.torsion, springs.rolling, advance);
  return load;
}

// Energy [J] that a contact keeps: in its springs, and of cohesion (negative)
inline double contactEnergy(const PairMaterial &m, const LawOptions &law, const Stiffness &k, const Geometry &g,
                            const Spheres &s, const Springs &springs)
{
  double energy = elasticEnergy(k, g.overlap, springs.tangential);
  if (law.cohesion != Cohesion::OFF) energy += m.cohesionEnergy * cohesionVolume(law.cohesion, s, g.overlap);
  if (law.rollingSpring())
    energy += rollingEnergy(rollingStiffness(law.rolling, m, k, g.radius), springs.rolling);
  return energy;
}

}
}

#endif
