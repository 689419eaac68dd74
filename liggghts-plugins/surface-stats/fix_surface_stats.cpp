/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_surface_stats.h"

#include "physics/wear/wear_laws.h"

#include "atom.h"
#include "comm.h"
#include "update.h"

#include <algorithm>
#include <cfloat>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

using namespace LAMMPS_NS;
using grainjet::FinishedCollision;
using grainjet::FixArguments;
using grainjet::ImpactSpectra;
using grainjet::ImpactSums;
using grainjet::LogHistogram;
using grainjet::MapSeries;
using grainjet::SlidingPiece;
using grainjet::SurfaceStatistics;

// Of a spectrum: each bin is a row of the file
static const int MOST_BINS = 10000;

/* ---------------------------------------------------------------------- */

FixSurfaceStats::FixSurfaceStats(LAMMPS *lmp, int narg, char **arg) :
  FixWallCollisions(lmp, narg, arg, grainjet::Collision::OF_SURFACE),
  speed_{1e-3, 1e3, 60}, energy_{1e-15, 1e3, 180}, placed_(false), mapped_(-1),
  mappedTime_(-1.0)
{
  parse(narg, arg);
  surface_.reset(new MeshSurface(lmp, wallID_, meshIDs_));
  statistics_.reset(new SurfaceStatistics(meshIDs_.size(), law_, has_temperature()));
  spectra_.reset(new ImpactSpectra(speed_, energy_));
  follow_sliding();
  watch(*surface_);
  size_vector = 6;
}

/* ---------------------------------------------------------------------- */

static const char *const KEYWORDS[] = {"mesh", "wall", "wear", "every", "file", "vtk", "events", "spectra", "speed",
  "energy", "stats_start"};

static bool is_keyword(const std::string &word)
{
  return std::find(std::begin(KEYWORDS), std::end(KEYWORDS), word) != std::end(KEYWORDS);
}

static std::string keyword_list()
{
  std::string list;
  for (const char *keyword : KEYWORDS) list += (list.empty() ? "" : ", ") + std::string(keyword);
  return list;
}

/* ---------------------------------------------------------------------- */

static ImpactSpectra::Range range(FixArguments &arguments, const std::string &what)
{
  ImpactSpectra::Range range;
  range.least = arguments.positive("lowest value after '" + what + "'");
  range.most = arguments.positive("highest value after '" + what + "'");
  range.bins = arguments.count("number of bins after '" + what + "'", MOST_BINS);
  if (!LogHistogram::valid(range.least, range.most, range.bins))
    arguments.fail("the highest value after '" + what + "' must be above the lowest");
  return range;
}

/* ---------------------------------------------------------------------- */

void FixSurfaceStats::parse(int narg, char **arg)
{
  FixArguments arguments(error, narg, arg);
  std::set<std::string> given;
  while (arguments.more()) {
    const std::string keyword = arguments.word("keyword");
    if (keyword == "mesh") {
      const std::string mesh = arguments.word("ID of a fix mesh/surface after 'mesh'");
      if (std::find(meshIDs_.begin(), meshIDs_.end(), mesh) != meshIDs_.end())
        arguments.fail("mesh '" + mesh + "' is given twice");
      meshIDs_.push_back(mesh);
      continue;
    }
    if (!given.insert(keyword).second) arguments.fail("keyword '" + keyword + "' is given twice");
    if (keyword == "wall") wallID_ = arguments.word("ID of a fix wall/gran after 'wall'");
    else if (keyword == "wear") parse_wear(arguments);
    else if (keyword == "every") every_ = arguments.count("every");
    else if (keyword == "file") path_ = arguments.word("path after 'file'");
    else if (keyword == "vtk") vtkPath_ = arguments.word("path after 'vtk'");
    else if (keyword == "events") eventsPath_ = arguments.word("path after 'events'");
    else if (keyword == "spectra") spectraPath_ = arguments.word("path after 'spectra'");
    else if (keyword == "speed") speed_ = range(arguments, "speed");
    else if (keyword == "energy") energy_ = range(arguments, "energy");
    else if (keyword == "stats_start") start_ = arguments.nonNegative("stats_start", DBL_MAX);
    else
      arguments.fail("unknown keyword '" + keyword + "'; valid keywords are " + keyword_list());
  }
  const std::pair<const char *, bool> required[] =
    {{"mesh", !meshIDs_.empty()}, {"wall", !wallID_.empty()}, {"file", !path_.empty()}};
  for (const auto &item : required)
    if (!item.second) arguments.fail(std::string("missing keyword ") + item.first);
  for (const char *word : {"speed", "energy"})
    if (given.count(word) && spectraPath_.empty())
      arguments.fail(std::string("keyword ") + word + " sets the bins of a file: give spectra <path>");
  series_.reset(new MapSeries(vtkPath_));
  if (vtkPath_.empty()) return;
  const std::string fault = series_->check();
  if (!fault.empty()) arguments.fail(fault);
}

