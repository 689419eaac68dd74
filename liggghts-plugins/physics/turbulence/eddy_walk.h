/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_EDDY_WALK_H
#define GRAINJET_EDDY_WALK_H

#include "physics/turbulence/grain_random.h"

#include <algorithm>
#include <cmath>

namespace grainjet {
namespace turbulence {

/* Time in which a grain crosses an eddy of a length, with a slip and a response time tau (Gosman and Ioannides
   1983); without end if it is caught in it.                                             */
inline double crossing_time(double length, double slip, double response_time)
{
  const double reach = response_time * slip;
  if (reach <= length) return 1e30;
  return -response_time * std::log1p(-length / reach);
}

/* Discrete random walk: the fluctuation xi = u'/s is constant while the grain is in an eddy and new in
   the next one, each component standard normal. Variance 2k/3 per component, diffusivity s2
   times half the mean life time.                                                     */
class EddyWalk {
public:
  // eddies that are followed one by one in an interval; the mean of more is Gaussian
  static constexpr int MOST = 32;

  // Numbers from draw `first` on
  explicit EddyWalk(const GrainRandom &random, uint32_t first = 0) : random_(random), draws_(first) {}

  /* xi:    of the eddy that the grain is in
     left:  s, that it stays in it
     life:  life(xi), s, time in an eddy of this fluctuation
     mean:  mean of xi over the interval dt                                            */
  template<class Life>
  void advance(double dt, const Life &life, double *xi, double &left, double *mean)
  {
    double rest = dt;
    double sum[3] = {0.0, 0.0, 0.0};
    for (int n = 0; left < rest; n++) {
      for (int k = 0; k < 3; k++)
        sum[k] += left * xi[k];
      rest -= left;
      draw(xi);
      left = std::max(life(xi), 1e-9 * dt);

      if (n == MOST && left < rest) {
        // independent eddies: variance of their mean
        double many[3];
        draw(many);
        for (int k = 0; k < 3; k++)
          sum[k] += std::sqrt(left * rest) * many[k];
        rest = 0.0;
        draw(xi);
      }
    }
    for (int k = 0; k < 3; k++)
      mean[k] = (sum[k] + rest * xi[k]) / dt;
    left -= rest;
  }

  // The next eddy
  void draw(double *xi)
  {
    double four[4];
    random_.normals(draws_++, four);
    std::copy(four, four + 3, xi);
  }

private:
  const GrainRandom &random_;
  uint32_t draws_;
};

}
}

#endif
