/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(wall/roughness,FixWallRoughness)

#else

#ifndef LMP_FIX_WALL_ROUGHNESS_H
#define LMP_FIX_WALL_ROUGHNESS_H

#include "fix.h"

#include <string>

namespace LAMMPS_NS {

class FixPropertyAtom;
class FixWallGran;

/* A rough wall: each contact of a grain with a primitive fix wall/gran is one with a facet that is inclined at random
   (physics/wall/rough_wall.h). User page: docs/fix_wall_roughness.md.

     fix ID group wall/roughness wall wallID angle degrees [seed n]

   When a contact begins the velocities of the grain are turned so that they lie to the smooth wall as they did to the facet;
   the wall's own contact model works as always; when the contact ends they are turned back. So the impact is exactly that of the
   model on a plane with the facet's normal, for any contact model, and the two turns change no energy.

   The random numbers depend on seed, grain and step alone. The turn of a grain that is in contact goes with it to other
   ranks and into restart files.

   Global vector: 1 contacts begun since the fix was made, 2 grains in contact.                                            */
class FixWallRoughness : public Fix {
 public:

  FixWallRoughness(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void pre_force(int) override;
  double compute_vector(int) override;

 private:

  std::string wallID_;
  double deviation_;            // rad
  int seed_;
  FixWallGran *wall_;
  FixPropertyAtom *turns_;      // per grain: 1 in contact, 0 not; turn of its velocities (axis times angle)
  double begun_;                // contacts, on this rank

  [[noreturn]] void fail(const std::string &message) const;
  std::string find_wall();
  bool touches(int grain, double *towards) const;
  void begin(int grain, const double *towards);
  void apply(int grain, double sign);
};

}

#endif
#endif
