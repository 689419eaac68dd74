/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/liggghtsplugin.h"

#include "fix_surface_stats.h"

using namespace LAMMPS_NS;

static Fix *surface_stats(LAMMPS *lmp, int narg, char **arg)
{
  return new FixSurfaceStats(lmp, narg, arg);
}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "surface/stats", "what meshes suffer from the collisions of grains, by triangle",
     "The Grainjet developers", reinterpret_cast<void (*)()>(surface_stats)}
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};
  return &description;
}
