/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_ERGUN_H
#define GRAINJET_DRAG_ERGUN_H

#include "physics/drag/drag_state.h"

namespace grainjet {
namespace drag {

/* Ergun (1952), Chem. Eng. Prog. 48, 89: packed bed of spheres,

     beta/(1-eps) = 150 mu (1-eps) / (eps d^2) + 1.75 rho |ur| / d

   (paper Eq. 21 with sphericity 1). Meant for eps <= 0.8: at eps = 1 it does not tend to
   the drag of a lone sphere.                                                        */
inline double ergun(const State &s)
{
  return 150.0 * s.density * s.viscosity * solidFraction(s)
      / (s.voidFraction * s.diameter * s.diameter)
    + 1.75 * s.density * s.slipSpeed / s.diameter;
}

}
}

#endif
