/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "wall_forces.h"

#include "fix_property_atom.h"
#include "modify.h"

#include <cstring>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

std::string WallForces::attach()
{
  const int ifix = modify->find_fix(wallID_.c_str());
  if (ifix < 0 || strncmp(modify->fix[ifix]->style, "wall/gran", 9) != 0)
    return "wall '" + wallID_ + "' is not the ID of a fix wall/gran defined before";

  const std::string name = "force_" + wallID_;
  property_ = static_cast<FixPropertyAtom *>(modify->find_fix_property(
    name.c_str(), "property/atom", "vector", 3, 0, "wall/gran", false));
  if (!property_) return "fix wall/gran '" + wallID_ + "' needs the keywords store_force yes";
  return "";
}

/* ---------------------------------------------------------------------- */

double **WallForces::forces() const
{
  return property_->array_atom;
}
