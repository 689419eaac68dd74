/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A plugin with the right stamp that calls a function which this host does not have. */

#include "exampleplugin.cpp"

namespace LAMMPS_NS { void function_of_another_host(); }

static void call()
{
  function_of_another_host();
}

void (*unresolvedplugin_call)() = &call;
