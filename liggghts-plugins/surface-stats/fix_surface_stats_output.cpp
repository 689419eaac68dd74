/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* What is written: table, spectra, maps, events, restart data */

#include "fix_surface_stats.h"

#include "surface_map.h"

#include "comm.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

using namespace LAMMPS_NS;
using grainjet::FinishedCollision;
using grainjet::ImpactSpectra;
using grainjet::ImpactSums;
using grainjet::SlidingPiece;
using grainjet::SurfaceMap;
using grainjet::SurfaceStatistics;

/* ----------------------------------------------------------------------
   A series has no path that is known beforehand; its pattern stands for all of them, so that two
   fixes do not share one.
------------------------------------------------------------------------- */

std::vector<FixSurfaceStats::Output> FixSurfaceStats::outputs() const
{
  std::vector<Output> list = {{path_, SurfaceStatistics::columns(has_temperature())}};
  if (!spectraPath_.empty()) list.push_back({spectraPath_, ImpactSpectra::columns()});
  if (vtkPath_.empty()) return list;
  list.push_back({vtkPath_, SurfaceMap::first_line(series_->xml())});
  if (series_->series()) list.push_back({series_->index_path(), series_->index_line()});
  return list;
}

/* ---------------------------------------------------------------------- */

std::string FixSurfaceStats::event_columns() const
{
  return std::string("time,id,x,y,z,mesh,triangle,speed_before,speed_after,angle,normal_force_peak,"
    "tangential_force_peak,duration,normal_force,tangential_force,energy_loss,particles,mass,"
    "diameter,sliding_work,wear_volume") + (has_temperature() ? ",temperature" : "");
}

/* ---------------------------------------------------------------------- */

std::string FixSurfaceStats::event(const FinishedCollision &c) const
{
  char line[600];
  const grainjet::Collision &contact = c.contact;
  snprintf(line, sizeof(line),
    "%.9g,%.0f,%.9g,%.9g,%.9g,%.200s,%.0f,%.9g,%.9g,%.9g,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.9g,%.9g,"
    "%.9g,%.9g,%.9g",
    contact.time, c.id, contact.x[0], contact.x[1], contact.x[2],
    meshIDs_[static_cast<int>(contact.firstMesh)].c_str(), contact.firstTriangle, contact.speed,
    c.speedAfter, contact.angle, contact.normalPeak, contact.tangentialPeak, contact.duration,
    contact.normalMean(), contact.tangentialMean(), c.energyLoss(), c.particles,
    c.mass, 2.0 * c.radius, contact.slidingWork, statistics_->wear(c));
  return line + temperature(c);
}

/* ---------------------------------------------------------------------- */

void FixSurfaceStats::find_corners()
{
  if (placed_) return;
  corners_.clear();
  areas_.clear();
  for (int m = 0; m < surface_->meshes(); m++) {
    corners_.push_back(surface_->corners(m));
    areas_.push_back(SurfaceMap::areas(corners_.back()));
  }
  placed_ = !surface_->moves();
}

/* ----------------------------------------------------------------------
   Grains that lie or roll on the surface may never leave it: what they have done so far belongs to
   the output, but it is added for good only when they leave their triangle, so that the
   sums do not depend on when there is output.
------------------------------------------------------------------------- */

void FixSurfaceStats::write()
{
  gather();
  find_corners();
  const std::vector<double> now = touching();
  const std::vector<SlidingPiece> slid = sliding(tracker_->sliding());
  std::string fault;
  if (comm->me == 0) {
    SurfaceStatistics statistics = *statistics_;
    for (const SlidingPiece &piece : slid) statistics.add(piece);
    fault = write_table(statistics, now);
    const bool mapped = update->ntimestep == mapped_ && clock_ == mappedTime_;
    if (fault.empty() && !vtkPath_.empty() && !mapped) fault = write_map(statistics);
  }
  agree(fault);
}

/* ---------------------------------------------------------------------- */

std::string FixSurfaceStats::write_table(const SurfaceStatistics &statistics,
  const std::vector<double> &touching)
{
  std::string fault = replace(path_, SurfaceStatistics::columns(has_temperature()),
    statistics.csv(std::max(clock_ - begin_, 0.0), meshIDs_, areas_, begun_, touching));
  if (fault.empty() && !spectraPath_.empty())
    fault = replace(spectraPath_, ImpactSpectra::columns(), spectra_->csv());
  return fault;
}

/* ---------------------------------------------------------------------- */

