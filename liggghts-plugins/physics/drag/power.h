/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_POWER_H
#define GRAINJET_DRAG_POWER_H

#include <cmath>

namespace grainjet {
namespace drag {

/* Logarithm of x >= 0 that raises no floating-point exception at 0, where OpenFOAM would
   stop the run: there it is that of 1e-300, -691. Without a branch, of
   which a compiler may compute both sides.                                            */
inline double safeLog(double x)
{
  return std::log(x + 1e-300);
}

/* x^y for x >= 0 as exp(y ln x), which raises no exception at 0 either. Its relative error is
   some 1e-16 times 1 + |y ln x|, for Re up to 1e6 less than 1e-14. x = 0 gives less than
   1e-100 for y > 1/3.                                                                  */
inline double power(double x, double y)
{
  return std::exp(y * safeLog(x));
}

}
}

#endif
