/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/liggghtsplugin.h"

#include "fix_wall_roughness.h"

using namespace LAMMPS_NS;

static Fix *wall_roughness(LAMMPS *lmp, int narg, char **arg)
{
  return new FixWallRoughness(lmp, narg, arg);
}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "wall/roughness", "facets of a rough wall, met at random",
     "The Grainjet developers", reinterpret_cast<void (*)()>(wall_roughness)}
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};
  return &description;
}
