/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A plugin from a time when plugins stated no version of Grainjet and described themselves
   otherwise: whoever reads its description as that of today takes a number for a text. */

namespace {

struct Description {
  long styles;
  long pointer;
};

const Description description = {1, 8};

}

extern "C" const void *liggghtsplugin_init()
{
  return &description;
}
