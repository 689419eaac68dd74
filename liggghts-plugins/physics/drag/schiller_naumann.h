/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_SCHILLER_NAUMANN_H
#define GRAINJET_DRAG_SCHILLER_NAUMANN_H

#include "physics/drag/drag_state.h"
#include "physics/drag/sphere_drag.h"

namespace grainjet {
namespace drag {

/* Schiller & Naumann (1935), VDI Zeitung 77: a lone sphere up to the critical Reynolds
   number. The void fraction does not enter, so Re = |ur| d / nu here.                 */
inline double schillerNaumann(const State &s)
{
  const double re = s.slipSpeed * s.diameter / s.viscosity;
  return sphereDrag(s, re);
}

}
}

#endif
