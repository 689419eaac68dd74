/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/statistics/log_histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

using grainjet::LogHistogram;

namespace {

const double INF = std::numeric_limits<double>::infinity();
const double UNDEFINED = std::numeric_limits<double>::quiet_NaN();

std::vector<double> exponential(int n, double mean, unsigned seed)
{
  std::mt19937_64 random(seed);
  std::exponential_distribution<double> law(1.0 / mean);
  std::vector<double> samples(n);
  for (double &x : samples) x = law(random);
  return samples;
}

void expectEqual(const LogHistogram &a, const LogHistogram &b)
{
  ASSERT_TRUE(a.sameEdges(b));
  EXPECT_EQ(a.below(), b.below());
  EXPECT_EQ(a.above(), b.above());
  for (int i = 0; i < a.bins(); ++i) EXPECT_EQ(a.weight(i), b.weight(i)) << i;
}

}

TEST(LogHistogram, EdgesAreAGeometricSeries)
{
  const LogHistogram h(1e-9, 1e-3, 12);
  ASSERT_EQ(h.bins(), 12);
  EXPECT_EQ(h.edge(0), 1e-9);
  EXPECT_EQ(h.edge(12), 1e-3);
  // two bins a decade; exp() is good to one digit of its argument, which is up to 14
  for (int i = 0; i <= 12; ++i) EXPECT_NEAR(h.edge(i) / std::pow(10.0, -9.0 + 0.5 * i), 1.0, 1e-14) << i;
  for (int i = 0; i < 12; ++i) EXPECT_NEAR(h.middle(i) / std::pow(10.0, -8.75 + 0.5 * i), 1.0, 1e-14) << i;
}

// Whatever the rounding of the edges: a sample on one belongs to the bin above, the number before it to the one below
TEST(LogHistogram, SamplesOnEdges)
{
  LogHistogram h(0.003, 7e5, 23);
  for (int i = 0; i < h.bins(); ++i) {
    LogHistogram on(h), before(h);
    on.add(h.edge(i));
    before.add(std::nextafter(h.edge(i), 0.0));
    EXPECT_EQ(on.weight(i), 1.0) << i;
    EXPECT_EQ(i == 0 ? before.below() : before.weight(i - 1), 1.0) << i;
  }
  h.add(7e5);
  EXPECT_EQ(h.above(), 1.0);
  h.add(std::nextafter(7e5, 0.0));
  EXPECT_EQ(h.weight(22), 1.0);
}

TEST(LogHistogram, NothingIsLostBeyondTheEdges)
{
  LogHistogram h(1.0, 10.0, 3);
  for (double x : {0.0, -0.0, -5.0, 0.999, -INF, UNDEFINED, std::numeric_limits<double>::denorm_min()}) h.add(x);
  for (double x : {10.0, 1e300, INF}) h.add(x);
  h.add(2.0);
  EXPECT_EQ(h.below(), 7.0);
  EXPECT_EQ(h.above(), 3.0);
  EXPECT_EQ(h.weight(0), 1.0);
  EXPECT_EQ(h.total(), 11.0);
}

TEST(LogHistogram, Weights)
{
  LogHistogram h(1.0, 100.0, 2);
  h.add(5.0, 8.0);
  h.add(20.0, 27.0);
  h.add(30.0);
  h.add(1e3, 64.0);
  EXPECT_EQ(h.weight(0), 8.0);
  EXPECT_EQ(h.weight(1), 28.0);
  EXPECT_EQ(h.above(), 64.0);
  EXPECT_EQ(h.total(), 100.0);
  EXPECT_DOUBLE_EQ(h.density(0), 0.08 / (h.edge(1) - h.edge(0)));
}

TEST(LogHistogram, DensityIsUndefinedWithoutSamples)
{
  const LogHistogram h(1.0, 2.0, 1);
  EXPECT_TRUE(std::isnan(h.density(0)));
  EXPECT_EQ(h.total(), 0.0);
}

