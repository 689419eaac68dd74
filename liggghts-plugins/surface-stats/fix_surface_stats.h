/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(surface/stats,FixSurfaceStats)

#else

#ifndef LMP_FIX_SURFACE_STATS_H
#define LMP_FIX_SURFACE_STATS_H

#include "impact_spectra.h"
#include "map_series.h"
#include "mesh_surface.h"
#include "surface_statistics.h"

#include "host/fix_arguments.h"
#include "wall-collisions/fix_wall_collisions.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/* What meshes suffer from the collisions of grains: by triangle, by mesh, in total. User page:
   docs/fix_surface_stats.md.

     fix ID group surface/stats mesh meshID [mesh meshID ...] wall wallID file path
         [wear law coefficients] [every N] [vtk path] [events path] [spectra path]
         [speed least most bins] [energy least most bins] [stats_start t]

   What a collision is and how it is followed: wall-collisions/fix_wall_collisions.h. A grain
   that slides over an edge or from one of the meshes to another goes on with its collision.
   The force is all that the wall exerts on the grain in the step. An impact belongs to the
   triangle that is touched first, sliding work to the one on which it is done.

   Global vector: 1 finished collisions, 2 grains in contact, 3 grains deleted while in
   contact, 4 mass of impacts (kg), 5 energy lost in them (J), 6 removed volume (m3),
   all of collisions that count (see stats_start).                                    */
class FixSurfaceStats : public FixWallCollisions {
 public:

  FixSurfaceStats(class LAMMPS *, int, char **);

  void post_create() override;
  void init() override;
  double compute_vector(int) override;
  double memory_usage() override;

 protected:

  std::string attach_surface() override;
  void update_surface(bool) override { surface_->update(); }
  std::vector<Output> outputs() const override;
  std::string event_columns() const override;
  std::string event(const grainjet::FinishedCollision &) const override;
  void book(const std::vector<grainjet::FinishedCollision> &,
    const std::vector<grainjet::SlidingPiece> &) override;
  void write() override;
  std::vector<double> pack_watched() const override;
  std::string compare_watched(const double *&next) const override;
  std::vector<double> pack_statistics() const override;
  void unpack_statistics(const std::vector<double> &) override;

 private:

  std::vector<std::string> meshIDs_;
  std::string wear_;                // law and coefficients as the script has them
  std::string vtkPath_, spectraPath_;
  grainjet::ImpactSpectra::Range speed_, energy_;

  std::unique_ptr<MeshSurface> surface_;
  std::shared_ptr<const grainjet::wear::WearLaw> law_;
  bool placed_;                     // corners_ are those of this run, and no mesh moves

  // ---- on rank 0

  std::unique_ptr<grainjet::SurfaceStatistics> statistics_;
  std::unique_ptr<grainjet::ImpactSpectra> spectra_;
  std::unique_ptr<grainjet::MapSeries> series_;    // empty: no vtk
  bigint mapped_;                   // step of the latest map
  double mappedTime_;               // s, its time: reset_timestep can bring a step again
  std::vector<int> restarted_;      // triangles of the meshes in the restart file
  std::vector<std::vector<double> > corners_, areas_;    // by mesh: m, m2

  void parse(int, char **);
  void parse_wear(grainjet::FixArguments &);
  std::vector<int> triangles() const;
  void find_corners();
  std::string write_table(const grainjet::SurfaceStatistics &, const std::vector<double> &touching);
  std::string write_map(const grainjet::SurfaceStatistics &);
};

}

#endif
#endif
