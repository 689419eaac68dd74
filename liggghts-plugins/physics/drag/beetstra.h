/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_BEETSTRA_H
#define GRAINJET_DRAG_BEETSTRA_H

#include "physics/drag/drag_state.h"
#include "physics/drag/power.h"
#include <cmath>

namespace grainjet {
namespace drag {

/* Beetstra, van der Hoef & Kuipers (2007), AIChE J. 53, 489, monodisperse form. The drag
   in units of Stokes' at the superficial slip velocity is, with phi = 1 - eps,

     F = 10 phi/eps^2 + eps^2 (1 + 1.5 sqrt(phi))
       + 0.413 Re / (24 eps^2)
         (1/eps + 3 eps phi + 8.4 Re^-0.343) / (1 + 10^(3 phi) Re^-(1/2 + 2 phi))

   with Re = eps |ur| d / nu, and beta/(1-eps) = 18 mu eps / d^2 F. The fraction is
   expanded by Re^(1/2 + 2 phi), so that it holds at Re = 0 as well. Continuous.     */
inline double beetstra(const State &s)
{
  const double eps = s.voidFraction, phi = solidFraction(s), re = reynolds(s);
  const double growth = power(re, 0.5 + 2.0 * phi);
  const double inertia = 0.413 / (24.0 * eps * eps) * growth
    * (re * (1.0 / eps + 3.0 * eps * phi) + 8.4 * power(re, 0.657))
    / (growth + power(10.0, 3.0 * phi));
  const double creeping =
    10.0 * phi / (eps * eps) + eps * eps * (1.0 + 1.5 * std::sqrt(phi));
  return 18.0 * s.density * s.viscosity * eps / (s.diameter * s.diameter)
    * (creeping + inertia);
}

}
}

#endif
