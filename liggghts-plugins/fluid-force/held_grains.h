/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_HELD_GRAINS_H
#define GRAINJET_HELD_GRAINS_H

#include "pointers.h"

#include <cstring>
#include <vector>

namespace LAMMPS_NS {

/* Grains that a fix insert/stream still carries at constant velocity from the place of
   their insertion to its face. Until their release it sets their velocity and clears
   their force at the end of every step, so whatever a fluid gave them would be undone:
   they are given nothing.                                                           */
class HeldGrains : protected Pointers {
 public:

  HeldGrains(class LAMMPS *lmp) : Pointers(lmp), release_(NULL), stale_(true) {}

  // start of a run: looks for insert/stream
  void init();

  // indices have changed: to be called before every rebuild of the neighbour lists
  void reorder() { stale_ = true; }

  // Once per step, before holds(). first: the first step whose kick a released grain
  // feels, so the step at hand or, in the set-up, the next one.
  void update(bigint first);

  bool holds(int i) const { return candidates_[i] && still_held(i); }

  // may it hold one of n grains from this one on?
  bool may_hold(int first, int n) const
  {
    return std::memchr(candidates_.data() + first, 1, n) != NULL;
  }

 private:

  class FixPropertyAtom *release_;    // its fifth value is the step of the release
  bool stale_;
  bigint first_;
  std::vector<char> candidates_;      // held when the neighbour lists were built: spares a
                                      // look at release_ for all the others
  bool still_held(int) const;
};

}

#endif
