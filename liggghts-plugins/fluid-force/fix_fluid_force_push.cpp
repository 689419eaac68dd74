/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* The loops of fix fluid/force over the grains, once per DEM step. */

#include "fix_fluid_force.h"

#include "physics/drag/exponential_drag.h"

#include "atom.h"
#include "fix_property_atom.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;
using grainjet::drag::ExponentialDrag;

/* ----------------------------------------------------------------------
   Forces. Returns whether one is no number or far too large.

   The drag of both kinds is integrated as one, since each would change the velocity that the
   other sees. With forces of one kind only, nothing at all is booked for the other.

   With an added mass m_a, M = m + m_a, the kick is that of M dv/dt = R + W + f: R and W the
   fluid's other forces with and without reaction, f all other forces. The integrator divides
   by m, so what is added to f is m dv/dt - f = (m/M)(R + W) - (m_a/M) f. This is all that the
   fluid gives to the grain, R + W - m_a dv/dt; the reaction is to all of it but W.
------------------------------------------------------------------------- */

template<bool UNIFORM, bool NON_REACTING, bool ADDED_MASS>
bool FixFluidForce::push(double kick, bool remove, bool book)
{
  const int nlocal = atom->nlocal;
  const double half = 0.5 * update->dt;
  double buoyancy[3];
  if (UNIFORM) uniform_->buoyancy(buoyancy);

  // The loop is bound by memory. LIGGGHTS' arrays of vectors are one block each, so their
  // rows need not be looked up.
  const double *velocities = atom->v[0];
  const double *fluids = UNIFORM ? NULL : fluidVelocity_->array_atom[0];
  const double *explicits = UNIFORM ? NULL : explicitForce_->array_atom[0];
  double *coefficient = dragCoefficient_->vector_atom;
  const double *nonReactingCoefficient = NON_REACTING ? nonReactingCoefficient_->vector_atom : NULL;
  const double *addedMasses = ADDED_MASS && !UNIFORM ? addedMass_->vector_atom : NULL;
  bool wrong = false;

  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const int first = 3 * i;
    double *f = atom->f[0] + first;
    double *applied = fluidForce_->array_atom[0] + first;
    double *impulse = impulse_->array_atom[0] + first;
    double *nonReactingApplied = NON_REACTING ? nonReactingApplied_->array_atom[0] + first : NULL;
    double *nonReactingImpulse = NON_REACTING ? nonReactingImpulse_->array_atom[0] + first : NULL;
    if (held_.holds(i)) {
      applied[0] = applied[1] = applied[2] = 0.0;
      if (NON_REACTING) nonReactingApplied[0] = nonReactingApplied[1] = nonReactingApplied[2] = 0.0;
      continue;
    }
    const double *v = velocities + first;
    const double *fluid = UNIFORM ? uniform_->velocity() : fluids + first;
    const double *nonReacting = NON_REACTING ? nonReactingForce_->array_atom[0] + first : NULL;

    const double volume = UNIFORM ? UniformFlow::volume(atom->radius[i]) : 0.0;
    const double mass = atom->rmass[i];
    const double addedMass = !ADDED_MASS ? 0.0 : UNIFORM ? uniform_->addedMass(volume) : addedMasses[i];
    const double inertia = ADDED_MASS ? mass + addedMass : mass;
    const double own = mass / inertia, takenUp = addedMass / inertia;
    double given[3], other[3];
    for (int dim = 0; dim < 3; dim++) {
      if (remove) f[dim] -= applied[dim];
      given[dim] = UNIFORM ? buoyancy[dim] * volume : explicits[first + dim];
      other[dim] = f[dim] + (NON_REACTING ? given[dim] + nonReacting[dim] : given[dim]);
    }
    if (UNIFORM && uniform_->magnus()) {
      double lift[3];
      uniform_->lift(i, other, kick, book ? coefficient[i] : 0.0, inertia, lift);
      for (int dim = 0; dim < 3; dim++) {
        given[dim] += lift[dim];
        other[dim] += lift[dim];
      }
    }
    if (UNIFORM)
      coefficient[i] =
        uniform_->dragCoefficient(i, other, kick, book ? coefficient[i] : 0.0, inertia);

    if (!NON_REACTING) {
      const ExponentialDrag drag(coefficient[i], kick, inertia);
      for (int dim = 0; dim < 3; dim++) {
        double force =
          given[dim] + drag.slip * (fluid[dim] - v[dim]) - drag.other * other[dim];
        if (ADDED_MASS) force = own * force - takenUp * f[dim];
        f[dim] += force;
        wrong |= !(std::fabs(force) <= LARGEST);    // also if it is no number
        if (book) impulse[dim] += half * (applied[dim] + force);
        applied[dim] = force;
      }
      continue;
    }

    // One drag, shared out by the coefficients
    const double c = nonReactingCoefficient[i], b = coefficient[i] + c;
    const ExponentialDrag drag(b, kick, inertia);
    const double share = c > 0.0 ? c / b : 0.0;
    const double slip = (1.0 - share) * drag.slip, taken = (1.0 - share) * drag.other;
    const double slipWithout = share * drag.slip, takenWithout = share * drag.other;
    for (int dim = 0; dim < 3; dim++) {
      const double speed = fluid[dim] - v[dim];
      double force = given[dim] + slip * speed - taken * other[dim];
      const double without = nonReacting[dim] + slipWithout * speed - takenWithout * other[dim];
      if (ADDED_MASS) force = own * force - takenUp * (without + f[dim]);
      wrong |= !(std::fabs(force) + std::fabs(without) <= LARGEST);
      if (book) {    // the forces of the former step, too, each kind its own
        impulse[dim] += half * (applied[dim] - nonReactingApplied[dim] + force);
        nonReactingImpulse[dim] += half * (nonReactingApplied[dim] + without);
      }
      nonReactingApplied[dim] = without;
      applied[dim] = force + without;
      f[dim] += force + without;
    }
  }
  return wrong;
}

