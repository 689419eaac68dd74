/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(grain/motion,FixGrainMotion)

#else

#ifndef LMP_FIX_GRAIN_MOTION_H
#define LMP_FIX_GRAIN_MOTION_H

#include "fix.h"
#include "fluid-force/held_grains.h"
#include "grain_step.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

/* Moves grains as the stock nve/sphere, with gravity and the force of a fluid in the same pass over
   memory. User page: docs/fix_grain_motion.md.

     fix ID group grain/motion [gravity g x y z] [fluid <fix-ID>]

   A step of a dilute stream is bound by memory: stock LIGGGHTS reads and writes position, velocity and force
   five times (two halves of the integration, clearing of forces, gravity, force of the fluid). Here
   - forces are cleared where they were used last, and to the weight instead of zero;
   - the fluid's force is worked out in the pass that uses it;
   - the second half of a step and the first half of the next one are one pass, wherever nothing
     can look at grains in between (joined steps, see join()).

   No state of its own, nothing in restart files.

   Errors, in init(): another fix that integrates or clumps, run_style respa, minimisation, a fix gravity beside
   the keyword, a fluid that is no fix fluid/force or has another group, grains without radius. */
class FixGrainMotion : public Fix {
 public:

  FixGrainMotion(class LAMMPS *, int, char **);

  int setmask() override;
  void pre_delete(bool) override;
  void init() override;
  void setup(int) override;
  void setup_pre_force(int) override;
  void initial_integrate(int) override;
  void pre_neighbor() override;
  void pre_force(int) override;
  void final_integrate() override;

  // "grain_motion_gravity": double[3], m/s2, or NULL without the keyword
  // "grain_motion_fluid": const char *, ID of the fix fluid/force that this fix calls, or NULL
  // "grain_motion_until": bigint *, the last step of the present Integrate::run, for programs that
  //   call it with an Update::laststep beyond; behind it grains are at a full step. -1: laststep
  void *extract(const char *, int &) override;

 private:

  double magnitude_, direction_[3];    // of gravity, m/s2 and unit vector
  double gravity_[3];                  // m/s2
  bool hasGravity_;
  std::string fluidId_;                // empty: none
  FluidMotion *fluid_;

  HeldGrains held_;
  std::vector<int> late_;              // grains that have not begun the next step yet
  bool mayJoin_;                       // of this run
  bool joined_;                        // the first half of the coming step is done
  bigint until_;
  struct EndOfStep { int every; };
  std::vector<EndOfStep> ends_;        // fixes that look at grains at the end of some steps

  void parse(int, char **);
  void check_atoms();
  void check_other_fixes();
  void find_fluid();
  void act_first();
  void set_clearing(bool own);
  std::string spoiler() const;         // what keeps steps from being joined; empty: nothing
  void find_ends();
  bool join() const;
  GrainStep step(bool join);
  void clear_all();
  void clear_ghosts();
  [[noreturn]] void fail(const std::string &) const;
};

}

#endif
#endif
