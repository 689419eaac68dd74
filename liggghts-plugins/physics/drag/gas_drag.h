/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_GAS_DRAG_H
#define GRAINJET_DRAG_GAS_DRAG_H

#include "physics/drag/drag_state.h"
#include "physics/drag/power.h"
#include "physics/drag/shaped_drag.h"

#include <algorithm>
#include <cmath>

namespace grainjet {
namespace drag {

/* Drag of spheres in a gas at any Mach number M = |ur|/c of the slip, and in a rarefied gas. The two
   laws are for lone spheres; here they have the voidage function of Wen & Yu (wen_yu.h), as the laws
   of shaped_drag.h have: an assumption for anything but M -> 0, and 1 at void fraction 1.

   A law returns the drag over Stokes' drag, Cd Re/24, times what dilutedDrag() needs. M and Re vanish
   together at rest, where the Knudsen number stays, so nothing is divided by either.               */
struct GasState {
  State flow;
  double speedOfSound;       // m/s, c of the gas around the grain
  double gamma;              // -, ratio of its specific heats
};

// x^2, x^4
inline double squared(double x) { return x * x; }
inline double fourth(double x) { return squared(squared(x)); }

/* Loth, Daspit, Jeong, Nagata & Nonomura (2021), AIAA J. 59, 3261:

   Re <= 45, where the gas is rarefied before it is compressed,
     Cd = (C1 + M^4 C2)/(1 + M^4),  C1 = 24/Re (1 + 0.15 Re^0.687) fKn,  C2 = Cfm/(1 + (Cfm/J - 1) sqrt(Re/45))
     fKn = 1/(1 + Kn (2.514 + 0.8 exp(-0.55/Kn))),  Kn = sqrt(pi gamma/2) M/Re
     Cfm, free molecules that are reflected diffusely by a wall of the gas' temperature, s = M sqrt(gamma/2):
         (1 + 2 s^2) exp(-s^2)/(s^3 sqrt(pi)) + (4 s^4 + 4 s^2 - 1) erf(s)/(2 s^4) + 2 sqrt(pi)/(3 s)
     J = 2.26 - 0.1/M + 0.14/M^3 (M <= 1),  1.6 + 0.25/M + 0.11/M^2 + 0.44/M^3 (M > 1)
   Re > 45,
     Cd = 24/Re (1 + 0.15 Re^0.687) H + 0.42 C/(1 + 42500/Re^(1.16 C) + G/sqrt(Re))
     C = 1.65 + 0.65 tanh(4 M - 3.4) (M < 1.5),  2.18 - 0.13 tanh(0.9 M - 2.7)
     G = 166 M^3 + 3.29 M^2 - 10.9 M + 20 (M < 0.8),  5 + 40/M^3
     H = 0.0239 M^3 + 0.212 M^2 - 0.074 M + 1 (M < 1),  0.93 + 1/(3.5 + M^5)

   For spheres below the Reynolds number at which their boundary layer turns turbulent. M -> 0 is
   Schiller & Naumann up to Re 45 and close to Clift & Gauvin beyond. It jumps at Re = 45, see docs/theory-drag.md.  */
inline double loth(const GasState &gas)
{
  const State &s = gas.flow;
  const double re = reynolds(s);
  const double mach = s.slipSpeed / gas.speedOfSound;
  const double viscous = 1.0 + 0.15 * power(re, 0.687);

  // M^4 C2 is nothing where M is cut off, in formulas that are 1/M^3 - 1/M^3 there
  const double m = std::max(mach, 1e-3);
  const double m3 = m * m * m;

  const double kn = std::sqrt(0.5 * M_PI * gas.gamma) * s.viscosity / (s.voidFraction * s.diameter * gas.speedOfSound);
  const double slip = 1.0 / (1.0 + kn * (2.514 + 0.8 * std::exp(-0.55 / std::max(kn, 1e-3))));
  const double speedRatio = m * std::sqrt(0.5 * gas.gamma);
  const double s2 = squared(speedRatio), s4 = fourth(speedRatio);
  const double free = (1.0 + 2.0 * s2) * std::exp(-s2) / (speedRatio * s2 * std::sqrt(M_PI))
    + (4.0 * s4 + 4.0 * s2 - 1.0) * std::erf(speedRatio) / (2.0 * s4)
    + 2.0 * std::sqrt(M_PI) / (3.0 * speedRatio);
  const double j = m <= 1.0 ? 2.26 - 0.1 / m + 0.14 / m3 : 1.6 + 0.25 / m + 0.11 / (m * m) + 0.44 / m3;
  const double c2 = free / (1.0 + (free / j - 1.0) * std::sqrt(re / 45.0));
  const double rarefied = (viscous * slip + fourth(mach) * c2 * re / 24.0) / (1.0 + fourth(mach));

  const double c = m < 1.5 ? 1.65 + 0.65 * std::tanh(4.0 * mach - 3.4) : 2.18 - 0.13 * std::tanh(0.9 * mach - 2.7);
  const double g = m < 0.8 ? 20.0 + mach * (-10.9 + mach * (3.29 + 166.0 * mach)) : 5.0 + 40.0 / m3;
  const double h = m < 1.0 ? 1.0 + mach * (-0.074 + mach * (0.212 + 0.0239 * mach))
    : 0.93 + 1.0 / (3.5 + mach * fourth(mach));
  const double n = std::max(re, 1.0);    // not less than 45 where it counts
  const double compressed = viscous * h + re / 24.0 * 0.42 * c / (1.0 + 42500.0 * power(n, -1.16 * c) + g / std::sqrt(n));

  return dilutedDrag(s, re <= 45.0 ? rarefied : compressed);
}

/* Henderson (1976), AIAA J. 14, 707, with S = M sqrt(gamma/2) and the sphere's temperature over the gas', t:

     M <= 1:  Cd = 24/(Re + S (4.33 + (3.65 - 1.53 t)/(1 + 0.353 t) exp(-0.247 Re/S)))
                 + exp(-0.5 M/sqrt(Re)) ((4.5 + 0.38 (0.03 Re + 0.48 sqrt(Re)))/(1 + 0.03 Re + 0.48 sqrt(Re))
                                         + 0.1 M^2 + 0.2 M^8) + 0.6 S (1 - exp(-M/Re))
     M >= 1.75:  Cd = (0.9 + 0.34/M^2 + 1.86 sqrt(M/Re) (2 + 2/S^2 + 1.058 sqrt(t)/S - 1/S^4)) / (1 + 1.86 sqrt(M/Re))
     between:  linear in M between the first at M = 1 and the second at M = 1.75, at the same Re

   Continuous in M. For Re below that of a turbulent boundary layer, M up to 6. At M -> 0 within 6 % of Schiller &
   Naumann up to Re 100; above that it is larger, see docs/theory-drag.md.                          */
class Henderson {
 public:

