/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_STYLE_MAPS_H
#define GRAINJET_STYLE_MAPS_H

#include "loader/liggghtsplugin.h"

#include <string>

namespace LAMMPS_NS { class LAMMPS; }

/* The tables in which one LIGGGHTS instance looks up its styles by name.

   They are private members of the host's classes Modify (fixes) and Input
   (commands) and are reached through explicit template instantiation, where
   the language does not check access; no source of the host is touched.
   A `clear` command makes a new Modify, so entries have to be made again then.  */

namespace grainjet {
namespace style_maps {

  // how a name stands to a creator that a plugin brings for it
  enum class Entry { FREE, SAME, OTHER, UNKNOWN_KIND };

  Entry find(LAMMPS_NS::LAMMPS *, const liggghtsplugin_style &);

  // enter the creator under its name; the kind must be a known one
  void enter(LAMMPS_NS::LAMMPS *, const liggghtsplugin_style &);

  // take the name out again if it stands for this creator
  void remove(LAMMPS_NS::LAMMPS *, const liggghtsplugin_style &);

  // ID of a fix of this style that is now defined, empty if there is none
  // (commands end at once and so are never in use)
  std::string user(LAMMPS_NS::LAMMPS *, const liggghtsplugin_style &);

  // library file whose creator stands under the name now, empty if it is in no file
  std::string file(LAMMPS_NS::LAMMPS *, const liggghtsplugin_style &);

}
}

#endif
