/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A plugin whose fix warns: fix ID group plugin/warn <rank> <every> <words>
   On that rank (-1: on all, by the function for that) every so many steps, and at the end of the
   run (step 0 in its words, so that it is told from the others by nothing but a number).    */

#include "loader/liggghtsplugin.h"

#include "comm.h"
#include "error.h"
#include "fix.h"
#include "update.h"

#include <stdlib.h>

#include <string>

using namespace LAMMPS_NS;

namespace {

class FixPluginWarn : public Fix {
 public:
  FixPluginWarn(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
  {
    if (narg != 6) error->fix_error(FLERR, this, "expected: fix ID group plugin/warn <rank> <every> <words>");
    rank = atoi(arg[3]);
    nevery = atoi(arg[4]);
    words = arg[5];
  }

  int setmask() override { return FixConst::END_OF_STEP; }
  void end_of_step() override { warn(update->ntimestep); }
  void post_run() override { warn(0); }

 private:
  int rank;
  std::string words;

  void warn(bigint step)
  {
    const std::string text = words + " at step " + std::to_string(step);
    if (rank < 0) error->warningAll(FLERR, text.c_str());
    else if (rank == comm->me) error->warning(FLERR, text.c_str());
  }
};

Fix *plugin_warn(LAMMPS *lmp, int narg, char **arg)
{
  return new FixPluginWarn(lmp, narg, arg);
}

const liggghtsplugin_style styles[] = {
  {"fix", "plugin/warn", "warns", "Grainjet developers", (void (*)()) &plugin_warn},
};

const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};

}

const liggghtsplugin_description *liggghtsplugin_init()
{
  return &description;
}
