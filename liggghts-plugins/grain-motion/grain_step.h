/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_GRAIN_STEP_H
#define GRAINJET_GRAIN_STEP_H

#include "fluid-force/fluid_block.h"
#include "fluid-force/held_grains.h"
#include "host/vector_registers.h"

#include <vector>

namespace LAMMPS_NS {

/* One time step of velocity Verlet for a sphere, in the parts of which fix grain/motion and the
   loop of fix fluid/force make their passes over memory. Same operations in the same order as in the
   stock nve/sphere, so the same digits. Arrays of vectors are LIGGGHTS' own blocks, three a grain. */
struct GrainStep {
  double *x, *v, *f, *omega, *torque;
  const double *radius, *rmass;
  const int *mask;
  int n;                          // grains of this rank
  int groupbit;                   // others rest
  double dt, half;                // s; half is that of the kick
  double halfOverInertia;         // half a step over 0.4, of discs in two dimensions 0.5
  double gravity[3];              // m/s2

  // Joined: the first half of the next step is done in the same pass, since nothing looks at grains
  // in between. Grains that a fix insert/stream still carries are put where they belong at the end
  // of the step, so they are left for the next step: late.
  bool join;
  HeldGrains *held;
  std::vector<int> *late;

  bool moves(int i) const { return mask[i] & groupbit; }

  // half a kick of velocity and spin by force and torque of the grain
  void kick(int i) const
  {
    double *__restrict vi = v + 3 * i;
    const double *__restrict fi = f + 3 * i;
    const double scale = half / rmass[i];
    for (int dim = 0; dim < 3; dim++) vi[dim] += scale * fi[dim];
    turn(i);
  }

  // Two half kicks by the same force, the drift and the new force in one go: kick(), then begin(), in
  // registers, since the compiler has to take every store for a change of what it loads next
  void pass(int i) const
  {
    const double *fi = f + 3 * i;
    const double force[3] = {fi[0], fi[1], fi[2]};
    pass(i, force);
  }

  void pass(int i, const double *force) const    // of a local copy, with what is to be added
  {
    double *__restrict vi = v + 3 * i, *__restrict xi = x + 3 * i, *__restrict fi = f + 3 * i;
    const double mass = rmass[i], scale = half / mass;
    for (int dim = 0; dim < 3; dim++) {
      const double kicked = scale * force[dim], speed = (vi[dim] + kicked) + kicked;
      vi[dim] = speed;
      xi[dim] += dt * speed;
      fi[dim] = mass * gravity[dim];
    }
    if (!twisted(i)) return;
    turn(i);
    turn(i);
    for (int dim = 0; dim < 3; dim++) torque[3 * i + dim] = 0.0;
  }

  // kick() or, JOIN, pass() for the grains of a FluidBlock from `first` on; add(e): the force to be added to number e of it
  template<bool JOIN, class Block, class Add>
  GRAINJET_IN_BOTH void move(int first, const Add &add) const
  {
    constexpr int N = Block::N;
    double *__restrict vs = v + 3 * first, *__restrict xs = x + 3 * first, *__restrict fs = f + 3 * first;
    double scale[Block::SIZE], scales[N], weights[N];
    for (int i = 0; i < Block::SIZE; i++) scale[i] = half / rmass[first + i];
    Block::spread(scale, scales);
    if (!JOIN)
      for (int e = 0; e < N; e++) {
        fs[e] += add(e);
        vs[e] += scales[e] * fs[e];
      }
    else {
      for (int i = 0; i < Block::SIZE; i++)
        for (int dim = 0; dim < 3; dim++) weights[3 * i + dim] = rmass[first + i] * gravity[dim];
      for (int e = 0; e < N; e++) {
        const double kicked = scales[e] * (fs[e] + add(e)), speed = (vs[e] + kicked) + kicked;
        vs[e] = speed;
        xs[e] += dt * speed;
        fs[e] = weights[e];
      }
    }
    double *twist = torque + 3 * first;
    if (Block::zero(twist)) return;
    for (int i = first; i < first + Block::SIZE; i++) {
      turn(i);
      if (JOIN) turn(i);
    }
    if (JOIN) for (int e = 0; e < N; e++) twist[e] = 0.0;
  }

  // Free grains have no torque: their spin is not even read
  bool twisted(int i) const
  {
    const double *t = torque + 3 * i;
    return t[0] != 0.0 || t[1] != 0.0 || t[2] != 0.0;
  }

  void turn(int i) const
  {
    if (!twisted(i)) return;
    const int k = 3 * i;
    const double scale = halfOverInertia / (radius[i] * radius[i] * rmass[i]);
    omega[k] += scale * torque[k];
    omega[k + 1] += scale * torque[k + 1];
    omega[k + 2] += scale * torque[k + 2];
  }

  void drift(int i) const
  {
    const int k = 3 * i;
    x[k] += dt * v[k];
    x[k + 1] += dt * v[k + 1];
    x[k + 2] += dt * v[k + 2];
  }

  // What the step's forces are added to: weight, no torque
  void clear(int i) const
  {
    const double mass = moves(i) ? rmass[i] : 0.0;
    for (int dim = 0; dim < 3; dim++) f[3 * i + dim] = mass * gravity[dim];
    if (twisted(i))
      for (int dim = 0; dim < 3; dim++) torque[3 * i + dim] = 0.0;
  }

  // the first half of a step
  void begin(int i) const
  {
    if (moves(i)) {
      kick(i);
      drift(i);
    }
    clear(i);
  }

  // The second half, and if they are joined the first one of the next step. JOIN: join, known to the compiler
  template<bool JOIN>
  void end(int i) const
  {
    if (JOIN && held->holds(i)) {
      late->push_back(i);
      if (moves(i)) kick(i);
    } else if (JOIN) {
      if (moves(i)) pass(i);
      else clear(i);
    } else if (moves(i)) kick(i);
  }

  // end() of all grains; joined, of many at once
  template<bool JOIN>
  void end_all() const
  {
    if (grainjet::has_avx2()) end_avx2<JOIN>();
    else end_loop<JOIN>();
  }

  template<bool JOIN>
  GRAINJET_AVX2 void end_avx2() const { end_loop<JOIN>(); }

  template<bool JOIN>
  GRAINJET_IN_BOTH void end_loop() const
  {
    typedef FluidBlock<false> Block;
    const GrainStep grains = *this;    // a copy: stays in registers
    for (int first = 0; first < grains.n; first += Block::SIZE) {
      if (JOIN && Block::may_be_taken(first, grains.n, grains.mask, grains.groupbit, *grains.held)) {
        grains.move<JOIN, Block>(first, [](int) { return -0.0; });    // adding it changes nothing, not even a sign
        continue;
      }
      const int end = first + Block::SIZE < grains.n ? first + Block::SIZE : grains.n;
      for (int i = first; i < end; i++) grains.end<JOIN>(i);
    }
  }
};

/* What fix fluid/force hands to fix grain/motion, by extract("fluid_force_motion"). Both are of
   one version ("fluid_force_version"). */
struct FluidMotion {
  void *fix;

  // can steps be joined in this run? Not with torque of the fluid, nor if its work is asked for
  bool (*joins)(void *fix);

  // The fluid's force of this step, and with it GrainStep::end() of all grains of the rank
  void (*move)(void *fix, const GrainStep &);
};

}

#endif
