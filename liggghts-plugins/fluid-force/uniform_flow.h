/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_UNIFORM_FLOW_H
#define GRAINJET_UNIFORM_FLOW_H

#include "pointers.h"

#include "physics/drag/drag_state.h"

#include <functional>
#include <string>

namespace grainjet { class FixArguments; }

namespace LAMMPS_NS {

/* The given flow of fix fluid/force uniform, and what it does to a grain:

     uniform ux uy uz density rho viscosity nu [drag name [sphericity phi]]
       [buoyancy yes|no] [rotation yes|no] [magnus yes|no] [addedMass C]

   A uniform flow has no vorticity: it does not turn grains, and has no lift by shear.     */
class UniformFlow : protected Pointers {
 public:

  // reads what follows the word `uniform`
  UniformFlow(class LAMMPS *, grainjet::FixArguments &);

  // start of a run: finds the gravity for the buoyancy
  void init();

  const double *velocity() const { return velocity_; }    // m/s
  double density() const { return density_; }
  double viscosity() const { return viscosity_; }
  bool rotation() const { return rotation_; }
  bool magnus() const { return magnus_; }

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

  // Torque per angular velocity (kg m2/s) of grain i over a kick (s), pi mu d^3 times the factor of fast
  // spin (physics/lift/spin_torque.h), the mean over the decay within the kick. A grain's spin
  // decays at the rate of its particles', so that their rotational energies stay equal:
  // 6 mu f_cg^2 V for slow spin.
  double spinCoefficient(int i, double kick) const;

  // Magnus' lift (N) on grain i over a kick under another force (N), by the spin and diameter of its
  // particles (physics/lift/magnus.h), at the mean slip and spin of the kick
  // (physics/lift/mean_lift.h). before: as for dragCoefficient(). mass: what drag and lift
  // accelerate (kg)
  void lift(int i, const double *other, double kick, double before, double mass, double *result) const;

  static double volume(double radius);

 private:

  double velocity_[3];
  double density_;                  // kg/m3
  double viscosity_;                // m2/s, kinematic
  std::function<double(const grainjet::drag::State &)> law_;
  bool buoyancy_, rotation_, magnus_;
  double addedMass_;                // coefficient C, -; 0 without
  class FixGravity *gravity_;
  const double *given_;             // m/s2, by fix grain/motion

  void set_law(grainjet::FixArguments &, const std::string &name, double sphericity);
  double spinReynolds(int i) const;    // |w| d^2/nu of the particles of grain i
};

}

#endif
