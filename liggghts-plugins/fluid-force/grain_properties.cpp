/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "grain_properties.h"

#include "atom.h"
#include "error.h"
#include "fix_property_atom.h"
#include "modify.h"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace LAMMPS_NS;

static const char PREFIX[] = "fluidState_";    // of the states' names

/* ---------------------------------------------------------------------- */

GrainProperties::GrainProperties(LAMMPS *lmp, Fix *owner) : Pointers(lmp), owner_(owner) {}

/* ----------------------------------------------------------------------
   all ranks come here together
------------------------------------------------------------------------- */

void GrainProperties::fail(const std::string &message) const
{
  const std::string full = std::string("Fix ") + owner_->style + " (ID " + owner_->id + "): " + message;
  error->all(FLERR, full.c_str());
  std::abort();    // never reached: Error::all ends the program
}

/* ----------------------------------------------------------------------
   LIGGGHTS would replace a fix of the same ID without a word.
------------------------------------------------------------------------- */

FixPropertyAtom *GrainProperties::create_property(const char *name, const std::vector<std::string> &initial)
{
  if (modify->find_fix(name) >= 0)
    fail(std::string("the script has a fix with ID ") + name
      + ", which is the name of a property of this fix; give that fix another ID");

  std::vector<const char *> args = {name, "all", "property/atom", name,
    initial.size() == 1 ? "scalar" : "vector", "yes", "no", "no"};
  for (const std::string &value : initial) args.push_back(value.c_str());
  FixPropertyAtom *fix = modify->add_fix_property_atom(
    args.size(), const_cast<char **>(args.data()), owner_->style);

  // What is there has its initial state now. Modify::setup would set it once more and
  // so wipe out what was written before the first run.
  fix->just_created = 0;
  names_.push_back(name);
  return fix;
}

/* ---------------------------------------------------------------------- */

FixPropertyAtom *GrainProperties::create(const char *name, const std::vector<double> &initial)
{
  std::vector<std::string> texts;
  for (double value : initial) {
    char text[32];
    snprintf(text, sizeof(text), "%.17g", value);
    texts.push_back(text);
  }
  return create_property(name, texts);
}

FixPropertyAtom *GrainProperties::create_unset(const char *name, int size)
{
  return create_property(name, std::vector<std::string>(size, "none"));
}

/* ---------------------------------------------------------------------- */

void GrainProperties::remove()
{
  for (const std::string &name : names_)
    if (modify->find_fix(name.c_str()) >= 0) modify->delete_fix(name.c_str());
  names_.clear();
  states_.clear();
}

/* ---------------------------------------------------------------------- */

void GrainProperties::check(const char *name, int size, const double *initial)
{
  bool plain = name[0] != '\0';
  for (const char *c = name; *c; c++) plain &= std::isalnum(static_cast<unsigned char>(*c)) || *c == '_';
  if (!plain)
    fail(std::string("'") + name + "' cannot be the name of a model's state; use letters, digits and _ only");

  if (size < 1)
    fail(std::string("state '") + name + "' must have at least one number per grain, not "
      + std::to_string(size));
  for (int k = 0; k < size; k++)
    if (!std::isfinite(initial[k]))
      fail(std::string("initial value ") + std::to_string(k + 1) + " of state '" + name
        + "' is not a finite number");
}

/* ---------------------------------------------------------------------- */

int GrainProperties::add_state(const char *name, int size, const double *initial)
{
  check(name, size, initial);
  const std::vector<double> values(initial, initial + size);

  for (size_t index = 0; index < states_.size(); index++) {
    State &state = states_[index];
    if (state.name != name) continue;
    if (state.initial.size() != values.size())
      fail(std::string("state '") + name + "' has " + std::to_string(state.initial.size())
        + " numbers per grain, in this run or in the restart file, and a model asks for "
        + std::to_string(size) + "; give the model's state another name");
    state.requested = true;
    return index;
  }

  states_.push_back(State{name, values, create((PREFIX + std::string(name)).c_str(), values), true});
  return states_.size() - 1;
}

/* ---------------------------------------------------------------------- */

double *GrainProperties::state(int index) const
{
  if (atom->nlocal == 0) return NULL;
  const State &state = states_[index];
  return state.initial.size() == 1 ? state.fix->vector_atom : state.fix->array_atom[0];
}

/* ----------------------------------------------------------------------
   number of states, and for each: length of the name, its letters, size, initial values
------------------------------------------------------------------------- */

void GrainProperties::pack(std::vector<double> &list, bool all) const
{
  const size_t place = list.size();
  list.push_back(0.0);
  for (const State &state : states_) {
    if (!state.requested && !all) continue;
    list[place] += 1.0;
    list.push_back(state.name.size());
    list.insert(list.end(), state.name.begin(), state.name.end());
    list.push_back(state.initial.size());
    list.insert(list.end(), state.initial.begin(), state.initial.end());
  }
}

/* ---------------------------------------------------------------------- */

void GrainProperties::unpack(const double *list)
{
  states_.clear();
  for (int n = static_cast<int>(*list++); n > 0; n--) {
    State state = {"", {}, NULL, false};
    for (int k = static_cast<int>(*list++); k > 0; k--) state.name += static_cast<char>(*list++);
    for (int k = static_cast<int>(*list++); k > 0; k--) state.initial.push_back(*list++);
    states_.push_back(state);
  }
}

void GrainProperties::create_states()
{
  for (State &state : states_)
    state.fix = create((PREFIX + state.name).c_str(), state.initial);
}
