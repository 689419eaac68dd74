/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* The search for pairs against trying all of them, and when a list of pairs is due again.
   Unit tests are built from one source each, so the parts under test are included.   */

#include "hertz-cg/cell_grid.cpp"
#include "hertz-cg/stream_motion.cpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>
#include <utility>

using namespace grainjet;

namespace {

struct Spheres { std::vector<double> x, radius; };

Spheres random(int n, const double (&box)[3], double smallest, double largest, unsigned seed)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Spheres s;
  for (int i = 0; i < n; ++i) {
    for (double length : box) s.x.push_back(length * (unit(engine) - 0.3));
    s.radius.push_back(smallest + (largest - smallest) * unit(engine));
  }
  return s;
}

typedef std::set<std::pair<int, int>> Pairs;

Pairs all_tried(const Spheres &s, int nowned, double margin)
{
  Pairs pairs;
  const int n = static_cast<int>(s.radius.size());
  for (int i = 0; i < nowned; ++i)
    for (int j = i + 1; j < n; ++j) {
      double square = 0.0;
      for (int d = 0; d < 3; ++d) square += std::pow(s.x[3 * i + d] - s.x[3 * j + d], 2);
      const double cut = s.radius[i] + s.radius[j] + margin;
      if (square < cut * cut) pairs.insert({i, j});
    }
  return pairs;
}

Pairs searched(CellGrid &grid, const Spheres &s, int nowned, double margin)
{
  Pairs pairs;
  EXPECT_TRUE(grid.sort(static_cast<int>(s.radius.size()), nowned, s.x.data(), s.radius.data(), margin));
  grid.pairs([&](int i, int j) {
    EXPECT_TRUE(pairs.insert({std::min(i, j), std::max(i, j)}).second) << "a pair found twice: " << i << " " << j;
  });
  return pairs;
}

}

TEST(CellGrid, findsEveryPairOnce)
{
  CellGrid grid;    // one for all: nothing may be left over from the case before
  const double boxes[][3] = {{1, 1, 1}, {20, 20, 20}, {100, 1, 1}, {1, 100, 1}, {1, 1, 100},
                             {0, 5, 5}, {5, 0, 0}, {1e6, 1e6, 1e6}};
  unsigned seed = 1;
  for (const auto &box : boxes)
    for (int n : {1, 2, 40, 700})
      for (double margin : {0.0, 0.05, 1.0})
        for (double largest : {0.05, 0.5}) {
          const Spheres s = random(n, box, 0.05, largest, ++seed);
          const int nowned = n - n / 3;
          EXPECT_EQ(searched(grid, s, nowned, margin), all_tried(s, nowned, margin))
            << "box " << box[0] << " " << box[1] << " " << box[2] << ", n " << n << ", margin " << margin;
        }
}

// Neighbours on a lattice sit exactly on the limits of cells and of the cut-off
TEST(CellGrid, findsPairsOnALattice)
{
  Spheres s;
  for (int i = 0; i < 1000; ++i) {
    for (int c : {i % 10, i / 10 % 10, i / 100}) s.x.push_back(0.1 * c);
    s.radius.push_back(0.05);
  }
  CellGrid grid;
  for (double margin : {1e-12, 0.1, 0.1 * std::sqrt(3.0)})
    EXPECT_EQ(searched(grid, s, 1000, margin), all_tried(s, 1000, margin));
}

TEST(CellGrid, memoryGoesWithSpheresNotWithVolume)
{
  const double small[3] = {1, 1, 1}, large[3] = {1e5, 1e5, 1e5};
  CellGrid dense, dilute;
  searched(dense, random(2000, small, 0.01, 0.01, 1), 2000, 0.01);
  searched(dilute, random(2000, large, 0.01, 0.01, 1), 2000, 0.01);
  EXPECT_EQ(dense.bytes(), dilute.bytes());
  EXPECT_LT(dilute.bytes(), 100u * 2000u);
}

TEST(CellGrid, refusesWhatIsNoPosition)
{
  Spheres s = random(10, {1, 1, 1}, 0.1, 0.1, 1);
  s.x[3 * 7 + 1] = std::numeric_limits<double>::quiet_NaN();
  CellGrid grid;
  EXPECT_FALSE(grid.sort(10, 10, s.x.data(), s.radius.data(), 0.1));
  EXPECT_EQ(CellGrid::firstInvalid(10, s.x.data()), 7);
}

namespace {

const double stream[3] = {0.0, 0.0, 6.0};
const double still[6] = {0, 0, 0, 1, 1, 1};

StreamMotion::Limits limits()
{
  return {0.1, 0.15, {true, true, false}, {10.0, 10.0, 10.0}};
}

}

