/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_grain_motion.h"

#include "host/expose_member.h"
#include "host/fix_arguments.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "integrate.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "signal_handling.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::FixArguments;

namespace grainjet {

struct MotionPreForceList {
  using type = int *Modify::*;
  friend type member(MotionPreForceList);
};

struct ExternalForceClear {
  using type = int Integrate::*;
  friend type member(ExternalForceClear);
};

}

template struct grainjet::Expose<grainjet::MotionPreForceList, &Modify::list_pre_force>;
template struct grainjet::Expose<grainjet::ExternalForceClear, &Integrate::external_force_clear>;

/* ---------------------------------------------------------------------- */

FixGrainMotion::FixGrainMotion(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), magnitude_(0.0), direction_(), gravity_(), hasGravity_(false), fluid_(NULL),
  held_(lmp), mayJoin_(false), joined_(false), until_(-1)
{
  time_integrate = 1;
  parse(narg, arg);
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::parse(int narg, char **arg)
{
  FixArguments arguments(error, narg, arg);
  while (arguments.more()) {
    const std::string keyword = arguments.keyword({"gravity", "fluid"});
    if (keyword == "fluid") {
      fluidId_ = arguments.word("the ID of a fix fluid/force after fluid");
      continue;
    }
    hasGravity_ = true;
    magnitude_ = arguments.nonNegative("gravity");
    double square = 0.0;
    for (int dim = 0; dim < 3; dim++) {
      direction_[dim] = arguments.number(std::string("direction of gravity, ") + "xyz"[dim]);
      if (dim == domain->dimension) direction_[dim] = 0.0;    // in a plane as fix gravity
      square += direction_[dim] * direction_[dim];
    }
    if (!(square > 0.0)) arguments.fail("the direction of gravity is 0 0 0; give, for instance, gravity 9.81 0 0 -1");
    // as fix gravity does, for the same digits
    const double length = std::sqrt(square);
    for (int dim = 0; dim < 3; dim++) gravity_[dim] = magnitude_ * (direction_[dim] / length);
  }

  if (!atom->sphere_flag || !atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    arguments.fail("requires atom_style granular: spheres with radius, mass and spin of their own");
  if (atom->superquadric_flag || atom->erforce_flag || atom->e_flag || atom->rho_flag || atom->mu_flag)
    arguments.fail("moves spheres only: atom_style granular alone, without superquadrics, dipoles or SPH");
}

/* ---------------------------------------------------------------------- */

int FixGrainMotion::setmask()
{
  return INITIAL_INTEGRATE | PRE_NEIGHBOR | PRE_FORCE | FINAL_INTEGRATE;
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::fail(const std::string &message) const
{
  const std::string text = std::string("Fix ") + style + " (ID " + id + "): " + message;
  error->all(FLERR, text.c_str());
  std::abort();    // never reached: Error::all ends the program
}

/* ----------------------------------------------------------------------
   LIGGGHTS clears forces itself, or leaves it to the one fix that does
------------------------------------------------------------------------- */

void FixGrainMotion::set_clearing(bool own)
{
  if (update->integrate) update->integrate->*member(grainjet::ExternalForceClear()) = own;
}

void FixGrainMotion::pre_delete(bool unfixflag)
{
  if (unfixflag) set_clearing(false);
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::init()
{
  if (strcmp(update->integrate_style, "verlet") != 0)
    fail(std::string("works with run_style verlet, not with ") + update->integrate_style);
  if (update->whichflag == 2) fail("moves grains in runs of steps; minimize needs a script without it");
  check_other_fixes();
  check_atoms();
  find_fluid();
  held_.init();
  act_first();
  set_clearing(true);
  find_ends();

  const std::string trouble = spoiler();
  mayJoin_ = trouble.empty();
  if (comm->me == 0) {
    const std::string text = std::string("Fix grain/motion (ID ") + id + "): "
      + (mayJoin_ ? "halves of steps are joined" : "halves of steps stay apart, for " + trouble) + "\n";
    for (FILE *out : {screen, logfile})
      if (out) fputs(text.c_str(), out);
  }
}

/* ----------------------------------------------------------------------
   All ranks come here together, also those without grains
------------------------------------------------------------------------- */

void FixGrainMotion::check_atoms()
{
  int mine = 0, any = 0;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && !(atom->radius[i] > 0.0 && atom->rmass[i] > 0.0)) mine = 1;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  if (any) fail("its group has grains without a radius or a mass above 0; set them, for instance by set group all diameter");
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::check_other_fixes()
{
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const Fix *other = modify->fix[ifix];
    if (other == this) continue;
    const std::string name = std::string("fix ") + other->style + " (ID " + other->id + ")";
    if (other->rigid_flag || strncmp(other->style, "multisphere", 11) == 0)
      fail(name + " moves clumps of grains, which this fix cannot; use fix nve/sphere for the others");
    if (other->time_integrate)
      fail(name + " integrates grains, too; one fix grain/motion must be the only one that does. Take one of them out");
    if (hasGravity_ && strcmp(other->style, "gravity") == 0)
      fail(name + " and the keyword gravity would both add a weight; take one of them out");
    if (hasGravity_ && strcmp(other->style, "relax") == 0)
      fail(name + " changes the weight of grains, which the keyword gravity does not know; use fix gravity");
  }
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::find_fluid()
{
  fluid_ = NULL;
  if (fluidId_.empty()) return;
  const int ifix = modify->find_fix(fluidId_.c_str());
  if (ifix < 0) fail("there is no fix with ID " + fluidId_ + ", which the keyword fluid names; define a fix fluid/force of that ID");
  Fix *fix = modify->fix[ifix];
  if (strcmp(fix->style, "fluid/force") != 0)
    fail("fluid must name a fix fluid/force; the fix with ID " + fluidId_ + " is a " + fix->style);
  if (fix->igroup != igroup)
    fail("fix fluid/force (ID " + fluidId_ + ") has another group; give both the same");
  int dim;
  fluid_ = static_cast<FluidMotion *>(fix->extract("fluid_force_motion", dim));
  if (!fluid_) fail("fix fluid/force (ID " + fluidId_ + ") is of another version; load the plugins of one version");
}

/* ----------------------------------------------------------------------
   Whoever adds forces before the pair style finds them cleared
------------------------------------------------------------------------- */

void FixGrainMotion::act_first()
{
  int *first = modify->*member(grainjet::MotionPreForceList());
  int *last = first + modify->n_pre_force;
  int *own = std::find(first, last, modify->find_fix(id));
  if (own != last) std::rotate(first, own, own + 1);
}

/* ----------------------------------------------------------------------
   Fixes that act between the halves, or that may look at force or fluid force of the former step
   while the next one is under way, by a variable for instance. Only of those named here we know that
   they do not: they add forces, move meshes, insert, count crossings by position and half-step velocity.
------------------------------------------------------------------------- */

std::string FixGrainMotion::spoiler() const
{
  static const char *const known[] = {"wall/gran", "wall/roughness", "hertz/cg", "fluid/force", "freeze", "viscous",
    "check/timestep/gran", "massflow/mesh"};
  static const char *const families[] = {"mesh/surface", "move/mesh", "insert/", "property/", "neighlist/mesh",
    "contacthistory", "contactproperty/", "particletemplate/", "particledistribution/"};
  const int between = PRE_INITIAL_INTEGRATE | INITIAL_INTEGRATE | POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | PRE_FORCE
    | POST_FORCE | PRE_FINAL_INTEGRATE | FINAL_INTEGRATE | ITERATE_IMPLICITLY;

  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const Fix *fix = modify->fix[ifix];
    if (fix == this || !(modify->fmask[ifix] & between)) continue;
    bool found = false;
    for (const char *name : known) found |= strcmp(fix->style, name) == 0;
    for (const char *name : families) found |= strncmp(fix->style, name, strlen(name)) == 0;
    if (!found) return std::string("fix ") + fix->style + " (ID " + fix->id + ")";
  }
  if (fluid_ && !fluid_->joins(fluid_->fix)) return "torque or work of the fluid";
  for (const EndOfStep &end : ends_)
    if (end.every <= 1) return "a fix that looks at every step";
  return "";
}

/* ----------------------------------------------------------------------
   insert/stream acts at the end of every step, but only on grains that it carries: see GrainStep
------------------------------------------------------------------------- */

void FixGrainMotion::find_ends()
{
  ends_.clear();
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const Fix *fix = modify->fix[ifix];
    if ((modify->fmask[ifix] & END_OF_STEP) && strcmp(fix->style, "insert/stream") != 0)
      ends_.push_back(EndOfStep{std::max(1, fix->nevery)});
  }
}

/* ----------------------------------------------------------------------
   May the next step begin right behind this one? Not if it is the last one, or if a fix or an output looks
   at grains at its end, or if the user has asked for the end of the run. The same on all ranks.
------------------------------------------------------------------------- */

bool FixGrainMotion::join() const
{
  const bigint now = update->ntimestep;
  if (!mayJoin_ || now >= (until_ >= 0 ? until_ : update->laststep) || now == output->next) return false;
  if (SignalHandler::request_quit || SignalHandler::request_write_restart) return false;
  for (const EndOfStep &end : ends_)
    if (now % end.every == 0) return false;
  return true;
}

/* ---------------------------------------------------------------------- */

GrainStep FixGrainMotion::step(bool join)
{
  GrainStep step = {};
  if (atom->nlocal > 0) {    // a rank that never had one has no arrays
    step.x = atom->x[0];
    step.v = atom->v[0];
    step.f = atom->f[0];
    step.omega = atom->omega[0];
    step.torque = atom->torque[0];
  }
  step.radius = atom->radius;
  step.rmass = atom->rmass;
  step.mask = atom->mask;
  step.n = atom->nlocal;
  step.groupbit = groupbit;
  step.dt = update->dt;
  step.half = 0.5 * update->dt * force->ftm2v;
  step.halfOverInertia = step.half / (domain->dimension == 2 ? 0.5 : 0.4);
  std::copy(gravity_, gravity_ + 3, step.gravity);
  step.join = join;
  step.held = &held_;
  step.late = &late_;
  return step;
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::setup(int)
{
  joined_ = false;
  late_.clear();
  held_.reorder();
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::initial_integrate(int)
{
  const GrainStep grains = step(false);
  if (joined_) {
    for (int i : late_) grains.begin(i);
    late_.clear();
    joined_ = false;
  } else {
    for (int i = 0; i < grains.n; i++) grains.begin(i);
  }
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::final_integrate()
{
  joined_ = join();
  const GrainStep grains = step(joined_);
  if (joined_) held_.update(update->ntimestep);
  if (fluid_) fluid_->move(fluid_->fix, grains);
  else if (joined_) grains.end_all<true>();
  else grains.end_all<false>();
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::pre_neighbor()
{
  held_.reorder();
}

/* ----------------------------------------------------------------------
   Grains that were exchanged, sorted or inserted have forces that mean nothing.
------------------------------------------------------------------------- */

void FixGrainMotion::setup_pre_force(int)
{
  clear_all();
}

void FixGrainMotion::pre_force(int)
{
  if (neighbor->ago == 0) clear_all();
  else clear_ghosts();
}

/* ---------------------------------------------------------------------- */

void FixGrainMotion::clear_all()
{
  const GrainStep grains = step(false);
  for (int i = 0; i < grains.n; i++) grains.clear(i);
  clear_ghosts();
}

void FixGrainMotion::clear_ghosts()
{
  if (atom->nghost == 0) return;
  const std::size_t bytes = 3 * sizeof(double) * static_cast<std::size_t>(atom->nghost);
  memset(atom->f[atom->nlocal], 0, bytes);
  memset(atom->torque[atom->nlocal], 0, bytes);
}

/* ---------------------------------------------------------------------- */

void *FixGrainMotion::extract(const char *what, int &dim)
{
  dim = 0;
  if (strcmp(what, "grain_motion_fluid") == 0) return fluidId_.empty() ? NULL : const_cast<char *>(fluidId_.c_str());
  if (strcmp(what, "grain_motion_until") == 0) return &until_;
  dim = 1;
  return hasGravity_ && strcmp(what, "grain_motion_gravity") == 0 ? gravity_ : NULL;
}
