/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision-stats/collision_tables.h"

#include <cmath>
#include <cstdio>
#include <limits>

using namespace grainjet;
using Cell = CollisionStatistics::Cell;

// a constant: the division 0/0 would end a run in OpenFOAM, which traps invalid operations
static const double UNDEFINED = std::numeric_limits<double>::quiet_NaN();

// b may be undefined, which an ordinary comparison traps there as well
static double ratio(double a, double b) { return std::isgreater(b, 0.0) ? a / b : UNDEFINED; }

/* ---------------------------------------------------------------------- */

static void put(std::string &text, double value)
{
  char number[32];
  snprintf(number, sizeof(number), ",%.10g", value);
  text += number;
}

/* ---------------------------------------------------------------------- */

namespace {

// the rows of a table, each with the region and the pair of types that it is about
struct Row {
  int region, pair;         // of CollisionStatistics::sum
  int type1, type2;         // 0: all
  std::string name() const { return region == 0 ? "all" : "bin" + std::to_string(region); }
  std::string types() const
  {
    return pair == 0 ? "all" : std::to_string(type1) + "-" + std::to_string(type2);
  }
};

std::vector<Row> rows(const CollisionStatistics &statistics)
{
  std::vector<Row> list;
  for (int region = 0; region < statistics.regions(); ++region) {
    list.push_back({region, 0, 0, 0});
    if (statistics.types() == 1) continue;
    for (int a = 1; a <= statistics.types(); ++a)
      for (int b = a; b <= statistics.types(); ++b) list.push_back({region, statistics.pair(a, b) + 1, a, b});
  }
  return list;
}

}

/* ---------------------------------------------------------------------- */

std::string CollisionTables::totalsColumns()
{
  std::string text = "region,from,to,types,time,volume,grains_1,grains_2,collisions,touching,lost,frequency,"
    "frequency_per_volume,frequency_per_grain_1,frequency_per_grain_2,particle_frequency_per_volume,"
    "frequency_per_particle_1,frequency_per_particle_2,normal_energy_sum,tangential_energy_sum,dissipated_energy_sum";
  for (const CollisionStatistics::Quantity &q : CollisionStatistics::quantities())
    for (const char *moment : {"_mean", "_variance", "_skewness", "_standard_error"})
      text += std::string(",") + q.name + moment;
  return text;
}

/* ----------------------------------------------------------------------
   What the particles do that the grains stand for, were they on their own: in a gas of equal velocities a grain meets
   another f times less often than a particle does, and there are f^3 times fewer of them, so
   f^4 collisions of particles go with one of grains
------------------------------------------------------------------------- */

namespace {

struct Particles {
  double collisions = 0.0, number1 = 0.0, number2 = 0.0;

  Particles(const CollisionStatistics &statistics, const CollisionSurroundings &around, const Row &row)
  {
    for (int a = 1; a <= statistics.types(); ++a) {
      const double f = around.factor[a - 1];
      const double number = f * f * f * statistics.grains(row.region, a);
      if (row.type1 == 0 || row.type1 == a) number1 += number;
      if (row.type2 == 0 || row.type2 == a) number2 += number;
      // grains of unlike factors do not touch
      for (int b = a; b <= statistics.types(); ++b)
        if (row.pair == 0 || (row.type1 == a && row.type2 == b))
          collisions += f * f * f * f * statistics.collisions(row.region, statistics.pair(a, b) + 1);
    }
  }
};

}

/* ---------------------------------------------------------------------- */

std::string CollisionTables::totals(const CollisionStatistics &statistics, const CollisionSurroundings &around)
{
  std::string text = totalsColumns() + "\n";
  for (const Row &row : rows(statistics)) {
    const Cell cell = statistics.sum(row.region, row.pair);
    const double n = cell.collisions(), time = around.time, volume = around.volumes[row.region];
    const double touching = statistics.sum(around.touching, row.region, row.pair);
    const double grains1 = ratio(statistics.grains(row.region, row.type1), around.samples);
    const double grains2 = ratio(statistics.grains(row.region, row.type2), around.samples);
    // two equal partners of one collision, or one of each type
    const double each = row.type1 == row.type2 ? 2.0 : 1.0;
    const Particles particles(statistics, around, row);
    const AxisBins &bins = statistics.bins();

    text += row.name();
    put(text, row.region == 0 ? UNDEFINED : bins.edge(row.region - 1));
    put(text, row.region == 0 ? UNDEFINED : bins.edge(row.region));
    text += "," + row.types();
    for (double x : {time, volume, grains1, grains2, n, touching, cell.begun - n - touching}) put(text, x);
    put(text, ratio(n, time));
    put(text, ratio(n, time * volume));
    put(text, ratio(each * n, time * grains1));
    put(text, ratio(each * n, time * grains2));
    put(text, ratio(particles.collisions, time * volume));
    put(text, ratio(each * particles.collisions * around.samples, time * particles.number1));
    put(text, ratio(each * particles.collisions * around.samples, time * particles.number2));
    for (int q = 0; q < 3; ++q) put(text, n > 0.0 ? n * cell.moments[q].mean() : 0.0);
    for (const Moments &m : cell.moments)
      for (double x : {m.mean(), m.variance(), m.skewness(), m.standardError()}) put(text, x);
    text += "\n";
  }
  return text;
}

/* ---------------------------------------------------------------------- */

std::string CollisionTables::spectraColumns()
{
  return "region,types,quantity,from,to,collisions,density";
}

std::string CollisionTables::spectra(const CollisionStatistics &statistics)
{
  std::string text = spectraColumns() + "\n";
  for (const Row &row : rows(statistics)) {
    const Cell cell = statistics.sum(row.region, row.pair);
    if (cell.collisions() == 0.0) continue;
    for (std::size_t q = 0; q < cell.spectra.size(); ++q) {
      const LogHistogram &h = cell.spectra[q];
      const auto line = [&](double from, double to, double collisions, double density) {
        text += row.name() + "," + row.types() + "," + CollisionStatistics::quantities()[q].name;
        for (double x : {from, to, collisions, density}) put(text, x);
        text += "\n";
      };
      line(-HUGE_VAL, h.edge(0), h.below(), UNDEFINED);
      for (int i = 0; i < h.bins(); ++i) line(h.edge(i), h.edge(i + 1), h.weight(i), h.density(i));
      line(h.edge(h.bins()), HUGE_VAL, h.above(), UNDEFINED);
    }
  }
  return text;
}
