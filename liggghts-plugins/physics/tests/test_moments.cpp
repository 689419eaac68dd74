/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/statistics/moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using grainjet::Moments;

namespace {

struct Exact {
  double mean, variance, skewness;
};

// Two passes in long double, over differences to the first sample, so that an offset costs no
// digit. Rounding is relative to these: n eps / 2 at worst, 3e-15 for 1e5 samples
Exact exact(const std::vector<double> &samples)
{
  using Wide = long double;
  static_assert(std::numeric_limits<Wide>::digits >= 64, "long double holds no more than double");
  const Wide n = samples.size(), start = samples.front();
  Wide sum = 0, m2 = 0, m3 = 0;
  for (double x : samples) sum += x - start;
  const Wide mean = sum / n;
  for (double x : samples) {
    const Wide d = (x - start) - mean;
    m2 += d * d;
    m3 += d * d * d;
  }
  const double square = double(m2 / n);
  return {double(start + mean), double(m2 / (n - 1)), double(m3 / n) / (square * std::sqrt(square))};
}

Moments accumulated(const std::vector<double> &samples)
{
  Moments moments;
  for (double x : samples) moments.add(x);
  return moments;
}

std::vector<double> lognormal(int n, double offset, unsigned seed)
{
  std::mt19937_64 random(seed);
  std::lognormal_distribution<double> law(0.0, 0.6);
  std::vector<double> samples(n);
  for (double &x : samples) x = offset + law(random);
  return samples;
}

// The mean is exact to the last digit but one. The sums of squares and cubes are rounded
// once per sample, n eps / 2 in the worst case of roundings that all go one way, and the
// cubes partly cancel: tolerance is relative, for variance and skewness.
void expectEqual(const Moments &moments, const Exact &truth, double tolerance)
{
  EXPECT_NEAR(moments.mean(), truth.mean,
    std::numeric_limits<double>::epsilon() * std::fabs(truth.mean));
  EXPECT_NEAR(moments.variance(), truth.variance, tolerance * truth.variance);
  EXPECT_NEAR(moments.skewness(), truth.skewness, tolerance * (1 + std::fabs(truth.skewness)));
}

}

TEST(Moments, KnownByHand)
{
  // 1 2 3 10: mean 4, squares 9 4 1 36 = 50, cubes -27 -8 -1 216 = 180
  const Moments moments = accumulated({1, 2, 3, 10});
  EXPECT_DOUBLE_EQ(moments.count(), 4);
  EXPECT_DOUBLE_EQ(moments.mean(), 4);
  EXPECT_DOUBLE_EQ(moments.variance(), 50.0 / 3);
  EXPECT_DOUBLE_EQ(moments.populationVariance(), 12.5);
  EXPECT_DOUBLE_EQ(moments.standardError(), std::sqrt(50.0 / 12));
  EXPECT_DOUBLE_EQ(moments.skewness(), 45.0 / std::pow(12.5, 1.5));
}

TEST(Moments, NoSampleHasNoMoments)
{
  const Moments none;
  EXPECT_EQ(none.count(), 0);
  EXPECT_TRUE(std::isnan(none.mean()));
  EXPECT_TRUE(std::isnan(none.variance()));
  EXPECT_TRUE(std::isnan(none.populationVariance()));
  EXPECT_TRUE(std::isnan(none.skewness()));
  EXPECT_TRUE(std::isnan(none.standardError()));
}

TEST(Moments, FewSamples)
{
  const Moments one = accumulated({-7.25});
  EXPECT_EQ(one.mean(), -7.25);
  EXPECT_EQ(one.populationVariance(), 0);
  EXPECT_TRUE(std::isnan(one.variance()));
  EXPECT_TRUE(std::isnan(one.skewness()));

  const Moments two = accumulated({1, 3});
  EXPECT_EQ(two.mean(), 2);
  EXPECT_EQ(two.variance(), 2);
  EXPECT_EQ(two.standardError(), 1);
  EXPECT_TRUE(std::isnan(two.skewness()));
}

