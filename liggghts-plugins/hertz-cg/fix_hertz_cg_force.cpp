/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix hertz/cg: the loop over pairs and the force of a contact */

#include "hertz-cg/fix_hertz_cg.h"
#include "hertz-cg/kinematics.h"
#include "hertz-cg/pair_hertz_cg.h"
#include "physics/contact/contact_law.h"

#include "atom.h"
#include "force.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace LAMMPS_NS;
using namespace grainjet;
using contact::Tangential;
using contact::Vector3;

// the host's arrays, fetched once per step
struct FixHertzCg::Grains {
  double **x, **v, **f, **omega, **torque;
  const double *radius, *rmass;
  const int *type, *mask, *tag;
  int nlocal;
  double dt;
  bool told;         // somebody asks the pair style for every contact
  bool watched;      // that, or there are observers

  Grains(Atom *atom, double step, bool tell, bool observe)
    : x(atom->x), v(atom->v), f(atom->f), omega(atom->omega), torque(atom->torque),
      radius(atom->radius), rmass(atom->rmass), type(atom->type), mask(atom->mask),
      tag(atom->tag), nlocal(atom->nlocal), dt(step), told(tell), watched(tell || observe) {}

  // a pair across ranks is computed on both; each counts it once in two, or by IDs
  double share(int j) const { return j < nlocal ? 1.0 : 0.5; }
  bool counts(int i, int j) const { return j < nlocal || tag[i] < tag[j]; }
};

static inline void add(double *a, const Vector3 &b)
{
  a[0] += b.x;
  a[1] += b.y;
  a[2] += b.z;
}

/* ----------------------------------------------------------------------
   `run ... pre no` after grains were created or deleted comes without a search
------------------------------------------------------------------------- */

void FixHertzCg::setup_pre_force(int)
{
  int missing = !pairs_valid_;
  MPI_Allreduce(MPI_IN_PLACE, &missing, 1, MPI_INT, MPI_MAX, world);
  if (missing) search();
}

/* ----------------------------------------------------------------------
   Called where the host computes its pair style. Before the first step springs are left alone (advance
   is not set), as the stock pair style does. After a restart file written in the middle of a run the
   first forces are those of the file.
------------------------------------------------------------------------- */

void FixHertzCg::compute(bool advance)
{
  const bool again = forces_restarted_ && !advance;
  store_current_ = false;
  const bool extras = !law_.plain();
  if (law_.tangential != Tangential::OFF) {
    if (extras) compute_pairs<true, true>(advance, again);
    else compute_pairs<true, false>(advance, again);
  } else {
    if (extras) compute_pairs<false, true>(advance, again);
    else compute_pairs<false, false>(advance, again);
  }
  if (!advance) report_failure();
}

/* ---------------------------------------------------------------------- */

template <bool TANGENTIAL, bool EXTRAS>
void FixHertzCg::compute_pairs(bool advance, bool again)
{
  const Grains g(atom, update->dt, stand_in_->watched(), observers_.any());
  const std::size_t n = pairs_.size();
  if (n == 0) return;
  if (grows_)
    for (ContactPairs::Pair &pair : pairs_.pairs) {
      const double sum = g.radius[pair.i] + g.radius[pair.j];
      pair.reach2 = sum * sum;
    }
  const double *x = g.x[0];
  for (std::size_t p = 0; p < n; ++p) {
    // grains of a pair lie anywhere in memory; pairs to come are fetched ahead
    const ContactPairs::Pair &ahead = pairs_.pairs[std::min(p + 16, n - 1)];
    __builtin_prefetch(x + 3 * ahead.i);
    __builtin_prefetch(x + 3 * ahead.j);
    const ContactPairs::Pair &pair = pairs_.pairs[p];
    const double *xi = x + 3 * pair.i, *xj = x + 3 * pair.j;
    const double dx = xi[0] - xj[0], dy = xi[1] - xj[1], dz = xi[2] - xj[2];
    const double rsq = dx * dx + dy * dy + dz * dz;
    if (rsq < pair.reach2) compute_contact<TANGENTIAL, EXTRAS>(g, p, rsq, advance, again);
    else if (pairs_.marks[p]) end_contact(g, p, advance);
  }
}

