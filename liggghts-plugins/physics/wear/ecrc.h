/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WEAR_ECRC_H
#define GRAINJET_WEAR_ECRC_H

#include "physics/wear/coefficients.h"
#include "physics/wear/wear_law.h"

namespace grainjet {
namespace wear {

/* Sand on steels and nickel alloys, of the Erosion/Corrosion Research Center: Zhang, Reuterfors, McLaury, Shirazi & Rybicki,
   Wear 263 (2007) 330.

     removed mass over mass of sand = C B^-0.59 Fs v^n F(a),     C = 2.17e-7, n = 2.41
     F = 5.3983 a - 10.1068 a^2 + 10.9327 a^3 - 6.3283 a^4 + 1.4234 a^5        1.00 at 90 degrees

   B: Brinell hardness of the target. Fs: sharpness of the particles, 1 sharp, 0.53 half rounded, 0.2 fully rounded.
   Some print the polynomial with two decimals: 6 % less at 90 degrees.                                     */
class Ecrc : public WearLaw {
 public:

  static CoefficientList coefficients()
  {
    return {
      {"brinell", "Brinell hardness of the target, a number of 10 to 1000"}, {"sharpness", "of the particles, 0.2 (rounded) to 1 (sharp)"},
      {"density", "of the target, kg/m3"}, {"C", "factor, 2.17e-7 if not given"}, {"n", "exponent of the speed, 2.41 if not given"}};
  }

  explicit Ecrc(const Coefficients &c)
    : perMass_(c.number("C", 2.17e-7) * std::pow(c.between("brinell", 10.0, 1000.0), -0.59)
        * c.between("sharpness", 0.2, 1.0) / c.number("density")),
      n_(c.number("n", 2.41)) {}

  // F(a)
  static double angleFactor(double a)
  {
    return a * (5.3983 + a * (-10.1068 + a * (10.9327 + a * (-6.3283 + a * 1.4234))));
  }

 private:

  double removed(const Impact &i) const override
  {
    return perMass_ * i.particles * i.mass * std::pow(i.speed, n_) * angleFactor(i.angle);
  }

  double perMass_, n_;
};

}
}

#endif
