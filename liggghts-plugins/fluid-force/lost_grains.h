/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_LOST_GRAINS_H
#define GRAINJET_LOST_GRAINS_H

#include "fluid_force_exchange.h"

#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

/* Grains that LIGGGHTS is about to delete on this rank, kept for the momentum and number
   balance of a coupling: those beyond a fixed ('f') boundary, which the exchange between
   ranks drops, and those marked by a fix massflow/mesh with delete_atoms yes.        */
class LostGrains : protected Pointers {
 public:

  explicit LostGrains(class LAMMPS *);

  // Moves fix `ifix` to the front of the list of pre_exchange fixes, so that it sees the
  // grains before another fix deletes them. To be called in init() of that fix.
  void act_first(int ifix);

  // Books leaving grains, also those out of the group, which a coupling counts too:
  // those beyond the boundary, which every exchange between ranks drops, and those marked by
  // a fix massflow/mesh, which goes on holding them until the next step that rebuilds
  // lists (so not in a set-up). halfKick: time (s) during which they have felt the fluid
  // force since their impulse was last updated.
  void collect_outside(const FluidForceExchange &, double halfKick);
  void collect_marked(const FluidForceExchange &, double halfKick);

  void clear() { grains_.clear(); }
  const std::vector<FluidForceExchange::Lost> &grains() const { return grains_; }

 private:

  std::vector<FluidForceExchange::Lost> grains_;

  bool outside(const double *) const;
  void record(int, const FluidForceExchange &, double halfKick);
};

}

#endif
