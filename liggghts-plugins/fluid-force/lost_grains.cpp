/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "lost_grains.h"
#include "marked_grains.h"

#include "host/expose_member.h"

#include "atom.h"
#include "domain.h"
#include "fix_massflow_mesh.h"
#include "modify.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace grainjet {

struct PreExchangeList {
  using type = int *Modify::*;
  friend type member(PreExchangeList);
};

struct PreExchangeCount {
  using type = int Modify::*;
  friend type member(PreExchangeCount);
};

struct MarkedTags {
  using type = std::vector<int> FixMassflowMesh::*;
  friend type member(MarkedTags);
};

}

template struct grainjet::Expose<grainjet::PreExchangeList, &Modify::list_pre_exchange>;
template struct grainjet::Expose<grainjet::PreExchangeCount, &Modify::n_pre_exchange>;
template struct grainjet::Expose<grainjet::MarkedTags, &FixMassflowMesh::atom_tags_delete_>;

/* ---------------------------------------------------------------------- */

std::vector<int> *grainjet::marked_tags(Fix *fix)
{
  FixMassflowMesh *counter = dynamic_cast<FixMassflowMesh *>(fix);
  return counter ? &(counter->*member(MarkedTags())) : NULL;
}

/* ---------------------------------------------------------------------- */

LostGrains::LostGrains(LAMMPS *lmp) : Pointers(lmp) {}

/* ---------------------------------------------------------------------- */

void LostGrains::act_first(int ifix)
{
  int *first = modify->*member(grainjet::PreExchangeList());
  int *last = first + modify->*member(grainjet::PreExchangeCount());
  int *own = std::find(first, last, ifix);
  if (own != last) std::rotate(first, own, own + 1);
}

/* ---------------------------------------------------------------------- */

bool LostGrains::outside(const double *x) const
{
  const int FIXED = 1;    // of Domain::boundary; shrink-wrapped faces move instead
  for (int dim = 0; dim < 3; dim++) {
    if (domain->boundary[dim][0] == FIXED && x[dim] < domain->boxlo[dim]) return true;
    if (domain->boundary[dim][1] == FIXED && x[dim] >= domain->boxhi[dim]) return true;
  }
  return false;
}

/* ---------------------------------------------------------------------- */

void LostGrains::collect_marked(const FluidForceExchange &state, double halfKick)
{
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const std::vector<int> *tags = grainjet::marked_tags(modify->fix[ifix]);
    if (!tags) continue;
    for (int tag : *tags) {
      const int i = atom->map(tag);
      if (i >= 0 && i < atom->nlocal && !outside(atom->x[i])) record(i, state, halfKick);
    }
  }
}

/* ---------------------------------------------------------------------- */

void LostGrains::collect_outside(const FluidForceExchange &state, double halfKick)
{
  for (int i = 0; i < atom->nlocal; i++)
    if (outside(atom->x[i])) record(i, state, halfKick);
}

/* ---------------------------------------------------------------------- */

void LostGrains::record(int i, const FluidForceExchange &state, double halfKick)
{
  FluidForceExchange::Lost grain;
  grain.tag = atom->tag[i];
  grain.mass = atom->rmass[i];
  grain.radius = atom->radius[i];
  for (int dim = 0; dim < 3; dim++) {
    grain.position[dim] = atom->x[i][dim];
    grain.startPosition[dim] = state.startPosition[i][dim];
    grain.velocity[dim] = atom->v[i][dim];
    grain.impulse[dim] = state.impulse[i][dim] + halfKick * state.fluidForce[i][dim];
  }
  grain.host[0] = state.host[i][0];
  grain.host[1] = state.host[i][1];
  grains_.push_back(grain);
}
