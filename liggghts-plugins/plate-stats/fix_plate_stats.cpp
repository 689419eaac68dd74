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
#include "fix_property_atom.h"
#include "force.h"
#include "math_const.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::Collision;
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
  every_(1000), start_(0.0), state_(NULL),
  rebuild_(true), thorough_(true), elsewhere_(false), warned_(false), observed_(false),
  clock_(-1.0), begin_(0.0), restartedEvents_(-1.0)
{
  parse(narg, arg);
  const FixArguments arguments(error, narg, arg);
  if (!atom->sphere_flag) arguments.fail("requires atom_style granular (spheres)");

  wall_.reset(new WallForces(lmp, wallID_));
  const std::string fault = wall_->attach();
  if (!fault.empty()) arguments.fail(fault);

  statistics_.reset(new PlateStatistics(*plate_));
  begun_.assign(statistics_->regions(), 0.0);
  begunAll_ = begun_;

  restart_global = 1;
  nevery = 1;
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extvector = 1;
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
  const std::string name = std::string("plateStats_") + id;
  std::vector<const char *> args = {name.c_str(), "all", "property/atom", name.c_str(),
    "vector", "yes", "no", "no"};
  args.insert(args.end(), Collision::SIZE, "0.");
  state_ = modify->add_fix_property_atom(args.size(), const_cast<char **>(args.data()), style);
  state_->just_created = 0;    // its initial state is set; Modify::setup need not repeat it

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

void FixPlateStats::pre_delete(bool unfixflag)
{
  if (unfixflag && state_) modify->delete_fix(state_->id);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::init()
{
  const std::string fault = wall_->attach();    // it may have been replaced
  if (!fault.empty()) {
    const std::string text = std::string("Fix plate/stats (ID ") + id + "): " + fault;
    error->all(FLERR, text.c_str());
  }
  rebuild_ = true;
}

/* ----------------------------------------------------------------------
   Grains that are in contact already when the fix first looks: the beginning of their
   collision is unknown, so it is followed but does not count.
------------------------------------------------------------------------- */

void FixPlateStats::setup(int)
{
  thorough_ = true;
  if (clock_ < 0.0) {
    clock_ = update->get_cur_time();
    begin_ = std::max(clock_, start_);
  }
  if (observed_) return;
  observed_ = true;
  double **forces = wall_->forces();
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && touches(i, forces)) {
      contact(i) = Collision();
      contact(i).steps = 1.0;
      contact(i).time = -1.0;
    }
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::pre_neighbor()
{
  rebuild_ = true;
}

/* ---------------------------------------------------------------------- */

Collision &FixPlateStats::contact(int i) const
{
  return *reinterpret_cast<Collision *>(state_->array_atom[i]);
}

/* ---------------------------------------------------------------------- */

bool FixPlateStats::touches(int i, double **forces) const
{
  const double *f = forces[i];
  return (f[0] != 0.0 || f[1] != 0.0 || f[2] != 0.0)
    && std::fabs(plate_->height(atom->x[i])) < atom->radius[i];
}

/* ----------------------------------------------------------------------
   The wall's own neighbour lists rest on the same margin: until the next rebuild no
   grain moves by more than the skin. Only between runs can a grain be put elsewhere
   while it touches; then all are looked at.
------------------------------------------------------------------------- */

void FixPlateStats::find_near()
{
  const bool look = !elsewhere_ && begunAll_[0] + begun_[0] == 0.0;
  double **forces = wall_->forces();
  near_.clear();
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    if (std::fabs(plate_->height(atom->x[i])) < atom->radius[i] + neighbor->skin
        || (thorough_ && contact(i).steps > 0.0))
      near_.push_back(i);
    else if (look && (forces[i][0] != 0.0 || forces[i][1] != 0.0 || forces[i][2] != 0.0))
      elsewhere_ = true;
  }
  rebuild_ = thorough_ = false;
}

/* ----------------------------------------------------------------------
   all forces of the step are known and have not acted yet
------------------------------------------------------------------------- */

void FixPlateStats::pre_final_integrate()
{
  if (rebuild_) find_near();
  clock_ += update->dt;
  double **forces = wall_->forces();
  for (int i : near_) {
    Collision &c = contact(i);
    if (touches(i, forces)) {
      if (c.steps == 0.0) begin(i, c);
      double normal[3];
      const double side = plate_->height(atom->x[i]) < 0.0 ? -1.0 : 1.0;
      for (int dim = 0; dim < 3; dim++) normal[dim] = side * plate_->normal()[dim];
      c.addStep(forces[i], normal, update->dt);
    } else if (c.steps > 0.0) {
      finish(i, c);
    }
  }
}

/* ---------------------------------------------------------------------- */

double FixPlateStats::kinetic_energy(int i) const
{
  const double radius = atom->radius[i];
  return 0.5 * atom->rmass[i] * (PlateGeometry::dot(atom->v[i], atom->v[i])
    + 0.4 * radius * radius * PlateGeometry::dot(atom->omega[i], atom->omega[i]));
}

/* ----------------------------------------------------------------------
   one more in the whole plate and in the collision's ring
------------------------------------------------------------------------- */

void FixPlateStats::count(const Collision &c, std::vector<double> &regions) const
{
  const double place[2] = {c.a, c.b};
  const int ring = plate_->ring(place);
  if (ring < 0 || !counts(c)) return;
  regions[0] += 1.0;
  regions[1 + ring] += 1.0;
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::begin(int i, Collision &c)
{
  c = Collision();
  c.time = clock_;
  plate_->project(atom->x[i], &c.a);
  const double *v = atom->v[i];
  const double across = PlateGeometry::dot(v, plate_->normal());
  const double square = PlateGeometry::dot(v, v);
  c.speed = std::sqrt(square);
  c.angle = std::atan2(std::sqrt(std::max(square - across * across, 0.0)), std::fabs(across))
    * 180.0 / MathConst::MY_PI;
  c.energy = kinetic_energy(i);
  count(c, begun_);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::finish(int i, Collision &c)
{
  const double place[2] = {c.a, c.b};
  if (counts(c) && plate_->ring(place) >= 0) {
    const double cg = force->cg(atom->type[i]);
    FinishedCollision collision;
    collision.contact = c;
    collision.id = atom->tag[i];
    collision.particles = cg * cg * cg;
    collision.speedAfter = std::sqrt(PlateGeometry::dot(atom->v[i], atom->v[i]));
    collision.energyAfter = kinetic_energy(i);
    finished_.push_back(collision);
  }
  c = Collision();
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
  int mine = elsewhere_, any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  warned_ = any;
  if (any && comm->me == 0 && begunAll_[0] == 0.0) {
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
  int mine = finished_.size() * FinishedCollision::SIZE, total = 0;
  std::vector<int> sizes(comm->nprocs), starts(comm->nprocs);
  MPI_Gather(&mine, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, world);
  for (int rank = 0; rank < comm->nprocs; rank++) {
    starts[rank] = total;
    total += sizes[rank];
  }
  std::vector<FinishedCollision> all(total / FinishedCollision::SIZE);
  MPI_Gatherv(finished_.data(), mine, MPI_DOUBLE,
    all.data(), sizes.data(), starts.data(), MPI_DOUBLE, 0, world);
  finished_.clear();

  std::vector<double> begun(begun_.size());
  MPI_Reduce(begun_.data(), begun.data(), begun.size(), MPI_DOUBLE, MPI_SUM, 0, world);
  begun_.assign(begun_.size(), 0.0);

  std::string fault;
  if (comm->me == 0) {
    for (std::size_t r = 0; r < begun.size(); r++) begunAll_[r] += begun[r];
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
  std::vector<double> mine(begun_.size(), 0.0), all(begun_.size(), 0.0);
  for (int i = 0; i < atom->nlocal; i++)
    if (contact(i).steps > 0.0) count(contact(i), mine);
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
      statistics_->csv(std::max(clock_ - begin_, 0.0), begunAll_, now);
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
    begunAll_[0] - statistics_->collisions(0) - now[0]};
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
  list.insert(list.end(), begunAll_.begin(), begunAll_.end());
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
  begunAll_.assign(list + head, list + head + begun_.size());
}
