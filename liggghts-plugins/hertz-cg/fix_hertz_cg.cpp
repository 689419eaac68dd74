/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/fix_hertz_cg.h"
#include "hertz-cg/pair_hertz_cg.h"

#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "integrate.h"
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
  Fix(lmp, narg, arg), timestep_fraction_(0.0), timestep_error_(false), overlap_fraction_(0.1),
  search_(lmp), stand_in_(nullptr), pairs_valid_(false), store_current_(true), forces_restarted_(false),
  rmax_(0.0), margin_(0.0), pairs_per_grain_(-1.0), search_step_(0), elapsed_(0.0), counted_step_(0), step_size_(0.0), expired_(false), work_done_(), stream_(),
  freeze_bit_(0), grows_(false), growth_(0.0), collisions_(0.0),
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

  store_.keepRollingSpring(law_.rollingSpring());
  if (domain->dimension == 2) law_.rollingInertia = grainjet::contact::DISC_ROLLS;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

/* ----------------------------------------------------------------------
   not before the host's list of fixes holds this one: a pair style looks through it
------------------------------------------------------------------------- */

void FixHertzCg::post_create_pre_restart()
{
  if (!force->pair) stand_in();
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
  if (!unfixflag) return;
  search_.restore();
  remove_stand_in();
}

/* ----------------------------------------------------------------------
   the place of the pair style, for all who ask it for contacts
------------------------------------------------------------------------- */

static void name_pair_style(Force *force, const char *name)
{
  delete [] force->pair_style;
  force->pair_style = strcpy(new char[strlen(name) + 1], name);
}

void FixHertzCg::stand_in()
{
  stand_in_ = new PairHertzCg(lmp, this);
  force->pair = stand_in_;
  name_pair_style(force, "gran");
}

void FixHertzCg::remove_stand_in()
{
  if (!stand_in_) return;
  delete stand_in_;
  force->pair = nullptr;
  name_pair_style(force, "none");
}

/* ---------------------------------------------------------------------- */

int FixHertzCg::setmask()
{
  int mask = POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | POST_RUN;
  if (timestep_fraction_ > 0.0) mask |= END_OF_STEP;
  return mask;
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::init()
{
  step_size_ = update->dt;
  // those of a restart file that the script has not defined again
  observers_.removeAbsent(store_, pairs_);

  // grains that are there have no contacts yet, or those of a restart file: not to be reset by the
  // host after the first forces
  just_created = 0;

  // `pair_style none` came after the fix: what the host has done for the pair style so far is done again
  if (!force->pair) {
    stand_in();
    force->pair->init();
    update->integrate->init();
  } else {
    check_host();
  }

  freeze_bit_ = 0;
  for (int i = 0; i < modify->nfix; ++i)
    if (strcmp(modify->fix[i]->style, "freeze") == 0) freeze_bit_ |= modify->fix[i]->groupbit;

  grows_ = find_growth();
  growth_ = 0.0;
  const std::vector<double> radius = largest_radii();
  rmax_ = *std::max_element(radius.begin(), radius.end());
  check_sizes();
  // an empty box touches nothing, and the host does not know its materials
  if (rmax_ > 0.0) materials_.read(lmp, this, law_);

  bool through = modify->n_fixes_style("continuum/weighted") + modify->n_fixes_style("fiber/") > 0;
  for (int i = 0; i < modify->ncompute; ++i)
    through = through || strcmp(modify->compute[i]->style, "contact/atom/gran") == 0;
  search_.require_skin(through);

  walls_ = grainjet::find_walls(lmp);
  search_.choose(radius, packing(), walls_);

  if (comm->me == 0)
    for (FILE *out : {screen, logfile})
      if (out)
        fprintf(out, "Fix %s (hertz/cg) searches up to %g beyond contact, walls list grains up to %g at first; "
                "`neighbor` limits the latter for mesh walls, `neigh_modify delay` does not matter\n",
                id, search_.reach(), search_.skin());

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
    error->fix_error(FLERR, this, "does not know `neigh_modify exclude`; say `neigh_modify exclude none` "
                     "and give the fix a group: only grains of it touch each other");
  search_.set_cutoff();
}

/* ----------------------------------------------------------------------
   what the host must and must not have defined; every message says what to do
------------------------------------------------------------------------- */

void FixHertzCg::check_host()
{
  if (force->pair != stand_in_) {
    const std::string message = std::string("computes the contacts itself, but `pair_style ")
      + force->pair_style + "` is defined too; remove one of them (after read_restart: `pair_style none`)";
    error->fix_error(FLERR, this, message.c_str());
  }
  if (modify->n_fixes_style_strict("hertz/cg") > 1)
    error->fix_error(FLERR, this, "is defined twice; contacts would act twice");
  if (modify->n_fixes_style("rigid") + modify->n_fixes_style("multisphere") > 0)
    error->fix_error(FLERR, this, "does not know rigid bodies or multispheres; use `pair_style gran` for them");
  if (modify->n_fixes_style("multicontact") > 0)
    error->fix_error(FLERR, this, "does not know fix multicontact/halfspace, which needs the stock pair style with "
                     "`surface multicontact`");
  if (modify->n_fixes_style("heat/gran") > 0 && force->cg_active())
    error->cg(FLERR, "fix heat/gran, whose conduction goes with the size of a grain and not with f_cg");
  if (force->newton_pair) error->fix_error(FLERR, this, "needs `newton off`");
  if (!comm->ghost_velocity) error->fix_error(FLERR, this, "needs `communicate single vel yes`");
  if (force->nktv2p != 1.0)
    error->fix_error(FLERR, this, "needs consistent units: `units si`, cgs or lj");
  if (domain->triclinic) error->fix_error(FLERR, this, "needs an orthogonal box: `region ... block`, not prism");
  if (update->whichflag == 2)
    error->fix_error(FLERR, this, "cannot be used with `minimize`; let the grains settle in a `run`, with `fix viscous`");
  if (strcmp(update->integrate_style, "respa") == 0)
    error->fix_error(FLERR, this, "needs `run_style verlet`");
  if (neighbor->build_once)
    error->fix_error(FLERR, this, "cannot be used with `neigh_modify once yes`; leave it out: searches come when they are due");
  if (neighbor->includegroup)
    error->fix_error(FLERR, this, "does not know `neigh_modify include`, which leaves forces of other grains uncleared; "
                     "say `neigh_modify include all` and give the fix the group");
  const int ghosts = search_.ghost_group();
  if (ghosts && groupbit != group->bitmask[ghosts]) {
    const std::string message = std::string("would lose contacts between ranks with `communicate ... group ")
      + group->names[ghosts] + "`; say `communicate single group all vel yes`, or give the fix this group";
    error->fix_error(FLERR, this, message.c_str());
  }
  for (int i = 0; i < modify->nfix; ++i)
    if (modify->fix[i]->box_change_size || modify->fix[i]->box_change_shape)
      error->fix_error(FLERR, this, (std::string("needs a box that no other fix deforms; remove fix ")
                                     + modify->fix[i]->id + " (" + modify->fix[i]->style + ")").c_str());
}

/* ----------------------------------------------------------------------
   volume fraction of grains where there are grains: in cubes of eight diameters that hold some.
   A bed in a tall box is as dense as in a small one.
------------------------------------------------------------------------- */

double FixHertzCg::packing() const
{
  if (rmax_ <= 0.0) return 0.0;
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
