/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_SURFACE_STATISTICS_H
#define GRAINJET_SURFACE_STATISTICS_H

#include "wall-collisions/collision_moments.h"

#include "physics/wear/wear_law.h"

#include <memory>
#include <string>
#include <vector>

namespace grainjet {

/* Sums over the impacts on a triangle, a mesh or all: plain doubles for restart files. SI units;
   energies and forces are the grains'.                                               */
struct ImpactSums {
  double impacts;               // of grains
  double particles;             // of original particles, f_cg^3 to a grain
  double mass;                  // kg
  double speed, speedSquare;    // m/s
  double angle, angleSquare;    // degrees from the normal
  double normalEnergy, tangentialEnergy;    // J, translational, before the impact
  double loss;                  // J, energy before minus after
  double normalPeak, tangentialPeak;        // N, largest of all
  double slidingWork;           // J
  double wear;                  // m3

  static constexpr int SIZE = 14;

  void add(const FinishedCollision &, double wear);
  void slide(double work, double wear);

  // NaN without an impact
  double speedMean() const { return mean(speed); }
  double speedRms() const;
  double angleMean() const { return mean(angle); }
  double angleRms() const;

 private:

  double mean(double sum) const;
};

static_assert(sizeof(ImpactSums) == ImpactSums::SIZE * sizeof(double), "plain doubles only");

/* Statistics of the impacts on meshes: by triangle, by mesh, in total. An impact belongs to the
   triangle of the first touch, sliding work to the triangle on which it was done. Only
   triangles that have been hit hold sums.                                            */
class SurfaceStatistics {
 public:

  // law: none is an empty pointer; temperature: grains have one
  SurfaceStatistics(int meshes, std::shared_ptr<const wear::WearLaw> law, bool temperature);

  // how many triangles each mesh has; to be called before anything is added
  void size(const std::vector<int> &triangles);

  void add(const FinishedCollision &);
  void add(const SlidingPiece &);

  bool wears() const { return law_ != nullptr; }

  // m3 that one collision removes by its impact and sliding; NaN without a law
  double wear(const FinishedCollision &) const;

  // m3 that sliding removes; 0 without a law
  double sliding_wear(double work) const;

  double collisions(int region) const { return regions_[region].sums.impacts; }
  const ImpactSums &sums(int region) const { return regions_[region].sums; }

  // of one triangle; all zero if it was not hit
  const ImpactSums &triangle(int mesh, int id) const;

  // the first line of the table; temperature: grains have one
  static std::string columns(bool temperature);

  // The table as CSV text, one row for all and one for each mesh. time: s over which collisions were
  // counted; areas: m2 of each triangle by mesh; begun, touching: collisions begun in that time
  // and those of them that go on now, all and by mesh
  std::string csv(double time, const std::vector<std::string> &names,
    const std::vector<std::vector<double> > &areas, const std::vector<double> &begun,
    const std::vector<double> &touching) const;

  // for restart files
  std::vector<double> pack() const;
  void unpack(const double *);

 private:

  struct Region {
    explicit Region(bool temperature) : moments(temperature) {}
    CollisionMoments moments;
    ImpactSums sums = {};
  };

  std::shared_ptr<const wear::WearLaw> law_;
  bool temperature_;
  std::vector<Region> regions_;                   // all, then by mesh

  static constexpr int NONE = -1;
  std::vector<std::vector<int> > place_;          // by mesh and triangle: where in hit_
  std::vector<ImpactSums> hit_;

  ImpactSums &at(int mesh, int id);
  double impact_wear(const FinishedCollision &) const;
};

}

#endif
