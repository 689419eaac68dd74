/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "uniform_gas.h"

#include "fluid-force/fluid_force_exchange.h"
#include "host/fix_arguments.h"
#include "host/grainjet_version.h"
#include "physics/heat/lumped_temperature.h"

#include "atom.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "modify.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

using namespace LAMMPS_NS;
using grainjet::FixArguments;
namespace heat = grainjet::heat;

// Far beyond every fluid, so that only slips of the pen are refused, as in fix fluid/force
static const double FASTEST = 299792458.0;
static const double WIDEST = 1e12;

// Of two statements of one property: more than rounding by a hand
static const double SAME = 1e-6;

/* ---------------------------------------------------------------------- */

UniformGas::UniformGas(LAMMPS *lmp, FixArguments &arguments) :
  Pointers(lmp), given_(), velocity_(), velocityGiven_(false), recovery_(true), grainTemperature_(NAN),
  law_(heat::ranzMarshall)
{
  const auto positive = [&arguments](const char *what) {
    return arguments.positive(std::string(what) + " after 'uniform T rho nu cp Pr'", 1.0 / WIDEST, WIDEST);
  };
  temperature_ = positive("fluid temperature T (K)");
  density_ = positive("fluid density rho (kg/m3)");
  viscosity_ = positive("kinematic viscosity nu (m2/s)");
  specificHeat_ = positive("specific heat cp of the fluid (J/(kg K))");
  prandtl_ = positive("Prandtl number Pr");
  conductivity_ = density_ * viscosity_ * specificHeat_ / prandtl_;

  while (arguments.more()) {
    const std::string keyword = arguments.keyword({"velocity", "nusselt", "recovery", "temperature"});
    if (keyword == "velocity") {
      velocityGiven_ = true;
      for (double &component : given_)
        component = arguments.number("the fluid velocity ux uy uz after 'velocity'", -FASTEST, FASTEST);
    } else if (keyword == "nusselt") {
      const std::string name = arguments.word("name of a law after 'nusselt'");
      law_ = heat::findNusselt(name);
      if (!law_) arguments.fail("unknown nusselt law '" + name + "'; valid laws are " + heat::nusseltNames());
    } else if (keyword == "recovery") recovery_ = arguments.yesNo("recovery");
    else grainTemperature_ = arguments.positive("temperature", 1.0 / WIDEST, WIDEST);
  }
}

/* ----------------------------------------------------------------------
   all ranks come here together
------------------------------------------------------------------------- */

void UniformGas::init(const Fix *fix)
{
  std::copy_n(given_, 3, velocity_);
  Fix *flow = NULL;
  for (int ifix = 0; ifix < modify->nfix; ifix++)
    if (strcmp(modify->fix[ifix]->style, "fluid/force") == 0) flow = modify->fix[ifix];
  if (!flow) return;

  const std::string name = std::string("Fix fluid/heat (ID ") + fix->id + "): ";
  const std::string other = std::string("fix fluid/force (ID ") + flow->id + ")";
  const auto fail = [&](const std::string &message) { error->all(FLERR, (name + message).c_str()); };

  int dim;
  const char *version = static_cast<const char *>(flow->extract("fluid_force_version", dim));
  if (!version || strcmp(version, GRAINJET_VERSION) != 0) fail(other + " is of another version of Grainjet; " GRAINJET_ANEW);
  const UniformFluid *fluid = static_cast<const UniformFluid *>(flow->extract("fluid_force_uniform", dim));
  if (!fluid) fail("style uniform next to " + other + " of style coupled: the fluid of that has other velocities; "
    "use fluid/heat coupled");
  if (velocityGiven_) fail("keyword velocity next to " + other + ", whose velocity counts; take the keyword out");

  const auto compare = [&](const char *what, double mine, double theirs) {
    if (std::fabs(mine - theirs) <= SAME * std::max(mine, theirs)) return;
    char text[128];
    snprintf(text, sizeof(text), "%s is %g here and %g in ", what, mine, theirs);
    fail(text + other + "; give both the same fluid");
  };
  compare("density", density_, fluid->density);
  compare("viscosity", viscosity_, fluid->viscosity);
  std::copy_n(fluid->velocity, 3, velocity_);
}

/* ---------------------------------------------------------------------- */

double UniformGas::exchange(int i, const double *velocity, double &temperature) const
{
  const double cg = force->cg(atom->type[i]);
  double square = 0.0;
  for (int dim = 0; dim < 3; dim++)
    square += (velocity_[dim] - velocity[dim]) * (velocity_[dim] - velocity[dim]);

  heat::State state;
  state.voidFraction = 1.0;
  state.slipSpeed = std::sqrt(square);
  state.diameter = 2.0 * atom->radius[i] / cg;
  state.viscosity = viscosity_;
  state.prandtl = prandtl_;
  state.viscosityRatio = 1.0;
  temperature = recovery_ ? heat::recoveryTemperature(temperature_, state.slipSpeed, specificHeat_, prandtl_)
    : temperature_;
  return heat::grainCoefficient(law_(state), conductivity_, state.diameter, cg);
}
