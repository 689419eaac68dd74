/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_plate_stats.h"

#include "host/fix_arguments.h"

#include <cfloat>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

using namespace LAMMPS_NS;
using grainjet::FinishedCollision;
using grainjet::FixArguments;
using grainjet::PlateGeometry;
using grainjet::PlateStatistics;

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
  FixWallCollisions(lmp, narg, arg, grainjet::Collision::OF_PLATE)
{
  parse(narg, arg);
  surface_.reset(new WallSurface(lmp, wallID_, id, *plate_));
  statistics_.reset(new PlateStatistics(*plate_, has_temperature()));
  watch(*surface_);
  size_vector = 3;
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

void FixPlateStats::pre_delete(bool unfixflag)
{
  if (unfixflag) surface_->release();
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::update_surface(bool start)
{
  if (start || !surface_->at_rest()) surface_->update();
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::book(const std::vector<FinishedCollision> &all,
  const std::vector<grainjet::SlidingPiece> &)
{
  for (const FinishedCollision &collision : all) statistics_->add(collision);
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
