/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A plugin that brings a free name and one that LIGGGHTS has itself. */

#include "loader/liggghtsplugin.h"

#include "fix_plugin_example.h"

using namespace LAMMPS_NS;

static Fix *create(LAMMPS *lmp, int narg, char **arg)
{
  return new FixPluginExample(lmp, narg, arg);
}

static const liggghtsplugin_style styles[] = {
  {"fix", "plugin/conflict", "never entered", "Grainjet developers", (void (*)()) &create},
  {"fix", "nve/sphere", "taken", "Grainjet developers", (void (*)()) &create},
};

static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 2, styles};

const liggghtsplugin_description *liggghtsplugin_init()
{
  return &description;
}
