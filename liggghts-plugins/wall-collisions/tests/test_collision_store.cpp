/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "wall-collisions/collision_store.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>
#include <vector>

using grainjet::Collision;
using grainjet::CollisionStore;

namespace {

// Grains with names, each with or without a collision that bears its name, kept the plain
// way beside the store
struct Grains {
  CollisionStore store;
  std::vector<int> names;            // by local index
  std::map<int, double> colliding;   // name -> steps

  Grains() : store(Collision::OF_SURFACE, true) { store.grow(1000); }

  void create(int name)
  {
    store.reset(static_cast<int>(names.size()));
    names.push_back(name);
  }

  // as LIGGGHTS takes a grain away: the last one comes to lie in its place
  void remove(int i)
  {
    colliding.erase(names[i]);
    const int last = static_cast<int>(names.size()) - 1;
    store.move(last, i, true);
    names[i] = names[last];
    names.pop_back();
  }

  void swapBySorting(int i, int j)
  {
    const int spare = static_cast<int>(names.size());
    store.move(i, spare, false);
    store.move(j, i, false);
    store.move(spare, j, false);
    std::swap(names[i], names[j]);
  }

  void check() const
  {
    for (int i = 0; i < static_cast<int>(names.size()); i++) {
      const auto known = colliding.find(names[i]);
      const Collision *found = store.find(i);
      ASSERT_EQ(found != nullptr, known != colliding.end()) << "grain " << names[i];
      if (!found) continue;
      ASSERT_EQ(found->time, names[i]);
      ASSERT_EQ(found->steps, known->second);
    }
  }
};

}

// Two ranks, ten thousand random events: contacts begin, go on and end, grains are made,
// deleted, sorted and sent over
TEST(CollisionStore, RandomLife)
{
  std::mt19937 random(1);
  const auto below = [&](std::size_t n) { return static_cast<int>(random() % n); };
  Grains ranks[2];
  int name = 0;
  for (int step = 0; step < 10000; step++) {
    const int r = below(2);
    Grains &here = ranks[r], &there = ranks[1 - r];
    const int n = static_cast<int>(here.names.size());
    const int event = below(6);
    if (n < 2 || (event == 0 && n < 400)) {
      here.create(++name);
    } else if (event == 1) {
      const int i = below(n);
      if (here.store.find(i)) {
        here.store.end(i);
        here.colliding.erase(here.names[i]);
      } else {
        here.store.begin(i).time = here.names[i];
        here.colliding[here.names[i]] = 0;
      }
    } else if (event == 2) {
      for (int i = 0; i < n; i++)
        if (Collision *c = here.store.find(i)) {
          c->steps += 1;
          here.colliding[here.names[i]] += 1;
        }
    } else if (event == 3 && below(4) == 0) {
      here.remove(below(n));
    } else if (event == 4) {
      here.swapBySorting(below(n), below(n));
    } else if (event == 5) {
      const int i = below(n), moved = here.names[i];
      double buffer[CollisionStore::PACKED];
      const int sent = here.store.pack(i, buffer);
      const bool colliding = here.colliding.count(moved);
      if (colliding) there.colliding[moved] = here.colliding[moved];
      here.remove(i);
      there.names.push_back(moved);
      ASSERT_EQ(there.store.unpack(static_cast<int>(there.names.size()) - 1, buffer), sent);
      ASSERT_EQ(sent, colliding ? CollisionStore::PACKED : 1);
    }
    here.check();
    there.check();
  }
  EXPECT_GT(name, 500);
}

TEST(CollisionStore, RemovingTheLastGrainFreesItsPlace)
{
  Grains grains;
  grains.create(1);
  grains.store.begin(0).time = 1;
  grains.colliding[1] = 0;
  grains.remove(0);
  grains.create(2);
  EXPECT_EQ(grains.store.find(0), nullptr);
}

// A record that is used again starts from zero
TEST(CollisionStore, NothingIsLeftOfAnOldCollision)
{
  CollisionStore store;
  store.grow(2);
  store.begin(0).normalPeak = 5;
  store.end(0);
  EXPECT_EQ(store.begin(1).normalPeak, 0);
  EXPECT_EQ(store.find(0), nullptr);
}

// A plate keeps the first part of a record, which is what its restart files have always held
TEST(CollisionStore, APartIsKept)
{
  static_assert(Collision::OF_PLATE == 17, "restart files of plates hold 17 numbers to a collision");
  CollisionStore store(Collision::OF_PLATE), other(Collision::OF_PLATE);
  store.grow(1);
  other.grow(1);
  Collision &c = store.begin(0);
  for (int n = 0; n < Collision::SIZE; n++) c.data()[n] = n + 1;
  double buffer[CollisionStore::PACKED];
  ASSERT_EQ(store.pack(0, buffer), 1 + Collision::OF_PLATE);
  ASSERT_EQ(other.unpack(0, buffer), 1 + Collision::OF_PLATE);
  for (int n = 0; n < Collision::SIZE; n++)
    EXPECT_EQ(other.find(0)->data()[n], n < Collision::OF_PLATE ? n + 1 : 0);
  EXPECT_EQ(other.find(0)->surface[2], Collision::OF_PLATE);
}

// Grains with a temperature: that follows the part. A record of a restart file may have it or not, whatever the store
TEST(CollisionStore, TheTemperatureIsKept)
{
  CollisionStore with(Collision::OF_PLATE, true), without(Collision::OF_PLATE);
  with.grow(2);
  without.grow(1);
  Collision &c = with.begin(0);
  c.time = 3.0;
  c.x[0] = 5.0;
  c.temperature = 350.0;
  double buffer[CollisionStore::PACKED];
  ASSERT_EQ(with.pack(0, buffer), with.packed());
  ASSERT_EQ(with.packed(), without.packed() + 1);

  ASSERT_EQ(with.unpack(1, buffer), with.packed());
  EXPECT_EQ(with.find(1)->time, 3.0);
  EXPECT_EQ(with.find(1)->x[0], 0.0);
  EXPECT_EQ(with.find(1)->temperature, 350.0);

  ASSERT_EQ(without.unpack(0, buffer, true), with.packed());
  ASSERT_EQ(without.pack(0, buffer), without.packed());
  ASSERT_EQ(with.unpack(1, buffer, false), without.packed());
  EXPECT_EQ(with.find(1)->time, 3.0);
  EXPECT_EQ(with.find(1)->temperature, 0.0);
}
