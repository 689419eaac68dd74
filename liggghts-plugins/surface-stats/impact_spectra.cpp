/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "impact_spectra.h"

#include "wall-collisions/collision_moments.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

ImpactSpectra::ImpactSpectra(const Range &speed, const Range &energy) :
  angleGrains_(), angleParticles_()
{
  const auto spectrum = [this](const char *name, const Range &range) {
    const LogHistogram empty(range.least, range.most, range.bins);
    spectra_.push_back(Spectrum{name, empty, empty});
  };
  spectrum("impact_speed", speed);
  spectrum("kinetic_energy", energy);
  spectrum("kinetic_energy_normal", energy);
  spectrum("kinetic_energy_tangential", energy);
  spectrum("energy_loss", energy);
}

/* ---------------------------------------------------------------------- */

void ImpactSpectra::add(const FinishedCollision &c)
{
  const double v = c.contact.speed, kinetic = 0.5 * c.mass * v * v / c.particles;
  const double cosine = std::cos(c.contact.angle * std::acos(-1.0) / 180.0);
  const double across = kinetic * cosine * cosine;
  const double values[] = {v, kinetic, across, kinetic - across, c.energyLoss() / c.particles};
  for (std::size_t s = 0; s < spectra_.size(); s++) {
    spectra_[s].grains.add(values[s]);
    spectra_[s].particles.add(values[s], c.particles);
  }
  const int bin = std::min(static_cast<int>(c.contact.angle * ANGLES / 90.0), ANGLES - 1);
  angleGrains_[bin] += 1.0;
  angleParticles_[bin] += c.particles;
}

/* ---------------------------------------------------------------------- */

std::string ImpactSpectra::columns()
{
  return "quantity,low,high,collisions,particles,density";
}

/* ----------------------------------------------------------------------
   density: share of the particles per unit of the quantity. What lies below and above all bins
   has rows of its own.
------------------------------------------------------------------------- */

std::string ImpactSpectra::csv() const
{
  const double infinite = std::numeric_limits<double>::infinity();
  const double undefined = std::numeric_limits<double>::quiet_NaN();
  std::string text = columns() + "\n";
  const auto row = [&text](const char *name, std::initializer_list<double> values) {
    text += name;
    for (double value : values) text += CollisionMoments::cell(value);
    text += "\n";
  };
  for (const Spectrum &s : spectra_) {
    const LogHistogram &g = s.grains, &p = s.particles;
    const int n = g.bins();
    row(s.name, {-infinite, g.edge(0), g.below(), p.below(), undefined});
    for (int bin = 0; bin < n; bin++)
      row(s.name, {g.edge(bin), g.edge(bin + 1), g.weight(bin), p.weight(bin), p.density(bin)});
    row(s.name, {g.edge(n), infinite, g.above(), p.above(), undefined});
  }
  double total = 0.0;
  for (double particles : angleParticles_) total += particles;
  const double width = 90.0 / ANGLES;
  for (int bin = 0; bin < ANGLES; bin++)
    row("impact_angle", {bin * width, (bin + 1) * width, angleGrains_[bin], angleParticles_[bin],
      total > 0.0 ? angleParticles_[bin] / (total * width) : undefined});
  return text;
}

/* ---------------------------------------------------------------------- */

std::vector<double> ImpactSpectra::pack() const
{
  std::vector<double> buffer;
  for (const Spectrum &s : spectra_)
    for (const LogHistogram *h : {&s.grains, &s.particles}) {
      buffer.resize(buffer.size() + h->packed());
      h->pack(&buffer[buffer.size() - h->packed()]);
    }
  buffer.insert(buffer.end(), angleGrains_, angleGrains_ + ANGLES);
  buffer.insert(buffer.end(), angleParticles_, angleParticles_ + ANGLES);
  return buffer;
}

/* ---------------------------------------------------------------------- */

int ImpactSpectra::unpack(const double *buffer)
{
  const double *next = buffer;
  for (Spectrum &s : spectra_)
    for (LogHistogram *h : {&s.grains, &s.particles}) {
      *h = LogHistogram::unpack(next);
      next += h->packed();
    }
  std::copy_n(next, ANGLES, angleGrains_);
  std::copy_n(next + ANGLES, ANGLES, angleParticles_);
  return next + 2 * ANGLES - buffer;
}
