/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/contact_pairs.h"

#include <algorithm>
#include <utility>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

bool ContactPairs::build(const Grains &g, double margin, const ContactStore &store, bool earlier)
{
  pairs.clear();
  marks.clear();
  tags_.clear();
  nowned_ = g.nowned;
  if (!grid_.sort(g.nall, g.nowned, g.x, g.radius, margin)) {
    contacts.clear();
    return false;
  }

  grid_.pairs([&](int i, int j) {
    if (i > j) std::swap(i, j);
    if (!(g.mask[i] & g.mask[j] & g.group) || (g.mask[i] & g.mask[j] & g.frozen)) return;
    const double reach = g.radius[i] + g.radius[j];
    pairs.push_back({i, j, reach * reach});
    tags_.push_back({g.tag[i], g.tag[j]});
  });

  marks.assign(pairs.size(), 0);
  contacts.resize(pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const int i = pairs[p].i, j = pairs[p].j;
    for (int n = 0; n < store.count(i); ++n) {
      const ContactStore::Entry &e = store.entries(i)[n];
      if (e.partner != tags_[p].j) continue;
      // in a narrow periodic box another image of the same grain may be listed too
      const double *a = g.x + 3 * i, *b = g.x + 3 * j;
      const double dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
      if (!earlier && dx * dx + dy * dy + dz * dz > 1.2 * pairs[p].reach2) break;
      marks[p] = static_cast<unsigned char>(e.marks);
      contacts[p] = e.contact;
      break;
    }
  }
  return true;
}

/* ---------------------------------------------------------------------- */

void ContactPairs::save(ContactStore &store) const
{
  store.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (!(marks[p] & TOUCHING)) continue;
    store.add(pairs[p].i, {tags_[p].j, marks[p], contacts[p]});
    if (pairs[p].j < nowned_)
      store.add(pairs[p].j, {tags_[p].i, marks[p], contacts[p].mirrored()});
  }
  store.finish();
}

/* ---------------------------------------------------------------------- */

std::size_t ContactPairs::bytes() const
{
  return pairs.capacity() * sizeof(Pair) + marks.capacity() + tags_.capacity() * sizeof(Tags)
    + contacts.capacity() * sizeof(Contact) + grid_.bytes();
}
