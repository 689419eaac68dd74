/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_SHAPED_DRAG_H
#define GRAINJET_DRAG_SHAPED_DRAG_H

#include "physics/drag/drag_state.h"
#include "physics/drag/power.h"

#include <cmath>
#include <functional>
#include <string>

namespace grainjet {
namespace drag {

/* Drag of particles that are no spheres, by their sphericity phi: surface of the sphere of equal volume
   over that of the particle. The diameter is that of this sphere, so mass and volume of the grain
   are right. The drag is a mean over orientations, along the slip.

   Both were measured on lone particles. Here they have the voidage function of Wen & Yu
   (wen_yu.h), Cd at Re = eps |ur| d/nu times eps^-2.65, which is an assumption for any shape but spheres,
   and 1 at eps = 1.                                                                            */
inline double dilutedDrag(const State &s, double overStokes)
{
  return 18.0 * s.density * s.viscosity / (s.diameter * s.diameter) * overStokes
    * power(s.voidFraction, -2.65);
}

/* Haider & Levenspiel (1989), Powder Technol. 58, 63:

     Cd = 24/Re (1 + A Re^B) + C/(1 + D/Re)
     A = exp(2.3288 - 6.4581 phi + 2.4486 phi^2)         B = 0.0964 + 0.5565 phi
     C = exp(4.905 - 13.8944 phi + 18.4222 phi^2 - 10.2599 phi^3)
     D = exp(1.4681 + 12.2584 phi - 20.7322 phi^2 + 15.8855 phi^3)

   Isometric solids of phi 0.67 to 1 and discs down to 0.026, Re < 25000. For Re -> 0 the drag is that of the
   sphere for every shape.                                                                      */
class HaiderLevenspiel {
 public:

  static constexpr double LEAST = 0.026;    // sphericity

  explicit HaiderLevenspiel(double phi)
    : A_(std::exp(2.3288 + phi * (-6.4581 + phi * 2.4486))), B_(0.0964 + 0.5565 * phi),
      C_(std::exp(4.905 + phi * (-13.8944 + phi * (18.4222 - phi * 10.2599)))),
      D_(std::exp(1.4681 + phi * (12.2584 + phi * (-20.7322 + phi * 15.8855)))) {}

  double operator()(const State &s) const
  {
    const double re = reynolds(s);
    return dilutedDrag(s, 1.0 + A_ * power(re, B_) + C_ / 24.0 * re * (re / (re + D_)));
  }

 private:

  double A_, B_, C_, D_;
};

/* Ganser (1993), Powder Technol. 77, 143, for isometric shapes:

     Cd/K2 = 24/Z (1 + 0.1118 Z^0.6567) + 0.4305/(1 + 3305/Z),    Z = Re K1 K2
     K1 = 3/(1 + 2 phi^-1/2),    log10 K2 = 1.8148 (-log10 phi)^0.5743

   For Re -> 0 the drag is 1/K1 of the sphere's. phi of 0.09 to 1 (Chhabra, Agarwal & Sinha 1999, Powder
   Technol. 101, 288, who found it the best of five forms), Z < 1e5.                             */
class Ganser {
 public:

  static constexpr double LEAST = 0.09;     // sphericity

  explicit Ganser(double phi)
    : overSphere_((1.0 + 2.0 / std::sqrt(phi)) / 3.0),
      stretch_(std::pow(10.0, 1.8148 * std::pow(std::fabs(std::log10(phi)), 0.5743)) / overSphere_) {}

  double operator()(const State &s) const
  {
    const double z = stretch_ * reynolds(s);
    return dilutedDrag(s, overSphere_
      * (1.0 + 0.1118 * power(z, 0.6567) + 0.4305 / 24.0 * z * (z / (z + 3305.0))));
  }

 private:

  double overSphere_, stretch_;    // 1/K1, K1 K2
};

/* Those laws by the names of scripts. findShapedLaw: least sphericity and the law for one, or a NULL
   function if there is none of that name                                                       */
struct ShapedLaw {
  const char *name;
  double least;
  std::function<double(const State &)> (*make)(double sphericity);
};

template<class LAW>
std::function<double(const State &)> makeShapedLaw(double sphericity)
{
  return LAW(sphericity);
}

inline const ShapedLaw *findShapedLaw(const std::string &name)
{
  static const ShapedLaw laws[] = {
    {"haiderLevenspiel", HaiderLevenspiel::LEAST, makeShapedLaw<HaiderLevenspiel>},
    {"ganser", Ganser::LEAST, makeShapedLaw<Ganser>}
  };
  for (const ShapedLaw &law : laws)
    if (name == law.name) return &law;
  return nullptr;
}

inline std::string shapedLawNames() { return "haiderLevenspiel, ganser"; }

}
}

#endif
