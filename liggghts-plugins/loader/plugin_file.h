/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_PLUGIN_FILE_H
#define GRAINJET_PLUGIN_FILE_H

#include "loader/liggghtsplugin.h"

#include <string>

namespace LAMMPS_NS { class LAMMPS; }

/* Finding and opening a plugin file.

   Both find() and open() are collective over the ranks of `world`. Rank 0 searches and all
   ranks open the very file it found, so that different folders on different ranks
   cannot mix two builds of a plugin. If any rank fails, all ranks end with the same
   message through error->all().                                                */

namespace grainjet {
namespace plugin_file {

  // Absolute path of the file meant by `name`. A name with a slash is taken as it is;
  // another one is looked for in the working folder, in the folders of
  // LIGGGHTS_PLUGIN_PATH (separated by colons) and beside the loader.
  std::string find(LAMMPS_NS::LAMMPS *, const std::string &name);

  // Open the file and ask it for its styles. Refused are files that are no shared
  // library or are cut short, that lack the entry point, or that were built with another
  // Grainjet or for another build of LIGGGHTS.
  // The file stays mapped to the end of the process, since fixes made by it may
  // outlive its entry in the style tables.
  const liggghtsplugin_description *open(LAMMPS_NS::LAMMPS *, const std::string &path);

  // End with this message on all ranks if it is not empty on one of them; the lowest such
  // rank is heard. Collective over `world`
  void agree(LAMMPS_NS::LAMMPS *, std::string why);

  // version of Grainjet that a library which is loaded already was built with; empty if
  // it states none
  std::string version(const std::string &path);

  // the library that this loader is a part of
  std::string loader();

}
}

#endif
