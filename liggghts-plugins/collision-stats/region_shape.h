/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_REGION_SHAPE_H
#define GRAINJET_REGION_SHAPE_H

#include <string>
#include <vector>

namespace LAMMPS_NS { class Domain; class Region; }

namespace grainjet {

/* What LIGGGHTS knows of a region but does not tell: its members, and where it is now. */
namespace RegionShape {

  // Those of a union or an intersect, of other styles none
  std::vector<LAMMPS_NS::Region *> members(const LAMMPS_NS::Domain &, LAMMPS_NS::Region *);

  // Disjoint parts: a point is in part n if it matches list[n] and none before. Other styles than union: one
  std::vector<LAMMPS_NS::Region *> parts(const LAMMPS_NS::Domain &, LAMMPS_NS::Region *);

  // Of this style, or with a member of it: that region, else NULL
  LAMMPS_NS::Region *of_style(const LAMMPS_NS::Domain &, LAMMPS_NS::Region *, const char *style);

  // Puts it and its members where they are in this step. On all ranks, since variables can ask all
  void settle(const LAMMPS_NS::Domain &, LAMMPS_NS::Region *);

  // A box about it, m, where it is after settle(); false: it has no bounds
  bool extent(const LAMMPS_NS::Domain &, LAMMPS_NS::Region *, double *low, double *high);

  // Style, side and extent at rest, of the members as well
  std::string description(const LAMMPS_NS::Domain &, LAMMPS_NS::Region *);

}

}

#endif
