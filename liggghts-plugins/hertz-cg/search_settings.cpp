/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/search_settings.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "lammps.h"
#include "neighbor.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace grainjet;

/* Settings that the host keeps to itself, reached through pointers to members; access is
   not checked in an explicit instantiation. No source of the host is touched.           */
namespace {

template <class Tag, typename Tag::type Member>
struct Expose {
  friend typename Tag::type member(Tag) { return Member; }
};

struct BinSizeFlag { typedef int Neighbor::*type; friend type member(BinSizeFlag); };
struct BinSize { typedef double Neighbor::*type; friend type member(BinSize); };
struct SortBinSize { typedef double Atom::*type; friend type member(SortBinSize); };

template struct Expose<BinSizeFlag, &Neighbor::binsizeflag>;
template struct Expose<BinSize, &Neighbor::binsize_user>;
template struct Expose<SortBinSize, &Atom::userbinsize>;

// never reached by the counter of steps since the last search; the host wants a multiple of `every`
int never(int every)
{
  return every * (1000000000 / every);
}

}

/* ---------------------------------------------------------------------- */

void SearchSettings::choose(double diameter, double packing, const WallAxes &walls)
{
  Neighbor *neighbor = lmp_->neighbor;
  if (!taken_ || neighbor->skin != skin_) userSkin_ = neighbor->skin;
  if (!taken_ || neighbor->delay != never(neighbor->every)) userDelay_ = neighbor->delay;
  taken_ = true;

  // The more dilute, the wider: a search costs the same however few pairs it finds. Two
  // diameters where nothing is there yet to judge by.
  diameter_ = diameter;
  double width = 2.0;
  if (packing > 0.0) width = std::min(std::max(std::cbrt(1.0 + 0.25 / packing) - 1.0, 0.2), 3.0);
  reach_ = kept_ > 0.0 ? kept_ : width * diameter;
  kept_ = 0.0;
  if (reach_ <= 0.0) reach_ = userSkin_;
  reach_ = std::max(reach_, least());
  // so much that walls hardly ever ask for a search before two grains do, nor need a look of their own
  skin_ = 0.55 * reach_ / walls.reach;

  neighbor->skin = skin_;
  neighbor->delay = never(neighbor->every);
  choose_bins(walls.mesh);
  choose_sorting();
}

/* ----------------------------------------------------------------------
   bins serve mesh walls only: about as many as there are grains
------------------------------------------------------------------------- */

void SearchSettings::choose_bins(bool meshWalls)
{
  Neighbor *neighbor = lmp_->neighbor;
  if (neighbor->*member(BinSizeFlag()) && !ownBins_) return;
  const double *prd = lmp_->domain->prd;
  const double thin = std::min(prd[0], std::min(prd[1], prd[2]));
  double size = thin;
  if (meshWalls) {
    const double bins = 1e5 + 2.0 * lmp_->atom->natoms;
    size = std::max(0.5 * (diameter_ + reach_), std::cbrt(prd[0] * prd[1] * prd[2] / bins));
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
  ownSortBins_ = true;
}

/* ---------------------------------------------------------------------- */

void SearchSettings::set_cutoff() const
{
  lmp_->neighbor->cutneighmax = diameter_ + skin_;
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
