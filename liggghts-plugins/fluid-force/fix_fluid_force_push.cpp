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

/* ---------------------------------------------------------------------- */

void FixFluidForce::apply(double kick, bool remove, bool book)
{
  sumStep_ = -1;    // on all ranks alike, also on one without grains
  if (atom->nlocal == 0) return;

  const bool wrong = uniform_ ? push<true, false>(kick, remove, book)
    : nonReactingForce_ ? push<false, true>(kick, remove, book)
    : push<false, false>(kick, remove, book);
  if (wrong) refuse_force();
  if (fluidTorque_ && turn(kick, remove)) refuse_torque();
}

/* ----------------------------------------------------------------------
   Forces. Returns whether one is no number or far too large.

   The drag of both kinds together is integrated as one, and shared out by their coefficients.
   A force of one kind is booked to the last digit if there is none of the other kind.
------------------------------------------------------------------------- */

template<bool UNIFORM, bool NON_REACTING>
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

    double given[3], other[3];
    for (int dim = 0; dim < 3; dim++) {
      if (remove) f[dim] -= applied[dim];
      given[dim] = UNIFORM ? buoyancy[dim] * UniformFlow::volume(atom->radius[i]) : explicits[first + dim];
      other[dim] = f[dim] + (NON_REACTING ? given[dim] + nonReacting[dim] : given[dim]);
    }
    if (UNIFORM)
      coefficient[i] =
        uniform_->dragCoefficient(i, other, kick, book ? coefficient[i] : 0.0);

    double b = coefficient[i], share = 0.0;
    if (NON_REACTING) {
      b += nonReactingCoefficient[i];
      if (b > 0.0) share = nonReactingCoefficient[i] / b;
    }
    const ExponentialDrag drag(b, kick, atom->rmass[i]);

    for (int dim = 0; dim < 3; dim++) {
      double slip = drag.slip * (fluid[dim] - v[dim]), taken = drag.other * other[dim];
      double force, without = 0.0;
      if (NON_REACTING) {
        without = nonReacting[dim] + share * slip - share * taken;
        slip *= 1.0 - share;
        taken *= 1.0 - share;
      }
      force = given[dim] + slip - taken;

      if (NON_REACTING) {
        wrong |= !(std::fabs(force) <= LARGEST && std::fabs(without) <= LARGEST);
        if (book) {
          impulse[dim] += half * (applied[dim] - nonReactingApplied[dim] + force);
          nonReactingImpulse[dim] += half * (nonReactingApplied[dim] + without);
        }
        nonReactingApplied[dim] = without;
        force += without;
        applied[dim] = force;
        f[dim] += force;
      } else {
        f[dim] += force;
        wrong |= !(std::fabs(force) <= LARGEST);    // also if it is no number
        if (book) impulse[dim] += half * (applied[dim] + force);
        applied[dim] = force;
      }
    }
  }
  return wrong;
}

/* ----------------------------------------------------------------------
   Torque. Returns whether one is no number or far too large.
------------------------------------------------------------------------- */

bool FixFluidForce::turn(double kick, bool remove)
{
  static const double none[3] = {0.0, 0.0, 0.0};
  bool wrong = false;

  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    double *applied = fluidTorque_->array_atom[i];
    if (held_.holds(i)) {
      applied[0] = applied[1] = applied[2] = 0.0;
      continue;
    }
    const double *spin = uniform_ ? none : fluidSpin_->array_atom[i];
    const double *given = uniform_ ? none : explicitTorque_->array_atom[i];
    const double coefficient = uniform_ ? uniform_->spinCoefficient(i) : spinCoefficient_->vector_atom[i];
    const double inertia = 0.4 * atom->rmass[i] * atom->radius[i] * atom->radius[i];
    const ExponentialDrag drag(coefficient, kick, inertia);

    double *torque = atom->torque[i];
    for (int dim = 0; dim < 3; dim++) {
      if (remove) torque[dim] -= applied[dim];
      applied[dim] = given[dim] + drag.slip * (spin[dim] - atom->omega[i][dim])
        - drag.other * (torque[dim] + given[dim]);
      wrong |= !(std::fabs(applied[dim]) <= LARGEST);
      torque[dim] += applied[dim];
    }
  }
  return wrong;
}

/* ---------------------------------------------------------------------- */

const double *FixFluidForce::fluid_velocity(int i) const
{
  return coupled_ ? fluidVelocity_->array_atom[i] : uniform_->velocity();
}
