/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_exchange_probe.h"

#include "fluid-force/fluid_force_exchange.h"
#include "fluid-heat/fluid_heat_exchange.h"
#include "host/grainjet_version.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixExchangeProbe::FixExchangeProbe(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), nonReacting_(false), torque_(false), work_(false),
  nonReactingCoefficient_(0.0), nonReactingForce_(0.0),
  spinCoefficient_(0.0), spin_(0.0), explicitTorque_(0.0), addedMass_(0.0),
  heat_(false), temperature_(0.0), heatCoefficient_(0.0), fluid_(NULL), heating_(NULL), mine_()
{
  if (narg < 8) error->all(FLERR, "Illegal fix exchange/probe command");
  nevery = atoi(arg[3]);
  wind_ = atof(arg[4]);
  shear_ = atof(arg[5]);
  coefficient_ = atof(arg[6]);
  explicit_ = atof(arg[7]);
  for (int n = 8; n < narg; ) {
    if (strcmp(arg[n], "nonReacting") == 0 && n + 2 < narg) {
      nonReacting_ = true;
      nonReactingCoefficient_ = atof(arg[n + 1]);
      nonReactingForce_ = atof(arg[n + 2]);
      n += 3;
    } else if (strcmp(arg[n], "torque") == 0 && n + 3 < narg) {
      torque_ = true;
      spinCoefficient_ = atof(arg[n + 1]);
      spin_ = atof(arg[n + 2]);
      explicitTorque_ = atof(arg[n + 3]);
      n += 4;
    } else if (strcmp(arg[n], "addedMass") == 0 && n + 1 < narg) {
      addedMass_ = atof(arg[n + 1]);
      n += 2;
    } else if (strcmp(arg[n], "work") == 0) {
      work_ = true;
      n += 1;
    } else if (strcmp(arg[n], "heat") == 0 && n + 2 < narg) {
      heat_ = true;
      temperature_ = atof(arg[n + 1]);
      heatCoefficient_ = atof(arg[n + 2]);
      n += 3;
    } else if (strcmp(arg[n], "state") == 0 && n + 2 < narg) {
      states_.push_back(State{arg[n + 1], atoi(arg[n + 2]), -1});
      n += 3;
    } else error->all(FLERR, "Illegal fix exchange/probe command");
  }
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

FluidForceExchange *FixExchangeProbe::exchange()
{
  int dim;
  return static_cast<FluidForceExchange *>(fluid_->extract("fluid_force_exchange", dim));
}

/* ----------------------------------------------------------------------
   the requests: before the first set-up
------------------------------------------------------------------------- */

void FixExchangeProbe::post_create()
{
  fluid_ = modify->find_fix_style("fluid/force", 0);
  if (!fluid_ || !exchange()) error->all(FLERR, "Fix exchange/probe: no fix fluid/force coupled");

  FluidForceExchange *fluid = exchange();
  if (fluid->nonReactingForce || fluid->nonReactingCoefficient || fluid->nonReactingImpulse
    || fluid->fluidSpin || fluid->spinCoefficient || fluid->explicitTorque || fluid->addedMass || fluid->work)
    error->all(FLERR, "Fix exchange/probe: arrays that nobody has requested");

  if (heat_) {
    heating_ = modify->find_fix_style("fluid/heat", 0);
    if (!heating_ || !heat_exchange()) error->all(FLERR, "Fix exchange/probe: no fix fluid/heat coupled");
    int dim;
    if (strcmp(static_cast<const char *>(heating_->extract("fluid_heat_version", dim)), GRAINJET_VERSION) != 0)
      error->all(FLERR, "Fix exchange/probe: fix fluid/heat of another version");
  }
  if (nonReacting_) fluid->useNonReacting(fluid);
  if (torque_) fluid->useTorque(fluid);
  if (addedMass_ != 0.0) fluid->useAddedMass(fluid);
  if (work_) fluid->useWork(fluid);
  for (State &state : states_) {
    std::vector<double> initial;
    for (int k = 0; k < state.size; k++) initial.push_back(k + 0.25);
    state.index = fluid->addState(fluid, state.name.c_str(), state.size, initial.data());
    if (fluid->addState(fluid, state.name.c_str(), state.size, initial.data()) != state.index)
      error->all(FLERR, "Fix exchange/probe: two indices of one state");
  }
}

/* ---------------------------------------------------------------------- */

void FixExchangeProbe::init()
{
  fluid_ = modify->find_fix_style("fluid/force", 0);
  heating_ = modify->find_fix_style("fluid/heat", 0);
}

/* ---------------------------------------------------------------------- */

FluidHeatExchange *FixExchangeProbe::heat_exchange()
{
  int dim;
  return static_cast<FluidHeatExchange *>(heating_->extract("fluid_heat_exchange", dim));
}

/* ---------------------------------------------------------------------- */

void FixExchangeProbe::exchange_heat()
{
  FluidHeatExchange *heating = heat_exchange();
  for (int i = 0; i < atom->nlocal; i++) {
    mine_[HEAT] += heating->heat[i];
    heating->heat[i] = 0;
    heating->fluidTemperature[i] = temperature_;
    heating->heatTransferCoefficient[i] = heatCoefficient_;
  }
}

/* ---------------------------------------------------------------------- */

static double distance(const double *p, const double *q)
{
  return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
    + (p[2] - q[2]) * (p[2] - q[2]));
}

