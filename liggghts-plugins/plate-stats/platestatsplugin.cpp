/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/liggghtsplugin.h"

#include "fix_plate_stats.h"

using namespace LAMMPS_NS;

static Fix *plate_stats(LAMMPS *lmp, int narg, char **arg)
{
  return new FixPlateStats(lmp, narg, arg);
}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "plate/stats", "statistics of the collisions of grains with a plate",
     "The Grainjet developers", reinterpret_cast<void (*)()>(plate_stats)}
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};
  return &description;
}
