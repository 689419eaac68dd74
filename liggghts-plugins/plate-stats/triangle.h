/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_TRIANGLE_H
#define GRAINJET_TRIANGLE_H

#include <algorithm>

namespace grainjet {

/* The point of a triangle that is nearest to p, as corner 0 + s edge01 + t edge02: the
   minimum of the squared distance, a quadratic form in s and t, inside or else on one of
   the three edges. A triangle without area is its edges. Returns the squared distance. */
inline double nearestOnTriangle(const double corner[3][3], const double *p, double *nearest)
{
  const auto dot = [](const double *u, const double *v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  double best = -1;
  const auto offer = [&](const double *point) {
    const double away[3] = {p[0] - point[0], p[1] - point[1], p[2] - point[2]};
    const double square = dot(away, away);
    if (best >= 0 && square >= best) return;
    best = square;
    std::copy_n(point, 3, nearest);
  };

  double edge[3][3], point[3];
  for (int e = 0; e < 3; e++) {
    const double *from = corner[e], *to = corner[(e + 1) % 3];
    for (int i = 0; i < 3; i++) {
      edge[e][i] = to[i] - from[i];
      point[i] = p[i] - from[i];
    }
    const double square = dot(edge[e], edge[e]);
    const double s = square > 0 ? std::min(std::max(dot(point, edge[e]) / square, 0.0), 1.0) : 0;
    for (int i = 0; i < 3; i++) point[i] = from[i] + s * edge[e][i];
    offer(point);
  }

  double u[3], v[3], w[3];
  for (int i = 0; i < 3; i++) {
    u[i] = edge[0][i];
    v[i] = -edge[2][i];
    w[i] = p[i] - corner[0][i];
  }
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const double area = uu * vv - uv * uv;
  if (!(area > 0)) return best;
  const double s = (wu * vv - wv * uv) / area, t = (wv * uu - wu * uv) / area;
  if (s < 0 || t < 0 || s + t > 1) return best;
  for (int i = 0; i < 3; i++) point[i] = corner[0][i] + s * u[i] + t * v[i];
  offer(point);
  return best;
}

}

#endif
