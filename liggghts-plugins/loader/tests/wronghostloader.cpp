/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* The preloaded loader as it would come from a build against another LIGGGHTS. */

#include "loader/liggghtsplugin.h"

#undef LIGGGHTSPLUGIN_HOST
#define LIGGGHTSPLUGIN_HOST "LIGGGHTS-PUBLIC 2.0.0, SMALLBIG OpenMPI, build 0"

#include "couplinglibrary.cpp"
