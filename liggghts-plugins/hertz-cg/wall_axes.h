/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WALL_AXES_H
#define GRAINJET_WALL_AXES_H

namespace LAMMPS_NS { class LAMMPS; }

namespace grainjet {

/* Walls keep lists of the grains near them, made together with the list of pairs. A grain comes
   upon a wall only by moving along the wall's normal: a stream through a pipe does not.        */
struct WallAxes {
  bool any;        // is there a wall that keeps a list?
  bool mesh;       // is one of them a mesh, whose triangles may face anywhere?
  double reach;    // how far a grain may come nearer before lists are stale, in units of the skin
  bool axis[3];    // directions x, y, z that some wall's normal may have a part in
  bool moving;     // does a mesh move?
};

WallAxes find_walls(LAMMPS_NS::LAMMPS *lmp);

// What mesh walls cost on this rank
struct MeshWork {
  double triangles;   // also those shared with other ranks
  double listed;      // pairs of grain and triangle, looked at in every step
};

MeshWork mesh_work(LAMMPS_NS::LAMMPS *lmp);

}

#endif
