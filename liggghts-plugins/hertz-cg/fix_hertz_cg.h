/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(hertz/cg,FixHertzCg)

#else

#ifndef LMP_FIX_HERTZ_CG_H
#define LMP_FIX_HERTZ_CG_H

#include "fix.h"

#include "hertz-cg/contact_exchange.h"
#include "hertz-cg/contact_observers.h"
#include "hertz-cg/contact_pairs.h"
#include "hertz-cg/contact_store.h"
#include "hertz-cg/material_table.h"
#include "hertz-cg/search_settings.h"
#include "hertz-cg/stream_motion.h"
#include "hertz-cg/wall_axes.h"
#include "physics/contact/contact_law.h"

#include <string>
#include <vector>

namespace grainjet { class FixArguments; struct Kinematics; }

namespace LAMMPS_NS {

/* Contact between grains: Hertz-Mindlin spring-dashpot with tangential history, evaluated for
   the particles a grain stands for and scaled by f_cg^2 and f_cg^3. In place of `pair_style gran`.

     fix c all hertz/cg [model hertz] [tangential history|no_history|off]
                        [rolling off|cdt|epsd|epsd2] [torsionTorque on|off]
                        [limitForce on|off] [tangential_damping on|off]
                        [cohesion off|sjkr|sjkr2] [tangential_reduce on|off]
                        [timestep_check N fraction warn|error] [overlap_check fraction]

   The words of `pair_style gran model hertz` mean what they mean there (rolling_friction may be written
   for rolling); laws and sources in physics/contact.

   tangential      friction with a tangential spring (default), with a dashpot only, or none
   rolling         resistance to rolling, default off; torsionTorque: also to rotation about the normal
   limitForce      no attraction by the dashpot at the end of a contact (default off)
   tangential_damping  dashpot beside the tangential spring (default on)
   cohesion        attraction by contact area and cohesion energy density, default off;
                   tangential_reduce: it counts in the Coulomb limit (default off)
   timestep_check  every N steps compare the time step with `fraction` of the Rayleigh time and of
                   the Hertz time; beyond it warn, or end the run. Without it, both times are only
                   in the global vector
   overlap_check   fraction of the smaller radius beyond which an overlap is counted and reported
                   at the end of a run (default 0.1)

   Global vector f_c[1..7]: contacts now; collisions begun since the start; largest
   overlap/radius since the start; time step in % of the Rayleigh time, in % of the Hertz time;
   energy now in the springs, and of cohesion [J]; energy dissipated by contacts since the start [J].
   Walls are left to the stock `fix wall/gran` and not in these numbers.

   Other fixes observe the contacts through extract(): hertz-cg/contact_exchange.h.           */
class FixHertzCg : public Fix, private ContactExchange {
 public:
  FixHertzCg(class LAMMPS *, int, char **);
  ~FixHertzCg();

  int setmask() override;
  void post_create_pre_restart() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void init_list(int, class NeighList *) override;
  void setup_pre_exchange() override;
  void setup_pre_neighbor() override;
  void setup_pre_force(int) override;
  void post_integrate() override;
  void reset_dt() override;
  void pre_exchange() override;
  void pre_neighbor() override;
  void end_of_step() override;
  void post_run() override;

  double extend_cut_ghost() override;
  double compute_vector(int) override;
  double memory_usage() override;
  void *extract(const char *, int &) override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;

  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

 private:

  friend class PairHertzCg;

  // keywords
  grainjet::contact::LawOptions law_;
  double timestep_fraction_;
  bool timestep_error_;
  double overlap_fraction_;

  // parts
  grainjet::MaterialTable materials_;
  grainjet::SearchSettings search_;
  grainjet::StreamMotion motion_;
  grainjet::ContactPairs pairs_;
  grainjet::ContactStore store_;
  grainjet::ContactObservers observers_;
  class PairHertzCg *stand_in_;    // in the place of the pair style; owned by the host

  // state of pairs and store
  bool pairs_valid_;       // indices in pairs_ are those of the host's arrays
  bool store_current_;     // store_ holds what pairs_ holds
  bool forces_restarted_;  // until the first step, forces and list are those of the restart file
  double state_restarted_[2];    // state() of the grains of that file

  // the search
  double rmax_;            // m, largest radius, also of grains still to be inserted
  double margin_;          // m, of the present list
  double pairs_per_grain_; // of the present list
  bigint search_step_;     // when it was made
  double elapsed_;         // s, from then until counted_step_, in steps of other lengths than the present one
  bigint counted_step_;
  double step_size_;       // s, of the present steps
  bool expired_;           // the next one is due because its margin is used up
  grainjet::SearchSettings::Work work_done_;
  double stream_[3];       // m/s, mean velocity of the grains then
  int freeze_bit_;

  // grains that change their size
  bool grows_;
  double growth_;                // m, largest growth of a radius between two searches of this run
  std::vector<double> held_;     // m, radii at the last search

  grainjet::WallAxes walls_;

  // bookkeeping, this rank's share since the start
  double collisions_, deep_, deepest_;
  double deep_reported_;   // number of deep contacts last reported
  double work_;            // J, done by contacts on grains
  double found_;           // J, in the springs of contacts that were there before the first step
  bigint reduced_step_;
  double reduced_[7];

  std::string failure_;    // what went wrong on this rank, to be told by all

  void parse(int, char **);
  void parse_law(grainjet::FixArguments &, const std::string &keyword);
  void stand_in();
  void remove_stand_in();
  void check_host();
  void check_sizes();
  bool find_growth() const;
  std::vector<double> largest_radii() const;
  bool follow_sizes();
  void hold_sizes();
  bool sizes_changed();
  double packing() const;

  void search();
  void check_grains();
  void measure();
  void choose_margin(const double velocity[3]);
  void stream_velocity(double velocity[3]) const;
  void start_motion(const double velocity[3]);
  void save_contacts();
  void state(double sum[2]) const;
  void check_restarted();

  void fail(const std::string &message);
  void report_failure();
  void report_deep();

  struct Grains;
  struct Evaluated;
  void compute(bool advance);
  template <bool TANGENTIAL, bool EXTRAS>
  void compute_pairs(bool advance, bool again);
  template <bool TANGENTIAL, bool EXTRAS>
  void compute_contact(const Grains &, std::size_t pair, double rsq, bool advance, bool again);
  template <bool TANGENTIAL, bool EXTRAS, class Kinematics>
  Evaluated evaluate(const Grains &, const Kinematics &, int i, int j, const grainjet::Contact &, bool advance) const;
  void tell_contacts();
  void observe_contact(const grainjet::Kinematics &, std::size_t pair, double work, bool begins, bool advance);
  void end_contact(const Grains &, std::size_t pair, bool advance);
  void begin_contact(const Grains &, std::size_t pair, double depth);
  void fail_contact(const Grains &, std::size_t pair, const char *why);

  std::string observe(ContactObserver *, const std::string &name, int size) override;
  void ignore(const ContactObserver *) override;
  bool observed(const ContactObserver *) const override;
  void visit(const ContactObserver *, const Visit &) const override;

  void reduce();
  double elastic_energy() const;

  struct Grain {
    double key = 0.0;      // kg^power, what the time grows with when divided by the radius
    double radius = 0.0;   // m; zero: there is none
    double mass = 0.0;     // kg
  };
  std::vector<Grain> quickest(int power) const;
  double percent_of(double shortest) const;
  double rayleigh_percent() const;
  double hertz_percent() const;
};

}

#endif
#endif
