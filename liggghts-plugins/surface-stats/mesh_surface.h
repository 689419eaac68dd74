/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_MESH_SURFACE_H
#define GRAINJET_MESH_SURFACE_H

#include "wall-collisions/mesh_contacts.h"
#include "wall-collisions/watched_surface.h"

#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

/* Some or all of the meshes of a fix wall/gran. A grain is on the triangle that it has entered
   deepest; over a common edge or corner, where several are equal, on that with the lowest ID.
   Regions are the meshes.                                                            */
class MeshSurface : protected Pointers, public WatchedSurface {
 public:

  MeshSurface(class LAMMPS *, const std::string &wallID, const std::vector<std::string> &meshIDs);

  // Finds wall and meshes: returns an empty string or what is wrong. WallForces has found the wall
  // before. At the definition and at the start of every run, on all ranks together.
  std::string attach();

  // Velocities of the nodes, in every step: a mesh that is moved gets them only after the start of a
  // run, and LIGGGHTS puts them elsewhere when triangles change rank
  void update();

  int meshes() const { return static_cast<int>(meshIDs_.size()); }
  const std::string &name(int m) const { return meshIDs_[m]; }

  // element IDs are below this
  int triangles(int m) const { return triangles_[m]; }

  // a mesh that goes elsewhere
  bool moves() const;

  // Corners of the triangles of a mesh by ID, 9 numbers each (m), where they are now. On all ranks
  // together; the result is on rank 0.
  std::vector<double> corners(int m) const;

  void reorder() override;
  bool comes_near(int i) const override;
  bool touch(int i, Touch &) const override;
  bool velocity(int i, Touch &) const override;
  void place(int i, const Touch &, grainjet::Collision &) const override;
  int regions() const override { return meshes(); }
  int region(const grainjet::Collision &collision) const override
  {
    return static_cast<int>(collision.firstMesh);
  }

 private:

  std::string wallID_;
  std::vector<std::string> meshIDs_;

  // per mesh
  std::vector<class FixMeshSurface *> owners_;
  std::vector<MeshContacts> contacts_;
  std::vector<int> triangles_;

  std::string find_mesh(const std::string &meshID, class FixMeshSurface *&) const;
  int count_triangles(class FixMeshSurface *) const;
};

}

#endif
