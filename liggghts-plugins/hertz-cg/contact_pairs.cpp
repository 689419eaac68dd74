/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/contact_pairs.h"

#include <algorithm>
#include <utility>

using namespace grainjet;

/* ----------------------------------------------------------------------
   How little a remembered contact fits the direction between two grains: its force has the twist n x Ft for
   its own normal n only, and mostly pushes
------------------------------------------------------------------------- */

static double strangeness(const Contact &c, const contact::Vector3 &delta)
{
  const double force = contact::length(c.force), distance = contact::length(delta);
  if (!(force > 0.0 && distance > 0.0)) return 0.5;
  const contact::Vector3 normal = (1.0 / distance) * delta;
  const double twist = contact::length(contact::cross(normal, c.force) - c.twist) / force;
  return twist + (contact::dot(c.force, normal) < 0.0 ? 0.5 : 0.0);
}

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
  row_ = store.row();
  rows.assign(pairs.size() * row_, 0.0);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const int i = pairs[p].i, j = pairs[p].j;
    const double *a = g.x + 3 * i, *b = g.x + 3 * j;
    const contact::Vector3 delta = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    // in a narrow periodic box another image of the same grain may be listed too
    if (!earlier && contact::dot(delta, delta) > 1.2 * pairs[p].reach2) continue;
    const ContactStore::Entry *best = nullptr;
    int place = 0;
    double least = 1.0;
    for (int n = 0; n < store.count(i); ++n) {
      const ContactStore::Entry &e = store.entries(i)[n];
      if (e.partner != tags_[p].j) continue;
      // and may touch too
      const double strange = g.narrow ? strangeness(e.contact, delta) : 0.0;
      if (!(strange < least)) continue;
      best = &e;
      place = n;
      least = strange;
    }
    if (!best) continue;
    marks[p] = static_cast<unsigned char>(best->marks);
    contacts[p] = best->contact;
    std::copy_n(store.row(i, place), row_, row(p));
  }
  return true;
}

/* ---------------------------------------------------------------------- */

void ContactPairs::save(ContactStore &store) const
{
  store.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (!(marks[p] & TOUCHING)) continue;
    store.add(pairs[p].i, {tags_[p].j, marks[p], contacts[p]}, row(p));
    if (pairs[p].j < nowned_)
      store.add(pairs[p].j, {tags_[p].i, marks[p], contacts[p].mirrored()}, row(p));
  }
  store.finish();
}

/* ---------------------------------------------------------------------- */

void ContactPairs::layOut(const std::vector<int> &from)
{
  layOutRows(rows, row_, pairs.size(), from);
  row_ = from.size();
}

/* ---------------------------------------------------------------------- */

std::size_t ContactPairs::bytes() const
{
  return pairs.capacity() * sizeof(Pair) + marks.capacity() + tags_.capacity() * sizeof(Tags)
    + contacts.capacity() * sizeof(Contact) + rows.capacity() * sizeof(double) + grid_.bytes();
}
