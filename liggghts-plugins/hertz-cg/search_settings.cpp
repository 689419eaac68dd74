/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/search_settings.h"

#include "host/expose_member.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "lammps.h"
#include "neighbor.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace grainjet;

// Settings that the host keeps to itself
namespace grainjet {

struct BinSizeFlag { using type = int Neighbor::*; friend type member(BinSizeFlag); };
struct BinSize { using type = double Neighbor::*; friend type member(BinSize); };
struct SortBinSize { using type = double Atom::*; friend type member(SortBinSize); };
struct CommStyle { using type = int Comm::*; friend type member(CommStyle); };
struct BorderGroup { using type = int Comm::*; friend type member(BorderGroup); };

template struct Expose<BinSizeFlag, &Neighbor::binsizeflag>;
template struct Expose<BinSize, &Neighbor::binsize_user>;
template struct Expose<SortBinSize, &Atom::userbinsize>;
template struct Expose<CommStyle, &Comm::style>;
template struct Expose<BorderGroup, &Comm::bordergroup>;

}

namespace {

// never reached by the counter of steps since the last search; the host wants a multiple of `every`
int never(int every)
{
  return every * (1000000000 / every);
}

}

/* ---------------------------------------------------------------------- */

void SearchSettings::choose(const std::vector<double> &radius, double packing, const WallAxes &walls)
{
  Neighbor *neighbor = lmp_->neighbor;
  if (!taken_ || neighbor->skin != skin_) userSkin_ = neighbor->skin;
  if (!taken_ || neighbor->delay != never(neighbor->every)) userDelay_ = neighbor->delay;
  taken_ = true;

  radius_ = radius;
  diameter_ = 2.0 * *std::max_element(radius.begin(), radius.end());
  walls_ = walls;
  const bool kept = kept_.reach > 0.0;
  reach_ = kept ? kept_.reach : width(packing) * diameter_;
  // an empty box in which no grains are announced; the next run chooses anew
  if (reach_ <= 0.0) reach_ = userSkin_;
  reach_ = std::max(reach_, least());
  largestSkin_ = kept ? kept_.largestSkin : HUGE_VAL;
  limit_skin(kept ? kept_.skin : HUGE_VAL);
  if (!kept) largestSkin_ = skin_;

  neighbor->delay = never(neighbor->every);
  choose_bins();
  choose_sorting();
  kept_ = Lengths();
}

/* ----------------------------------------------------------------------
   pairs ~ 4 packing (1 + margin/diameter)^3, in a random arrangement. A change is worth its set-up
   only if it is large
------------------------------------------------------------------------- */

bool SearchSettings::adapt(const Work &work)
{
  if (work.pairs < 0.0 || diameter_ <= 0.0) return false;
  const auto far = [](double wanted, double is) { return wanted < 0.7 * is || wanted > 1.4 * is; };
  const double shell = 1.0 + work.margin / diameter_;
  const double reach = std::max(width(0.25 * work.pairs / (shell * shell * shell)) * diameter_, least());
  const double skin = walls_.mesh ? best_skin(work) : skin_;
  if (!far(reach, reach_) && !far(skin, skin_)) return false;
  if (far(reach, reach_)) reach_ = reach;
  limit_skin(skin);
  choose_bins();
  set_cutoff();
  return true;
}

/* ----------------------------------------------------------------------
   The skin for which searches and the triangles listed cost least: searches as often as it is smaller,
   triangles as the volume in which they lie. Not all in one step, since both are estimates.
------------------------------------------------------------------------- */

double SearchSettings::best_skin(const Work &work) const
{
  // a visit of a listed triangle costs as much as 6 of a listed pair of grains (measured)
  const double triangleVisit = 6.0;
  const double radius = 0.5 * diameter_;
  double best = skin_, least = HUGE_VAL;
  for (double s = 2.0 * skin_; s >= 0.45 * skin_; s *= 0.84) {
    const double shell = (radius + s) / (radius + skin_);
    const double cost = triangleVisit * work.triangles * shell * shell * shell + work.search * work.searches * skin_ / s;
    if (cost < least) { best = s; least = cost; }
  }
  return std::min(best, largestSkin_);
}

/* ----------------------------------------------------------------------
   The reach in diameters. The more dilute, the wider: a search costs the same however few pairs
   it finds. Two diameters where nothing is there yet to judge by.
------------------------------------------------------------------------- */

double SearchSettings::width(double packing) const
{
  double width = 2.0;
  if (packing > 0.0) width = std::min(std::max(std::cbrt(1.0 + 0.25 / packing) - 1.0, 0.2), 3.0);
  if (diameter_ <= 0.0) return width;
  // lists of triangles make searches dear; then as wide as the stock pair style would go
  if (walls_.mesh) width = std::max(width, std::min(userSkin_ / diameter_, 1.0));
  // no grain's own images, and no ghosts of ghosts, only to search less often
  return std::min(width, std::max(0.2, 0.5 * narrowest() / diameter_));
}

