/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_wall_roughness.h"

#include "host/fix_arguments.h"
#include "physics/turbulence/grain_random.h"
#include "physics/wall/rough_wall.h"
#include "plate-stats/wall_shear.h"

#include "atom.h"
#include "error.h"
#include "fix_property_atom.h"
#include "fix_wall_gran.h"
#include "modify.h"
#include "primitive_wall.h"
#include "update.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::FixArguments;
using grainjet::contact::Vector3;
using grainjet::turbulence::GrainRandom;

// Beyond that four standard deviations would reach half a right angle
static const double MOST_DEGREES = 11.25;

static Vector3 vector3(const double *v) { return {v[0], v[1], v[2]}; }

/* ---------------------------------------------------------------------- */

FixWallRoughness::FixWallRoughness(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg),
  deviation_(-1.0), seed_(1), wall_(NULL), turns_(NULL), begun_(0.0)
{
  FixArguments arguments(error, narg, arg);
  while (arguments.more()) {
    const std::string keyword = arguments.keyword({"wall", "angle", "seed"});
    if (keyword == "wall") wallID_ = arguments.word("ID of a fix wall/gran after 'wall'");
    else if (keyword == "angle") {
      deviation_ = arguments.nonNegative("angle", MOST_DEGREES) * grainjet::wall::HALF_PI / 90.0;
    } else seed_ = arguments.count("seed");
  }
  if (wallID_.empty()) arguments.fail("missing keyword wall");
  if (deviation_ < 0.0) arguments.fail("missing keyword angle");
  if (!atom->sphere_flag) arguments.fail("requires atom_style granular (spheres)");
  const std::string fault = find_wall();
  if (!fault.empty()) arguments.fail(fault);

  vector_flag = 1;
  size_vector = 2;
  global_freq = 1;
  extvector = 1;
}

/* ---------------------------------------------------------------------- */

