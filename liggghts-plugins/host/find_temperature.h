/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_FIND_TEMPERATURE_H
#define GRAINJET_FIND_TEMPERATURE_H

#include "fix_property_atom.h"
#include "modify.h"

#include <cstring>

namespace grainjet {

/* The temperature of grains (K): the stock property Temp, which fix heat/gran, fix fluid/heat or a script's own fix
   property/atom makes; NULL without. Modify::find_fix_property fails where a fix is just being replaced. */
inline LAMMPS_NS::FixPropertyAtom *find_temperature(const LAMMPS_NS::Modify *modify, const char *caller)
{
  using LAMMPS_NS::FixPropertyAtom;
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    FixPropertyAtom *property = dynamic_cast<FixPropertyAtom *>(modify->fix[ifix]);
    if (property && property->check_fix("Temp", "scalar", 0, 0, caller, false)) return property;
  }
  return NULL;
}

}

#endif
