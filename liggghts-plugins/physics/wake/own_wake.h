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

       u(t) = integral F(t') K(t - t') dt',
       K(t) = sum over i = 1, 2 of k_i/(rho V) exp(- t sqrt((nu/(t_i L^2))^2 + (w/(l_i L))^2))

   with the viscosity nu that the flow is solved with, and w the speed of the body relative to the
   undisturbed fluid. A steady force in fluid at rest gives u = F/(rho nu L) sum k_i t_i, the
   Stokes flow on the mesh; for large w the body leaves behind what it has set in motion.

   The numbers are not fitted to flows with bodies. They describe the linear response of the
   equations on a cubic mesh, worked out in wave numbers: second-order differences for diffusion,
   the pressure of a collocated mesh, implicit Euler in time. The body moves in a straight
   line through cells, averaged over places in the cell and directions; its force lies in the
   cells that hold its parts, its sample is that of the interpolation. validation/own_wake/response.py
   computes them: rms error 3 %, largest 7 %, for w L/nu from 0.1 to 1000;
   at rest, while the flow builds up, 7 and 16 %.

   Sources for the idea: Horwitz & Mani (2016) J. Comput. Phys. 318, 85; Esmaily & Horwitz (2018)
   J. Comput. Phys. 375, 960; Balachandar, Liu & Lakhote (2019) J. Comput. Phys. 376, 160.   */
struct Response {
  // of each mode, and how they change with the body's diameter over L, up to 1, if its force is
  // divided among the cells that it reaches
  double k[2], kSize[2];
  double t[2], tSize[2];
  double l[2], lSize[2];
};

// sampled is the value of the cell, or linear interpolation between cell centre and points
constexpr Response CELL = {
  {0.439, 0.3105}, {-0.1724, -0.1184}, {0.1228, 0.4055}, {-0.0355, 0.1098},
  {0.6028, 0.3473}, {0.0373, 0.3303}};
constexpr Response CELL_POINT = {
  {0.2416, 0.0746}, {-0.0727, -0.0283}, {0.0981, 0.8890}, {0.0366, 0.2981},
  {0.5842, 0.9336}, {0.1623, 0.2645}};

/* One time step of the fluid. The solver treats diffusion implicitly, and so do the modes:

       u_i' = (u_i + gain_i J/(rho V)) kept_i,    J = F dt the impulse of the step           */
struct Step {
  double gain[2], kept[2];

  // size: diameter of the body over L, 0 if its force is not divided. D: nu dt/L^2. C: w dt/L
  Step(const Response &r, double size, double D, double C)
  {
    const double s = size < 1.0 ? size : 1.0;
    for (int i = 0; i < 2; i++) {
      const double fading = D / (r.t[i] + r.tSize[i] * s), leaving = C / (r.l[i] + r.lSize[i] * s);
      gain[i] = r.k[i] + r.kSize[i] * s;
      kept[i] = std::exp(fading - std::sqrt(fading * fading + leaving * leaving)) / (1.0 + fading);
    }
  }
};

}
}

#endif
