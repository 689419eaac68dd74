/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/liggghtsplugin.h"

#include "fix_fluid_force.h"

using namespace LAMMPS_NS;

static Fix *fluid_force(LAMMPS *lmp, int narg, char **arg)
{
  return new FixFluidForce(lmp, narg, arg);
}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "fluid/force", "drag and other forces of a fluid, coupled or in a uniform flow",
     "The Grainjet developers", reinterpret_cast<void (*)()>(fluid_force)}
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};
  return &description;
}
