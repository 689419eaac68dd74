/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef LMP_FIX_EXCHANGE_PROBE_H
#define LMP_FIX_EXCHANGE_PROBE_H

#include "fix.h"

namespace LAMMPS_NS {

/* Plays the coupling for the tests of fix fluid/force coupled:

     fix ID all exchange/probe N ux shear b fx

   Every N steps it takes the impulses through the exchange header, and then writes the
   fluid velocity (ux + shear y, 0, 0), the drag coefficient b and the explicit force
   (fx, 0, 0). Global vector:
     1-3 impulse taken since the start, of present and removed grains
     4   removed grains      5-7 their momentum      8 their mass
     9   grains without owner at the last exchange (new ones)
    10   largest distance from the start position at the last exchange
    11   largest distance between end and start position of a removed grain            */
class FixExchangeProbe : public Fix {
 public:

  FixExchangeProbe(class LAMMPS *, int, char **);
  int setmask();
  void init();
  void end_of_step();
  double compute_vector(int);

 private:

  static const int SUMS = 9, SIZE = 11;

  double wind_, shear_, coefficient_, explicit_;
  class Fix *fluid_;
  double mine_[SIZE];
};

}

#endif
