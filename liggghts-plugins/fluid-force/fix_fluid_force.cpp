/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_fluid_force.h"

#include "host/fix_arguments.h"
#include "physics/drag/exponential_drag.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_property_atom.h"
#include "modify.h"
#include "update.h"

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::FixArguments;
using grainjet::drag::ExponentialDrag;

/* ---------------------------------------------------------------------- */

FixFluidForce::FixFluidForce(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg),
  coupled_(false),
  fluidVelocity_(NULL), dragCoefficient_(NULL), explicitForce_(NULL), impulse_(NULL),
  fluidForce_(NULL), startPosition_(NULL), host_(NULL), fluidTorque_(NULL),
  exchange_(), lost_(lmp), doorOpen_(false), running_(lmp), held_(lmp),
  freshSetup_(false), sumStep_(-1), sums_()
{
  parse(narg, arg);

  // the per-grain state has fixed names, so there can be one such fix only
  const FixArguments arguments(error, narg, arg);
  for (int ifix = 0; ifix < modify->nfix; ifix++)
    if (modify->fix[ifix] && strcmp(modify->fix[ifix]->style, style) == 0)
      arguments.fail(std::string("there is already one with ID ") + modify->fix[ifix]->id
        + "; let one fix fluid/force act on all grains that feel the fluid");
  if (!atom->sphere_flag) arguments.fail("requires atom_style granular (spheres)");
  if (domain->dimension != 3) arguments.fail("requires a 3d simulation");
  if (coupled_ && domain->triclinic) arguments.fail("coupled requires an orthogonal box");
  if (strcmp(update->unit_style, "si") != 0) arguments.fail("requires units si");

  create_attribute = coupled_ ? 1 : 0;
  restart_global = restart_peratom = restart_file = coupled_ ? 1 : 0;
  vector_flag = 1;
  size_vector = 4;
  global_freq = 1;
  extvector = 0;

  if (!coupled_) return;
  atom->add_callback(0);
  atom->add_callback(1);
}

/* ---------------------------------------------------------------------- */

