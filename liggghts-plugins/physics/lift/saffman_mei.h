/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_LIFT_SAFFMAN_MEI_H
#define GRAINJET_LIFT_SAFFMAN_MEI_H

#include <cmath>

namespace grainjet {
namespace lift {

/* Lift on a sphere in a shear flow over Saffman's (Mei 1992, Int. J. Multiphase Flow 18, 145, a fit
   to the simulations of Dandy & Dwyer 1990),

     g = (1 - a) exp(-Re/10) + a,  a = 0.3314 sqrt(b)     Re < 40
       = 0.0524 sqrt(b Re)                                above,    b = Re_w/(2 Re)

   Re = |U - v| d/nu, Re_w = |curl U| d^2/nu. Fitted for 0.1 <= Re <= 100 and
   0.005 <= b <= 0.4. g = 1 at Re = 0. At Re = 40 it falls by (1 - a) exp(-4), at most 0.018: so it is
   printed. Without division by Re or Re_w.                                                   */
inline double meiFactor(double re, double shearRe)
{
  const double root = std::sqrt(0.5 * shearRe);
  const double taken = -std::expm1(-0.1 * re);                       // 1 - exp(-Re/10)
  const double slow = 1.0 - taken + 0.3314 * root * (taken / std::sqrt(re + 1e-300));
  const double fast = 0.0524 * root;
  return re < 40.0 ? slow : fast;
}

/* Saffman's lift (1965, J. Fluid Mech. 22, 385; corrigendum 1968, 31, 624) with Mei's factor, on one
   particle:

     F = S (U - v) x curl U,    S = 1.615 rho d^2 sqrt(nu/|curl U|) g

   which is rho V 3 C/(2 pi sqrt(Re_w)) with C = 6.46 g. curl U is the vorticity of the fluid; the
   spin of the particle does not enter. Returns S (kg) for diameter d (m), density (kg/m3),
   kinematic viscosity (m2/s), slip speed |U - v| (m/s) and vorticity |curl U| (1/s). It grows without
   bound as the vorticity goes to 0, slower than the cross product vanishes; 0 gives a finite number. */
inline double saffmanMei(double diameter, double density, double viscosity, double slipSpeed,
  double vorticity)
{
  const double perViscosity = diameter / viscosity;
  return 1.615 * density * diameter * diameter * std::sqrt(viscosity / (vorticity + 1e-100))
    * meiFactor(slipSpeed * perViscosity, vorticity * diameter * perViscosity);
}

}
}

#endif
