/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_MAP_SERIES_H
#define GRAINJET_MAP_SERIES_H

#include <string>
#include <vector>

namespace grainjet {

/* Names of the files with surface maps. Without a star in its path there is one, replaced at each
   output. With a star there is one to an output, with the number of the step in place of the
   star, and an index with their times that ParaView opens as a series: <name>.pvd for files
   .vtp, <name>.vtk.series for files .vtk, <name> being the path without the star.    */
class MapSeries {
 public:

  explicit MapSeries(const std::string &path) : path_(path) {}

  // an empty string, or what is wrong with the path
  std::string check() const;

  bool xml() const;
  bool series() const { return path_.find('*') != std::string::npos; }

  const std::string &path() const { return path_; }
  std::string path(double step) const;

  // of the index: path, first line, whole text
  std::string index_path() const;
  std::string index_line() const;
  std::string index() const;

  // An output at this step and time (s); what was noted for this step or later ones is dropped
  void note(double step, double time);

  // for restart files
  std::vector<double> pack() const;
  int unpack(const double *);

 private:

  struct Output {
    double step, time;
  };

  std::string path_;
  std::vector<Output> outputs_;

  bool ends(const std::string &) const;
};

}

#endif