std::string FixSurfaceStats::write_map(const SurfaceStatistics &statistics)
{
  SurfaceMap map;
  for (const std::vector<double> &corners : corners_) map.add_triangles(corners);

  // a constant: the division 0/0 would end a run in OpenFOAM, which traps invalid operations
  const double undefined = std::numeric_limits<double>::quiet_NaN();
  const double time = std::max(clock_ - begin_, 0.0);
  const auto field = [&](const std::string &name, const auto &value) {
    std::vector<double> values;
    for (int m = 0; m < surface_->meshes(); m++)
      for (int id = 0; id < surface_->triangles(m); id++)
        values.push_back(value(m, id, statistics.triangle(m, id), areas_[m][id]));
    map.add_field(name, values);
  };
  const auto sum = [&](const std::string &name, double ImpactSums::*member) {
    field(name, [member](int, int, const ImpactSums &s, double) { return s.*member; });
  };
  const auto per_area = [&](const std::string &name, double ImpactSums::*member, double per) {
    field(name, [=](int, int, const ImpactSums &s, double area) {
      return area > 0.0 && per > 0.0 ? s.*member / (area * per) : undefined;
    });
  };

  field("mesh", [](int m, int, const ImpactSums &, double) { return m; });
  field("triangle", [](int, int id, const ImpactSums &, double) { return id; });
  field("area", [](int, int, const ImpactSums &, double area) { return area; });
  sum("impacts", &ImpactSums::impacts);
  sum("particles", &ImpactSums::particles);
  sum("impact_mass", &ImpactSums::mass);
  field("impact_speed_mean", [](int, int, const ImpactSums &s, double) { return s.speedMean(); });
  field("impact_speed_rms", [](int, int, const ImpactSums &s, double) { return s.speedRms(); });
  field("impact_angle_mean", [](int, int, const ImpactSums &s, double) { return s.angleMean(); });
  field("impact_angle_rms", [](int, int, const ImpactSums &s, double) { return s.angleRms(); });
  sum("kinetic_energy_normal", &ImpactSums::normalEnergy);
  sum("kinetic_energy_tangential", &ImpactSums::tangentialEnergy);
  sum("energy_loss", &ImpactSums::loss);
  sum("normal_force_peak", &ImpactSums::normalPeak);
  sum("tangential_force_peak", &ImpactSums::tangentialPeak);
  sum("sliding_work", &ImpactSums::slidingWork);
  per_area("particle_flux", &ImpactSums::particles, time);
  per_area("mass_flux", &ImpactSums::mass, time);
  if (statistics.wears()) {
    sum("wear_volume", &ImpactSums::wear);
    per_area("wear_depth", &ImpactSums::wear, 1.0);
  }

  const double step = update->ntimestep;
  std::string fault = replace(series_->path(step), SurfaceMap::first_line(series_->xml()),
    series_->xml() ? map.vtp(clock_) : map.vtk(clock_));
  if (!fault.empty()) return fault;
  mapped_ = update->ntimestep;
  mappedTime_ = clock_;
  series_->note(step, clock_);
  return series_->series() ? replace(series_->index_path(), series_->index_line(), series_->index()) : "";
}

/* ----------------------------------------------------------------------
   meshes, law of wear, bins of the spectra
------------------------------------------------------------------------- */

std::vector<double> FixSurfaceStats::pack_watched() const
{
  std::vector<double> list(1, meshIDs_.size());
  for (const std::string &mesh : meshIDs_) pack_text(list, mesh);
  pack_text(list, wear_);
  for (const ImpactSpectra::Range &range : {speed_, energy_}) {
    list.push_back(range.least);
    list.push_back(range.most);
    list.push_back(range.bins);
  }
  return list;
}

/* ---------------------------------------------------------------------- */

std::string FixSurfaceStats::compare_watched(const double *&next) const
{
  std::vector<std::string> meshes(static_cast<std::size_t>(*next++));
  std::string names;
  for (std::string &mesh : meshes) {
    mesh = unpack_text(next);
    names += (names.empty() ? "" : ", ") + mesh;
  }
  const std::string wear = unpack_text(next);
  bool same = true;
  for (const ImpactSpectra::Range &range : {speed_, energy_}) {
    same = same && next[0] == range.least && next[1] == range.most && next[2] == range.bins;
    next += 3;
  }
  if (meshes != meshIDs_) return "other meshes, or in another order (" + names + ")";
  if (wear != wear_)
    return wear.empty() ? "no law of wear" : "another law of wear, or other coefficients (" + wear + ")";
  return same ? "" : "spectra with other bins";
}

/* ----------------------------------------------------------------------
   triangles of the meshes, maps of the series, spectra, statistics
------------------------------------------------------------------------- */

std::vector<double> FixSurfaceStats::pack_statistics() const
{
  const std::vector<int> counts = triangles();
  std::vector<double> list(counts.begin(), counts.end());
  for (const std::vector<double> &part : {series_->pack(), spectra_->pack(), statistics_->pack()})
    list.insert(list.end(), part.begin(), part.end());
  return list;
}

/* ---------------------------------------------------------------------- */

void FixSurfaceStats::unpack_statistics(const std::vector<double> &list)
{
  restarted_.assign(list.begin(), list.begin() + meshIDs_.size());
  statistics_->size(restarted_);
  const double *next = list.data() + restarted_.size();
  next += series_->unpack(next);
  next += spectra_->unpack(next);
  statistics_->unpack(next);
}
