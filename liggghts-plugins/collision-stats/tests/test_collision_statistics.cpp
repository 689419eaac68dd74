/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision-stats/collision_statistics.cpp"
#include "collision-stats/collision_tables.cpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace {

const SpectrumBins SPECTRA[CollisionStatistics::KINDS] = {{1e-9, 1e-3, 6}, {1e-3, 10.0, 4}, {1e-6, 1.0, 3}, {1e-6, 1e-2, 2}};

CollisionStatistics statistics(int bins, int types)
{
  AxisBins axis;
  if (bins) axis = {1, -1.0, 3.0, bins};
  return CollisionStatistics(axis, types, SPECTRA);
}

GrainCollision collision(int cell, double size)
{
  return {cell + 1.0, 0.0, 0.5 * size, 1e-6 * size, 2e-7 * size, 5e-7 * size, 1e-3 * size, 1e-4 * size, 1e-4 * size};
}

}

TEST(CollisionStatistics, EveryPairOfTypesHasANumber)
{
  const CollisionStatistics s = statistics(0, 5);
  std::set<int> found;
  for (int a = 1; a <= 5; ++a)
    for (int b = a; b <= 5; ++b) {
      found.insert(s.pair(a, b));
      EXPECT_EQ(s.pair(a, b), s.pair(b, a));
    }
  EXPECT_EQ(s.pairs(), 15);
  EXPECT_EQ(found.size(), 15u);
  EXPECT_EQ(*found.begin(), 0);
  EXPECT_EQ(*found.rbegin(), 14);
}

