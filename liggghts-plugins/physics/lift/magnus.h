/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_LIFT_MAGNUS_H
#define GRAINJET_LIFT_MAGNUS_H

#include "physics/drag/power.h"

#include <algorithm>
#include <cmath>

namespace grainjet {
namespace lift {

/* Lift of a spinning sphere over that of Rubinow & Keller (1961), C = C_L Re/Re_W with
   C_L = F/(pi/8 rho d^2 |U - v|^2), Re = |U - v| d/nu, Re_W = |W| d^2/nu. The smaller of

     0.45 q + (1 - 0.45 q) exp(-0.05684 Re_W^0.4 Re^0.3),    q = Re/Re_W

   (Oesterle & Bui Dinh 1998, Exp. Fluids 25, 16: measured for 10 < Re < 140 and |W| d/(2 |U - v|) of 1
   to 6; the lift is bounded for a fast spin) and

     1                             Re < 1
     0.178 + 0.822 Re^-0.522       above

   (Lun & Liu 1997, Int. J. Multiphase Flow 23, 575, up to Re = 1000, where it is 0.20, as Tsuji
   et al. 1985 measured for |W| d/(2 |U - v|) < 0.7). The first, used below its range of spins, would exceed
   Rubinow & Keller and have no bound. Continuous; 1 at Re = 0.                                 */
inline double spinLiftFactor(double re, double spinRe)
{
  const double logRe = drag::safeLog(re);
  const double taken = -std::expm1(-0.05684 * std::exp(0.4 * drag::safeLog(spinRe) + 0.3 * logRe));
  const double fastSpin = 1.0 - taken + 0.45 * re * (taken / (spinRe + 1e-30));
  const double slowSpin = 0.178 + 0.822 * std::exp(-0.522 * logRe);
  return std::min(fastSpin, re < 1.0 ? 1.0 : slowSpin);
}

/* Magnus' lift on one particle (Rubinow & Keller 1961, J. Fluid Mech. 11, 447),

     F = M W x (U - v),    M = pi/8 rho d^3 C,    W = 1/2 curl U - w

   w the spin of the particle. Returns M (kg) for diameter d (m), density (kg/m3), kinematic
   viscosity (m2/s), slip speed |U - v| (m/s) and relative spin |W| (rad/s).                     */
inline double magnus(double diameter, double density, double viscosity, double slipSpeed,
  double spin)
{
  const double perViscosity = diameter / viscosity, eighthOfPi = 0.39269908169872414;
  return eighthOfPi * density * diameter * diameter * diameter
    * spinLiftFactor(slipSpeed * perViscosity, spin * diameter * perViscosity);
}

}
}

#endif
