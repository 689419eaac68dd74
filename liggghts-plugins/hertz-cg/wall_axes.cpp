/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/wall_axes.h"

#include "atom.h"
#include "domain.h"
#include "fix.h"
#include "fix_neighlist_mesh.h"
#include "fix_wall_gran.h"
#include "lammps.h"
#include "modify.h"
#include "primitive_wall.h"

#include <cstdint>
#include <cstring>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

grainjet::WallAxes grainjet::find_walls(LAMMPS *lmp)
{
  // primitive walls list grains up to a whole skin from contact, keep a little in hand; meshes and
  // what is stored per contact with a primitive wall go by half of it
  WallAxes walls = {false, false, 0.9, {false, false, false}, false};
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    Fix *fix = lmp->modify->fix[i];
    if (strncmp(fix->style, "contactproperty/atom/wall", 25) == 0) walls.reach = 0.5;
    if (strncmp(fix->style, "move/mesh", 9) == 0 || strstr(fix->style, "servo") || strstr(fix->style, "6dof"))
      walls.moving = true;
    if (strncmp(fix->style, "neighlist/mesh", 14) == 0) {
      walls.reach = 0.5;
      walls.any = walls.mesh = walls.axis[0] = walls.axis[1] = walls.axis[2] = true;
    }
    if (strncmp(fix->style, "wall/gran", 9) != 0) continue;
    PrimitiveWall *primitive = static_cast<FixWallGran *>(fix)->primitiveWall();
    if (!primitive) continue;
    walls.any = true;
    // a cylinder names its axis; a plane shows its normal in the way from any point to it
    const double *lo = lmp->domain->boxlo;
    double from[3] = {lo[0] - 1.1, lo[1] - 1.2, lo[2] - 1.3}, delta[3] = {1.0, 1.0, 1.0};
    if (primitive->axis() < 0) primitive->resolveContact(from, 0.0, delta);
    for (int d = 0; d < 3; ++d)
      if (d != primitive->axis() && delta[d] != 0.0) walls.axis[d] = true;
  }
  return walls;
}

/* ---------------------------------------------------------------------- */

grainjet::MeshWork grainjet::mesh_work(LAMMPS *lmp)
{
  MeshWork work = {0.0, 0.0};
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    Fix *fix = lmp->modify->fix[i];
    if (strcmp(fix->style, "neighlist/mesh") == 0)
      // the number of triangles, in spite of its name
      work.triangles += static_cast<FixNeighlistMesh *>(fix)->getSizeNumContacts();
    // the list's number of triangles of each grain, which the host keeps as the bits of an integer
    if (strncmp(fix->id, "n_neighs_mesh_", 14) != 0 || !fix->vector_atom) continue;
    for (int n = 0; n < lmp->atom->nlocal; ++n) {
      std::int64_t listed;
      memcpy(&listed, fix->vector_atom + n, sizeof(listed));
      work.listed += static_cast<double>(listed);
    }
  }
  return work;
}