// The share of each bin against the integral of the law over it: chi square of 30 bins and 29 to 31 degrees
// of freedom lies below 60 with a probability of 0.999
TEST(LogHistogram, SpectrumOfAnExponentialLaw)
{
  const int n = 200000;
  const double mean = 3e-7;
  LogHistogram h(1e-9, 3e-6, 30);
  for (double x : exponential(n, mean, 5)) h.add(x);
  const auto below = [mean](double x) { return -std::expm1(-x / mean); };
  double chi2 = 0.0, integral = 0.0;
  const auto term = [&chi2](double weight, double probability) {
    chi2 += (weight - n * probability) * (weight - n * probability) / (n * probability);
  };
  term(h.below(), below(h.edge(0)));
  term(h.above(), 1.0 - below(h.edge(30)));
  for (int i = 0; i < 30; ++i) {
    term(h.weight(i), below(h.edge(i + 1)) - below(h.edge(i)));
    integral += h.density(i) * (h.edge(i + 1) - h.edge(i));
  }
  EXPECT_LT(chi2, 60.0);
  EXPECT_EQ(h.total(), n);
  EXPECT_NEAR(integral, 1.0 - (h.below() + h.above()) / n, 1e-13);
}

// to the last bit, in any order and any share: weights are whole numbers
TEST(LogHistogram, MergeEqualsOneStream)
{
  const auto samples = exponential(10007, 1.0, 6);
  LogHistogram whole(1e-3, 5.0, 40);
  for (double x : samples) whole.add(x, 8.0);
  for (int parts : {2, 3, 64}) {
    std::vector<LogHistogram> share(parts, LogHistogram(1e-3, 5.0, 40));
    for (std::size_t i = 0; i < samples.size(); ++i)
      share[std::size_t(parts * std::pow(double(i) / samples.size(), 3.0))].add(samples[i], 8.0);
    LogHistogram merged(1e-3, 5.0, 40);
    for (int p = parts - 1; p >= 0; --p) EXPECT_TRUE(merged.merge(share[p]));
    expectEqual(merged, whole);
  }
}

TEST(LogHistogram, OtherEdgesDoNotMerge)
{
  LogHistogram h(1.0, 10.0, 4);
  h.add(2.0);
  for (const LogHistogram &other : {LogHistogram(1.0, 10.0, 5), LogHistogram(1.0, 11.0, 4), LogHistogram(0.9, 10.0, 4)}) {
    LogHistogram filled(other);
    filled.add(3.0);
    EXPECT_FALSE(h.sameEdges(filled));
    EXPECT_FALSE(h.merge(filled));
  }
  EXPECT_EQ(h.total(), 1.0);
}

TEST(LogHistogram, PackedAndUnpackedIsBitwiseTheSame)
{
  const auto samples = exponential(1000, 2.0, 7);
  LogHistogram whole(0.013, 5.7, 17), first(whole);
  for (double x : samples) whole.add(x, 0.1);
  for (int i = 0; i < 500; ++i) first.add(samples[i], 0.1);
  std::vector<double> buffer(first.packed());
  EXPECT_EQ(first.packed(), LogHistogram::packed(17));
  first.pack(buffer.data());
  LogHistogram second = LogHistogram::unpack(buffer.data());
  for (int i = 500; i < 1000; ++i) second.add(samples[i], 0.1);
  expectEqual(second, whole);
}

TEST(LogHistogram, BadEdgesAreRefused)
{
  struct Edges { double least, most; int bins; };
  for (const Edges &e : {Edges{0.0, 1.0, 4}, Edges{-1.0, 1.0, 4}, Edges{1.0, 1.0, 4}, Edges{2.0, 1.0, 4}, Edges{1.0, 2.0, 0},
                         Edges{1.0, INF, 4}, Edges{UNDEFINED, 1.0, 4}, Edges{1.0, UNDEFINED, 4}, Edges{1.0, 1.0 + 1e-14, 100}}) {
    EXPECT_FALSE(LogHistogram::valid(e.least, e.most, e.bins)) << e.least << " " << e.most << " " << e.bins;
    EXPECT_THROW(LogHistogram(e.least, e.most, e.bins), std::invalid_argument);
  }
  EXPECT_TRUE(LogHistogram::valid(1e-300, 1e300, 1));
  EXPECT_TRUE(LogHistogram::valid(5.0, 6.0, 1000));
}
