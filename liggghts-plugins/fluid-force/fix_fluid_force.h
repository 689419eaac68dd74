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
#include "fluid_block.h"
#include "fluid_force_exchange.h"
#include "grain-motion/grain_step.h"
#include "grain_properties.h"
#include "held_grains.h"
#include "removed_grains.h"
#include "running_state.h"
#include "uniform_flow.h"

#include <memory>

namespace LAMMPS_NS {

/* Forces and torque of a fluid on the grains: drag that follows the grain's current velocity
   every DEM step, and explicit forces. User page: docs/fix_fluid_force.md.

     fix ID group fluid/force coupled
     fix ID group fluid/force uniform ux uy uz density rho viscosity nu
         [drag name [sphericity phi]] [buoyancy yes|no] [rotation yes|no] [magnus yes|no]
         [addedMass C]

   The drag acts last in the step, after all other forces are known, and is integrated
   exactly over the kick of velocity Verlet (physics/drag/exponential_drag.h). Half-step
   velocities are exact for constant other forces, whole-step velocities and positions
   of second order in dt/tau; stable for any drag coefficient.

   An added mass m_a makes the grain accelerate as if its mass were m + m_a, while the integrator
   knows m: all other forces are scaled by m/(m + m_a). Stable for any m_a/m.

   Per-grain values lie in stock fix property/atom instances (grain_properties.h), so that
   LIGGGHTS itself moves, sorts, restarts and dumps them (f_fluidForce[1] ...):
     fluidDragCoefficient fluidImpulse[3] fluidForce[3]                  both styles
     fluidVelocity[3] fluidExplicitForce[3] fluidStartPosition[3] fluidOwner[3]    coupled
     fluidNonReactingCoefficient fluidNonReactingForce[3] fluidNonReactingImpulse[3]
       fluidNonReactingApplied[3]      coupled, if the coupling asks for it (useNonReacting)
     fluidSpin[3] fluidSpinCoefficient fluidExplicitTorque[3]       the same with useTorque
     fluidTorque[3]                         coupled with useTorque, uniform with rotation yes
     fluidAddedMass                         coupled with useAddedMass
     fluidWork fluidPowerGrowth                                     the same with useWork
     fluidState_<name>                                                     the same, addState
   fluidNonReactingApplied: forces without reaction of the latest step, N. fluidPowerGrowth: forces with
   reaction of the latest step times the acceleration by all forces, W/s. Meaning and units of the
   others: fluid_force_exchange.h.

   A restart file from the middle of a run of style coupled holds what the next run needs to go on
   as if that had not stopped: running_state.h. What a coupling had asked for comes back with
   it; if the next coupling does not ask for it, those forces are 0 from its first run on.

   Global vector: 1-3 total fluid force (N), 4 mean slip speed (m/s) of the grains
   that have a drag coefficient.                                                     */
class FixFluidForce : public Fix {
 public:

  FixFluidForce(class LAMMPS *, int, char **);
  ~FixFluidForce();

  int setmask() override;
  void post_create() override;
  void pre_delete(bool) override;
  void init() override;
  void setup(int) override;
  void setup_pre_exchange() override;
  void setup_pre_neighbor() override;
  void setup_pre_force(int) override;
  void pre_initial_integrate() override;
  void pre_exchange() override;
  void pre_neighbor() override;
  void pre_final_integrate() override;
  void set_arrays(int) override;
  double compute_vector(int) override;
  int min_type() override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;

