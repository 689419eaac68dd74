/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision_tracker.h"

#include "atom.h"
#include "force.h"
#include "math_const.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using grainjet::Collision;
using grainjet::CollisionStore;
using grainjet::FinishedCollision;
using grainjet::PlateGeometry;

/* ---------------------------------------------------------------------- */

// velocity of grain i against the surface
static void against(const double *v, const double *surface, double *relative)
{
  for (int dim = 0; dim < 3; dim++) relative[dim] = v[dim] - surface[dim];
}

/* ---------------------------------------------------------------------- */

CollisionTracker::CollisionTracker(LAMMPS *lmp, const PlateGeometry &plate,
  const WallSurface &surface, int groupbit, CollisionStore &store) :
  Pointers(lmp), plate_(plate), surface_(surface), groupbit_(groupbit), store_(store),
  start_(0.0), rebuild_(true), thorough_(true), begun_(1 + plate.rings(), 0.0),
  seen_(false), elsewhere_(false)
{
}

/* ---------------------------------------------------------------------- */

bool CollisionTracker::reaches(int i, int plate) const
{
  return std::fabs(surface_.height(plate, atom->x[i])) < atom->radius[i];
}

/* ---------------------------------------------------------------------- */

bool CollisionTracker::touches(int i, double **forces) const
{
  const double *f = forces[i];
  WallSurface::Touch touch;
  return (f[0] != 0.0 || f[1] != 0.0 || f[2] != 0.0) && surface_.touch(i, touch)
    && reaches(i, touch.mesh);
}

/* ---------------------------------------------------------------------- */

void CollisionTracker::skip_present(double **forces)
{
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit_) && touches(i, forces)) {
      store_.end(i);
      Collision &c = store_.begin(i);
      c.steps = 1.0;
      c.time = -1.0;
    }
}

/* ----------------------------------------------------------------------
   The wall's own neighbour lists rest on the same margin: until the next rebuild neither
   grain nor mesh moves by more than the skin.
------------------------------------------------------------------------- */

bool CollisionTracker::comes_near(int i) const
{
  for (int plate = 0; plate < surface_.plates(); plate++) {
    if (!surface_.bears(plate)) continue;
    const double margin = surface_.carried(plate) ? 2 * neighbor->skin : neighbor->skin;
    if (std::fabs(surface_.height(plate, atom->x[i])) < atom->radius[i] + margin) return true;
  }
  return false;
}

/* ----------------------------------------------------------------------
   Only between runs can a grain be put elsewhere while it touches; then all are looked at.
------------------------------------------------------------------------- */

void CollisionTracker::find_near(double **forces)
{
  const bool look = !elsewhere_ && !seen_;
  near_.clear();
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit_)) continue;
    if (comes_near(i) || (thorough_ && store_.find(i)))
      near_.push_back(i);
    else if (look && (forces[i][0] != 0.0 || forces[i][1] != 0.0 || forces[i][2] != 0.0))
      elsewhere_ = true;
  }
  rebuild_ = thorough_ = false;
}

/* ---------------------------------------------------------------------- */

void CollisionTracker::step(double **forces, double time)
{
  if (rebuild_) find_near(forces);
  for (int i : near_) {
    const double *force = forces[0] + 3 * i;    // one block, as all arrays of LIGGGHTS
    const bool pushed = force[0] != 0.0 || force[1] != 0.0 || force[2] != 0.0;
    Collision *c = store_.find(i);
    WallSurface::Touch touch;
    if (pushed && surface_.touch(i, touch) && reaches(i, touch.mesh)) {
      seen_ = true;
      if (!c) c = &begin(i, time, touch);
      c->mesh = touch.mesh;
      c->triangle = touch.triangle;
      double normal[3];
      const double side = surface_.height(touch.mesh, atom->x[i]) < 0.0 ? -1.0 : 1.0;
      for (int dim = 0; dim < 3; dim++) {
        c->surface[dim] = touch.velocity[dim];
        normal[dim] = side * surface_.normal(touch.mesh)[dim];
      }
      c->addStep(force, normal, update->dt);
    } else if (c) {
      finish(i);
    }
  }
}

/* ---------------------------------------------------------------------- */

double CollisionTracker::kinetic_energy(int i, const double *velocity) const
{
  const double radius = atom->radius[i];
  return 0.5 * atom->rmass[i] * (PlateGeometry::dot(velocity, velocity)
    + 0.4 * radius * radius * PlateGeometry::dot(atom->omega[i], atom->omega[i]));
}

/* ----------------------------------------------------------------------
   one more in the whole plate and in the collision's ring
------------------------------------------------------------------------- */

void CollisionTracker::count(const Collision &c, std::vector<double> &regions) const
{
  const double place[2] = {c.a, c.b};
  const int ring = plate_.ring(place);
  if (ring < 0 || !counts(c)) return;
  regions[0] += 1.0;
  regions[1 + ring] += 1.0;
}

/* ---------------------------------------------------------------------- */

Collision &CollisionTracker::begin(int i, double time, const WallSurface::Touch &touch)
{
  Collision &c = store_.begin(i);
  c.time = time;
  surface_.project(touch.mesh, atom->x[i], &c.a);
  double v[3];
  against(atom->v[i], touch.velocity, v);
  const double across = PlateGeometry::dot(v, surface_.normal(touch.mesh));
  const double square = PlateGeometry::dot(v, v);
  c.speed = std::sqrt(square);
  c.angle = std::atan2(std::sqrt(std::max(square - across * across, 0.0)), std::fabs(across))
    * 180.0 / MathConst::MY_PI;
  c.energy = kinetic_energy(i, v);
  count(c, begun_);
  return c;
}

/* ----------------------------------------------------------------------
   The surface has gone on since it was touched last: its velocity is that of this step
------------------------------------------------------------------------- */

void CollisionTracker::finish(int i)
{
  const Collision &c = *store_.find(i);
  const double place[2] = {c.a, c.b};
  if (counts(c) && plate_.ring(place) >= 0) {
    const double cg = force->cg(atom->type[i]);
    FinishedCollision collision;
    collision.contact = c;
    collision.id = atom->tag[i];
    collision.particles = cg * cg * cg;
    WallSurface::Touch last = {static_cast<int>(c.mesh), static_cast<int>(c.triangle), {}};
    double v[3];
    against(atom->v[i], surface_.velocity(i, last) ? last.velocity : c.surface, v);
    collision.speedAfter = std::sqrt(PlateGeometry::dot(v, v));
    collision.energyAfter = kinetic_energy(i, v);
    finished_.push_back(collision);
  }
  store_.end(i);
}

/* ---------------------------------------------------------------------- */

void CollisionTracker::clear()
{
  finished_.clear();
  begun_.assign(begun_.size(), 0.0);
}

/* ---------------------------------------------------------------------- */

std::vector<double> CollisionTracker::touching() const
{
  std::vector<double> regions(begun_.size(), 0.0);
  for (int i = 0; i < atom->nlocal; i++)
    if (const Collision *c = store_.find(i)) count(*c, regions);
  return regions;
}
