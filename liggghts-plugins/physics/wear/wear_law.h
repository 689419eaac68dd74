/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WEAR_LAW_H
#define GRAINJET_WEAR_LAW_H

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace grainjet {
namespace wear {

static constexpr double HALF_PI = 1.5707963267948966;

// Rounding by which an angle may lie outside 0 to pi/2
static constexpr double ANGLE_ROUNDING = 1e-9;

/* One finished impact on a surface, as it was when the contact began. Mass and diameter are those of ONE original
   particle; a grain of coarse-graining factor f_cg stands for f_cg^3 of them, each of which hits the surface with the
   speed and angle of the grain.                                                                     */
struct Impact {
  double speed;              // m/s, of the particle's centre against the surface, >= 0
  double angle;              // rad, between velocity and surface: 0 along it, pi/2 against it
  double mass;               // kg, of one original particle
  double diameter;           // m, of one original particle
  double particles = 1.0;    // original particles in the grain, f_cg^3

  // J, the grain's normal force times the speed at which its surface slides on the target, over the whole contact.
  // With scaled contact laws a grain's force goes with f_cg^2 and its path of sliding with f_cg, so this is already
  // that of all its particles.
  double slidingWork = 0.0;
};

// Relation of the removed volume to one impact. A new law is one header beside this one and one line in wear_laws.h.
class WearLaw {
 public:

  virtual ~WearLaw() = default;

  /* Volume that the impact removes from the target [m3], of all particles of the grain, >= 0. An angle outside 0 to pi/2 or
     a speed below 0, for which no law is made, is a std::domain_error.                                 */
  double volume(const Impact &impact) const
  {
    if (!(impact.angle >= -ANGLE_ROUNDING && impact.angle <= HALF_PI + ANGLE_ROUNDING))
      outside("angle", impact.angle, "rad, must lie between 0 (along the surface) and pi/2 (against it)");
    if (!(impact.speed >= 0.0 && std::isfinite(impact.speed))) outside("speed", impact.speed, "m/s, must be 0 or more");
    Impact bounded = impact;
    bounded.angle = std::fmin(std::fmax(impact.angle, 0.0), HALF_PI);
    return removed(bounded);
  }

 private:

  // The same for an impact with angle and speed in their ranges
  virtual double removed(const Impact &impact) const = 0;

  static void outside(const char *what, double value, const char *range)
  {
    std::ostringstream text;
    text << "law of wear: " << what << " of an impact is " << value << ' ' << range;
    throw std::domain_error(text.str());
  }
};

}
}

#endif
