/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* The loops of fix fluid/force over the grains, once per DEM step. */

#include "fix_fluid_force.h"

#include "grain-motion/grain_step.h"
#include "physics/drag/exponential_drag.h"

#include "atom.h"
#include "fix_property_atom.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using grainjet::drag::ExponentialDrag;

/* ----------------------------------------------------------------------
   Forces. Returns whether one is no number or far too large.

   The drag of both kinds is integrated as one, since each would change the velocity that the
   other sees. With forces of one kind only, nothing at all is booked for the other.

   With an added mass m_a, M = m + m_a, the kick is that of M dv/dt = R + W + f: R and W the
   fluid's other forces with and without reaction, f all other forces. The integrator divides
   by m, so what is added to f is m dv/dt - f = (m/M)(R + W) - (m_a/M) f. This is all that the
   fluid gives to the grain, R + W - m_a dv/dt; the reaction is to all of it but W.
------------------------------------------------------------------------- */

template<bool UNIFORM, bool NON_REACTING, bool ADDED_MASS>
struct FixFluidForce::Push {

  const Booking book;
  const double kick, half;
  const UniformFlow *uniform;
  const HeldGrains &held;
  double buoyancy[3];

  // The loop is bound by memory. LIGGGHTS' arrays of vectors are one block each, so their
  // rows need not be looked up.
  const double *velocities, *fluids, *explicits, *rmass, *radius;
  const double *nonReactingCoefficient, *nonReactingForces, *addedMasses;
  double *forces, *coefficient, *allApplied, *impulses, *nonReactingAll, *nonReactingImpulses;

  Push(const FixFluidForce &fix, double k, const Booking &b) :
    book(b), kick(k), half(0.5 * fix.update->dt), uniform(fix.uniform_.get()), held(fix.held_)
  {
    const Atom *atom = fix.atom;
    if (UNIFORM) uniform->buoyancy(buoyancy);
    velocities = atom->v[0];
    forces = atom->f[0];
    rmass = atom->rmass;
    radius = atom->radius;
    fluids = UNIFORM ? NULL : fix.fluidVelocity_->array_atom[0];
    explicits = UNIFORM ? NULL : fix.explicitForce_->array_atom[0];
    coefficient = fix.dragCoefficient_->vector_atom;
    allApplied = fix.fluidForce_->array_atom[0];
    impulses = fix.impulse_->array_atom[0];
    nonReactingCoefficient = NON_REACTING ? fix.nonReactingCoefficient_->vector_atom : NULL;
    nonReactingForces = NON_REACTING ? fix.nonReactingForce_->array_atom[0] : NULL;
    nonReactingAll = NON_REACTING ? fix.nonReactingApplied_->array_atom[0] : NULL;
    nonReactingImpulses = NON_REACTING ? fix.nonReactingImpulse_->array_atom[0] : NULL;
    addedMasses = ADDED_MASS && !UNIFORM ? fix.addedMass_->vector_atom : NULL;
  }

  // nothing for a grain that fix insert/stream holds
  void none(int i) const
  {
    double *applied = allApplied + 3 * i;
    applied[0] = applied[1] = applied[2] = 0.0;
    if (!NON_REACTING) return;
    double *without = nonReactingAll + 3 * i;
    without[0] = without[1] = without[2] = 0.0;
  }

