/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_FLUID_BLOCK_H
#define GRAINJET_FLUID_BLOCK_H

#include "held_grains.h"
#include "host/vector_registers.h"
#include "physics/drag/exponential_drag.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace LAMMPS_NS {

/* The force of a coupled fluid on SIZE grains that follow each other in memory, without added mass. LIGGGHTS'
   arrays of vectors are one block each: loops here run over its numbers, three a grain, and what belongs to a grain
   is laid out for each of its numbers first. So the compiler works on several numbers at once. The operations on a number
   are those of FixFluidForce::Push in its order: the same digits. NON_REACTING: there are forces of that kind. */
template<bool NON_REACTING>
class FluidBlock {
 public:

  static constexpr int SIZE = 16, N = 3 * SIZE;

  // what acts on the grains, from the first one of the block on: see FixFluidForce for the meaning
  struct Fluid {
    const double *velocity, *force, *coefficient;
    const double *nonReactingForce, *nonReactingCoefficient;    // NULL without that kind
  };

  // Are there so many grains of the group from this one on, none of them held?
  GRAINJET_IN_BOTH static bool may_be_taken(int first, int n, const int *mask, int groupbit, const HeldGrains &held)
  {
    if (first + SIZE > n) return false;
    int all = groupbit;
    for (int i = first; i < first + SIZE; i++) all &= mask[i];
    return all && !held.may_hold(first, SIZE);
  }

  double force[N], without[N];    // N, with and without reaction on the fluid

  // Works out the forces. kick: s; f: N, the other forces. Returns whether all are at most `largest` in size, and
  // numbers
  GRAINJET_IN_BOTH bool work_out(const Fluid &fluid, const double *__restrict v, const double *__restrict f,
    const double *__restrict mass, double kick, double largest)
  {
    share_drag(fluid, mass, kick);
    const double *__restrict u = fluid.velocity, *__restrict given = fluid.force;
    const double *__restrict alone = fluid.nonReactingForce;
    double *__restrict with = force, *__restrict other = without;

    // Of numbers that are not negative the larger one has the larger bits, and what is no number has larger ones than any
    const std::uint64_t limit = bits(largest);
    std::uint64_t signs = 0;
    for (int e = 0; e < N; e++) {
      const double rest = f[e] + (NON_REACTING ? given[e] + alone[e] : given[e]);
      const double speed = u[e] - v[e];
      with[e] = given[e] + slip_[e] * speed - taken_[e] * rest;
      double size = std::fabs(with[e]);
      if (NON_REACTING) {
        other[e] = alone[e] + slipWithout_[e] * speed - takenWithout_[e] * rest;
        size += std::fabs(other[e]);
      }
      signs |= limit - bits(size);
    }
    return !(signs >> 63);
  }

  GRAINJET_IN_BOTH double all(int e) const { return NON_REACTING ? force[e] + without[e] : force[e]; }

  // Adds half a kick by forces of the former step, less those in `less`, and one or two by `now`
  GRAINJET_IN_BOTH static void book(double *__restrict impulse, const double *__restrict now, double half, bool twice,
    const double *__restrict former, const double *__restrict less)
  {
    const double times = twice ? 2.0 : 1.0;
    if (!former)
      for (int e = 0; e < N; e++) impulse[e] += half * (times * now[e]);
    else if (less)
      for (int e = 0; e < N; e++) impulse[e] += half * ((former[e] - less[e]) + times * now[e]);
    else
      for (int e = 0; e < N; e++) impulse[e] += half * (former[e] + times * now[e]);
  }

  // One number a grain for each of its three
  GRAINJET_IN_BOTH static void spread(const double *__restrict one, double *__restrict three)
  {
    for (int i = 0; i < SIZE; i++)
      for (int dim = 0; dim < 3; dim++) three[3 * i + dim] = one[i];
  }

  template<int COUNT = N>
  GRAINJET_IN_BOTH static bool zero(const double *__restrict numbers)
  {
    std::uint64_t any = 0;
    for (int e = 0; e < COUNT; e++) any |= bits(numbers[e]) << 1;    // -0 is zero
    return any == 0;
  }

 private:

  double slip_[N], taken_[N], slipWithout_[N], takenWithout_[N];

  GRAINJET_IN_BOTH static std::uint64_t bits(double number)
  {
    std::uint64_t same;
    std::memcpy(&same, &number, sizeof(same));
    return same;
  }

  // One drag of all kinds of force, shared out by their coefficients
  GRAINJET_IN_BOTH void share_drag(const Fluid &fluid, const double *__restrict mass, double kick)
  {
    using grainjet::drag::ExponentialDrag;
    double b[SIZE], x[SIZE], slip[SIZE], other[SIZE];
    const std::uint64_t limit = bits(ExponentialDrag::SMALL) - 1;
    std::uint64_t signs = 0;
    for (int i = 0; i < SIZE; i++) {
      b[i] = fluid.coefficient[i];
      if (NON_REACTING) b[i] += fluid.nonReactingCoefficient[i];
      x[i] = b[i] * kick / mass[i];
      signs |= limit - bits(x[i]);
    }
    if (!(signs >> 63))
      for (int i = 0; i < SIZE; i++) {
        other[i] = ExponentialDrag::series(x[i]);
        slip[i] = b[i] * (1.0 - other[i]);
      }
    else
      for (int i = 0; i < SIZE; i++) {
        const ExponentialDrag drag(b[i], kick, mass[i]);
        other[i] = drag.other;
        slip[i] = drag.slip;
      }
    if (!NON_REACTING) {
      spread(slip, slip_);
      spread(other, taken_);
      return;
    }
    double with[SIZE], part[SIZE];
    if (zero<SIZE>(fluid.nonReactingCoefficient)) {
      spread(slip, slip_);
      spread(other, taken_);
      std::fill_n(slipWithout_, N, 0.0);
      std::fill_n(takenWithout_, N, 0.0);
      return;
    }
    for (int i = 0; i < SIZE; i++) {
      const double c = fluid.nonReactingCoefficient[i];
      part[i] = c > 0.0 ? c / b[i] : 0.0;
    }
    for (int i = 0; i < SIZE; i++) with[i] = (1.0 - part[i]) * slip[i];
    spread(with, slip_);
    for (int i = 0; i < SIZE; i++) with[i] = (1.0 - part[i]) * other[i];
    spread(with, taken_);
    for (int i = 0; i < SIZE; i++) with[i] = part[i] * slip[i];
    spread(with, slipWithout_);
    for (int i = 0; i < SIZE; i++) with[i] = part[i] * other[i];
    spread(with, takenWithout_);
  }
};

}

#endif
