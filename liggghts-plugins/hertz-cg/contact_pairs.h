/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_PAIRS_H
#define GRAINJET_CONTACT_PAIRS_H

#include "hertz-cg/cell_grid.h"
#include "hertz-cg/contact_store.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace grainjet {

/* The pairs of grains that may touch until the next search, packed one after the other, and
   the contacts among them. A pair of two owned grains is listed once, a pair with a ghost on
   either rank (newton off).

   Kept in three parallel arrays: what every step reads of every pair (16 bytes), one byte of
   marks, and the contact, which is read only where two grains touch.                       */
class ContactPairs {
 public:

  struct Pair {
    int i, j;         // indices; i is always owned, j may be a ghost
    double reach2;    // m2, squared sum of the radii
  };

  enum Mark : unsigned char { TOUCHING = 1, DEEP = 2 };   // DEEP: overlap has been reported

  // arrays of grains of the host, owned ones first, then ghosts
  struct Grains {
    int nowned, nall;
    const double *x;          // 3 per grain
    const double *radius;
    const int *tag;           // ID
    const int *mask;          // group bits
    int group;                // only pairs with both grains in this group bit are listed
    int frozen;               // pairs with both grains in this group bit are not; 0: no such group
    bool narrow = false;      // may two grains touch through two images? (periodic, narrower than two diameters)
  };

  // List the pairs closer than margin and take up their contacts from the store.
  // earlier: the positions are those of a moment before the contacts began, so grains may be apart.
  // Returns false if a grain's position is not a finite number.
  bool build(const Grains &grains, double margin, const ContactStore &store, bool earlier = false);

  // Write the contacts to both grains in the store
  void save(ContactStore &store) const;

  std::size_t size() const { return pairs.size(); }
  std::size_t bytes() const;

  std::vector<Pair> pairs;
  std::vector<unsigned char> marks;
  std::vector<Contact> contacts;     // valid where marked TOUCHING
  std::vector<double> rows;          // what observers keep of them, ContactStore::row() numbers each

  double *row(std::size_t p) { return rows.data() + p * row_; }
  const double *row(std::size_t p) const { return rows.data() + p * row_; }
  void clearRow(std::size_t p) { std::fill_n(row(p), row_, 0.0); }
  void layOut(const std::vector<int> &from);    // as layOutRows()

 private:

  struct Tags { int i, j; };

  CellGrid grid_;
  std::vector<Tags> tags_;   // the host's IDs may be overwritten before save()
  int nowned_ = 0;
  std::size_t row_ = 0;
};

}

#endif
