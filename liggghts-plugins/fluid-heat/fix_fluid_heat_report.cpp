/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* What fix fluid/heat tells the user: its output, temperatures that cannot be, the Biot number. */

#include "fix_fluid_heat.h"

#include "physics/heat/lumped_temperature.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_property_atom.h"
#include "force.h"
#include "update.h"

#include <climits>
#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace LAMMPS_NS;

static const double LARGEST_BIOT = 0.1;

/* ---------------------------------------------------------------------- */

static bool possible(double temperature)
{
  return temperature > 0.0 && temperature < HUGE_VAL;
}

/* ----------------------------------------------------------------------
   Start of a run: the script may have set them. The grain of the lowest ID is named, by all ranks.
------------------------------------------------------------------------- */

void FixFluidHeat::check_temperatures()
{
  struct { int tag, rank; } mine = {INT_MAX, comm->me}, first;
  double value = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double temperature = grainTemperature_->vector_atom[i];
    if (!(atom->mask[i] & groupbit) || possible(temperature) || atom->tag[i] >= mine.tag) continue;
    mine.tag = atom->tag[i];
    value = temperature;
  }
  MPI_Allreduce(&mine, &first, 1, MPI_2INT, MPI_MINLOC, world);
  if (first.tag == INT_MAX) return;
  MPI_Bcast(&value, 1, MPI_DOUBLE, first.rank, world);
  char text[160];
  snprintf(text, sizeof(text), "the temperature of grain %d is %g K, but must be > 0 and finite; look at what sets the "
    "property Temp", first.tag, value);
  fail(text);
}

/* ----------------------------------------------------------------------
   Ranks do not wait for each other here, so the one that has it ends the run.
------------------------------------------------------------------------- */

void FixFluidHeat::refuse_temperature()
{
  for (int i = 0; i < atom->nlocal; i++) {
    const double temperature = grainTemperature_->vector_atom[i], coefficient = coefficient_->vector_atom[i];
    const double fluid = fluidTemperature_->vector_atom[i];
    if (!(atom->mask[i] & groupbit)) continue;
    if (possible(temperature) && (coefficient == 0.0 || (coefficient > 0.0 && fluid > 0.0))) continue;
    char text[512];
    snprintf(text, sizeof(text), "Fix fluid/heat (ID %s): the temperature of grain %d is %g K in step " BIGINT_FORMAT
      ", that of the fluid %g K; both must be > 0 and finite. The heat transfer coefficient of the grain is %g W/K (>= 0), its "
      "mass %g kg. Look for what is not finite: a fluid that diverges, or a fix that changes the property Temp",
      id, atom->tag[i], temperature, update->ntimestep, fluid, coefficient, atom->rmass[i]);
    fflush(NULL);    // the log and dumps up to here
    error->one(FLERR, text);
    std::abort();    // never reached: Error::one ends the program
  }
}

/* ---------------------------------------------------------------------- */

double FixFluidHeat::largest_biot(int &tag)
{
  struct { double biot; int tag; } mine = {0.0, 0}, largest;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double cg = force->cg(atom->type[i]);
    const double biot = grainjet::heat::biot(coefficient_->vector_atom[i], 2.0 * atom->radius[i] / cg, cg,
      conductivity_[atom->type[i]]);
    if (biot > mine.biot) mine = {biot, atom->tag[i]};
  }
  MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  tag = largest.tag;
  return largest.biot;
}

/* ----------------------------------------------------------------------
   once
------------------------------------------------------------------------- */

void FixFluidHeat::warn_of_biot()
{
  if (warned_ || conductivity_.empty()) return;
  int tag;
  const double biot = largest_biot(tag);
  warned_ = biot > LARGEST_BIOT;
  if (!warned_ || comm->me != 0) return;
  char text[256];
  snprintf(text, sizeof(text), "Fix fluid/heat (ID %s): the Biot number of grain %d is %.3g, above %g: its inside and its "
    "surface differ in temperature, and one temperature per grain is a rough estimate", id, tag, biot, LARGEST_BIOT);
  error->warning(FLERR, text);
}

/* ---------------------------------------------------------------------- */

double FixFluidHeat::compute_vector(int n)
{
  if (n == 3) {
    int tag;
    return conductivity_.empty() ? -1.0 : largest_biot(tag);
  }
  if (sumStep_ != update->ntimestep) sum();
  if (n == 0) return sums_[0] / update->dt;
  if (n == 1) return sums_[1] > 0.0 ? sums_[2] / sums_[1] : 0.0;
  return sums_[3];
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::sum()
{
  double mine[4] = {latest_, 0.0, 0.0, total_};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double capacity = atom->rmass[i] * specificHeat_[atom->type[i]];
    mine[1] += capacity;
    mine[2] += capacity * grainTemperature_->vector_atom[i];
  }
  MPI_Allreduce(mine, sums_, 4, MPI_DOUBLE, MPI_SUM, world);
  sumStep_ = update->ntimestep;
}
