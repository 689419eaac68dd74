/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "mesh_contacts.h"

#include "atom.h"
#include "fix_contact_history_mesh.h"
#include "fix_mesh_surface.h"
#include "tri_mesh.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

MeshContacts::MeshContacts(LAMMPS *lmp, FixMeshSurface *owner) :
  Pointers(lmp), mesh_(owner->triMesh()), owner_(owner), nodeVelocity_(NULL), current_(false)
{
}

/* ---------------------------------------------------------------------- */

void MeshContacts::update()
{
  MultiVectorContainer<double, 3, 3> *velocity =
    mesh_->prop().getElementProperty<MultiVectorContainer<double, 3, 3> >("v");
  nodeVelocity_ = velocity ? velocity->begin() : NULL;
}

/* ---------------------------------------------------------------------- */

void MeshContacts::index() const
{
  const int n = mesh_->sizeLocal() + mesh_->sizeGhost();
  if (current_ && static_cast<int>(next_.size()) == n) return;
  std::fill(first_.begin(), first_.end(), NONE);
  next_.assign(n, NONE);
  for (int i = n - 1; i >= 0; i--) {
    const int id = mesh_->id(i);
    if (id >= static_cast<int>(first_.size())) first_.resize(id + 1, NONE);
    next_[i] = first_[id];
    first_[id] = i;
  }
  current_ = true;
}

/* ---------------------------------------------------------------------- */

bool MeshContacts::comes_near(int i) const
{
  return owner_->contactHistory()->nneighs(i) > 0;
}

/* ---------------------------------------------------------------------- */

bool MeshContacts::deepest(int i, Contact &touched) const
{
  const FixContactHistoryMesh *contacts = owner_->contactHistory();
  bool found = false;
  const int n = contacts->nneighs(i);
  for (int slot = 0; slot < n; slot++) {
    const int id = contacts->get_partner_idTri(i, slot);
    Contact contact;
    if (id < 0 || !nearest(i, id, contact)) continue;
    if (found && (contact.gap > touched.gap
        || (contact.gap == touched.gap && id > touched.triangle))) continue;
    found = true;
    touched = contact;
  }
  return found;
}

/* ---------------------------------------------------------------------- */

bool MeshContacts::nearest(int i, int triangle, Contact &touched) const
{
  index();
  bool found = false;
  for (int image = element(triangle); image != NONE; image = next_[image]) {
    Contact contact;
    int sign;
    contact.triangle = triangle;
    contact.element = image;
    contact.gap = mesh_->resolveTriSphereContactBary(
      i, image, atom->radius[i], atom->x[i], contact.delta, contact.weights, sign, false);
    if (found && contact.gap >= touched.gap) continue;
    found = true;
    touched = contact;
  }
  return found;
}

/* ----------------------------------------------------------------------
   Equal to the rounding of the distances. Triangles around a corner are reached by way of
   their neighbours.
------------------------------------------------------------------------- */

void MeshContacts::choose_lowest(int i, Contact &touched) const
{
  const double EDGE = 1e-6, SAME = 1e-9 * atom->radius[i];
  const double *w = touched.weights;
  if (std::min(std::min(w[0], w[1]), w[2]) > EDGE) return;

  std::vector<int> seen(1, touched.triangle);
  std::vector<Contact> open(1, touched);
  while (!open.empty()) {
    const Contact from = open.back();
    open.pop_back();
    if (from.triangle < touched.triangle) touched = from;
    for (int n = 0; n < mesh_->nNeighs(from.element); n++) {
      const int id = mesh_->neighFaces(from.element, n);
      if (std::find(seen.begin(), seen.end(), id) != seen.end()) continue;
      seen.push_back(id);
      Contact contact;
      if (nearest(i, id, contact) && contact.gap <= from.gap + SAME) open.push_back(contact);
    }
  }
}

/* ---------------------------------------------------------------------- */

void MeshContacts::velocity(const Contact &contact, double *velocity) const
{
  std::fill_n(velocity, 3, 0.0);
  if (!nodeVelocity_) return;
  double **v = nodeVelocity_[contact.element];
  const double *w = contact.weights;
  for (int dim = 0; dim < 3; dim++)
    velocity[dim] = w[0] * v[0][dim] + w[1] * v[1][dim] + w[2] * v[2][dim];
}

/* ---------------------------------------------------------------------- */

void MeshContacts::normal(const Contact &contact, double *normal) const
{
  mesh_->surfaceNorm(contact.element, normal);
  const double *d = contact.delta;
  if (d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2] <= 0.0) return;
  for (int dim = 0; dim < 3; dim++) normal[dim] = -normal[dim];
}