  // f: the other forces on grain i, to which the fluid's is added. Nothing is stored before all is loaded that
  // is needed: the compiler has to take every store for a change of what it loads next.
  bool operator()(int i, double *f) const
  {
    const int first = 3 * i;
    double *applied = allApplied + first;
    double *nonReactingApplied = NON_REACTING ? nonReactingAll + first : NULL;
    const double *v = velocities + first;
    const double *fluid = UNIFORM ? uniform->velocity() : fluids + first;
    const double *nonReacting = NON_REACTING ? nonReactingForces + first : NULL;

    const double volume = UNIFORM ? UniformFlow::volume(radius[i]) : 0.0;
    const double mass = rmass[i];
    const double addedMass = !ADDED_MASS ? 0.0 : UNIFORM ? uniform->addedMass(volume) : addedMasses[i];
    const double inertia = ADDED_MASS ? mass + addedMass : mass;
    const double own = mass / inertia, takenUp = addedMass / inertia;
    double given[3], other[3];
    for (int dim = 0; dim < 3; dim++) {
      if (book.remove) f[dim] -= applied[dim];
      given[dim] = UNIFORM ? buoyancy[dim] * volume : explicits[first + dim];
      other[dim] = f[dim] + (NON_REACTING ? given[dim] + nonReacting[dim] : given[dim]);
    }
    if (UNIFORM && uniform->magnus()) {
      double lift[3];
      uniform->lift(i, other, kick, book.step ? coefficient[i] : 0.0, inertia, lift);
      for (int dim = 0; dim < 3; dim++) {
        given[dim] += lift[dim];
        other[dim] += lift[dim];
      }
    }
    if (UNIFORM)
      coefficient[i] =
        uniform->dragCoefficient(i, other, kick, book.step ? coefficient[i] : 0.0, inertia);

    // One drag, shared out by the coefficients of the two kinds of force
    const double c = NON_REACTING ? nonReactingCoefficient[i] : 0.0, b = coefficient[i] + c;
    const ExponentialDrag drag(b, kick, inertia);
    const double share = NON_REACTING && c > 0.0 ? c / b : 0.0;
    const double slip = NON_REACTING ? (1.0 - share) * drag.slip : drag.slip;
    const double taken = NON_REACTING ? (1.0 - share) * drag.other : drag.other;
    const double slipWithout = share * drag.slip, takenWithout = share * drag.other;

    bool wrong = false;
    double reacting[3], alone[3], all[3];
    for (int dim = 0; dim < 3; dim++) {
      const double speed = fluid[dim] - v[dim];
      double force = given[dim] + slip * speed - taken * other[dim];
      const double without = NON_REACTING ? nonReacting[dim] + slipWithout * speed - takenWithout * other[dim] : 0.0;
      if (ADDED_MASS) force = own * force - takenUp * (NON_REACTING ? without + f[dim] : f[dim]);
      reacting[dim] = force;
      alone[dim] = without;
      all[dim] = NON_REACTING ? force + without : force;
      // also if it is no number
      wrong |= !((NON_REACTING ? std::fabs(force) + std::fabs(without) : std::fabs(force)) <= LARGEST);
    }

    if (book.step) {    // the forces of the former step, too, each kind its own
      add(impulses + first, applied, nonReactingApplied, reacting);
      if (NON_REACTING) add(nonReactingImpulses + first, nonReactingApplied, NULL, alone);
    }
    for (int dim = 0; dim < 3; dim++) f[dim] += all[dim];
    if (book.after && !wrong) return false;
    for (int dim = 0; dim < 3; dim++) {
      applied[dim] = all[dim];
      if (NON_REACTING) nonReactingApplied[dim] = alone[dim];
    }
    return wrong;
  }

  // Can a block of grains from this one on be taken at once?
  template<class Block>
  GRAINJET_IN_BOTH bool whole(int first, int n, const int *mask, int groupbit) const
  {
    return !UNIFORM && !ADDED_MASS && book.step && !book.remove && Block::may_be_taken(first, n, mask, groupbit, held);
  }

  // operator() for such a block: its forces are booked, but not added to the others yet. Returns false with nothing
  // booked if one is no number or far too large.
  template<class Block>
  GRAINJET_IN_BOTH bool take(int i, Block &block) const
  {
    const int first = 3 * i;
    const typename Block::Fluid fluid = {fluids + first, explicits + first, coefficient + i,
      NON_REACTING ? nonReactingForces + first : NULL, NON_REACTING ? nonReactingCoefficient + i : NULL};
    if (!block.work_out(fluid, velocities + first, forces + first, rmass + i, kick, LARGEST)) return false;

    double *applied = allApplied + first, *alone = NON_REACTING ? nonReactingAll + first : NULL;
    Block::book(impulses + first, block.force, half, book.after, book.before ? applied : NULL, alone);
    if (NON_REACTING)
      Block::book(nonReactingImpulses + first, block.without, half, book.after, book.before ? alone : NULL, NULL);
    if (book.after) return true;
    for (int e = 0; e < Block::N; e++) applied[e] = block.all(e);
    if (NON_REACTING)
      for (int e = 0; e < Block::N; e++) alone[e] = block.without[e];
    return true;
  }

  // former: forces of the former step, less those in `less`
  void add(double *impulse, const double *former, const double *less, const double *force) const
  {
    double sum[3];
    if (book.before)
      for (int dim = 0; dim < 3; dim++)
        sum[dim] = (less ? former[dim] - less[dim] : former[dim]) + (book.after ? 2.0 * force[dim] : force[dim]);
    else
      for (int dim = 0; dim < 3; dim++) sum[dim] = book.after ? 2.0 * force[dim] : force[dim];
    for (int dim = 0; dim < 3; dim++) sum[dim] = impulse[dim] + half * sum[dim];
    for (int dim = 0; dim < 3; dim++) impulse[dim] = sum[dim];
  }
};

/* ---------------------------------------------------------------------- */

template<bool UNIFORM, bool NON_REACTING, bool ADDED_MASS>
GRAINJET_IN_BOTH inline bool FixFluidForce::push_loop(double kick, const Booking &book)
{
  typedef FluidBlock<NON_REACTING> Block;
  const Push<UNIFORM, NON_REACTING, ADDED_MASS> push(*this, kick, book);
  const int nlocal = atom->nlocal;
  Block block;
  bool wrong = false;
  for (int first = 0; first < nlocal; first += Block::SIZE) {
    if (push.template whole<Block>(first, nlocal, atom->mask, groupbit) && push.take(first, block)) {
      double *f = push.forces + 3 * first;
      for (int e = 0; e < Block::N; e++) f[e] += block.all(e);
      continue;
    }
    for (int i = first; i < std::min(first + Block::SIZE, nlocal); i++) {
      if (!(atom->mask[i] & groupbit)) continue;
      if (held_.holds(i)) {
        push.none(i);
        continue;
      }
      double *f = push.forces + 3 * i, sum[3] = {f[0], f[1], f[2]};
      wrong |= push(i, sum);
      for (int dim = 0; dim < 3; dim++) f[dim] = sum[dim];
    }
  }
  return wrong;
}

