/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WEAR_ARCHARD_H
#define GRAINJET_WEAR_ARCHARD_H

#include "physics/wear/coefficients.h"
#include "physics/wear/wear_law.h"

namespace grainjet {
namespace wear {

/* Wear by sliding: Archard, J. Appl. Phys. 24 (1953) 981.

     V = K W/H,     W = integral of normal force times speed of sliding over the contact

   K: dimensionless coefficient of wear, 1e-8 to 1e-2. H: hardness of the softer body [Pa]. Neither speed nor angle of the
   impact enter, and a grain's W is that of its particles (see Impact).                                           */
class Archard : public WearLaw {
 public:

  static CoefficientList coefficients()
  {
    return {
      {"K", "coefficient of wear, dimensionless, at most 1"}, {"hardness", "of the target, Pa, 1e5 to 1e12"}};
  }

  explicit Archard(const Coefficients &c) : perWork_(c.between("K", 0.0, 1.0) / c.between("hardness", 1e5, 1e12)) {}

 private:

  double removed(const Impact &i) const override { return perWork_ * i.slidingWork; }

  double perWork_;    // m3/J
};

}
}

#endif