TEST(Moments, ConstantSamplesHaveNoSkewness)
{
  const Moments moments = accumulated(std::vector<double>(1000, 0.1));
  EXPECT_EQ(moments.mean(), 0.1);
  EXPECT_EQ(moments.variance(), 0);
  EXPECT_TRUE(std::isnan(moments.skewness()));
}

TEST(Moments, SkewedSamples)
{
  const auto samples = lognormal(100000, 0, 1);
  expectEqual(accumulated(samples), exact(samples), 1e-11);
}

// Offset 1e9 over a spread of about 1: sums of squares would leave no digit at all
TEST(Moments, LargeOffset)
{
  const auto samples = lognormal(100000, 1e9, 2);
  const Exact truth = exact(samples);
  expectEqual(accumulated(samples), truth, 1e-11);

  double sum = 0, squares = 0;
  for (double x : samples) { sum += x; squares += x * x; }
  const double n = samples.size(), naive = (squares - sum * sum / n) / (n - 1);
  EXPECT_GT(std::fabs(naive - truth.variance), 0.1 * truth.variance)
    << "the data are not hostile enough to tell a naive sum from this one";
}

TEST(Moments, WideRangeOfMagnitudes)
{
  std::vector<double> samples;
  for (int i = 0; i < 2000; i++) samples.push_back(std::pow(10.0, (i * 37 % 200) / 10.0 - 10));
  expectEqual(accumulated(samples), exact(samples), 1e-12);
}

TEST(Moments, OneOutlierAmongMany)
{
  std::vector<double> samples(9999, 1.0);
  samples.insert(samples.begin() + 5000, 1e6);
  expectEqual(accumulated(samples), exact(samples), 1e-11);
}

TEST(Moments, MergeEqualsOneStream)
{
  const auto samples = lognormal(10007, 1e6, 3);
  const Exact truth = exact(samples);
  for (int parts : {2, 3, 64}) {
    std::vector<Moments> share(parts);
    // unequal shares, some of them empty or with one sample
    for (std::size_t i = 0; i < samples.size(); i++)
      share[std::size_t(parts * std::pow(double(i) / samples.size(), 3.0))].add(samples[i]);
    Moments whole;
    for (const Moments &m : share) whole.merge(m);
    EXPECT_EQ(whole.count(), samples.size());
    expectEqual(whole, truth, 1e-11);
  }
}

TEST(Moments, MergeWithDistantMean)
{
  const std::vector<double> low{1, 2, 4}, high{1e8, 1e8 + 3};
  std::vector<double> both(low);
  both.insert(both.end(), high.begin(), high.end());
  Moments merged = accumulated(low);
  merged.merge(accumulated(high));
  expectEqual(merged, exact(both), 1e-14);
}

TEST(Moments, MergeWithEmptyChangesNothing)
{
  const Moments some = accumulated({1, 2, 5}), none;
  Moments left = some, right = none;
  left.merge(none);
  right.merge(some);
  for (const Moments &m : {left, right}) {
    EXPECT_EQ(m.count(), some.count());
    EXPECT_EQ(m.mean(), some.mean());
    EXPECT_EQ(m.variance(), some.variance());
    EXPECT_EQ(m.skewness(), some.skewness());
  }
}

TEST(Moments, PackedAndUnpackedIsBitwiseTheSame)
{
  const auto samples = lognormal(100, 1e3, 4);
  Moments whole = accumulated(samples), first;
  for (int i = 0; i < 50; i++) first.add(samples[i]);
  double buffer[Moments::PACKED];
  first.pack(buffer);
  Moments second = Moments::unpack(buffer);
  for (int i = 50; i < 100; i++) second.add(samples[i]);
  EXPECT_EQ(second.count(), whole.count());
  EXPECT_EQ(second.mean(), whole.mean());
  EXPECT_EQ(second.variance(), whole.variance());
  EXPECT_EQ(second.skewness(), whole.skewness());
}
