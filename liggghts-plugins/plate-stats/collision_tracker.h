/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_COLLISION_TRACKER_H
#define GRAINJET_COLLISION_TRACKER_H

#include "collision.h"
#include "collision_store.h"
#include "plate_geometry.h"
#include "wall_surface.h"

#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

/* Follows the collisions of this rank's grains with the plate from step to step. Velocities
   are against the surface at the contact. The owner of the store sees to it that
   collisions in progress migrate and restart.                                        */
class CollisionTracker : protected Pointers {
 public:

  CollisionTracker(class LAMMPS *, const grainjet::PlateGeometry &, const WallSurface &,
    int groupbit, grainjet::CollisionStore &);

  // collisions that begin earlier do not count (s)
  void count_from(double time) { start_ = time; }

  // Start of a run. Between runs a grain can have been put elsewhere while it touched.
  void start_run() { rebuild_ = thorough_ = true; }

  // Grains that touch already when first looked at: the beginning of their collision is
  // unknown, so it is followed but never counts.
  void skip_present(double **forces);

  // indices or positions have changed: at every rebuild of the neighbour lists
  void reorder() { rebuild_ = true; }

  // One DEM step, when all its forces are known and have not acted yet. forces: of the
  // wall on each grain; time: s, at the end of the step
  void step(double **forces, double time);

  // what has come in since the last clear(); begun: whole plate, then rings
  const std::vector<grainjet::FinishedCollision> &finished() const { return finished_; }
  const std::vector<double> &begun() const { return begun_; }
  void clear();

  // collisions that count and go on now: whole plate, then rings
  std::vector<double> touching() const;

  // the wall has touched grains of this rank at the plate; away from it
  bool seen() const { return seen_; }
  bool beside() const { return elsewhere_; }

 private:

  const grainjet::PlateGeometry &plate_;    // radius and rings
  const WallSurface &surface_;
  int groupbit_;
  grainjet::CollisionStore &store_;
  double start_;
  bool rebuild_, thorough_;         // near_ is out of date; look at all grains

  std::vector<int> near_;           // grains that can reach the plate until the next rebuild
  std::vector<grainjet::FinishedCollision> finished_;
  std::vector<double> begun_;
  bool seen_, elsewhere_;

  bool reaches(int, int plate) const;
  bool touches(int, double **forces) const;
  bool comes_near(int) const;
  bool counts(const grainjet::Collision &c) const { return c.time >= 0 && c.time >= start_; }
  double kinetic_energy(int, const double *velocity) const;
  void count(const grainjet::Collision &, std::vector<double> &) const;
  void find_near(double **forces);
  grainjet::Collision &begin(int, double time, const WallSurface::Touch &);
  void finish(int);
};

}

#endif
