/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(plate/stats,FixPlateStats)

#else

#ifndef LMP_FIX_PLATE_STATS_H
#define LMP_FIX_PLATE_STATS_H

#include "plate_geometry.h"
#include "plate_statistics.h"
#include "wall_surface.h"

#include "wall-collisions/fix_wall_collisions.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/* Statistics of what hits a plate. User page: docs/fix_plate_stats.md.

     fix ID group plate/stats wall wallID centre x y z normal nx ny nz radius R rings n
         file path [every N] [events path] [stats_start t]

   What a collision is and how it is followed: wall-collisions/fix_wall_collisions.h. It
   belongs to the plate while the grain reaches the plate's plane, and the plate goes along
   with the mesh that it lies on.

   Global vector: 1 finished collisions, 2 grains in contact, 3 grains deleted while in
   contact, all for the whole plate and of collisions that count (see stats_start).    */
class FixPlateStats : public FixWallCollisions {
 public:

  FixPlateStats(class LAMMPS *, int, char **);

  void pre_delete(bool unfixflag) override;
  double compute_vector(int) override;

 protected:

  std::string attach_surface() override { return surface_->attach(); }
  void update_surface(bool start) override;
  const char *beside_hint() const override;
  std::vector<Output> outputs() const override;
  std::string event_columns() const override;
  std::string event(const grainjet::FinishedCollision &) const override;
  void book(const std::vector<grainjet::FinishedCollision> &,
    const std::vector<grainjet::SlidingPiece> &) override;
  void write() override;
  std::vector<double> pack_watched() const override;
  std::string compare_watched(const double *&next) const override;
  std::vector<double> pack_surface() const override { return surface_->pack(); }
  int unpack_surface(const double *list) override { return surface_->unpack(list); }
  std::vector<double> pack_statistics() const override { return statistics_->pack(); }
  void unpack_statistics(const std::vector<double> &list) override { statistics_->unpack(list); }

 private:

  std::unique_ptr<grainjet::PlateGeometry> plate_;
  std::unique_ptr<WallSurface> surface_;
  std::unique_ptr<grainjet::PlateStatistics> statistics_;    // on rank 0

  void parse(int, char **);
};

}

#endif
#endif
