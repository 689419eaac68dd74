/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_HERTZ_CG_H
#define LMP_PAIR_HERTZ_CG_H

#include "pair_gran.h"

#include "hertz-cg/contact_pairs.h"

#include <vector>

namespace LAMMPS_NS {

class FixHertzCg;

/* What stands in the place of the granular pair style while fix hertz/cg is defined, under its name
   `gran`. Stock commands that ask the pair style for contacts find it and get those of the fix:
   compute pair/gran/local, contact/atom/gran, stress/atom, pressure, fix check/timestep/gran,
   heat/gran/conduction, ave/euler, continuum/weighted, and all that only want a pair style to be there.
   It has no settings and no law of its own: the fix computes the contacts when the host calls the pair
   style, with the host's wish for the virial. It leaves no trace in restart files.            */
class PairHertzCg : public PairGran {
 public:

  PairHertzCg(LAMMPS *, FixHertzCg *);
  ~PairHertzCg();

  // A neighbour list of the host's kind for those who go through it: partners by their first grain
  void show(const grainjet::ContactPairs &pairs, int nlocal);

  // The pairs in the order of that list
  const std::vector<int> &order() const { return order_; }

  std::size_t bytes() const { return (order_.capacity() + partners_.capacity() + first_.capacity()) * sizeof(int); }

  void settings(int, char **) override;
  void init_style() override;
  void compute_force(int eflag, int vflag, int addflag) override;
  bool contact_match(const std::string kind, const std::string model) override;
  int64_t hashcode() override { return 0; }             // for the host's neighbour lists, of which there are none
  double stressStrainExponent() override { return 1.5; }    // of a Hertz contact

  void write_restart(FILE *) override;

  // Forces of a contact, for whoever wants to know: sum, torques on both grains, as the host's own style tells
  struct Contact {
    int i, j;
    double force[3], torqueI[3], torqueJ[3];   // N, on i; N m
    double normal[3];                          // from j to i
    double delta[3];                           // m, from j to i
    double history[6];                         // m, tangential spring; N m, rolling spring (as `history` shows it)
  };

  // Is anybody there who wants to be told of every contact of a step?
  bool watched() const;
  void tell(const Contact &);                  // of a step
  void tell_local(Contact &);                  // to compute pair/gran/local

 private:

  FixHertzCg *fix_;
  std::vector<int> order_, partners_, first_;

  bool storing() const;
  void store(class FixContactPropertyAtom *, int i, int j, const double *force, const double *rest, int nrest);
};

}

#endif
