/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "wall_surface.h"

#include "triangle.h"
#include "wall_shear.h"

#include "atom.h"
#include "domain.h"
#include "fix_wall_gran.h"
#include "modify.h"
#include "neighbor.h"
#include "tri_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;
using grainjet::Collision;
using grainjet::PlateGeometry;

// a vector of the mesh as a whole, as the reference points of fix move/mesh are
typedef VectorContainer<double, 3> MeshVector;

/* ---------------------------------------------------------------------- */

WallSurface::WallSurface(LAMMPS *lmp, const std::string &wallID, const std::string &fixID,
  const PlateGeometry &plate) :
  Pointers(lmp), wallID_(wallID), prefix_("plate_" + fixID), plate_(plate), wall_(NULL),
  moves_(false), plates_(1, plate), carried_(1, 0), bears_(1, 1), attached_(false)
{
  for (int dim = 0; dim < 3; dim++) {
    drawn_[dim] = plate.centre()[dim];
    drawn_[3 + dim] = plate.normal()[dim];
    drawn_[6 + dim] = plate.a()[dim];
  }
}

/* ---------------------------------------------------------------------- */

TriMesh *WallSurface::mesh(int m) const
{
  return meshes_[m]->triMesh();
}

/* ---------------------------------------------------------------------- */

std::string WallSurface::property(int axis) const
{
  static const char *const names[] = {"_centre", "_normal", "_axis"};
  return prefix_ + names[axis];
}

/* ---------------------------------------------------------------------- */

std::string WallSurface::attach()
{
  wall_ = dynamic_cast<FixWallGran *>(modify->fix[modify->find_fix(wallID_.c_str())]);
  if (!wall_) return "wall '" + wallID_ + "' is not the ID of a fix wall/gran defined before";
  meshes_.clear();
  if (wall_->is_mesh_wall())
    meshes_.assign(wall_->mesh_list(), wall_->mesh_list() + wall_->n_meshes());
  const std::size_t n = std::max<std::size_t>(meshes_.size(), 1);
  plates_.assign(n, plate_);
  carried_.assign(n, 0);
  bears_.assign(n, 1);
  contacts_.clear();
  for (FixMeshSurface *mesh : meshes_) contacts_.emplace_back(lmp, mesh);

  const std::string fault = check_restarted();
  if (!fault.empty()) return fault;
  const std::vector<Drawing> before = drawings_;
  drawings_.resize(meshes_.size());
  for (std::size_t m = 0; m < meshes_.size(); m++) {
    drawings_[m].level = -1.0;
    for (const Drawing &known : before)
      if (known.meshID == meshes_[m]->id) drawings_[m].level = known.level;
    draw(m);
  }
  attached_ = true;
  restarted_.clear();
  update();
  choose_bearers();
  return "";
}

/* ----------------------------------------------------------------------
   Meshes that go on from a restart file are where their drawings are. A mesh of another
   name or kind is read anew and lies where it was at first.
------------------------------------------------------------------------- */

std::string WallSurface::check_restarted() const
{
  for (std::size_t r = 0; r < restarted_.size(); r++) {
    const Drawing &drawing = restarted_[r];
    if (std::equal(drawing.frame, drawing.frame + FRAME, drawn_)) continue;
    const bool here = r < meshes_.size() && drawing.meshID == meshes_[r]->id;
    if (!here || !modify->have_restart_data(meshes_[r]))
      return "in the restart file the plate has gone along with mesh '" + drawing.meshID
        + "' of wall '" + wallID_ + "', which is not continued here; use the same meshes in "
        "the same order, or another fix ID";
  }
  return "";
}

/* ---------------------------------------------------------------------- */

void WallSurface::draw(int m)
{
  drawings_[m].meshID = meshes_[m]->id;
  const double *frame = drawn_;
  for (const Drawing &drawing : restarted_)
    if (drawing.meshID == meshes_[m]->id) {
      frame = drawing.frame;
      drawings_[m].level = drawing.level;
    }
  if (drawings_[m].level < 0.0) drawings_[m].level = level(m);
  // the centre is a point, the others are directions
  static const char *const frames[] =
    {"frame_general", "frame_scale_trans_invariant", "frame_scale_trans_invariant"};
  for (int axis = 0; axis < 3; axis++) {
    const std::string name = property(axis);
    const bool there = mesh(m)->prop().getGlobalProperty<MeshVector>(name.c_str());
    if (there && attached_) continue;
    double start[3];
    std::copy_n(frame + 3 * axis, 3, start);
    if (!there)
      mesh(m)->prop().addGlobalProperty<MeshVector>(
        name.c_str(), "comm_none", frames[axis], "restart_no");
    mesh(m)->prop().setGlobalProperty<MeshVector>(name.c_str(), start);
  }
}

