/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_HEAT_LUMPED_TEMPERATURE_H
#define GRAINJET_HEAT_LUMPED_TEMPERATURE_H

#include <cmath>

namespace grainjet {
namespace heat {

/* One temperature per particle: m c dT/dt = H (Tr - T), with H = h A and the temperature Tr at which the
   particle would exchange no heat with the fluid. A grain stands for f^3 particles of diameter d that are all
   of its temperature: its mass and H are f^3 times theirs, so it follows the curve of its particles.     */

// Recovery factor r of a sphere with a laminar boundary layer: Pr^(1/2) (Pohlhausen 1921; Eckert & Drake, Analysis
// of Heat and Mass Transfer, 1972), 0.84 in air. A turbulent layer, for which Pr^(1/3) = 0.89 holds, needs a
// Reynolds number beyond some 2e5, which grains do not reach. The flow in the wake, behind the point of
// separation, is not in it.
inline double recoveryFactor(double prandtl)
{
  return std::sqrt(prandtl);
}

// Recovery temperature (K): T + r slip^2/(2 cp). T: of the undisturbed fluid (K), slipSpeed: |uf - up| (m/s),
// cp: of the fluid at constant pressure (J/(kg K))
inline double recoveryTemperature(double T, double slipSpeed, double cp, double prandtl)
{
  return T + recoveryFactor(prandtl) * slipSpeed * slipSpeed / (2.0 * cp);
}

// H of a grain (W/K): Nu k/d times the surface pi d^2 of each of its f^3 particles. conductivity: of the fluid
// (W/(m K)), diameter: of the original particle, d = 2 r/f (m), cg: the factor f of coarse graining
inline double grainCoefficient(double nusselt, double conductivity, double diameter, double cg)
{
  return M_PI * nusselt * conductivity * diameter * cg * cg * cg;
}

// Biot number h (V/A)/kp = h d/(6 kp) of a grain's particles, from the grain's H (W/K). kp: conductivity of the
// particle (W/(m K)). Up to 0.1 one temperature describes a sphere within some per cent (Incropera &
// DeWitt, Fundamentals of Heat and Mass Transfer, 5.1)
inline double biot(double grainCoefficient, double diameter, double cg, double kp)
{
  return grainCoefficient / (6.0 * M_PI * diameter * cg * cg * cg * kp);
}

/* The part of the way to Tr that the temperature covers within a time t, exactly: 1 - exp(-x), x = H t/(m c).
   From 0 to 1 for any x >= 0. Of small x, as in nearly every step of DEM, the series: its first missing term is
   x^5/720 < 2e-18 of the result.                                                              */
inline double heatingFraction(double x)
{
  if (x < 1e-3) return x * (1.0 - x * (1.0/2 - x * (1.0/6 - x * (1.0/24 - x * (1.0/120)))));
  return -std::expm1(-x);
}

}
}

#endif
