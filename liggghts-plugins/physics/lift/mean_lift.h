/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_LIFT_MEAN_LIFT_H
#define GRAINJET_LIFT_MEAN_LIFT_H

#include "physics/drag/exponential_drag.h"

#include <cmath>

namespace grainjet {
namespace lift {

/* A lift F = s x L, s = u - v the slip and L (kg/s) constant, at the mean slip of a kick under drag
   b s, this lift and a constant force f. The lift turns with the slip within the kick:

     s + c s x L = phi1 s0 - c f,    c = (1 - phi1)/b

   (physics/drag/exponential_drag.h), of which the solution is closed. Second order in the kick, stable
   for any L and b; where drag is far faster than the kick it is the steady state.               */
struct MeanLift {
  double force[3];    // N
  double slip[3];     // m/s, the mean

  // slip: before the kick (m/s); other: f (N); b: kg/s; kick: s; mass: kg
  MeanLift(const double *before, const double *other, const double *L, double b, double kick,
    double mass)
  {
    const drag::ExponentialDrag drag(b, kick, mass);
    const double c = b > 0.0 ? drag.other / b : 0.5 * kick / mass;
    double start[3], square = 0.0, along = 0.0;
    for (int dim = 0; dim < 3; dim++) {
      start[dim] = (1.0 - drag.other) * before[dim] - c * other[dim];
      square += c * c * L[dim] * L[dim];
      along += c * c * L[dim] * start[dim];
    }
    double turned[3];
    cross(start, L, turned);
    for (int dim = 0; dim < 3; dim++)
      slip[dim] = (start[dim] + along * L[dim] - c * turned[dim]) / (1.0 + square);
    cross(slip, L, force);
  }

  double slipSpeed() const
  {
    return std::sqrt(slip[0] * slip[0] + slip[1] * slip[1] + slip[2] * slip[2]);
  }

 private:

  static void cross(const double *a, const double *b, double *result)
  {
    for (int dim = 0; dim < 3; dim++) {
      const int next = (dim + 1) % 3, last = (dim + 2) % 3;
      result[dim] = a[next] * b[last] - a[last] * b[next];
    }
  }
};

}
}

#endif
