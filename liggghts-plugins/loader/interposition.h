/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_INTERPOSITION_H
#define GRAINJET_INTERPOSITION_H

#include <string>

/* Some functions of LIGGGHTS are defined anew in a library of Grainjet, which LIGGGHTS then
   calls instead of its own. That works only if the library comes before LIGGGHTS, and before
   any other one with such a function, in the linker's search order.                         */

namespace grainjet {
namespace interposition {

  // a function of LIGGGHTS: its name for messages, and for the linker
  struct Function {
    const char *name;
    const char *symbol;
  };

  // Which of these functions LIGGGHTS would not take from this library, and from where
  // instead; empty if it takes all of them from here. The list ends with {NULL, NULL}
  std::string fault(const Function *functions);

  // The same for the functions of the loader. Those of another loader will do, as of a
  // preloaded one beside a coupling: they call each other in turn
  std::string loader_fault();

  // the program that runs, as a path
  std::string program();

  // why a LIGGGHTS that knows no `plugin` does so, as sentences: it does not call the
  // functions that lie first in the linker's search order
  extern const char *const own_calls;

}
}

#endif
