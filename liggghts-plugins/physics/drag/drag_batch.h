/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_BATCH_H
#define GRAINJET_DRAG_BATCH_H

#include "physics/drag/drag_laws.h"

namespace grainjet {
namespace drag {

/* What drag laws need of many grains, and what they return, in the units of State. A new
   batch holds numbers that every law can take, so that a part of it may be left as it is. */
struct Batch {
  // Several registers, and few enough for the first cache to hold what belongs to them
  static constexpr int SIZE = 16;

  double density;                   // kg/m3, of the fluid
  double voidFraction[SIZE], slipSpeed[SIZE], diameter[SIZE], viscosity[SIZE];
  double drag[SIZE];                // kg/(m3 s)

  explicit Batch(double fluidDensity) : density(fluidDensity)
  {
    for (int i = 0; i < SIZE; i++) {
      voidFraction[i] = diameter[i] = viscosity[i] = 1.0;
      slipSpeed[i] = 0.0;
    }
  }
};

typedef void (*BatchLaw)(Batch &);

/* The law of that name (see findLaw) for a batch at once, or nullptr. It works on as many
   grains together as the processor's vector registers hold, AVX-512 or AVX2 where there is
   one, with glibc's vector functions; so its last digit is that of the processor. All grains of a batch are
   computed in the same way, so that a grain's drag does not depend on its place.       */
BatchLaw findBatchLaw(const std::string &name, Spelling spelling);

}
}

#endif
