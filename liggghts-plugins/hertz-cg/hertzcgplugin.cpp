/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* hertzcgplugin.so: enters `fix hertz/cg` and the command `coarsegraining` */

#include "hertz-cg/coarsegraining.h"
#include "hertz-cg/fix_hertz_cg.h"
#include "loader/liggghtsplugin.h"

using namespace LAMMPS_NS;

static Fix *create_fix(LAMMPS *lmp, int narg, char **arg)
{
  return new FixHertzCg(lmp, narg, arg);
}

static void run_command(LAMMPS *lmp, int narg, char **arg)
{
  CoarseGrainingCommand(lmp).command(narg, arg);
}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "hertz/cg", "Hertz-Mindlin contact of coarse-grained particles, in place of pair_style gran",
     "The Grainjet developers", reinterpret_cast<void (*)()>(&create_fix)},
    {"command", "coarsegraining", "factor f_cg by which grains are larger than the particles they stand for",
     "The Grainjet developers", reinterpret_cast<void (*)()>(&run_command)},
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 2, styles};
  return &description;
}
