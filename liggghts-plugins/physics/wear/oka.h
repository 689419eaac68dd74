/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WEAR_OKA_H
#define GRAINJET_WEAR_OKA_H

#include "physics/wear/coefficients.h"
#include "physics/wear/wear_law.h"

namespace grainjet {
namespace wear {

/* Metals from the hardness of the target and the kind of abrasive: Oka, Okamura & Yoshida, Wear 259 (2005) 95 and Oka &
   Yoshida, Wear 259 (2005) 102.

     V/m = g(a) E90                              mm3/kg
     E90 = K H^k1 (v/v')^k2 (d/d')^k3            H: Vickers hardness of the target in GPa
     g   = sin^n1 a (1 + H (1 - sin a))^n2       1 at 90 degrees

     abrasive  K   k1     k2           k3    v' m/s  d' um  n1           n2
     SiO2      65  -0.12  2.3 H^0.038  0.19  104     326    0.71 H^0.14  2.4 H^-0.94
     SiC       45  -0.05  3.0 H^0.085  0.19  99      326    0.71 H^0.14  2.8 H^-1.00
     glass     27  -0.16  2.1          0.19  100     200    2.8 H^0.41   2.6 H^-1.46     (beads)

   Any number of the table can be given, in place of the preset's or without an abrasive all of them. Measured at 50 to
   167 m/s. The hardness in scripts is in Pa.                                                             */
class Oka : public WearLaw {
 public:

  // c[0] H^c[1] wherever the exponent depends on the hardness
  struct Abrasive {
    const char *name;
    double K, k1, k2[2], k3, speed, diameter, n1[2], n2[2];
  };

  static constexpr Abrasive ABRASIVES[] = {
    {"SiO2", 65.0, -0.12, {2.3, 0.038}, 0.19, 104.0, 326e-6, {0.71, 0.14}, {2.4, -0.94}},
    {"SiC", 45.0, -0.05, {3.0, 0.085}, 0.19, 99.0, 326e-6, {0.71, 0.14}, {2.8, -1.00}},
    {"glass", 27.0, -0.16, {2.1, 0.0}, 0.19, 100.0, 200e-6, {2.8, 0.41}, {2.6, -1.46}}
  };

  static CoefficientList coefficients()
  {
    return {
      {"hardness", "Vickers hardness of the target, Pa, 1e7 to 1e11"}, {"abrasive", "SiO2, SiC or glass"},
      {"E90", "removed volume per mass of abrasive at 90 degrees, reference speed and diameter, mm3/kg"},
      {"k2", "exponent of the speed"}, {"k3", "exponent of the diameter"}, {"n1", "exponent of sin a"},
      {"n2", "exponent of 1 + H (1 - sin a)"}, {"referenceSpeed", "m/s"}, {"referenceDiameter", "m"}};
  }

  explicit Oka(const Coefficients &c) : hardness_(1e-9 * c.between("hardness", 1e7, 1e11))
  {
    const Abrasive *a = c.preset("abrasive", ABRASIVES);
    const auto value = [&](const char *name, double preset) { return a ? c.number(name, preset) : c.number(name); };
    const auto power = [&](const double (&of)[2]) { return of[0] * std::pow(hardness_, of[1]); };
    if (!a && !c.has("E90")) c.fail("needs an abrasive (SiO2, SiC or glass) or all of E90, k2, k3, n1, n2, "
      "referenceSpeed, referenceDiameter");
    e90_ = value("E90", a ? a->K * std::pow(hardness_, a->k1) : 0.0);
    k2_ = value("k2", a ? power(a->k2) : 0.0);
    k3_ = value("k3", a ? a->k3 : 0.0);
    n1_ = value("n1", a ? power(a->n1) : 0.0);
    n2_ = value("n2", a ? power(a->n2) : 0.0);
    speed_ = value("referenceSpeed", a ? a->speed : 0.0);
    diameter_ = value("referenceDiameter", a ? a->diameter : 0.0);
  }

  // g(a)
  double angleFactor(double angle) const
  {
    const double s = std::sin(angle);
    return std::pow(s, n1_) * std::pow(1.0 + hardness_ * (1.0 - s), n2_);
  }

 private:

  double removed(const Impact &i) const override
  {
    return 1e-9 * e90_ * i.particles * i.mass * std::pow(i.speed / speed_, k2_) * std::pow(i.diameter / diameter_, k3_)
      * angleFactor(i.angle);
  }

  double hardness_;    // GPa
  double e90_;         // mm3/kg
  double k2_, k3_, n1_, n2_, speed_, diameter_;
};

}
}

#endif
