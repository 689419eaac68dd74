/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_GIDASPOW_H
#define GRAINJET_DRAG_GIDASPOW_H

#include "physics/drag/drag_state.h"
#include "physics/drag/ergun.h"
#include "physics/drag/wen_yu.h"

namespace grainjet {
namespace drag {

/* Gidaspow (1994), Multiphase Flow and Fluidization: Wen & Yu where eps > 0.8, Ergun
   elsewhere (paper Eqs. 18 - 21). Discontinuous at eps = 0.8 by definition: by how much
   depends on Re (docs/theory-drag.md has a table).                                  */
inline double gidaspow(const State &s)
{
  const double dilute = wenYu(s), dense = ergun(s);
  return s.voidFraction > 0.8 ? dilute : dense;
}

}
}

#endif
