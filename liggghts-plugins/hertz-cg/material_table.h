/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_MATERIAL_TABLE_H
#define GRAINJET_MATERIAL_TABLE_H

#include "physics/contact/coarse_graining.h"
#include "physics/contact/contact_law.h"
#include "physics/contact/material.h"

#include <string>
#include <vector>

namespace LAMMPS_NS { class LAMMPS; class Fix; }

namespace grainjet {

/* The material data of a run by atom type, from the stock `fix property/global` of these names:
   youngsModulus, poissonsRatio (peratomtype), coefficientRestitution and, where the law asks for them,
   coefficientFriction, coefficientRollingFriction, coefficientRollingViscousDamping,
   cohesionEnergyDensity (peratomtypepair).
   Missing or impossible values are an error that names the property, the types and the value. */
class MaterialTable {
 public:

  struct Entry {
    contact::PairMaterial material;
    contact::CoarseGraining scale;
    bool mixed;                    // the two types have different coarse-graining factors
  };

  // Read the tables; the fix is the one that asks (for its name in messages)
  void read(LAMMPS_NS::LAMMPS *lmp, LAMMPS_NS::Fix *fix, const contact::LawOptions &law);

  int ntypes() const { return ntypes_; }
  const Entry &operator()(int itype, int jtype) const { return entries_[itype * (ntypes_ + 1) + jtype]; }
  double youngs(int type) const { return youngs_[type]; }
  double poisson(int type) const { return poisson_[type]; }

 private:

  typedef std::vector<double> Values;

  // by type from 1, or by pair as entries_; both ends of the allowed range belong to it
  // unless open; `range` says it in words
  Values per_type(const char *name, double low, double high, bool open, const char *range);
  Values per_pair(const char *name, double low, double high, bool open, const char *range);
  void check(const char *name, double value, const std::string &types, double low, double high,
             bool open, const char *range);
  class LAMMPS_NS::Fix *property(const char *name, const char *kind, int n1, int n2);

  LAMMPS_NS::LAMMPS *lmp_ = nullptr;
  LAMMPS_NS::Fix *fix_ = nullptr;
  int ntypes_ = 0;
  Values youngs_, poisson_;
  std::vector<Entry> entries_;
};

}

#endif
