/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_COLLISION_H
#define GRAINJET_COLLISION_H

#include <cmath>

namespace grainjet {

/* One collision of one grain with the plate, from the first to the last DEM step in
   contact. Plain doubles, since that is what travels between ranks and into restart
   files. Everything is of the grain, SI units.                                       */
struct Collision {
  double steps;             // DEM steps in contact so far
  double time;              // s, of the first of them; negative: began unobserved
  double duration;          // s
  double a, b;              // m, grain centre at first contact, in the plate's plane
  double speed;             // m/s, before contact, against the surface
  double angle;             // degrees between that velocity and the plate's normal
  double energy;            // J, translational (of that velocity) and rotational
  double normalPeak;        // N, largest normal force, positive when it pushes the grain off
  double tangentialPeak;    // N
  double normalSum;         // N s, of the force over the time in contact
  double tangentialSum;     // N s
  double mesh, triangle;    // touched last: place in the list of the wall's meshes, element ID
  double surface[3];        // m/s, of the surface there

  static constexpr int SIZE = 17;
  double *data() { return &steps; }
  const double *data() const { return &steps; }

  double normalMean() const { return normalSum / duration; }
  double tangentialMean() const { return tangentialSum / duration; }

  // One DEM step in contact. normal: unit vector away from the plate, on the grain's side
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

  static constexpr int SIZE = Collision::SIZE + 4;
  double energyLoss() const { return contact.energy - energyAfter; }
};

static_assert(sizeof(FinishedCollision) == FinishedCollision::SIZE * sizeof(double),
  "plain doubles only");

}

#endif
