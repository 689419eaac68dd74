/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_fluid_force.h"

#include "host/fix_arguments.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_property_atom.h"
#include "modify.h"
#include "update.h"

#include <cstring>
#include <string>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::FixArguments;

/* ---------------------------------------------------------------------- */

FixFluidForce::FixFluidForce(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg),
  coupled_(false), uniformFluid_(), properties_(lmp, this),
  fluidVelocity_(NULL), dragCoefficient_(NULL), explicitForce_(NULL), impulse_(NULL),
  fluidForce_(NULL), startPosition_(NULL), owner_(NULL),
  nonReactingCoefficient_(NULL), nonReactingForce_(NULL), nonReactingImpulse_(NULL),
  nonReactingApplied_(NULL),
  fluidSpin_(NULL), spinCoefficient_(NULL), explicitTorque_(NULL), fluidTorque_(NULL),
  addedMass_(NULL), work_(NULL), powerGrowth_(NULL),
  exchange_(), exchangeOpen_(false), nonReactingRequested_(false), torqueRequested_(false),
  addedMassRequested_(false), workRequested_(false), nonReactingRead_(false), torqueRead_(false),
  addedMassRead_(false), workRead_(false),
  removed_(lmp), running_(lmp), held_(lmp),
  freshSetup_(false), sumStep_(-1), sums_(), motion_(), moved_(false), bookedAhead_(false)
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
  const double *velocity = uniform_->velocity();
  uniformFluid_ = {{velocity[0], velocity[1], velocity[2]}, uniform_->density(), uniform_->viscosity()};
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
  dragCoefficient_ = properties_.create("fluidDragCoefficient", {0.0});
  impulse_ = properties_.create("fluidImpulse", {0.0, 0.0, 0.0});
  fluidForce_ = properties_.create("fluidForce", {0.0, 0.0, 0.0});
  if (uniform_ && uniform_->rotation()) fluidTorque_ = properties_.create("fluidTorque", {0.0, 0.0, 0.0});
  if (coupled_) {
    fluidVelocity_ = properties_.create("fluidVelocity", {0.0, 0.0, 0.0});
    explicitForce_ = properties_.create("fluidExplicitForce", {0.0, 0.0, 0.0});
    owner_ = properties_.create("fluidOwner", {-1.0, -1.0, 0.0});

    // its initial value is the grain's own position: set_arrays() does that
    startPosition_ = properties_.create_unset("fluidStartPosition", 3);
    if (!startPosition_->recent_restart)
      for (int i = 0; i < atom->nlocal; i++) set_arrays(i);

    // what a coupling had asked for before the restart file was written
    if (nonReactingRead_) create_non_reacting();
    if (torqueRead_) create_torque();
    if (addedMassRead_) create_added_mass();
    if (workRead_) create_work();
    properties_.create_states();
  }

  // What is there has its initial state now. Modify::setup would set it once more and
  // so wipe out what was written before the first run.
  just_created = 0;
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::pre_delete(bool unfixflag)
{
  if (unfixflag) properties_.remove();
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::init()
{
  if (strstr(update->integrate_style, "respa"))
    error->all(FLERR, "Fix fluid/force does not work with run_style respa, use verlet");

  if (uniform_) uniform_->init();
  held_.init();
  find_motion();
  check_other_fixes();
  if (!coupled_) return;
  check_box();
  removed_.act_first(modify->find_fix(id));
  if (exchangeOpen_) drop_unrequested();
}

/* ----------------------------------------------------------------------
   The mesh of the fluid stays as it is, and so must the box: commands behind this fix may have
   changed its shape. Shrink-wrapped faces, which only follow the grains, do no harm.
------------------------------------------------------------------------- */

void FixFluidForce::check_box()
{
  if (domain->triclinic)
    error->all(FLERR, "Fix fluid/force coupled requires an orthogonal box; take out change_box ... triclinic");

  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const Fix *other = modify->fix[ifix];
    if (!other->box_change_size && !other->box_change_shape) continue;
    const std::string text = std::string("Fix fluid/force coupled: fix ") + other->style + " (ID "
      + other->id + ") changes the simulation box during the run, while the mesh of the fluid stays;"
      " take it out";
    error->all(FLERR, text.c_str());
  }
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
   does a fix grain/motion take over the loop?
------------------------------------------------------------------------- */

void FixFluidForce::find_motion()
{
  moved_ = false;
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    int dim;
    if (strcmp(modify->fix[ifix]->style, "grain/motion") != 0) continue;
    const char *named = static_cast<const char *>(modify->fix[ifix]->extract("grain_motion_fluid", dim));
    moved_ |= named && strcmp(named, id) == 0;
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
  bookedAhead_ = false;
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
  if (moved_) return;    // it calls move()
  held_.update(update->ntimestep);
  apply(update->dt, false, true);
}

/* ---------------------------------------------------------------------- */

void FixFluidForce::setup_pre_exchange()
{
  running_.forget_lists();
  if (running_.resume()) running_.to_lists();
  collect_removed(false, 0.0);
}

/* ----------------------------------------------------------------------
   the grains have had the first half kick of this step, which is booked already only if steps are joined
------------------------------------------------------------------------- */

void FixFluidForce::pre_exchange()
{
  collect_removed(true, bookedAhead_ ? 0.0 : 0.5 * update->dt);
}
