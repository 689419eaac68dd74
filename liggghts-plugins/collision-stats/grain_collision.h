/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_GRAIN_COLLISION_H
#define GRAINJET_GRAIN_COLLISION_H

namespace grainjet {

/* One collision of two grains, from the first to the last DEM step in contact. Plain doubles, since
   they travel between ranks and into restart files, and the same seen from either grain. SI units,
   of the grains.                                                                             */
struct GrainCollision {
  double place;             // 1 + cell of CollisionStatistics; 0: of no interest, or its beginning is unknown
  double time;              // s, of the first step in contact
  double speed;             // m/s, of one centre against the other, before contact
  double normalEnergy;      // J, m* vn^2/2, with the velocity of approach
  double tangentialEnergy;  // J, m* vt^2/2, vt at the contact point, with rotation
  double loss;              // J, that the contact has taken from the motion so far; when it is over: dissipated
  double normalPeak;        // N, largest normal force, positive when it pushes
  double tangentialPeak;    // N
  double duration;          // s

  static constexpr int SIZE = 9;

  bool counts(double start) const { return place > 0.0 && time >= start; }
  int cell() const { return static_cast<int>(place) - 1; }
};

static_assert(sizeof(GrainCollision) == GrainCollision::SIZE * sizeof(double), "plain doubles only");

}

#endif