/* ----------------------------------------------------------------------
   so much that walls hardly ever ask for a search before two grains do, nor need a look of their own
------------------------------------------------------------------------- */

void SearchSettings::limit_skin(double skin)
{
  skin_ = 0.55 * reach_ / walls_.reach;
  if (walls_.mesh) {
    // not so little, `neighbor 0` for one, that every step is a search
    const double most = std::max(std::min(userSkin_, largestSkin_), 0.02 * diameter_);
    skin_ = std::min(skin_, std::min(most, std::max(skin, 0.02 * diameter_)));
  }
  lmp_->neighbor->skin = skin_;
}

/* ---------------------------------------------------------------------- */

double SearchSettings::part(int d) const
{
  const Domain *domain = lmp_->domain;
  if (domain->dimension == 2 && d == 2) return HUGE_VAL;
  if (!domain->periodicity[d] && lmp_->comm->procgrid[d] == 1) return HUGE_VAL;
  return domain->prd[d] / lmp_->comm->procgrid[d];
}

/* ---------------------------------------------------------------------- */

int SearchSettings::ghost_group() const
{
  return lmp_->comm->*member(BorderGroup());
}

/* ---------------------------------------------------------------------- */

bool SearchSettings::outgrown(const std::vector<double> &radius) const
{
  for (std::size_t type = 1; type < radius.size(); ++type)
    if (!known(static_cast<int>(type), radius[type])) return true;
  return false;
}

void SearchSettings::grow(const std::vector<double> &radius)
{
  for (std::size_t type = 0; type < radius.size(); ++type) radius_[type] = std::max(radius_[type], radius[type]);
  diameter_ = 2.0 * *std::max_element(radius_.begin(), radius_.end());
  choose_bins();
  set_cutoff();
}

/* ---------------------------------------------------------------------- */

bool SearchSettings::known(int type, double radius) const
{
  if (2.0 * radius > diameter_) return false;
  const bool multi = lmp_->comm->*member(CommStyle()) != 0;
  return !multi || radius <= radius_[type];
}

/* ----------------------------------------------------------------------
   Bins serve mesh walls only: about as many as there are grains. A triangle looks at all bins so far
   away as the cut-off, mostly empty ones; of half the size they would be five times as many.
------------------------------------------------------------------------- */

void SearchSettings::choose_bins()
{
  Neighbor *neighbor = lmp_->neighbor;
  if (neighbor->*member(BinSizeFlag()) && !ownBins_) return;
  const double *prd = lmp_->domain->prd;
  const double thin = std::min(prd[0], std::min(prd[1], prd[2]));
  double size = thin;
  if (walls_.mesh) {
    const double bins = 1e5 + 2.0 * lmp_->atom->natoms;
    size = std::max(diameter_ + skin_, std::cbrt(prd[0] * prd[1] * prd[2] / bins));
  }
  // the host refuses bins much larger than the box is thick
  neighbor->*member(BinSize()) = std::min(size, 50.0 * thin);
  neighbor->*member(BinSizeFlag()) = 1;
  ownBins_ = true;
}

/* ----------------------------------------------------------------------
   grains are sorted in memory by bins of about half a grain on average
------------------------------------------------------------------------- */

void SearchSettings::choose_sorting()
{
  double &size = lmp_->atom->*member(SortBinSize());
  if (size > 0.0 && !ownSortBins_) return;
  const double *prd = lmp_->domain->prd;
  const double bins = 1e4 + 2.0 * lmp_->atom->natoms;
  size = std::max(0.5 * (diameter_ + reach_), std::cbrt(prd[0] * prd[1] * prd[2] / bins));
  if (kept_.sortBin > 0.0) size = kept_.sortBin;
  ownSortBins_ = true;
}

/* ---------------------------------------------------------------------- */

SearchSettings::Lengths SearchSettings::lengths() const
{
  Lengths lengths;
  lengths.reach = reach_;
  lengths.skin = skin_;
  lengths.largestSkin = largestSkin_;
  lengths.sortBin = lmp_->atom->*member(SortBinSize());
  return lengths;
}

/* ----------------------------------------------------------------------
   `communicate multi` goes by the types' own cut-offs alone
------------------------------------------------------------------------- */

void SearchSettings::set_cutoff() const
{
  Neighbor *neighbor = lmp_->neighbor;
  neighbor->cutneighmax = diameter_ + skin_;
  for (int type = 1; type <= lmp_->atom->ntypes; ++type)
    neighbor->cuttype[type] = 0.5 * diameter_ + radius_[type] + std::max(reach_, skin_);
}

/* ---------------------------------------------------------------------- */

void SearchSettings::restore()
{
  if (!taken_) return;
  lmp_->neighbor->skin = userSkin_;
  lmp_->neighbor->delay = userDelay_;
  if (ownBins_) lmp_->neighbor->*member(BinSizeFlag()) = 0;
  if (ownSortBins_) lmp_->atom->*member(SortBinSize()) = 0.0;
  taken_ = ownBins_ = ownSortBins_ = false;
}
