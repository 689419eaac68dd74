/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_fluid_door.h"

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

FixFluidDoor::FixFluidDoor(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), fluid_(NULL), mine_()
{
  if (narg != 8) error->all(FLERR, "Illegal fix fluid/door command");
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

int FixFluidDoor::setmask()
{
  return END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixFluidDoor::init()
{
  fluid_ = modify->find_fix_style("fluid/force", 0);
  int dim;
  if (!fluid_ || !fluid_->extract("fluid_force_exchange", dim))
    error->all(FLERR, "Fix fluid/door: no door");
}

/* ---------------------------------------------------------------------- */

void FixFluidDoor::end_of_step()
{
  int dim;
  auto *door = static_cast<FluidForceExchange *>(fluid_->extract("fluid_force_exchange", dim));

  const auto distance = [](const double *p, const double *q) {
    return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
      + (p[2] - q[2]) * (p[2] - q[2]));
  };

  for (int i = 0; i < door->nLost; i++) {
    const FluidForceExchange::Lost &grain = door->lost[i];
    mine_[3] += 1;
    for (int k = 0; k < 3; k++) {
      mine_[k] += grain.impulse[k];
      mine_[4 + k] += grain.mass * grain.velocity[k];
    }
    mine_[7] += grain.mass;
    mine_[10] = std::max(mine_[10], distance(grain.position, grain.startPosition));
  }
  door->clearLost(door);
  if (door->nLost != 0) error->one(FLERR, "Fix fluid/door: lost grains not cleared");

  mine_[8] = mine_[9] = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (door->host[i][0] < 0) mine_[8] += 1;
    mine_[9] = std::max(mine_[9], distance(atom->x[i], door->startPosition[i]));
    for (int k = 0; k < 3; k++) {
      mine_[k] += door->impulse[i][k];
      door->impulse[i][k] = 0;
      door->startPosition[i][k] = atom->x[i][k];
      door->fluidVelocity[i][k] = k == 0 ? wind_ + shear_ * atom->x[i][1] : 0;
      door->explicitForce[i][k] = k == 0 ? explicit_ : 0;
    }
    door->dragCoefficient[i] = coefficient_;
    door->host[i][0] = comm->me;
    door->host[i][1] = i;
  }
}

/* ---------------------------------------------------------------------- */

double FixFluidDoor::compute_vector(int n)
{
  double value;
  MPI_Allreduce(&mine_[n], &value, 1, MPI_DOUBLE, n < SUMS ? MPI_SUM : MPI_MAX, world);
  return value;
}
