/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_COLLISION_TRACKER_H
#define GRAINJET_COLLISION_TRACKER_H

#include "collision.h"
#include "collision_store.h"
#include "watched_surface.h"

#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

/* Follows the collisions of this rank's grains with a surface from step to step. Velocities are
   against the surface at the contact. The owner of the store sees to it that collisions
   in progress migrate and restart.                                                   */
class CollisionTracker : protected Pointers {
 public:

  CollisionTracker(class LAMMPS *, WatchedSurface &, int groupbit, grainjet::CollisionStore &);

  // collisions that begin earlier, and sliding before, do not count (s)
  void count_from(double time) { start_ = time; }

  // also adds up the sliding work, by triangle; the store has to keep whole records
  void follow_sliding() { sliding_ = true; }

  // property Temp, for the temperature at impact; NULL: grains have none
  void record_temperature(const class FixPropertyAtom *property) { temperature_ = property; }

  // Start of a run. Between runs a grain can have been put elsewhere while it touched.
  void start_run() { surface_.reorder(); rebuild_ = thorough_ = true; }

  // Grains that touch already when first looked at: the beginning of their collision is
  // unknown, so it is followed but never counts.
  void skip_present(double **forces);

  // indices or positions have changed: at every rebuild of the neighbour lists
  void reorder() { rebuild_ = true; }

  // One DEM step, when all its forces are known and have not acted yet. forces: of the
  // wall on each grain; time: s, at the end of the step
  void step(double **forces, double time);

  // what has come in since the last clear(); begun: all, then by region
  const std::vector<grainjet::FinishedCollision> &finished() const { return finished_; }
  const std::vector<grainjet::SlidingPiece> &slid() const { return slid_; }
  const std::vector<double> &begun() const { return begun_; }
  void clear();

  // collisions that count and go on now: all, then by region
  std::vector<double> touching() const;

  // sliding work of grains on the triangles that they touch now
  std::vector<grainjet::SlidingPiece> sliding() const;

  // the wall has touched grains of this rank on the surface; away from it
  bool seen() const { return seen_; }
  bool beside() const { return elsewhere_; }

 private:

  WatchedSurface &surface_;
  int groupbit_;
  grainjet::CollisionStore &store_;
  double start_;
  bool sliding_;
  const class FixPropertyAtom *temperature_;
  bool rebuild_, thorough_;         // near_ is out of date; look at all grains

  std::vector<int> near_;           // grains that can reach the surface until the next rebuild
  std::vector<grainjet::FinishedCollision> finished_;
  std::vector<grainjet::SlidingPiece> slid_;
  std::vector<double> begun_;
  bool seen_, elsewhere_;

  bool touches(int, double **forces) const;
  bool counts(const grainjet::Collision &c) const { return c.time >= 0 && c.time >= start_; }
  double kinetic_energy(int, const double *velocity) const;
  void count(const grainjet::Collision &, std::vector<double> &) const;
  void find_near(double **forces, double time);
  grainjet::Collision &begin(int, double time, const WatchedSurface::Touch &);
  void slide(int, const double *force, const WatchedSurface::Touch &, grainjet::Collision &) const;
  grainjet::SlidingPiece piece(int, const grainjet::Collision &, double time) const;
  void finish(int, double time);
  void leave(int, double time);
};

}

#endif
