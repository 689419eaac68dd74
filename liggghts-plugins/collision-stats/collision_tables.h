/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_COLLISION_TABLES_H
#define GRAINJET_COLLISION_TABLES_H

#include "collision-stats/collision_statistics.h"

#include <string>
#include <vector>

namespace grainjet {

// What the tables say besides the collisions that are over
struct CollisionSurroundings {
  double time = 0.0;                 // s, for which collisions were counted
  double samples = 0.0;              // how often the grains were counted
  std::vector<double> volumes;       // m3, of each region of CollisionStatistics
  std::vector<double> touching;      // of each cell: collisions that go on now
  std::vector<double> factor;        // f_cg of each type, from 0 on
};

/* Two tables in CSV, with one line of names. SI units. What is undefined is nan. Regions without a collision
   have no rows in the table of spectra.                                                     */
namespace CollisionTables {

  std::string totalsColumns();
  std::string totals(const CollisionStatistics &, const CollisionSurroundings &);

  std::string spectraColumns();
  std::string spectra(const CollisionStatistics &);

}

}

#endif
