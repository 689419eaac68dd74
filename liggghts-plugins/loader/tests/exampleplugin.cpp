/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/liggghtsplugin.h"

#include "fix_plugin_example.h"

using namespace LAMMPS_NS;

static Fix *plugin_example(LAMMPS *lmp, int narg, char **arg)
{
  return new FixPluginExample(lmp, narg, arg);
}

static const liggghtsplugin_style styles[] = {
  {"fix", "plugin/example", "counts time steps", "Grainjet developers", (void (*)()) &plugin_example},
};

static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};

const liggghtsplugin_description *liggghtsplugin_init()
{
  return &description;
}
