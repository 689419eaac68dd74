/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A plugin that needs a further library, found through LD_LIBRARY_PATH or not. */

#include "exampleplugin.cpp"

extern "C" int neededlibrary_answer();

int needslibraryplugin_answer = neededlibrary_answer();
