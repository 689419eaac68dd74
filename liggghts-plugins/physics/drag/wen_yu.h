/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_WEN_YU_H
#define GRAINJET_DRAG_WEN_YU_H

#include "physics/drag/drag_state.h"
#include "physics/drag/sphere_drag.h"

namespace grainjet {
namespace drag {

/* Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100: the lone sphere's drag at the
   superficial slip velocity, times the voidage function,

     beta/(1-eps) = 3/4 rho eps Cd |ur| / d  eps^-2.65,   Re = eps |ur| d / nu

   (paper Eqs. 19, 20; the branch Cd = 0.44 for Re >= 1000, which they leave out, is
   included). Jumps by +0.4 % at Re = 1000, as Cd does.                              */
inline double wenYu(const State &s)
{
  return sphereDrag(s, reynolds(s)) * power(s.voidFraction, -2.65);
}

}
}

#endif
