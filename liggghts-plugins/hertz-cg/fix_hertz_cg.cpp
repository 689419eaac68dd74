/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/fix_hertz_cg.h"
#include "host/fix_arguments.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixHertzCg::FixHertzCg(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), tangential_(true), rolling_(false), timestep_fraction_(0.0),
  timestep_error_(false), overlap_fraction_(0.1), search_(lmp), pairs_valid_(false),
  store_current_(true), forces_restarted_(false), rmax_(0.0), margin_(0.0),
  pairs_per_grain_(-1.0), search_step_(0), stream_(), freeze_bit_(0), collisions_(0.0),
  deep_(0.0), deepest_(0.0), deep_reported_(0.0), work_(0.0), found_(0.0), reduced_step_(-1)
{
  parse(narg, arg);

  vector_flag = 1;
  size_vector = 7;
  global_freq = 1;
  extvector = 0;
  restart_global = 1;
  restart_peratom = 1;
  create_attribute = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;

  if (!atom->sphere_flag || !atom->radius_flag || !atom->omega_flag || !atom->torque_flag)
    error->fix_error(FLERR, this, "needs `atom_style granular` (or sphere)");

  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

/* ---------------------------------------------------------------------- */

FixHertzCg::~FixHertzCg()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

/* ----------------------------------------------------------------------
   settings of the host go back only while the host still is there; at the end
   of the program it is taken down before its fixes
------------------------------------------------------------------------- */

void FixHertzCg::pre_delete(bool unfixflag)
{
  if (unfixflag) search_.restore();
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::parse(int narg, char **arg)
{
  grainjet::FixArguments in(error, narg, arg);
  while (in.more()) {
    const std::string keyword = in.word("keyword");
    if (keyword == "tangential") {
      const std::string model = in.word("model after 'tangential': history or off");
      if (model != "history" && model != "off")
        in.fail("tangential must be history or off, not '" + model + "'");
      tangential_ = model == "history";
    } else if (keyword == "rolling") {
      const std::string model = in.word("model after 'rolling': off or cdt");
      if (model != "off" && model != "cdt")
        in.fail("rolling must be off or cdt, not '" + model + "'");
      rolling_ = model == "cdt";
    } else if (keyword == "timestep_check") {
      nevery = in.count("number of steps after 'timestep_check'");
      timestep_fraction_ = in.positive("fraction after 'timestep_check'");
      const std::string action = in.word("'warn' or 'error' at the end of 'timestep_check'");
      if (action != "warn" && action != "error")
        in.fail("timestep_check must end with warn or error, not '" + action + "'");
      timestep_error_ = action == "error";
    } else if (keyword == "overlap_check") {
      overlap_fraction_ = in.positive("fraction after 'overlap_check'");
    } else {
      in.fail("unknown keyword '" + keyword
              + "'; known are tangential, rolling, timestep_check, overlap_check");
    }
  }
}

/* ---------------------------------------------------------------------- */

int FixHertzCg::setmask()
{
  int mask = POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | PRE_FORCE | POST_RUN;
  if (timestep_fraction_ > 0.0) mask |= END_OF_STEP;
  return mask;
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::init()
{
  // grains that are there have no contacts yet, or those of a restart file: not to be reset by the
  // host after the first forces
  just_created = 0;

  check_host();
  materials_.read(lmp, this, tangential_, rolling_);

  freeze_bit_ = 0;
  for (int i = 0; i < modify->nfix; ++i)
    if (strcmp(modify->fix[i]->style, "freeze") == 0) freeze_bit_ |= modify->fix[i]->groupbit;

  // also of grains that are still to be inserted
  double radius = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) radius = std::max(radius, atom->radius[i]);
  for (int i = 0; i < modify->nfix; ++i)
    if (modify->fix[i]->use_rad_for_cut_neigh_and_ghost())
      for (int type = 1; type <= atom->ntypes; ++type)
        radius = std::max(radius, modify->fix[i]->max_rad(type));
  MPI_Allreduce(&radius, &rmax_, 1, MPI_DOUBLE, MPI_MAX, world);
  check_sizes();

  walls_ = grainjet::find_walls(lmp);
  search_.choose(2.0 * rmax_, packing(), walls_);

  if (comm->me == 0)
    for (FILE *out : {screen, logfile})
      if (out)
        fprintf(out, "Fix %s (hertz/cg) searches up to %g beyond contact, walls list grains up to %g; "
                "`neighbor` and `neigh_modify delay` do not matter\n", id, search_.reach(), search_.skin());

  // A list that is never built: being handed it is the only call back from the host between
  // the moment it works out its cut-off (which the pair style would give) and its first use
  const int request = neighbor->request(this);
  neighbor->requests[request]->pair = 0;
  neighbor->requests[request]->fix = 1;
  neighbor->requests[request]->occasional = 1;
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::init_list(int, NeighList *)
{
  // undefined until the host's neighbour lists are initialised, which is now
  if (neighbor->exclude_setting())
    error->fix_error(FLERR, this, "does not know `neigh_modify exclude`; use its group instead");
  search_.set_cutoff();
}

/* ----------------------------------------------------------------------
   what the host must and must not have defined; every message says what to do
------------------------------------------------------------------------- */

void FixHertzCg::check_host()
{
  if (force->pair) {
    const std::string message = std::string("computes the contacts itself, but `pair_style ")
      + force->pair_style + "` is defined too; remove one of them (after read_restart: `pair_style none`)";
    error->fix_error(FLERR, this, message.c_str());
  }
  if (modify->n_fixes_style_strict("hertz/cg") > 1)
    error->fix_error(FLERR, this, "is defined twice; contacts would act twice");
  if (modify->n_fixes_style("rigid") + modify->n_fixes_style("multisphere") > 0)
    error->fix_error(FLERR, this, "does not know rigid bodies or multispheres");
  if (force->newton_pair) error->fix_error(FLERR, this, "needs `newton off`");
  if (!comm->ghost_velocity) error->fix_error(FLERR, this, "needs `communicate single vel yes`");
  if (force->nktv2p != 1.0)
    error->fix_error(FLERR, this, "needs consistent units: `units si`, cgs or lj");
  if (domain->triclinic) error->fix_error(FLERR, this, "needs an orthogonal box");
  if (update->whichflag == 2) error->fix_error(FLERR, this, "cannot be used with minimize");
  if (strcmp(update->integrate_style, "respa") == 0)
    error->fix_error(FLERR, this, "needs `run_style verlet`");
  if (neighbor->build_once)
    error->fix_error(FLERR, this, "cannot be used with `neigh_modify once yes`");
  if (atom->radvary_flag) error->fix_error(FLERR, this, "needs grains of constant radius");
  for (int i = 0; i < modify->nfix; ++i)
    if (modify->fix[i]->box_change_size || modify->fix[i]->box_change_shape)
      error->fix_error(FLERR, this, "needs a box that no other fix deforms");
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::check_sizes()
{
  double width = HUGE_VAL, smallest;
  for (int d = 0; d < 3; ++d)
    if (comm->procgrid[d] > 1 || domain->periodicity[d])
      width = std::min(width, domain->subhi[d] - domain->sublo[d]);
  MPI_Allreduce(&width, &smallest, 1, MPI_DOUBLE, MPI_MIN, world);
  if (2.0 * rmax_ <= smallest) return;
  std::ostringstream message;
  message << "grains of diameter " << 2.0 * rmax_ << " are larger than a rank's part of the box, "
          << smallest << "; use fewer ranks, `processors`, or a larger box";
  error->fix_error(FLERR, this, message.str().c_str());
}

/* ----------------------------------------------------------------------
   volume fraction of grains where there are grains: in cubes of eight diameters that hold some.
   A bed in a tall box is as dense as in a small one.
------------------------------------------------------------------------- */

double FixHertzCg::packing() const
{
  const double cube = 16.0 * rmax_;
  double sum[2] = {0.0, 0.0};
  std::vector<std::array<std::int64_t, 3>> cubes(atom->nlocal);
  for (int i = 0; i < atom->nlocal; ++i) {
    sum[0] += 4.0 / 3.0 * 3.14159265358979323846 * std::pow(atom->radius[i], 3);
    for (int d = 0; d < 3; ++d)
      cubes[i][d] = static_cast<std::int64_t>(std::floor((atom->x[i][d] - domain->boxlo[d]) / cube));
  }
  std::sort(cubes.begin(), cubes.end());
  sum[1] = (std::unique(cubes.begin(), cubes.end()) - cubes.begin()) * cube * cube * cube;
  MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, world);
  return sum[1] > 0.0 ? sum[0] / sum[1] : 0.0;
}

/* ---------------------------------------------------------------------- */

double FixHertzCg::extend_cut_ghost()
{
  return search_.ghosts();
}

/* ---------------------------------------------------------------------- */

double FixHertzCg::memory_usage()
{
  return static_cast<double>(pairs_.bytes() + store_.bytes() + motion_.bytes());
}
