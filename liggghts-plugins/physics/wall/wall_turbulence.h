/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WALL_WALL_TURBULENCE_H
#define GRAINJET_WALL_WALL_TURBULENCE_H

#include <cmath>

namespace grainjet {
namespace wall {

/* Turbulence in the layer next to a smooth wall that a wall function bridges, as shapes over the
   distance: the value at y is that at y_P times shape(y+)/shape(y_P+). y+ is made with the
   velocity C_mu^(1/4) sqrt(k) of the layer.

   In the log layer k = u_tau^2/sqrt(C_mu) and epsilon = u_tau^3/(kappa y), as the k-epsilon model and its
   wall functions have it (Launder & Spalding 1974). Below it:

     k        goes with y^2, as a velocity without slip demands: 0.07 y+^2 u_tau^2, which is the DNS
              of pipe flow by Fukagata & Kasagi (2002) at y+ 1 to 4 (0.077 to 0.067, Re_tau 180). It
              meets the log layer's value at y+ 6.9
     epsilon  stays constant from the edge of the sublayer on, y+ 11.5: 0.21 u_tau^4/nu. DNS have
              0.12 to 0.2 there
     nut      goes with y^3

   code_saturne's model of deposition has the same shapes with other edges (0.1 y+^2 up to 5, and
   epsilon constant up to 30 [0.2 u_tau^4/nu]), of which k jumps.                                */
class WallTurbulence {
public:
  // sublayerEdge   y+ where u+ = y+ meets the log law
  // Cmu            constant of the k-epsilon model
  explicit WallTurbulence(double sublayerEdge = 11.53, double Cmu = 0.09) :
    epsilonEdge_(sublayerEdge), kEdge_(1.0 / std::sqrt(0.07 * std::sqrt(Cmu)))
  {}

  // y+ below which k falls
  double edgeOfK() const { return kEdge_; }

  // Of k: 1 in the log layer
  double k(double yPlus) const
  {
    const double x = yPlus < kEdge_ ? yPlus / kEdge_ : 1.0;
    return x * x;
  }

  // Of epsilon: 1/y+ in the log layer
  double epsilon(double yPlus) const { return 1.0 / (yPlus > epsilonEdge_ ? yPlus : epsilonEdge_); }

private:
  double epsilonEdge_, kEdge_;
};

}
}

#endif
