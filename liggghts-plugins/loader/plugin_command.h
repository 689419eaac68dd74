/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_PLUGIN_COMMAND_H
#define GRAINJET_PLUGIN_COMMAND_H

#include "loader/liggghtsplugin.h"

/* The `plugin` command of an input script:

     plugin load <file>      load a plugin file and enter its styles
     plugin list             print what is loaded
     plugin clear            forget all plugins; error if a fix of theirs is defined
   Any other word, and a missing or surplus one, is an error on all ranks.     */

namespace grainjet {

  // the command as an entry for the table of commands
  extern const liggghtsplugin_style plugin_command;

}

#endif
