/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_MESH_CONTACTS_H
#define GRAINJET_MESH_CONTACTS_H

#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

/* Which triangles of one mesh of a fix wall/gran a grain touches, and how these move. The wall
   notes the triangles that it has handled in the step (FixContactHistoryMesh). The velocity
   is the one that the wall's law uses: of the nodes, for surface_vel and surface_ang_vel
   as well.                                                                           */
class MeshContacts : protected Pointers {
 public:

  struct Contact {
    int triangle;            // element ID
    int element;             // its local index
    double gap;              // m, from the grain's surface to the nearest point of the triangle
    double delta[3];         // m, from the grain's centre to that point
    double weights[3];       // of the corners, for that point
  };

  MeshContacts(class LAMMPS *, class FixMeshSurface *);

  // local indices of triangles have changed
  void reorder() { current_ = false; }

  // finds the velocities; at the start of a run, and in every step if the mesh has them
  void update();
  bool has_velocity() const { return nodeVelocity_ != NULL; }

  // neighbour list of the wall: grain i may touch a triangle until the next rebuild
  bool comes_near(int i) const;

  // Of the triangles that grain i touches the one it has entered deepest, of equals the one with the
  // lowest ID; false: none
  bool deepest(int i, Contact &) const;

  // grain i and this triangle; of images in a periodic box the nearest. false: not on this rank
  bool nearest(int i, int triangle, Contact &) const;

  // Grains over a common edge or corner touch several triangles alike, and the wall handles one of
  // those that lie in a plane: which one depends on the order of triangles on the rank. This
  // takes the one with the lowest ID.
  void choose_lowest(int i, Contact &) const;

  // m/s, of the surface in the nearest point
  void velocity(const Contact &, double *) const;

  // unit vector of the triangle, on the grain's side
  void normal(const Contact &, double *) const;

 private:

  class TriMesh *mesh_;
  class FixMeshSurface *owner_;
  double ***nodeVelocity_;              // [element][node][3], NULL: at rest

  // local indices by ID, since LIGGGHTS' own map costs more than the contact itself
  mutable bool current_;
  mutable std::vector<int> first_;      // by ID, NONE: not here
  mutable std::vector<int> next_;       // by local index: further images in a periodic box

  static constexpr int NONE = -1;
  void index() const;
  int element(int triangle) const
  {
    return triangle >= 0 && triangle < static_cast<int>(first_.size()) ? first_[triangle] : NONE;
  }
};

}

#endif
