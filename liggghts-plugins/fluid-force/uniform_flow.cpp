/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "uniform_flow.h"

#include "host/fix_arguments.h"
#include "physics/drag/drag_laws.h"
#include "physics/drag/exponential_drag.h"
#include "physics/drag/shaped_drag.h"
#include "physics/lift/magnus.h"
#include "physics/lift/mean_lift.h"
#include "physics/lift/spin_torque.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_gravity.h"
#include "force.h"
#include "math_const.h"
#include "modify.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

using namespace LAMMPS_NS;
using grainjet::FixArguments;
using grainjet::drag::ExponentialDrag;
using grainjet::drag::State;

// Far beyond every fluid, so that only slips of the pen are refused: the speed of light (m/s),
// and twelve decades either side of 1 for density and viscosity
static const double FASTEST = 299792458.0;
static const double WIDEST = 1e12;

// Of the added-mass coefficient: 0.5 for a sphere, more beside a wall or in a crowd
static const double SMALLEST_ADDED = 1e-6, LARGEST_ADDED = 100.0;

/* ---------------------------------------------------------------------- */

UniformFlow::UniformFlow(LAMMPS *lmp, FixArguments &arguments) :
  Pointers(lmp), density_(0.0), viscosity_(0.0),
  buoyancy_(false), rotation_(false), magnus_(false), addedMass_(0.0), gravity_(NULL), given_(NULL)
{
  for (double &component : velocity_)
    component = arguments.number("the fluid velocity ux uy uz after 'uniform'", -FASTEST, FASTEST);

  std::string law = "gidaspow";
  double sphericity = NAN;    // none
  while (arguments.more()) {
    const std::string keyword = arguments.keyword(
      {"density", "viscosity", "drag", "sphericity", "buoyancy", "rotation", "magnus", "addedMass"});
    if (keyword == "density") density_ = arguments.positive("density", 1.0 / WIDEST, WIDEST);
    else if (keyword == "viscosity") viscosity_ = arguments.positive("viscosity", 1.0 / WIDEST, WIDEST);
    else if (keyword == "drag") law = arguments.word("name of a drag law after 'drag'");
    else if (keyword == "sphericity") sphericity = arguments.number("sphericity", -HUGE_VAL, HUGE_VAL);
    else if (keyword == "buoyancy") buoyancy_ = arguments.yesNo("buoyancy");
    else if (keyword == "magnus") magnus_ = arguments.yesNo("magnus");
    else if (keyword == "rotation") rotation_ = arguments.yesNo("rotation");
    else addedMass_ = arguments.positive("addedMass", SMALLEST_ADDED, LARGEST_ADDED);
  }
  if (density_ == 0.0) arguments.fail("missing keyword density (kg/m3), for instance density 1.2 for air");
  if (viscosity_ == 0.0) arguments.fail("missing keyword viscosity (kinematic, m2/s), for instance viscosity 1.5e-5 for air");

  set_law(arguments, law, sphericity);

  if (magnus_ && !rotation_ && comm->me == 0)
    error->warning(FLERR, "Fix fluid/force: magnus yes without rotation yes: the spin that contacts give to grains "
      "never decays; add rotation yes");
}

/* ---------------------------------------------------------------------- */

void UniformFlow::set_law(FixArguments &arguments, const std::string &name, double sphericity)
{
  using namespace grainjet::drag;

  const ShapedLaw *shaped = findShapedLaw(name);
  if (shaped) {
    char range[48];
    snprintf(range, sizeof(range), "from %g to 1", shaped->least);
    if (std::isnan(sphericity))
      arguments.fail("drag " + name + " needs the keyword sphericity, " + range + ": surface of the sphere of equal "
        "volume over that of the particle, for instance sphericity 0.8");
    if (!(sphericity >= shaped->least && sphericity <= 1.0)) {
      char value[32];
      snprintf(value, sizeof(value), "%g", sphericity);
      arguments.fail("sphericity of drag " + name + " must be " + range + ", not " + value);
    }
    law_ = shaped->make(sphericity);
    return;
  }

  law_ = findLaw(name);
  if (!law_)
    arguments.fail("unknown drag law '" + name + "'; valid laws are " + lawNames() + ", " + shapedLawNames());
  if (!std::isnan(sphericity))
    arguments.fail("drag " + name + " is a law of spheres; take the keyword sphericity out, or use "
      + shapedLawNames());
}

/* ---------------------------------------------------------------------- */

void UniformFlow::init()
{
  gravity_ = NULL;
  given_ = NULL;
  if (!buoyancy_) return;
  for (int ifix = 0; ifix < modify->nfix && !gravity_; ifix++) {
    int dim;
    gravity_ = dynamic_cast<FixGravity *>(modify->fix[ifix]);
    if (strcmp(modify->fix[ifix]->style, "grain/motion") == 0)
      given_ = static_cast<const double *>(modify->fix[ifix]->extract("grain_motion_gravity", dim));
  }
  if (!gravity_ && !given_) error->all(FLERR, "Fix fluid/force: buoyancy yes requires a fix gravity; add, for instance, "
    "fix g all gravity 9.81 vector 0 0 -1, or take buoyancy out");
}

