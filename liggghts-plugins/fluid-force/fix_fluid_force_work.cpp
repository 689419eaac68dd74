/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* The work that forces with reaction do on the grains, for a coupling that asks for it.

   A half kick of velocity Verlet changes the velocity of a grain by h a, h half a time step and a = f/m by
   all forces f. Of the change of its kinetic energy, m h a.(v + h a/2) with v the velocity before, the
   fluid's force F takes h F.(v + h a/2). The sum over all forces is the whole change, to round-off.

   In the middle of a step v is that after the kick by the forces of the step before, and before the
   kick by the new ones. Of the former forces f is gone by then, so F.a is kept (fluidPowerGrowth). */

#include "fix_fluid_force.h"

#include "atom.h"
#include "fix_property_atom.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void FixFluidForce::reacting_force(int i, double *force) const
{
  const double *all = fluidForce_->array_atom[i];
  const double *without = nonReactingApplied_ ? nonReactingApplied_->array_atom[i] : NULL;
  for (int dim = 0; dim < 3; dim++) force[dim] = without ? all[dim] - without[dim] : all[dim];
}

/* ---------------------------------------------------------------------- */

static double dot(const double *a, const double *b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::book_work_before()
{
  const double half = 0.5 * update->dt;
  double *work = work_->vector_atom;
  const double *growth = powerGrowth_->vector_atom;
  double force[3];

  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit) || held_.holds(i)) continue;
    reacting_force(i, force);
    work[i] += half * (dot(force, atom->v[i]) - 0.5 * half * growth[i]);
  }
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::book_work_after(bool book)
{
  const double half = 0.5 * update->dt;
  double *work = work_->vector_atom, *growth = powerGrowth_->vector_atom;
  double force[3];

  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    reacting_force(i, force);    // of held grains 0
    growth[i] = dot(force, atom->f[i]) / atom->rmass[i];
    if (book) work[i] += half * (dot(force, atom->v[i]) + 0.5 * half * growth[i]);
  }
}
