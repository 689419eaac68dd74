/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix fluid/force coupled: its door, and its part of a restart file, which is that of RunningState.
   Style uniform has neither. */

#include "fix_fluid_force.h"
#include "host/grainjet_version.h"

#include "atom.h"
#include "fix_property_atom.h"

#include <cstring>

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
  exchange_.host = host_->array_atom;
  exchange_.nLost = lost_.grains().size();
  exchange_.lost = lost_.grains().data();
  exchange_.clearLost = clear_lost;
  exchange_.written = running_.written();
  exchange_.read = running_.read();
  exchange_.fix = this;
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::clear_lost(FluidForceExchange *door)
{
  static_cast<FixFluidForce *>(door->fix)->lost_.clear();
  door->nLost = 0;
}

/* ---------------------------------------------------------------------- */

void *FixFluidForce::extract(const char *what, int &dim)
{
  dim = 0;
  if (strcmp(what, "fluid_force_version") == 0) return const_cast<char *>(GRAINJET_VERSION);
  if (!coupled_ || strcmp(what, "fluid_force_exchange") != 0) return NULL;
  doorOpen_ = true;
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

/* ---------------------------------------------------------------------- */

void FixFluidForce::write_restart(FILE *fp)
{
  running_.begin_write(fp);
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
  running_.restart(buf);
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
