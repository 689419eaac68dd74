/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "removed_grains.h"
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

RemovedGrains::RemovedGrains(LAMMPS *lmp) : Pointers(lmp) {}

/* ---------------------------------------------------------------------- */

void RemovedGrains::act_first(int ifix)
{
  int *first = modify->*member(grainjet::PreExchangeList());
  int *last = first + modify->*member(grainjet::PreExchangeCount());
  int *own = std::find(first, last, ifix);
  if (own != last) std::rotate(first, own, own + 1);
}

/* ---------------------------------------------------------------------- */

bool RemovedGrains::outside(const double *x) const
{
  const int FIXED = 1;    // of Domain::boundary; shrink-wrapped faces move instead
  for (int dim = 0; dim < 3; dim++) {
    if (domain->boundary[dim][0] == FIXED && x[dim] < domain->boxlo[dim]) return true;
    if (domain->boundary[dim][1] == FIXED && x[dim] >= domain->boxhi[dim]) return true;
  }
  return false;
}

/* ----------------------------------------------------------------------
   A grain may be marked by two fixes.
------------------------------------------------------------------------- */

void RemovedGrains::find_marked()
{
  marked_.assign(atom->nlocal, 0);
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const std::vector<int> *tags = grainjet::marked_tags(modify->fix[ifix]);
    if (!tags) continue;
    for (int tag : *tags) {
      const int i = atom->map(tag);
      if (i >= 0 && i < atom->nlocal) marked_[i] = 1;
    }
  }
}

/* ----------------------------------------------------------------------
   A marked grain beyond the boundary is deleted before the exchange between ranks drops it.
------------------------------------------------------------------------- */

void RemovedGrains::collect(const FluidForceExchange &state, bool deleting, double halfKick,
  const double *const *nonReacting)
{
  if (deleting) find_marked();
  else marked_.assign(atom->nlocal, 0);

  for (int i = 0; i < atom->nlocal; i++) {
    if (!marked_[i] && !outside(atom->x[i])) continue;
    record(i, marked_[i] ? FluidForceExchange::DELETED : FluidForceExchange::LEFT_BOX, state,
      halfKick, nonReacting ? nonReacting[i] : NULL);
  }
}

/* ---------------------------------------------------------------------- */

void RemovedGrains::record(int i, FluidForceExchange::Fate fate, const FluidForceExchange &state,
  double halfKick, const double *nonReacting)
{
  FluidForceExchange::Removed grain;
  grain.tag = atom->tag[i];
  grain.mass = atom->rmass[i];
  grain.radius = atom->radius[i];
  grain.fate = fate;
  for (int dim = 0; dim < 3; dim++) {
    grain.position[dim] = atom->x[i][dim];
    grain.startPosition[dim] = state.startPosition[i][dim];
    grain.velocity[dim] = atom->v[i][dim];
    grain.owner[dim] = state.owner[i][dim];
    const double without = nonReacting ? nonReacting[dim] : 0.0;
    grain.impulse[dim] = state.impulse[i][dim] + halfKick * (state.fluidForce[i][dim] - without);
    grain.nonReactingImpulse[dim] = state.nonReactingImpulse
      ? state.nonReactingImpulse[i][dim] + halfKick * without : 0.0;
  }
  grains_.push_back(grain);
}