TEST(CollisionStatistics, Slabs)
{
  const AxisBins bins = {1, -1.0, 3.0, 3};
  const auto at = [&bins](double y) { const double x[3] = {0.0, y, 100.0}; return bins.find(x); };
  EXPECT_EQ(at(-1.0), 0);
  EXPECT_EQ(at(std::nextafter(-1.0, -2.0)), 3);
  EXPECT_EQ(at(std::nextafter(3.0, 0.0)), 2);
  EXPECT_EQ(at(3.0), 3);
  EXPECT_EQ(at(NAN), 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(at(bins.edge(i) + 1e-12), i);
  EXPECT_EQ(bins.edge(3), 3.0);
  const double x[3] = {0.0, 0.0, 0.0};
  EXPECT_EQ(AxisBins().find(x), 0);
}

TEST(CollisionStatistics, SumsOfRegionsAndPairs)
{
  CollisionStatistics s = statistics(2, 2);
  const double low[3] = {0, 0, 0}, high[3] = {0, 2, 0}, none[3] = {0, 9, 0};
  int n = 0;
  for (const double *x : {low, high, none})
    for (int k = 0; k <= n; ++k) {
      s.begin(s.cell(x, 1, 2));
      s.add(collision(s.cell(x, 2, 1), 1.0 + n++ * 0.1));
      s.addGrain(x, 2);
      if (n > 6) break;
    }
  EXPECT_EQ(s.regions(), 3);
  double slabs = s.collisions(1, 0) + s.collisions(2, 0);
  EXPECT_EQ(s.collisions(0, 0), n);
  EXPECT_LT(slabs, n);
  EXPECT_EQ(s.collisions(0, s.pair(1, 2) + 1), n);
  EXPECT_EQ(s.collisions(0, s.pair(2, 2) + 1), 0);
  EXPECT_EQ(s.grains(0, 2), n);
  EXPECT_EQ(s.grains(0, 1), 0);
  EXPECT_EQ(s.sum(0, 0).moments[0].count(), n);
  EXPECT_EQ(s.sum(0, 0).begun, n);
  EXPECT_EQ(s.sum(2, 0).spectra[6].total(), s.collisions(2, 0));
}

TEST(CollisionStatistics, MergedIsTheSameAsOne)
{
  CollisionStatistics whole = statistics(3, 2), a = statistics(3, 2), b = statistics(3, 2);
  for (int n = 0; n < 500; ++n) {
    const GrainCollision c = collision(n * 7 % whole.cells(), 1.0 + 0.01 * (n * 37 % 500));
    whole.add(c);
    (n % 3 ? a : b).add(c);
  }
  a.merge(b);
  for (int region = 0; region < whole.regions(); ++region)
    for (int pair = 0; pair <= whole.pairs(); ++pair) {
      const auto p = whole.sum(region, pair), q = a.sum(region, pair);
      ASSERT_EQ(p.collisions(), q.collisions());
      for (int m = 0; m < 7; ++m) {
        // rounding of some hundred additions
        EXPECT_NEAR(q.moments[m].mean() / p.moments[m].mean(), 1.0, 1e-14);
        EXPECT_NEAR(q.moments[m].variance() / p.moments[m].variance(), 1.0, 1e-12);
        for (int i = 0; i < p.spectra[m].bins(); ++i) EXPECT_EQ(p.spectra[m].weight(i), q.spectra[m].weight(i));
      }
    }
}

TEST(CollisionStatistics, PackedAndUnpackedIsBitwiseTheSame)
{
  CollisionStatistics s = statistics(2, 3);
  for (int n = 0; n < 100; ++n) s.add(collision(n % s.cells(), 1.0 + 0.1 * n));
  CollisionStatistics t = statistics(2, 3);
  const std::vector<double> list = s.pack();
  EXPECT_LT(list.size(), CollisionStatistics::numbers(s.cells(), SPECTRA));
  EXPECT_GT(2 * list.size(), CollisionStatistics::numbers(s.cells(), SPECTRA));
  ASSERT_TRUE(t.unpack(list));
  EXPECT_EQ(t.pack(), list);
  CollisionStatistics other = statistics(3, 3);
  EXPECT_FALSE(other.unpack(list));
  t.clear();
  EXPECT_EQ(t.pack(), statistics(2, 3).pack());
}

// f = 2 for the first type: f^4 collisions of particles for one of grains, among f^3 times as many
TEST(CollisionTables, Particles)
{
  CollisionStatistics s = statistics(0, 2);
  const double x[3] = {0, 0, 0};
  for (int n = 0; n < 3; ++n) s.add(collision(s.cell(x, 1, 1), 1.0));
  s.add(collision(s.cell(x, 2, 2), 1.0));
  for (int n = 0; n < 10; ++n) s.addGrain(x, 1);
  for (int n = 0; n < 30; ++n) s.addGrain(x, 2);
  CollisionSurroundings around;
  around.time = 2.0;
  around.samples = 5.0;
  around.volumes = {4.0};
  around.touching.assign(s.cells(), 0.0);
  around.factor = {2.0, 1.0};
  const std::string text = CollisionTables::totals(s, around);
  std::vector<std::vector<std::string>> table(1);
  for (char c : text)
    if (c == ',') table.back().emplace_back();
    else if (c == '\n') table.emplace_back();
    else {
      if (table.back().empty()) table.back().emplace_back();
      table.back().back() += c;
    }
  const auto value = [&table](const std::string &column, int row) {
    for (std::size_t k = 0; k < table[0].size(); ++k)
      if (table[0][k] == column) return std::stod(table[row][k]);
    return -1.0;
  };
  EXPECT_EQ(value("collisions", 1), 4);
  EXPECT_EQ(value("grains_1", 1), 8);
  EXPECT_DOUBLE_EQ(value("frequency_per_volume", 1), 0.5);
  EXPECT_DOUBLE_EQ(value("frequency_per_grain_1", 1), 2 * 4 / (2.0 * 8));
  EXPECT_DOUBLE_EQ(value("particle_frequency_per_volume", 1), (3 * 16 + 1) / 8.0);
  // written with ten digits
  EXPECT_NEAR(value("frequency_per_particle_1", 1) / (2 * (3 * 16 + 1) / (2.0 * (2 * 8 + 6))), 1.0, 1e-9);
  EXPECT_EQ(table[2][3], "1-1");
  EXPECT_DOUBLE_EQ(value("frequency_per_particle_1", 2) / value("frequency_per_grain_1", 2), 2.0);
}

// before the first count of grains: a program that traps invalid operations, as OpenFOAM does, goes on
TEST(CollisionTables, NothingCountedYetIsNoInvalidOperation)
{
  CollisionStatistics s = statistics(2, 2);
  CollisionSurroundings around;
  around.volumes.assign(3, 0.0);
  around.touching.assign(s.cells(), 0.0);
  around.factor = {2.0, 1.0};
  std::feclearexcept(FE_ALL_EXCEPT);
  const std::string text = CollisionTables::totals(s, around) + CollisionTables::spectra(s);
  EXPECT_EQ(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), 0);
  EXPECT_NE(text.find("nan"), std::string::npos);
}
