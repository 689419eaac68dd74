/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "plate_statistics.h"

#include <limits>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

PlateStatistics::PlateStatistics(const PlateGeometry &geometry, bool temperature)
  : geometry_(geometry), temperature_(temperature), regions_(1 + geometry.rings(), Region(temperature))
{
}

/* ---------------------------------------------------------------------- */

void PlateStatistics::add(const FinishedCollision &collision)
{
  const double place[2] = {collision.contact.a, collision.contact.b};
  const int ring = geometry_.ring(place);
  if (ring < 0) return;
  for (int r : {0, 1 + ring}) {
    regions_[r].particles += collision.particles;
    regions_[r].moments.add(collision);
  }
}

/* ---------------------------------------------------------------------- */

std::string PlateStatistics::columns(bool temperature)
{
  return "region,r_in,r_out,time,collisions,frequency" + CollisionMoments::moment_columns(temperature)
    + ",particle_frequency" + CollisionMoments::error_columns(temperature) + ",touching,deleted";
}

/* ---------------------------------------------------------------------- */

std::string PlateStatistics::csv(double time, const std::vector<double> &begun,
  const std::vector<double> &touching) const
{
  std::string text = columns(temperature_) + "\n";
  const auto put = [&text](double value) { text += CollisionMoments::cell(value); };
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
    text += region.moments.moments();
    put(time > 0 ? region.particles / time : undefined);
    text += region.moments.errors();
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
    buffer.resize(buffer.size() + region.moments.packed());
    region.moments.pack(&buffer[buffer.size() - region.moments.packed()]);
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
    region.moments.unpack(next);
    next += region.moments.packed();
  }
  return true;
}
