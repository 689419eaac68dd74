/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* What LIGGGHTS asks of a fix with per-grain data: see collision_store.h */

#include "fix_wall_collisions.h"

#include "atom.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void FixWallCollisions::grow_arrays(int nmax)
{
  store_.grow(nmax);
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::copy_arrays(int i, int j, int delflag)
{
  store_.move(i, j, delflag);
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::set_arrays(int i)
{
  store_.reset(i);
}

/* ---------------------------------------------------------------------- */

int FixWallCollisions::pack_exchange(int i, double *buf)
{
  return store_.pack(i, buf);
}

/* ---------------------------------------------------------------------- */

int FixWallCollisions::unpack_exchange(int i, double *buf)
{
  return store_.unpack(i, buf);
}

/* ----------------------------------------------------------------------
   in a restart file the number of values comes first
------------------------------------------------------------------------- */

int FixWallCollisions::pack_restart(int i, double *buf)
{
  buf[0] = 1 + store_.pack(i, buf + 1);
  return static_cast<int>(buf[0]);
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::unpack_restart(int i, int nth)
{
  const double *extra = atom->extra[i];
  for (int n = 0; n < nth; n++) extra += static_cast<int>(extra[0]);
  store_.unpack(i, extra + 1, restartedTemperature_);
  grainjet::Collision *collision = store_.find(i);
  if (!collision) return;
  if (unknown_) collision->time = -1.0;
  if (anew_) collision->slidingWork = collision->workHere = 0.0;
}

/* ---------------------------------------------------------------------- */

int FixWallCollisions::size_restart(int i)
{
  return store_.find(i) ? maxsize_restart() : 2;
}

/* ---------------------------------------------------------------------- */

int FixWallCollisions::maxsize_restart()
{
  return 1 + store_.packed();
}

/* ---------------------------------------------------------------------- */

double FixWallCollisions::memory_usage()
{
  return atom->nmax * sizeof(int);
}
