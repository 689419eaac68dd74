/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* What is written: the table, the events, restart data */

#include "fix_plate_stats.h"

#include "comm.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace LAMMPS_NS;
using grainjet::FinishedCollision;
using grainjet::PlateStatistics;

// of the restart data: centre and normal, radius, rings
static const int GEOMETRY = 8;

/* ---------------------------------------------------------------------- */

const char *FixPlateStats::beside_hint() const
{
  return "has touched grains, but none at the plate so far; check centre and normal";
}

/* ---------------------------------------------------------------------- */

std::vector<FixPlateStats::Output> FixPlateStats::outputs() const
{
  return {{path_, PlateStatistics::columns(has_temperature())}};
}

/* ---------------------------------------------------------------------- */

std::string FixPlateStats::event_columns() const
{
  return std::string("time,id,x,y,speed_before,speed_after,angle,normal_force_peak,"
    "tangential_force_peak,duration,normal_force,tangential_force,energy_loss,particles")
    + (has_temperature() ? ",temperature" : "");
}

/* ---------------------------------------------------------------------- */

std::string FixPlateStats::event(const FinishedCollision &c) const
{
  char line[400];
  snprintf(line, sizeof(line),
    "%.9g,%.0f,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g",
    c.contact.time, c.id, c.contact.a, c.contact.b, c.contact.speed, c.speedAfter,
    c.contact.angle, c.contact.normalPeak, c.contact.tangentialPeak, c.contact.duration,
    c.contact.normalMean(), c.contact.tangentialMean(), c.energyLoss(), c.particles);
  return line + temperature(c);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::write()
{
  gather();
  const std::vector<double> now = touching();
  std::string fault;
  if (comm->me == 0)
    fault = replace(path_, PlateStatistics::columns(has_temperature()),
      statistics_->csv(std::max(clock_ - begin_, 0.0), begun_, now));
  agree(fault);
}

/* ---------------------------------------------------------------------- */

std::vector<double> FixPlateStats::pack_watched() const
{
  std::vector<double> list(plate_->centre(), plate_->centre() + 3);
  list.insert(list.end(), plate_->normal(), plate_->normal() + 3);
  list.push_back(plate_->radius());
  list.push_back(plate_->rings());
  return list;
}

/* ----------------------------------------------------------------------
   how the plate of a restart file differs from this one; numbers may have gone through a
   script's variables
------------------------------------------------------------------------- */

std::string FixPlateStats::compare_watched(const double *&next) const
{
  const double SAME = 1e-9;
  const double radius = plate_->radius(), *stored = next;
  next += GEOMETRY;
  if (stored[7] != plate_->rings()) return "another number of rings";
  if (!(std::fabs(stored[6] - radius) <= SAME * radius)) return "another radius";
  for (int dim = 0; dim < 3; dim++) {
    if (!(std::fabs(stored[dim] - plate_->centre()[dim]) <= SAME * radius))
      return "another centre";
    if (!(std::fabs(stored[3 + dim] - plate_->normal()[dim]) <= SAME)) return "another normal";
  }
  return "";
}