/* ----------------------------------------------------------------------
   the law, for the particles the two grains stand for, and back
------------------------------------------------------------------------- */

struct FixHertzCg::Evaluated {
  contact::Geometry particle;
  contact::Spheres spheres;         // of the particles; only where more than the plain law asks for them
  contact::Stiffness stiffness;
  contact::Springs springs;         // of the particles, as they are now
  Vector3 force, twist, rolling;    // of the grains, as in Contact
};

template <bool TANGENTIAL, bool EXTRAS, class K>
inline FixHertzCg::Evaluated FixHertzCg::evaluate(const Grains &g, const K &k, int i, int j, const Contact &c,
                                                  bool advance) const
{
  contact::Geometry grain;
  grain.overlap = k.overlap;
  grain.radius = g.radius[i] * g.radius[j] / (g.radius[i] + g.radius[j]);
  if (g.mask[i] & freeze_bit_) grain.mass = g.rmass[j];
  else if (g.mask[j] & freeze_bit_) grain.mass = g.rmass[i];
  else grain.mass = g.rmass[i] * g.rmass[j] / (g.rmass[i] + g.rmass[j]);

  const MaterialTable::Entry &m = materials_(g.type[i], g.type[j]);
  const double dt = g.dt / m.scale.factor();
  Evaluated e;
  e.particle = m.scale.particle(grain);
  e.stiffness = contact::stiffness(m.material, e.particle);
  e.springs.tangential = m.scale.particleSpring(c.spring);
  if (TANGENTIAL && advance) contact::advanceSpring(e.springs.tangential, k.normal, k.vt, dt);

  contact::Force f;
  if (EXTRAS) {
    e.springs.rolling = m.scale.particleTorque(c.rollingSpring);
    e.spheres = m.scale.particles({g.radius[i], g.radius[j], g.rmass[i], g.rmass[j]});
    const contact::Motion motion = {k.normal, k.vn, k.vt, m.scale.particleRotation(k.turning), dt};
    const contact::Load load = contact::contactLoad(m.material, law_, e.stiffness, e.particle, e.spheres, motion,
                                                    e.springs, advance);
    f = m.scale.grainForce(load.force);
    e.rolling = m.scale.grainTorque(load.rolling);
  } else {
    f = {contact::normalForce(e.stiffness, e.particle.overlap, k.vn), {0.0, 0.0, 0.0}};
    if (TANGENTIAL)
      f = contact::hertzMindlin(m.material, e.stiffness, e.particle.overlap, k.vn, k.vt, e.springs.tangential, advance);
    f = m.scale.grainForce(f);
    e.rolling = e.springs.rolling = {0.0, 0.0, 0.0};
  }
  e.force = f.normal * k.normal + f.tangential;
  e.twist = contact::cross(k.normal, f.tangential);
  return e;
}

/* ----------------------------------------------------------------------
   a contact as the host's pair style tells of it
------------------------------------------------------------------------- */

static inline void put(double *a, const Vector3 &b)
{
  a[0] = b.x;
  a[1] = b.y;
  a[2] = b.z;
}

template <class K>
static PairHertzCg::Contact told(const K &k, int i, int j, const Vector3 &force, const Vector3 &twist,
                                 const Vector3 &rolling)
{
  PairHertzCg::Contact c;
  c.i = i;
  c.j = j;
  put(c.force, force);
  put(c.torqueI, rolling - k.armI * twist);
  put(c.torqueJ, -1.0 * rolling - k.armJ * twist);
  put(c.normal, k.normal);
  put(c.delta, k.delta);
  return c;
}

/* ---------------------------------------------------------------------- */

