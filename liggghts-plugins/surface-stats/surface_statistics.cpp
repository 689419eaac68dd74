/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "surface_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace grainjet;

static const double DEGREE = wear::HALF_PI / 90.0;

// A constant: the division 0/0 would end a run in OpenFOAM, which traps invalid operations
static const double UNDEFINED = std::numeric_limits<double>::quiet_NaN();

/* ---------------------------------------------------------------------- */

void ImpactSums::add(const FinishedCollision &c, double worn)
{
  const double v = c.contact.speed, a = c.contact.angle;
  const double kinetic = 0.5 * c.mass * v * v, cosine = std::cos(a * DEGREE);
  normalPeak = impacts > 0.0 ? std::max(normalPeak, c.contact.normalPeak) : c.contact.normalPeak;
  tangentialPeak = std::max(tangentialPeak, c.contact.tangentialPeak);
  impacts += 1.0;
  particles += c.particles;
  mass += c.mass;
  speed += v;
  speedSquare += v * v;
  angle += a;
  angleSquare += a * a;
  normalEnergy += kinetic * cosine * cosine;
  tangentialEnergy += kinetic * (1.0 - cosine * cosine);
  loss += c.energyLoss();
  wear += worn;
}

void ImpactSums::slide(double work, double worn)
{
  slidingWork += work;
  wear += worn;
}

/* ---------------------------------------------------------------------- */

double ImpactSums::mean(double sum) const
{
  return impacts > 0.0 ? sum / impacts : UNDEFINED;
}

double ImpactSums::speedRms() const { return impacts > 0.0 ? std::sqrt(speedSquare / impacts) : UNDEFINED; }
double ImpactSums::angleRms() const { return impacts > 0.0 ? std::sqrt(angleSquare / impacts) : UNDEFINED; }

/* ---------------------------------------------------------------------- */

SurfaceStatistics::SurfaceStatistics(int meshes, std::shared_ptr<const wear::WearLaw> law, bool temperature)
  : law_(law), temperature_(temperature), regions_(1 + meshes, Region(temperature)), place_(meshes)
{
}

/* ---------------------------------------------------------------------- */

void SurfaceStatistics::size(const std::vector<int> &triangles)
{
  for (std::size_t m = 0; m < triangles.size(); m++) place_[m].resize(triangles[m], NONE);
}

/* ---------------------------------------------------------------------- */

ImpactSums &SurfaceStatistics::at(int mesh, int id)
{
  int &place = place_[mesh][id];
  if (place == NONE) {
    place = static_cast<int>(hit_.size());
    hit_.push_back(ImpactSums());
  }
  return hit_[place];
}

const ImpactSums &SurfaceStatistics::triangle(int mesh, int id) const
{
  static const ImpactSums nothing = ImpactSums();
  const int place = place_[mesh][id];
  return place == NONE ? nothing : hit_[place];
}

/* ----------------------------------------------------------------------
   Impact and sliding are worn apart, since they may belong to different triangles: laws of
   impact take no sliding work, and that of sliding takes nothing else.
------------------------------------------------------------------------- */

double SurfaceStatistics::impact_wear(const FinishedCollision &c) const
{
  if (!law_) return 0.0;
  const double angle = wear::HALF_PI - c.contact.angle * DEGREE;
  return law_->volume(wear::Impact{c.contact.speed, angle, c.mass / c.particles,
    2.0 * c.radius / std::cbrt(c.particles), c.particles, 0.0});
}

double SurfaceStatistics::sliding_wear(double work) const
{
  return law_ ? law_->volume(wear::Impact{0.0, 0.0, 0.0, 0.0, 1.0, work}) : 0.0;
}

double SurfaceStatistics::wear(const FinishedCollision &c) const
{
  return law_ ? impact_wear(c) + sliding_wear(c.contact.slidingWork) : UNDEFINED;
}

/* ---------------------------------------------------------------------- */

void SurfaceStatistics::add(const FinishedCollision &c)
{
  const int mesh = static_cast<int>(c.contact.firstMesh);
  const double worn = impact_wear(c);
  for (int r : {0, 1 + mesh}) {
    regions_[r].moments.add(c);
    regions_[r].sums.add(c, worn);
  }
  at(mesh, static_cast<int>(c.contact.firstTriangle)).add(c, worn);
}

/* ---------------------------------------------------------------------- */

void SurfaceStatistics::add(const SlidingPiece &piece)
{
  const int mesh = static_cast<int>(piece.mesh);
  const double worn = sliding_wear(piece.work);
  for (int r : {0, 1 + mesh}) regions_[r].sums.slide(piece.work, worn);
  at(mesh, static_cast<int>(piece.triangle)).slide(piece.work, worn);
}

