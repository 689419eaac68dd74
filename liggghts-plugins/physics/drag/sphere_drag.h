/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_SPHERE_DRAG_H
#define GRAINJET_DRAG_SPHERE_DRAG_H

#include "physics/drag/drag_state.h"
#include "physics/drag/power.h"

namespace grainjet {
namespace drag {

/* Drag per volume and slip velocity of one sphere, 3/4 rho Cd |u| / d, at the Reynolds
   number re = |u| d / nu:

     Cd = 24/re (1 + 0.15 re^0.687)   re < 1000       (Schiller & Naumann 1935)
        = 0.44                        re >= 1000      (Newton's range)

   Written as Stokes drag times Cd re / 24, which needs no division by re. At re = 1000
   Cd jumps from 0.4383 to 0.44, +0.4 %.                                            */
inline double sphereDrag(const State &s, double re)
{
  const double schillerNaumann = 1.0 + 0.15 * power(re, 0.687);
  const double newton = (0.44 / 24.0) * re;
  return 18.0 * s.density * s.viscosity / (s.diameter * s.diameter)
    * (re < 1000.0 ? schillerNaumann : newton);
}

}
}

#endif