template <bool TANGENTIAL, bool EXTRAS>
void FixHertzCg::compute_contact(const Grains &g, std::size_t p, double rsq, bool advance, bool again)
{
  const int i = pairs_.pairs[p].i, j = pairs_.pairs[p].j;
  Contact &c = pairs_.contacts[p];
  if (rsq == 0.0) return fail_contact(g, p, "have the same centre");

  const MaterialTable::Entry &m = materials_(g.type[i], g.type[j]);
  if (m.mixed)
    return fail_contact(g, p, "touch, but their types have different coarse-graining factors; "
                              "the law between them is not defined");

  const Kinematics k(g, i, j, std::sqrt(rsq));
  const double depth = k.overlap / std::min(g.radius[i], g.radius[j]);
  const bool found = !(pairs_.marks[p] & ContactPairs::TOUCHING);
  if (found || depth > deepest_) begin_contact(g, p, depth);
  else if (depth > overlap_fraction_ && !(pairs_.marks[p] & ContactPairs::DEEP)) begin_contact(g, p, depth);

  Evaluated e = evaluate<TANGENTIAL, EXTRAS>(g, k, i, j, c, advance);
  // contacts that the file does not know were made since
  if (again && !found) {
    e.force = c.force;
    e.twist = c.twist;
    e.rolling = c.rolling;
  }

  double work = 0.0;
  if (advance) {
    // over the step, by the mean of the forces at its two ends
    work = 0.5 * g.dt * k.power(c.force + e.force, c.twist + e.twist, c.rolling + e.rolling);
    work_ += g.share(j) * work;
    c.spring = m.scale.grainSpring(e.springs.tangential);
    if (EXTRAS) c.rollingSpring = m.scale.grainTorque(e.springs.rolling);
  } else if (found) {
    const double energy = EXTRAS
      ? contact::contactEnergy(m.material, law_, e.stiffness, e.particle, e.spheres, e.springs)
      : contact::elasticEnergy(e.stiffness, e.particle.overlap, e.springs.tangential);
    found_ += g.share(j) * m.scale.grainEnergy(energy);
  }
  c.force = e.force;
  c.twist = e.twist;
  c.rolling = e.rolling;
  if (g.watched) {
    if (g.told) stand_in_->tell(told(k, i, j, e.force, e.twist, e.rolling));
    observe_contact(k, p, work, found, advance);
  }

  add(g.f[i], e.force);
  if (TANGENTIAL) add(g.torque[i], -k.armI * e.twist);
  if (EXTRAS) add(g.torque[i], e.rolling);
  if (j >= g.nlocal) return;
  add(g.f[j], -1.0 * e.force);
  if (TANGENTIAL) add(g.torque[j], -k.armJ * e.twist);
  if (EXTRAS) add(g.torque[j], -1.0 * e.rolling);
}

/* ----------------------------------------------------------------------
   for compute pair/gran/local: contacts with the positions and velocities of the end of the step, in the
   order of the list that it goes through; nothing moves on
------------------------------------------------------------------------- */

void FixHertzCg::tell_contacts()
{
  const Grains g(atom, update->dt, false, false);
  for (const int p : stand_in_->order()) {
    const int i = pairs_.pairs[p].i, j = pairs_.pairs[p].j;
    const double distance = contact::length(vector(g.x[i]) - vector(g.x[j]));
    if (distance * distance >= pairs_.pairs[p].reach2 || distance == 0.0) continue;
    const Vector3 zero = {0.0, 0.0, 0.0};
    const Contact none = {zero, zero, zero, zero, zero};
    const Contact &c = pairs_.marks[p] & ContactPairs::TOUCHING ? pairs_.contacts[p] : none;
    const Kinematics k(g, i, j, distance);
    const Evaluated e = law_.tangential != Tangential::OFF ? evaluate<true, true>(g, k, i, j, c, false)
                                                           : evaluate<false, true>(g, k, i, j, c, false);
    PairHertzCg::Contact contact = told(k, i, j, e.force, e.twist, e.rolling);
    double *history = contact.history;
    if (law_.tangential == Tangential::HISTORY) {
      put(history, c.spring);
      history += 3;
    }
    put(history, -1.0 * c.rollingSpring);    // the host keeps the torque with the other sign
    stand_in_->tell_local(contact);
  }
}

