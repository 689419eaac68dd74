/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A coupling library that holds the loader of another version of Grainjet. */

#include "host/grainjet_version.h"

#undef GRAINJET_VERSION
#define GRAINJET_VERSION "0.0.9"

#include "couplinglibrary.cpp"
