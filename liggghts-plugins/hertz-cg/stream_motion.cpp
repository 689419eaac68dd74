/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/stream_motion.h"

#include <algorithm>
#include <cmath>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

void StreamMotion::start(int n, const double *x, const double velocity[3], const Limits &limits)
{
  hold_.assign(x, x + 3 * static_cast<std::size_t>(n));
  std::copy(velocity, velocity + 3, velocity_);
  limits_ = limits;
}

/* ---------------------------------------------------------------------- */

StreamMotion::Expired StreamMotion::expired(int n, const double *x, double time) const
{
  double shift[3];
  bool far = false;
  for (int d = 0; d < 3; ++d) {
    shift[d] = velocity_[d] * time;
    far |= !(std::fabs(shift[d]) + limits_.relative <= limits_.stream[d]);
  }
  // grains that came or went without a search: their number says so
  if (far || 3 * static_cast<std::size_t>(n) != hold_.size()) return STREAM;
  if (grains_expired(n, x, shift)) return RELATIVE;
  // no grain has left the stream's way by more than the relative limit: often that settles it
  double towards = 0.0;
  for (int d = 0; d < 3; ++d)
    if (limits_.wallAxes[d]) towards += shift[d] * shift[d];
  if (limits_.wall > 0.0 && std::sqrt(towards) + limits_.relative > limits_.wall && walls_expired(n, x)) return STREAM;
  return FRESH;
}

/* ---------------------------------------------------------------------- */

bool StreamMotion::grains_expired(int n, const double *x, const double shift[3]) const
{
  const double *h = hold_.data();
  const double limit = limits_.relative * limits_.relative;
  int far = 0;
  for (int i = 0; i < 3 * n; i += 3) {
    const double dx = x[i] - h[i] - shift[0];
    const double dy = x[i + 1] - h[i + 1] - shift[1];
    const double dz = x[i + 2] - h[i + 2] - shift[2];
    // also of a grain that is nowhere: the search that follows says which
    far |= !(dx * dx + dy * dy + dz * dz <= limit);
  }
  return far != 0;
}

/* ---------------------------------------------------------------------- */

bool StreamMotion::walls_expired(int n, const double *x) const
{
  const double *h = hold_.data();
  const double limit = limits_.wall * limits_.wall;
  const double wx = limits_.wallAxes[0], wy = limits_.wallAxes[1], wz = limits_.wallAxes[2];
  int far = 0;
  for (int i = 0; i < 3 * n; i += 3) {
    const double dx = wx * (x[i] - h[i]);
    const double dy = wy * (x[i + 1] - h[i + 1]);
    const double dz = wz * (x[i + 2] - h[i + 2]);
    far |= dx * dx + dy * dy + dz * dz > limit;
  }
  return far != 0;
}

/* ---------------------------------------------------------------------- */

double MarginChoice::best() const
{
  // an empty box
  if (!(diameter > 0.0) || !(largest > 0.0)) return largest;
  const double smallest = std::min(0.02 * diameter, largest);
  double choice = largest, least = 0.0;
  for (double s = largest; ; s *= 0.8) {
    s = std::max(s, smallest);
    const double shell = (diameter + s) / (diameter + with);
    const double searches = std::max(2.0 * displacement / s, forced);
    const double cost = pairs * shell * shell * shell + search * searches;
    if (s == largest || cost < least) { choice = s; least = cost; }
    if (s <= smallest) break;
  }
  return choice;
}
