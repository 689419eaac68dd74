/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_PLUGIN_LOADER_H
#define GRAINJET_PLUGIN_LOADER_H

#include "loader/liggghtsplugin.h"

#include <string>
#include <vector>

namespace LAMMPS_NS { class LAMMPS; }

namespace grainjet {

/* The plugins this process has loaded.

   One registry serves all LIGGGHTS instances of a process, since a library is
   mapped once per process; each instance has style tables of its own, and
   restore() enters all styles in those of a new or cleared instance.
   All functions are collective over the instance's `world`.                    */

class PluginLoader {
 public:
  static PluginLoader &instance();

  // Load a plugin file (see plugin_file.h for the search) and enter its styles.
  // Loading a file again is harmless. Error on all ranks if the file is refused or
  // a style name is taken by LIGGGHTS itself or by another plugin.
  void load(LAMMPS_NS::LAMMPS *, const std::string &name);

  // Print styles, files, what they do and who wrote them.
  void list(LAMMPS_NS::LAMMPS *) const;

  // Take all styles out of this instance and forget the plugins.
  // Error on all ranks if a fix of such a style is still defined.
  void clear(LAMMPS_NS::LAMMPS *);

  // Enter the styles of all loaded plugins in an instance's tables.
  void restore(LAMMPS_NS::LAMMPS *) const;

 private:
  struct Plugin {
    std::string path;
    const liggghtsplugin_description *description;
  };

  std::vector<Plugin> plugins;

  PluginLoader() = default;

  const Plugin *loaded(const std::string &path) const;
  std::string source_of(const liggghtsplugin_style &) const;
  void check(LAMMPS_NS::LAMMPS *, const Plugin &) const;
};

}

#endif