/* ----------------------------------------------------------------------
   a contact begins, or is deeper than any before, or than what is reported
------------------------------------------------------------------------- */

void FixHertzCg::begin_contact(const Grains &g, std::size_t p, double depth)
{
  const int i = pairs_.pairs[p].i, j = pairs_.pairs[p].j;
  const bool counts = g.counts(i, j);
  deepest_ = std::max(deepest_, depth);
  if (!(pairs_.marks[p] & ContactPairs::TOUCHING)) {
    const Vector3 zero = {0.0, 0.0, 0.0};
    pairs_.contacts[p] = {zero, zero, zero, zero, zero};
    pairs_.clearRow(p);
    pairs_.marks[p] |= ContactPairs::TOUCHING;
    if (counts) collisions_ += 1.0;
  }
  if (depth > overlap_fraction_ && !(pairs_.marks[p] & ContactPairs::DEEP)) {
    pairs_.marks[p] |= ContactPairs::DEEP;
    if (counts) deep_ += 1.0;
  }
}

/* ----------------------------------------------------------------------
   the two have parted: over this step the force fell to nothing
------------------------------------------------------------------------- */

void FixHertzCg::end_contact(const Grains &g, std::size_t p, bool advance)
{
  const int i = pairs_.pairs[p].i, j = pairs_.pairs[p].j;
  const Contact &c = pairs_.contacts[p];
  pairs_.marks[p] = 0;
  if (!advance) return;
  const Vector3 delta = vector(g.x[i]) - vector(g.x[j]);
  const Kinematics k(g, i, j, contact::length(delta));
  const double work = 0.5 * g.dt * k.power(c.force, c.twist, c.rolling);
  work_ += g.share(j) * work;
  if (observers_.any()) observe_contact(k, p, work, false, true);
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::fail_contact(const Grains &g, std::size_t p, const char *why)
{
  const int i = pairs_.pairs[p].i, j = pairs_.pairs[p].j;
  std::ostringstream message;
  message << "grains " << g.tag[i] << " (type " << g.type[i] << ", f_cg " << force->cg(g.type[i]) << ") and "
          << g.tag[j] << " (type " << g.type[j] << ", f_cg " << force->cg(g.type[j]) << ") " << why;
  fail(message.str());
}

/* ---------------------------------------------------------------------- */

double FixHertzCg::elastic_energy() const
{
  const Grains g(atom, update->dt, false, false);
  double energy = 0.0;
  if (!pairs_valid_) return energy;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (!(pairs_.marks[p] & ContactPairs::TOUCHING)) continue;
    const int i = pairs_.pairs[p].i, j = pairs_.pairs[p].j;
    const double distance = contact::length(vector(g.x[i]) - vector(g.x[j]));
    contact::Geometry grain;
    grain.overlap = g.radius[i] + g.radius[j] - distance;
    if (grain.overlap <= 0.0) continue;
    grain.radius = g.radius[i] * g.radius[j] / (g.radius[i] + g.radius[j]);
    grain.mass = 0.0;    // no damping in it
    const MaterialTable::Entry &m = materials_(g.type[i], g.type[j]);
    const contact::Geometry particle = m.scale.particle(grain);
    const Contact &c = pairs_.contacts[p];
    energy += g.share(j) * m.scale.grainEnergy(contact::contactEnergy(
      m.material, law_, contact::stiffness(m.material, particle), particle,
      m.scale.particles({g.radius[i], g.radius[j], g.rmass[i], g.rmass[j]}),
      {m.scale.particleSpring(c.spring), m.scale.particleTorque(c.rollingSpring)}));
  }
  return energy;
}
