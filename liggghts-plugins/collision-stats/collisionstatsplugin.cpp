/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* collisionstatsplugin.so: enters `fix collision/stats` */

#include "collision-stats/fix_collision_stats.h"
#include "loader/liggghtsplugin.h"

using namespace LAMMPS_NS;

static Fix *collision_stats(LAMMPS *lmp, int narg, char **arg)
{
  return new FixCollisionStats(lmp, narg, arg);
}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "collision/stats", "statistics of the collisions between grains",
     "The Grainjet developers", reinterpret_cast<void (*)()>(collision_stats)}
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};
  return &description;
}
