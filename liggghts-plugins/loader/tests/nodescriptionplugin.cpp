/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A plugin whose entry point has nothing to tell. */

#include "loader/liggghtsplugin.h"

const liggghtsplugin_description *liggghtsplugin_init()
{
  return 0;
}
