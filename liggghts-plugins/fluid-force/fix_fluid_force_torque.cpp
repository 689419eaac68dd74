/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Torque of the fluid on the grains, once per DEM step. */

#include "fix_fluid_force.h"

#include "physics/drag/exponential_drag.h"

#include "atom.h"
#include "fix_property_atom.h"

#include <cmath>

using namespace LAMMPS_NS;
using grainjet::drag::ExponentialDrag;

/* ----------------------------------------------------------------------
   Torque of a block of grains from this one on: the same as drag, of spin. Returns false with nothing done if
   they cannot be taken at once, or if a torque is no number or far too large.
------------------------------------------------------------------------- */

GRAINJET_IN_BOTH inline bool FixFluidForce::turn_block(int i, double kick, FluidBlock<false> &block)
{
  constexpr int SIZE = FluidBlock<false>::SIZE, N = FluidBlock<false>::N;
  if (!block.may_be_taken(i, atom->nlocal, atom->mask, groupbit, held_)) return false;
  double inertia[SIZE];
  for (int k = 0; k < SIZE; k++) inertia[k] = 0.4 * atom->rmass[i + k] * atom->radius[i + k] * atom->radius[i + k];
  double *torque = atom->torque[i], *applied = fluidTorque_->array_atom[i];
  const FluidBlock<false>::Fluid fluid = {fluidSpin_->array_atom[i], explicitTorque_->array_atom[i],
    spinCoefficient_->vector_atom + i, NULL, NULL};
  if (!block.work_out(fluid, atom->omega[i], torque, inertia, kick, LARGEST)) return false;
  for (int e = 0; e < N; e++) {
    applied[e] = block.force[e];
    torque[e] += block.force[e];
  }
  return true;
}

/* ----------------------------------------------------------------------
   Torque. Returns whether one is no number or far too large. The fluid of style uniform is at
   rest as far as spin goes.
------------------------------------------------------------------------- */

template<bool UNIFORM>
GRAINJET_IN_BOTH inline bool FixFluidForce::turn_loop(double kick, bool remove)
{
  const int nlocal = atom->nlocal;
  const double *omegas = atom->omega[0];
  double *torques = atom->torque[0], *turned = fluidTorque_->array_atom[0];
  const double *spins = UNIFORM ? NULL : fluidSpin_->array_atom[0];
  const double *explicits = UNIFORM ? NULL : explicitTorque_->array_atom[0];
  bool wrong = false;

  FluidBlock<false> block;
  for (int i = 0; i < nlocal; i++) {
    if (!UNIFORM && !remove && i % block.SIZE == 0 && turn_block(i, kick, block)) {
      i += block.SIZE - 1;
      continue;
    }
    if (!(atom->mask[i] & groupbit)) continue;
    const int first = 3 * i;
    double *torque = torques + first, *applied = turned + first;
    if (held_.holds(i)) {
      applied[0] = applied[1] = applied[2] = 0.0;
      continue;
    }
    const double *omega = omegas + first;
    const double inertia = 0.4 * atom->rmass[i] * atom->radius[i] * atom->radius[i];
    const ExponentialDrag drag(UNIFORM ? uniform_->spinCoefficient(i, kick) : spinCoefficient_->vector_atom[i],
      kick, inertia);

    for (int dim = 0; dim < 3; dim++) {
      if (remove) torque[dim] -= applied[dim];
      const double given = UNIFORM ? 0.0 : explicits[first + dim];
      const double spin = UNIFORM ? 0.0 : spins[first + dim];
      const double all = UNIFORM ? -drag.slip * omega[dim] - drag.other * torque[dim]
        : given + drag.slip * (spin - omega[dim]) - drag.other * (torque[dim] + given);
      if (!UNIFORM) wrong |= !(std::fabs(all) <= LARGEST);    // also if it is no number
      applied[dim] = all;
      torque[dim] += all;
    }
  }
  return wrong;
}

template<bool UNIFORM>
bool FixFluidForce::turn(double kick, bool remove)
{
  return turn_loop<UNIFORM>(kick, remove);
}

GRAINJET_AVX2 bool FixFluidForce::turn_avx2(double kick, bool remove)
{
  return turn_loop<false>(kick, remove);
}

template bool FixFluidForce::turn<true>(double, bool);
template bool FixFluidForce::turn<false>(double, bool);
