/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "plate_statistics.h"

#include <limits>
#include <cstdio>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

const std::vector<std::string> &PlateStatistics::quantities()
{
  static const std::vector<std::string> names = {
    "normal_force_peak", "tangential_force_peak", "normal_force", "tangential_force",
    "impact_speed", "impact_angle", "duration", "energy_loss"};
  return names;
}

/* ---------------------------------------------------------------------- */

PlateStatistics::PlateStatistics(const PlateGeometry &geometry)
  : geometry_(geometry), regions_(1 + geometry.rings())
{
  for (Region &region : regions_) region.moments.resize(quantities().size());
}

/* ---------------------------------------------------------------------- */

void PlateStatistics::add(const FinishedCollision &collision)
{
  const Collision &contact = collision.contact;
  const double place[2] = {contact.a, contact.b};
  const int ring = geometry_.ring(place);
  if (ring < 0) return;

  const double values[] = {contact.normalPeak, contact.tangentialPeak,
    contact.normalMean(), contact.tangentialMean(), contact.speed, contact.angle,
    contact.duration, collision.energyLoss()};
  for (int r : {0, 1 + ring}) {
    Region &region = regions_[r];
    region.particles += collision.particles;
    for (std::size_t q = 0; q < region.moments.size(); q++) region.moments[q].add(values[q]);
  }
}

/* ---------------------------------------------------------------------- */

std::string PlateStatistics::columns()
{
  std::string text = "region,r_in,r_out,time,collisions,frequency";
  for (const std::string &name : quantities())
    text += "," + name + "_mean," + name + "_variance," + name + "_skewness";
  text += ",particle_frequency";
  for (const std::string &name : quantities()) text += "," + name + "_standard_error";
  return text + ",touching,deleted";
}

/* ---------------------------------------------------------------------- */

std::string PlateStatistics::csv(double time, const std::vector<double> &begun,
  const std::vector<double> &touching) const
{
  std::string text = columns() + "\n";
  const auto put = [&text](double value) {
    char number[32];
    snprintf(number, sizeof(number), ",%.10g", value);
    text += number;
  };
  // a constant: the division 0/0 would end a run in OpenFOAM, which traps invalid operations
  const double undefined = std::numeric_limits<double>::quiet_NaN();
  for (int r = 0; r < regions(); r++) {
    const Region &region = regions_[r];
    text += r == 0 ? "all" : "ring" + std::to_string(r);
    put(r == 0 ? 0.0 : geometry_.innerRadius(r - 1));
    put(r == 0 ? geometry_.radius() : geometry_.innerRadius(r));
    put(time);
    put(collisions(r));
    put(time > 0 ? collisions(r) / time : undefined);
    for (const Moments &m : region.moments) {
      put(m.mean());
      put(m.variance());
      put(m.skewness());
    }
    put(time > 0 ? region.particles / time : undefined);
    for (const Moments &m : region.moments) put(m.standardError());
    put(touching[r]);
    put(begun[r] - collisions(r) - touching[r]);
    text += "\n";
  }
  return text;
}

/* ---------------------------------------------------------------------- */

std::vector<double> PlateStatistics::pack() const
{
  std::vector<double> buffer;
  for (const Region &region : regions_) {
    buffer.push_back(region.particles);
    for (const Moments &m : region.moments) {
      buffer.resize(buffer.size() + Moments::PACKED);
      m.pack(&buffer[buffer.size() - Moments::PACKED]);
    }
  }
  return buffer;
}

/* ---------------------------------------------------------------------- */

bool PlateStatistics::unpack(const std::vector<double> &buffer)
{
  if (buffer.size() != pack().size()) return false;
  const double *next = buffer.data();
  for (Region &region : regions_) {
    region.particles = *next++;
    for (Moments &m : region.moments) {
      m = Moments::unpack(next);
      next += Moments::PACKED;
    }
  }
  return true;
}
