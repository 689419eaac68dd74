/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_SURFACE_MAP_H
#define GRAINJET_SURFACE_MAP_H

#include <string>
#include <vector>

namespace grainjet {

/* Triangles with numbers on them as a file for ParaView: VTK's XML format (.vtp, binary appended)
   or its legacy format (.vtk, binary). Written without the VTK library, which not every
   build of LIGGGHTS has.                                                             */
class SurfaceMap {
 public:

  // corners: 9 numbers to a triangle (m); those at the same place become one point
  void add_triangles(const std::vector<double> &corners);

  std::size_t triangles() const { return corner_.size() / 3; }

  // one number to a triangle
  void add_field(const std::string &name, const std::vector<double> &values)
  {
    fields_.push_back(Field{name, values});
  }

  // what the files begin with, without the line's end
  static std::string first_line(bool xml);

  // the whole file; time: s
  std::string vtp(double time) const;
  std::string vtk(double time) const;

  // m2 of triangles with these corners
  static std::vector<double> areas(const std::vector<double> &corners);

 private:

  struct Field {
    std::string name;
    std::vector<double> values;
  };

  std::vector<double> points_;
  std::vector<int> corner_;       // points of the triangles
  std::vector<Field> fields_;
};

}

#endif
