/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(collision/stats,FixCollisionStats)

#else

#ifndef LMP_FIX_COLLISION_STATS_H
#define LMP_FIX_COLLISION_STATS_H

#include "fix.h"

#include "collision-stats/collision_place.h"
#include "collision-stats/collision_statistics.h"
#include "hertz-cg/contact_exchange.h"
#include "wall-collisions/file_writer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace grainjet { class FixArguments; }

namespace LAMMPS_NS {

/* Statistics of the collisions between grains, as fix hertz/cg computes them. User page:
   docs/fix_collision_stats.md.

     fix ID group collision/stats contact hertzID [region ID] [bins x|y|z low high n] [energy min max n]
         [speed min max n] [force min max n] [duration min max n] [every N] file path [spectra path] [stats_start t]

   A collision is a contact of fix hertz/cg from its first to its last step. Velocities before it are those of
   mid-step, after the last kick without and before the first with a force of the contact. What it dissipates is
   summed as fix hertz/cg does it. The state of collisions in progress goes with the contacts of fix hertz/cg.

   Each rank keeps the statistics of what it has counted since the last output, where all go to rank 0.

   Global vector: 1 collisions that are over; 2 going on; 3 lost (a grain was deleted or displaced in
   contact); 4 energy dissipated by those that are over [J]; 5 energy that those going on have taken from the
   motion so far, a part of which is in their springs [J].                                      */
class FixCollisionStats : public Fix, public grainjet::FileWriter, private ContactObserver {
 public:

  FixCollisionStats(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int) override;
  void post_integrate() override;
  void end_of_step() override;
  void post_run() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double compute_vector(int) override;
  double memory_usage() override;

 private:

  using Statistics = grainjet::CollisionStatistics;

  std::string contactID_, regionID_, path_, spectraPath_;
  int every_;               // steps between outputs
  double start_;            // s, stats_start
  grainjet::AxisBins bins_;
  grainjet::SpectrumBins spectra_[Statistics::KINDS];

  std::unique_ptr<CollisionPlace> place_;
  std::unique_ptr<Statistics> statistics_;    // of this rank; after an output of all, on rank 0
  double samples_;          // how often the grains were counted
  double clock_;            // s, time of the simulation, also across restarts, where LIGGGHTS'
                            // own starts anew; < 0: not yet set
  double begin_;            // s, time from which collisions count
  bool anew_;               // after a restart statistics begin anew
  bool started_, left_[2];  // has run; the files became somebody else's, of which a warning was given

  double numbers_[5];       // global vector
  bigint numbersStep_;      // when it was summed

  void parse(int, char **);
  void parse_bins(grainjet::FixArguments &);
  void parse_spectrum(grainjet::FixArguments &, const std::string &keyword, grainjet::SpectrumBins &);
  [[noreturn]] void fail(const std::string &message) const;
  void agree(std::string fault);
  ContactExchange *find_contacts(std::string &fault) const;
  void attach();

  void touches(const ContactStep &, double *state) override;
  void parted(const ContactStep &, const double *state) override;
  bool begins(const ContactStep &, grainjet::GrainCollision &) const;
  bool counts(const grainjet::GrainCollision &c) const { return c.counts(begin_); }
  void count_grains();
  void visit_counted(const std::function<void(const grainjet::GrainCollision &)> &) const;
  std::vector<double> touching() const;
  void sum_numbers();

  void gather();
  void write();
  std::string write_file(int which, const std::string &columns, const std::string &text);
  std::string check_files() const;
  std::vector<std::string> paths() const override;
  std::vector<double> settings() const;
  std::vector<std::string> names() const;
};

}

#endif
#endif
