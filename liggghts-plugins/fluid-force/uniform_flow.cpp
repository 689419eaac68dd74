/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "uniform_flow.h"

#include "host/fix_arguments.h"
#include "physics/drag/drag_laws.h"
#include "physics/drag/exponential_drag.h"

#include "atom.h"
#include "error.h"
#include "fix_gravity.h"
#include "force.h"
#include "math_const.h"
#include "modify.h"

#include <cmath>
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
  Pointers(lmp), density_(0.0), viscosity_(0.0), law_(NULL),
  buoyancy_(false), rotation_(false), addedMass_(0.0), gravity_(NULL)
{
  for (double &component : velocity_)
    component = arguments.number("the fluid velocity ux uy uz after 'uniform'", -FASTEST, FASTEST);

  std::string law = "gidaspow";
  while (arguments.more()) {
    const std::string keyword =
      arguments.keyword({"density", "viscosity", "drag", "buoyancy", "rotation", "addedMass"});
    if (keyword == "density") density_ = arguments.positive("density", 1.0 / WIDEST, WIDEST);
    else if (keyword == "viscosity") viscosity_ = arguments.positive("viscosity", 1.0 / WIDEST, WIDEST);
    else if (keyword == "drag") law = arguments.word("name of a drag law after 'drag'");
    else if (keyword == "buoyancy") buoyancy_ = arguments.yesNo("buoyancy");
    else if (keyword == "rotation") rotation_ = arguments.yesNo("rotation");
    else addedMass_ = arguments.positive("addedMass", SMALLEST_ADDED, LARGEST_ADDED);
  }
  if (density_ == 0.0) arguments.fail("missing keyword density (kg/m3)");
  if (viscosity_ == 0.0) arguments.fail("missing keyword viscosity (kinematic, m2/s)");

  law_ = grainjet::drag::findLaw(law);
  if (!law_)
    arguments.fail("unknown drag law '" + law + "'; valid laws are "
      + grainjet::drag::lawNames());
}

/* ---------------------------------------------------------------------- */

void UniformFlow::init()
{
  gravity_ = NULL;
  if (!buoyancy_) return;
  for (int ifix = 0; ifix < modify->nfix && !gravity_; ifix++)
    gravity_ = dynamic_cast<FixGravity *>(modify->fix[ifix]);
  if (!gravity_) error->all(FLERR, "Fix fluid/force: buoyancy yes requires a fix gravity");
}

/* ---------------------------------------------------------------------- */

void UniformFlow::buoyancy(double *force) const
{
  force[0] = force[1] = force[2] = 0.0;
  if (gravity_) gravity_->get_gravity(force);
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

double UniformFlow::spinCoefficient(int i) const
{
  const double cg = force->cg(atom->type[i]);
  return 6.0 * density_ * viscosity_ * cg * cg * volume(atom->radius[i]);
}
