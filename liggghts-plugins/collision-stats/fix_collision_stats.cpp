/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision-stats/fix_collision_stats.h"

#include "host/fix_arguments.h"
#include "host/grainjet_version.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::AxisBins;
using grainjet::CollisionStatistics;
using grainjet::FixArguments;
using grainjet::GrainCollision;
using grainjet::LogHistogram;
using grainjet::SpectrumBins;

// steps between two counts of the grains, whose mean is what frequencies per grain refer to
static const int COUNT_EVERY = 100;

// Each slab is some rows of the tables, and has moments and spectra of its own on every rank
static const int MOST_BINS = 10000, MOST_SPECTRUM_BINS = 10000;
static const double MOST_NUMBERS = 5e7;

/* ---------------------------------------------------------------------- */

FixCollisionStats::FixCollisionStats(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), every_(1000), start_(0.0),
  spectra_{{1e-18, 1.0, 108}, {1e-5, 1e3, 48}, {1e-9, 1e5, 84}, {1e-9, 1.0, 54}},
  samples_(0.0), clock_(-1.0), begin_(0.0), anew_(false), started_(false), left_{false, false},
  numbers_(), numbersStep_(-1)
{
  parse(narg, arg);
  if (strcmp(update->unit_style, "si") != 0) fail(std::string("requires units si, not ") + update->unit_style);

  const double cells = (bins_.count + 1.0) * atom->ntypes * (atom->ntypes + 1) / 2;
  if (CollisionStatistics::numbers(cells, spectra_) > MOST_NUMBERS)
    fail("bins and spectra for all pairs of types would take more than 400 MB; state fewer of them");
  place_.reset(new CollisionPlace(lmp, regionID_, bins_));
  statistics_.reset(new Statistics(bins_, atom->ntypes, spectra_));

  restart_global = 1;
  nevery = 1;
  vector_flag = 1;
  size_vector = 5;
  global_freq = 1;
  extvector = 1;
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::parse_bins(FixArguments &in)
{
  const std::string axis = in.word("axis after bins: x, y or z");
  if (axis != "x" && axis != "y" && axis != "z") in.fail("the axis of bins must be x, y or z, not '" + axis + "'");
  bins_.axis = axis[0] - 'x';
  bins_.low = in.number("low of bins");
  bins_.high = in.number("high of bins");
  if (!(bins_.high > bins_.low)) in.fail("bins: low must be below high");
  bins_.count = in.count("number of bins after 'bins'", MOST_BINS);
}

void FixCollisionStats::parse_spectrum(FixArguments &in, const std::string &keyword, SpectrumBins &spectrum)
{
  spectrum.least = in.positive("min of " + keyword, 1e-100, 1e100);
  spectrum.most = in.positive("max of " + keyword, 1e-100, 1e100);
  if (!(spectrum.most > spectrum.least)) in.fail(keyword + ": min must be below max");
  spectrum.count = in.count("number of bins of " + keyword, MOST_SPECTRUM_BINS);
  if (!LogHistogram::valid(spectrum.least, spectrum.most, spectrum.count))
    in.fail(keyword + ": bins are too narrow; state fewer of them, or a wider range");
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::parse(int narg, char **arg)
{
  FixArguments in(error, narg, arg);
  while (in.more()) {
    const std::string keyword = in.keyword({"contact", "region", "bins", "energy", "speed", "force", "duration",
      "every", "file", "spectra", "stats_start"});
    if (keyword == "contact") contactID_ = in.word("ID of a fix hertz/cg after contact");
    else if (keyword == "region") regionID_ = in.word("ID of a region after region");
    else if (keyword == "bins") parse_bins(in);
    else if (keyword == "energy") parse_spectrum(in, keyword, spectra_[Statistics::ENERGY]);
    else if (keyword == "speed") parse_spectrum(in, keyword, spectra_[Statistics::SPEED]);
    else if (keyword == "force") parse_spectrum(in, keyword, spectra_[Statistics::FORCE]);
    else if (keyword == "duration") parse_spectrum(in, keyword, spectra_[Statistics::DURATION]);
    else if (keyword == "every") every_ = in.count("every");
    else if (keyword == "file") path_ = in.word("path after file");
    else if (keyword == "spectra") spectraPath_ = in.word("path after spectra");
    else start_ = in.nonNegative("stats_start");
  }
  if (contactID_.empty()) in.fail("missing keyword contact");
  if (path_.empty()) in.fail("missing keyword file");
  if (spectraPath_.empty()) {
    const std::string end = ".csv";
    const bool csv = path_.size() > end.size() && path_.compare(path_.size() - end.size(), end.size(), end) == 0;
    spectraPath_ = csv ? path_.substr(0, path_.size() - end.size()) + "_spectra.csv" : path_ + "_spectra";
  }
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::fail(const std::string &message) const
{
  const std::string text = std::string("Fix collision/stats (ID ") + id + "): " + message;
  error->all(FLERR, text.c_str());
  std::abort();    // never reached: Error::all ends the program
}

/* ---------------------------------------------------------------------- */

int FixCollisionStats::setmask()
{
  return POST_INTEGRATE | END_OF_STEP;
}

/* ----------------------------------------------------------------------
   the contacts of the fix that the script has named; NULL, and why
------------------------------------------------------------------------- */

ContactExchange *FixCollisionStats::find_contacts(std::string &fault) const
{
  const int found = modify->find_fix(contactID_.c_str());
  if (found < 0) {
    fault = "contact: no fix with ID '" + contactID_ + "'; define the fix hertz/cg before";
    return nullptr;
  }
  Fix *fix = modify->fix[found];
  if (strcmp(fix->style, "hertz/cg") != 0) {
    fault = "contact: fix '" + contactID_ + "' has style " + fix->style + ", but collisions are those of a fix hertz/cg";
    return nullptr;
  }
  int dim;
  const void *version = fix->extract("contact_version", dim);
  if (!version || strcmp(static_cast<const char *>(version), GRAINJET_VERSION) != 0) {
    fault = std::string("is of Grainjet " GRAINJET_VERSION ", but hertzcgplugin.so of ")
      + (version ? static_cast<const char *>(version) : "an earlier version") + "; load both from one build";
    return nullptr;
  }
  return static_cast<ContactExchange *>(fix->extract("contact_exchange", dim));
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::attach()
{
  std::string fault;
  ContactExchange *contacts = find_contacts(fault);
  if (contacts && !contacts->observed(this)) fault = contacts->observe(this, id, GrainCollision::SIZE);
  if (fault.empty()) fault = place_->attach();
  if (!fault.empty()) fail(fault);
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::post_create()
{
  attach();
  agree(comm->me == 0 ? check_files() : "");
}

/* ----------------------------------------------------------------------
   at the end of the program the other fix may be gone already
------------------------------------------------------------------------- */

void FixCollisionStats::pre_delete(bool unfixflag)
{
  if (!unfixflag) return;
  std::string fault;
  ContactExchange *contacts = find_contacts(fault);
  if (contacts) contacts->ignore(this);
}

/* ----------------------------------------------------------------------
   the script may have replaced the fix hertz/cg, or the region
------------------------------------------------------------------------- */

void FixCollisionStats::init()
{
  attach();
  if (strcmp(update->integrate_style, "verlet") != 0)
    fail(std::string("requires run_style verlet, not ") + update->integrate_style);
  agree(comm->me == 0 ? check_files() : "");
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::setup(int)
{
  if (clock_ < 0.0) {
    clock_ = update->get_cur_time();
    begin_ = std::max(clock_, start_);
  }
  place_->update();
  if (samples_ == 0.0 && clock_ >= begin_) count_grains();
  started_ = true;
}

/* ----------------------------------------------------------------------
   before the forces of the step
------------------------------------------------------------------------- */

void FixCollisionStats::post_integrate()
{
  clock_ += update->dt;
  place_->update();
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::end_of_step()
{
  if (update->ntimestep % COUNT_EVERY == 0 && clock_ >= begin_) count_grains();
  if (update->ntimestep % every_ == 0) write();
}

void FixCollisionStats::post_run()
{
  write();
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::count_grains()
{
  samples_ += 1.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    double x[3] = {atom->x[i][0], atom->x[i][1], atom->x[i][2]};
    if (place_->holds(x)) statistics_->addGrain(x, atom->type[i]);
  }
}

/* ----------------------------------------------------------------------
   Is it a collision to be looked at? Its contact point decides where it belongs
------------------------------------------------------------------------- */

bool FixCollisionStats::begins(const ContactStep &s, GrainCollision &c) const
{
  if (!(atom->mask[s.i] & atom->mask[s.j] & groupbit)) return false;
  const double arm = atom->radius[s.i] - 0.5 * s.overlap;
  const double *centre = atom->x[s.i];
  double x[3] = {centre[0] - arm * s.normal.x, centre[1] - arm * s.normal.y, centre[2] - arm * s.normal.z};
  if (!place_->holds(x)) return false;
  const double approach = grainjet::contact::dot(s.velocity, s.normal);
  c.place = 1.0 + statistics_->cell(x, atom->type[s.i], atom->type[s.j]);
  c.time = clock_;
  c.speed = grainjet::contact::length(s.velocity);
  c.normalEnergy = 0.5 * s.mass * approach * approach;
  c.tangentialEnergy = 0.5 * s.mass * grainjet::contact::dot(s.slip, s.slip);
  return true;
}

/* ----------------------------------------------------------------------
   Contacts that are there before the first step have no known beginning
------------------------------------------------------------------------- */

void FixCollisionStats::touches(const ContactStep &s, double *state)
{
  GrainCollision &c = *reinterpret_cast<GrainCollision *>(state);
  if (!s.advances) return;
  if (s.begins && begins(s, c) && counts(c) && s.counts) statistics_->begin(c.cell());
  if (c.place == 0.0) return;
  const double normal = grainjet::contact::dot(s.force, s.normal);
  const double tangential = grainjet::contact::length(s.force - normal * s.normal);
  c.normalPeak = c.duration == 0.0 ? normal : std::max(c.normalPeak, normal);
  c.tangentialPeak = std::max(c.tangentialPeak, tangential);
  c.loss -= s.work;
  c.duration += s.dt;
}

void FixCollisionStats::parted(const ContactStep &s, const double *state)
{
  GrainCollision c = *reinterpret_cast<const GrainCollision *>(state);
  c.loss -= s.work;
  if (s.counts && counts(c)) statistics_->add(c);
}

/* ----------------------------------------------------------------------
   Collisions of this rank that count and go on now. Between runs the other fix may be gone
------------------------------------------------------------------------- */

void FixCollisionStats::visit_counted(const std::function<void(const GrainCollision &)> &use) const
{
  std::string fault;
  const ContactExchange *contacts = find_contacts(fault);
  if (!contacts) return;
  contacts->visit(this, [&](bool here, const double *state) {
    const GrainCollision &c = *reinterpret_cast<const GrainCollision *>(state);
    if (here && counts(c)) use(c);
  });
}

/* ----------------------------------------------------------------------
   how many of them, of each cell; on rank 0
------------------------------------------------------------------------- */

std::vector<double> FixCollisionStats::touching() const
{
  std::vector<double> mine(statistics_->cells(), 0.0), all(mine);
  visit_counted([&](const GrainCollision &c) { mine[c.cell()] += 1.0; });
  MPI_Reduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_SUM, 0, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::sum_numbers()
{
  const Statistics::Cell all = statistics_->sum(0, 0);
  const grainjet::Moments &loss = all.moments[2];
  double sum[4] = {all.begun, loss.count(), loss.count() > 0.0 ? loss.count() * loss.mean() : 0.0, 0.0}, touching = 0.0;
  visit_counted([&](const GrainCollision &c) {
    touching += 1.0;
    sum[3] += c.loss;
  });
  MPI_Allreduce(MPI_IN_PLACE, sum, 4, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, &touching, 1, MPI_DOUBLE, MPI_SUM, world);
  const double list[5] = {sum[1], touching, sum[0] - sum[1] - touching, sum[2], sum[3]};
  std::copy(list, list + 5, numbers_);
  numbersStep_ = update->ntimestep;
}

double FixCollisionStats::compute_vector(int n)
{
  if (numbersStep_ != update->ntimestep || update->setupflag) sum_numbers();
  return numbers_[n];
}

/* ---------------------------------------------------------------------- */

double FixCollisionStats::memory_usage()
{
  return sizeof(double) * CollisionStatistics::numbers(statistics_->cells(), spectra_);
}
