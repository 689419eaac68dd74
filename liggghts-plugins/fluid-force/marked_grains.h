/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_MARKED_GRAINS_H
#define GRAINJET_MARKED_GRAINS_H

#include <vector>

namespace LAMMPS_NS { class Fix; }

namespace grainjet {

/* IDs of this rank's grains that a fix massflow/mesh will delete when lists are made next, in this
   order; NULL if the fix is of another style.                                                */
std::vector<int> *marked_tags(LAMMPS_NS::Fix *);

}

#endif
