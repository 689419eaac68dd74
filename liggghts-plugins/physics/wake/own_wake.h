/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_OWN_WAKE_H
#define GRAINJET_OWN_WAKE_H

#include <cmath>

namespace grainjet {
namespace wake {

/* The velocity that a body itself causes in a fluid on a mesh, where it is sampled at the body.

   A force F on the fluid of a cell of volume V = L^3 gives the velocity that is then sampled at
   the body

       u(t) = integral F(t') K(t - t') dt',    K = sum over i = 1, 2 of
              k_i/(rho V) exp(- (t - t') (nu/(t_i L^2) + w/(l_i L)))

   with the viscosity nu that the flow is solved with, and w the speed of the body relative to the
   undisturbed fluid. Mode 1 is the body's own cell, mode 2 the flow around it. For w = 0 a steady
   force gives u = F/(rho nu L) sum k_i t_i, the Stokes flow on the mesh; for large w the body
   leaves behind what it has set in motion.

   The numbers are not fitted to flows with bodies. They describe the linear response of the
   equations on a cubic mesh, in wave numbers: second-order differences for
   diffusion, pressure at the same places as velocity (wave number sin(kL) in the gradient and
   2 sin(kL/2) in the equation for pressure), implicit Euler in time; the body moves in a straight
   line through cells, averaged over places in the cell and directions; its force lies in the
   cells that hold its parts, its sample is that of the interpolation. validation/own_wake/response.py
   computes them and says how well they fit.

   Sources for the idea: Horwitz & Mani (2016) J. Comput. Phys. 318, 85; Esmaily & Horwitz (2018)
   J. Comput. Phys. 375, 960; Balachandar, Liu & Lakhote (2019) J. Comput. Phys. 376, 160.   */
struct Response {
  // of each mode, and how they change with the body's diameter over L, up to 1, if its force is
  // divided among the cells that it reaches
  double k[2], kSize[2];
  double t[2], tSize[2];
  double l[2], lSize[2];
  double step;               // growth with the time step, see below
};

// sampled is the value of the cell, or linear interpolation between cell centre and points
constexpr Response CELL = {
  {0.637, 0.00935}, {-0.290, -0.0024}, {0.193, 4.13}, {0.030, 1.0}, {0.48, 7.65}, {0.22, 3.2}, 0.35};
constexpr Response CELL_POINT = {
  {0.206, 0.00720}, {-0.050, -0.0007}, {0.236, 4.30}, {0.027, 0.3}, {0.80, 8.1}, {0.11, 1.0}, 0.31};

/* One time step of the fluid. The solver treats diffusion implicitly, and so do the modes:

       u_i' = (u_i + gain_i J/(rho V)) kept_i,    J = F dt the impulse of the step

   The pressure equation lets through a part of the velocity that its wide gradient does not see,
   more of it the longer the step is: factor 1 + step sqrt(6 D/(1 + 6 D)).            */
struct Step {
  double gain[2], kept[2];

  // size: diameter of the body over L, 0 if its force is not divided. D: nu dt/L^2. C: w dt/L
  Step(const Response &r, double size, double D, double C)
  {
    const double s = size < 1.0 ? size : 1.0;
    const double grown = 1.0 + r.step * std::sqrt(6.0 * D / (1.0 + 6.0 * D));
    for (int i = 0; i < 2; i++) {
      gain[i] = grown * (r.k[i] + r.kSize[i] * s);
      kept[i] = std::exp(-C / (r.l[i] + r.lSize[i] * s)) / (1.0 + D / (r.t[i] + r.tSize[i] * s));
    }
  }
};

}
}

#endif
