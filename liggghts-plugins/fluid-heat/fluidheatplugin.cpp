/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/liggghtsplugin.h"

#include "fix_fluid_heat.h"

using namespace LAMMPS_NS;

static Fix *fluid_heat(LAMMPS *lmp, int narg, char **arg)
{
  return new FixFluidHeat(lmp, narg, arg);
}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "fluid/heat", "heat between a fluid and the grains, coupled or in a uniform flow",
     "The Grainjet developers", reinterpret_cast<void (*)()>(fluid_heat)}
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};
  return &description;
}
