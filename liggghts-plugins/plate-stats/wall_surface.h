/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WALL_SURFACE_H
#define GRAINJET_WALL_SURFACE_H

#include "plate_geometry.h"

#include "wall-collisions/mesh_contacts.h"
#include "wall-collisions/watched_surface.h"

#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

/* The plate: where the surface of a fix wall/gran is and how fast it moves. Regions are rings.

   At its definition the plate is drawn on every mesh of the wall, and from then on each mesh
   takes its drawing along. A grain is on the plate of the mesh that it touches. Centre,
   normal and first axis are properties of the mesh, which LIGGGHTS moves and rotates with
   the nodes, whatever moves these, and which are the same on all ranks. Of meshes that move
   differently only those bear the plate that lay nearest to its plane then: what lies
   under a thin workpiece does not.

   The velocity at a contact is the one that the wall's law uses: of the nodes of the
   triangle, for surface_vel and surface_ang_vel as well; of `shear` for a primitive wall.

   A wall at rest has one plate, and nothing is looked up.                            */
class WallSurface : protected Pointers, public WatchedSurface {
 public:

  WallSurface(class LAMMPS *, const std::string &wallID, const std::string &fixID,
    const grainjet::PlateGeometry &);

  // Finds the wall, which WallForces has found before, and draws the plate on meshes that are
  // new: returns an empty string or what is wrong. At the definition and at the start of
  // every run.
  std::string attach();

  // takes the drawings off again
  void release();

  // at the start of a run, and in every step when the meshes have moved
  void update();

  bool at_rest() const { return !moves_; }

  void reorder() override;
  bool comes_near(int i) const override;
  bool touch(int i, Touch &) const override;
  bool velocity(int i, Touch &) const override;
  void place(int i, const Touch &, grainjet::Collision &) const override;
  int regions() const override { return plate_.rings(); }
  int region(const grainjet::Collision &) const override;

  // for restart files: IDs of the meshes and the plates drawn on them
  std::vector<double> pack() const;

  // To be called before the first attach(). Returns the number of values that were used.
  int unpack(const double *);

 private:

  static constexpr int FRAME = 9;    // centre, normal, first axis

  struct Drawing {
    std::string meshID;
    double level;            // m, from the plate's plane to the mesh in its middle, when drawn
    double frame[FRAME];
  };

  std::string wallID_, prefix_;
  grainjet::PlateGeometry plate_;      // as the script has it
  double drawn_[FRAME];

  class FixWallGran *wall_;
  std::vector<class FixMeshSurface *> meshes_;
  bool moves_;

  // per mesh
  std::vector<grainjet::PlateGeometry> plates_;
  std::vector<Drawing> drawings_;
  std::vector<char> carried_, bears_;
  std::vector<MeshContacts> contacts_;

  bool attached_;                      // this fix has drawn its plate on the meshes
  std::vector<Drawing> restarted_;     // until then

  class TriMesh *mesh(int) const;
  std::string property(int axis) const;
  std::string check_restarted() const;
  void draw(int);
  double level(int) const;
  void choose_bearers();
  bool touched(int i, Touch &) const;
  double height(int plate, const double *x) const;
  const double *image(int plate, const double *x, double *copy) const;
};

}

#endif
