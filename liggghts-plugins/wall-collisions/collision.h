/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_COLLISION_H
#define GRAINJET_COLLISION_H

#include <cmath>

namespace grainjet {

/* One collision of one grain with a watched surface, from the first to the last DEM step in
   contact. Plain doubles, since that is what goes between ranks and into restart files.
   Everything is of the grain, SI units. A plate needs no more than the first OF_PLATE of
   them, and keeps no more, but for the temperature, which is kept where grains have one.  */
struct Collision {
  double steps;             // DEM steps in contact so far
  double time;              // s, of the first of them; negative: began unobserved
  double duration;          // s
  double a, b;              // m, grain centre at first contact, in the plane of a plate
  double speed;             // m/s, before contact, against the surface
  double angle;             // degrees between that velocity and the surface's normal
  double energy;            // J, translational (of that velocity) and rotational
  double normalPeak;        // N, largest normal force, positive when it pushes the grain off
  double tangentialPeak;    // N
  double normalSum;         // N s, of the force over the time in contact
  double tangentialSum;     // N s
  double mesh, triangle;    // touched last: place in the list of meshes, element ID
  double surface[3];        // m/s, of the surface there
  double x[3];              // m, grain centre at first contact
  double firstMesh, firstTriangle;    // touched first
  double slidingWork;       // J, integral of normal force times speed of sliding (Archard)
  double workHere;          // J, that part of it which belongs to the triangle touched last
  double temperature;       // K, of the grain at first contact; 0 where grains have none

  static constexpr int OF_PLATE = 17;
  static constexpr int OF_SURFACE = 24;
  static constexpr int SIZE = 25;
  double *data() { return &steps; }
  const double *data() const { return &steps; }

  double normalMean() const { return normalSum / duration; }
  double tangentialMean() const { return tangentialSum / duration; }

  // One DEM step in contact. normal: unit vector away from the surface, on the grain's side
  void addStep(const double *force, const double *normal, double dt)
  {
    const double fn = force[0] * normal[0] + force[1] * normal[1] + force[2] * normal[2];
    double square = 0;
    for (int i = 0; i < 3; i++)
      square += (force[i] - fn * normal[i]) * (force[i] - fn * normal[i]);
    const double ft = std::sqrt(square);
    if (steps == 0 || fn > normalPeak) normalPeak = fn;
    if (ft > tangentialPeak) tangentialPeak = ft;
    normalSum += fn * dt;
    tangentialSum += ft * dt;
    duration += dt;
    steps += 1;
  }
};

static_assert(sizeof(Collision) == Collision::SIZE * sizeof(double), "plain doubles only");

/* A collision that is over. */
struct FinishedCollision {
  Collision contact;
  double id;                // atom ID
  double particles;         // original particles that the grain stands for, f_cg^3
  double speedAfter;        // m/s, against the surface
  double energyAfter;       // J, with that velocity
  double mass, radius;      // kg, m, of the grain

  static constexpr int SIZE = Collision::SIZE + 6;
  double energyLoss() const { return contact.energy - energyAfter; }
};

static_assert(sizeof(FinishedCollision) == FinishedCollision::SIZE * sizeof(double),
  "plain doubles only");

/* Sliding work that a grain has done on one triangle while it touched that without a break. */
struct SlidingPiece {
  double time;              // s, when it left the triangle
  double id;                // atom ID
  double mesh, triangle;
  double work;              // J

  static constexpr int SIZE = 5;
};

static_assert(sizeof(SlidingPiece) == SlidingPiece::SIZE * sizeof(double), "plain doubles only");

}

#endif
