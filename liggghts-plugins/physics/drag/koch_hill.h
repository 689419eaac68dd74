/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_KOCH_HILL_H
#define GRAINJET_DRAG_KOCH_HILL_H

#include "physics/drag/drag_state.h"
#include "physics/drag/power.h"
#include <cmath>

namespace grainjet {
namespace drag {

/* Koch & Hill (2001), Annu. Rev. Fluid Mech. 33, 619, from the lattice-Boltzmann runs of
   Hill, Koch & Ladd (2001), J. Fluid Mech. 448, 213 and 243. In the form common to
   CFD-DEM (van Buijtenen et al. 2011, Chem. Eng. Sci. 66, 2368), phi = 1 - eps:

     beta/(1-eps) = 18 mu eps^2 / d^2 (F0 + F3 Re / 2),   Re = eps |ur| d / nu
     F0 = (1 + 3 sqrt(phi/2) + 135/64 phi ln phi + 16.14 phi)
          / (1 + 0.681 phi - 8.48 phi^2 + 8.16 phi^3)     phi < 0.4
        = 10 phi / eps^3                                  phi >= 0.4
     F3 = 0.0673 + 0.212 phi + 0.0232 / eps^5

   The half comes from their Re being built with the radius. Their separate fit for
   Re so small that inertia enters as Re^2 is not part of this form. At phi = 0.4, F0
   jumps from 18.33 to 18.52, +1.0 %.                                               */
inline double kochHill(const State &s)
{
  const double eps = s.voidFraction, phi = solidFraction(s);
  const double dense = 10.0 * phi / (eps * eps * eps);
  const double dilute =
    (1.0 + 3.0 * std::sqrt(0.5 * phi) + (135.0 / 64.0) * phi * safeLog(phi) + 16.14 * phi)
    / (1.0 + phi * (0.681 + phi * (-8.48 + phi * 8.16)));    // the divisor is at least 0.1
  const double f0 = phi < 0.4 ? dilute : dense;
  const double f3 = 0.0673 + 0.212 * phi + 0.0232 / (eps * eps * eps * eps * eps);
  return 18.0 * s.density * s.viscosity * eps * eps / (s.diameter * s.diameter)
    * (f0 + 0.5 * f3 * reynolds(s));
}

}
}

#endif
