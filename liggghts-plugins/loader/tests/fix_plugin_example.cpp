/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_plugin_example.h"

#include "comm.h"
#include "error.h"

#include <stdlib.h>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixPluginExample::FixPluginExample(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  if (narg != 4) error->fix_error(FLERR, this, "expected: fix ID group plugin/example <start>");
  count = atof(arg[3]);
  nevery = 1;
  scalar_flag = 1;
  global_freq = 1;
  restart_global = 1;
}

/* ---------------------------------------------------------------------- */

int FixPluginExample::setmask()
{
  return END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixPluginExample::end_of_step()
{
  count += 1.0;
}

/* ---------------------------------------------------------------------- */

double FixPluginExample::compute_scalar()
{
  return count;
}

/* ---------------------------------------------------------------------- */

void FixPluginExample::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const int size = sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&count, sizeof(double), 1, fp);
}

/* ---------------------------------------------------------------------- */

void FixPluginExample::restart(char *buf)
{
  count = *reinterpret_cast<double *>(buf);
}
