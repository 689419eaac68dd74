/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_LOG_HISTOGRAM_H
#define GRAINJET_LOG_HISTOGRAM_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace grainjet {

/* How often a stream of samples fell into bins whose edges form a geometric series,

     edge(i) = least (most/least)^(i/bins),   0 <= i <= bins,

   so that a spectrum over many decades has the same relative width everywhere. Bin i holds
   edge(i) <= x < edge(i+1). What lies beyond the edges is kept apart and not lost: below() has
   x < least, also zero, negative and undefined (NaN) samples, above() has x >= most.

   A sample can have a weight, such as the number of particles that a grain stands for. Sums of whole
   weights are exact up to 2^53 in any order, so the result is the same on any number of ranks;
   sums of other weights differ by rounding.

   Two histograms of the same edges merge into the one that would have seen both streams.  */
class LogHistogram {
 public:

  // Is this a set of edges? Bins narrower than 1e-12 of their edges would be rounding only.
  static bool valid(double least, double most, int bins)
  {
    return least > 0.0 && most > least && std::isfinite(most) && bins >= 1
      && (std::log(most) - std::log(least)) / bins > 1e-12;
  }

  // throws std::invalid_argument unless valid(least, most, bins)
  LogHistogram(double least, double most, int bins)
  {
    if (!valid(least, most, bins))
      throw std::invalid_argument("LogHistogram needs 0 < least < most and one bin or more");
    edges_.resize(bins + 1);
    const double range = std::log(most) - std::log(least);
    for (int i = 0; i < bins; ++i) edges_[i] = least * std::exp(range * i / bins);
    edges_[0] = least;
    edges_[bins] = most;
    weights_.assign(bins + 2, 0.0);
  }

  void add(double x, double weight = 1.0) { weights_[place(x)] += weight; }

  // false, and nothing is changed, if the edges are others
  [[nodiscard]] bool merge(const LogHistogram &other)
  {
    if (!sameEdges(other)) return false;
    for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] += other.weights_[i];
    return true;
  }

  bool sameEdges(const LogHistogram &other) const { return edges_ == other.edges_; }

  int bins() const { return static_cast<int>(edges_.size()) - 1; }
  double edge(int i) const { return edges_[i]; }

  // geometric mean of the edges of bin i
  double middle(int i) const { return std::sqrt(edges_[i]) * std::sqrt(edges_[i + 1]); }

  // sums of weights: of bin i, of what lies below and above all bins, of all samples
  double weight(int i) const { return weights_[i + 1]; }
  double below() const { return weights_.front(); }
  double above() const { return weights_.back(); }
  double total() const
  {
    double sum = 0.0;
    for (double w : weights_) sum += w;
    return sum;
  }

  // Probability density in bin i, per unit of the samples: its share of the total divided by its
  // width. The integral over all bins is 1 less the shares below and above. NaN if there is no sample
  double density(int i) const
  {
    const double sum = total();
    return sum > 0.0 ? weight(i) / (sum * (edges_[i + 1] - edges_[i])) : std::numeric_limits<double>::quiet_NaN();
  }

  // ---- as doubles: edges and weights, so that unpack() needs nothing else

  int packed() const { return 3 + static_cast<int>(weights_.size()); }

  // doubles that a histogram of so many bins packs
  static int packed(int bins) { return 5 + bins; }

  void pack(double *buffer) const
  {
    buffer[0] = bins();
    buffer[1] = edges_.front();
    buffer[2] = edges_.back();
    std::copy(weights_.begin(), weights_.end(), buffer + 3);
  }

  static LogHistogram unpack(const double *buffer)
  {
    LogHistogram histogram(buffer[1], buffer[2], static_cast<int>(buffer[0]));
    std::copy_n(buffer + 3, histogram.weights_.size(), histogram.weights_.begin());
    return histogram;
  }

 private:

  std::vector<double> edges_;      // ascending
  std::vector<double> weights_;    // below, bins, above

  // by the edges themselves, since a logarithm would round samples on an edge to either side
  std::size_t place(double x) const
  {
    if (!(x >= edges_.front())) return 0;
    return std::upper_bound(edges_.begin(), edges_.end(), x) - edges_.begin();
  }
};

}

#endif