TEST(StreamMotion, goesByMotionRelativeToTheStream)
{
  StreamMotion motion;
  motion.start(2, still, stream, limits());
  const double with[6] = {0, 0, 1.5, 1, 1, 2.5};
  EXPECT_FALSE(motion.expired(2, with, 0.25)) << "both have moved with the stream";
  EXPECT_TRUE(motion.expired(2, still, 0.25)) << "both stayed behind";
  const double apart[6] = {0, 0, 1.5, 1, 1, 2.65};
  EXPECT_TRUE(motion.expired(2, apart, 0.25));
  const double less[6] = {0, 0, 1.5, 1, 1, 2.59};
  EXPECT_FALSE(motion.expired(2, less, 0.25));
}

TEST(StreamMotion, goesByAbsoluteMotionTowardsWalls)
{
  const double across[3] = {1.0, 0.0, 0.0};
  StreamMotion motion;
  StreamMotion::Limits wall = limits();
  motion.start(2, still, across, wall);
  const double moved[6] = {0.14, 0, 0, 1.16, 1, 1};
  EXPECT_TRUE(motion.expired(2, moved, 0.14));
  wall.wallAxes[0] = false;
  motion.start(2, still, across, wall);
  EXPECT_FALSE(motion.expired(2, moved, 0.14)) << "the wall does not face that way";
  wall.wallAxes[0] = true;
  wall.wall = 0.0;
  motion.start(2, still, across, wall);
  EXPECT_FALSE(motion.expired(2, moved, 0.14)) << "no wall";
}

TEST(StreamMotion, boundsTheWayOfTheStreamAndNoticesOtherGrains)
{
  StreamMotion motion;
  motion.start(2, still, stream, limits());
  double x[6];
  const auto after = [&](double time) {
    for (int k = 0; k < 6; ++k) x[k] = still[k] + time * stream[k % 3];
    return motion.expired(2, x, time);
  };
  EXPECT_FALSE(after(9.8 / 6.0));
  EXPECT_TRUE(after(9.95 / 6.0)) << "0.1 of the 10 belongs to the single grain";
  EXPECT_TRUE(motion.expired(1, still, 0.0));
}

// The choice is the least cost, wide where few pairs are met, narrow where many are
TEST(MarginChoice, narrowInACrowdWideInADiluteStream)
{
  MarginChoice c = {1.0, 3.0, 0.0016 * 4.0, 0.0, 0.01};
  const double dilute = c.best();
  c.pairs = 3.0;
  const double crowded = c.best();
  c.displacement = 1e-6;
  const double bed = c.best();
  EXPECT_GT(dilute, 2.0);
  EXPECT_LT(crowded, 0.7);
  EXPECT_LT(bed, 0.1);
  EXPECT_LE(dilute, c.largest);
  EXPECT_GT(bed, 0.0);
  c.largest = 0.0;     // no grains yet
  c.diameter = 0.0;
  EXPECT_EQ(c.best(), 0.0);
}

TEST(MarginChoice, anEmptyBoxHasAnAnswer)
{
  MarginChoice c = {0.0, 0.001, 0.0, 0.0, 0.0};
  EXPECT_EQ(c.best(), 0.001);
  c.largest = 0.0;
  EXPECT_EQ(c.best(), 0.0);
}

TEST(MarginChoice, noMoreThanASearchThatComesAnywayNeeds)
{
  MarginChoice c = {1.0, 3.0, 4.0, 0.0, 0.001};
  const double alone = c.best();
  c.forced = 0.1;    // a search every ten steps, in which the fastest grain moves 0.01
  const double forced = c.best();
  EXPECT_LT(forced, 0.5 * alone);
  EXPECT_GE(forced, 2.0 * 0.01);
  c.forced = 0.0;
  c.search = 6000.0;
  EXPECT_GT(c.best(), alone) << "lists of triangles make searches dear";
}

TEST(StreamMotion, aGrainThatIsNowhereAsksForASearch)
{
  StreamMotion motion;
  const double start[] = {0, 0, 0, 5, 0, 0}, velocity[] = {0, 0, 0};
  StreamMotion::Limits limits = {0.1, 0.0, {false, false, false}, {10, 10, 10}};
  motion.start(2, start, velocity, limits);
  EXPECT_EQ(motion.expired(2, start, 1.0), StreamMotion::FRESH);
  double x[] = {0, 0, 0, 5, std::numeric_limits<double>::quiet_NaN(), 0};
  EXPECT_EQ(motion.expired(2, x, 1.0), StreamMotion::RELATIVE);
  const double endless[] = {std::numeric_limits<double>::infinity(), 0, 0};
  motion.start(2, start, endless, limits);
  EXPECT_EQ(motion.expired(2, start, 1.0), StreamMotion::STREAM);
}
