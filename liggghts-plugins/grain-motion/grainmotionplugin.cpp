/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/liggghtsplugin.h"

#include "fix_grain_motion.h"

using namespace LAMMPS_NS;

static Fix *grain_motion(LAMMPS *lmp, int narg, char **arg)
{
  return new FixGrainMotion(lmp, narg, arg);
}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "grain/motion", "moves grains as nve/sphere, with gravity and a fluid in one pass",
     "The Grainjet developers", reinterpret_cast<void (*)()>(grain_motion)}
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};
  return &description;
}
