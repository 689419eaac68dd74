/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix hertz/cg: when and how the list of pairs is made, and how contacts get from one list
   to the next */

#include "hertz-cg/fix_hertz_cg.h"
#include "hertz-cg/pair_hertz_cg.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "neighbor.h"
#include "output.h"
#include "update.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <sstream>
#include <string>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   in place of the host's test by absolute displacement, and at the same point of the step
------------------------------------------------------------------------- */

void FixHertzCg::post_integrate()
{
  forces_restarted_ = false;
  const double time = elapsed_ + (update->ntimestep - counted_step_) * update->dt;
  const int failed = grainjet::StreamMotion::RELATIVE + 1;
  int state = motion_.expired(atom->nlocal, atom->nlocal ? atom->x[0] : nullptr, time);
  if (sizes_changed()) state = std::max<int>(state, grainjet::StreamMotion::STREAM);
  if (!failure_.empty()) state = failed;
  if (comm->nprocs > 1) MPI_Allreduce(MPI_IN_PLACE, &state, 1, MPI_INT, MPI_MAX, world);
  if (state == failed) report_failure();
  if (state != grainjet::StreamMotion::FRESH) next_reneighbor = update->ntimestep;
  expired_ = state == grainjet::StreamMotion::RELATIVE;
}

/* ----------------------------------------------------------------------
   The time since the last search is one of steps of the former length, too
------------------------------------------------------------------------- */

void FixHertzCg::reset_dt()
{
  elapsed_ += (update->ntimestep - counted_step_) * step_size_;
  counted_step_ = update->ntimestep;
  step_size_ = update->dt;
}

/* ----------------------------------------------------------------------
   The host hands out its list, and forgets its cut-offs, only when what is asked of it has changed
------------------------------------------------------------------------- */

void FixHertzCg::setup_pre_exchange()
{
  check_restarted();
  search_.set_cutoff();
  save_contacts();
  pairs_valid_ = false;
  check_grains();
  measure();
}

/* ----------------------------------------------------------------------
   A run continued from a restart file starts with its grains sorted in memory. This one sorts
   them at the same step, so that both add up forces in the same order.
------------------------------------------------------------------------- */

void FixHertzCg::pre_exchange()
{
  save_contacts();
  pairs_valid_ = false;
  check_grains();
  if (update->whichflag && output->restart_requested(update->ntimestep))
    atom->nextsort = update->ntimestep;
  measure();
  const bool outgrown = follow_sizes();
  if (search_.adapt(work_done_) || outgrown) {
    comm->setup();
    if (neighbor->style) neighbor->setup_bins();
  }
}

/* ----------------------------------------------------------------------
   what the present list has cost
------------------------------------------------------------------------- */

void FixHertzCg::measure()
{
  // a search costs about as much as 60 visits of a listed pair (measured, dilute and dense); the list of a mesh
  // costs 40 or 200 per triangle, still or moving
  work_done_ = {pairs_per_grain_, margin_, 0.0, 60.0, 0.0};
  if (update->ntimestep > search_step_) work_done_.searches = 1.0 / (update->ntimestep - search_step_);
  if (!walls_.mesh) return;
  const grainjet::MeshWork mesh = grainjet::mesh_work(lmp);
  double sum[3] = {mesh.triangles, mesh.listed, static_cast<double>(atom->nlocal)};
  MPI_Allreduce(MPI_IN_PLACE, sum, 3, MPI_DOUBLE, MPI_SUM, world);
  sum[2] = std::max(sum[2], 1.0);
  work_done_.triangles = sum[1] / sum[2];
  work_done_.search += (walls_.moving ? 200.0 : 40.0) * sum[0] / sum[2];
}

/* ----------------------------------------------------------------------
   The host changes a grain's rank for a neighbouring one, or sends it round the box once; it loses,
   without a word, what has got further. Where a grain just leaves through an open side, that is right.
------------------------------------------------------------------------- */

