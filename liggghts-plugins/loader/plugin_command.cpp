/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/plugin_command.h"

#include "loader/plugin_loader.h"

#include <liggghts/lammps.h>
#include <liggghts/error.h>

#include <string>

using namespace LAMMPS_NS;

static void run_plugin_command(LAMMPS *lmp, int narg, char **arg)
{
  grainjet::PluginLoader &loader = grainjet::PluginLoader::instance();
  const std::string action = narg ? arg[0] : "";

  if (action == "load" && narg == 2) loader.load(lmp, arg[1]);
  else if (action == "list" && narg == 1) loader.list(lmp);
  else if (action == "clear" && narg == 1) loader.clear(lmp);
  else {
    std::string line = "plugin";
    for (int i = 0; i < narg; i++) line += std::string(" ") + arg[i];
    lmp->error->all(FLERR, ("Illegal plugin command '" + line +
      "': use plugin load <file>, plugin list or plugin clear").c_str());
  }
}

const liggghtsplugin_style grainjet::plugin_command = {
  "command", "plugin", "load styles from files", "Grainjet developers",
  reinterpret_cast<void (*)()>(&run_plugin_command)
};
