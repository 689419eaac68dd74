/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_HEAT_NUSSELT_H
#define GRAINJET_HEAT_NUSSELT_H

#include "physics/drag/power.h"

#include <cmath>
#include <string>

namespace grainjet {
namespace heat {

/* Heat transfer between a fluid and the spheres in it, as the Nusselt number Nu = h d/k: h the coefficient
   per surface (W/(m2 K)), k the fluid's conductivity. Everything is of the original PARTICLE, also where a
   grain stands for many (lumped_temperature.h). No law divides by the slip speed, and none raises a
   floating-point exception at rest: OpenFOAM ends the run for one.                               */
struct State {
  double voidFraction;     // -, fluid volume fraction eps, 0 < eps <= 1
  double slipSpeed;        // m/s, |uf - up| >= 0
  double diameter;         // m, of the original particle
  double viscosity;        // m2/s, kinematic, of the fluid
  double prandtl;          // -, Pr = nu rho cp/k of the fluid
  double viscosityRatio;   // -, mu/mu_s: of the fluid, dynamic, over that at the temperature of the
                           // particle's surface; 1 where that is not known. Used by Whitaker only
};

// Reynolds number of a lone sphere, |ur| d/nu, and that with the superficial slip velocity, eps |ur| d/nu
inline double reynolds(const State &s) { return s.slipSpeed * s.diameter / s.viscosity; }
inline double superficialReynolds(const State &s) { return s.voidFraction * reynolds(s); }

/* Ranz & Marshall (1952), Chem. Eng. Prog. 48, 141 and 173: lone spheres, measured on drops up to Re 200, in wide
   use far beyond.

     Nu = 2 + 0.6 Re^(1/2) Pr^(1/3),  Re = |ur| d/nu                                          */
inline double ranzMarshall(const State &s)
{
  return 2.0 + 0.6 * std::sqrt(reynolds(s)) * std::cbrt(s.prandtl);
}

/* Gunn (1978), Int. J. Heat Mass Transfer 21, 467: fixed and fluidised beds, 0.35 <= eps <= 1, Re up to 1e5.

     Nu = (7 - 10 eps + 5 eps^2) (1 + 0.7 Re^0.2 Pr^(1/3)) + (1.33 - 2.4 eps + 1.2 eps^2) Re^0.7 Pr^(1/3)

   Re = eps |ur| d/nu with the superficial slip velocity. At rest 2 for eps = 1.              */
inline double gunn(const State &s)
{
  const double re = superficialReynolds(s), eps = s.voidFraction, cube = std::cbrt(s.prandtl);
  return (7.0 + eps * (5.0 * eps - 10.0)) * (1.0 + 0.7 * drag::power(re, 0.2) * cube)
    + (1.33 + eps * (1.2 * eps - 2.4)) * drag::power(re, 0.7) * cube;
}

/* Whitaker (1972), AIChE J. 18, 361: lone spheres, 3.5 <= Re <= 7.6e4, 0.71 <= Pr <= 380, 1 <= mu/mu_s <= 3.2.

     Nu = 2 + (0.4 Re^(1/2) + 0.06 Re^(2/3)) Pr^0.4 (mu/mu_s)^(1/4),  Re = |ur| d/nu            */
inline double whitaker(const State &s)
{
  const double root = std::sqrt(reynolds(s)), cube = std::cbrt(reynolds(s));
  return 2.0 + (0.4 * root + 0.06 * cube * cube) * drag::power(s.prandtl, 0.4)
    * std::sqrt(std::sqrt(s.viscosityRatio));
}

typedef double (*NusseltLaw)(const State &);

/* All laws with the names by which scripts and dictionaries select them. A new law is one function and one
   line here.                                                                                      */
struct NamedNusselt {
  const char *name;
  NusseltLaw law;
};

constexpr NamedNusselt NUSSELT_LAWS[] = {
  {"ranzMarshall", ranzMarshall},
  {"gunn", gunn},
  {"whitaker", whitaker}
};

// The law of that name, or nullptr
inline NusseltLaw findNusselt(const std::string &name)
{
  for (const NamedNusselt &entry : NUSSELT_LAWS)
    if (name == entry.name) return entry.law;
  return nullptr;
}

// "ranzMarshall, gunn, ..." for messages
inline std::string nusseltNames()
{
  std::string names;
  for (const NamedNusselt &entry : NUSSELT_LAWS)
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  return names;
}

}
}

#endif
