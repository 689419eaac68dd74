/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix hertz/cg: sizes of the grains, and grains that change theirs during a run (`fix adapt ... diameter`,
   or a fix that says so to the host). Every change asks for a search in the next step, which also tells the sizes to
   other ranks; contacts go by the sizes of the moment in between. */

#include "hertz-cg/fix_hertz_cg.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_adapt.h"
#include "modify.h"
#include "neighbor.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   may grains change their size during this run?
------------------------------------------------------------------------- */

bool FixHertzCg::find_growth() const
{
  for (int i = 0; i < modify->nfix; ++i) {
    const FixAdapt *adapt = dynamic_cast<FixAdapt *>(modify->fix[i]);
    if (adapt && adapt->diamflag) return true;
  }
  return atom->radvary_flag != 0;
}

/* ----------------------------------------------------------------------
   radius of the largest grain of each type [m], on all ranks, also of grains that are still to be inserted
------------------------------------------------------------------------- */

std::vector<double> FixHertzCg::largest_radii() const
{
  std::vector<double> radius(atom->ntypes + 1, 0.0);
  for (int i = 0; i < atom->nlocal; ++i)
    radius[atom->type[i]] = std::max(radius[atom->type[i]], atom->radius[i]);
  for (int i = 0; i < modify->nfix; ++i)
    if (modify->fix[i]->use_rad_for_cut_neigh_and_ghost())
      for (int type = 1; type <= atom->ntypes; ++type)
        radius[type] = std::max(radius[type], modify->fix[i]->max_rad(type));
  MPI_Allreduce(MPI_IN_PLACE, radius.data(), atom->ntypes + 1, MPI_DOUBLE, MPI_MAX, world);
  return radius;
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::check_sizes()
{
  const double smallest = search_.narrowest();
  if (2.0 * rmax_ <= smallest) return;
  std::ostringstream message;
  message << "grains of diameter " << 2.0 * rmax_ << " are larger than a rank's part of the box, or than a periodic box, "
          << smallest << "; use fewer ranks, `processors`, or a larger box";
  error->fix_error(FLERR, this, message.str().c_str());
}

/* ----------------------------------------------------------------------
   Before ghosts are fetched. Sizes are taken a little larger than they are, so that not every search sets
   up the host's communication anew. Ranks share triangles of meshes by the sizes at the start of a run.
------------------------------------------------------------------------- */

bool FixHertzCg::follow_sizes()
{
  if (!grows_) return false;
  std::vector<double> radius = largest_radii();
  if (!search_.outgrown(radius)) return false;
  if (walls_.mesh && comm->nprocs > 1)
    error->fix_error(FLERR, this, "grains have outgrown the largest size at the start of the run, by which ranks share the "
                     "triangles of mesh walls; divide it into several runs, or use one rank");
  for (double &r : radius) r *= 1.05;
  rmax_ = *std::max_element(radius.begin(), radius.end());
  check_sizes();
  search_.grow(radius);
  return true;
}

/* ----------------------------------------------------------------------
   at a search: sizes from which growth is counted
------------------------------------------------------------------------- */

void FixHertzCg::hold_sizes()
{
  if (!grows_) return;
  held_.assign(atom->radius, atom->radius + atom->nlocal);
}

/* ----------------------------------------------------------------------
   Has a grain another size than at the last search? What one change has brought is kept free of the margins:
   it comes between two searches, after the second has been missed.
------------------------------------------------------------------------- */

bool FixHertzCg::sizes_changed()
{
  if (!grows_ || held_.size() != static_cast<std::size_t>(atom->nlocal)) return grows_;
  double change = 0.0;
  bool changed = false;
  for (int i = 0; i < atom->nlocal; ++i) {
    changed |= atom->radius[i] != held_[i];
    change = std::max(change, atom->radius[i] - held_[i]);
  }
  growth_ = std::max(growth_, change);
  return changed;
}
