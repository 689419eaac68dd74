/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_PLATE_STATISTICS_H
#define GRAINJET_PLATE_STATISTICS_H

#include "plate_geometry.h"

#include "wall-collisions/collision_moments.h"

#include <string>
#include <vector>

namespace grainjet {

/* Statistics of finished collisions for the whole plate and each ring.

   Collisions belong to the ring of their first contact. All ratios with nothing to
   divide by are nan in the file.                                                    */
class PlateStatistics {
 public:

  // the first line of the table; temperature: grains have one
  static std::string columns(bool temperature);

  PlateStatistics(const PlateGeometry &, bool temperature);

  // regions: 0 is the whole plate, 1 + i is ring i
  int regions() const { return static_cast<int>(regions_.size()); }

  void add(const FinishedCollision &);

  double collisions(int region) const { return regions_[region].moments.count(); }

  // The table as CSV text. time: s over which collisions were counted; begun, touching:
  // collisions begun in that time and those of them that go on now, per region
  std::string csv(double time, const std::vector<double> &begun,
    const std::vector<double> &touching) const;

  // for restart files; unpack returns false if they are of another number of rings
  std::vector<double> pack() const;
  bool unpack(const std::vector<double> &);

 private:

  struct Region {
    explicit Region(bool temperature) : moments(temperature) {}
    CollisionMoments moments;
    double particles = 0.0;    // sum of f_cg^3
  };

  PlateGeometry geometry_;
  bool temperature_;
  std::vector<Region> regions_;
};

}

#endif
