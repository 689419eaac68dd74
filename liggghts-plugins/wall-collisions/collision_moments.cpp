/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision_moments.h"

#include <cstdio>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

std::vector<std::string> CollisionMoments::quantities(bool temperature)
{
  std::vector<std::string> names = {
    "normal_force_peak", "tangential_force_peak", "normal_force", "tangential_force",
    "impact_speed", "impact_angle", "duration", "energy_loss"};
  if (temperature) names.push_back("temperature");
  return names;
}

/* ---------------------------------------------------------------------- */

std::string CollisionMoments::moment_columns(bool temperature)
{
  std::string text;
  for (const std::string &name : quantities(temperature))
    text += "," + name + "_mean," + name + "_variance," + name + "_skewness";
  return text;
}

/* ---------------------------------------------------------------------- */

std::string CollisionMoments::error_columns(bool temperature)
{
  std::string text;
  for (const std::string &name : quantities(temperature)) text += "," + name + "_standard_error";
  return text;
}

/* ---------------------------------------------------------------------- */

void CollisionMoments::add(const FinishedCollision &collision)
{
  const Collision &contact = collision.contact;
  const double values[] = {contact.normalPeak, contact.tangentialPeak,
    contact.normalMean(), contact.tangentialMean(), contact.speed, contact.angle,
    contact.duration, collision.energyLoss(), contact.temperature};
  for (std::size_t q = 0; q < moments_.size(); q++) moments_[q].add(values[q]);
}

/* ---------------------------------------------------------------------- */

std::string CollisionMoments::cell(double value)
{
  char number[32];
  snprintf(number, sizeof(number), ",%.10g", value);
  return number;
}

/* ---------------------------------------------------------------------- */

std::string CollisionMoments::moments() const
{
  std::string text;
  for (const Moments &m : moments_) text += cell(m.mean()) + cell(m.variance()) + cell(m.skewness());
  return text;
}

/* ---------------------------------------------------------------------- */

std::string CollisionMoments::errors() const
{
  std::string text;
  for (const Moments &m : moments_) text += cell(m.standardError());
  return text;
}

/* ---------------------------------------------------------------------- */

void CollisionMoments::pack(double *buffer) const
{
  for (std::size_t q = 0; q < moments_.size(); q++) moments_[q].pack(buffer + q * Moments::PACKED);
}

/* ---------------------------------------------------------------------- */

void CollisionMoments::unpack(const double *buffer)
{
  for (std::size_t q = 0; q < moments_.size(); q++)
    moments_[q] = Moments::unpack(buffer + q * Moments::PACKED);
}
