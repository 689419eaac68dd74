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
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::EventsFile;
using grainjet::FinishedCollision;
using grainjet::FixArguments;
using grainjet::PlateGeometry;
using grainjet::PlateStatistics;

// steps between gatherings, so that buffers stay small for any `every`
static const int GATHER_EVERY = 1000;

/* ---------------------------------------------------------------------- */

FixPlateStats::FixPlateStats(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg),
  every_(1000), start_(0.0), observed_(false),
  warned_(false), clock_(-1.0), begin_(0.0), restartedEvents_(-1.0)
{
  parse(narg, arg);
  const FixArguments arguments(error, narg, arg);
  if (!atom->sphere_flag) arguments.fail("requires atom_style granular (spheres)");

  wall_.reset(new WallForces(lmp, wallID_));
  tracker_.reset(new CollisionTracker(lmp, *plate_, groupbit, store_));
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
  while (arguments.more()) {
    const std::string keyword = arguments.word("keyword");
    if (keyword == "wall") wallID_ = arguments.word("ID of a fix wall/gran after 'wall'");
    else if (keyword == "centre") {
      for (double &x : centre) x = arguments.number("coordinates x y z after 'centre'");
      hasCentre = true;
    } else if (keyword == "normal") {
      for (double &x : normal) x = arguments.number("components nx ny nz after 'normal'");
      hasNormal = true;
    } else if (keyword == "radius") radius = arguments.positive("radius");
    else if (keyword == "rings") rings = arguments.count("rings");
    else if (keyword == "every") every_ = arguments.count("every");
    else if (keyword == "file") path_ = arguments.word("path after 'file'");
    else if (keyword == "events") eventsPath_ = arguments.word("path after 'events'");
    else if (keyword == "stats_start") start_ = arguments.nonNegative("stats_start");
    else
      arguments.fail("unknown keyword '" + keyword + "'; valid keywords are wall, centre, "
        "normal, radius, rings, every, file, events, stats_start");
  }
  const std::pair<const char *, bool> required[] = {{"wall", !wallID_.empty()},
    {"centre", hasCentre}, {"normal", hasNormal}, {"radius", radius > 0.0},
    {"rings", rings > 0}, {"file", !path_.empty()}};
  for (const auto &item : required)
    if (!item.second) arguments.fail(std::string("missing keyword ") + item.first);
  if (PlateGeometry::dot(normal, normal) == 0.0) arguments.fail("normal must not be zero");

  plate_.reset(new PlateGeometry(centre, normal, radius, rings));
}

/* ---------------------------------------------------------------------- */

int FixPlateStats::setmask()
{
  return PRE_NEIGHBOR | PRE_FINAL_INTEGRATE | END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::post_create()
{
  find_wall();
  just_created = 0;    // grains are free of collisions; Modify::setup need not say so again

  std::string fault;
  if (comm->me == 0) {
    FILE *file = fopen(path_.c_str(), "a");
    if (file) fclose(file);
    else fault = "cannot write file '" + path_ + "': " + strerror(errno);
    if (fault.empty() && !eventsPath_.empty()) {
      events_.reset(new EventsFile(eventsPath_));
      fault = restartedEvents_ < 0 ? events_->create() : events_->resume(restartedEvents_);
    }
  }
  agree(fault);
}

/* ----------------------------------------------------------------------
   ends the run on all ranks if rank 0 has met a fault
------------------------------------------------------------------------- */

void FixPlateStats::agree(std::string fault)
{
  int length = fault.size();
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  if (length == 0) return;
  fault.resize(length);
  MPI_Bcast(&fault[0], length, MPI_CHAR, 0, world);
  fault = std::string("Fix plate/stats (ID ") + id + "): " + fault;
  error->all(FLERR, fault.c_str());
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::init()
{
  find_wall();    // it may have been replaced since
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::find_wall()
{
  const std::string fault = wall_->attach();
  if (fault.empty()) return;
  const std::string text = std::string("Fix plate/stats (ID ") + id + "): " + fault;
  error->all(FLERR, text.c_str());
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
  if (!observed_) tracker_->skip_present(wall_->forces());
  observed_ = true;
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

/* ----------------------------------------------------------------------
   The file is replaced as a whole by renaming, so a reader never sees half a table.
------------------------------------------------------------------------- */

void FixPlateStats::write()
{
  gather();
  const std::vector<double> now = touching();
  std::string fault;
  if (comm->me == 0) {
    const std::string text =
      statistics_->csv(std::max(clock_ - begin_, 0.0), begun_, now);
    const std::string fresh = path_ + ".new";
    FILE *file = fopen(fresh.c_str(), "w");
    bool good = file && fwrite(text.data(), 1, text.size(), file) == text.size();
    if (file && fclose(file) != 0) good = false;
    if (!good || rename(fresh.c_str(), path_.c_str()) != 0)
      fault = "cannot write file '" + path_ + "': " + strerror(errno);
  }
  agree(fault);
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

/* ----------------------------------------------------------------------
   restart data: size, start_, clock_, begin_, bytes of the events file, collisions
   begun per region, statistics
------------------------------------------------------------------------- */

void FixPlateStats::write_restart(FILE *fp)
{
  gather();
  if (comm->me != 0) return;
  std::vector<double> list = {0.0, start_, clock_, begin_, events_ ? events_->size() : -1.0};
  list.insert(list.end(), begun_.begin(), begun_.end());
  const std::vector<double> packed = statistics_->pack();
  list.insert(list.end(), packed.begin(), packed.end());
  list[0] = list.size();
  const int bytes = list.size() * sizeof(double);
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::restart(char *buf)
{
  const double *list = reinterpret_cast<const double *>(buf);
  const std::size_t size = static_cast<std::size_t>(list[0]), head = 5;
  const std::vector<double> packed(list + head + begun_.size() < list + size
    ? list + head + begun_.size() : list + size, list + size);
  clock_ = list[2];
  observed_ = true;
  if (start_ != list[1]) {    // another stats_start asks for statistics from then on
    begin_ = std::max(clock_, start_);
    return;
  }
  if (!statistics_->unpack(packed)) {
    const std::string text = std::string("Fix plate/stats (ID ") + id + "): the restart file "
      "holds statistics of another number of rings; use that, or another fix ID";
    error->all(FLERR, text.c_str());
  }
  begin_ = list[3];
  restartedEvents_ = list[4];
  begun_.assign(list + head, list + head + begun_.size());
}