/* ----------------------------------------------------------------------
   Height of the point of the mesh that is nearest to the centre; none if that is not in
   the plate. Before its first run each rank has the whole mesh, later its part.
------------------------------------------------------------------------- */

double WallSurface::level(int m) const
{
  double best = std::numeric_limits<double>::max(), mine = best, distance = best;
  for (int i = 0; i < mesh(m)->sizeLocal(); i++) {
    double corner[3][3], point[3], ab[2];
    for (int node = 0; node < 3; node++) mesh(m)->node(i, node, corner[node]);
    const double square = grainjet::nearestOnTriangle(corner, plate_.centre(), point);
    if (square >= distance) continue;
    distance = square;
    plate_.project(point, ab);
    mine = plate_.ring(ab) < 0 ? best : std::fabs(plate_.height(point));
  }
  double nearest;
  MPI_Allreduce(&distance, &nearest, 1, MPI_DOUBLE, MPI_MIN, world);
  if (distance > nearest) mine = best;
  MPI_Allreduce(&mine, &best, 1, MPI_DOUBLE, MPI_MIN, world);
  return best;
}

/* ----------------------------------------------------------------------
   Meshes at rest are one body, each of the others is one. Meshes that lie in the plate's
   plane do so to the digits of their files.
------------------------------------------------------------------------- */

void WallSurface::choose_bearers()
{
  if (meshes_.empty()) return;
  const double margin = 1e-4 * plate_.radius();
  double best = std::numeric_limits<double>::max(), rest = best;
  for (std::size_t m = 0; m < meshes_.size(); m++) {
    best = std::min(best, drawings_[m].level);
    if (!carried_[m]) rest = std::min(rest, drawings_[m].level);
  }
  for (std::size_t m = 0; m < meshes_.size(); m++)
    bears_[m] = (carried_[m] ? drawings_[m].level : rest) - best <= margin;
}

/* ----------------------------------------------------------------------
   by name: the wall and its meshes may be gone already
------------------------------------------------------------------------- */

void WallSurface::release()
{
  for (const Drawing &drawing : drawings_) {
    const int ifix = modify->find_fix(drawing.meshID.c_str());
    FixMeshSurface *owner =
      ifix < 0 ? NULL : dynamic_cast<FixMeshSurface *>(modify->fix[ifix]);
    if (!owner) continue;
    for (int axis = 0; axis < 3; axis++) {
      const std::string name = property(axis);
      if (owner->triMesh()->prop().getGlobalProperty<MeshVector>(name.c_str()))
        owner->triMesh()->prop().removeGlobalProperty(name.c_str());
    }
  }
  drawings_.clear();
}

/* ---------------------------------------------------------------------- */

void WallSurface::update()
{
  moves_ = meshes_.empty() && wall_shears(wall_);
  for (std::size_t m = 0; m < meshes_.size(); m++) {
    CustomValueTracker &properties = mesh(m)->prop();
    double *frame = drawings_[m].frame;
    for (int axis = 0; axis < 3; axis++)
      properties.getGlobalProperty<MeshVector>(property(axis).c_str())->get(0, frame + 3 * axis);
    const bool displaced = !std::equal(frame, frame + FRAME, drawn_);
    if (displaced) plates_[m].carry(frame, frame + 3, frame + 6);
    else plates_[m] = plate_;
    carried_[m] = displaced || mesh(m)->isMoving();

    contacts_[m].update();
    moves_ = moves_ || carried_[m] || contacts_[m].has_velocity();
  }
}

/* ----------------------------------------------------------------------
   A plate that moves leaves a periodic box on one side and comes back on the other, in
   pieces: x as seen from the nearest image of its centre.
------------------------------------------------------------------------- */

const double *WallSurface::image(int plate, const double *x, double *copy) const
{
  if (!carried_[plate] || !(domain->xperiodic || domain->yperiodic || domain->zperiodic))
    return x;
  const int periodic[3] = {domain->xperiodic, domain->yperiodic, domain->zperiodic};
  for (int dim = 0; dim < 3; dim++) {
    copy[dim] = x[dim];
    if (!periodic[dim]) continue;
    const double away = x[dim] - plates_[plate].centre()[dim];
    copy[dim] -= domain->prd[dim] * std::round(away / domain->prd[dim]);
  }
  return copy;
}

