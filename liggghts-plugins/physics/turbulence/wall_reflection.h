/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WALL_REFLECTION_H
#define GRAINJET_WALL_REFLECTION_H

#include <algorithm>
#include <cmath>

namespace grainjet {
namespace turbulence {

/* Way of a grain in an interval dt in which the fluid at it has a velocity u,

     way = fluid u + own_velocity v    response time tau, from 1/tau            */
struct GrainWay {
  double kept;          // v at the end from v
  double own_velocity;  // s
  double fluid;         // s

  GrainWay(double dt, double rate)
  {
    const double x = rate * dt;
    const double lost = -std::expm1(-x);
    kept = 1.0 - lost;
    own_velocity = x > 1e-8 ? lost / rate : dt;
    fluid = dt - own_velocity;
  }
};

/* The fluctuation seen by a grain is mirrored where the grain meets a wall: in homogeneous turbulence, and at
   a wall that throws grains back as they come, the whole of place, velocity and fluctuation is then that
   without a wall, folded at it. So tracers stay evenly spread, and no grain is
   pushed into a wall for longer than until it is there. Part of the interval passes before and
   the rest after the reflection; the mean over it is that of both.
   gap:     m, between the surface of the grain and the wall
   normal:  of the wall, out of the fluid
   way:     m, of the grain in the interval if there were no wall; folded, so that further walls
            may follow
   xi:      fluctuation at the end of the interval
   mean:    m/s, mean fluctuation over the interval
   returns whether the wall is met                                                       */
inline bool reflect_at_wall(double gap, const double *normal, double *way, double *xi,
                            double *mean)
{
  const double out = normal[0] * way[0] + normal[1] * way[1] + normal[2] * way[2];
  if (!(out > 0.0 && out > gap)) return false;

  const double after = 1.0 - std::max(gap, 0.0) / out;
  const double xi_out = normal[0] * xi[0] + normal[1] * xi[1] + normal[2] * xi[2];
  const double mean_out = normal[0] * mean[0] + normal[1] * mean[1] + normal[2] * mean[2];
  for (int k = 0; k < 3; k++) {
    way[k] -= 2.0 * after * out * normal[k];
    xi[k] -= 2.0 * xi_out * normal[k];
    mean[k] -= 2.0 * after * mean_out * normal[k];
  }
  return true;
}

}
}

#endif
