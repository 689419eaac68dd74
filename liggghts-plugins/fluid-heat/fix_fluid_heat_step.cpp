/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* The loop of fix fluid/heat over the grains, once per DEM step. */

#include "fix_fluid_heat.h"

#include "physics/heat/lumped_temperature.h"

#include "atom.h"
#include "fix_property_atom.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;
using grainjet::heat::heatingFraction;

// steps between looks at the Biot number, for which all ranks meet
static const int BIOT_EVERY = 1000;

/* ----------------------------------------------------------------------
   Heat for the time of one step. In style uniform the slip is that of the middle of the step, where the
   last kick of velocity Verlet is taken off again: with it the step is of second order in time. A grain
   that the coupling has not seen has coefficient and fluid temperature 0.
------------------------------------------------------------------------- */

template<bool UNIFORM>
bool FixFluidHeat::step()
{
  const int nlocal = atom->nlocal;
  const double dt = update->dt, half = 0.5 * dt;
  double *temperatures = grainTemperature_->vector_atom;
  double *fluids = fluidTemperature_->vector_atom, *coefficients = coefficient_->vector_atom;
  double *heats = heat_->vector_atom;
  bool wrong = false;

  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & groupbit) || held_.holds(i)) continue;
    if (UNIFORM) {
      const double kick = half / atom->rmass[i];
      double velocity[3];
      for (int dim = 0; dim < 3; dim++) velocity[dim] = atom->v[i][dim] - kick * atom->f[i][dim];
      coefficients[i] = uniform_->exchange(i, velocity, fluids[i]);
    }
    const double capacity = atom->rmass[i] * specificHeat_[atom->type[i]];
    const double x = coefficients[i] * dt / capacity;
    const double before = temperatures[i];
    const double after = before + heatingFraction(x) * (fluids[i] - before);
    const double received = capacity * (after - before);
    temperatures[i] = after;
    heats[i] += received;
    latest_ += received;
    // also if one is no number
    wrong |= !(x >= 0.0) || !(after > 0.0 && after < HUGE_VAL) || (x > 0.0 && !(fluids[i] > 0.0));
  }
  return wrong;
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::end_of_step()
{
  sumStep_ = -1;    // on all ranks alike, also on one without grains
  latest_ = 0.0;
  held_.update(update->ntimestep);
  if (uniform_ ? step<true>() : step<false>()) refuse_temperature();
  total_ += latest_;

  if (!checkBiot_ && update->ntimestep % BIOT_EVERY != 0) return;
  checkBiot_ = false;
  warn_of_biot();
}
