/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_IMPACT_SPECTRA_H
#define GRAINJET_IMPACT_SPECTRA_H

#include "wall-collisions/collision.h"

#include "physics/statistics/log_histogram.h"

#include <string>
#include <vector>

namespace grainjet {

/* Spectra of the impacts: speed and energies in logarithmic bins, the angle from the normal in steps
   of 5 degrees. Energies are those of one original particle: a grain's over f_cg^3. Each
   spectrum counts grains and original particles.                                     */
class ImpactSpectra {
 public:

  struct Range {
    double least, most;
    int bins;
  };

  ImpactSpectra(const Range &speed, const Range &energy);

  void add(const FinishedCollision &);

  // the table: first line, whole text
  static std::string columns();
  std::string csv() const;

  // for restart files
  std::vector<double> pack() const;
  int unpack(const double *);

 private:

  static constexpr int ANGLES = 18;

  struct Spectrum {
    const char *name;
    LogHistogram grains, particles;
  };

  std::vector<Spectrum> spectra_;
  double angleGrains_[ANGLES], angleParticles_[ANGLES];
};

}

#endif
