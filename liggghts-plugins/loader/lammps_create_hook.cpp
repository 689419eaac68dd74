/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* How the `plugin` command gets into LIGGGHTS, and styles stay in it.

   LAMMPS::create() makes the classes that hold the style tables. The constructor
   calls it, and so does the `clear` command, both through the dynamic linker. The
   function below has the same name and comes first in the linker's search order:
   by LD_PRELOAD in the stock program (the launcher does that), or by lying in a
   library that depends on libliggghts. It runs the host's own function and then
   enters the command and the styles loaded so far.                             */

#include "loader/plugin_command.h"
#include "loader/plugin_loader.h"
#include "loader/style_maps.h"

#include <liggghts/lammps.h>
#include <liggghts/error.h>

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

#include <string>

using namespace LAMMPS_NS;

namespace {

typedef void (*Create)(LAMMPS *);

const char *const CREATE = "_ZN9LAMMPS_NS6LAMMPS6createEv";

// a function of the host that nobody interposes, to find the host's file by
const char *const LANDMARK = "_ZN9LAMMPS_NS6LAMMPS11post_createEv";

/* The host's own create(). Usually it is the next one in the search order. If this
   file is preloaded and LIGGGHTS comes later by dlopen (as in OpenFOAM), the next one
   is not visible from here, and the host's file is asked for it.               */

Create host_create()
{
  if (void *next = dlsym(RTLD_NEXT, CREATE)) return reinterpret_cast<Create>(next);

  Dl_info info;
  void *landmark = dlsym(RTLD_DEFAULT, LANDMARK);
  if (landmark && dladdr(landmark, &info))
    if (void *host = dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD))
      if (void *create = dlsym(host, CREATE)) return reinterpret_cast<Create>(create);

  fprintf(stderr, "ERROR: the plugin loader cannot find the LIGGGHTS library it was loaded into. "
          "Start LIGGGHTS with liggghts-plugins, without setting LD_PRELOAD yourself\n");
  abort();
}

}

/* ---------------------------------------------------------------------- */

void LAMMPS::create()
{
  // before anything of the host's classes is touched: their layout must be the known one
  const std::string host = grainjet::style_maps::host(this);
  if (host != LIGGGHTSPLUGIN_HOST)
    error->all(FLERR, ("The plugin loader was built for " LIGGGHTSPLUGIN_HOST ", but this is " + host +
      ". Build Grainjet again for this LIGGGHTS").c_str());

  static const Create create_host = host_create();
  create_host(this);

  // a loader that is here already (preloaded and part of a coupling library) does it all
  using grainjet::style_maps::Entry;
  if (grainjet::style_maps::find(this, grainjet::plugin_command) == Entry::OTHER) return;

  grainjet::style_maps::enter(this, grainjet::plugin_command);
  grainjet::PluginLoader::instance().restore(this);
}
