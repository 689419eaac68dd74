/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/material_table.h"

#include "atom.h"
#include "error.h"
#include "fix_property_global.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "properties.h"

#include <cfloat>
#include <cmath>
#include <cstring>
#include <sstream>

using namespace LAMMPS_NS;
using namespace grainjet;

/* ---------------------------------------------------------------------- */

void MaterialTable::read(LAMMPS *lmp, Fix *fix, const contact::LawOptions &law)
{
  lmp_ = lmp;
  fix_ = fix;
  ntypes_ = lmp->atom->get_properties()->max_type();

  youngs_ = per_type("youngsModulus", 0.0, DBL_MAX, true, "must be > 0");
  poisson_ = per_type("poissonsRatio", 0.0, 0.5, false, "must be in [0, 0.5]");
  const Values restitution =
    per_pair("coefficientRestitution", 0.0, 1.0, true, "must be in (0, 1]");
  const Values zero((ntypes_ + 1) * (ntypes_ + 1), 0.0);
  const auto where = [&](bool asked, const char *name) {
    return asked ? per_pair(name, 0.0, DBL_MAX, false, "must be >= 0") : zero;
  };
  const Values mu = where(law.tangential != contact::Tangential::OFF, "coefficientFriction");
  const Values rollingMu = where(law.rolling != contact::Rolling::OFF, "coefficientRollingFriction");
  const Values rollingDamping = where(law.rolling == contact::Rolling::EPSD, "coefficientRollingViscousDamping");
  const Values cohesion = where(law.cohesion != contact::Cohesion::OFF, "cohesionEnergyDensity");

  entries_.resize(zero.size());
  for (int i = 1; i <= ntypes_; ++i)
    for (int j = 1; j <= ntypes_; ++j) {
      const int ij = i * (ntypes_ + 1) + j;
      Entry &e = entries_[ij];
      e.material.youngs = contact::effectiveYoungs(youngs_[i], poisson_[i], youngs_[j], poisson_[j]);
      e.material.shear = contact::effectiveShear(youngs_[i], poisson_[i], youngs_[j], poisson_[j]);
      e.material.damping = contact::dampingRatio(restitution[ij]);
      e.material.friction = mu[ij];
      e.material.rollingFriction = rollingMu[ij];
      e.material.rollingDamping = rollingDamping[ij];
      e.material.cohesionEnergy = cohesion[ij];
      e.scale = contact::CoarseGraining(lmp->force->cg(i));
      e.mixed = lmp->force->cg(i) != lmp->force->cg(j);
    }
}

/* ---------------------------------------------------------------------- */

Fix *MaterialTable::property(const char *name, const char *kind, int n1, int n2)
{
  Fix *found = lmp_->modify->find_fix_property(name, "property/global", kind, 0, 0, fix_->style, false);
  std::ostringstream message;
  if (!found)
    message << "material property '" << name << "' is missing; define it with `fix <id> all property/global "
            << name << " " << kind << " ...`";
  else if (n2 ? found->size_array_rows < n1 || found->size_array_cols < n2 : found->size_vector < n1)
    message << "material property '" << name << "' has values for too few atom types; " << n1 << " are in use";
  if (!message.str().empty()) lmp_->error->fix_error(FLERR, fix_, message.str().c_str());
  return found;
}

/* ---------------------------------------------------------------------- */

MaterialTable::Values MaterialTable::per_type(const char *name, double low, double high, bool open,
                                              const char *range)
{
  Fix *found = property(name, "peratomtype", ntypes_, 0);
  Values values(ntypes_ + 1, 0.0);
  for (int i = 1; i <= ntypes_; ++i) {
    values[i] = found->compute_vector(i - 1);
    check(name, values[i], std::to_string(i), low, high, open, range);
  }
  return values;
}

/* ---------------------------------------------------------------------- */

MaterialTable::Values MaterialTable::per_pair(const char *name, double low, double high, bool open,
                                              const char *range)
{
  Fix *found = property(name, "peratomtypepair", ntypes_, ntypes_);
  Values values((ntypes_ + 1) * (ntypes_ + 1), 0.0);
  for (int i = 1; i <= ntypes_; ++i)
    for (int j = 1; j <= ntypes_; ++j) {
      const double value = found->compute_array(i - 1, j - 1);
      check(name, value, std::to_string(i) + " and " + std::to_string(j), low, high, open, range);
      values[i * (ntypes_ + 1) + j] = value;
    }
  return values;
}

/* ---------------------------------------------------------------------- */

void MaterialTable::check(const char *name, double value, const std::string &types, double low,
                          double high, bool open, const char *range)
{
  if ((open ? value > low : value >= low) && value <= high) return;
  std::ostringstream message;
  message << "material property '" << name << "' of type " << types << " is " << value << ", but " << range;
  lmp_->error->fix_error(FLERR, fix_, message.str().c_str());
}
