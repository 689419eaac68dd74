/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_MATERIAL_H
#define GRAINJET_CONTACT_MATERIAL_H

#include <cmath>

namespace grainjet {
namespace contact {

/* Coefficients of a contact between two materials, effective values of the pair.
   Weaver & Miskovic (2023), appendix A, with two errata: (A3) prints (1 - nu^2) where the
   shear modulus needs (1 + nu), and (A8) prints the root over beta too.             */
struct PairMaterial {
  double youngs;             // Pa, E*: 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2
  double shear;              // Pa, G*: 1/G* = 2(2-nu1)(1+nu1)/E1 + 2(2-nu2)(1+nu2)/E2
  double damping;            // -, -beta >= 0, see dampingRatio
  double friction;           // -, coefficient of sliding friction
  double rollingFriction;    // -, coefficient of rolling friction
  double rollingDamping;     // -, ratio of damping of a rolling spring to the critical one
  double cohesionEnergy;     // J/m3, cohesion energy density
};

// E* of two materials with Young's moduli E [Pa] and Poisson's ratios nu
inline double effectiveYoungs(double E1, double nu1, double E2, double nu2)
{
  return 1.0 / ((1.0 - nu1 * nu1) / E1 + (1.0 - nu2 * nu2) / E2);
}

// G* of the same, for G = E/(2(1+nu))
inline double effectiveShear(double E1, double nu1, double E2, double nu2)
{
  return 1.0 / (2.0 * (2.0 - nu1) * (1.0 + nu1) / E1 + 2.0 * (2.0 - nu2) * (1.0 + nu2) / E2);
}

/* -beta = -ln e / sqrt(ln^2 e + pi^2) for a coefficient of restitution 0 < e <= 1.
   With the dashpot of hertzMindlin() the speed after a head-on impact is exactly e times
   the speed before, whatever that speed: Antypov & Elliott, Europhys. Lett. 94 (2011)
   50004, in whose notation alpha = -sqrt(5) beta.                                     */
inline double dampingRatio(double restitution)
{
  const double pi = 3.14159265358979323846;
  const double ln = std::log(restitution);
  return -ln / std::sqrt(ln * ln + pi * pi);
}

// Shear modulus of an isotropic material, G = E/(2(1+nu))
inline double shearModulus(double E, double nu)
{
  return E / (2.0 * (1.0 + nu));
}

}
}

#endif
