/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef COMMAND_CLASS

CommandStyle(coarsegraining,CoarseGrainingCommand)

#else

#ifndef LMP_COARSEGRAINING_H
#define LMP_COARSEGRAINING_H

#include "pointers.h"

#include <string>

namespace LAMMPS_NS {

/* States the coarse-graining factor f_cg of all grains, or one factor per atom type:

     coarsegraining f [f2 ... fn] [model_check error|warn]

   Afterwards radii in particle templates, the `neighbor` skin and bin sizes are those of the
   particles and LIGGGHTS multiplies them by f_cg. To be given once, before templates and before
   or after the box. Each factor has to be from 1 to 1e6. Several factors have to be as many as
   there are atom types; if the box comes later, the command that makes it is an error else.
   The public LIGGGHTS carries the factor but lacks the command.
   model_check: what a stock model does that LIGGGHTS takes for inconsistent with coarse graining,
   end the run (default) or warn.                                                            */
class CoarseGrainingCommand : protected Pointers {
 public:
  explicit CoarseGrainingCommand(class LAMMPS *lmp) : Pointers(lmp) {}
  void command(int, char **);

  // With a box: one factor becomes that of every atom type; several have to be as many as
  // there are types. Nothing if none was stated.
  void settle_number();

 private:
  void settle_when_box_is_made();
  [[noreturn]] void fail(const std::string &message);
};

}

#endif
#endif
