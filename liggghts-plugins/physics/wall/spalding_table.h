/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WALL_SPALDING_TABLE_H
#define GRAINJET_WALL_SPALDING_TABLE_H

#include "physics/wall/spalding.h"
#include <cstdint>
#include <cstring>
#include <vector>

namespace grainjet {
namespace wall {

/* u+ of Spalding's law from a table, without an iteration: for many places. Cubic Hermite
   interpolation with the slopes of the law: continuous with its slope, and good to 1e-7 of u+.

   The nodes are 32 between each two powers of two of 1 + y+, so that the interval of a place is
   given by the leading bits of that number. Beyond the table (y+ 4e6) the law itself is taken. */
class SpaldingTable {
public:
  explicit SpaldingTable(const Spalding &law) : law_(law), nodes_(OCTAVES * PER_OCTAVE + 1)
  {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double y = std::ldexp(1.0 + double(i % PER_OCTAVE) / PER_OCTAVE, int(i / PER_OCTAVE)) - 1.0;
      const double u = law_.uPlus(y);
      nodes_[i] = Node{y, u, 1.0 / law_.slope(u)};
    }
  }

  double uPlus(double yPlus) const
  {
    const double x = 1.0 + yPlus;
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    const std::uint64_t i = (bits >> (52 - PER_OCTAVE_BITS)) - (std::uint64_t(1023) << PER_OCTAVE_BITS);
    if (i >= OCTAVES * PER_OCTAVE) return law_.uPlus(yPlus);

    const Node &a = nodes_[i], &b = nodes_[i + 1];
    const double h = b.y - a.y, t = (yPlus - a.y) / h, r = 1.0 - t;
    return r * r * ((1.0 + 2.0 * t) * a.u + t * h * a.slope) + t * t * ((3.0 - 2.0 * t) * b.u - r * h * b.slope);
  }

  // u+/y+: 1 at the wall, also exactly at it
  double ratio(double yPlus) const { return yPlus > 0 ? uPlus(yPlus) / yPlus : 1.0; }

private:
  static constexpr int PER_OCTAVE_BITS = 5;
  static constexpr std::uint64_t PER_OCTAVE = 1 << PER_OCTAVE_BITS, OCTAVES = 22;

  struct Node {
    double y, u, slope;
  };

  Spalding law_;
  std::vector<Node> nodes_;
};

}
}

#endif
