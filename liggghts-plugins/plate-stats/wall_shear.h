/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WALL_SHEAR_H
#define GRAINJET_WALL_SHEAR_H

namespace LAMMPS_NS {

class FixWallGran;

// a primitive wall has the keyword shear
bool wall_shears(const FixWallGran *);

// Velocity (m/s) of such a wall at x, as FixWallGran::post_force_primitive gives it to the
// law; velocity must be 0 before
void wall_shear(FixWallGran *, double *x, double *velocity);

}

#endif
