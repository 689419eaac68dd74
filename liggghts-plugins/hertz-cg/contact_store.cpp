/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/contact_store.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

using namespace grainjet;

/* whole numbers travel as the bit pattern of a double, as LIGGGHTS does it */

static double as_double(std::int64_t i)
{
  double d;
  std::memcpy(&d, &i, sizeof d);
  return d;
}

static int as_int(double d)
{
  std::int64_t i;
  std::memcpy(&i, &d, sizeof i);
  return static_cast<int>(i);
}

/* ---------------------------------------------------------------------- */

void ContactStore::resize(int ngrains)
{
  count_.resize(ngrains, 0);
  first_.resize(ngrains, 0);
}

/* ---------------------------------------------------------------------- */

void ContactStore::clear()
{
  std::fill(count_.begin(), count_.end(), 0);
  entries_.clear();
  added_.clear();
  largest_ = 0;
}

/* ---------------------------------------------------------------------- */

void ContactStore::add(int grain, const Entry &entry)
{
  ++count_[grain];
  added_.push_back({grain, entry});
}

/* ---------------------------------------------------------------------- */

void ContactStore::finish()
{
  int sum = 0;
  for (std::size_t i = 0; i < count_.size(); ++i) {
    first_[i] = sum;
    sum += count_[i];
    largest_ = std::max(largest_, count_[i]);
    count_[i] = 0;
  }
  entries_.resize(sum);
  for (const Added &a : added_) entries_[first_[a.grain] + count_[a.grain]++] = a.entry;
  added_.clear();
}

/* ---------------------------------------------------------------------- */

int ContactStore::pack(int grain, double *buffer) const
{
  int m = 0;
  buffer[m++] = as_double(count_[grain]);
  for (int n = 0; n < count_[grain]; ++n) {
    const Entry &e = entries(grain)[n];
    const Contact &c = e.contact;
    buffer[m++] = as_double(e.partner);
    buffer[m++] = as_double(e.marks);
    const contact::Vector3 *vectors[] = {&c.spring, &c.force, &c.twist, &c.rolling, &c.rollingSpring};
    for (int v = 0; v < (rollingSpring_ ? 5 : 4); ++v) {
      buffer[m++] = vectors[v]->x;
      buffer[m++] = vectors[v]->y;
      buffer[m++] = vectors[v]->z;
    }
  }
  return m;
}

/* ---------------------------------------------------------------------- */

int ContactStore::unpack(int grain, const double *buffer)
{
  int m = 0;
  const int n = as_int(buffer[m++]);
  count_[grain] = n;
  first_[grain] = static_cast<int>(entries_.size());
  largest_ = std::max(largest_, n);
  for (int k = 0; k < n; ++k) {
    Entry e;
    e.partner = as_int(buffer[m++]);
    e.marks = as_int(buffer[m++]);
    Contact &c = e.contact;
    c.rollingSpring = {0.0, 0.0, 0.0};
    contact::Vector3 *vectors[] = {&c.spring, &c.force, &c.twist, &c.rolling, &c.rollingSpring};
    for (int v = 0; v < (rollingSpring_ ? 5 : 4); ++v) {
      vectors[v]->x = buffer[m++];
      vectors[v]->y = buffer[m++];
      vectors[v]->z = buffer[m++];
    }
    entries_.push_back(e);
  }
  return m;
}

/* ---------------------------------------------------------------------- */

std::size_t ContactStore::bytes() const
{
  return (count_.capacity() + first_.capacity()) * sizeof(int)
    + entries_.capacity() * sizeof(Entry) + added_.capacity() * sizeof(Added);
}
