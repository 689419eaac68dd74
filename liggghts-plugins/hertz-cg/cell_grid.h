/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CELL_GRID_H
#define GRAINJET_CELL_GRID_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace grainjet {

/* Finds the pairs of spheres whose surfaces are closer than a margin.

   Spheres are sorted by the number of the cell that holds their centre, counted row by row
   over the whole extent. Only cells that hold a sphere exist, so time and memory go with the
   number of spheres and not with the volume they are spread over. A row of neighbouring cells
   is one contiguous piece of the sorted order, and while the cells are visited in that order
   the pieces that belong to it move only forward: the search is a merge of a few sorted
   streams without any look-up.

   Host-free: it sees plain arrays.                                                        */
class CellGrid {
 public:

  /* Sort n spheres. x: centres, 3 n values; radius: n values; margin >= 0 [same unit].
     nowned: only pairs with at least one of the first nowned spheres are of interest.
     Returns false if a centre is not a finite number (no search is possible then).      */
  bool sort(int n, int nowned, const double *x, const double *radius, double margin);

  // Call visit(i, j) once for every pair found by sort()'s margin; i, j in no special order
  template <class Visit> void pairs(Visit visit) const;

  // index of the first sphere with a centre that is not finite, -1 if there is none
  static int firstInvalid(int n, const double *x);

  std::size_t bytes() const;

 private:

  struct Item { std::uint64_t key; int index; };

  void choose_cells(int n, const double *x, const double *radius);
  void sort_items(std::uint64_t largest);

  int nowned_ = 0;
  double margin_ = 0.0;
  double lo_[3], inverse_ = 1.0;        // corner of the grid, 1/cell size
  std::uint64_t ncell_[3];              // cells in x, y, z with guard cells in x and y
  int reach_ = 1;                       // cells to look at on either side
  std::vector<Item> items_, scratch_;
  std::vector<double> xs_, ys_, zs_, rs_;   // in sorted order
  std::vector<std::int64_t> rows_;          // key distances of the rows after a cell's own
};

template <class Visit>
void CellGrid::pairs(Visit visit) const
{
  const int n = static_cast<int>(items_.size());
  const int nrows = static_cast<int>(rows_.size());
  const std::int64_t reach = reach_;
  std::vector<int> first(nrows, 0), last(nrows, 0);
  int ownEnd = 0;

  const auto key = [this](int p) { return static_cast<std::int64_t>(items_[p].key); };
  const auto test = [&](int p, int from, int to) {
    const double x = xs_[p], y = ys_[p], z = zs_[p], r = rs_[p] + margin_;
    const int i = items_[p].index;
    for (int q = from; q < to; ++q) {
      const double dx = xs_[q] - x, dy = ys_[q] - y, dz = zs_[q] - z, cut = rs_[q] + r;
      if (dx * dx + dy * dy + dz * dz < cut * cut) {
        const int j = items_[q].index;
        if (i < nowned_ || j < nowned_) visit(i, j);
      }
    }
  };

  for (int begin = 0; begin < n;) {
    const std::int64_t k = key(begin);
    int end = begin + 1;
    while (end < n && key(end) == k) ++end;
    if (ownEnd < end) ownEnd = end;
    while (ownEnd < n && key(ownEnd) <= k + reach) ++ownEnd;
    for (int row = 0; row < nrows; ++row) {
      const std::int64_t from = k + rows_[row] - reach, to = k + rows_[row] + reach;
      while (first[row] < n && key(first[row]) < from) ++first[row];
      if (last[row] < first[row]) last[row] = first[row];
      while (last[row] < n && key(last[row]) <= to) ++last[row];
    }
    for (int p = begin; p < end; ++p) {
      test(p, p + 1, ownEnd);
      for (int row = 0; row < nrows; ++row)
        if (first[row] < last[row]) test(p, first[row], last[row]);
    }
    begin = end;
  }
}

}

#endif
