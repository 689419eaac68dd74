/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_UNIFORM_GAS_H
#define GRAINJET_UNIFORM_GAS_H

#include "pointers.h"

#include "physics/heat/nusselt.h"

namespace grainjet { class FixArguments; }

namespace LAMMPS_NS {

/* The given fluid of fix fluid/heat uniform, and what it does to a grain:

     uniform T rho nu cp Pr [velocity ux uy uz] [nusselt name] [recovery yes|no] [temperature T0]

   Its velocity is that of a fix fluid/force uniform, if the script has one.                */
class UniformGas : protected Pointers {
 public:

  // reads what follows the word `uniform`
  UniformGas(class LAMMPS *, grainjet::FixArguments &);

  // start of a run: takes the velocity of fix fluid/force. fix: named in messages
  void init(const class Fix *fix);

  double temperature() const { return temperature_; }    // K, of the fluid

  // K, of the grains at the start, keyword temperature; NAN: not given
  double grainTemperature() const { return grainTemperature_; }

  // Heat transfer coefficient H (W/K) of grain i, and the temperature (K) at which it would exchange
  // no heat. velocity: of the grain (m/s)
  double exchange(int i, const double *velocity, double &temperature) const;

 private:

  double temperature_;         // K
  double density_;             // kg/m3
  double viscosity_;           // m2/s, kinematic
  double specificHeat_;        // J/(kg K), at constant pressure
  double prandtl_;             // -
  double conductivity_;        // W/(m K), rho nu cp/Pr
  double given_[3];            // m/s, keyword velocity
  double velocity_[3];         // m/s, in use
  bool velocityGiven_, recovery_;
  double grainTemperature_;
  grainjet::heat::NusseltLaw law_;
};

}

#endif
