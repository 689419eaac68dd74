/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_COHESION_H
#define GRAINJET_CONTACT_COHESION_H

#include "physics/contact/rolling.h"

namespace grainjet {
namespace contact {

/* Cohesion by the simplified Johnson-Kendall-Roberts models of LIGGGHTS 3.8: an attraction of the
   cohesion energy density [J/m3] times a contact area A [m2], while the two overlap.

     SJKR    A = pi/4 ((S^2 - r^2)(r^2 - D^2))/r^2,  S = R1 + R2, D = R1 - R2: the circle in which two
             spheres at the distance r cut each other
     SJKR2   A = 4 pi R1 R2/S (S - r)

   An area goes with f_cg^2 and so does the force: with the same energy density a grain is held as the
   particles it stands for.                                                                     */
enum class Cohesion { OFF, SJKR, SJKR2 };

inline double cohesionArea(Cohesion model, const Spheres &s, double overlap)
{
  const double pi = 3.14159265358979323846;
  const double S = s.radius1 + s.radius2, D = s.radius1 - s.radius2, r = S - overlap;
  if (model == Cohesion::SJKR2) return 2.0 * pi * (2.0 * s.radius1 * s.radius2 / S) * overlap;
  return 0.25 * pi * overlap * (S + r) * (r - D) * (r + D) / (r * r);
}

// Energy [J] per cohesion energy density, <= 0: minus the area summed over the overlap
inline double cohesionVolume(Cohesion model, const Spheres &s, double overlap)
{
  const double pi = 3.14159265358979323846;
  const double S = s.radius1 + s.radius2, D = s.radius1 - s.radius2, r = S - overlap;
  if (model == Cohesion::SJKR2) return -pi * (2.0 * s.radius1 * s.radius2 / S) * overlap * overlap;
  // of the integral of (S^2 + D^2) - q^2 - S^2 D^2/q^2 from r to S, in powers of the overlap
  const double cubes = (S * S + S * r + r * r) / 3.0;
  return -0.25 * pi * overlap * (S * S + D * D - cubes - S * D * D / r);
}

}
}

#endif
