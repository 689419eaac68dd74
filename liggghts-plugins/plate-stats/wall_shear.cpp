/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "wall_shear.h"

#include "host/expose_member.h"

#include "fix_wall_gran.h"
#include "primitive_wall.h"

using namespace LAMMPS_NS;

namespace grainjet {

struct ShearFlag {
  using type = int FixWallGran::*;
  friend type member(ShearFlag);
};

struct ShearDim {
  using type = int FixWallGran::*;
  friend type member(ShearDim);
};

struct ShearAxis {
  using type = int FixWallGran::*;
  friend type member(ShearAxis);
};

struct ShearSpeed {
  using type = double FixWallGran::*;
  friend type member(ShearSpeed);
};

struct ShearVector {
  using type = double (FixWallGran::*)[3];
  friend type member(ShearVector);
};

}

template struct grainjet::Expose<grainjet::ShearFlag, &FixWallGran::shear_>;
template struct grainjet::Expose<grainjet::ShearDim, &FixWallGran::shearDim_>;
template struct grainjet::Expose<grainjet::ShearAxis, &FixWallGran::shearAxis_>;
template struct grainjet::Expose<grainjet::ShearSpeed, &FixWallGran::vshear_>;
template struct grainjet::Expose<grainjet::ShearVector, &FixWallGran::shearAxisVec_>;

/* ---------------------------------------------------------------------- */

bool LAMMPS_NS::wall_shears(const FixWallGran *wall)
{
  return wall->*member(grainjet::ShearFlag());
}

/* ---------------------------------------------------------------------- */

void LAMMPS_NS::wall_shear(FixWallGran *wall, double *x, double *velocity)
{
  velocity[wall->*member(grainjet::ShearDim())] = wall->*member(grainjet::ShearSpeed());
  if (wall->*member(grainjet::ShearAxis()) < 0) return;
  double radial[3];
  wall->primitiveWall()->calcRadialDistance(x, radial);
  vectorCross3D(wall->*member(grainjet::ShearVector()), radial, velocity);
}