int FixWallRoughness::setmask()
{
  return PRE_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixWallRoughness::fail(const std::string &message) const
{
  const std::string text = std::string("Fix wall/roughness (ID ") + id + "): " + message;
  error->all(FLERR, text.c_str());
  std::abort();    // never reached: Error::all ends the program
}

/* ----------------------------------------------------------------------
   Meshes are left out: a grain may touch several triangles, whose normals LIGGGHTS does not keep.
------------------------------------------------------------------------- */

std::string FixWallRoughness::find_wall()
{
  const int ifix = modify->find_fix(wallID_.c_str());
  wall_ = ifix < 0 ? NULL : dynamic_cast<FixWallGran *>(modify->fix[ifix]);
  if (!wall_ || strncmp(wall_->style, "wall/gran", 9) != 0)
    return "wall '" + wallID_ + "' is not the ID of a fix wall/gran defined before";
  if (wall_->is_mesh_wall())
    return "wall '" + wallID_ + "' consists of meshes; only a primitive wall can be rough, such as "
      "'primitive type 1 zcylinder <radius> <x> <y>'";
  return "";
}

/* ---------------------------------------------------------------------- */

void FixWallRoughness::post_create()
{
  const std::string name = std::string("wallTurn_") + id;
  if (modify->find_fix(name.c_str()) >= 0)
    fail("the script has a fix with ID " + name + ", which is the name of a property of this fix; give that fix another ID");
  std::vector<const char *> args = {name.c_str(), "all", "property/atom", name.c_str(), "vector", "yes", "no", "no",
    "0.", "0.", "0.", "0."};
  turns_ = modify->add_fix_property_atom(args.size(), const_cast<char **>(args.data()), style);

  // it has its initial state; the first setup would set it once more
  turns_->just_created = 0;
}

/* ---------------------------------------------------------------------- */

void FixWallRoughness::pre_delete(bool unfixflag)
{
  if (unfixflag && turns_) modify->delete_fix(turns_->id);
}

/* ---------------------------------------------------------------------- */

void FixWallRoughness::init()
{
  const std::string fault = find_wall();    // it may have been replaced since
  if (!fault.empty()) fail(fault);
  if (strcmp(update->integrate_style, "verlet") != 0)
    fail(std::string("requires run_style verlet, not ") + update->integrate_style);
  for (int i = 0; i < modify->nfix; i++) {
    if (modify->fix[i] == this) break;
    if (modify->fix[i] == wall_) return;
  }
  fail("must be defined behind its wall '" + wallID_ + "'");
}

/* ----------------------------------------------------------------------
   The wall's own test; towards: from the grain's centre to the wall, m
------------------------------------------------------------------------- */

bool FixWallRoughness::touches(int i, double *towards) const
{
  return wall_->primitiveWall()->resolveContact(atom->x[i], atom->radius[i], towards) <= 0.0;
}

/* ----------------------------------------------------------------------
   Behind the wall's own pre_force, which brings its list of near grains up to date, and before its forces
------------------------------------------------------------------------- */

void FixWallRoughness::pre_force(int)
{
  double **turns = turns_->array_atom;
  double towards[3];
  for (int i = 0; i < atom->nlocal; i++)
    if (turns[i][0] != 0.0 && !touches(i, towards)) {
      apply(i, 1.0);
      for (int k = 0; k < 4; k++) turns[i][k] = 0.0;
    }

  int *near;
  const int n = wall_->primitiveWall()->getNeighbors(near);
  for (int j = 0; j < n; j++) {
    const int i = near[j];
    if ((atom->mask[i] & groupbit) && (atom->mask[i] & wall_->groupbit) && turns[i][0] == 0.0
      && touches(i, towards)) begin(i, towards);
  }
}

/* ---------------------------------------------------------------------- */

void FixWallRoughness::begin(int i, const double *towards)
{
  double *turn = turns_->array_atom[i];
  turn[0] = 1.0;
  begun_ += 1.0;

  double surface[3] = {0.0, 0.0, 0.0};
  if (wall_shears(wall_)) wall_shear(wall_, atom->x[i], surface);
  const Vector3 velocity = vector3(atom->v[i]) - vector3(surface);
  const Vector3 to = vector3(towards);
  const double distance = length(to);
  if (distance == 0.0) return;    // the centre lies on the wall: it has no side
  const Vector3 normal = -1.0 / distance * to;

  const GrainRandom random(seed_, atom->tag[i], update->ntimestep, GrainRandom::ROUGHNESS);
  const Vector3 facet = grainjet::wall::facet(normal, velocity, deviation_, random);
  const Vector3 rotation = grainjet::wall::turn(normal, facet);
  turn[1] = rotation.x;
  turn[2] = rotation.y;
  turn[3] = rotation.z;
  apply(i, -1.0);
}

/* ----------------------------------------------------------------------
   sign 1: by the turn from wall to facet, -1: by its opposite
------------------------------------------------------------------------- */

void FixWallRoughness::apply(int i, double sign)
{
  double surface[3] = {0.0, 0.0, 0.0};
  if (wall_shears(wall_)) wall_shear(wall_, atom->x[i], surface);
  const Vector3 rotation = sign * vector3(turns_->array_atom[i] + 1);
  const Vector3 v = vector3(surface) + grainjet::wall::turned(vector3(atom->v[i]) - vector3(surface), rotation);
  const Vector3 omega = grainjet::wall::turned(vector3(atom->omega[i]), rotation);
  const double values[6] = {v.x, v.y, v.z, omega.x, omega.y, omega.z};
  for (int k = 0; k < 3; k++) {
    atom->v[i][k] = values[k];
    atom->omega[i][k] = values[3 + k];
  }
}

/* ---------------------------------------------------------------------- */

double FixWallRoughness::compute_vector(int n)
{
  double mine = begun_, all = 0.0;
  if (n == 1) {
    mine = 0.0;
    for (int i = 0; i < atom->nlocal; i++) mine += turns_->array_atom[i][0];
  }
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}
