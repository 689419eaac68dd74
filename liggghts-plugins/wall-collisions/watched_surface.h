/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WATCHED_SURFACE_H
#define GRAINJET_WATCHED_SURFACE_H

#include "collision.h"

namespace LAMMPS_NS {

/* The surface whose collisions are followed: what belongs to it, where its normal points and how
   fast it moves. A region is a part of it with a count of its own.                   */
class WatchedSurface {
 public:

  struct Touch {
    int mesh, triangle;      // place in the list of meshes, element ID
    double velocity[3];      // m/s, of the surface
    double normal[3];        // unit vector away from the surface, on the grain's side
  };

  virtual ~WatchedSurface() {}

  // indices of grains or triangles have changed: at every rebuild of the neighbour lists
  virtual void reorder() {}

  // until the next rebuild grain i may come to touch the surface
  virtual bool comes_near(int i) const = 0;

  // What grain i, on which the wall acts in this step, touches of the surface; false: nothing
  virtual bool touch(int i, Touch &) const = 0;

  // the velocity of the surface there now, next to grain i; false: not on this rank
  virtual bool velocity(int i, Touch &) const = 0;

  // where grain i touches first
  virtual void place(int i, const Touch &, grainjet::Collision &) const = 0;

  // regions are counted from 0; -1: the collision is none of the surface
  virtual int regions() const = 0;
  virtual int region(const grainjet::Collision &) const = 0;
};

}

#endif
