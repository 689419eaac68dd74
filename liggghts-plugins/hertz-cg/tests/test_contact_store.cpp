/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Contacts on their way between lists of pairs, ranks and files */

#include "hertz-cg/cell_grid.cpp"
#include "hertz-cg/contact_pairs.cpp"
#include "hertz-cg/contact_store.cpp"

#include <gtest/gtest.h>

using namespace grainjet;

namespace {

Contact contact_of(double k)
{
  return {{k, 2 * k, 3 * k}, {4 * k, 5 * k, 6 * k}, {7 * k, 8 * k, 9 * k}, {10 * k, 11 * k, 12 * k},
    {13 * k, 14 * k, 15 * k}};
}

void expect_equal(const Contact &a, const Contact &b)
{
  const contact::Vector3 va[] = {a.spring, a.force, a.twist, a.rolling, a.rollingSpring},
    vb[] = {b.spring, b.force, b.twist, b.rolling, b.rollingSpring};
  for (int n = 0; n < 5; ++n) {
    EXPECT_EQ(va[n].x, vb[n].x);
    EXPECT_EQ(va[n].y, vb[n].y);
    EXPECT_EQ(va[n].z, vb[n].z);
  }
}

// Three touching grains in a row and a ghost that touches the third
struct Row {
  double x[12] = {0, 0, 0, 0.9, 0, 0, 1.8, 0, 0, 2.7, 0, 0};
  double radius[4] = {0.5, 0.5, 0.5, 0.5};
  int tag[4] = {11, 7, 5, 20};
  int mask[4] = {1, 1, 1, 1};
  ContactPairs::Grains grains() { return {3, 4, x, radius, tag, mask, 1, 0}; }
};

int partner(const ContactStore &store, int grain, int tag)
{
  for (int n = 0; n < store.count(grain); ++n)
    if (store.entries(grain)[n].partner == tag) return n;
  return -1;
}

}

TEST(ContactStore, survivesExchangeWithAnotherRank)
{
  ContactStore here, there;
  here.keepRollingSpring(true);
  there.keepRollingSpring(true);
  here.resize(5);
  there.resize(3);
  here.add(4, {123456789, 1, contact_of(0.1)});
  here.add(1, {7, 3, contact_of(-1e-300)});
  here.add(4, {2, 1, contact_of(1.0 / 3.0)});
  here.finish();
  EXPECT_EQ(here.count(0), 0);
  EXPECT_EQ(here.largest(), 2);

  double buffer[100];
  const int written = here.pack(4, buffer);
  EXPECT_EQ(written, here.packed_size(4));
  EXPECT_EQ(there.unpack(2, buffer), written);
  ASSERT_EQ(there.count(2), 2);
  EXPECT_EQ(there.entries(2)[0].partner, 123456789);
  expect_equal(there.entries(2)[0].contact, contact_of(0.1));
  expect_equal(there.entries(2)[1].contact, contact_of(1.0 / 3.0));
  EXPECT_EQ(there.unpack(0, buffer), written);
  expect_equal(there.entries(2)[0].contact, contact_of(0.1));

  // without such a spring it is not sent
  here.keepRollingSpring(false);
  there.keepRollingSpring(false);
  EXPECT_EQ(here.pack(4, buffer), written - 2 * 3);
  there.unpack(1, buffer);
  Contact without = contact_of(0.1);
  without.rollingSpring = {0, 0, 0};
  expect_equal(there.entries(1)[0].contact, without);

  here.copy(4, 0);
  here.forget(4);
  EXPECT_EQ(here.count(4), 0);
  ASSERT_EQ(here.count(0), 2);
  EXPECT_EQ(here.entries(0)[1].partner, 2);
}

TEST(ContactPairs, contactsComeBackAfterASearchFromEitherSide)
{
  Row row;
  ContactPairs pairs;
  ContactStore store;
  store.keepRollingSpring(true);
  store.resize(4);
  ASSERT_TRUE(pairs.build(row.grains(), 0.2, store));
  ASSERT_EQ(pairs.size(), 3u);
  for (std::size_t p = 0; p < 3; ++p) {
    pairs.marks[p] = ContactPairs::TOUCHING | (p == 1 ? ContactPairs::DEEP : 0);
    pairs.contacts[p] = contact_of(1.0 + pairs.pairs[p].i);
  }
  pairs.save(store);
  EXPECT_EQ(store.count(0), 1);
  EXPECT_EQ(store.count(1), 2);
  EXPECT_EQ(store.count(2), 2) << "also the ghost";
  expect_equal(store.entries(0)[partner(store, 0, 7)].contact, contact_of(1.0));
  expect_equal(store.entries(1)[partner(store, 1, 11)].contact, contact_of(1.0).mirrored());

  // the host has sorted its grains the other way round
  Row turned;
  ContactStore sorted;
  sorted.keepRollingSpring(true);
  sorted.resize(4);
  for (int i = 0; i < 3; ++i) {
    double buffer[100];
    for (int d = 0; d < 3; ++d) turned.x[3 * i + d] = row.x[3 * (2 - i) + d];
    turned.tag[i] = row.tag[2 - i];
    store.pack(2 - i, buffer);
    sorted.unpack(i, buffer);
  }
  ASSERT_TRUE(pairs.build(turned.grains(), 0.2, sorted));
  ASSERT_EQ(pairs.size(), 3u);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_TRUE(pairs.marks[p] & ContactPairs::TOUCHING);
    const int i = pairs.pairs[p].i, j = pairs.pairs[p].j;
    if (j == 3) expect_equal(pairs.contacts[p], contact_of(3.0));
    else expect_equal(pairs.contacts[p], contact_of(1.0 + 2 - j).mirrored());
    EXPECT_LT(i, j);
  }
}

TEST(ContactPairs, listsOnlyTheGroupAndNoFrozenPairs)
{
  Row row;
  ContactPairs pairs;
  ContactStore store;
  store.resize(4);
  row.mask[0] = 2;
  ASSERT_TRUE(pairs.build(row.grains(), 0.2, store));
  EXPECT_EQ(pairs.size(), 2u);
  for (int &m : row.mask) m = 1;
  row.mask[1] = row.mask[2] = 1 | 4;
  ContactPairs::Grains g = row.grains();
  g.frozen = 4;
  ASSERT_TRUE(pairs.build(g, 0.2, store));
  EXPECT_EQ(pairs.size(), 2u) << "1-2 are both frozen";
}

// a partner that has gone far, or another image of it, is no contact
TEST(ContactPairs, doesNotTakeAFarImageForTheContact)
{
  Row row;
  ContactPairs pairs;
  ContactStore store;
  store.resize(4);
  store.add(0, {7, 1, contact_of(1.0)});
  store.finish();
  row.x[3] = 1.3;
  ASSERT_TRUE(pairs.build(row.grains(), 0.5, store));
  for (std::size_t p = 0; p < pairs.size(); ++p) EXPECT_EQ(pairs.marks[p], 0);
}
