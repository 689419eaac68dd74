/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_COLLISION_STATISTICS_H
#define GRAINJET_COLLISION_STATISTICS_H

#include "collision-stats/grain_collision.h"
#include "physics/statistics/log_histogram.h"
#include "physics/statistics/moments.h"

#include <vector>

namespace grainjet {

// Slabs of equal width along an axis; count is the index of all that lies in none
struct AxisBins {
  int axis = -1;                // 0 1 2: x y z; -1: there are none
  double low = 0.0, high = 0.0; // m
  int count = 0;

  int find(const double *x) const;
  double edge(int i) const { return i == count ? high : low + (high - low) * i / count; }
  bool operator==(const AxisBins &) const;
};

struct SpectrumBins {
  double least, most;
  int count;
};

/* Collisions that are over, by cell: slab of the first contact and pair of types. Every cell has the moments
   and the spectrum of every quantity. Those of two ranks merge into those of both.            */
class CollisionStatistics {
 public:

  // energy [J], speed [m/s], force [N], duration [s]
  enum Kind { ENERGY, SPEED, FORCE, DURATION, KINDS };

  struct Quantity {
    const char *name;
    Kind kind;
    double (*value)(const GrainCollision &);
  };
  static const std::vector<Quantity> &quantities();

  // doubles that the statistics of so many cells take, with the edges of the spectra
  static double numbers(double cells, const SpectrumBins (&)[KINDS]);

  CollisionStatistics(const AxisBins &, int types, const SpectrumBins (&)[KINDS]);

  // one pair of two equal or different types, from 1 on, in any order
  int pair(int type1, int type2) const;
  int pairs() const { return types_ * (types_ + 1) / 2; }
  int types() const { return types_; }
  const AxisBins &bins() const { return bins_; }

  int cell(const double *x, int type1, int type2) const { return bins_.find(x) * pairs() + pair(type1, type2); }
  int cells() const { return (bins_.count + 1) * pairs(); }

  void begin(int cell) { cells_[cell].begun += 1.0; }
  void add(const GrainCollision &);
  void addGrain(const double *x, int type) { grains_[bins_.find(x) * types_ + type - 1] += 1.0; }

  void merge(const CollisionStatistics &);
  void clear();

  struct Cell {
    double begun = 0.0;
    std::vector<Moments> moments;         // of each quantity
    std::vector<LogHistogram> spectra;

    double collisions() const { return moments.front().count(); }
    void merge(const Cell &);
  };

  // ---- a region (0: everywhere, then the slabs) and a pair of types (0: all, then pair() + 1)

  int regions() const { return 1 + bins_.count; }
  Cell sum(int region, int pair) const;
  double collisions(int region, int pair) const;
  double grains(int region, int type) const;      // sum over samples; type 0: all

  // the same sum of numbers of each cell
  double sum(const std::vector<double> &ofCells, int region, int pair) const;

  // ---- as doubles

  std::vector<double> pack() const;
  bool unpack(const std::vector<double> &);       // false: of other cells or spectra

 private:

  AxisBins bins_;
  int types_;
  std::vector<Cell> cells_;
  std::vector<double> grains_;    // by slab and type
  Cell none_;
};

}

#endif
