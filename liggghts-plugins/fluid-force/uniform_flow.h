/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_UNIFORM_FLOW_H
#define GRAINJET_UNIFORM_FLOW_H

#include "pointers.h"

#include "physics/drag/drag_state.h"

namespace grainjet { class FixArguments; }

namespace LAMMPS_NS {

/* The given flow of fix fluid/force uniform, and what it does to a grain:

     uniform ux uy uz density rho viscosity nu [drag name] [buoyancy yes|no]
       [rotation yes|no] [addedMass C]                                              */
class UniformFlow : protected Pointers {
 public:

  // reads what follows the word `uniform`
  UniformFlow(class LAMMPS *, grainjet::FixArguments &);

  // start of a run: finds the gravity for the buoyancy
  void init();

  const double *velocity() const { return velocity_; }    // m/s
  bool rotation() const { return rotation_; }

  // buoyancy per volume (N/m3), -density times gravity; 0 with buoyancy no
  void buoyancy(double *) const;

  // Drag coefficient (kg/s) of grain i over a kick (s) under another force (N), by the
  // drag law with the original particle's diameter and the grain's volume. Taken at the
  // mean of the slip before the kick and an estimate of the slip after it: second order
  // in time, and for a long time step it converges to the terminal velocity where the
  // slip before the kick alone would make it oscillate. The estimate uses the coefficient
  // of the step before, which is exact enough while the drag is slow against the kick,
  // or else, and where there is none (0), one more evaluation of the law. inertia: mass of the
  // grain with its added mass (kg).
  double dragCoefficient(int i, const double *other, double kick, double before,
    double inertia) const;

  // Added mass (kg) C density volume of a grain. The flow is steady and uniform, so the fluid
  // itself does not accelerate
  double addedMass(double volume) const { return addedMass_ * density_ * volume; }
  bool hasAddedMass() const { return addedMass_ > 0.0; }

  // Torque per angular velocity (kg m2/s) of a sphere that spins in fluid at rest,
  // pi mu d^3 (Stokes; Happel & Brenner 1983, section 5-3). A grain's spin decays at the
  // rate of its particles', so that their rotational energies stay equal: 6 mu f_cg^2 V.
  double spinCoefficient(int i) const;

  static double volume(double radius);

 private:

  double velocity_[3];
  double density_;                  // kg/m3
  double viscosity_;                // m2/s, kinematic
  grainjet::drag::Law law_;
  bool buoyancy_, rotation_;
  double addedMass_;                // coefficient C, -; 0 without
  class FixGravity *gravity_;
};

}

#endif
