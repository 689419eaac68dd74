/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* What LIGGGHTS asks of a fix with per-grain data: see collision_store.h */

#include "fix_plate_stats.h"

#include "atom.h"

using namespace LAMMPS_NS;
using grainjet::CollisionStore;

/* ---------------------------------------------------------------------- */

void FixPlateStats::grow_arrays(int nmax)
{
  store_.grow(nmax);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::copy_arrays(int i, int j, int delflag)
{
  store_.move(i, j, delflag);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::set_arrays(int i)
{
  store_.reset(i);
}

/* ---------------------------------------------------------------------- */

int FixPlateStats::pack_exchange(int i, double *buf)
{
  return store_.pack(i, buf);
}

/* ---------------------------------------------------------------------- */

int FixPlateStats::unpack_exchange(int i, double *buf)
{
  return store_.unpack(i, buf);
}

/* ----------------------------------------------------------------------
   in a restart file the number of values comes first
------------------------------------------------------------------------- */

int FixPlateStats::pack_restart(int i, double *buf)
{
  buf[0] = 1 + store_.pack(i, buf + 1);
  return static_cast<int>(buf[0]);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::unpack_restart(int i, int nth)
{
  const double *extra = atom->extra[i];
  for (int n = 0; n < nth; n++) extra += static_cast<int>(extra[0]);
  store_.unpack(i, extra + 1);
  if (unknown_ && store_.find(i)) store_.find(i)->time = -1.0;
}

/* ---------------------------------------------------------------------- */

int FixPlateStats::size_restart(int i)
{
  return store_.find(i) ? maxsize_restart() : 2;
}

/* ---------------------------------------------------------------------- */

int FixPlateStats::maxsize_restart()
{
  return 1 + CollisionStore::PACKED;
}

/* ---------------------------------------------------------------------- */

double FixPlateStats::memory_usage()
{
  return atom->nmax * sizeof(int);
}
