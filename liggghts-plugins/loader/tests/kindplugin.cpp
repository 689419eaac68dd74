/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A plugin with a kind of style that the loader does not know. */

#include "loader/liggghtsplugin.h"

static void create() {}

static const liggghtsplugin_style styles[] = {
  {"pair", "plugin/pair", "of unknown kind", "Grainjet developers", &create},
};

static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};

const liggghtsplugin_description *liggghtsplugin_init()
{
  return &description;
}
