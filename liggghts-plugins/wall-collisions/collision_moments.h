/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_COLLISION_MOMENTS_H
#define GRAINJET_COLLISION_MOMENTS_H

#include "collision.h"

#include "physics/statistics/moments.h"

#include <string>
#include <vector>

namespace grainjet {

/* Moments of the quantities of finished collisions, as tables have them:
   normal_force_peak, tangential_force_peak, normal_force, tangential_force (N),
   impact_speed (m/s), impact_angle (degrees), duration (s), energy_loss (J), and temperature (K)
   where grains have one.                                                             */
class CollisionMoments {
 public:

  // in the order of the columns
  static std::vector<std::string> quantities(bool temperature);

  // ",<q>_mean,<q>_variance,<q>_skewness" of each; ",<q>_standard_error" of each
  static std::string moment_columns(bool temperature);
  static std::string error_columns(bool temperature);

  explicit CollisionMoments(bool temperature) : moments_(quantities(temperature).size()) {}

  void add(const FinishedCollision &);

  double count() const { return moments_[0].count(); }

  // values under those columns, as text
  std::string moments() const;
  std::string errors() const;

  // a value of a CSV table, after a comma
  static std::string cell(double);

  int packed() const { return Moments::PACKED * static_cast<int>(moments_.size()); }
  void pack(double *buffer) const;
  void unpack(const double *buffer);

 private:

  std::vector<Moments> moments_;    // one per quantity
};

}

#endif
