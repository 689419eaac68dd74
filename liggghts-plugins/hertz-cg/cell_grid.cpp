/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/cell_grid.h"

#include <algorithm>
#include <cmath>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

int CellGrid::firstInvalid(int n, const double *x)
{
  for (int i = 0; i < 3 * n; ++i)
    if (!std::isfinite(x[i])) return i / 3;
  return -1;
}

/* ---------------------------------------------------------------------- */

bool CellGrid::sort(int n, int nowned, const double *x, const double *radius, double margin)
{
  nowned_ = nowned;
  margin_ = margin;
  items_.clear();
  if (n == 0) return true;
  if (firstInvalid(n, x) >= 0) return false;

  choose_cells(n, x, radius);

  items_.resize(n);
  std::uint64_t largest = 0;
  for (int i = 0; i < n; ++i) {
    const std::uint64_t ix = static_cast<std::uint64_t>((x[3 * i] - lo_[0]) * inverse_) + reach_;
    const std::uint64_t iy = static_cast<std::uint64_t>((x[3 * i + 1] - lo_[1]) * inverse_) + reach_;
    const std::uint64_t iz = static_cast<std::uint64_t>((x[3 * i + 2] - lo_[2]) * inverse_);
    const std::uint64_t key = (iz * ncell_[1] + iy) * ncell_[0] + ix;
    items_[i] = {key, i};
    largest = std::max(largest, key);
  }
  sort_items(largest);

  xs_.resize(n); ys_.resize(n); zs_.resize(n); rs_.resize(n);
  for (int p = 0; p < n; ++p) {
    const int i = items_[p].index;
    xs_[p] = x[3 * i];
    ys_[p] = x[3 * i + 1];
    zs_[p] = x[3 * i + 2];
    rs_[p] = radius[i];
  }
  return true;
}

/* ----------------------------------------------------------------------
   cells as wide as the largest reach of a pair; half as wide, with twice the
   cells to look at, where spheres are so crowded that fewer vain distance
   tests are worth more than fewer rows
------------------------------------------------------------------------- */

void CellGrid::choose_cells(int n, const double *x, const double *radius)
{
  double hi[3];
  for (int d = 0; d < 3; ++d) lo_[d] = hi[d] = x[d];
  double rmax = radius[0];
  for (int i = 0; i < n; ++i) {
    for (int d = 0; d < 3; ++d) {
      lo_[d] = std::min(lo_[d], x[3 * i + d]);
      hi[d] = std::max(hi[d], x[3 * i + d]);
    }
    rmax = std::max(rmax, radius[i]);
  }

  const double reach = 2.0 * rmax + margin_;
  double volume = 1.0;
  for (int d = 0; d < 3; ++d) volume *= hi[d] - lo_[d] + reach;
  const double crowding = n * reach * reach * reach / volume;
  reach_ = crowding > 2.0 ? 2 : 1;

  // a little wider than needed, so that round-off cannot put a pair one cell further apart;
  // and a cell number has to fit 63 bits whatever the extent
  double size = (1.0 + 1e-9) * reach / reach_;
  for (int d = 0; d < 3; ++d) size = std::max(size, (hi[d] - lo_[d]) / (1 << 20));
  inverse_ = 1.0 / size;
  for (int d = 0; d < 3; ++d)
    ncell_[d] = static_cast<std::uint64_t>((hi[d] - lo_[d]) * inverse_) + 1 + 2 * reach_;

  rows_.clear();
  const std::int64_t row = ncell_[0], layer = ncell_[0] * ncell_[1];
  for (int dy = 1; dy <= reach_; ++dy) rows_.push_back(dy * row);
  for (int dz = 1; dz <= reach_; ++dz)
    for (int dy = -reach_; dy <= reach_; ++dy) rows_.push_back(dz * layer + dy * row);
}

/* ----------------------------------------------------------------------
   radix sort by key, 11 bits at a time; stable, so that equal input gives
   equal order
------------------------------------------------------------------------- */

void CellGrid::sort_items(std::uint64_t largest)
{
  const int bits = 11, buckets = 1 << bits;
  scratch_.resize(items_.size());
  std::vector<int> count(buckets);
  for (int shift = 0; shift < 64 && (largest >> shift) > 0; shift += bits) {
    std::fill(count.begin(), count.end(), 0);
    for (const Item &item : items_) ++count[(item.key >> shift) & (buckets - 1)];
    int sum = 0;
    for (int &c : count) { const int here = c; c = sum; sum += here; }
    for (const Item &item : items_) scratch_[count[(item.key >> shift) & (buckets - 1)]++] = item;
    items_.swap(scratch_);
  }
}

/* ---------------------------------------------------------------------- */

std::size_t CellGrid::bytes() const
{
  return (items_.capacity() + scratch_.capacity()) * sizeof(Item)
    + (xs_.capacity() + ys_.capacity() + zs_.capacity() + rs_.capacity()) * sizeof(double);
}
