/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision-stats/collision_place.h"
#include "collision-stats/region_shape.h"

#include "comm.h"
#include "domain.h"
#include "region.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace LAMMPS_NS;
using grainjet::AxisBins;
namespace RegionShape = grainjet::RegionShape;

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

  shape_ = RegionShape::description(*domain, region_);

  Region *tets = comm->nprocs > 1 ? RegionShape::of_style(*domain, region_, "mesh/tet") : nullptr;
  if (tets)
    return std::string("region: '") + tets->id + "' is of style mesh/tet, which does not know contacts between two "
      "ranks; use another style, or one rank";
  return "";
}

/* ---------------------------------------------------------------------- */

void CollisionPlace::update()
{
  if (changes_) RegionShape::settle(*domain, region_);
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
  // slabs and what lies beside them add up to the whole
  const int fine = changes_ ? 80 : 160, LEAST = 8;
  volumes_.assign(1, 0.0);
  for (int slab = 0; slab < bins_.count; slab++)
    volumes_.push_back(volume(bins_.edge(slab), bins_.edge(slab + 1), std::max(fine / bins_.count, LEAST)));
  volumes_[0] = std::accumulate(volumes_.begin(), volumes_.end(), 0.0);
  volumes_[0] += volume(-HUGE_VAL, bins_.count > 0 ? bins_.edge(0) : HUGE_VAL, fine);
  if (bins_.count > 0) volumes_[0] += volume(bins_.edge(bins_.count), HUGE_VAL, fine);
  return volumes_;
}

/* ----------------------------------------------------------------------
   Between two coordinates along the axis of the slabs, in so many layers of cells. Each part of a union has a grid of
   its own, so that parts far from each other are resolved. Some million points in all, fewer where every output asks
   anew
------------------------------------------------------------------------- */

double CollisionPlace::volume(double from, double to, int layers)
{
  std::vector<Region *> parts(1, nullptr), before;
  if (region_) parts = RegionShape::parts(*domain, region_);
  const int COARSE = 20;
  const double share = 1.0 / std::cbrt(static_cast<double>(parts.size()));
  int n[3];
  std::fill(n, n + 3, std::max(static_cast<int>((changes_ ? 80 : 160) * share), COARSE));
  n[bins_.axis] = std::min(layers, n[bins_.axis]);

  double sum = 0.0;
  for (Region *part : parts) {
    before.push_back(part);
    double low[3], high[3], least[3], most[3];
    std::copy(box_, box_ + 3, low);
    std::copy(box_ + 3, box_ + 6, high);
    low[bins_.axis] = std::max(low[bins_.axis], from);
    high[bins_.axis] = std::min(high[bins_.axis], to);
    const bool bounded = part && RegionShape::extent(*domain, part, least, most);
    double all = 1.0;
    for (int d = 0; d < 3; d++) {
      if (bounded) low[d] = std::max(low[d], least[d]);
      if (bounded) high[d] = std::min(high[d], most[d]);
      all *= std::max(high[d] - low[d], 0.0);
    }
    sum += part && all > 0.0 ? all * inside(before, low, high, n) : all;
  }
  return sum;
}

/* ----------------------------------------------------------------------
   The share of a block that lies in the last of these regions and in none before. A point at random in each cell:
   centres of cells would err by a layer of them on a face along the grid. The numbers do not depend on ranks
------------------------------------------------------------------------- */

double CollisionPlace::inside(const std::vector<Region *> &parts, const double *low, const double *high, const int *n) const
{
  double sum = 0.0;
  for (int i = comm->me; i < n[0]; i += comm->nprocs) {
    std::mt19937 random(i + 1);
    const auto place = [&](int d, int cell) {
      const double within = (random() + 0.5) / 4294967296.0;
      return low[d] + (high[d] - low[d]) * (cell + within) / n[d];
    };
    for (int j = 0; j < n[1]; j++)
      for (int k = 0; k < n[2]; k++) {
        const double x = place(0, i), y = place(1, j), z = place(2, k);
        std::size_t first = 0;
        while (first < parts.size() && !parts[first]->match(x, y, z)) first++;
        if (first + 1 == parts.size()) sum += 1.0;
      }
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum / (1.0 * n[0] * n[1] * n[2]);
}