/* ---------------------------------------------------------------------- */

void UniformFlow::buoyancy(double *force) const
{
  force[0] = force[1] = force[2] = 0.0;
  if (gravity_) gravity_->get_gravity(force);
  else if (given_) std::copy(given_, given_ + 3, force);
  for (int dim = 0; dim < 3; dim++) force[dim] *= -density_;
}

/* ---------------------------------------------------------------------- */

double UniformFlow::volume(double radius)
{
  return 4.0 / 3.0 * MathConst::MY_PI * radius * radius * radius;
}

/* ---------------------------------------------------------------------- */

double UniformFlow::dragCoefficient(int i, const double *other, double kick,
  double before, double inertia) const
{
  const double size = volume(atom->radius[i]);
  double slip[3];
  for (int dim = 0; dim < 3; dim++) slip[dim] = velocity_[dim] - atom->v[i][dim];

  State state;
  state.voidFraction = 1.0;
  state.diameter = 2.0 * atom->radius[i] / force->cg(atom->type[i]);
  state.density = density_;
  state.viscosity = viscosity_;

  const double slow = 0.05;    // b h / m up to which the last coefficient is a good estimate
  double estimate = before;
  if (before <= 0.0 || before * kick > slow * inertia) {
    state.slipSpeed = std::sqrt(slip[0]*slip[0] + slip[1]*slip[1] + slip[2]*slip[2]);
    estimate = law_(state) * size;
  }
  const ExponentialDrag drag(estimate, kick, inertia);
  for (int dim = 0; dim < 3; dim++)
    slip[dim] -= 0.5 * kick / inertia * (drag.slip * slip[dim] + (1.0 - drag.other) * other[dim]);
  state.slipSpeed = std::sqrt(slip[0]*slip[0] + slip[1]*slip[1] + slip[2]*slip[2]);
  return law_(state) * size;
}

/* ---------------------------------------------------------------------- */

double UniformFlow::spinReynolds(int i) const
{
  const double cg = force->cg(atom->type[i]), d = 2.0 * atom->radius[i] / cg;
  const double *omega = atom->omega[i];
  return cg * std::sqrt(omega[0]*omega[0] + omega[1]*omega[1] + omega[2]*omega[2]) * d * d / viscosity_;
}

double UniformFlow::spinCoefficient(int i, double kick) const
{
  const double cg = force->cg(atom->type[i]);
  const double slow = 6.0 * density_ * viscosity_ * cg * cg * volume(atom->radius[i]);
  const double spinRe = spinReynolds(i);
  if (spinRe < 31.0) return slow;    // where the factor is 1
  const double inertia = 0.4 * atom->rmass[i] * atom->radius[i] * atom->radius[i];
  return slow * grainjet::lift::meanSpinTorqueFactor(spinRe, slow * kick / inertia);
}

/* ----------------------------------------------------------------------
   The coefficient is taken at the mean slip, which depends on the lift: twice.
------------------------------------------------------------------------- */

void UniformFlow::lift(int i, const double *other, double kick, double before, double mass, double *result) const
{
  const double cg = force->cg(atom->type[i]), d = 2.0 * atom->radius[i] / cg;
  const double *omega = atom->omega[i];
  double spin = viscosity_ * spinReynolds(i) / (d * d), kept = 1.0;
  if (rotation_) {
    const double inertia = 0.4 * atom->rmass[i] * atom->radius[i] * atom->radius[i];
    kept = grainjet::lift::meanOfDecay(spinCoefficient(i, kick) * kick / inertia);
    spin *= kept;
  }

  double slip[3], total[3], L[3];
  for (int dim = 0; dim < 3; dim++) {
    slip[dim] = velocity_[dim] - atom->v[i][dim];
    total[dim] = other[dim];
  }
  double slipSpeed = std::sqrt(slip[0]*slip[0] + slip[1]*slip[1] + slip[2]*slip[2]);
  for (int pass = 0; pass < 2; pass++) {
    // W x slip = slip x w, as the flow does not turn: W = -w
    const double M = cg * cg * cg * grainjet::lift::magnus(d, density_, viscosity_, slipSpeed, spin);
    for (int dim = 0; dim < 3; dim++) L[dim] = M * kept * cg * omega[dim];
    const double b = dragCoefficient(i, total, kick, before, mass);
    const grainjet::lift::MeanLift lift(slip, other, L, b, kick, mass);
    for (int dim = 0; dim < 3; dim++) {
      result[dim] = lift.force[dim];
      total[dim] = other[dim] + lift.force[dim];
    }
    slipSpeed = lift.slipSpeed();
  }
}
