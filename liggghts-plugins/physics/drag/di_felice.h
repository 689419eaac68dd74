/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_DI_FELICE_H
#define GRAINJET_DRAG_DI_FELICE_H

#include "physics/drag/drag_state.h"
#include "physics/drag/power.h"
#include <cmath>

namespace grainjet {
namespace drag {

/* Di Felice (1994), Int. J. Multiphase Flow 20, 153: the lone sphere's drag at the
   superficial slip velocity times eps^-chi,

     Cd  = (0.63 + 4.8 / sqrt(Re))^2                     (Dallavalle 1948)
     chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2 / 2),      Re = eps |ur| d / nu
     F   = pi/8 d^2 rho Cd (eps |ur|)^2 eps^-chi

   hence beta/(1-eps) = 3/4 mu/d^2 Cd Re eps^(1-chi), with Cd Re free of any division.
   Continuous everywhere. For Re -> 0 Dallavalle's Cd Re is 4.8^2 = 23.04, 4 % below
   Stokes' 24.                                                                       */
inline double diFelice(const State &s)
{
  const double re = reynolds(s);
  const double root = 0.63 * std::sqrt(re) + 4.8;
  const double perDecade = 0.43429448190325183;                   // 1/ln 10
  const double distance = 1.5 - perDecade * safeLog(re);          // chi = 3.7 at Re = 0
  const double chi = 3.7 - 0.65 * std::exp(-0.5 * distance * distance);
  return 0.75 * s.density * s.viscosity / (s.diameter * s.diameter)
    * root * root * power(s.voidFraction, 1.0 - chi);
}

}
}

#endif
