/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_STATE_H
#define GRAINJET_DRAG_STATE_H

#include <cmath>

namespace grainjet {
namespace drag {

/* What every drag law depends on. A law is a function

       double law(const State &)      [kg/(m3 s)]

   that returns the drag force per volume of solid and per slip velocity, so that the
   force on a particle or grain of volume V is law(state) * V * (uf - up). In the paper's
   notation (Weaver & Miskovic 2023, Eq. 18) this is beta/(1 - eps).

   diameter is that of the ORIGINAL particle, also for a grain: d = d_grain / f_cg
   (section 2.4). Only the volume V is the grain's.

   The coupling computes a law for 16 grains in one loop, in which a compiler may compute both
   sides of a branch and choose afterwards. So neither side may raise a floating-point
   exception, whatever the values: OpenFOAM ends the run for one.                        */
struct State {
  double voidFraction;   // -, fluid volume fraction eps, 0 < eps <= 1
  double slipSpeed;      // m/s, |uf - up| >= 0
  double diameter;       // m, of the original particle
  double density;        // kg/m3, of the fluid
  double viscosity;      // m2/s, kinematic, of the fluid
};

// Particle Reynolds number with the superficial slip velocity, eps |ur| d / nu
inline double reynolds(const State &s)
{
  return s.voidFraction * s.slipSpeed * s.diameter / s.viscosity;
}

// 1 - eps; not negative, though an interpolated void fraction may exceed 1 by round-off
inline double solidFraction(const State &s)
{
  return std::fabs(1.0 - s.voidFraction);
}

typedef double (*Law)(const State &);

}
}

#endif
