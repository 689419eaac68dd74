/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_TIME_STEP_H
#define GRAINJET_CONTACT_TIME_STEP_H

#include <cmath>

namespace grainjet {
namespace contact {

/* Time scales that an explicit time step has to stay below. All in SI units.

   Rayleigh time [s]: a surface wave's way around a sphere,
     t_R = pi R sqrt(rho/G) / (0.1631 nu + 0.8766),   G = E/(2(1+nu)).
   With R of the grain as it is simulated, so that it grows with the factor f_cg.

   Weaver & Miskovic (2023) give dt/t_R in Table 4. Erratum: the text there says E = 5e6 Pa,
   but the whole column (5.9, 6.6, 9.2, 4.6, 2.3 %) follows from E = 5e5 Pa.          */
inline double rayleighTime(double radius, double density, double youngs, double poisson)
{
  const double pi = 3.14159265358979323846;
  const double G = youngs / (2.0 * (1.0 + poisson));
  return pi * radius * std::sqrt(density / G) / (0.1631 * poisson + 0.8766);
}

/* Hertz time [s]: duration of an elastic head-on impact at relative speed v > 0,
     t_H = 2.87 (m*^2 / (R* E*^2 v))^(1/5)
   (Johnson, Contact Mechanics, 1985, section 11.4: 2.943 d_max/v).                   */
inline double hertzTime(double effectiveMass, double effectiveRadius, double effectiveYoungs, double speed)
{
  return 2.87 * std::pow(effectiveMass * effectiveMass
                         / (effectiveRadius * effectiveYoungs * effectiveYoungs * speed), 0.2);
}

}
}

#endif
