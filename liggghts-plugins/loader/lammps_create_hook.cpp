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

#include "loader/host_build.h"
#include "loader/host_function.h"
#include "loader/plugin_command.h"
#include "loader/plugin_file.h"
#include "loader/plugin_loader.h"
#include "loader/style_maps.h"

#include <liggghts/lammps.h>
#include <liggghts/error.h>

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

#include <string>

using namespace LAMMPS_NS;

namespace {

typedef void (*Create)(LAMMPS *);

// A loader that is here already (preloaded and part of a coupling library) does it all,
// but the coupling relies on what its own version of it refuses
void check_other_loader(LAMMPS *lmp)
{
  using namespace grainjet;
  const std::string file = style_maps::file(lmp, plugin_command);
  const std::string version = plugin_file::version(file);
  if (version == GRAINJET_VERSION) return;

  const std::string why = "Two plugin loaders are in this process: " + file + " of " +
    (version.empty() ? std::string("an earlier Grainjet (it states no version)") : "Grainjet " + version) +
    " and " + plugin_file::loader() + " of Grainjet " GRAINJET_VERSION ". Let LD_PRELOAD, "
    "LD_LIBRARY_PATH and FOAM_USER_LIBBIN lead to one of them only, or " GRAINJET_ANEW;
  lmp->error->all(FLERR, why.c_str());
}

// Ranks that the mpirun of another MPI has started are one rank each, and do all the same. The
// variable is how that mpirun tells its own MPI how many there are
std::string other_mpirun()
{
#ifdef OPEN_MPI
  const char *variable = "PMI_SIZE", *ours = "Open MPI";
#else
  const char *variable = "OMPI_COMM_WORLD_SIZE", *ours = "MPICH";
#endif
  int ranks;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const char *told = getenv(variable);
  if (ranks > 1 || !told || atoi(told) < 2) return "";
  return "The mpirun of another MPI has started " + std::string(told) + " ranks, but LIGGGHTS uses " + ours +
    ", to which each is alone: all would do the same and write the same files. Use the mpirun of " + ours +
    "; if this is one rank among other programs, unset " + variable;
}

}

/* ---------------------------------------------------------------------- */

void LAMMPS::create()
{
  // Before the host's tables are touched: the layout of its classes must be the known one. Ranks
  // on other machines may have another LIGGGHTS
  const std::string misfit = grainjet::host_build::misfit(LIGGGHTSPLUGIN_HOST);
  grainjet::plugin_file::agree(this, misfit.empty() ? "" : "The plugin loader " + misfit);
  grainjet::plugin_file::agree(this, other_mpirun());

  // as in preload_once.cpp, for another screen than the launcher's and other programs
  if (screen) setvbuf(screen, NULL, _IOLBF, 0);

  static const Create create_host =
    reinterpret_cast<Create>(grainjet::host_function("_ZN9LAMMPS_NS6LAMMPS6createEv"));
  create_host(this);

  using grainjet::style_maps::Entry;
  if (grainjet::style_maps::find(this, grainjet::plugin_command) == Entry::OTHER)
    return check_other_loader(this);

  grainjet::style_maps::enter(this, grainjet::plugin_command);
  grainjet::PluginLoader::instance().restore(this);
}
