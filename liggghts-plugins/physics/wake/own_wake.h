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
   Stokes flow on the mesh; for large w the body leaves behind what it has set in motion. k_i
   depends on the place in the cell (Place): it is the mean over the pairs of a cell that holds a part of
   the force and a cell that is sampled.

   The numbers are not fitted to flows with bodies. They describe the linear response of the
   equations on a cubic mesh, worked out in wave numbers: second-order differences for diffusion,
   the pressure of a collocated mesh, implicit Euler in time. The body moves in a straight
   line through cells, averaged over places in the cell and directions; its force lies in the
   cells that hold its parts, its sample is that of the interpolation. validation/own_wake/response.py
   computes them. rms error for w L/nu from 0.1 to 1000: 3 % sampled linearly, 5 % from the cell;
   largest 7 and 18 %; at a given place of the cell 3 and 13 %; at rest, while the flow builds up, 7 and
   10 %.

   Sources for the idea: Horwitz & Mani (2016) J. Comput. Phys. 318, 85; Esmaily & Horwitz (2018)
   J. Comput. Phys. 375, 960; Balachandar, Liu & Lakhote (2019) J. Comput. Phys. 376, 160.   */
struct Response {
  double k[2][4];            // of each mode, for each number of Place
  double t[2], l[2];
};

// sampled is the value of the cell, or linear interpolation between cell centre and points
constexpr Response CELL = {
  {{0.4717, 0.5473, -0.7657, 3.605}, {0.2829, 0.0407, 0.2910, -0.5705}}, {0.0847, 0.4874}, {0.5186, 0.5262}};
constexpr Response CELL_POINT = {
  {{0.4395, 0.4888, -2.005, 5.100}, {0.1409, 0.0088, 0.1420, -0.2405}}, {0.1073, 0.9653}, {0.6495, 1.050}};

/* How much of its own force a body samples at once: the shares of pairs of a cell that holds a part of the force and a
   cell that is sampled, which are the same cell, or neighbours over a face, an edge, a corner. Worked
   out axis by axis for a cell that is a box.                                              */
struct Place {
  double pairs[4];
  double inside[4];         // the same if the value of the cell is sampled

  // offset: from the middle of the cell over half of its side, along each axis. radius: of the
  // body over half of the side along each axis, 0 if its force is not divided. linear: sampled by
  // linear interpolation between cell centre and points, else from the cell
  Place(const double (&offset)[3], const double (&radius)[3], bool linear)
  {
    double local[3], beyond[3], nearest = 0.0;
    for (int k = 0; k < 3; k++) {
      local[k] = std::fmin(std::fabs(offset[k]), 1.0);
      nearest = std::fmax(nearest, local[k]);
      // part of a sphere that lies beyond the next face
      const double R = std::fmin(radius[k], 1.0), room = 1.0 - local[k], in = std::fmax(R - room, 0.0);
      beyond[k] = in * in * (2.0 * R + room) / (4.0 * R * R * R + 1e-300);
    }

    for (int n = 0; n < 4; n++) inside[n] = n == 0 ? 1.0 : 0.0;
    for (int k = 0; k < 3; k++) multiply(inside, 1.0 - beyond[k], beyond[k]);
    if (!linear) {
      for (int n = 0; n < 4; n++) pairs[n] = inside[n];
      return;
    }

    // A point of the mesh has the mean of the cells around it: half of them on either side
    double points[4] = {1.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < 3; k++) {
      const double towards = 0.5 * (1.0 + local[k] / (nearest + 1e-300));
      multiply(points, 0.5 * towards + 0.5 * (1.0 - beyond[k]) * (1.0 - towards), 0.5);
    }
    for (int n = 0; n < 4; n++) pairs[n] = (1.0 - nearest) * inside[n] + nearest * points[n];
  }

 private:

  static void multiply(double (&q)[4], double same, double next)
  {
    for (int n = 3; n > 0; n--) q[n] = q[n] * same + q[n - 1] * next;
    q[0] *= same;
  }
};

/* One time step of the fluid. The solver treats diffusion implicitly, and so do the modes:

       a_i' = (a_i + R/(rho V)) kept_i,    R the impulse that the fluid gets in the step
       u = sum over i of weight_i a_i

   R is what the body gives, J, if the source of the momentum equation is explicit. If it is linearised in the
   velocity U of the cell with a slope K, with a debt d that later steps pay,

       R  = J + w d - K dt (U' - U),    d' = (1 - w) d + K dt (U' - U),    w = 1/(1 + K dt/(rho V))

   and what the body does to U' - U is known from the modes, too: the cell stays where it is, so that only
   viscosity fades them there, by still_i.                                                     */
struct Step {
  double kept[2], weight[2];
  double still[2], ofCell[2];

  // D: nu dt/L^2. C: w dt/L
  Step(const Response &r, const Place &place, double D, double C)
  {
    for (int i = 0; i < 2; i++) {
      const double fading = D / r.t[i], leaving = C / r.l[i];
      still[i] = 1.0 / (1.0 + fading);
      kept[i] = std::exp(fading - std::sqrt(fading * fading + leaving * leaving)) / (1.0 + fading);
      weight[i] = ofCell[i] = 0.0;
      for (int n = 0; n < 4; n++) {
        weight[i] += r.k[i][n] * place.pairs[n];
        ofCell[i] += r.k[i][n] * place.inside[n];
      }
    }
  }

  // Advance the modes a of one component.
  // given: J/(rho V). kappa: K dt/(rho V), 0 for an explicit source. owed: d/(rho V)
  // Returns u
  double advance(double given, double kappa, double (&a)[2], double &owed) const
  {
    const double w = 1.0 / (1.0 + kappa);
    double fades = 0.0, answer = 0.0;
    for (int i = 0; i < 2; i++) {
      fades += ofCell[i] * (1.0 - still[i]) * a[i];
      answer += ofCell[i] * still[i];
    }
    const double received = (given + w * owed + kappa * fades) / (1.0 + kappa * answer);
    owed = (1.0 - w) * owed + kappa * (answer * received - fades);

    double u = 0.0;
    for (int i = 0; i < 2; i++) {
      a[i] = (a[i] + received) * kept[i];
      u += weight[i] * a[i];
    }
    return u;
  }
};

}
}

#endif