/* ---------------------------------------------------------------------- */

void FixExchangeProbe::take_removed()
{
  FluidForceExchange *fluid = exchange();
  for (int i = 0; i < fluid->nRemoved; i++) {
    const FluidForceExchange::Removed &grain = fluid->removed[i];
    mine_[REMOVED] += 1;
    if (grain.fate == FluidForceExchange::DELETED) mine_[DELETED] += 1;
    for (int k = 0; k < 3; k++) {
      mine_[IMPULSE + k] += grain.impulse[k];
      mine_[NON_REACTING + k] += grain.nonReactingImpulse[k];
      mine_[MOMENTUM + k] += grain.mass * grain.velocity[k];
      mine_[ENERGY] += 0.5 * grain.mass * grain.velocity[k] * grain.velocity[k];
    }
    mine_[WORK] += grain.work;
    mine_[HEAT] += grain.heat;
    if (heat_) mine_[THERMAL] += grain.mass * heat_exchange()->specificHeat[1] * grain.temperature;
    else if (grain.heat != 0.0 || grain.temperature != 0.0)
      error->one(FLERR, "Fix exchange/probe: heat of a removed grain without fix fluid/heat");
    mine_[MASS] += grain.mass;
    mine_[FATE] = std::max(mine_[FATE], distance(grain.position, grain.startPosition));
  }
  fluid->clearRemoved(fluid);
  if (fluid->nRemoved != 0) error->one(FLERR, "Fix exchange/probe: removed grains not cleared");
}

/* ---------------------------------------------------------------------- */

void FixExchangeProbe::advance_states()
{
  FluidForceExchange *fluid = exchange();
  for (const State &state : states_) {
    double *values = fluid->state(fluid, state.index);
    for (int i = 0; i < atom->nlocal; i++)
      for (int k = 0; k < state.size; k++) {
        double &value = values[state.size * i + k];
        if (fluid->owner[i][OWNER_RANK] < 0 && value != k + 0.25) mine_[WRONG_STATE] += 1;
        value += (k + 1) * atom->v[i][0];
      }
  }
}

/* ---------------------------------------------------------------------- */

void FixExchangeProbe::end_of_step()
{
  take_removed();
  advance_states();
  if (heat_) exchange_heat();

  FluidForceExchange *fluid = exchange();
  mine_[NEW] = mine_[FAR] = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (fluid->owner[i][OWNER_RANK] < 0) mine_[NEW] += 1;
    mine_[FAR] = std::max(mine_[FAR], distance(atom->x[i], fluid->startPosition[i]));
    for (int k = 0; k < 3; k++) {
      mine_[IMPULSE + k] += fluid->impulse[i][k];
      fluid->impulse[i][k] = 0;
      fluid->startPosition[i][k] = atom->x[i][k];
      fluid->fluidVelocity[i][k] = k == 0 ? wind_ + shear_ * atom->x[i][1] : 0;
      fluid->explicitForce[i][k] = k == 0 ? explicit_ : 0;
      if (nonReacting_) {
        mine_[NON_REACTING + k] += fluid->nonReactingImpulse[i][k];
        fluid->nonReactingImpulse[i][k] = 0;
        fluid->nonReactingForce[i][k] = k == 2 ? nonReactingForce_ : 0;
      }
      if (torque_) {
        fluid->fluidSpin[i][k] = k == 2 ? spin_ : 0;
        fluid->explicitTorque[i][k] = k == 2 ? explicitTorque_ : 0;
      }
    }
    if (work_) {
      mine_[WORK] += fluid->work[i];
      fluid->work[i] = 0;
    }
    fluid->dragCoefficient[i] = coefficient_;
    if (nonReacting_) fluid->nonReactingCoefficient[i] = nonReactingCoefficient_;
    if (torque_) fluid->spinCoefficient[i] = spinCoefficient_;
    if (addedMass_ != 0.0) fluid->addedMass[i] = addedMass_;
    fluid->owner[i][OWNER_RANK] = comm->me;
    fluid->owner[i][OWNER_NUMBER] = i;
    fluid->owner[i][OWNER_PRESENT] = 1;
  }
}

/* ---------------------------------------------------------------------- */

double FixExchangeProbe::compute_vector(int n)
{
  double value;
  MPI_Allreduce(&mine_[n], &value, 1, MPI_DOUBLE, n == FAR || n == FATE ? MPI_MAX : MPI_SUM, world);
  return value;
}
