/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(fluid/force,FixFluidForce)

#else

#ifndef LMP_FIX_FLUID_FORCE_H
#define LMP_FIX_FLUID_FORCE_H

#include "fix.h"
#include "fluid_force_exchange.h"
#include "held_grains.h"
#include "lost_grains.h"
#include "running_state.h"
#include "uniform_flow.h"

#include <memory>

namespace LAMMPS_NS {

/* Force of a fluid on the grains: drag that follows the grain's current velocity every
   DEM step, plus an explicit force. User page: docs/fix_fluid_force.md.

     fix ID group fluid/force coupled
     fix ID group fluid/force uniform ux uy uz density rho viscosity nu
         [drag name] [buoyancy yes|no] [rotation yes|no]

   The drag acts last in the step, after all other forces are known, and is integrated
   exactly over the kick of velocity Verlet (physics/drag/exponential_drag.h). Half-step
   velocities are exact for constant other forces, whole-step velocities and positions
   of second order in dt/tau; stable for any drag coefficient.

   Per-grain state lives in stock fix property/atom instances of these names, so that it
   migrates, is sorted, restarted and dumped (f_fluidForce[1] ...) by LIGGGHTS itself:
     fluidVelocity[3] fluidDragCoefficient fluidExplicitForce[3] fluidImpulse[3]
     fluidForce[3] fluidStartPosition[3] fluidHost[2]
   A restart file from the middle of a run of style coupled holds what the next run needs to go on
   as if that had not stopped: running_state.h.
   (uniform has fluidDragCoefficient, fluidImpulse, fluidForce, and with rotation yes
   fluidTorque[3]). Meaning and units: fluid_force_exchange.h.

   Global vector: 1-3 total fluid force (N), 4 mean slip speed (m/s) of the grains
   that have a drag coefficient.                                                     */
class FixFluidForce : public Fix {
 public:

  FixFluidForce(class LAMMPS *, int, char **);
  ~FixFluidForce();

  int setmask();
  void post_create();
  void pre_delete(bool);
  void init();
  void setup(int);
  void setup_pre_exchange();
  void setup_pre_neighbor();
  void setup_pre_force(int);
  void pre_initial_integrate();
  void pre_exchange();
  void pre_neighbor();
  void pre_final_integrate();
  void set_arrays(int);
  double compute_vector(int);
  int min_type();

  void grow_arrays(int);
  void copy_arrays(int, int, int);
  int pack_exchange(int, double *);
  int unpack_exchange(int, double *);

  void write_restart(FILE *);
  void write_restart_file(char *);
  void restart(char *);
  int pack_restart(int, double *);
  void unpack_restart(int, int);
  int size_restart(int);
  int maxsize_restart();

  // "fluid_force_exchange": FluidForceExchange *, or NULL if not in style coupled
  // "fluid_force_version": const char *, the version of Grainjet that layout belongs to
  void *extract(const char *, int &);

 private:

  bool coupled_;
  std::unique_ptr<UniformFlow> uniform_;    // NULL in style coupled

  // ---- per-grain state; those of the exchange are NULL in style uniform

  class FixPropertyAtom *fluidVelocity_, *dragCoefficient_, *explicitForce_;
  class FixPropertyAtom *impulse_, *fluidForce_, *startPosition_, *host_;
  class FixPropertyAtom *fluidTorque_;    // rotation yes only

  // ---- style coupled

  FluidForceExchange exchange_;
  LostGrains lost_;
  bool doorOpen_;                   // a coupling has asked for the exchange: book losses
  RunningState running_;

  HeldGrains held_;
  bool freshSetup_;                 // forces of the set-up not yet used for a kick
  bigint sumStep_;                  // step of sums_, -1: none
  double sums_[5];                  // force, sum of slip speeds, number of those

  void parse(int, char **);
  class FixPropertyAtom *property(const char *, int, const char *);
  void check_other_fixes();

  void refresh_exchange();
  void apply(double kick, bool remove, bool book);
  const double *fluid_velocity(int) const;
  void rotational_drag(double kick, bool remove);
  void sum();
  void refuse_force();

  static constexpr double LARGEST_FORCE = 1e30;    // N, on a grain

  static void clear_lost(FluidForceExchange *);
};

}

#endif
#endif
