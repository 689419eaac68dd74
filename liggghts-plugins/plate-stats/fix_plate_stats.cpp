/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_plate_stats.h"

#include "host/fix_arguments.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <utility>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::FinishedCollision;
using grainjet::FixArguments;
using grainjet::PlateGeometry;
using grainjet::PlateStatistics;

// steps between gatherings, so that buffers stay small for any `every`
static const int GATHER_EVERY = 1000;

// Each ring is a row of the table with its own moments on every rank
static const double MOST_RINGS = 10000;

// m, far beyond any simulation, near enough for all arithmetic
static const double FAR = 1e30;

/* ---------------------------------------------------------------------- */

static int whole(FixArguments &arguments, const std::string &what, double most)
{
  const double value = arguments.number(what);
  char range[100];
  snprintf(range, sizeof(range), " must be a whole number >= 1 and <= %.0f, not %g", most, value);
  if (!(value >= 1.0 && value <= most && value == std::floor(value))) arguments.fail(what + range);
  return static_cast<int>(value);
}

static double length(FixArguments &arguments, const std::string &what)
{
  const double value = arguments.number(what);
  if (!(std::fabs(value) < FAR)) arguments.fail(what + " must be below 1e30 m");
  return value;
}

/* ---------------------------------------------------------------------- */

FixPlateStats::FixPlateStats(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg),
  every_(1000), start_(0.0), observed_(false), anew_(false),
  unknown_(false), warned_(false), clock_(-1.0), begin_(0.0), restartedEvents_(-1.0),
  started_(false), left_(false)
{
  parse(narg, arg);
  const FixArguments arguments(error, narg, arg);
  if (!atom->sphere_flag) arguments.fail("requires atom_style granular (spheres)");
  if (strcmp(update->unit_style, "si") != 0)
    arguments.fail(std::string("requires units si, not ") + update->unit_style);

  wall_.reset(new WallForces(lmp, wallID_));
  surface_.reset(new WallSurface(lmp, wallID_, id, *plate_));
  tracker_.reset(new CollisionTracker(lmp, *plate_, *surface_, groupbit, store_));
  statistics_.reset(new PlateStatistics(*plate_));
  begun_.assign(statistics_->regions(), 0.0);

  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
  create_attribute = 1;
  restart_peratom = 1;
  restart_global = 1;
  nevery = 1;
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extvector = 1;
}

/* ---------------------------------------------------------------------- */

FixPlateStats::~FixPlateStats()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::parse(int narg, char **arg)
{
  FixArguments arguments(error, narg, arg);
  bool hasCentre = false, hasNormal = false;
  double centre[3], normal[3], radius = 0.0;
  int rings = 0;
  std::set<std::string> given;
  while (arguments.more()) {
    const std::string keyword = arguments.word("keyword");
    if (!given.insert(keyword).second) arguments.fail("keyword '" + keyword + "' is given twice");
    if (keyword == "wall") wallID_ = arguments.word("ID of a fix wall/gran after 'wall'");
    else if (keyword == "centre") {
      for (double &x : centre) x = length(arguments, "coordinates x y z after 'centre'");
      hasCentre = true;
    } else if (keyword == "normal") {
      for (double &x : normal) x = arguments.number("components nx ny nz after 'normal'", -DBL_MAX, DBL_MAX);
      hasNormal = true;
    } else if (keyword == "radius") {
      radius = arguments.positive("radius", 0.0, FAR);
    } else if (keyword == "rings") rings = whole(arguments, "rings", MOST_RINGS);
    else if (keyword == "every") every_ = whole(arguments, "every", 1e9);
    else if (keyword == "file") path_ = arguments.word("path after 'file'");
    else if (keyword == "events") eventsPath_ = arguments.word("path after 'events'");
    else if (keyword == "stats_start") start_ = arguments.nonNegative("stats_start", DBL_MAX);
    else
      arguments.fail("unknown keyword '" + keyword + "'; valid keywords are wall, centre, "
        "normal, radius, rings, every, file, events, stats_start");
  }
  const std::pair<const char *, bool> required[] = {{"wall", !wallID_.empty()},
    {"centre", hasCentre}, {"normal", hasNormal}, {"radius", radius > 0.0},
    {"rings", rings > 0}, {"file", !path_.empty()}};
  for (const auto &item : required)
    if (!item.second) arguments.fail(std::string("missing keyword ") + item.first);
  if (normal[0] == 0.0 && normal[1] == 0.0 && normal[2] == 0.0)
    arguments.fail("normal must not be zero");
  const double size = std::hypot(std::hypot(normal[0], normal[1]), normal[2]);
  if (!(size > 1e-100 && size < 1e100))
    arguments.fail("normal must have a length between 1e-100 and 1e100, best 1");

  plate_.reset(new PlateGeometry(centre, normal, radius, rings));
}

