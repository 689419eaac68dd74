/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WEAR_FINNIE_H
#define GRAINJET_WEAR_FINNIE_H

#include "physics/wear/coefficients.h"
#include "physics/wear/wear_law.h"

namespace grainjet {
namespace wear {

/* Cutting of ductile targets: Finnie, Wear 3 (1960) 87.

     V = k m v^2 g(a)
     g = sin 2a - 6/R sin^2 a   for tan a <= R/6,   R/6 cos^2 a   above

   R = 2 is the ratio of the vertical to the horizontal force on the tip of the particle: with it the largest volume is removed
   at 17 degrees and none at 90, where metals do wear. With the flow pressure p of the target [Pa], of the order of its
   hardness,

     k = c/(psi R p)

   psi = 2: length of contact over depth of cut; c = 0.5: Finnie's estimate of the fraction of particles that cut.
   The k_finnie of LIGGGHTS is the same k.                                                                      */
class Finnie : public WearLaw {
 public:

  static constexpr double RATIO = 2.0;

  static CoefficientList coefficients()
  {
    return {
      {"k", "removed volume over m v^2 g, 1/Pa"}, {"pressure", "flow pressure of the target, Pa, in place of k"},
      {"fraction", "of the particles that cut, with pressure, at most 1, 0.5 if not given"},
      {"psi", "length of contact over depth of cut, with pressure, 2 if not given"},
      {"ratio", "vertical over horizontal force, 2 if not given"}};
  }

  explicit Finnie(const Coefficients &c) : ratio_(c.number("ratio", RATIO))
  {
    if (c.has("k") == c.has("pressure")) c.fail("needs either k (1/Pa) or pressure (flow pressure of the target, Pa)");
    if (c.has("k")) {
      for (const char *name : {"fraction", "psi"})
        if (c.has(name)) c.fail("coefficient '" + std::string(name) + "' goes with pressure, not with k");
      k_ = c.number("k");
    } else {
      const double fraction = c.has("fraction") ? c.between("fraction", 0.0, 1.0) : 0.5;
      k_ = fraction / (c.number("psi", 2.0) * ratio_ * c.number("pressure"));
    }
  }

  // g(a)
  double angleFactor(double angle) const
  {
    const double s = std::sin(angle), c = std::cos(angle);
    return 6.0 * s <= ratio_ * c ? s * (2.0 * c - 6.0 / ratio_ * s) : ratio_ / 6.0 * c * c;
  }

 private:

  double removed(const Impact &i) const override
  {
    return k_ * i.particles * i.mass * i.speed * i.speed * angleFactor(i.angle);
  }

  double k_, ratio_;
};

}
}

#endif
