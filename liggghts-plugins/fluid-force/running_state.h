/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_RUNNING_STATE_H
#define GRAINJET_RUNNING_STATE_H

#include "fluid_force_exchange.h"

#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

/* What a run needs to go on from the middle of another one as if that had not stopped, and what
   LIGGGHTS does not put into its restart files:

   - force and torque of the latest step. A set-up works them out anew from velocities that are
     half a step further, so every contact that is open then would damp differently;
   - where grains were when the neighbour lists were made. From there the set-up makes the same
     lists in the same order, and the next ones are due at the same step;
   - when grains are sorted in memory next, and which ones a fix massflow/mesh has marked for
     deletion.

   So a file can be written between any two steps and the writing run is not touched. A grain
   beyond its rank's part of the box, which read_restart would lose, is written with its
   position in the lists. Nothing is kept per grain while a run goes on, except that position. */
class RunningState : protected Pointers {
 public:

  static const int VALUES = 15;    // numbers per grain in a restart file

  explicit RunningState(class LAMMPS *);

  // ---- writing

  void note_lists();               // neighbour lists are being made
  void forget_lists() { noted_ = false; }
  std::vector<double> begin_write();    // global part; until end_write() grains are where they can be read
  void end_write();
  int pack(int i, double *) const;

  // ---- reading, and grains that change place meanwhile

  const double *restart(const double *);    // returns what follows in the global part
  void unpack(int i, const double *);
  bool holds() const { return holding_; }
  void grow(int nmax);
  void copy(int i, int j);
  void forget(int i);
  int pack_exchange(int i, double *) const;
  int unpack_exchange(int i, const double *);

  // ---- the set-up of the run that goes on, in this order. resumes(): it does go on, which is
  //      to be asked once, at the beginning, and is the same on all ranks

  bool resume();
  bool resumes() const { return resuming_; }
  void to_lists();                 // before grains are exchanged
  void lists_made();               // before the lists are used
  void to_present();               // before any force is worked out
  void present_forces();           // once all are, and again before the first step
  void set_up();                   // at the end of the set-up
  void finish();                   // the first step begins

  const GrainFile &written() const { return written_; }
  const GrainFile &read() const { return read_; }

 private:

  // per grain, in a file: is it valid, position in the lists, present position, force, torque,
  // number of the fix massflow/mesh that has marked it (0: none) and place among those
  enum { VALID, LISTED, PRESENT = LISTED + 3, FORCE = PRESENT + 3, TORQUE = FORCE + 3,
         MARKED_BY = TORQUE + 3, PLACE };
  static constexpr double LAYOUT = 4.0;    // of the fix' data in a file
  enum { VERSION, IN_RUN, STAMP, STEP, GRAINS, NEXT_SORT, AGO, NSAVED };

  std::vector<double> listed_;     // positions in the lists, three a grain
  bool noted_;                     // listed_ is that of the present lists

  struct Moved { int i; double x[3]; };
  bool inRun_;                     // the file being written is from the middle of a run
  std::vector<Moved> moved_;       // grains that are elsewhere while it is written
  struct Marked { int i; double by, place; };
  std::vector<Marked> marked_;     // grains that are to be deleted, while it is written

  bool holding_, resuming_, used_;
  std::vector<double> held_;       // VALUES a grain, while holding
  bigint nextSort_;
  int ago_;
  int sortEvery_;
  double contactDistance_;
  std::vector<int> order_;         // of the pre_force hooks, while resuming

  GrainFile written_, read_;

  bool outside(const double *) const;
  void find_marked();
  void mark();
  void move(int column);
  void keep_histories();
};

}

#endif
