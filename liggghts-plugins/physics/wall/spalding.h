/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WALL_SPALDING_H
#define GRAINJET_WALL_SPALDING_H

#include <cmath>

namespace grainjet {
namespace wall {

/* The law of the wall in one formula, Spalding (1961), J. Appl. Mech. 28, 455: distance from a
   smooth wall y+ = y u_tau/nu as a function of the velocity u+ = u/u_tau,

     y+ = u+ + (exp(z) - 1 - z - z^2/2 - z^3/6)/E,   z = kappa u+

   It is u+ = y+ at the wall and u+ = ln(E y+)/kappa far from it.
   All arguments are from 0 on.                                                             */
class Spalding {
public:
  // kappa   von Karman's constant
  // E       constant of the log law
  explicit Spalding(double kappa = 0.41, double E = 9.8) : kappa_(kappa), oneOverE_(1.0 / E) {}

  double kappa() const { return kappa_; }
  double E() const { return 1.0 / oneOverE_; }

  // y+ of u+; infinite where the exponential is
  double yPlus(double uPlus) const
  {
    return uPlus + oneOverE_ * tail(kappa_ * uPlus).value;
  }

  // d(y+)/d(u+) = 1 + nut/nu of a layer with constant stress
  double slope(double uPlus) const
  {
    return 1.0 + oneOverE_ * kappa_ * tail(kappa_ * uPlus).slope;
  }

  // u+ of y+, to the last digits, for y+ up to 1e15. Newton's iteration: y+ is convex in u+, so
  // that it falls monotonically after its first step. Three to five steps for y+ above 10
  double uPlus(double yPlus) const
  {
    const double logLaw = std::log1p(yPlus / oneOverE_) / kappa_;
    double u = yPlus < logLaw ? yPlus : logLaw;
    for (int i = 0; i < 20; ++i) {
      const Tail t = tail(kappa_ * u);
      const double step = (u - yPlus + oneOverE_ * t.value) / (1.0 + oneOverE_ * kappa_ * t.slope);
      u -= step;
      if (std::fabs(step) <= 1e-9 * u) break;    // the next step would be below 1e-16
    }
    return u;
  }

  // u+/y+: 1 at the wall, also exactly at it
  double ratio(double yPlus) const { return yPlus > 0 ? uPlus(yPlus) / yPlus : 1.0; }

private:
  // exp(z) - 1 - z - z^2/2 - z^3/6 and its derivative
  struct Tail {
    double value, slope;
  };

  static Tail tail(double z)
  {
    const double cubic = z * z * z * (1.0 / 6);
    if (z < 0.2) {
      // The series, since the difference would lose its digits. Its next term is 1e-16 of u+
      const double value = 0.25 * z * cubic
        * (1 + z / 5 * (1 + z / 6 * (1 + z / 7 * (1 + z / 8 * (1 + z / 9 * (1 + z / 10))))));
      return Tail{value, value + cubic};
    }
    const double value = std::exp(z) - 1 - z - 0.5 * z * z - cubic;
    return Tail{value, value + cubic};
  }

  double kappa_, oneOverE_;
};

}
}

#endif
