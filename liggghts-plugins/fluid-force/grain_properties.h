/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_GRAIN_PROPERTIES_H
#define GRAINJET_GRAIN_PROPERTIES_H

#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

/* The numbers per grain that a fix keeps, each in a stock fix property/atom of the same name:
   LIGGGHTS moves them between ranks, sorts, restarts and dumps them. In a continued run their
   values come back when they are created, as long as that is before the first set-up of steps.

   Some of them are the state of models: those have a name and a size of the model's choice, and
   are listed in the restart file of the fix, so that they come back with it.            */
class GrainProperties : protected Pointers {
 public:

  // owner: the fix, named in messages
  GrainProperties(class LAMMPS *, class Fix *owner);

  // A fix property/atom with restart and without ghosts. New grains get `initial`, one value
  // per column; without one the owner sets them. One column: vector_atom, else array_atom.
  // Error if the script has a fix of that name.
  class FixPropertyAtom *create(const char *name, const std::vector<double> &initial);
  class FixPropertyAtom *create_unset(const char *name, int size);

  void remove();    // all of them, with their owner

  // State of a model: see FluidForceExchange::addState
  int add_state(const char *name, int size, const double *initial);
  double *state(int index) const;

  // The list of states in a restart file, as numbers. all: also those that no model has asked
  // for since the file was read; otherwise these end here
  void pack(std::vector<double> &, bool all) const;
  void unpack(const double *);
  void create_states();    // those of the file

 private:

  struct State {
    std::string name;
    std::vector<double> initial;
    class FixPropertyAtom *fix;    // NULL: read, not created yet
    bool requested;                // by a model in this run
  };

  class Fix *owner_;
  std::vector<std::string> names_;
  std::vector<State> states_;

  class FixPropertyAtom *create_property(const char *name, const std::vector<std::string> &initial);
  void check(const char *name, int size, const double *initial);
  [[noreturn]] void fail(const std::string &) const;
};

}

#endif
