/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_COARSE_GRAINING_H
#define GRAINJET_CONTACT_COARSE_GRAINING_H

#include "physics/contact/hertz_mindlin.h"
#include "physics/contact/rolling.h"

namespace grainjet {
namespace contact {

/* Coarse graining, Weaver & Miskovic (2023), section 2.4 and appendix A. A grain of radius
   f Rp stands for f^3 particles of radius Rp. Density, moduli, restitution, friction and
   translational velocities are equal, w_grain = w_particle / f.

   A contact of grains is evaluated for the particles it stands for:
     lengths (overlap, radius, spring)  / f
     masses                             / f^3
   and carried back by
     forces                             * f^2
     torques and energies               * f^3
   Hertz-Mindlin is self-similar, so this equals the law evaluated on the grain itself; a law
   that is not (linear spring, cohesion) becomes consistent by the same three lines.       */
class CoarseGraining {
 public:

  explicit CoarseGraining(double factor = 1.0)
    : length_(1.0 / factor), mass_(1.0 / (factor * factor * factor)),
      factor_(factor), force_(factor * factor), torque_(factor * factor * factor) {}

  double factor() const { return factor_; }

  // grain to particle
  Geometry particle(const Geometry &grain) const
  {
    return {length_ * grain.overlap, length_ * grain.radius, mass_ * grain.mass};
  }
  Spheres particles(const Spheres &grains) const
  {
    return {length_ * grains.radius1, length_ * grains.radius2, mass_ * grains.mass1, mass_ * grains.mass2};
  }
  Vector3 particleTorque(const Vector3 &grain) const { return mass_ * grain; }
  Vector3 particleSpring(const Vector3 &grain) const { return length_ * grain; }
  Vector3 particleRotation(const Vector3 &grain) const { return factor_ * grain; }

  // particle to grain
  Vector3 grainSpring(const Vector3 &particle) const { return factor_ * particle; }
  Force grainForce(const Force &particle) const
  {
    return {force_ * particle.normal, force_ * particle.tangential};
  }
  Vector3 grainTorque(const Vector3 &particle) const { return torque_ * particle; }
  double grainEnergy(double particle) const { return torque_ * particle; }

 private:

  double length_, mass_;              // grain to particle
  double factor_, force_, torque_;    // particle to grain
};

}
}

#endif
