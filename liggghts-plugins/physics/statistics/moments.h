/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_MOMENTS_H
#define GRAINJET_MOMENTS_H

#include <cmath>
#include <limits>

namespace grainjet {

/* Count, mean, variance and skewness of a stream of samples, in one pass and without
   keeping the samples. Two accumulators merge into the one that would have seen both
   streams, so ranks and restarts need nothing else.

   Sums of powers are never formed: central moments are updated (Welford 1962; third
   order and merging after Pebay, SAND2008-6212), and the mean carries its own rounding
   error along (Knuth's two-sum), so a large common offset costs no digits beyond those
   the samples themselves have lost.

   What is undefined is NaN, never a number that looks like a result:
     no sample            mean
     fewer than 2         variance, standard error
     fewer than 3, or a spread that is not above round-off of the mean: skewness    */
class Moments {
 public:

  // doubles that pack() writes and unpack() reads
  static constexpr int PACKED = 5;

  void add(double x)
  {
    const double before = n_;
    n_ += 1.0;
    const double delta = (x - mean_) - low_;
    const double step = delta / n_;
    const double square = delta * step * before;
    shift(step);
    m3_ += square * step * (n_ - 2.0) - 3.0 * step * m2_;
    m2_ += square;
  }

  void merge(const Moments &other)
  {
    if (other.n_ == 0.0) return;
    if (n_ == 0.0) { *this = other; return; }
    const double n = n_ + other.n_;
    const double delta = (other.mean_ - mean_) + (other.low_ - low_);
    const double step = delta / n;
    m3_ += other.m3_
      + delta * step * step * n_ * other.n_ * (n_ - other.n_)
      + 3.0 * step * (n_ * other.m2_ - other.n_ * m2_);
    m2_ += other.m2_ + delta * step * n_ * other.n_;
    shift(step * other.n_);
    n_ = n;
  }

  // number of samples; whole, exact up to 2^53
  double count() const { return n_; }

  double mean() const { return n_ >= 1.0 ? mean_ : undefined(); }

  // of the sample, sum (x - mean)^2 / (n - 1)
  double variance() const { return n_ >= 2.0 ? m2_ / (n_ - 1.0) : undefined(); }

  // sum (x - mean)^2 / n: of the samples themselves, as used for rms fluctuations
  double populationVariance() const { return n_ >= 1.0 ? m2_ / n_ : undefined(); }

  // of the mean, for independent samples: sqrt(variance / n)
  double standardError() const { return n_ >= 2.0 ? std::sqrt(variance() / n_) : undefined(); }

  // g1 = sqrt(n) sum (x - mean)^3 / (sum (x - mean)^2)^(3/2), the moment coefficient
  double skewness() const
  {
    const double roundOff = 4.0 * std::numeric_limits<double>::epsilon() * std::fabs(mean_);
    if (n_ < 3.0 || !(std::sqrt(m2_ / n_) > roundOff)) return undefined();
    return std::sqrt(n_) * m3_ / (m2_ * std::sqrt(m2_));
  }

  void pack(double *buffer) const
  {
    buffer[0] = n_;
    buffer[1] = mean_;
    buffer[2] = low_;
    buffer[3] = m2_;
    buffer[4] = m3_;
  }

  static Moments unpack(const double *buffer)
  {
    Moments moments;
    moments.n_ = buffer[0];
    moments.mean_ = buffer[1];
    moments.low_ = buffer[2];
    moments.m2_ = buffer[3];
    moments.m3_ = buffer[4];
    return moments;
  }

 private:

  // mean + low += step, with what rounding takes from the mean kept in low
  void shift(double step)
  {
    step += low_;
    const double sum = mean_ + step;
    const double added = sum - mean_;
    low_ = (mean_ - (sum - added)) + (step - added);
    mean_ = sum;
  }

  static double undefined() { return std::numeric_limits<double>::quiet_NaN(); }

  double n_ = 0.0;      // samples
  double mean_ = 0.0;   // rounded to double
  double low_ = 0.0;    // the rest of it
  double m2_ = 0.0;     // sum (x - mean)^2
  double m3_ = 0.0;     // sum (x - mean)^3
};

}

#endif
