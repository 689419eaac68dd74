/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_STREAM_MOTION_H
#define GRAINJET_STREAM_MOTION_H

#include <cstddef>
#include <vector>

namespace grainjet {

/* Decides when a list of pairs, made with a margin between surfaces, has to be made anew.

   Two grains cannot meet unseen before one of them has moved half the margin relative to any
   common motion of all grains. The common motion taken out here is the mean velocity at the
   last search: a stream of 6 m/s with fluctuations of 0.3 m/s needs a search about twenty
   times less often than by absolute displacement.

   Two things still go by absolute displacement: what lies near a wall (the walls' own lists are
   made at the same time), counted along the directions in which walls face, and the way of the
   stream as a whole, since grains change rank and leave the box only at a search.         */
class StreamMotion {
 public:

  struct Limits {
    double relative;     // m, largest displacement relative to the stream
    double wall;         // m, largest absolute displacement along wallAxes; <= 0: no walls
    bool wallAxes[3];
    double stream[3];    // m, largest absolute displacement along each axis
  };

  // Remember n positions (3 n values); velocity: common motion [m/s], equal on all ranks
  void start(int n, const double *x, const double velocity[3], const Limits &limits);

  // Which limit have the n grains used up, `time` seconds after start()? STREAM: that of walls or of
  // the way of the stream, or grains came or went; RELATIVE: that of two grains
  enum Expired { FRESH, STREAM, RELATIVE };
  Expired expired(int n, const double *x, double time) const;

  std::size_t bytes() const { return hold_.capacity() * sizeof(double); }

 private:

  bool grains_expired(int n, const double *x, const double shift[3]) const;
  bool walls_expired(int n, const double *x) const;

  std::vector<double> hold_;
  double velocity_[3] = {0.0, 0.0, 0.0};
  Limits limits_ = {};
};

/* The margin for which searches and the pairs listed by them together cost least.

   Per grain and step a margin s costs pairs(s) visits and 1/steps(s) searches, where the number
   of pairs grows with the volume of the shell, pairs ~ (d + s)^3, and a search lasts until the
   fastest grain has moved s/2, or until something else asks for one: then more margin is of no use. */
struct MarginChoice {
  double diameter;       // m, of the largest grain
  double largest;        // m, up to which ghosts have been fetched
  double pairs;          // pairs listed per grain with the margin `with`
  double with;           // m
  double displacement;   // m per step, of the fastest grain relative to the stream
  double search = 60.0;  // cost of a search per grain, in visits of a listed pair
  double forced = 0.0;   // searches per step that come whatever the margin

  double best() const;
};

}

#endif