/* ---------------------------------------------------------------------- */

std::string SurfaceStatistics::columns(bool temperature)
{
  return "region,area,time,collisions,frequency" + CollisionMoments::moment_columns(temperature)
    + ",particle_frequency" + CollisionMoments::error_columns(temperature) + ",touching,deleted,particles,"
    "impact_mass,impact_speed_rms,impact_angle_rms,kinetic_energy_normal,"
    "kinetic_energy_tangential,energy_loss_total,normal_force_max,tangential_force_max,"
    "sliding_work,wear_volume,wear_depth_mean,wear_depth_max,triangles,triangles_hit";
}

/* ---------------------------------------------------------------------- */

std::string SurfaceStatistics::csv(double time, const std::vector<std::string> &names,
  const std::vector<std::vector<double> > &areas, const std::vector<double> &begun,
  const std::vector<double> &touching) const
{
  std::string text = columns(temperature_) + "\n";
  const auto put = [&text](double value) { text += CollisionMoments::cell(value); };
  for (std::size_t r = 0; r < regions_.size(); r++) {
    const CollisionMoments &moments = regions_[r].moments;
    const ImpactSums &s = regions_[r].sums;
    double area = 0.0, deepest = 0.0, triangles = 0.0, hit = 0.0;
    for (std::size_t m = 0; m < place_.size(); m++) {
      if (r != 0 && r != 1 + m) continue;
      for (std::size_t id = 0; id < place_[m].size(); id++) {
        const ImpactSums &t = triangle(m, id);
        const double size = areas[m][id];
        area += size;
        triangles += 1.0;
        if (t.impacts > 0.0) hit += 1.0;
        if (size > 0.0) deepest = std::max(deepest, t.wear / size);
      }
    }
    const bool worn = law_ && area > 0.0;
    text += r == 0 ? "all" : names[r - 1];
    put(area);
    put(time);
    put(s.impacts);
    put(time > 0 ? s.impacts / time : UNDEFINED);
    text += moments.moments();
    put(time > 0 ? s.particles / time : UNDEFINED);
    text += moments.errors();
    put(touching[r]);
    put(begun[r] - s.impacts - touching[r]);
    put(s.particles);
    put(s.mass);
    put(s.speedRms());
    put(s.angleRms());
    put(s.normalEnergy);
    put(s.tangentialEnergy);
    put(s.loss);
    put(s.impacts > 0.0 ? s.normalPeak : UNDEFINED);
    put(s.impacts > 0.0 ? s.tangentialPeak : UNDEFINED);
    put(s.slidingWork);
    put(law_ ? s.wear : UNDEFINED);
    put(worn ? s.wear / area : UNDEFINED);
    put(worn ? deepest : UNDEFINED);
    put(triangles);
    put(hit);
    text += "\n";
  }
  return text;
}

/* ----------------------------------------------------------------------
   regions, then triangles that have been hit: mesh, ID, sums
------------------------------------------------------------------------- */

std::vector<double> SurfaceStatistics::pack() const
{
  std::vector<double> buffer;
  const auto put = [&buffer](const ImpactSums &sums) {
    buffer.insert(buffer.end(), &sums.impacts, &sums.impacts + ImpactSums::SIZE);
  };
  for (const Region &region : regions_) {
    put(region.sums);
    buffer.resize(buffer.size() + region.moments.packed());
    region.moments.pack(&buffer[buffer.size() - region.moments.packed()]);
  }
  buffer.push_back(hit_.size());
  for (std::size_t m = 0; m < place_.size(); m++)
    for (std::size_t id = 0; id < place_[m].size(); id++)
      if (place_[m][id] != NONE) {
        buffer.push_back(m);
        buffer.push_back(id);
        put(hit_[place_[m][id]]);
      }
  return buffer;
}

/* ---------------------------------------------------------------------- */

void SurfaceStatistics::unpack(const double *next)
{
  const auto take = [&next](ImpactSums &sums) {
    std::copy_n(next, ImpactSums::SIZE, &sums.impacts);
    next += ImpactSums::SIZE;
  };
  for (Region &region : regions_) {
    take(region.sums);
    region.moments.unpack(next);
    next += region.moments.packed();
  }
  for (std::size_t n = static_cast<std::size_t>(*next++); n > 0; n--) {
    const int mesh = static_cast<int>(*next++), id = static_cast<int>(*next++);
    take(at(mesh, id));
  }
}