  void write_restart(FILE *) override;
  void write_restart_file(char *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

  // "fluid_force_exchange": FluidForceExchange *, or NULL if not in style coupled
  // "fluid_force_version": const char *, the version of Grainjet that layout belongs to
  // "fluid_force_uniform": const UniformFluid *, or NULL if not in style uniform
  // "fluid_force_motion": FluidMotion *, for fix grain/motion
  void *extract(const char *, int &) override;

 private:

  bool coupled_;
  std::unique_ptr<UniformFlow> uniform_;    // NULL in style coupled
  UniformFluid uniformFluid_;               // what others ask of it

  // ---- values per grain; NULL where the style or the coupling has none

  GrainProperties properties_;
  class FixPropertyAtom *fluidVelocity_, *dragCoefficient_, *explicitForce_;
  class FixPropertyAtom *impulse_, *fluidForce_, *startPosition_, *owner_;
  class FixPropertyAtom *nonReactingCoefficient_, *nonReactingForce_;
  class FixPropertyAtom *nonReactingImpulse_, *nonReactingApplied_;
  class FixPropertyAtom *fluidSpin_, *spinCoefficient_, *explicitTorque_, *fluidTorque_;
  class FixPropertyAtom *addedMass_;
  class FixPropertyAtom *work_, *powerGrowth_;

  // ---- style coupled

  FluidForceExchange exchange_;
  bool exchangeOpen_;               // a coupling has asked for the exchange
  bool nonReactingRequested_, torqueRequested_, addedMassRequested_, workRequested_;    // by that coupling
  bool nonReactingRead_, torqueRead_, addedMassRead_, workRead_;                        // are in the restart file
  RemovedGrains removed_;
  RunningState running_;

  HeldGrains held_;
  bool freshSetup_;                 // forces of the set-up not yet used for a kick
  bigint sumStep_;                  // step of sums_, -1: none
  double sums_[5];                  // force, sum of slip speeds, number of those

  void parse(int, char **);
  void check_other_fixes();
  void check_box();

  void create_non_reacting();
  void create_torque();
  void create_added_mass();
  void create_work();
  void drop_unrequested();

  void refresh_exchange();
  void collect_removed(bool deleting, double halfKick);

  // Adds the fluid's force and torque to all grains. kick: time over which the integrator
  // applies them; remove: take the previous ones off first; book: add the impulse of the half
  // kick before and the half kick to come
  void apply(double kick, bool remove, bool book);

  // What a loop books as impulse. Steps that fix grain/motion has joined have the first half kick of the
  // next step booked with the second one of this step, by the same force.
  struct Booking {
    bool step;      // anything: not in the set-up
    bool remove;    // take the previous forces off first
    bool before;    // half kick before, by the forces of the former step
    bool after;     // first half kick of the next step. Then nobody sees the forces of this step: not kept
  };
  template<bool UNIFORM, bool NON_REACTING, bool ADDED_MASS> struct Kind {};
  template<bool UNIFORM, bool NON_REACTING, bool ADDED_MASS> struct Push;    // force on one grain
  template<bool U, bool N, bool A> bool push_loop(double kick, const Booking &);
  template<bool U, bool N, bool A> bool push(double kick, const Booking &);
  template<bool U, bool N, bool A> bool push_avx2(double kick, const Booking &);
  template<bool U, bool N, bool A, bool JOIN> bool move_loop(const GrainStep &, const Booking &);
  template<bool U, bool N, bool A, bool JOIN> bool push_and_move(const GrainStep &, const Booking &);
  template<bool U, bool N, bool A, bool JOIN> bool push_and_move_avx2(const GrainStep &, const Booking &);
  template<bool U, bool N, bool A> bool push_of(Kind<U, N, A>, double kick, const Booking &book)
  {
    return grainjet::has_avx2() ? push_avx2<U, N, A>(kick, book) : push<U, N, A>(kick, book);
  }
  template<bool U, bool N, bool A> bool move_of(Kind<U, N, A>, const GrainStep &grains, const Booking &book)
  {
    if (grainjet::has_avx2())
      return grains.join ? push_and_move_avx2<U, N, A, true>(grains, book) : push_and_move_avx2<U, N, A, false>(grains, book);
    return grains.join ? push_and_move<U, N, A, true>(grains, book) : push_and_move<U, N, A, false>(grains, book);
  }
  template<typename Call> bool choose(const Call &);    // call(Kind of what this run has)

  // ---- a fix grain/motion that names this fix calls it instead of LIGGGHTS

  FluidMotion motion_;
  bool moved_;           // there is one in this run
  bool bookedAhead_;     // impulse has the half kick to come
  void find_motion();
  bool joins() const;
  void move(const GrainStep &);

  template<bool UNIFORM> bool turn_loop(double kick, bool remove);
  template<bool UNIFORM> bool turn(double kick, bool remove);
  bool turn_avx2(double kick, bool remove);
  bool turn_block(int first, double kick, FluidBlock<false> &);

  // Work of the half kick before, by the forces before push(), and of the half kick to come, by
  // those after it
  bool books_work() const { return work_ && (workRequested_ || !exchangeOpen_); }
  void book_work_before();
  void book_work_after(bool book);
  void reacting_force(int, double *) const;

  const double *fluid_velocity(int) const;
  void sum();
  void refuse_force();
  void refuse_torque();
  [[noreturn]] void refuse(const char *text);

  static constexpr double LARGEST = 1e30;    // N or N m, on a grain

  static void clear_removed(FluidForceExchange *);
  static void use_non_reacting(FluidForceExchange *);
  static void use_torque(FluidForceExchange *);
  static void use_added_mass(FluidForceExchange *);
  static void use_work(FluidForceExchange *);
  static int add_state(FluidForceExchange *, const char *, int, const double *);
  static double *state(FluidForceExchange *, int);
};

}

#endif
#endif
