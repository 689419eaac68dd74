/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef LMP_COLLISION_PLACE_H
#define LMP_COLLISION_PLACE_H

#include "collision-stats/collision_statistics.h"

#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

/* Where collisions and grains are looked at: everywhere or in a region of the script, as a whole and in slabs. */
class CollisionPlace : protected Pointers {
 public:

  // region: its ID, empty for everywhere
  CollisionPlace(class LAMMPS *, const std::string &region, const grainjet::AxisBins &);

  // Looks the region up. Empty, or what is wrong
  std::string attach();

  // A region that moves or changes is put where it is in this step. On all ranks
  void update();

  // Is this point inside? A point beyond a periodic boundary is brought back into the box first
  bool holds(double *x) const;

  // m3, of the whole and of each slab, within the box. On all ranks. The volume of a region is that of the cells
  // of a fine grid about it, of which a random point each lies in it; exact for a block
  const std::vector<double> &volumes();

  // Style and extent at rest, as attach() has found them; empty for everywhere
  const std::string &shape() const { return shape_; }

 private:

  std::string id_, shape_;
  grainjet::AxisBins bins_;
  class Region *region_;        // NULL: everywhere
  bool changes_;
  std::vector<double> volumes_;
  double box_[6];               // of these volumes

  double volume(double from, double to, int layers);
  double inside(const std::vector<class Region *> &parts, const double *low, const double *high, const int *n) const;
};

}

#endif
