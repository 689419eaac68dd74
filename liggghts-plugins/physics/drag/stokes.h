/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_STOKES_H
#define GRAINJET_DRAG_STOKES_H

#include "physics/drag/drag_state.h"

namespace grainjet {
namespace drag {

/* Stokes (1851): a lone sphere in creeping flow, F = 3 pi mu d ur. The void fraction does
   not enter. Valid for Re << 1; exact there, and what the others tend to in that limit. */
inline double stokes(const State &s)
{
  return 18.0 * s.density * s.viscosity / (s.diameter * s.diameter);
}

}
}

#endif
