/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision-stats/collision_place.h"

#include "comm.h"
#include "domain.h"
#include "region.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using grainjet::AxisBins;

/* ---------------------------------------------------------------------- */

CollisionPlace::CollisionPlace(LAMMPS *lmp, const std::string &region, const AxisBins &bins) :
  Pointers(lmp), id_(region), bins_(bins), region_(nullptr), changes_(false), box_()
{}

/* ----------------------------------------------------------------------
   The host's region mesh/tet holds points of the rank's own part of the box only; a contact of two ranks
   can lie in either
------------------------------------------------------------------------- */

std::string CollisionPlace::attach()
{
  volumes_.clear();
  if (id_.empty()) return "";
  std::vector<char> id(id_.begin(), id_.end());
  id.push_back('\0');
  const int found = domain->find_region(id.data());
  if (found < 0) return "region: no region with ID '" + id_ + "'; define it before";
  region_ = domain->regions[found];
  changes_ = region_->dynamic_check() || region_->varshape;

  const bool combined = strcmp(region_->style, "union") == 0 || strcmp(region_->style, "intersect") == 0;
  for (int n = 0; comm->nprocs > 1 && n < domain->nregion; n++) {
    const bool part = domain->regions[n] == region_ || combined;
    if (part && strcmp(domain->regions[n]->style, "mesh/tet") == 0)
      return std::string("region: '") + domain->regions[n]->id + "' is of style mesh/tet, which does not know "
        "contacts between two ranks; use another style, or one rank";
  }
  return "";
}

/* ---------------------------------------------------------------------- */

void CollisionPlace::update()
{
  if (changes_) region_->prematch();
}

/* ---------------------------------------------------------------------- */

bool CollisionPlace::holds(double *x) const
{
  domain->remap(x);
  return !region_ || region_->match(x);
}

/* ---------------------------------------------------------------------- */

const std::vector<double> &CollisionPlace::volumes()
{
  const double box[6] = {domain->boxlo[0], domain->boxlo[1], domain->boxlo[2],
    domain->boxhi[0], domain->boxhi[1], domain->boxhi[2]};
  if (!changes_ && !volumes_.empty() && std::equal(box, box + 6, box_)) return volumes_;
  std::copy(box, box + 6, box_);
  update();
  volumes_.clear();
  for (int slab = -1; slab < bins_.count; slab++) volumes_.push_back(volume(slab));
  return volumes_;
}

/* ----------------------------------------------------------------------
   of a slab; -1: of all
------------------------------------------------------------------------- */

double CollisionPlace::volume(int slab)
{
  double low[3], high[3];
  std::copy(box_, box_ + 3, low);
  std::copy(box_ + 3, box_ + 6, high);
  if (slab >= 0) {
    low[bins_.axis] = std::max(low[bins_.axis], bins_.edge(slab));
    high[bins_.axis] = std::min(high[bins_.axis], bins_.edge(slab + 1));
  }
  // what the host says of a moving region's extent is that of its start
  if (region_ && region_->bboxflag && !changes_) {
    const double least[3] = {region_->extent_xlo, region_->extent_ylo, region_->extent_zlo};
    const double most[3] = {region_->extent_xhi, region_->extent_yhi, region_->extent_zhi};
    for (int d = 0; d < 3; d++) {
      low[d] = std::max(low[d], least[d]);
      high[d] = std::min(high[d], most[d]);
    }
  }
  double all = 1.0;
  for (int d = 0; d < 3; d++) all *= std::max(high[d] - low[d], 0.0);
  return region_ && all > 0.0 ? all * inside(low, high) : all;
}

/* ----------------------------------------------------------------------
   The share of a block that lies in the region; some million points in all, divided among the ranks, and fewer where
   every output asks anew
------------------------------------------------------------------------- */

double CollisionPlace::inside(const double *low, const double *high) const
{
  const int FINE = changes_ ? 80 : 160, LEAST = 8;
  int n[3] = {FINE, FINE, FINE};
  if (bins_.count > 0) n[bins_.axis] = std::max(FINE / bins_.count, LEAST);
  const auto place = [&](int d, int i) { return low[d] + (high[d] - low[d]) * (i + 0.5) / n[d]; };
  double sum = 0.0;
  for (int i = comm->me; i < n[0]; i += comm->nprocs)
    for (int j = 0; j < n[1]; j++)
      for (int k = 0; k < n[2]; k++)
        sum += region_->match(place(0, i), place(1, j), place(2, k)) ? 1.0 : 0.0;
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum / (1.0 * n[0] * n[1] * n[2]);
}
