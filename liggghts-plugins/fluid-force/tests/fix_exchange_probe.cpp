/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_exchange_probe.h"

#include "fluid-force/fluid_force_exchange.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixExchangeProbe::FixExchangeProbe(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), fluid_(NULL), mine_()
{
  if (narg != 8) error->all(FLERR, "Illegal fix exchange/probe command");
  nevery = atoi(arg[3]);
  wind_ = atof(arg[4]);
  shear_ = atof(arg[5]);
  coefficient_ = atof(arg[6]);
  explicit_ = atof(arg[7]);
  vector_flag = 1;
  size_vector = SIZE;
  global_freq = 1;
}

/* ---------------------------------------------------------------------- */

int FixExchangeProbe::setmask()
{
  return END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixExchangeProbe::init()
{
  fluid_ = modify->find_fix_style("fluid/force", 0);
  int dim;
  if (!fluid_ || !fluid_->extract("fluid_force_exchange", dim))
    error->all(FLERR, "Fix exchange/probe: no fix fluid/force coupled");
}

/* ---------------------------------------------------------------------- */

void FixExchangeProbe::end_of_step()
{
  int dim;
  auto *exchange = static_cast<FluidForceExchange *>(fluid_->extract("fluid_force_exchange", dim));

  const auto distance = [](const double *p, const double *q) {
    return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
      + (p[2] - q[2]) * (p[2] - q[2]));
  };

  for (int i = 0; i < exchange->nRemoved; i++) {
    const FluidForceExchange::Removed &grain = exchange->removed[i];
    mine_[3] += 1;
    for (int k = 0; k < 3; k++) {
      mine_[k] += grain.impulse[k];
      mine_[4 + k] += grain.mass * grain.velocity[k];
    }
    mine_[7] += grain.mass;
    mine_[10] = std::max(mine_[10], distance(grain.position, grain.startPosition));
  }
  exchange->clearRemoved(exchange);
  if (exchange->nRemoved != 0) error->one(FLERR, "Fix exchange/probe: removed grains not cleared");

  mine_[8] = mine_[9] = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (exchange->owner[i][0] < 0) mine_[8] += 1;
    mine_[9] = std::max(mine_[9], distance(atom->x[i], exchange->startPosition[i]));
    for (int k = 0; k < 3; k++) {
      mine_[k] += exchange->impulse[i][k];
      exchange->impulse[i][k] = 0;
      exchange->startPosition[i][k] = atom->x[i][k];
      exchange->fluidVelocity[i][k] = k == 0 ? wind_ + shear_ * atom->x[i][1] : 0;
      exchange->explicitForce[i][k] = k == 0 ? explicit_ : 0;
    }
    exchange->dragCoefficient[i] = coefficient_;
    exchange->owner[i][OWNER_RANK] = comm->me;
    exchange->owner[i][OWNER_NUMBER] = i;
    exchange->owner[i][OWNER_PRESENT] = 1;
  }
}

/* ---------------------------------------------------------------------- */

double FixExchangeProbe::compute_vector(int n)
{
  double value;
  MPI_Allreduce(&mine_[n], &value, 1, MPI_DOUBLE, n < SUMS ? MPI_SUM : MPI_MAX, world);
  return value;
}
