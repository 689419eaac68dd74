/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_wall_collisions.h"

#include "host/find_temperature.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::find_temperature;
using grainjet::FinishedCollision;
using grainjet::SlidingPiece;

// steps between gatherings, so that buffers stay small for any `every`
static const int GATHER_EVERY = 1000;

/* ---------------------------------------------------------------------- */

FixWallCollisions::FixWallCollisions(LAMMPS *lmp, int narg, char **arg, int kept) :
  Fix(lmp, narg, arg),
  every_(1000), start_(0.0), store_(kept, find_temperature(modify, style) != NULL), anew_(false), clock_(-1.0), begin_(0.0),
  temperature_(find_temperature(modify, style) != NULL), follows_sliding_(false), observed_(false), unknown_(false), warned_(false), started_(false),
  restartedTemperature_(false), restartedEvents_(-1.0)
{
  create_attribute = 1;
  restart_peratom = 1;
  restart_global = 1;
  nevery = 1;
  vector_flag = 1;
  global_freq = 1;
  extvector = 1;
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::watch(WatchedSurface &surface)
{
  if (!atom->sphere_flag) fail("requires atom_style granular (spheres)");
  if (strcmp(update->unit_style, "si") != 0)
    fail(std::string("requires units si, not ") + update->unit_style);

  wall_.reset(new WallForces(lmp, wallID_));
  tracker_.reset(new CollisionTracker(lmp, surface, groupbit, store_));
  if (follows_sliding_) tracker_->follow_sliding();
  begun_.assign(1 + surface.regions(), 0.0);
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

/* ---------------------------------------------------------------------- */

FixWallCollisions::~FixWallCollisions()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

/* ---------------------------------------------------------------------- */

int FixWallCollisions::setmask()
{
  return PRE_NEIGHBOR | PRE_FINAL_INTEGRATE | END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::fail(const std::string &message) const
{
  const std::string text = std::string("Fix ") + style + " (ID " + id + "): " + message;
  error->all(FLERR, text.c_str());
  std::abort();    // never reached: Error::all ends the program
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::init()
{
  find_wall();    // it may have been replaced since
  attach_temperature();
  if (strcmp(update->integrate_style, "verlet") != 0)
    fail(std::string("requires run_style verlet, not ") + update->integrate_style);
  if (!(update->dt > 0.0)) fail("requires a timestep > 0");
  agree(comm->me == 0 ? check_files() : "");
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::find_wall()
{
  std::string fault = wall_->attach();
  if (fault.empty()) fault = attach_surface();
  if (!fault.empty()) fail(fault);
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::attach_temperature()
{
  const FixPropertyAtom *property = find_temperature(modify, style);
  if (temperature_ && !property) fail("the property Temp is gone, whose temperatures it records; define this fix anew");
  tracker_->record_temperature(temperature_ ? property : NULL);
  if (!temperature_ && property && !started_ && comm->me == 0) {
    const std::string text = std::string("Fix ") + style + " (ID " + id + "): the property Temp came behind this fix, "
      "so its files have no temperatures; put fix " + property->id + " or what makes it before";
    error->warning(FLERR, text.c_str());
  }
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::setup(int)
{
  if (clock_ < 0.0) {
    clock_ = update->get_cur_time();
    begin_ = std::max(clock_, start_);
  }
  tracker_->count_from(begin_);
  tracker_->start_run();
  update_surface(true);
  if (!observed_) tracker_->skip_present(wall_->forces());
  if (anew_) begun_ = touching();    // what goes on from before the restart and counts
  anew_ = false;
  observed_ = started_ = true;
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::pre_neighbor()
{
  tracker_->reorder();
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::pre_final_integrate()
{
  clock_ += update->dt;
  update_surface(false);
  tracker_->step(wall_->forces(), clock_);
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::end_of_step()
{
  if (update->ntimestep % every_ == 0) write();
  else if (update->ntimestep % GATHER_EVERY == 0) gather();
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::post_run()
{
  write();
  warn_if_beside();
}

/* ----------------------------------------------------------------------
   the likely reason for a plate without collisions: it does not lie on the wall
------------------------------------------------------------------------- */

void FixWallCollisions::warn_if_beside()
{
  if (warned_) return;
  int mine[2] = {tracker_->beside(), tracker_->seen()}, any[2];
  MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, world);
  warned_ = any[0] || any[1];
  const char *hint = beside_hint();
  if (any[0] && !any[1] && hint && comm->me == 0) {
    const std::string text =
      std::string("Fix ") + style + " (ID " + id + "): wall '" + wallID_ + "' " + hint;
    error->warning(FLERR, text.c_str());
  }
}

/* ---------------------------------------------------------------------- */

std::vector<double> FixWallCollisions::collect(const double *mine, std::size_t count, int size) const
{
  int number = count * size, total = 0;
  std::vector<int> sizes(comm->nprocs), starts(comm->nprocs);
  MPI_Gather(&number, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, world);
  for (int rank = 0; rank < comm->nprocs; rank++) {
    starts[rank] = total;
    total += sizes[rank];
  }
  std::vector<double> all(total);
  MPI_Gatherv(mine, number, MPI_DOUBLE,
    all.data(), sizes.data(), starts.data(), MPI_DOUBLE, 0, world);
  return all;
}

/* ----------------------------------------------------------------------
   Sorted on rank 0, so that sums and the events file come out the same for any number of ranks.
------------------------------------------------------------------------- */

template<class Item>
static std::vector<Item> items(const std::vector<double> &list)
{
  std::vector<Item> all(list.size() / Item::SIZE);
  if (!all.empty()) memcpy(all.data(), list.data(), list.size() * sizeof(double));
  return all;
}

void FixWallCollisions::gather()
{
  const std::vector<FinishedCollision> &finished = tracker_->finished();
  std::vector<FinishedCollision> all = items<FinishedCollision>(collect(
    reinterpret_cast<const double *>(finished.data()), finished.size(), FinishedCollision::SIZE));
  std::vector<SlidingPiece> slid = sliding(tracker_->slid());

  std::vector<double> begun(begun_.size());
  MPI_Reduce(tracker_->begun().data(), begun.data(), begun.size(), MPI_DOUBLE, MPI_SUM, 0, world);
  tracker_->clear();

  std::string fault;
  if (comm->me == 0) {
    for (std::size_t r = 0; r < begun.size(); r++) begun_[r] += begun[r];
    std::sort(all.begin(), all.end(),
      [](const FinishedCollision &p, const FinishedCollision &q) {
        return std::make_pair(p.contact.time, p.id) < std::make_pair(q.contact.time, q.id);
      });
    book(all, slid);
    if (events_ && !all.empty()) {
      std::vector<std::string> lines;
      for (const FinishedCollision &collision : all) lines.push_back(event(collision));
      fault = events_->append(lines);
    }
  }
  if (!eventsPath_.empty()) agree(fault);
}

/* ---------------------------------------------------------------------- */

std::vector<SlidingPiece> FixWallCollisions::sliding(const std::vector<SlidingPiece> &mine) const
{
  if (!follows_sliding_) return std::vector<SlidingPiece>();
  std::vector<SlidingPiece> all = items<SlidingPiece>(
    collect(reinterpret_cast<const double *>(mine.data()), mine.size(), SlidingPiece::SIZE));
  std::sort(all.begin(), all.end(), [](const SlidingPiece &p, const SlidingPiece &q) {
    return std::make_pair(p.time, p.id) < std::make_pair(q.time, q.id);
  });
  return all;
}

/* ---------------------------------------------------------------------- */

std::vector<double> FixWallCollisions::touching() const
{
  const std::vector<double> mine = tracker_->touching();
  std::vector<double> all(mine.size(), 0.0);
  MPI_Reduce(mine.data(), all.data(), all.size(), MPI_DOUBLE, MPI_SUM, 0, world);
  return all;
}