/* ---------------------------------------------------------------------- */

double WallSurface::height(int plate, const double *x) const
{
  double copy[3];
  return plates_[plate].height(image(plate, x, copy));
}

/* ---------------------------------------------------------------------- */

void WallSurface::reorder()
{
  for (MeshContacts &contacts : contacts_) contacts.reorder();
}

/* ----------------------------------------------------------------------
   The wall's own neighbour lists rest on the same margin: until the next rebuild neither
   grain nor mesh moves by more than the skin. A wall at rest has one plate.
------------------------------------------------------------------------- */

bool WallSurface::comes_near(int i) const
{
  const int plates = moves_ ? static_cast<int>(plates_.size()) : 1;
  for (int plate = 0; plate < plates; plate++) {
    if (!bears_[plate]) continue;
    const double margin = carried_[plate] ? 2 * neighbor->skin : neighbor->skin;
    if (std::fabs(height(plate, atom->x[i])) < atom->radius[i] + margin) return true;
  }
  return false;
}

/* ---------------------------------------------------------------------- */

void WallSurface::place(int i, const Touch &touch, Collision &collision) const
{
  double copy[3];
  plates_[touch.mesh].project(image(touch.mesh, atom->x[i], copy), &collision.a);
}

/* ---------------------------------------------------------------------- */

int WallSurface::region(const Collision &collision) const
{
  const double place[2] = {collision.a, collision.b};
  return plate_.ring(place);
}

/* ---------------------------------------------------------------------- */

bool WallSurface::touch(int i, Touch &touch) const
{
  if (!touched(i, touch)) return false;
  const double height = this->height(touch.mesh, atom->x[i]);
  if (!(std::fabs(height) < atom->radius[i])) return false;
  const double side = height < 0.0 ? -1.0 : 1.0;
  for (int dim = 0; dim < 3; dim++) touch.normal[dim] = side * plates_[touch.mesh].normal()[dim];
  return true;
}

/* ----------------------------------------------------------------------
   Of several triangles the one that the grain has entered deepest.
------------------------------------------------------------------------- */

bool WallSurface::touched(int i, Touch &touch) const
{
  touch = Touch{0, -1, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  if (!moves_) return true;
  if (meshes_.empty()) {
    wall_shear(wall_, atom->x[i], touch.velocity);
    return true;
  }
  int mesh = -1;
  MeshContacts::Contact contact, deepest;
  for (std::size_t m = 0; m < meshes_.size(); m++) {
    if (!bears_[m] || !contacts_[m].deepest(i, contact)) continue;
    if (mesh >= 0 && contact.gap >= deepest.gap) continue;
    mesh = m;
    deepest = contact;
  }
  if (mesh < 0) return false;
  touch.mesh = mesh;
  touch.triangle = deepest.triangle;
  contacts_[mesh].velocity(deepest, touch.velocity);
  return true;
}

/* ---------------------------------------------------------------------- */

bool WallSurface::velocity(int i, Touch &touch) const
{
  std::fill_n(touch.velocity, 3, 0.0);
  if (!moves_) return true;
  if (meshes_.empty()) {
    wall_shear(wall_, atom->x[i], touch.velocity);
    return true;
  }
  MeshContacts::Contact contact;
  if (touch.mesh >= static_cast<int>(meshes_.size())
      || !contacts_[touch.mesh].nearest(i, touch.triangle, contact)) return false;
  contacts_[touch.mesh].velocity(contact, touch.velocity);
  return true;
}

/* ---------------------------------------------------------------------- */

std::vector<double> WallSurface::pack() const
{
  std::vector<double> list(1, drawings_.size());
  for (const Drawing &drawing : drawings_) {
    list.push_back(drawing.meshID.size());
    list.insert(list.end(), drawing.meshID.begin(), drawing.meshID.end());
    list.push_back(drawing.level);
    list.insert(list.end(), drawing.frame, drawing.frame + FRAME);
  }
  return list;
}

/* ---------------------------------------------------------------------- */

int WallSurface::unpack(const double *list)
{
  const double *next = list;
  restarted_.resize(static_cast<std::size_t>(*next++));
  for (Drawing &drawing : restarted_) {
    const int length = static_cast<int>(*next++);
    drawing.meshID.assign(next, next + length);
    next += length;
    drawing.level = *next++;
    std::copy_n(next, FRAME, drawing.frame);
    next += FRAME;
  }
  return next - list;
}
