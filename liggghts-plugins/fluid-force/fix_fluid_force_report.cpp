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

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   A force that is no number would be with all grains within some contacts, and a grain that
   an absurd one throws out of the box would be gone without a word. Ranks do not wait for
   each other here, so the one that has it ends the run.
------------------------------------------------------------------------- */

void FixFluidForce::refuse_force()
{
  for (int i = 0; i < atom->nlocal; i++) {
    const double *force = fluidForce_->array_atom[i], *v = atom->v[i];
    if (!(atom->mask[i] & groupbit) ||
      (std::fabs(force[0]) <= LARGEST_FORCE && std::fabs(force[1]) <= LARGEST_FORCE
        && std::fabs(force[2]) <= LARGEST_FORCE)) continue;
    const double *fluid = fluid_velocity(i);
    char text[512];
    snprintf(text, sizeof(text), "Fix fluid/force (ID %s): the force on grain %d is (%g %g %g) N in step "
      BIGINT_FORMAT ". Its velocity is (%g %g %g) m/s, the fluid's (%g %g %g) m/s, the drag coefficient %g kg/s, "
      "radius %g m, mass %g kg. Look for what is not finite or far too large: a time step too long for the contacts, or a "
      "fluid that diverges", id, atom->tag[i], force[0], force[1], force[2], update->ntimestep, v[0], v[1], v[2],
      fluid[0], fluid[1], fluid[2], dragCoefficient_->vector_atom[i], atom->radius[i], atom->rmass[i]);
    fflush(NULL);    // the log and dumps up to here
    error->one(FLERR, text);
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
    if (dragCoefficient_->vector_atom[i] <= 0.0) continue;
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
