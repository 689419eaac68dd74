/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WALL_FORCES_H
#define GRAINJET_WALL_FORCES_H

#include "pointers.h"

#include <string>

namespace LAMMPS_NS {

/* The forces that a fix wall/gran with store_force yes has put on the grains. Found by
   name only (LIGGGHTS keeps them in the property force_<ID>), so that primitive and mesh
   walls and all contact models serve alike.                                          */
class WallForces : protected Pointers {
 public:

  WallForces(class LAMMPS *lmp, const std::string &wallID)
    : Pointers(lmp), wallID_(wallID), property_(NULL) {}

  // Finds them: returns an empty string or what is wrong. To be called at the start of
  // every run, since the wall may have been defined anew.
  std::string attach();

  // force on each grain (N), [nlocal][3], of the latest force computation
  double **forces() const;

 private:

  std::string wallID_;
  class FixPropertyAtom *property_;
};

}

#endif
