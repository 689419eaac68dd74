/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_LIFT_SPIN_TORQUE_H
#define GRAINJET_LIFT_SPIN_TORQUE_H

#include <algorithm>
#include <cmath>

namespace grainjet {
namespace lift {

/* Torque of the fluid on a sphere that turns at W = 1/2 curl U - w against it,

     T = pi mu d^3 W f(Re_W),    Re_W = |W| d^2/nu

     f = 1                                               Re_W < 32   (Stokes; Rubinow & Keller 1961)
       = (12.9 sqrt(Re_W) + 128.4)/(64 pi)               above, up to Re_W = 4000

   Dennis, Singh & Ingham 1980, J. Fluid Mech. 101, 257: 6.45/sqrt(R) + 32.1/R for the torque over
   rho a^5 W^2/2, R = W a^2/nu up to 1000, in the form with the diameter that is common to particle
   tracking. Both meet at Re_W = 31.7, where f is switched: continuous.                        */
constexpr double SLOW_SPIN = 128.4 / (64.0 * 3.14159265358979324);
constexpr double FAST_SPIN = 12.9 / (64.0 * 3.14159265358979324);

inline double spinTorqueFactor(double spinRe)
{
  return std::max(1.0, SLOW_SPIN + FAST_SPIN * std::sqrt(spinRe));
}

/* Mean of f while the spin decays from Re_W = spinRe by this torque alone: held constant over the
   time, it gives the spin at its end exactly. elapsed: time over I/(pi mu d^3), I the moment of
   inertia, > 0. With y = sqrt(W), dW/dt = - W (A + B y) has the solution
   y = A y0 e/(A + B y0 (1 - e)), e = exp(-A t/2), until f = 1.                                 */
inline double meanSpinTorqueFactor(double spinRe, double elapsed)
{
  const double A = SLOW_SPIN, B = FAST_SPIN, slow = (1.0 - A) / B;
  const double root = std::max(std::sqrt(spinRe), slow);
  const double still = -2.0 / A * std::log(std::min(1.0, slow * (A + B * root) / root));
  const double early = A * elapsed
    + 2.0 * std::log1p(B * root / A * -std::expm1(-0.5 * A * elapsed));
  const double late = 2.0 * std::log(root / slow) + elapsed - still;
  const double mean = (elapsed < still ? early : late) / elapsed;
  return root > slow ? mean : 1.0;
}

// Mean over the time of what decays by a factor exp(-exponent) in it, over its value before;
// exponent > 0
inline double meanOfDecay(double exponent)
{
  return -std::expm1(-exponent) / exponent;
}

}
}

#endif
