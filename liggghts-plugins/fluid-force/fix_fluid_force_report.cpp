/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* What fix fluid/force tells the user: its output, and a force that cannot be. */

#include "fix_fluid_force.h"

#include "atom.h"
#include "error.h"
#include "fix_property_atom.h"
#include "update.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   A force that is no number would be with all grains within some contacts, and a grain that
   an absurd one throws out of the box would be gone without a word. Ranks do not wait for
   each other here, so the one that has it ends the run.
------------------------------------------------------------------------- */

void FixFluidForce::refuse(const char *text)
{
  fflush(NULL);    // the log and dumps up to here
  error->one(FLERR, text);
  std::abort();    // never reached: Error::one ends the program
}

/* ---------------------------------------------------------------------- */

static bool good(const double *vector, double largest)
{
  return std::fabs(vector[0]) <= largest && std::fabs(vector[1]) <= largest && std::fabs(vector[2]) <= largest;
}

/* ----------------------------------------------------------------------
   Forces with and without reaction may be absurd and still have a small sum: as in push().
------------------------------------------------------------------------- */

void FixFluidForce::refuse_force()
{
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double *force = fluidForce_->array_atom[i], *v = atom->v[i];
    const double *without = nonReactingApplied_ ? nonReactingApplied_->array_atom[i] : NULL;
    double size[3];
    for (int dim = 0; dim < 3; dim++)
      size[dim] = without ? std::fabs(force[dim] - without[dim]) + std::fabs(without[dim]) : force[dim];
    if (good(size, LARGEST)) continue;

    const double *fluid = fluid_velocity(i);
    char part[128] = "";
    double coefficient = dragCoefficient_->vector_atom[i];
    if (without) {
      snprintf(part, sizeof(part), ", of which (%g %g %g) N without reaction on the fluid,",
        without[0], without[1], without[2]);
      coefficient += nonReactingCoefficient_->vector_atom[i];
    }
    char text[640];
    snprintf(text, sizeof(text), "Fix fluid/force (ID %s): the force on grain %d is (%g %g %g) N%s in step "
      BIGINT_FORMAT ". Its velocity is (%g %g %g) m/s, the fluid's (%g %g %g) m/s, the drag coefficient %g kg/s, "
      "radius %g m, mass %g kg. Look for what is not finite or far too large: a time step too long for the contacts, or a "
      "fluid that diverges", id, atom->tag[i], force[0], force[1], force[2], part, update->ntimestep, v[0], v[1], v[2],
      fluid[0], fluid[1], fluid[2], coefficient, atom->radius[i], atom->rmass[i]);
    refuse(text);
  }
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::refuse_torque()
{
  for (int i = 0; i < atom->nlocal; i++) {
    const double *torque = fluidTorque_->array_atom[i], *omega = atom->omega[i];
    if (!(atom->mask[i] & groupbit) || good(torque, LARGEST)) continue;
    char text[640];
    snprintf(text, sizeof(text), "Fix fluid/force (ID %s): the fluid's torque on grain %d is (%g %g %g) N m in step "
      BIGINT_FORMAT ". Its angular velocity is (%g %g %g) rad/s, radius %g m, mass %g kg. Look for what is not finite or "
      "far too large: a time step too long for the contacts, or a fluid that diverges", id, atom->tag[i],
      torque[0], torque[1], torque[2], update->ntimestep, omega[0], omega[1], omega[2], atom->radius[i], atom->rmass[i]);
    refuse(text);
  }
}

/* ---------------------------------------------------------------------- */

double FixFluidForce::compute_vector(int n)
{
  if (sumStep_ != update->ntimestep) sum();
  if (n < 3) return sums_[n];
  return sums_[4] > 0.0 ? sums_[3] / sums_[4] : 0.0;
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::sum()
{
  double mine[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    for (int dim = 0; dim < 3; dim++) mine[dim] += fluidForce_->array_atom[i][dim];
    double coefficient = dragCoefficient_->vector_atom[i];
    if (nonReactingCoefficient_) coefficient += nonReactingCoefficient_->vector_atom[i];
    if (coefficient <= 0.0) continue;
    const double *fluid = fluid_velocity(i);
    double square = 0.0;
    for (int dim = 0; dim < 3; dim++)
      square += (fluid[dim] - atom->v[i][dim]) * (fluid[dim] - atom->v[i][dim]);
    mine[3] += std::sqrt(square);
    mine[4] += 1.0;
  }
  MPI_Allreduce(mine, sums_, 5, MPI_DOUBLE, MPI_SUM, world);
  sumStep_ = update->ntimestep;
}
