/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/cell_grid.cpp"
#include "hertz-cg/contact_observers.cpp"
#include "hertz-cg/contact_pairs.cpp"
#include "hertz-cg/contact_store.cpp"

#include <gtest/gtest.h>

#include <vector>

using namespace LAMMPS_NS;

namespace {

struct Watcher : ContactObserver {
  int touched = 0, ended = 0;
  double last = 0.0;
  void touches(const ContactStep &, double *state) override { ++touched; state[0] += 1.0; }
  void parted(const ContactStep &, const double *state) override { ++ended; last = state[0]; }
};

Contact contact_of(double x)
{
  return {{x, 0, 0}, {0, x, 0}, {0, 0, x}, {x, x, 0}, {0, x, x}};
}

// Three grains in a row, the second touches both others; listed and put by
struct Row {
  std::vector<double> x = {0, 0, 0, 0.9, 0, 0, 1.8, 0, 0}, radius = {0.5, 0.5, 0.5};
  std::vector<int> tag = {30, 10, 20}, mask = {1, 1, 1};
  ContactStore store;
  ContactPairs pairs;
  ContactObservers observers;

  Row() { store.resize(3); build(); }
  void build() { ASSERT_TRUE(pairs.build({3, 3, x.data(), radius.data(), tag.data(), mask.data(), 1, 0}, 0.05, store)); }
  int pair(int i, int j) const
  {
    for (std::size_t p = 0; p < pairs.size(); ++p)
      if (pairs.pairs[p].i == i && pairs.pairs[p].j == j) return static_cast<int>(p);
    return -1;
  }
  void touch(int p)
  {
    if (!pairs.marks[p]) {
      pairs.marks[p] = ContactPairs::TOUCHING;
      pairs.contacts[p] = contact_of(p);
      pairs.clearRow(p);
    }
    observers.touches(ContactStep(), pairs.row(p));
  }
};

}

TEST(ContactObservers, StateGoesThroughASearch)
{
  Row row;
  Watcher watcher;
  EXPECT_FALSE(row.observers.any());
  row.observers.add(&watcher, "k", 3, row.store, row.pairs);
  EXPECT_TRUE(row.observers.has("k"));
  EXPECT_TRUE(row.observers.has(&watcher));
  const int p = row.pair(0, 1), q = row.pair(1, 2);
  ASSERT_GE(p, 0);
  ASSERT_GE(q, 0);
  for (int n = 0; n < 5; ++n) row.touch(p);
  row.touch(q);
  row.pairs.save(row.store);
  // both grains of a contact have its state
  EXPECT_EQ(row.store.count(1), 2);
  EXPECT_EQ(row.store.row(0, 0)[0], 5.0);
  EXPECT_EQ(row.store.row(2, 0)[0], 1.0);
  row.build();
  EXPECT_EQ(row.observers.state(&watcher, row.pairs.row(row.pair(0, 1)))[0], 5.0);
  EXPECT_EQ(row.observers.state(&watcher, row.pairs.row(row.pair(1, 2)))[0], 1.0);
  row.touch(row.pair(1, 2));
  row.observers.parted(ContactStep(), row.pairs.row(row.pair(1, 2)));
  EXPECT_EQ(watcher.last, 2.0);
  EXPECT_EQ(watcher.touched, 7);
}

TEST(ContactObservers, PackedLikeTheContact)
{
  for (bool rolling : {false, true}) {
    ContactStore here, there;
    for (ContactStore *store : {&here, &there}) {
      store->keepRollingSpring(rolling);
      store->resize(4);
      store->layOut({-1, -1});
    }
    EXPECT_EQ(here.values(), rolling ? 19 : 16);
    const double first[2] = {1.5, -2.5}, second[2] = {1e300, 1.0 / 3};
    here.clear();
    here.add(2, {7, 1, contact_of(1.0)}, first);
    here.add(0, {9, 1, contact_of(2.0)}, second);
    here.add(2, {8, 1, contact_of(3.0)}, second);
    here.finish();
    std::vector<double> buffer(here.packed_size(2) + 1, -77.0);
    EXPECT_EQ(here.pack(2, buffer.data()), here.packed_size(2));
    EXPECT_EQ(buffer.back(), -77.0);
    EXPECT_EQ(there.unpack(1, buffer.data()), here.packed_size(2));
    ASSERT_EQ(there.count(1), 2);
    EXPECT_EQ(there.row(1, 0)[0], 1.5);
    EXPECT_EQ(there.row(1, 1)[1], 1.0 / 3);
    EXPECT_EQ(there.entries(1)[1].contact.force.y, 3.0);
    there.copy(1, 3);
    EXPECT_EQ(there.row(3, 1)[0], 1e300);
  }
}

TEST(ContactObservers, WithoutObserversThereAreNoRows)
{
  ContactStore store;
  store.resize(1);
  EXPECT_EQ(store.row(), 0);
  EXPECT_EQ(store.values(), 14);
  Row row;
  row.touch(row.pair(0, 1));
  row.pairs.save(row.store);
  EXPECT_TRUE(row.pairs.rows.empty());
  EXPECT_EQ(row.store.packed_size(0), 15);
}

TEST(ContactObservers, OneComesAndGoesBesideAnother)
{
  Row row;
  Watcher a, b;
  row.observers.add(&a, "a", 2, row.store, row.pairs);
  const int p = row.pair(0, 1);
  for (int n = 0; n < 3; ++n) row.touch(p);
  row.observers.add(&b, "b", 1, row.store, row.pairs);
  EXPECT_EQ(row.observers.size(), 3);
  row.touch(p);
  EXPECT_EQ(row.observers.state(&a, row.pairs.row(p))[0], 4.0);
  EXPECT_EQ(row.observers.state(&b, row.pairs.row(p))[0], 1.0) << "what was there before begins with zeros";
  row.observers.remove(&a, row.store, row.pairs);
  EXPECT_EQ(row.observers.state(&a, row.pairs.row(p)), nullptr);
  row.touch(p);
  EXPECT_EQ(row.observers.state(&b, row.pairs.row(p))[0], 2.0);
  row.observers.remove(&b, row.store, row.pairs);
  EXPECT_FALSE(row.observers.any());
  EXPECT_TRUE(row.pairs.rows.empty());
}

// A restart file brings places; who has the name and the size takes his state up, others begin anew
TEST(ContactObservers, PlacesOfARestartFile)
{
  Row before;
  Watcher a, b;
  before.observers.add(&a, "a", 2, before.store, before.pairs);
  before.observers.add(&b, "the other", 1, before.store, before.pairs);
  for (int n = 0; n < 6; ++n) before.touch(before.pair(0, 1));
  before.pairs.save(before.store);
  const std::vector<double> places = before.observers.pack();
  std::vector<double> buffer(before.store.packed_size(0));
  before.store.pack(0, buffer.data());

  for (int size : {1, 4}) {
    Row after;
    after.observers.unpack(places.data(), after.store, after.pairs);
    after.store.unpack(0, buffer.data());
    EXPECT_TRUE(after.observers.any());
    EXPECT_FALSE(after.observers.has("a")) << "a place, but nobody there yet";
    Watcher c;
    after.observers.add(&c, "the other", size, after.store, after.pairs);
    after.observers.removeAbsent(after.store, after.pairs);
    EXPECT_EQ(after.observers.size(), size);
    after.build();
    EXPECT_EQ(after.observers.state(&c, after.pairs.row(after.pair(0, 1)))[0], size == 1 ? 6.0 : 0.0);
  }
}
