/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WEAR_DNV_H
#define GRAINJET_WEAR_DNV_H

#include "physics/wear/coefficients.h"
#include "physics/wear/wear_law.h"

namespace grainjet {
namespace wear {

/* Quartz sand on materials of pipes: DNVGL-RP-O501 (2015), Managing sand production and erosion, section 3.

     removed mass over mass of sand = K v^n F(a)
     ductile   F = 0.6 (sin a + 7.2 (sin a - sin^2 a))^0.6 (1 - exp(-20 a))
     brittle   F = 2 a/pi

   K in (m/s)^-n. The table of materials is the practice's table 3-1. It has no influence of the particle's size.          */
class Dnv : public WearLaw {
 public:

  struct Material {
    const char *name;
    double K, n, density;
    bool ductile;
  };

  static constexpr Material MATERIALS[] = {
    {"steel", 2.0e-9, 2.6, 7800.0, true},
    {"duplex", 2.0e-9, 2.6, 7850.0, true},
    {"316", 2.0e-9, 2.6, 8000.0, true},
    {"inconel", 2.0e-9, 2.6, 8440.0, true},
    {"epoxy", 0.3e-9, 3.6, 1800.0, true},            // glass fibre reinforced
    {"vinylEster", 0.6e-9, 3.6, 1800.0, true},       // glass fibre reinforced
    {"hdpe", 3.5e-9, 2.9, 1150.0, true},
    {"aluminium", 5.8e-9, 2.3, 2700.0, true},
    {"dc05", 1.1e-10, 2.3, 15250.0, false},          // tungsten carbides
    {"cs10", 3.2e-10, 2.2, 14800.0, false},
    {"cr37", 8.8e-11, 2.5, 14600.0, false},
    {"alumina95", 6.8e-8, 2.0, 3700.0, false},
    {"alumina99", 9.5e-7, 1.2, 3700.0, false},
    {"psz", 4.1e-9, 2.5, 5700.0, false},             // zirconia
    {"zirconiaY3", 4.0e-11, 2.7, 6070.0, false},
    {"SiC", 6.5e-9, 1.9, 3100.0, false},
    {"Si3N4", 2.0e-10, 2.0, 3200.0, false},
    {"TiB2", 9.3e-9, 1.9, 4250.0, false},
    {"B4C", 3.0e-8, 0.9, 2500.0, false},
    {"SiSiC", 7.4e-11, 2.7, 3100.0, false}
  };

  struct Curve {
    const char *name;
    bool ductile;
  };

  static constexpr Curve CURVES[] = {{"ductile", true}, {"brittle", false}};

  static CoefficientList coefficients()
  {
    return {
      {"material", "of the target, by name"}, {"K", "removed over impinging mass at 1 m/s, (m/s)^-n"},
      {"n", "exponent of the speed"}, {"density", "of the target, kg/m3"}, {"curve", "ductile or brittle: function of the angle"}};
  }

  explicit Dnv(const Coefficients &c)
  {
    const Material *m = c.preset("material", MATERIALS);
    if (!m && !c.has("K")) c.fail("needs a material (steel, aluminium, ...) or all of K, n, density, curve");
    const Curve *curve = c.preset("curve", CURVES);
    if (!m && !curve) c.fail("coefficient 'curve' missing: ductile or brittle");
    K_ = m ? c.number("K", m->K) : c.number("K");
    n_ = m ? c.number("n", m->n) : c.number("n");
    density_ = m ? c.number("density", m->density) : c.number("density");
    ductile_ = curve ? curve->ductile : m->ductile;
  }

  // F(a)
  double angleFactor(double angle) const
  {
    if (!ductile_) return angle / HALF_PI;
    const double s = std::sin(angle);
    return 0.6 * std::pow(s + 7.2 * s * (1.0 - s), 0.6) * -std::expm1(-20.0 * angle);
  }

 private:

  double removed(const Impact &i) const override
  {
    return K_ / density_ * i.particles * i.mass * std::pow(i.speed, n_) * angleFactor(i.angle);
  }

  double K_, n_, density_;
  bool ductile_;
};

}
}

#endif