/* ----------------------------------------------------------------------
   The same loop for fix grain/motion, which moves each grain while its numbers are at hand. A wrong
   force ends the run before the grain has it.
------------------------------------------------------------------------- */

template<bool UNIFORM, bool NON_REACTING, bool ADDED_MASS, bool JOIN>
GRAINJET_IN_BOTH inline bool FixFluidForce::move_loop(const GrainStep &given, const Booking &book)
{
  typedef FluidBlock<NON_REACTING> Block;
  const Push<UNIFORM, NON_REACTING, ADDED_MASS> push(*this, given.dt, book);
  const GrainStep grains = given;    // a copy: stays in registers
  Block block;
  bool wrong = false;
  for (int first = 0; first < grains.n; first += Block::SIZE) {
    if (push.template whole<Block>(first, grains.n, grains.mask, grains.groupbit) && push.take(first, block)) {
      grains.move<JOIN, Block>(first, [&block](int e) { return block.all(e); });
      continue;
    }
    for (int i = first; i < std::min(first + Block::SIZE, grains.n); i++) {
      const bool held = held_.holds(i);
      if (!grains.moves(i) || held) {
        if (held && grains.moves(i)) push.none(i);
        grains.end<JOIN>(i);
        continue;
      }
      double *f = push.forces + 3 * i, sum[3] = {f[0], f[1], f[2]};
      if (push(i, sum)) wrong = true;
      else if (JOIN) grains.pass(i, sum);
      else {
        for (int dim = 0; dim < 3; dim++) f[dim] = sum[dim];
        grains.kick(i);
      }
    }
  }
  return wrong;
}

// The loops for any processor and for those with AVX2

template<bool U, bool N, bool A>
bool FixFluidForce::push(double kick, const Booking &book)
{
  return push_loop<U, N, A>(kick, book);
}

template<bool U, bool N, bool A>
GRAINJET_AVX2 bool FixFluidForce::push_avx2(double kick, const Booking &book)
{
  return push_loop<U, N, A>(kick, book);
}

template<bool U, bool N, bool A, bool JOIN>
bool FixFluidForce::push_and_move(const GrainStep &grains, const Booking &book)
{
  return move_loop<U, N, A, JOIN>(grains, book);
}

template<bool U, bool N, bool A, bool JOIN>
GRAINJET_AVX2 bool FixFluidForce::push_and_move_avx2(const GrainStep &grains, const Booking &book)
{
  return move_loop<U, N, A, JOIN>(grains, book);
}

/* ---------------------------------------------------------------------- */

template<typename Call>
bool FixFluidForce::choose(const Call &call)
{
  if (uniform_ && uniform_->hasAddedMass()) return call(Kind<true, false, true>());
  if (uniform_) return call(Kind<true, false, false>());
  if (addedMass_)
    return nonReactingForce_ ? call(Kind<false, true, true>()) : call(Kind<false, false, true>());
  return nonReactingForce_ ? call(Kind<false, true, false>()) : call(Kind<false, false, false>());
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::apply(double kick, bool remove, bool book)
{
  sumStep_ = -1;    // on all ranks alike, also on one without grains
  if (atom->nlocal == 0) return;

  const bool work = books_work();
  if (work && book) book_work_before();
  const Booking booking = {book, remove, true, false};
  if (choose([&](auto kind) { return push_of(kind, kick, booking); })) refuse_force();
  if (work) book_work_after(book);
  if (!fluidTorque_) return;
  const bool wrong = uniform_ ? turn<true>(kick, remove)
    : grainjet::has_avx2() ? turn_avx2(kick, remove) : turn<false>(kick, remove);
  if (wrong) refuse_torque();
}

/* ----------------------------------------------------------------------
   With torque or work there is more than one loop: fix grain/motion has one of its own then
------------------------------------------------------------------------- */

bool FixFluidForce::joins() const
{
  return !fluidTorque_ && !books_work();
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::move(const GrainStep &grains)
{
  held_.update(update->ntimestep);
  if (!joins()) {
    apply(update->dt, false, true);
    grains.end_all<false>();
    return;
  }

  sumStep_ = -1;
  const Booking booking = {true, false, !bookedAhead_, grains.join};
  bookedAhead_ = grains.join;    // on all ranks alike
  if (atom->nlocal == 0) return;
  if (choose([&](auto kind) { return move_of(kind, grains, booking); })) refuse_force();
}

/* ---------------------------------------------------------------------- */

const double *FixFluidForce::fluid_velocity(int i) const
{
  return coupled_ ? fluidVelocity_->array_atom[i] : uniform_->velocity();
}
