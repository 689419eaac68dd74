/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/liggghtsplugin.h"

#include "fix_exchange_probe.h"

using namespace LAMMPS_NS;

static Fix *exchange_probe(LAMMPS *lmp, int narg, char **arg)
{
  return new FixExchangeProbe(lmp, narg, arg);
}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "exchange/probe", "plays the coupling for tests of fix fluid/force",
     "The Grainjet developers", reinterpret_cast<void (*)()>(exchange_probe)}
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};
  return &description;
}
