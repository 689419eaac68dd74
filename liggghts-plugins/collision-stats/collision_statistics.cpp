/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision-stats/collision_statistics.h"

#include <algorithm>
#include <stdexcept>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

int AxisBins::find(const double *x) const
{
  if (count == 0) return 0;
  const double at = x[axis];
  if (!(at >= low && at < high)) return count;
  return std::min(static_cast<int>(count * ((at - low) / (high - low))), count - 1);
}

bool AxisBins::operator==(const AxisBins &other) const
{
  return axis == other.axis && low == other.low && high == other.high && count == other.count;
}

/* ---------------------------------------------------------------------- */

const std::vector<CollisionStatistics::Quantity> &CollisionStatistics::quantities()
{
  using C = GrainCollision;
  static const std::vector<Quantity> list = {
    {"normal_energy", ENERGY, [](const C &c) { return c.normalEnergy; }},
    {"tangential_energy", ENERGY, [](const C &c) { return c.tangentialEnergy; }},
    {"dissipated_energy", ENERGY, [](const C &c) { return c.loss; }},
    {"impact_speed", SPEED, [](const C &c) { return c.speed; }},
    {"normal_force_peak", FORCE, [](const C &c) { return c.normalPeak; }},
    {"tangential_force_peak", FORCE, [](const C &c) { return c.tangentialPeak; }},
    {"duration", DURATION, [](const C &c) { return c.duration; }}};
  return list;
}

/* ---------------------------------------------------------------------- */

double CollisionStatistics::numbers(double cells, const SpectrumBins (&spectra)[KINDS])
{
  double one = 1.0;
  for (const Quantity &q : quantities()) one += Moments::PACKED + 2.0 * LogHistogram::packed(spectra[q.kind].count);
  return cells * one;
}

/* ---------------------------------------------------------------------- */

CollisionStatistics::CollisionStatistics(const AxisBins &bins, int types, const SpectrumBins (&spectra)[KINDS])
  : bins_(bins), types_(types), grains_((bins.count + 1) * types, 0.0)
{
  none_.moments.resize(quantities().size());
  for (const Quantity &q : quantities()) {
    const SpectrumBins &s = spectra[q.kind];
    none_.spectra.emplace_back(s.least, s.most, s.count);
  }
  cells_.assign(cells(), none_);
}

/* ---------------------------------------------------------------------- */

int CollisionStatistics::pair(int type1, int type2) const
{
  const int a = std::min(type1, type2) - 1, b = std::max(type1, type2) - 1;
  return a * types_ - a * (a - 1) / 2 + b - a;
}

/* ---------------------------------------------------------------------- */

void CollisionStatistics::add(const GrainCollision &collision)
{
  Cell &cell = cells_[collision.cell()];
  for (std::size_t q = 0; q < quantities().size(); ++q) {
    const double value = quantities()[q].value(collision);
    cell.moments[q].add(value);
    cell.spectra[q].add(value);
  }
}

/* ---------------------------------------------------------------------- */

void CollisionStatistics::Cell::merge(const Cell &other)
{
  begun += other.begun;
  if (other.collisions() == 0.0) return;
  for (std::size_t q = 0; q < moments.size(); ++q) {
    moments[q].merge(other.moments[q]);
    if (!spectra[q].merge(other.spectra[q])) throw std::logic_error("spectra of other edges");
  }
}

void CollisionStatistics::merge(const CollisionStatistics &other)
{
  for (std::size_t c = 0; c < cells_.size(); ++c) cells_[c].merge(other.cells_[c]);
  for (std::size_t g = 0; g < grains_.size(); ++g) grains_[g] += other.grains_[g];
}

void CollisionStatistics::clear()
{
  std::fill(cells_.begin(), cells_.end(), none_);
  std::fill(grains_.begin(), grains_.end(), 0.0);
}

/* ----------------------------------------------------------------------
   Of a list by slab, and in each slab by kind: what belongs to a region and a kind. 0: all, also what is in no slab
------------------------------------------------------------------------- */

template <class Use>
static void select(int slabs, int kinds, int region, int kind, const Use &use)
{
  for (int r = region == 0 ? 0 : region - 1; r < (region == 0 ? slabs : region); ++r)
    for (int k = kind == 0 ? 0 : kind - 1; k < (kind == 0 ? kinds : kind); ++k) use(r * kinds + k);
}

CollisionStatistics::Cell CollisionStatistics::sum(int region, int pair) const
{
  Cell sum = none_;
  select(bins_.count + 1, pairs(), region, pair, [&](int c) { sum.merge(cells_[c]); });
  return sum;
}

double CollisionStatistics::collisions(int region, int pair) const
{
  double sum = 0.0;
  select(bins_.count + 1, pairs(), region, pair, [&](int c) { sum += cells_[c].collisions(); });
  return sum;
}

double CollisionStatistics::sum(const std::vector<double> &ofCells, int region, int pair) const
{
  double sum = 0.0;
  select(bins_.count + 1, pairs(), region, pair, [&](int c) { sum += ofCells[c]; });
  return sum;
}

double CollisionStatistics::grains(int region, int type) const
{
  double sum = 0.0;
  select(bins_.count + 1, types_, region, type, [&](int g) { sum += grains_[g]; });
  return sum;
}

/* ---------------------------------------------------------------------- */

std::vector<double> CollisionStatistics::pack() const
{
  std::vector<double> list = grains_;
  for (const Cell &cell : cells_) {
    list.push_back(cell.begun);
    for (std::size_t q = 0; q < cell.moments.size(); ++q) {
      const std::size_t at = list.size();
      list.resize(at + Moments::PACKED + cell.spectra[q].packed());
      cell.moments[q].pack(&list[at]);
      cell.spectra[q].pack(&list[at + Moments::PACKED]);
    }
  }
  return list;
}

/* ---------------------------------------------------------------------- */

bool CollisionStatistics::unpack(const std::vector<double> &list)
{
  std::size_t size = grains_.size();
  for (const Cell &cell : cells_) {
    size += 1;
    for (const LogHistogram &spectrum : cell.spectra) size += Moments::PACKED + spectrum.packed();
  }
  if (list.size() != size) return false;
  const double *next = list.data();
  std::vector<double> grains(next, next + grains_.size());
  next += grains.size();
  std::vector<Cell> cells = cells_;
  for (Cell &cell : cells) {
    cell.begun = *next++;
    for (std::size_t q = 0; q < cell.moments.size(); ++q) {
      cell.moments[q] = Moments::unpack(next);
      const LogHistogram spectrum = LogHistogram::unpack(next + Moments::PACKED);
      if (!spectrum.sameEdges(cell.spectra[q])) return false;
      cell.spectra[q] = spectrum;
      next += Moments::PACKED + spectrum.packed();
    }
  }
  grains_.swap(grains);
  cells_.swap(cells);
  return true;
}
