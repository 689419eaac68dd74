/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(plugin/example,FixPluginExample)

#else

#ifndef LMP_FIX_PLUGIN_EXAMPLE_H
#define LMP_FIX_PLUGIN_EXAMPLE_H

#include "fix.h"

namespace LAMMPS_NS {

/* fix ID group plugin/example <start>

   The smallest fix that shows whether it works: a scalar (f_ID) that begins at <start>
   and grows by one each time step, and goes on from there after a restart.      */

class FixPluginExample : public Fix {
 public:
  FixPluginExample(class LAMMPS *, int, char **);
  int setmask() override;
  void end_of_step() override;
  double compute_scalar() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  double count;
};

}

#endif
#endif
