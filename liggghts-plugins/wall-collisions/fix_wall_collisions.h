/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_FIX_WALL_COLLISIONS_H
#define GRAINJET_FIX_WALL_COLLISIONS_H

#include "fix.h"

#include "collision_store.h"
#include "collision_tracker.h"
#include "events_file.h"
#include "file_writer.h"
#include "wall_forces.h"
#include "watched_surface.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/* What fixes have in common that count the collisions of grains with a part of a wall.

   The forces are those that a fix wall/gran with store_force yes has computed in the
   step. A collision begins in the first step with a force from the wall while the grain
   touches the watched surface, and ends in the first step without. Velocities are taken
   in mid-step, after the last kick without and before the first kick with that force
   (and the reverse at the end), so speeds before and after hold no contact force. They
   are against the surface, whose velocity LIGGGHTS gives for mid-step as well.

   Collisions in progress migrate and restart with their grains; finished ones are
   gathered on rank 0, in the order of time and ID, so that the result does not depend
   on the number of ranks.                                                            */
class FixWallCollisions : public Fix, public grainjet::FileWriter {
 public:

  FixWallCollisions(class LAMMPS *, int, char **, int kept);
  ~FixWallCollisions();

  int setmask() override;
  void post_create() override;
  void init() override;
  void setup(int) override;
  void pre_neighbor() override;
  void pre_final_integrate() override;
  void end_of_step() override;
  void post_run() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
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

 protected:

  // a file that the fix writes as a whole, and its first line
  struct Output {
    std::string path, line;
  };

  std::string wallID_, path_, eventsPath_;
  int every_;               // steps between updates of the files
  double start_;            // s, stats_start

  // ---- on every rank

  grainjet::CollisionStore store_;
  std::unique_ptr<CollisionTracker> tracker_;
  std::unique_ptr<WallForces> wall_;
  bool anew_;               // after a restart statistics begin anew
  double clock_;            // s, time of the simulation, also across restarts, where LIGGGHTS'
                            // own starts anew; < 0: not yet set
  double begin_;            // s, time from which collisions count

  // ---- on rank 0

  std::unique_ptr<grainjet::EventsFile> events_;
  std::vector<double> begun_;       // all, then by region, since the statistics began

  // once wallID_ and the rest are known: the fix is complete but for its files
  void watch(WatchedSurface &);

  [[noreturn]] void fail(const std::string &message) const;

  // ends the run on all ranks if rank 0 has met a fault
  void agree(std::string fault);

  // hands finished collisions to rank 0
  void gather();

  // collisions that go on now, all, then by region; the result is on rank 0
  std::vector<double> touching() const;

  // plain doubles, `size` to an item, in the order of the ranks; the result is on rank 0
  std::vector<double> collect(const double *mine, std::size_t count, int size) const;

  // pieces of sliding of all ranks, in the order of time and ID; the result is on rank 0
  std::vector<grainjet::SlidingPiece> sliding(const std::vector<grainjet::SlidingPiece> &mine) const;

  // before watch(): sliding work is asked for; the store keeps whole records
  void follow_sliding() { follows_sliding_ = true; }

  // Grains have a temperature, the property Temp: files have that at impact
  bool has_temperature() const { return temperature_; }

  // of a line of the events file: ",<K>", or nothing
  std::string temperature(const grainjet::FinishedCollision &) const;

  // on rank 0: a file takes its place in one piece, or a warning says that it could not
  std::string replace(const std::string &path, const std::string &line, const std::string &text);

  // ---- what differs

  // finds the surface: an empty string or what is wrong
  virtual std::string attach_surface() = 0;

  // at the start of a run; in every step if the surface moves
  virtual void update_surface(bool start) = 0;

  // files written as a whole; the table is the first
  virtual std::vector<Output> outputs() const = 0;

  // of the events file: first line, line of a collision
  virtual std::string event_columns() const = 0;
  virtual std::string event(const grainjet::FinishedCollision &) const = 0;

  // a warning if the wall has touched grains, but none at the surface; NULL: that is no fault
  virtual const char *beside_hint() const { return NULL; }

  // on rank 0: adds collisions, in the order of time and ID, and sliding work alike
  virtual void book(const std::vector<grainjet::FinishedCollision> &,
    const std::vector<grainjet::SlidingPiece> &) = 0;

  // writes all files but the events; on all ranks together
  virtual void write() = 0;

  // Restart data: what is watched, and how it differs from that of the file (a phrase; `next` goes
  // past it); the surface; the statistics
  virtual std::vector<double> pack_watched() const = 0;
  virtual std::string compare_watched(const double *&next) const = 0;
  virtual std::vector<double> pack_surface() const { return std::vector<double>(); }
  virtual int unpack_surface(const double *) { return 0; }
  virtual std::vector<double> pack_statistics() const = 0;
  virtual void unpack_statistics(const std::vector<double> &) = 0;

  static void pack_text(std::vector<double> &, const std::string &);
  static std::string unpack_text(const double *&next);

 private:

  bool temperature_;        // settled when the fix is defined, since its files begin then
  bool follows_sliding_;
  bool observed_;           // grains in contact from before have been marked
  bool unknown_;            // the restart file's collisions are those of something else
  bool warned_;             // whether the surface lies on the wall is settled
  bool started_;            // the first run has begun
  bool restartedTemperature_;       // the restart file's collisions have a temperature
  double restartedEvents_;          // bytes of the events file to keep; < 0: new file
  std::string restartedPath_;       // of that events file
  std::vector<std::string> left_;   // files that could not take their place; said already

  void find_wall();
  void attach_temperature();
  void warn_if_beside();
  std::vector<std::string> paths() const override;
  std::string check_files() const;
  std::string check_dumps() const;
  std::string open_events();
};

}

#endif
