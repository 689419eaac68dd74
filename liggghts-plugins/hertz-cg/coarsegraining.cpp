/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/coarsegraining.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "modify.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

using namespace LAMMPS_NS;

/* Two settings that the host keeps to itself, reached through pointers to members; access is
   not checked in an explicit instantiation.                                               */
namespace {

template <class Tag, bool Force::*Member>
struct Expose {
  friend bool Force::*member(Tag) { return Member; }
};

struct ErrorFlag { friend bool Force::*member(ErrorFlag); };
struct WarnFlag { friend bool Force::*member(WarnFlag); };

template struct Expose<ErrorFlag, &Force::error_coarsegraining_>;
template struct Expose<WarnFlag, &Force::warn_coarsegraining_>;

}

/* ---------------------------------------------------------------------- */

void CoarseGrainingCommand::command(int narg, char **arg)
{
  if (narg >= 2 && strcmp(arg[narg - 2], "model_check") == 0) {
    const bool warn = strcmp(arg[narg - 1], "warn") == 0;
    if (!warn && strcmp(arg[narg - 1], "error") != 0) fail("needs error or warn after 'model_check'");
    force->*member(ErrorFlag()) = !warn;
    force->*member(WarnFlag()) = warn;
    narg -= 2;
  }
  if (narg < 1) fail("needs a factor, or one factor per atom type");
  if (modify->n_fixes_style("particletemplate") > 0)
    fail("comes after a particle template, which has its size already; state it before");
  if (force->cg_active()) fail("is given twice; state all factors in one command");
  if (narg > 1 && !domain->box_exist)
    fail("with one factor per atom type has to come after the box is created");
  if (narg > 1 && narg != atom->ntypes) fail("needs one factor, or as many as there are atom types");

  double *factor = new double[narg];
  for (int i = 0; i < narg; ++i) {
    char *end = nullptr;
    factor[i] = strtod(arg[i], &end);
    if (end == arg[i] || *end != '\0' || !std::isfinite(factor[i]) || factor[i] < 1.0)
      fail((std::string("needs factors >= 1, not '") + arg[i] + "'").c_str());
  }
  for (int i = 0; i < narg; ++i) force->setCG(factor[i]);
  delete[] factor;

  if (comm->me) return;
  for (FILE *out : {screen, logfile})
    if (out) {
      fprintf(out, "Coarse graining: one grain stands for f_cg^3 particles, f_cg =");
      for (int i = 0; i < narg; ++i) fprintf(out, " %g", force->cg(i + 1));
      fprintf(out, "\n");
    }
}

/* ---------------------------------------------------------------------- */

void CoarseGrainingCommand::fail(const char *message)
{
  error->all(FLERR, (std::string("Command coarsegraining ") + message).c_str());
  std::abort();    // never reached: Error::all ends the program
}
