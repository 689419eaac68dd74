/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "mesh_surface.h"

#include "atom.h"
#include "comm.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "modify.h"
#include "tri_mesh.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using grainjet::Collision;

/* ---------------------------------------------------------------------- */

MeshSurface::MeshSurface(LAMMPS *lmp, const std::string &wallID,
  const std::vector<std::string> &meshIDs) :
  Pointers(lmp), wallID_(wallID), meshIDs_(meshIDs)
{
}

/* ---------------------------------------------------------------------- */

std::string MeshSurface::attach()
{
  owners_.clear();
  contacts_.clear();
  for (const std::string &meshID : meshIDs_) {
    FixMeshSurface *owner = NULL;
    const std::string fault = find_mesh(meshID, owner);
    if (!fault.empty()) return fault;
    owners_.push_back(owner);
    contacts_.emplace_back(lmp, owner);
  }

  std::vector<int> triangles;
  for (FixMeshSurface *owner : owners_) triangles.push_back(count_triangles(owner));
  for (std::size_t m = 0; m < triangles_.size(); m++)
    if (triangles_[m] != triangles[m])
      return "mesh '" + meshIDs_[m] + "' has " + std::to_string(triangles[m]) + " triangles, but "
        + std::to_string(triangles_[m]) + " when the fix was defined; define the fix anew after "
        "the mesh";
  triangles_ = triangles;
  return "";
}

/* ---------------------------------------------------------------------- */

std::string MeshSurface::find_mesh(const std::string &meshID, FixMeshSurface *&owner) const
{
  const int ifix = modify->find_fix(meshID.c_str());
  if (ifix < 0) return "mesh '" + meshID + "' is not the ID of a fix mesh/surface defined before";
  owner = dynamic_cast<FixMeshSurface *>(modify->fix[ifix]);
  if (!owner)
    return "mesh '" + meshID + "' is a fix " + modify->fix[ifix]->style + ", not a fix mesh/surface";

  FixWallGran *wall = dynamic_cast<FixWallGran *>(modify->fix[modify->find_fix(wallID_.c_str())]);
  if (!wall) return "wall '" + wallID_ + "' is not the ID of a fix wall/gran defined before";
  if (!wall->is_mesh_wall())
    return "wall '" + wallID_ + "' is primitive and has no meshes; give the fix wall/gran of mesh '"
      + meshID + "', or use fix plate/stats for a plane";
  std::string names;
  for (int m = 0; m < wall->n_meshes(); m++) {
    if (wall->mesh_list()[m] == owner) return "";
    names += std::string(m ? ", " : "") + wall->mesh_list()[m]->id;
  }
  return "mesh '" + meshID + "' is none of wall '" + wallID_ + "', whose meshes are " + names;
}

/* ----------------------------------------------------------------------
   Before its first run each rank has the whole mesh, later its part.
------------------------------------------------------------------------- */

int MeshSurface::count_triangles(FixMeshSurface *owner) const
{
  TriMesh *mesh = owner->triMesh();
  int mine = 0, all;
  for (int i = 0; i < mesh->sizeLocal(); i++) mine = std::max(mine, mesh->id(i) + 1);
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void MeshSurface::update()
{
  for (MeshContacts &contacts : contacts_) contacts.update();
}

/* ---------------------------------------------------------------------- */

bool MeshSurface::moves() const
{
  return std::any_of(owners_.begin(), owners_.end(), [](FixMeshSurface *owner) {
    return owner->triMesh()->isMoving() || owner->triMesh()->isDeforming();
  });
}

/* ---------------------------------------------------------------------- */

std::vector<double> MeshSurface::corners(int m) const
{
  static const int SIZE = 10;    // ID and corners
  TriMesh *mesh = owners_[m]->triMesh();
  const int n = mesh->sizeLocal();
  std::vector<double> mine(n * SIZE);
  for (int i = 0; i < n; i++) {
    double *entry = &mine[i * SIZE];
    entry[0] = mesh->id(i);
    for (int node = 0; node < 3; node++) mesh->node(i, node, entry + 1 + 3 * node);
  }

  int number = mine.size(), total = 0;
  std::vector<int> sizes(comm->nprocs), starts(comm->nprocs);
  MPI_Gather(&number, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, world);
  for (int rank = 0; rank < comm->nprocs; rank++) {
    starts[rank] = total;
    total += sizes[rank];
  }
  std::vector<double> all(total), corners;
  MPI_Gatherv(mine.data(), number, MPI_DOUBLE,
    all.data(), sizes.data(), starts.data(), MPI_DOUBLE, 0, world);
  if (comm->me == 0) corners.assign(9 * triangles_[m], 0.0);
  for (int entry = 0; entry < total; entry += SIZE)
    std::copy_n(&all[entry + 1], 9, &corners[9 * static_cast<int>(all[entry])]);
  return corners;
}

/* ---------------------------------------------------------------------- */

void MeshSurface::reorder()
{
  for (MeshContacts &contacts : contacts_) contacts.reorder();
}

/* ---------------------------------------------------------------------- */

bool MeshSurface::comes_near(int i) const
{
  for (const MeshContacts &contacts : contacts_)
    if (contacts.comes_near(i)) return true;
  return false;
}

/* ---------------------------------------------------------------------- */

bool MeshSurface::touch(int i, Touch &touch) const
{
  int mesh = -1;
  MeshContacts::Contact contact, deepest;
  for (int m = 0; m < meshes(); m++) {
    if (!contacts_[m].deepest(i, contact) || (mesh >= 0 && contact.gap >= deepest.gap)) continue;
    mesh = m;
    deepest = contact;
  }
  if (mesh < 0) return false;
  contacts_[mesh].choose_lowest(i, deepest);
  touch.mesh = mesh;
  touch.triangle = deepest.triangle;
  contacts_[mesh].velocity(deepest, touch.velocity);
  contacts_[mesh].normal(deepest, touch.normal);
  return true;
}

/* ---------------------------------------------------------------------- */

bool MeshSurface::velocity(int i, Touch &touch) const
{
  std::fill_n(touch.velocity, 3, 0.0);
  const MeshContacts &contacts = contacts_[touch.mesh];
  if (!contacts.has_velocity()) return true;
  MeshContacts::Contact contact;
  if (!contacts.nearest(i, touch.triangle, contact)) return false;
  contacts.velocity(contact, touch.velocity);
  return true;
}

/* ---------------------------------------------------------------------- */

void MeshSurface::place(int i, const Touch &touch, Collision &collision) const
{
  std::copy_n(atom->x[i], 3, collision.x);
  collision.firstMesh = touch.mesh;
  collision.firstTriangle = touch.triangle;
}
