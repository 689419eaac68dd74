/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision_tracker.h"

#include "atom.h"
#include "fix_property_atom.h"
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
using grainjet::SlidingPiece;

/* ---------------------------------------------------------------------- */

static double dot(const double *p, const double *q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

// velocity of a grain against the surface
static void against(const double *v, const double *surface, double *relative)
{
  for (int dim = 0; dim < 3; dim++) relative[dim] = v[dim] - surface[dim];
}

/* ---------------------------------------------------------------------- */

CollisionTracker::CollisionTracker(LAMMPS *lmp, WatchedSurface &surface, int groupbit,
  CollisionStore &store) :
  Pointers(lmp), surface_(surface), groupbit_(groupbit), store_(store), start_(0.0),
  sliding_(false), temperature_(NULL), rebuild_(true), thorough_(true), begun_(1 + surface.regions(), 0.0),
  seen_(false), elsewhere_(false)
{
}

/* ---------------------------------------------------------------------- */

bool CollisionTracker::touches(int i, double **forces) const
{
  const double *f = forces[i];
  WatchedSurface::Touch touch;
  return (f[0] != 0.0 || f[1] != 0.0 || f[2] != 0.0) && surface_.touch(i, touch);
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
   Only between runs can a grain be put elsewhere while it touches, or leave the group; then all
   are looked at. The collision of a grain that has left is over without a result, as if it were
   deleted; the sliding that it has done stays.
------------------------------------------------------------------------- */

void CollisionTracker::find_near(double **forces, double time)
{
  const bool look = !elsewhere_ && !seen_;
  surface_.reorder();
  near_.clear();
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit_)) {
      if (thorough_) leave(i, time);
      continue;
    }
    if (surface_.comes_near(i) || (thorough_ && store_.find(i)))
      near_.push_back(i);
    else if (look && (forces[i][0] != 0.0 || forces[i][1] != 0.0 || forces[i][2] != 0.0))
      elsewhere_ = true;
  }
  rebuild_ = thorough_ = false;
}

/* ---------------------------------------------------------------------- */

void CollisionTracker::step(double **forces, double time)
{
  if (rebuild_) find_near(forces, time);
  for (int i : near_) {
    const double *force = forces[0] + 3 * i;    // one block, as all arrays of LIGGGHTS
    const bool pushed = force[0] != 0.0 || force[1] != 0.0 || force[2] != 0.0;
    Collision *c = store_.find(i);
    WatchedSurface::Touch touch;
    if (pushed && surface_.touch(i, touch)) {
      seen_ = true;
      if (!c) {
        c = &begin(i, time, touch);
      } else if (c->workHere > 0.0 && (c->mesh != touch.mesh || c->triangle != touch.triangle)) {
        slid_.push_back(piece(i, *c, time));
        c->workHere = 0.0;
      }
      c->mesh = touch.mesh;
      c->triangle = touch.triangle;
      std::copy_n(touch.velocity, 3, c->surface);
      c->addStep(force, touch.normal, update->dt);
      if (sliding_ && time >= start_) slide(i, force, touch, *c);
    } else if (c) {
      finish(i, time);
    }
  }
}

/* ----------------------------------------------------------------------
   Normal force times speed of sliding in this step. Velocities are those of mid-step; half a
   kick brings them to the moment of the force. The lever is the radius less the overlap,
   which is left out: it is small.
------------------------------------------------------------------------- */

void CollisionTracker::slide(int i, const double *force, const WatchedSurface::Touch &touch,
  Collision &c) const
{
  const double *n = touch.normal, radius = atom->radius[i], mass = atom->rmass[i];
  const double kick = 0.5 * update->dt / mass;
  const double spin = kick / (0.4 * radius * radius);
  double v[3], w[3];
  for (int dim = 0; dim < 3; dim++) {
    v[dim] = atom->v[i][dim] + kick * atom->f[i][dim] - touch.velocity[dim];
    w[dim] = atom->omega[i][dim] + spin * atom->torque[i][dim];
  }
  // of the point at -radius n
  for (int dim = 0; dim < 3; dim++) {
    const int j = (dim + 1) % 3, k = (dim + 2) % 3;
    v[dim] -= radius * (w[j] * n[k] - w[k] * n[j]);
  }
  const double across = dot(v, n);
  const double along = std::sqrt(std::max(dot(v, v) - across * across, 0.0));
  const double work = std::max(dot(force, n), 0.0) * along * update->dt;
  c.slidingWork += work;
  c.workHere += work;
}