/* ---------------------------------------------------------------------- */

int FixPlateStats::setmask()
{
  return PRE_NEIGHBOR | PRE_FINAL_INTEGRATE | END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::pre_delete(bool unfixflag)
{
  if (unfixflag) surface_->release();
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::fail(const std::string &message) const
{
  const std::string text = std::string("Fix plate/stats (ID ") + id + "): " + message;
  error->all(FLERR, text.c_str());
  std::abort();    // never reached: Error::all ends the program
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::init()
{
  find_wall();    // it may have been replaced since
  if (strcmp(update->integrate_style, "verlet") != 0)
    fail(std::string("requires run_style verlet, not ") + update->integrate_style);
  if (!(update->dt > 0.0)) fail("requires a timestep > 0");
  agree(comm->me == 0 ? check_files() : "");
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::find_wall()
{
  std::string fault = wall_->attach();
  if (fault.empty()) fault = surface_->attach();
  if (!fault.empty()) fail(fault);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::setup(int)
{
  if (clock_ < 0.0) {
    clock_ = update->get_cur_time();
    begin_ = std::max(clock_, start_);
  }
  tracker_->count_from(begin_);
  tracker_->start_run();
  surface_->update();
  if (!observed_) tracker_->skip_present(wall_->forces());
  if (anew_) begun_ = touching();    // what goes on from before the restart and counts
  anew_ = false;
  observed_ = started_ = true;
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::pre_neighbor()
{
  tracker_->reorder();
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::pre_final_integrate()
{
  clock_ += update->dt;
  if (!surface_->at_rest()) surface_->update();
  tracker_->step(wall_->forces(), clock_);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::end_of_step()
{
  if (update->ntimestep % every_ == 0) write();
  else if (update->ntimestep % GATHER_EVERY == 0) gather();
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::post_run()
{
  write();
  warn_if_beside();
}

/* ----------------------------------------------------------------------
   the likely reason for a plate without collisions: it does not lie on the wall
------------------------------------------------------------------------- */

void FixPlateStats::warn_if_beside()
{
  if (warned_) return;
  int mine[2] = {tracker_->beside(), tracker_->seen()}, any[2];
  MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, world);
  warned_ = any[0] || any[1];
  if (any[0] && !any[1] && comm->me == 0) {
    const std::string text = std::string("Fix plate/stats (ID ") + id + "): wall '" + wallID_
      + "' has touched grains, but none at the plate so far; check centre and normal";
    error->warning(FLERR, text.c_str());
  }
}

/* ----------------------------------------------------------------------
   Hands finished collisions to rank 0. Sorted there, so that sums and the events file
   come out the same for any number of ranks.
------------------------------------------------------------------------- */

void FixPlateStats::gather()
{
  const std::vector<FinishedCollision> &finished = tracker_->finished();
  int mine = finished.size() * FinishedCollision::SIZE, total = 0;
  std::vector<int> sizes(comm->nprocs), starts(comm->nprocs);
  MPI_Gather(&mine, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, world);
  for (int rank = 0; rank < comm->nprocs; rank++) {
    starts[rank] = total;
    total += sizes[rank];
  }
  std::vector<FinishedCollision> all(total / FinishedCollision::SIZE);
  MPI_Gatherv(finished.data(), mine, MPI_DOUBLE,
    all.data(), sizes.data(), starts.data(), MPI_DOUBLE, 0, world);

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
    for (const FinishedCollision &collision : all) statistics_->add(collision);
    if (events_ && !all.empty()) fault = events_->append(all);
  }
  if (!eventsPath_.empty()) agree(fault);
}

/* ----------------------------------------------------------------------
   collisions that go on now, per region; the result is on rank 0
------------------------------------------------------------------------- */

std::vector<double> FixPlateStats::touching() const
{
  const std::vector<double> mine = tracker_->touching();
  std::vector<double> all(mine.size(), 0.0);
  MPI_Reduce(mine.data(), all.data(), all.size(), MPI_DOUBLE, MPI_SUM, 0, world);
  return all;
}

/* ---------------------------------------------------------------------- */

double FixPlateStats::compute_vector(int n)
{
  gather();
  const std::vector<double> now = touching();
  double values[3] = {statistics_->collisions(0), now[0],
    begun_[0] - statistics_->collisions(0) - now[0]};
  MPI_Bcast(values, 3, MPI_DOUBLE, 0, world);
  return values[n];
}
