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
#include "fix_property_atom.h"
#include "modify.h"

#include <algorithm>
#include <limits>

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

RemovedGrains::RemovedGrains(LAMMPS *lmp) : Pointers(lmp), heat_(NULL), temperature_(NULL) {}

/* ---------------------------------------------------------------------- */

void RemovedGrains::act_first(int ifix)
{
  int *first = modify->*member(grainjet::PreExchangeList());
  int *last = first + modify->*member(grainjet::PreExchangeCount());
  int *own = std::find(first, last, ifix);
  if (own != last) std::rotate(first, own, own + 1);
}

/* ---------------------------------------------------------------------- */

RemovedGrains::Box::Box(const Domain *domain)
{
  const int FIXED = 1;    // of Domain::boundary; shrink-wrapped faces move instead
  const double FAR = std::numeric_limits<double>::infinity();
  for (int dim = 0; dim < 3; dim++) {
    low[dim] = domain->boundary[dim][0] == FIXED ? domain->boxlo[dim] : -FAR;
    high[dim] = domain->boundary[dim][1] == FIXED ? domain->boxhi[dim] : FAR;
    if (low[dim] > -FAR || high[dim] < FAR) open = true;
  }
}

/* ----------------------------------------------------------------------
   A grain may be marked by two fixes.
------------------------------------------------------------------------- */

bool RemovedGrains::find_marked()
{
  marked_.assign(atom->nlocal, 0);
  bool any = false;
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const std::vector<int> *tags = grainjet::marked_tags(modify->fix[ifix]);
    if (!tags) continue;
    for (int tag : *tags) {
      const int i = atom->map(tag);
      if (i >= 0 && i < atom->nlocal) {
        marked_[i] = 1;
        any = true;
      }
    }
  }
  return any;
}

/* ----------------------------------------------------------------------
   The two fixes lie in plugins of their own and share what LIGGGHTS keeps: the properties
------------------------------------------------------------------------- */

void RemovedGrains::find_heat()
{
  heat_ = temperature_ = NULL;
  if (!modify->find_fix_style("fluid/heat", 0)) return;
  const auto values = [this](const char *name) {
    return static_cast<FixPropertyAtom *>(
      modify->find_fix_property(name, "property/atom", "scalar", 0, 0, "fluid/force"))->vector_atom;
  };
  heat_ = values("fluidHeat");
  temperature_ = values("Temp");
}

/* ----------------------------------------------------------------------
   A marked grain beyond the boundary is deleted before the exchange between ranks drops it. This is
   called whenever lists are made: grains that nothing can remove are not looked at.
------------------------------------------------------------------------- */

void RemovedGrains::collect(const FluidForceExchange &state, bool deleting, double halfKick,
  const double *const *nonReacting, const double *powerGrowth)
{
  const Box box(domain);
  const bool marked = deleting && find_marked();
  if (!marked && !box.open) return;
  find_heat();

  const int nlocal = atom->nlocal;
  const double *const *x = atom->x;
  for (int i = 0; i < nlocal; i++) {
    const bool deleted = marked && marked_[i];
    if (!deleted && !box.outside(x[i])) continue;
    record(i, deleted ? FluidForceExchange::DELETED : FluidForceExchange::LEFT_BOX, state,
      halfKick, nonReacting ? nonReacting[i] : NULL, powerGrowth ? &powerGrowth[i] : NULL);
  }
}

/* ---------------------------------------------------------------------- */

void RemovedGrains::record(int i, FluidForceExchange::Fate fate, const FluidForceExchange &state,
  double halfKick, const double *nonReacting, const double *powerGrowth)
{
  FluidForceExchange::Removed grain;
  grain.tag = atom->tag[i];
  grain.mass = atom->rmass[i];
  grain.radius = atom->radius[i];
  grain.fate = fate;
  grain.heat = heat_ ? heat_[i] : 0.0;
  grain.temperature = temperature_ ? temperature_[i] : 0.0;
  grain.work = powerGrowth ? state.work[i] - 0.5 * halfKick * halfKick * *powerGrowth : 0.0;
  for (int dim = 0; dim < 3; dim++) {
    grain.position[dim] = atom->x[i][dim];
    grain.startPosition[dim] = state.startPosition[i][dim];
    grain.velocity[dim] = atom->v[i][dim];
    grain.owner[dim] = state.owner[i][dim];
    const double without = nonReacting ? nonReacting[dim] : 0.0;
    grain.impulse[dim] = state.impulse[i][dim] + halfKick * (state.fluidForce[i][dim] - without);
    grain.nonReactingImpulse[dim] = state.nonReactingImpulse
      ? state.nonReactingImpulse[i][dim] + halfKick * without : 0.0;
    if (powerGrowth) grain.work += halfKick * (state.fluidForce[i][dim] - without) * grain.velocity[dim];
  }
  grains_.push_back(grain);
}
