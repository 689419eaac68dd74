/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Another library that defines a function of LIGGGHTS (SYMBOL is its name for the linker), as a
   tool for debugging may. It ends the program: the tests want an error before it is called. */

#include <stdlib.h>

extern "C" void SYMBOL()
{
  abort();
}
