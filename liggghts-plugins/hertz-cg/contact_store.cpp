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
  rows_.clear();
  addedRows_.clear();
  largest_ = 0;
}

/* ---------------------------------------------------------------------- */

void grainjet::layOutRows(std::vector<double> &rows, std::size_t row, std::size_t count, const std::vector<int> &from)
{
  std::vector<double> fresh(from.size() * count, 0.0);
  for (std::size_t r = 0; r < count; ++r)
    for (std::size_t n = 0; n < from.size(); ++n)
      if (from[n] >= 0) fresh[r * from.size() + n] = rows[r * row + from[n]];
  rows.swap(fresh);
}

void ContactStore::layOut(const std::vector<int> &from)
{
  layOutRows(rows_, row_, entries_.size(), from);
  row_ = static_cast<int>(from.size());
}

/* ---------------------------------------------------------------------- */

void ContactStore::add(int grain, const Entry &entry, const double *row)
{
  ++count_[grain];
  added_.push_back({grain, entry});
  addedRows_.insert(addedRows_.end(), row, row + row_);
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
  rows_.resize(static_cast<std::size_t>(sum) * row_);
  const double *row = addedRows_.data();
  for (const Added &a : added_) {
    const int at = first_[a.grain] + count_[a.grain]++;
    entries_[at] = a.entry;
    std::copy(row, row + row_, rows_.begin() + static_cast<std::size_t>(at) * row_);
    row += row_;
  }
  added_.clear();
  addedRows_.clear();
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
    m = static_cast<int>(std::copy_n(row(grain, n), row_, buffer + m) - buffer);
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
    rows_.insert(rows_.end(), buffer + m, buffer + m + row_);
    m += row_;
  }
  return m;
}

/* ---------------------------------------------------------------------- */

std::size_t ContactStore::bytes() const
{
  return (count_.capacity() + first_.capacity()) * sizeof(int)
    + entries_.capacity() * sizeof(Entry) + added_.capacity() * sizeof(Added)
    + (rows_.capacity() + addedRows_.capacity()) * sizeof(double);
}