/* ----------------------------------------------------------------------
   Torque. Returns whether one is no number or far too large. The fluid of style uniform is at
   rest as far as spin goes.
------------------------------------------------------------------------- */

template<bool UNIFORM>
bool FixFluidForce::turn(double kick, bool remove)
{
  const int nlocal = atom->nlocal;
  const double *omegas = atom->omega[0];
  double *torques = atom->torque[0], *turned = fluidTorque_->array_atom[0];
  const double *spins = UNIFORM ? NULL : fluidSpin_->array_atom[0];
  const double *explicits = UNIFORM ? NULL : explicitTorque_->array_atom[0];
  bool wrong = false;

  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const int first = 3 * i;
    double *torque = torques + first, *applied = turned + first;
    if (held_.holds(i)) {
      applied[0] = applied[1] = applied[2] = 0.0;
      continue;
    }
    const double *omega = omegas + first;
    const double inertia = 0.4 * atom->rmass[i] * atom->radius[i] * atom->radius[i];
    const ExponentialDrag drag(UNIFORM ? uniform_->spinCoefficient(i, kick) : spinCoefficient_->vector_atom[i],
      kick, inertia);

    for (int dim = 0; dim < 3; dim++) {
      if (remove) torque[dim] -= applied[dim];
      const double given = UNIFORM ? 0.0 : explicits[first + dim];
      const double spin = UNIFORM ? 0.0 : spins[first + dim];
      const double all = UNIFORM ? -drag.slip * omega[dim] - drag.other * torque[dim]
        : given + drag.slip * (spin - omega[dim]) - drag.other * (torque[dim] + given);
      if (!UNIFORM) wrong |= !(std::fabs(all) <= LARGEST);    // also if it is no number
      applied[dim] = all;
      torque[dim] += all;
    }
  }
  return wrong;
}

/* ---------------------------------------------------------------------- */

bool FixFluidForce::push(double kick, bool remove, bool book)
{
  if (uniform_ && uniform_->hasAddedMass()) return push<true, false, true>(kick, remove, book);
  if (uniform_) return push<true, false, false>(kick, remove, book);
  if (addedMass_)
    return nonReactingForce_ ? push<false, true, true>(kick, remove, book)
      : push<false, false, true>(kick, remove, book);
  return nonReactingForce_ ? push<false, true, false>(kick, remove, book)
    : push<false, false, false>(kick, remove, book);
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::apply(double kick, bool remove, bool book)
{
  sumStep_ = -1;    // on all ranks alike, also on one without grains
  if (atom->nlocal == 0) return;

  const bool work = books_work();
  if (work && book) book_work_before();
  if (push(kick, remove, book)) refuse_force();
  if (work) book_work_after(book);
  if (!fluidTorque_) return;
  if (uniform_ ? turn<true>(kick, remove) : turn<false>(kick, remove)) refuse_torque();
}

/* ---------------------------------------------------------------------- */

const double *FixFluidForce::fluid_velocity(int i) const
{
  return coupled_ ? fluidVelocity_->array_atom[i] : uniform_->velocity();
}
