/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "surface_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <numeric>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

static bool little_endian()
{
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

static std::string print(double value)
{
  char text[32];
  snprintf(text, sizeof(text), "%.17g", value);
  return text;
}

/* ----------------------------------------------------------------------
   Points of equal coordinates are found by sorting; they are numbered in the order in which they
   come first.
------------------------------------------------------------------------- */

void SurfaceMap::add_triangles(const std::vector<double> &corners)
{
  const std::size_t n = corners.size() / 3;
  const auto less = [&corners](std::size_t p, std::size_t q) {
    const double *a = &corners[3 * p], *b = &corners[3 * q];
    for (int dim = 0; dim < 3; dim++)
      if (a[dim] != b[dim]) return a[dim] < b[dim];
    return p < q;
  };
  std::vector<std::size_t> order(n), leader(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), less);
  for (std::size_t k = 0; k < n; k++) {
    const bool same = k > 0 && std::equal(&corners[3 * order[k]], &corners[3 * order[k]] + 3,
      &corners[3 * order[k - 1]]);
    leader[order[k]] = same ? leader[order[k - 1]] : order[k];
  }
  std::vector<int> number(n);
  for (std::size_t p = 0; p < n; p++) {
    if (leader[p] == p) {
      number[p] = static_cast<int>(points_.size() / 3);
      points_.insert(points_.end(), &corners[3 * p], &corners[3 * p] + 3);
    }
    corner_.push_back(number[leader[p]]);
  }
}

/* ---------------------------------------------------------------------- */

std::vector<double> SurfaceMap::areas(const std::vector<double> &corners)
{
  std::vector<double> list;
  for (std::size_t t = 0; t + 9 <= corners.size(); t += 9) {
    const double *c = &corners[t];
    double u[3], v[3], square = 0.0;
    for (int dim = 0; dim < 3; dim++) {
      u[dim] = c[3 + dim] - c[dim];
      v[dim] = c[6 + dim] - c[dim];
    }
    for (int dim = 0; dim < 3; dim++) {
      const int j = (dim + 1) % 3, k = (dim + 2) % 3;
      const double cross = u[j] * v[k] - u[k] * v[j];
      square += cross * cross;
    }
    list.push_back(0.5 * std::sqrt(square));
  }
  return list;
}

/* ---------------------------------------------------------------------- */

std::string SurfaceMap::first_line(bool xml)
{
  return xml ? "<?xml version=\"1.0\"?><!-- Grainjet: fix surface/stats -->"
             : "# vtk DataFile Version 3.0\nGrainjet: fix surface/stats";
}

/* ----------------------------------------------------------------------
   Arrays are described in the head and follow as blocks: number of bytes, then values.
------------------------------------------------------------------------- */

std::string SurfaceMap::vtp(double time) const
{
  std::string head = first_line(true) + "\n", blocks;
  const auto block = [&blocks](const void *data, std::size_t bytes) {
    const std::uint64_t size = bytes;
    blocks.append(reinterpret_cast<const char *>(&size), sizeof(size));
    blocks.append(static_cast<const char *>(data), bytes);
  };
  const auto array = [&](const std::string &type, const std::string &name, const std::string &more,
      const void *data, std::size_t bytes) {
    head += "<DataArray type=\"" + type + "\" Name=\"" + name + "\"" + more
      + " format=\"appended\" offset=\"" + std::to_string(blocks.size()) + "\"/>\n";
    block(data, bytes);
  };
  const std::size_t n = triangles();
  std::vector<std::int64_t> connectivity(corner_.begin(), corner_.end()), offsets(n);
  for (std::size_t t = 0; t < n; t++) offsets[t] = 3 * (t + 1);

  head += std::string("<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"")
    + (little_endian() ? "LittleEndian" : "BigEndian") + "\" header_type=\"UInt64\">\n<PolyData>\n"
    "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">"
    + print(time) + "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\""
    + std::to_string(points_.size() / 3) + "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
    "NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(n) + "\">\n<Points>\n";
  array("Float64", "Points", " NumberOfComponents=\"3\"", points_.data(), points_.size() * sizeof(double));
  head += "</Points>\n<Polys>\n";
  array("Int64", "connectivity", "", connectivity.data(), connectivity.size() * sizeof(std::int64_t));
  array("Int64", "offsets", "", offsets.data(), offsets.size() * sizeof(std::int64_t));
  head += "</Polys>\n<CellData>\n";
  for (const Field &field : fields_)
    array("Float64", field.name, "", field.values.data(), field.values.size() * sizeof(double));
  head += "</CellData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  return head + blocks + "\n</AppendedData>\n</VTKFile>\n";
}

/* ----------------------------------------------------------------------
   The legacy format is big endian.
------------------------------------------------------------------------- */

std::string SurfaceMap::vtk(double time) const
{
  std::string text = first_line(false) + "\nBINARY\nDATASET POLYDATA\n";
  const auto put = [&text](const auto value) {
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    if (little_endian()) std::reverse(bytes, bytes + sizeof(value));
    text.append(bytes, sizeof(value));
  };
  const std::string n = std::to_string(triangles());
  text += "FIELD FieldData 1\nTimeValue 1 1 double\n";
  put(time);
  text += "\nPOINTS " + std::to_string(points_.size() / 3) + " double\n";
  for (double x : points_) put(x);
  text += "\nPOLYGONS " + n + " " + std::to_string(4 * triangles()) + "\n";
  for (std::size_t t = 0; t < triangles(); t++) {
    put(std::int32_t(3));
    for (int node = 0; node < 3; node++) put(std::int32_t(corner_[3 * t + node]));
  }
  text += "\nCELL_DATA " + n + "\nFIELD FieldData " + std::to_string(fields_.size()) + "\n";
  for (const Field &field : fields_) {
    text += field.name + " 1 " + n + " double\n";
    for (double value : field.values) put(value);
    text += "\n";
  }
  return text;
}
