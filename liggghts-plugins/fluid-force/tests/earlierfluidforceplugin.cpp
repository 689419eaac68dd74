/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix fluid/force as an earlier Grainjet had it: an exchange whose version cannot be asked for. It
   passes the loader, as it would if it were compiled into LIGGGHTS itself. */

#include "loader/liggghtsplugin.h"

#include "fix.h"

#include <cstring>

using namespace LAMMPS_NS;

namespace {

class EarlierFluidForce : public Fix {
 public:
  EarlierFluidForce(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg) {}
  int setmask() override { return 0; }
  void *extract(const char *what, int &dim) override
  {
    dim = 0;
    return strcmp(what, "fluid_force_exchange") == 0 ? exchange_ : nullptr;
  }

 private:
  double exchange_[4] = {};
};

Fix *fluid_force(LAMMPS *lmp, int narg, char **arg)
{
  return new EarlierFluidForce(lmp, narg, arg);
}

}

extern "C" const liggghtsplugin_description *liggghtsplugin_init()
{
  static const liggghtsplugin_style styles[] = {
    {"fix", "fluid/force", "an exchange without a version", "The Grainjet developers",
     reinterpret_cast<void (*)()>(fluid_force)}
  };
  static const liggghtsplugin_description description = {LIGGGHTSPLUGIN_HOST, 1, styles};
  return &description;
}
