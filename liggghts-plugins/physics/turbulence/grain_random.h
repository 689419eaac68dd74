/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_GRAIN_RANDOM_H
#define GRAINJET_GRAIN_RANDOM_H

#if !__has_include(<Random123/philox.h>)
#error "Random123 is missing: install the package librandom123-dev (docs/building.md)"
#endif

#include <Random123/philox.h>

#include <cmath>
#include <cstdint>

namespace grainjet {
namespace turbulence {

/* Random numbers of a grain in a time step, a function of seed, grain, step, number of the draw and what they
   are for alone: the same on any rank and after a restart, with no generator to be kept. Philox4x32-10
   (Salmon, Moraes, Dror and Shaw 2011).                                                 */
class GrainRandom {
public:
  // Two models have numbers of their own in the same step, even with equal seeds
  enum Use : uint32_t { EDDIES = 0, ROUGHNESS = 1 };

  GrainRandom(uint32_t seed, int64_t grain, int64_t step, Use use = EDDIES)
    : key_{{seed, 0x6772616eu ^ (use << 24) ^ uint32_t(uint64_t(step) >> 32)}},
      counter_{{uint32_t(grain), uint32_t(uint64_t(grain) >> 32), uint32_t(step), 0u}}
  {}

  // Four independent standard normal numbers (Box and Muller 1958) of draw number n, or the first two of them
  void normals(uint32_t n, double *four, int count = 4) const
  {
    r123::Philox4x32::ctr_type counter = counter_;
    counter[3] = n;
    const r123::Philox4x32::ctr_type bits = r123::Philox4x32()(counter, key_);

    for (int k = 0; k < count; k += 2) {
      const double radius = std::sqrt(-2.0 * std::log(uniform(bits[k])));
      const double angle = 6.283185307179586 * uniform(bits[k + 1]);
      four[k] = radius * std::cos(angle);
      four[k + 1] = radius * std::sin(angle);
    }
  }

private:
  const r123::Philox4x32::key_type key_;
  const r123::Philox4x32::ctr_type counter_;

  // within (0, 1), never at its ends
  static double uniform(uint32_t bits) { return (bits + 0.5) * (1.0 / 4294967296.0); }
};

}
}

#endif