/* ----------------------------------------------------------------------
   the law's name, then its coefficients, up to a word that is none of them
------------------------------------------------------------------------- */

void FixSurfaceStats::parse_wear(FixArguments &arguments)
{
  const std::string name =
    arguments.word("law of wear after 'wear': " + grainjet::wear::wearLawNames());
  wear_ = name;
  try {
    std::vector<std::string> words = arguments.rest();
    const std::size_t own = grainjet::wear::coefficientWords(name, words);
    if (own < words.size() && !is_keyword(words[own]))
      arguments.fail("wear " + name + " has no coefficient '" + words[own] + "', nor is that a keyword of the fix; it has "
        + describe(grainjet::wear::findWearLaw(name).coefficients()));
    words.resize(own);
    for (const std::string &word : words) wear_ += " " + arguments.word(word);
    law_ = grainjet::wear::makeWearLaw(name, words);
  } catch (const std::invalid_argument &fault) {
    arguments.fail(fault.what());
  }
}

/* ---------------------------------------------------------------------- */

void FixSurfaceStats::post_create()
{
  FixWallCollisions::post_create();
  statistics_->size(triangles());
}

/* ---------------------------------------------------------------------- */

void FixSurfaceStats::init()
{
  FixWallCollisions::init();
  placed_ = false;    // between runs a mesh can have been put elsewhere
}

/* ---------------------------------------------------------------------- */

std::string FixSurfaceStats::attach_surface()
{
  const std::string fault = surface_->attach();
  if (!fault.empty() || restarted_.empty()) return fault;
  const std::vector<int> here = triangles();
  for (std::size_t m = 0; m < here.size(); m++)
    if (here[m] != restarted_[m])
      return "in the restart file mesh '" + meshIDs_[m] + "' has " + std::to_string(restarted_[m])
        + " triangles, here " + std::to_string(here[m]) + "; use that mesh, or another fix ID";
  restarted_.clear();
  return "";
}

/* ---------------------------------------------------------------------- */

std::vector<int> FixSurfaceStats::triangles() const
{
  std::vector<int> list;
  for (int m = 0; m < surface_->meshes(); m++) list.push_back(surface_->triangles(m));
  return list;
}

/* ---------------------------------------------------------------------- */

void FixSurfaceStats::book(const std::vector<FinishedCollision> &all,
  const std::vector<SlidingPiece> &slid)
{
  for (const FinishedCollision &collision : all) {
    statistics_->add(collision);
    spectra_->add(collision);
  }
  for (const SlidingPiece &piece : slid) statistics_->add(piece);
}

/* ---------------------------------------------------------------------- */

double FixSurfaceStats::compute_vector(int n)
{
  gather();
  const std::vector<double> now = touching();
  ImpactSums total = statistics_->sums(0);
  for (const SlidingPiece &piece : sliding(tracker_->sliding()))
    total.slide(piece.work, statistics_->sliding_wear(piece.work));
  double values[6] = {total.impacts, now[0], begun_[0] - total.impacts - now[0],
    total.mass, total.loss, total.wear};
  MPI_Bcast(values, 6, MPI_DOUBLE, 0, world);
  return values[n];
}

/* ---------------------------------------------------------------------- */

double FixSurfaceStats::memory_usage()
{
  double bytes = FixWallCollisions::memory_usage();
  for (int m = 0; m < surface_->meshes(); m++)
    bytes += surface_->triangles(m) * (sizeof(int) + (comm->me == 0 ? 10 * sizeof(double) : 0.0));
  return bytes;
}
