/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix fluid/force coupled: its exchange with a coupling, and its part of a restart file, which is that of RunningState.
   Style uniform has neither. */

#include "fix_fluid_force.h"
#include "host/grainjet_version.h"

#include "atom.h"
#include "comm.h"
#include "fix_property_atom.h"

#include <cstring>
#include <vector>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void FixFluidForce::refresh_exchange()
{
  exchange_.fluidVelocity = fluidVelocity_->array_atom;
  exchange_.dragCoefficient = dragCoefficient_->vector_atom;
  exchange_.explicitForce = explicitForce_->array_atom;
  exchange_.impulse = impulse_->array_atom;
  exchange_.fluidForce = fluidForce_->array_atom;
  exchange_.startPosition = startPosition_->array_atom;
  exchange_.owner = owner_->array_atom;
  if (nonReactingRequested_) {
    exchange_.nonReactingCoefficient = nonReactingCoefficient_->vector_atom;
    exchange_.nonReactingForce = nonReactingForce_->array_atom;
    exchange_.nonReactingImpulse = nonReactingImpulse_->array_atom;
  }
  if (torqueRequested_) {
    exchange_.fluidSpin = fluidSpin_->array_atom;
    exchange_.spinCoefficient = spinCoefficient_->vector_atom;
    exchange_.explicitTorque = explicitTorque_->array_atom;
  }
  if (addedMassRequested_) exchange_.addedMass = addedMass_->vector_atom;
  if (workRequested_) exchange_.work = work_->vector_atom;
  exchange_.nRemoved = removed_.grains().size();
  exchange_.removed = removed_.grains().data();
  exchange_.clearRemoved = clear_removed;
  exchange_.useNonReacting = use_non_reacting;
  exchange_.useTorque = use_torque;
  exchange_.useAddedMass = use_added_mass;
  exchange_.useWork = use_work;
  exchange_.addState = add_state;
  exchange_.state = state;
  exchange_.written = running_.written();
  exchange_.read = running_.read();
  exchange_.fix = this;
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::clear_removed(FluidForceExchange *exchange)
{
  static_cast<FixFluidForce *>(exchange->fix)->removed_.clear();
  exchange->nRemoved = 0;
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::collect_removed(bool deleting, double halfKick)
{
  if (!exchangeOpen_) return;
  refresh_exchange();
  removed_.collect(exchange_, deleting, halfKick,
    nonReactingApplied_ ? nonReactingApplied_->array_atom : NULL,
    workRequested_ ? powerGrowth_->vector_atom : NULL);
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::create_non_reacting()
{
  nonReactingCoefficient_ = properties_.create("fluidNonReactingCoefficient", {0.0});
  nonReactingForce_ = properties_.create("fluidNonReactingForce", {0.0, 0.0, 0.0});
  nonReactingImpulse_ = properties_.create("fluidNonReactingImpulse", {0.0, 0.0, 0.0});
  nonReactingApplied_ = properties_.create("fluidNonReactingApplied", {0.0, 0.0, 0.0});
}

void FixFluidForce::create_torque()
{
  fluidSpin_ = properties_.create("fluidSpin", {0.0, 0.0, 0.0});
  spinCoefficient_ = properties_.create("fluidSpinCoefficient", {0.0});
  explicitTorque_ = properties_.create("fluidExplicitTorque", {0.0, 0.0, 0.0});
  fluidTorque_ = properties_.create("fluidTorque", {0.0, 0.0, 0.0});
}

void FixFluidForce::create_added_mass()
{
  addedMass_ = properties_.create("fluidAddedMass", {0.0});
}

void FixFluidForce::create_work()
{
  work_ = properties_.create("fluidWork", {0.0});
  powerGrowth_ = properties_.create("fluidPowerGrowth", {0.0});
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::use_non_reacting(FluidForceExchange *exchange)
{
  FixFluidForce *fix = static_cast<FixFluidForce *>(exchange->fix);
  if (!fix->nonReactingForce_) fix->create_non_reacting();
  fix->nonReactingRequested_ = true;
  fix->refresh_exchange();
}

void FixFluidForce::use_torque(FluidForceExchange *exchange)
{
  FixFluidForce *fix = static_cast<FixFluidForce *>(exchange->fix);
  if (!fix->explicitTorque_) fix->create_torque();
  fix->torqueRequested_ = true;
  fix->refresh_exchange();
}

void FixFluidForce::use_added_mass(FluidForceExchange *exchange)
{
  FixFluidForce *fix = static_cast<FixFluidForce *>(exchange->fix);
  if (!fix->addedMass_) fix->create_added_mass();
  fix->addedMassRequested_ = true;
  fix->refresh_exchange();
}

void FixFluidForce::use_work(FluidForceExchange *exchange)
{
  FixFluidForce *fix = static_cast<FixFluidForce *>(exchange->fix);
  if (!fix->work_) fix->create_work();
  fix->workRequested_ = true;
  fix->refresh_exchange();
}

int FixFluidForce::add_state(FluidForceExchange *exchange, const char *name, int size,
  const double *initial)
{
  return static_cast<FixFluidForce *>(exchange->fix)->properties_.add_state(name, size, initial);
}

double *FixFluidForce::state(FluidForceExchange *exchange, int index)
{
  return static_cast<FixFluidForce *>(exchange->fix)->properties_.state(index);
}

/* ----------------------------------------------------------------------
   Forces of the restart file that the coupling of this run does not know of. They end here; their
   last half kick is still to come and is booked as theirs.
------------------------------------------------------------------------- */

void FixFluidForce::drop_unrequested()
{
  const int nlocal = atom->nlocal;
  const auto clear = [nlocal](FixPropertyAtom *coefficient, FixPropertyAtom *constant) {
    for (int i = 0; i < nlocal; i++) {
      coefficient->vector_atom[i] = 0.0;
      for (int dim = 0; dim < 3; dim++) constant->array_atom[i][dim] = 0.0;
    }
  };
  if (nonReactingForce_ && !nonReactingRequested_) clear(nonReactingCoefficient_, nonReactingForce_);
  if (explicitTorque_ && !torqueRequested_) clear(spinCoefficient_, explicitTorque_);
  if (addedMass_ && !addedMassRequested_)
    for (int i = 0; i < nlocal; i++) addedMass_->vector_atom[i] = 0.0;
}

/* ---------------------------------------------------------------------- */

void *FixFluidForce::extract(const char *what, int &dim)
{
  dim = 0;
  if (strcmp(what, "fluid_force_version") == 0) return const_cast<char *>(GRAINJET_VERSION);
  if (uniform_ && strcmp(what, "fluid_force_uniform") == 0) return &uniformFluid_;
  if (strcmp(what, "fluid_force_motion") == 0) {
    motion_.fix = this;
    motion_.joins = [](void *fix) { return static_cast<FixFluidForce *>(fix)->joins(); };
    motion_.move = [](void *fix, const GrainStep &grains) { static_cast<FixFluidForce *>(fix)->move(grains); };
    return &motion_;
  }
  if (!coupled_ || strcmp(what, "fluid_force_exchange") != 0) return NULL;
  exchangeOpen_ = true;
  refresh_exchange();
  return &exchange_;
}

/* ----------------------------------------------------------------------
   LIGGGHTS wants type 1 to be in use. An empty box is a normal state of a coupled run.
------------------------------------------------------------------------- */

int FixFluidForce::min_type()
{
  return coupled_ && atom->natoms == 0 ? 1 : 0;
}

/* ----------------------------------------------------------------------
   Global part: numbers of RunningState, whether there are forces without reaction, torque, added
   mass and work, states of the models
------------------------------------------------------------------------- */

void FixFluidForce::write_restart(FILE *fp)
{
  std::vector<double> list = running_.begin_write();
  list.push_back(nonReactingForce_ != NULL);
  list.push_back(explicitTorque_ != NULL);
  list.push_back(addedMass_ != NULL);
  list.push_back(books_work());
  properties_.pack(list, !exchangeOpen_);

  if (comm->me) return;
  const int size = list.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ----------------------------------------------------------------------
   called once the file is written, for fixes that have a file of their own
------------------------------------------------------------------------- */

void FixFluidForce::write_restart_file(char *)
{
  running_.end_write();
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::restart(char *buf)
{
  const double *list = running_.restart(reinterpret_cast<const double *>(buf));
  nonReactingRead_ = *list++ != 0.0;
  torqueRead_ = *list++ != 0.0;
  addedMassRead_ = *list++ != 0.0;
  workRead_ = *list++ != 0.0;
  properties_.unpack(list);
}

/* ---------------------------------------------------------------------- */

int FixFluidForce::size_restart(int)
{
  return 1 + RunningState::VALUES;
}

int FixFluidForce::maxsize_restart()
{
  return size_restart(0);
}

int FixFluidForce::pack_restart(int i, double *buf)
{
  buf[0] = size_restart(i);
  running_.pack(i, buf + 1);
  return size_restart(i);
}

void FixFluidForce::unpack_restart(int i, int nth)
{
  const double *extra = atom->extra[i];
  int m = 0;
  for (int n = 0; n < nth; n++) m += static_cast<int>(extra[m]);
  running_.unpack(i, extra + m + 1);
}

/* ----------------------------------------------------------------------
   only between reading a file and the first step is anything kept per grain
------------------------------------------------------------------------- */

void FixFluidForce::grow_arrays(int nmax)
{
  running_.grow(nmax);
}

void FixFluidForce::copy_arrays(int i, int j, int)
{
  running_.copy(i, j);
}

int FixFluidForce::pack_exchange(int i, double *buf)
{
  return running_.pack_exchange(i, buf);
}

int FixFluidForce::unpack_exchange(int i, double *buf)
{
  return running_.unpack_exchange(i, buf);
}
