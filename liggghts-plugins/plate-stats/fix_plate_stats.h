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

#include "fix.h"

#include "collision_store.h"
#include "collision_tracker.h"
#include "events_file.h"
#include "plate_geometry.h"
#include "plate_statistics.h"
#include "wall_forces.h"
#include "wall_surface.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/* Statistics of what hits a plate. User page: docs/fix_plate_stats.md.

     fix ID group plate/stats wall wallID centre x y z normal nx ny nz radius R rings n
         file path [every N] [events path] [stats_start t]

   The forces are those that a fix wall/gran with store_force yes has computed in the
   step. A collision begins in the first step with a force from the wall while the grain
   reaches the plate's plane, and ends in the first step without. Velocities are taken
   in mid-step, after the last kick without and before the first kick with that force
   (and the reverse at the end), so speeds before and after hold no contact force. They
   are against the surface, whose velocity LIGGGHTS gives for mid-step as well; the plate
   goes along with the mesh that it lies on.

   Collisions in progress migrate and restart with their grains; finished ones are
   gathered on rank 0, in the order of time and ID, so that the result does not depend
   on the number of ranks.

   Global vector: 1 finished collisions, 2 grains in contact, 3 grains deleted while in
   contact, all for the whole plate and of collisions that count (see stats_start).    */
class FixPlateStats : public Fix {
 public:

  FixPlateStats(class LAMMPS *, int, char **);
  ~FixPlateStats();

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int) override;
  void pre_neighbor() override;
  void pre_final_integrate() override;
  void end_of_step() override;
  void post_run() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double compute_vector(int) override;
  double memory_usage() override;

  // the collisions in progress go where their grains go

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

 private:

  std::string wallID_, path_, eventsPath_;
  int every_;               // steps between updates of the file
  double start_;            // s, stats_start

  std::unique_ptr<grainjet::PlateGeometry> plate_;
  std::unique_ptr<WallForces> wall_;
  std::unique_ptr<WallSurface> surface_;

  // ---- on every rank

  grainjet::CollisionStore store_;
  std::unique_ptr<CollisionTracker> tracker_;
  bool observed_;           // grains in contact from before have been marked
  bool anew_;               // after a restart statistics begin anew
  bool unknown_;            // and the restart file's collisions are those of another plate
  bool warned_;             // whether the plate lies on the wall is settled
  double clock_;            // s, time of the simulation, also across restarts, where LIGGGHTS'
                            // own starts anew; < 0: not yet set
  double begin_;            // s, time from which collisions count

  // ---- on rank 0

  std::unique_ptr<grainjet::PlateStatistics> statistics_;
  std::unique_ptr<grainjet::EventsFile> events_;
  std::vector<double> begun_;       // per region, since the statistics began
  double restartedEvents_;          // bytes of the events file to keep; < 0: new file
  std::string restartedPath_;       // of that events file
  bool started_;                    // the first run has begun
  bool left_;                       // the table could not take its place; said already

  void parse(int, char **);
  void find_wall();
  [[noreturn]] void fail(const std::string &message) const;
  void gather();
  std::vector<double> touching() const;
  void write();
  void warn_if_beside();
  void agree(std::string fault);
  std::vector<std::string> paths() const;
  std::string check_files() const;
  std::string check_dumps() const;
  std::string open_events();
  std::string other_plate(const double *stored, const std::string &wall) const;
};

}

#endif
#endif
