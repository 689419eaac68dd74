/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_REMOVED_GRAINS_H
#define GRAINJET_REMOVED_GRAINS_H

#include "fluid_force_exchange.h"

#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

/* Grains that LIGGGHTS is about to remove on this rank, kept for the momentum and number
   balance of a coupling: those that a fix massflow/mesh with delete_atoms yes has marked, and
   those beyond a fixed ('f') boundary, which the exchange between ranks drops. Grains out of
   the group of the fix are kept, too, since a coupling counts all.                    */
class RemovedGrains : protected Pointers {
 public:

  explicit RemovedGrains(class LAMMPS *);

  // Moves fix `ifix` to the front of the list of pre_exchange fixes, so that it sees the
  // grains before another fix deletes them. To be called in init() of that fix.
  void act_first(int ifix);

  // Books the grains that are removed now. deleting: fixes massflow/mesh delete theirs, too,
  // which they do in a step that makes lists but not in a set-up. halfKick: time (s) during
  // which grains have felt the fluid force since their impulse was last updated. nonReacting:
  // force (N) without reaction of the latest step, NULL if none. powerGrowth: force with reaction
  // times acceleration (W/s) of that step, NULL unless the work is asked for.
  void collect(const FluidForceExchange &, bool deleting, double halfKick,
    const double *const *nonReacting, const double *powerGrowth);

  void clear() { grains_.clear(); }
  const std::vector<FluidForceExchange::Removed> &grains() const { return grains_; }

 private:

  std::vector<FluidForceExchange::Removed> grains_;
  std::vector<char> marked_;    // per grain, while collecting
  const double *heat_, *temperature_;    // of a fix fluid/heat, per grain, while collecting; NULL without

  // The fixed faces of the box, through which grains are lost; other faces lie at infinity
  struct Box {
    double low[3], high[3];    // m
    bool open = false;         // is there such a face?

    explicit Box(const class Domain *);
    bool outside(const double *x) const
    {
      for (int dim = 0; dim < 3; dim++)
        if (x[dim] < low[dim] || x[dim] >= high[dim]) return true;
      return false;
    }
  };

  bool find_marked();    // are there any?
  void find_heat();
  void record(int, FluidForceExchange::Fate, const FluidForceExchange &, double halfKick,
    const double *nonReacting, const double *powerGrowth);
};

}

#endif