void FixHertzCg::check_grains()
{
  const double fastest = 1e100;    // m/s, the square of which is still a number
  double near[3][2];               // this rank's part and as much again on either side
  for (int d = 0; d < 3; ++d) {
    const double part = domain->subhi[d] - domain->sublo[d];
    near[d][0] = domain->sublo[d] - part;
    near[d][1] = domain->subhi[d] + part;
  }
  for (int i = 0; i < atom->nlocal && failure_.empty(); ++i) {
    const double *x = atom->x[i], *v = atom->v[i];
    bool usual = true;
    for (int d = 0; d < 3; ++d) usual &= x[d] >= near[d][0] && x[d] < near[d][1] && std::fabs(v[d]) < fastest;
    if (usual) continue;

    bool lost = false, finite = true;
    for (int d = 0; d < 3; ++d) {
      finite &= std::isfinite(x[d]) && std::fabs(v[d]) < fastest;
      if (search_.part(d) == HUGE_VAL) continue;
      const double lo = domain->boxlo[d], hi = domain->boxhi[d];
      if (domain->periodicity[d]) lost |= x[d] < lo - domain->prd[d] || x[d] >= hi + domain->prd[d];
      else if (x[d] < lo || x[d] >= hi) continue;
      if (comm->procgrid[d] > 2) lost |= x[d] < near[d][0] || x[d] >= near[d][1];
    }
    if (finite && !lost) continue;
    std::ostringstream message;
    message << "grain " << atom->tag[i] << " has "
            << (finite ? "got further than into the next part of the box" : "no finite position or velocity")
            << ": position " << x[0] << " " << x[1] << " " << x[2] << ", velocity " << v[0] << " " << v[1] << " " << v[2]
            << ", step " << update->ntimestep << "; use a smaller time step, and look for grains that overlap or are far too fast";
    fail(message.str());
  }
  report_failure();
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
                                   2 * (1 + store_.values() * store_.largest()));
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::setup_pre_neighbor()
{
  expired_ = true;
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
    search_step_ = counted_step_ = update->ntimestep;
    elapsed_ = 0.0;
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
  for (int d = 0; d < 3; ++d)
    grains.narrow |= domain->periodicity[d] && search_.part(d) < HUGE_VAL && domain->prd[d] < 4.0 * rmax_;
  if (!pairs_.build(grains, margin_, store_, forces_restarted_))
    fail("grain " + std::to_string(atom->tag[grainjet::CellGrid::firstInvalid(nall, grains.x)])
         + " has no finite position");
  for (int i = 0; i < atom->nlocal && failure_.empty(); ++i)
    if (!search_.known(atom->type[i], atom->radius[i])) {
      std::ostringstream message;
      message << "grain " << atom->tag[i] << " of diameter " << 2.0 * atom->radius[i]
              << " is larger than the largest known at the start of the run; change sizes and types between runs, "
              << "and do not begin the next one with `pre no`";
      fail(message.str());
    }
  report_failure();
  pairs_valid_ = true;
  hold_sizes();
  stand_in_->show(pairs_, atom->nlocal);

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
  // none so wide that the limit along the stream is used up from the start
  choice.largest = std::min(search_.reach(), 0.5 * search_.narrowest());
  choice.pairs = pairs_per_grain_;
  choice.with = margin_;
  choice.displacement = std::sqrt(fastest) * update->dt;
  if (pairs_per_grain_ < 0.0) {
    // no list yet: as many as in a random arrangement
    choice.pairs = 4.0 * packing();
    choice.with = 0.0;
  }
  choice.search = work_done_.search;
  // a wall, a moving mesh or an insertion asked for this search, not the margin; and will again
  if (!expired_) choice.forced = work_done_.searches;
  margin_ = std::max(choice.best(), search_.least());
  if (grows_) {
    // growth between two searches comes out of the margin
    double growth;
    MPI_Allreduce(&growth_, &growth, 1, MPI_DOUBLE, MPI_MAX, world);
    margin_ = std::min(std::max(margin_, 4.0 * growth), search_.reach());
  }
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::start_motion(const double velocity[3])
{
  grainjet::StreamMotion::Limits limits;
  double growth = 0.0;
  if (grows_) MPI_Allreduce(&growth_, &growth, 1, MPI_DOUBLE, MPI_MAX, world);
  limits.relative = std::max(0.5 * margin_ - growth, 0.05 * margin_);
  limits.wall = walls_.any ? std::max(walls_.reach * search_.skin() - growth, DBL_MIN) : 0.0;
  for (int d = 0; d < 3; ++d) {
    limits.wallAxes[d] = walls_.axis[d];
    // grains go round, change rank or leave through an open end only at a search: none may get
    // far beyond the box before, nor pass a whole rank
    limits.stream[d] = std::min(std::max(20.0 * rmax_, search_.reach()), 0.5 * search_.part(d));
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
