/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Another library that defines functions of LIGGGHTS, as a tool for debugging may. Each function
   ends the program: the tests want an error before one of them is called.                 */

#include <stdlib.h>

extern "C" {

// LAMMPS_NS::LAMMPS::create(), which the loader takes the place of
void _ZN9LAMMPS_NS6LAMMPS6createEv()
{
  abort();
}

// LAMMPS_NS::Error::all(const char *, int, const char *), of the coupling
void _ZN9LAMMPS_NS5Error3allEPKciS2_()
{
  abort();
}

}
