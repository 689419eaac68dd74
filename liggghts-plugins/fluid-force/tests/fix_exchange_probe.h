/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef LMP_FIX_EXCHANGE_PROBE_H
#define LMP_FIX_EXCHANGE_PROBE_H

#include "fix.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

/* Plays the coupling for the tests of fix fluid/force coupled:

     fix ID all exchange/probe N ux shear b fx [nonReacting c fz] [torque C spin T]
       [addedMass m] [work] [heat T H] [state name size] ...

   Every N steps it takes the impulses through the exchange header, and then writes the fluid
   velocity (ux + shear y, 0, 0), the drag coefficient b and the explicit force (fx, 0, 0).
     nonReacting  requests forces without reaction: coefficient c, force (0, 0, fz)
     torque       requests torque: coefficient C, spin of the fluid (0, 0, spin), torque (0, 0, T)
     addedMass    requests added mass, m on every grain
     work         requests the work of forces with reaction
     heat         plays the coupling of fix fluid/heat as well: fluid of T (K), coefficient H (W/K)
     state        adds a state of `size` numbers, which begin with 0.25, 1.25, ...; every
                  exchange adds vx to the first, 2 vx to the second, ...
   Global vector:
     1-3   impulse with reaction taken since the start, of present and removed grains
     4     removed grains      5-7 their momentum      8 their mass
     9     grains without owner at the last exchange (new ones)
     10-12 impulse without reaction, as 1-3
     13    removed grains that were deleted by a fix massflow/mesh
     14    new grains whose state was not the initial one, since the start
     15    largest distance from the start position at the last exchange
     16    largest distance between end and start position of a removed grain
     17    work of forces with reaction, as 1-3          18    kinetic energy of removed grains
     19    heat of grains, as 1-3                        20    thermal energy m c T of removed grains,
           with the specific heat of type 1 (J)                                                  */
class FixExchangeProbe : public Fix {
 public:

  FixExchangeProbe(class LAMMPS *, int, char **);
  int setmask() override;
  void post_create() override;
  void init() override;
  void end_of_step() override;
  double compute_vector(int) override;

 private:

  enum { IMPULSE, REMOVED = 3, MOMENTUM, MASS = 7, NEW, NON_REACTING, DELETED = 12, WRONG_STATE,
         SUMS, FAR = SUMS, FATE, WORK, ENERGY, HEAT, THERMAL, SIZE };

  struct State { std::string name; int size, index; };

  double wind_, shear_, coefficient_, explicit_;
  bool nonReacting_, torque_, work_;
  double nonReactingCoefficient_, nonReactingForce_;
  double spinCoefficient_, spin_, explicitTorque_;
  double addedMass_;
  bool heat_;
  double temperature_, heatCoefficient_;
  std::vector<State> states_;
  class Fix *fluid_, *heating_;
  double mine_[SIZE];

  struct FluidForceExchange *exchange();
  struct FluidHeatExchange *heat_exchange();
  void take_removed();
  void advance_states();
  void exchange_heat();
};

}

#endif
