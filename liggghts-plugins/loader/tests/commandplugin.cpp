/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A plugin with a command and without the texts that `plugin list` shows. */

#include "loader/liggghtsplugin.h"

#include "lammps.h"
#include "comm.h"

#include <stdio.h>

using namespace LAMMPS_NS;

static void say(LAMMPS *lmp, int narg, char **arg)
{
  if (lmp->comm->me == 0 && lmp->screen && narg == 1) fprintf(lmp->screen, "The plugin says: %s\n", arg[0]);
}

static const liggghtsplugin_style styles[] = {
  {"command", "plugin_say", 0, 0, (void (*)()) &say},
};

static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};

const liggghtsplugin_description *liggghtsplugin_init()
{
  return &description;
}