/* ---------------------------------------------------------------------- */

SlidingPiece CollisionTracker::piece(int i, const Collision &c, double time) const
{
  return SlidingPiece{time, static_cast<double>(atom->tag[i]), c.mesh, c.triangle, c.workHere};
}

/* ---------------------------------------------------------------------- */

std::vector<SlidingPiece> CollisionTracker::sliding() const
{
  std::vector<SlidingPiece> pieces;
  for (int i = 0; i < atom->nlocal; i++)
    if (const Collision *c = store_.find(i))
      if (c->workHere > 0.0) pieces.push_back(piece(i, *c, 0.0));
  return pieces;
}

/* ---------------------------------------------------------------------- */

double CollisionTracker::kinetic_energy(int i, const double *velocity) const
{
  const double radius = atom->radius[i];
  return 0.5 * atom->rmass[i] * (dot(velocity, velocity)
    + 0.4 * radius * radius * dot(atom->omega[i], atom->omega[i]));
}

/* ----------------------------------------------------------------------
   one more in all and in the collision's region
------------------------------------------------------------------------- */

void CollisionTracker::count(const Collision &c, std::vector<double> &regions) const
{
  const int region = surface_.region(c);
  if (region < 0 || !counts(c)) return;
  regions[0] += 1.0;
  regions[1 + region] += 1.0;
}

/* ---------------------------------------------------------------------- */

Collision &CollisionTracker::begin(int i, double time, const WatchedSurface::Touch &touch)
{
  Collision &c = store_.begin(i);
  c.time = time;
  surface_.place(i, touch, c);
  double v[3];
  against(atom->v[i], touch.velocity, v);
  const double across = dot(v, touch.normal);
  const double square = dot(v, v);
  c.speed = std::sqrt(square);
  c.angle = std::atan2(std::sqrt(std::max(square - across * across, 0.0)), std::fabs(across))
    * 180.0 / MathConst::MY_PI;
  c.energy = kinetic_energy(i, v);
  if (temperature_) c.temperature = temperature_->vector_atom[i];
  count(c, begun_);
  return c;
}

/* ---------------------------------------------------------------------- */

void CollisionTracker::leave(int i, double time)
{
  const Collision *c = store_.find(i);
  if (c && c->workHere > 0.0) slid_.push_back(piece(i, *c, time));
  store_.end(i);
}

/* ----------------------------------------------------------------------
   The surface has gone on since it was touched last: its velocity is that of this step
------------------------------------------------------------------------- */

void CollisionTracker::finish(int i, double time)
{
  const Collision &c = *store_.find(i);
  if (counts(c) && surface_.region(c) >= 0) {
    const double cg = force->cg(atom->type[i]);
    FinishedCollision collision;
    collision.contact = c;
    collision.id = atom->tag[i];
    collision.particles = cg * cg * cg;
    WatchedSurface::Touch last = {static_cast<int>(c.mesh), static_cast<int>(c.triangle), {}, {}};
    double v[3];
    against(atom->v[i], surface_.velocity(i, last) ? last.velocity : c.surface, v);
    collision.speedAfter = std::sqrt(dot(v, v));
    collision.energyAfter = kinetic_energy(i, v);
    collision.mass = atom->rmass[i];
    collision.radius = atom->radius[i];
    finished_.push_back(collision);
  }
  leave(i, time);
}

/* ---------------------------------------------------------------------- */

void CollisionTracker::clear()
{
  finished_.clear();
  slid_.clear();
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
