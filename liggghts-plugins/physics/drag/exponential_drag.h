/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_EXPONENTIAL_DRAG_H
#define GRAINJET_EXPONENTIAL_DRAG_H

#include <cmath>

namespace grainjet {
namespace drag {

/* Exact drag over a kick of length h for

     m dv/dt = b (u - v) + f        b, u and f constant during the kick.

   With x = b h / m and phi1(x) = (1 - exp(-x)) / x the solution is

     v(h) = v exp(-x) + (1 - exp(-x)) u + phi1 h f / m,

   so the mean force of the drag during the kick, which an integrator adds to f, is

     D = b phi1 (u - v) - (1 - phi1) f.

   Stable for any x; for x -> infinity v(h) = u + f / b, the terminal velocity.        */
struct ExponentialDrag {
  double slip;    // kg/s, b phi1: multiplies u - v
  double other;   // -, 1 - phi1: the part of the other force that drag takes up

  // below this x the difference 1 - phi1 would lose digits: its series
  static constexpr double SMALL = 0.05;

  __attribute__((always_inline)) static double series(double x)
  {
    return x * (1.0/2 - x * (1.0/6 - x * (1.0/24 - x * (1.0/120 - x * (1.0/720
      - x * (1.0/5040 - x * (1.0/40320)))))));
  }

  ExponentialDrag(double b, double kick, double mass)
  {
    const double x = b * kick / mass;
    double phi1;
    if (x < SMALL) {
      other = series(x);
      phi1 = 1.0 - other;
    } else {
      phi1 = -std::expm1(-x) / x;
      other = 1.0 - phi1;
    }
    slip = b * phi1;
  }
};

}
}

#endif