  // t: temperature of the particle over that of the gas
  explicit Henderson(double temperatureRatio) : t_(temperatureRatio) {}

  double operator()(const GasState &gas) const
  {
    const State &s = gas.flow;
    const double re = reynolds(s);
    const double mach = s.slipSpeed / gas.speedOfSound;

    // M/Re, which stays at rest
    const double ratio = s.viscosity / (s.voidFraction * s.diameter * gas.speedOfSound);
    const double over = mach < 1.75 ? std::max(0.0, (mach - 1.0) / 0.75) : 1.0;
    const double factor = std::sqrt(0.5 * gas.gamma);
    const double low = subsonic(re, std::min(mach, 1.0), mach < 1.0 ? ratio : 1.0 / std::max(re, 1e-100), factor);
    const double high = supersonic(std::max(re, 1e-100), std::max(mach, 1.75), factor);
    return dilutedDrag(s, (1.0 - over) * low + over * re / 24.0 * high);
  }

 private:

  double t_;

  // Cd Re/24; ratio: M/Re
  double subsonic(double re, double mach, double ratio, double factor) const
  {
    const double overRe = factor * ratio;    // S/Re
    const double root = std::sqrt(re);
    const double wake = 0.03 * re + 0.48 * root;
    const double viscous = 1.0 / (1.0 + overRe * (4.33
      + (3.65 - 1.53 * t_) / (1.0 + 0.353 * t_) * std::exp(-0.247 / std::max(overRe, 1e-4))));
    const double pressure = std::exp(-0.5 * std::sqrt(mach * ratio))
      * ((4.5 + 0.38 * wake) / (1.0 + wake) + 0.1 * squared(mach) + 0.2 * squared(fourth(mach)));
    return viscous + re / 24.0 * (pressure - 0.6 * factor * mach * std::expm1(-ratio));
  }

  // Cd
  double supersonic(double re, double mach, double factor) const
  {
    const double S = mach * factor;
    const double layer = 1.86 * std::sqrt(mach / re);
    return (0.9 + 0.34 / squared(mach)
      + layer * (2.0 + 2.0 / squared(S) + 1.058 * std::sqrt(t_) / S - 1.0 / fourth(S))) / (1.0 + layer);
  }
};

}
}

#endif
