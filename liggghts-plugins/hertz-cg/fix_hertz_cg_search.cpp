/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix hertz/cg: when and how the list of pairs is made, and how contacts get from one list
   to the next */

#include "hertz-cg/fix_hertz_cg.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "neighbor.h"
#include "output.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   in place of the host's test by absolute displacement, and at the same point of the step
------------------------------------------------------------------------- */

void FixHertzCg::post_integrate()
{
  forces_restarted_ = false;
  const double time = (update->ntimestep - search_step_) * update->dt;
  enum { FRESH, EXPIRED, FAILED };
  int state = motion_.expired(atom->nlocal, atom->nlocal ? atom->x[0] : nullptr, time) ? EXPIRED : FRESH;
  if (!failure_.empty()) state = FAILED;
  if (comm->nprocs > 1) MPI_Allreduce(MPI_IN_PLACE, &state, 1, MPI_INT, MPI_MAX, world);
  if (state == FAILED) report_failure();
  if (state == EXPIRED) next_reneighbor = update->ntimestep;
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::setup_pre_exchange()
{
  pre_exchange();
}

/* ----------------------------------------------------------------------
   A run continued from a restart file starts with its grains sorted in memory. This one sorts
   them at the same step, so that both add up forces in the same order.
------------------------------------------------------------------------- */

void FixHertzCg::pre_exchange()
{
  save_contacts();
  pairs_valid_ = false;
  if (update->whichflag && output->restart_requested(update->ntimestep))
    atom->nextsort = update->ntimestep;
}

/* ----------------------------------------------------------------------
   put the contacts by for the time in which indices of grains change; LIGGGHTS may change
   them before it says so to all, so whoever comes first calls this
------------------------------------------------------------------------- */

void FixHertzCg::save_contacts()
{
  if (store_current_ || !pairs_valid_) return;
  pairs_.save(store_);
  store_current_ = true;
  // room for one grain's contacts in the host's buffer, besides what other fixes asked for
  comm->maxexchange_fix = std::max(comm->maxexchange_fix,
                                   2 * (1 + grainjet::ContactStore::VALUES * store_.largest()));
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::setup_pre_neighbor()
{
  search();
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::pre_neighbor()
{
  search();
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::search()
{
  // a run that goes on from the middle of another makes the list that was in use there
  if (!forces_restarted_) {
    stream_velocity(stream_);
    choose_margin(stream_);
    search_step_ = update->ntimestep;
  }

  const int nall = atom->nlocal + atom->nghost;
  grainjet::ContactPairs::Grains grains;
  grains.nowned = atom->nlocal;
  grains.nall = nall;
  grains.x = nall ? atom->x[0] : nullptr;
  grains.radius = atom->radius;
  grains.tag = atom->tag;
  grains.mask = atom->mask;
  grains.group = groupbit;
  grains.frozen = freeze_bit_;
  if (!pairs_.build(grains, margin_, store_, forces_restarted_))
    fail("grain " + std::to_string(atom->tag[grainjet::CellGrid::firstInvalid(nall, grains.x)])
         + " has no finite position");
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->radius[i] > rmax_)
      fail("grain " + std::to_string(atom->tag[i]) + " is larger than the largest known at the start of the run");
  report_failure();
  pairs_valid_ = true;

  double count[2] = {static_cast<double>(pairs_.size()), static_cast<double>(atom->nlocal)};
  MPI_Allreduce(MPI_IN_PLACE, count, 2, MPI_DOUBLE, MPI_SUM, world);
  pairs_per_grain_ = count[1] > 0.0 ? count[0] / count[1] : -1.0;
  start_motion(stream_);
}

/* ----------------------------------------------------------------------
   What goes wrong on one rank is told by all of them together, with one message; LIGGGHTS' way for
   a single rank ends the program before its message is through. The first failure is kept.
------------------------------------------------------------------------- */

void FixHertzCg::fail(const std::string &message)
{
  if (failure_.empty()) failure_ = message;
  if (comm->nprocs == 1) report_failure();
}

void FixHertzCg::report_failure()
{
  int rank = failure_.empty() ? comm->nprocs : comm->me;
  MPI_Allreduce(MPI_IN_PLACE, &rank, 1, MPI_INT, MPI_MIN, world);
  if (rank == comm->nprocs) return;
  int length = static_cast<int>(failure_.size());
  MPI_Bcast(&length, 1, MPI_INT, rank, world);
  failure_.resize(length);
  MPI_Bcast(&failure_[0], length, MPI_CHAR, rank, world);
  error->fix_error(FLERR, this, failure_.c_str());
}

/* ----------------------------------------------------------------------
   mean velocity of all grains that move
------------------------------------------------------------------------- */

void FixHertzCg::stream_velocity(double velocity[3]) const
{
  double sum[4] = {0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < atom->nlocal; ++i) {
    if (atom->mask[i] & freeze_bit_) continue;
    for (int d = 0; d < 3; ++d) sum[d] += atom->v[i][d];
    sum[3] += 1.0;
  }
  MPI_Allreduce(MPI_IN_PLACE, sum, 4, MPI_DOUBLE, MPI_SUM, world);
  for (int d = 0; d < 3; ++d) velocity[d] = sum[3] > 0.0 ? sum[d] / sum[3] : 0.0;
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::choose_margin(const double velocity[3])
{
  double fastest = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    double square = 0.0;
    for (int d = 0; d < 3; ++d) {
      const double w = atom->v[i][d] - velocity[d];
      square += w * w;
    }
    fastest = std::max(fastest, square);
  }
  MPI_Allreduce(MPI_IN_PLACE, &fastest, 1, MPI_DOUBLE, MPI_MAX, world);

  grainjet::MarginChoice choice;
  choice.diameter = 2.0 * rmax_;
  choice.largest = search_.reach();
  choice.pairs = pairs_per_grain_;
  choice.with = margin_;
  choice.displacement = std::sqrt(fastest) * update->dt;
  if (pairs_per_grain_ < 0.0) {
    // no list yet: as many as in a random arrangement
    choice.pairs = 4.0 * packing();
    choice.with = 0.0;
  }
  margin_ = choice.best();
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::start_motion(const double velocity[3])
{
  grainjet::StreamMotion::Limits limits;
  limits.relative = 0.5 * margin_;
  limits.wall = walls_.any ? walls_.reach * search_.skin() : 0.0;
  for (int d = 0; d < 3; ++d) {
    limits.wallAxes[d] = walls_.axis[d];
    // grains go round, change rank or leave through an open end only at a search: none may get
    // far beyond the box before, nor pass a whole rank
    limits.stream[d] = std::max(20.0 * rmax_, search_.reach());
    if (domain->periodicity[d] || comm->procgrid[d] > 1)
      limits.stream[d] = std::min(limits.stream[d], 0.5 * (domain->subhi[d] - domain->sublo[d]));
  }
  motion_.start(atom->nlocal, atom->nlocal ? atom->x[0] : nullptr, velocity, limits);
}

/* ----------------------------------------------------------------------
   contacts travel with their grains
------------------------------------------------------------------------- */

void FixHertzCg::grow_arrays(int nmax)
{
  store_.resize(nmax);
}

void FixHertzCg::copy_arrays(int i, int j, int)
{
  save_contacts();
  pairs_valid_ = false;
  store_.copy(i, j);
}

void FixHertzCg::set_arrays(int i)
{
  save_contacts();
  pairs_valid_ = false;
  store_.forget(i);
}

int FixHertzCg::pack_exchange(int i, double *buf)
{
  return store_.pack(i, buf);
}

int FixHertzCg::unpack_exchange(int nlocal, double *buf)
{
  return store_.unpack(nlocal, buf);
}
