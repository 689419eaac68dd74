/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/coarsegraining.h"

#include "host/expose_member.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "input.h"
#include "modify.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

using namespace LAMMPS_NS;

typedef void (*CommandCreator)(LAMMPS *, int, char **);

namespace grainjet {

struct ErrorFlag {
  using type = bool Force::*;
  friend type member(ErrorFlag);
};
template struct Expose<ErrorFlag, &Force::error_coarsegraining_>;

struct WarnFlag {
  using type = bool Force::*;
  friend type member(WarnFlag);
};
template struct Expose<WarnFlag, &Force::warn_coarsegraining_>;

struct Factors {
  using type = std::vector<double> Force::*;
  friend type member(Factors);
};
template struct Expose<Factors, &Force::coarsegrainingTypeBased_>;

struct Commands {
  using type = std::map<std::string, CommandCreator> *Input::*;
  friend type member(Commands);
};
template struct Expose<Commands, &Input::command_map>;

}

// a grain of more than 1e18 particles is a slip of the pen
static const double LARGEST = 1e6;

/* The commands that make a box; after each of them the number of types is known. */
namespace {

const char *const BOX_COMMANDS[] = {"create_box", "read_data", "read_restart"};
CommandCreator host_creators[3];

template <int n> void make_box(LAMMPS *lmp, int narg, char **arg)
{
  host_creators[n](lmp, narg, arg);
  CoarseGrainingCommand(lmp).settle_number();
}

const CommandCreator FOLLOWED_CREATORS[] = {make_box<0>, make_box<1>, make_box<2>};

}

/* ---------------------------------------------------------------------- */

void CoarseGrainingCommand::command(int narg, char **arg)
{
  std::vector<double> factors;
  int next = 0;
  for (; next < narg && strcmp(arg[next], "model_check") != 0; ++next) {
    char *end = nullptr;
    factors.push_back(strtod(arg[next], &end));
    if (end == arg[next] || *end != '\0' || !(factors[next] >= 1.0 && factors[next] <= LARGEST))
      fail(std::string("needs factors >= 1 and at most 1e6, not '") + arg[next] + "'; the only keyword is model_check");
  }
  if (factors.empty()) fail("needs a factor, or one factor per atom type");

  if (next < narg) {
    const std::string check = next + 1 < narg ? arg[next + 1] : "";
    if (check != "error" && check != "warn")
      fail("needs error or warn after 'model_check'" + (check.empty() ? "" : ", not '" + check + "'"));
    if (next + 2 < narg) fail(std::string("takes nothing after 'model_check ") + check + "', not '" + arg[next + 2] + "'");
    force->*member(grainjet::ErrorFlag()) = check == "error";
    force->*member(grainjet::WarnFlag()) = check == "warn";
  }

  if (modify->n_fixes_style("particletemplate") > 0)
    fail("comes after a particle template, which has its size already; state it before");
  if (force->cg_active()) fail("is given twice; state all factors in one command");

  for (double factor : factors) force->setCG(factor);
  if (domain->box_exist) settle_number();
  else settle_when_box_is_made();

  if (comm->me) return;
  for (FILE *out : {screen, logfile})
    if (out) {
      fprintf(out, "Coarse graining: one grain stands for f_cg^3 particles, f_cg =");
      for (double factor : factors) fprintf(out, " %g", factor);
      fprintf(out, "\n");
    }
}

/* ---------------------------------------------------------------------- */

void CoarseGrainingCommand::settle_number()
{
  const std::vector<double> &factors = force->*member(grainjet::Factors());
  const size_t given = factors.size();
  if (given == 1)
    for (int type = 2; type <= atom->ntypes; ++type) force->setCG(double(factors[0]));
  else if (given > 1 && given != static_cast<size_t>(atom->ntypes))
    fail("states " + std::to_string(given) + " factors, but the box has " + std::to_string(atom->ntypes)
      + " atom types; state one factor for all grains, or as many as there are atom types");
}

/* ----------------------------------------------------------------------
   The number of types is known as soon as one of the commands that make a box has run. From
   here to the end of the process the number of factors is looked at after each of them, which
   does nothing where none were stated, as after a `clear`.
------------------------------------------------------------------------- */

void CoarseGrainingCommand::settle_when_box_is_made()
{
  std::map<std::string, CommandCreator> &commands = *(input->*member(grainjet::Commands()));
  for (int n = 0; n < 3; ++n) {
    CommandCreator &creator = commands[BOX_COMMANDS[n]];
    if (creator == FOLLOWED_CREATORS[n]) continue;
    host_creators[n] = creator;
    creator = FOLLOWED_CREATORS[n];
  }
}

/* ---------------------------------------------------------------------- */

void CoarseGrainingCommand::fail(const std::string &message)
{
  error->all(FLERR, ("Command coarsegraining " + message).c_str());
  std::abort();    // never reached: Error::all ends the program
}