FixFluidForce::~FixFluidForce()
{
  if (!coupled_) return;
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::parse(int narg, char **arg)
{
  FixArguments arguments(error, narg, arg);
  const std::string kind = arguments.word("style: coupled or uniform");
  if (kind == "coupled") {
    coupled_ = true;
    if (arguments.more())
      arguments.fail("style coupled takes no keywords, found '" + arguments.word("") + "'");
    return;
  }
  if (kind != "uniform")
    arguments.fail("unknown style '" + kind + "'; valid styles are coupled, uniform");

  uniform_.reset(new UniformFlow(lmp, arguments));
}

/* ---------------------------------------------------------------------- */

int FixFluidForce::setmask()
{
  // The force is added in pre_final_integrate, which runs after all fixes' post_force:
  // so it acts last whatever the order of the fixes in the script.
  int mask = PRE_INITIAL_INTEGRATE | PRE_NEIGHBOR | PRE_FINAL_INTEGRATE;
  if (coupled_) mask |= PRE_EXCHANGE | PRE_FORCE;
  return mask;
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::post_create()
{
  dragCoefficient_ = property("fluidDragCoefficient", 1, "0.");
  impulse_ = property("fluidImpulse", 3, "0.");
  fluidForce_ = property("fluidForce", 3, "0.");
  if (uniform_ && uniform_->rotation()) fluidTorque_ = property("fluidTorque", 3, "0.");
  if (coupled_) {
    fluidVelocity_ = property("fluidVelocity", 3, "0.");
    explicitForce_ = property("fluidExplicitForce", 3, "0.");
    host_ = property("fluidHost", 2, "-1.");

    // its initial value is the grain's own position: set_arrays() does that
    startPosition_ = property("fluidStartPosition", 3, "none");
    if (!startPosition_->recent_restart)
      for (int i = 0; i < atom->nlocal; i++) set_arrays(i);
  }

  // What is there has its initial state now. Modify::setup would set it once more and
  // so wipe out what was written before the first run.
  just_created = 0;
}

/* ----------------------------------------------------------------------
   a stock fix property/atom with restart and without ghosts
------------------------------------------------------------------------- */

FixPropertyAtom *FixFluidForce::property(const char *name, int size, const char *value)
{
  std::vector<const char *> args = {name, "all", "property/atom", name,
    size == 1 ? "scalar" : "vector", "yes", "no", "no"};
  args.insert(args.end(), size, value);
  FixPropertyAtom *fix = modify->add_fix_property_atom(
    args.size(), const_cast<char **>(args.data()), style);
  fix->just_created = 0;
  return fix;
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::pre_delete(bool unfixflag)
{
  if (!unfixflag) return;
  for (FixPropertyAtom *fix : {dragCoefficient_, impulse_, fluidForce_, fluidTorque_,
      fluidVelocity_, explicitForce_, host_, startPosition_})
    if (fix) modify->delete_fix(fix->id);
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::init()
{
  if (strstr(update->integrate_style, "respa"))
    error->all(FLERR, "Fix fluid/force does not work with run_style respa, use verlet");

  if (uniform_) uniform_->init();
  held_.init();
  check_other_fixes();
  if (coupled_) lost_.act_first(modify->find_fix(id));
}

/* ----------------------------------------------------------------------
   velocity Verlet must be what moves the grains, since the impulse books its kicks
------------------------------------------------------------------------- */

void FixFluidForce::check_other_fixes()
{
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const Fix *other = modify->fix[ifix];
    const bool clumps = other->rigid_flag || strncmp(other->style, "multisphere", 11) == 0;
    const bool frozen = strcmp(other->style, "freeze") == 0;
    if (!clumps && !frozen) continue;

    int mine = 0, any = 0;
    for (int i = 0; i < atom->nlocal; i++)
      if ((atom->mask[i] & groupbit) && (atom->mask[i] & other->groupbit)) mine = 1;
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
    if (any) {
      const std::string text = std::string("Fix fluid/force: its group has grains that fix ")
        + other->style + " (ID " + other->id + ") holds; give fluid/force a group without them";
      error->all(FLERR, text.c_str());
    }
  }
}

/* ----------------------------------------------------------------------
   a new grain starts where it is inserted
------------------------------------------------------------------------- */

void FixFluidForce::set_arrays(int i)
{
  for (int dim = 0; dim < 3; dim++)
    startPosition_->array_atom[i][dim] = atom->x[i][dim];
  running_.forget(i);
}

/* ----------------------------------------------------------------------
   Forces of the set-up, for the first half kick and for output at step 0. Fixes that
   come later in the script have not added theirs yet: see pre_initial_integrate().
------------------------------------------------------------------------- */

void FixFluidForce::setup(int)
{
  held_.reorder();
  held_.update(update->ntimestep + 1);
  if (running_.resumes()) {
    running_.present_forces();
    running_.set_up();
    return;
  }
  apply(0.5 * update->dt, false, false);
  freshSetup_ = true;
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::pre_initial_integrate()
{
  if (running_.resumes()) {
    running_.present_forces();
    running_.finish();
  }
  if (!freshSetup_) return;
  apply(0.5 * update->dt, true, false);
  freshSetup_ = false;
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::pre_neighbor()
{
  held_.reorder();
  if (coupled_) running_.note_lists();
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::setup_pre_neighbor()
{
  if (!coupled_) return;
  running_.note_lists();
  if (running_.resumes()) running_.lists_made();
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::setup_pre_force(int)
{
  if (running_.resumes()) running_.to_present();
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::pre_final_integrate()
{
  held_.update(update->ntimestep);
  apply(update->dt, false, true);
}

/* ----------------------------------------------------------------------
   Adds the fluid force to all grains.
   kick: time over which the integrator applies it; remove: take the previous one off
   first; book: add the impulse of the half kick before and the half kick to come
------------------------------------------------------------------------- */

void FixFluidForce::apply(double kick, bool remove, bool book)
{
  sumStep_ = -1;    // on all ranks alike, also on one without grains
  const int nlocal = atom->nlocal;
  if (nlocal == 0) return;
  const double half = 0.5 * update->dt;
  double buoyancy[3];
  if (uniform_) uniform_->buoyancy(buoyancy);

  // The loop is bound by memory. LIGGGHTS' arrays of vectors are one block each, so their
  // rows need not be looked up.
  const double *velocities = atom->v[0];
  const double *fluids = coupled_ ? fluidVelocity_->array_atom[0] : NULL;
  const double *explicits = coupled_ ? explicitForce_->array_atom[0] : NULL;
  double *coefficient = dragCoefficient_->vector_atom;
  bool wrong = false;

  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const int first = 3 * i;
    double *f = atom->f[0] + first;
    double *applied = fluidForce_->array_atom[0] + first;
    double *impulse = impulse_->array_atom[0] + first;
    if (held_.holds(i)) {
      applied[0] = applied[1] = applied[2] = 0.0;
      continue;
    }
    const double *v = velocities + first;
    const double *fluid = coupled_ ? fluids + first : uniform_->velocity();

    double given[3], other[3];
    for (int dim = 0; dim < 3; dim++) {
      if (remove) f[dim] -= applied[dim];
      given[dim] = coupled_ ? explicits[first + dim]
        : buoyancy[dim] * UniformFlow::volume(atom->radius[i]);
      other[dim] = f[dim] + given[dim];
    }
    if (uniform_)
      coefficient[i] =
        uniform_->dragCoefficient(i, other, kick, book ? coefficient[i] : 0.0);

    const ExponentialDrag drag(coefficient[i], kick, atom->rmass[i]);
    for (int dim = 0; dim < 3; dim++) {
      const double force =
        given[dim] + drag.slip * (fluid[dim] - v[dim]) - drag.other * other[dim];
      f[dim] += force;
      wrong |= !(std::fabs(force) <= LARGEST_FORCE);    // also if it is no number
      if (book) impulse[dim] += half * (applied[dim] + force);
      applied[dim] = force;
    }
  }
  if (wrong) refuse_force();
  if (fluidTorque_) rotational_drag(kick, remove);
}

/* ---------------------------------------------------------------------- */

const double *FixFluidForce::fluid_velocity(int i) const
{
  return coupled_ ? fluidVelocity_->array_atom[i] : uniform_->velocity();
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::rotational_drag(double kick, bool remove)
{
  double **torque = atom->torque;
  double **applied = fluidTorque_->array_atom;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit) || held_.holds(i)) continue;
    const double inertia = 0.4 * atom->rmass[i] * atom->radius[i] * atom->radius[i];
    const ExponentialDrag drag(uniform_->spinCoefficient(i), kick, inertia);
    for (int dim = 0; dim < 3; dim++) {
      if (remove) torque[i][dim] -= applied[i][dim];
      applied[i][dim] = -drag.slip * atom->omega[i][dim] - drag.other * torque[i][dim];
      torque[i][dim] += applied[i][dim];
    }
  }
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::setup_pre_exchange()
{
  running_.forget_lists();
  if (running_.resume()) running_.to_lists();
  if (!doorOpen_) return;
  refresh_exchange();
  lost_.collect_outside(exchange_, 0.0);
}

/* ----------------------------------------------------------------------
   the grains have had the first half kick of this step, which is not booked yet
------------------------------------------------------------------------- */

void FixFluidForce::pre_exchange()
{
  if (!doorOpen_) return;
  refresh_exchange();
  lost_.collect_marked(exchange_, 0.5 * update->dt);
  lost_.collect_outside(exchange_, 0.5 * update->dt);
}
