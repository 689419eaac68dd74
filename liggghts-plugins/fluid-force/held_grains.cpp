/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "held_grains.h"

#include "atom.h"
#include "fix_property_atom.h"
#include "modify.h"

using namespace LAMMPS_NS;

static const int RELEASE_STEP = 4;

/* ---------------------------------------------------------------------- */

void HeldGrains::init()
{
  release_ = static_cast<FixPropertyAtom *>(modify->find_fix_property(
    "release_fix_insert_stream", "property/atom", "vector", 5, 0, "fluid/force", false));
  stale_ = true;
}

/* ---------------------------------------------------------------------- */

void HeldGrains::update(bigint first)
{
  first_ = first;
  if (!stale_) return;
  stale_ = false;
  candidates_.assign(atom->nlocal, 0);
  if (!release_) return;
  for (int i = 0; i < atom->nlocal; i++) candidates_[i] = still_held(i);
}

/* ---------------------------------------------------------------------- */

bool HeldGrains::still_held(int i) const
{
  return release_->array_atom[i][RELEASE_STEP] >= static_cast<double>(first_);
}
