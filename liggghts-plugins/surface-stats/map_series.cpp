/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "map_series.h"

#include <cstdio>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

bool MapSeries::ends(const std::string &ending) const
{
  return path_.size() >= ending.size()
    && path_.compare(path_.size() - ending.size(), ending.size(), ending) == 0;
}

/* ---------------------------------------------------------------------- */

std::string MapSeries::check() const
{
  if (!ends(".vtp") && !ends(".vtk"))
    return "the path after 'vtk' must end with .vtp or .vtk, not '" + path_ + "'";
  const std::size_t star = path_.find('*'), slash = path_.rfind('/');
  if (star == std::string::npos) return "";
  if (path_.find('*', star + 1) != std::string::npos || (slash != std::string::npos && star < slash))
    return "the path after 'vtk' may have one *, in the name of the file: '" + path_ + "'";
  return "";
}

/* ---------------------------------------------------------------------- */

bool MapSeries::xml() const
{
  return ends(".vtp");
}

/* ---------------------------------------------------------------------- */

std::string MapSeries::path(double step) const
{
  const std::size_t star = path_.find('*');
  if (star == std::string::npos) return path_;
  char number[32];
  snprintf(number, sizeof(number), "%.0f", step);
  return path_.substr(0, star) + number + path_.substr(star + 1);
}

/* ----------------------------------------------------------------------
   "wear_*.vtp" gives "wear.pvd"; a name of nothing but the star gives "surface.pvd"
------------------------------------------------------------------------- */

std::string MapSeries::index_path() const
{
  std::string name = path_.substr(0, path_.size() - 4);
  name.erase(name.find('*'), 1);
  while (!name.empty() && std::string("_-.").find(name.back()) != std::string::npos) name.pop_back();
  if (name.empty() || name.back() == '/') name += "surface";
  return name + (xml() ? ".pvd" : ".vtk.series");
}

/* ---------------------------------------------------------------------- */

std::string MapSeries::index_line() const
{
  return xml() ? "<?xml version=\"1.0\"?><!-- Grainjet: series of fix surface/stats -->"
               : "{ \"file-series-version\" : \"1.0\", \"written-by\" : \"Grainjet: fix surface/stats\",";
}

/* ---------------------------------------------------------------------- */

std::string MapSeries::index() const
{
  std::string list;
  for (const Output &output : outputs_) {
    const std::string whole = path(output.step), name = whole.substr(whole.rfind('/') + 1);
    char time[32];
    snprintf(time, sizeof(time), "%.10g", output.time);
    if (xml())
      list += std::string("<DataSet timestep=\"") + time + "\" group=\"\" part=\"0\" file=\"" + name + "\"/>\n";
    else
      list += std::string(list.empty() ? "" : ",\n") + "{ \"name\" : \"" + name + "\", \"time\" : " + time + " }";
  }
  if (xml())
    return index_line() + "\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" + list
      + "</Collection>\n</VTKFile>\n";
  return index_line() + "\n\"files\" : [\n" + list + "\n] }\n";
}

/* ---------------------------------------------------------------------- */

void MapSeries::note(double step, double time)
{
  while (!outputs_.empty() && outputs_.back().step >= step) outputs_.pop_back();
  outputs_.push_back(Output{step, time});
}

/* ---------------------------------------------------------------------- */

std::vector<double> MapSeries::pack() const
{
  std::vector<double> list(1, outputs_.size());
  for (const Output &output : outputs_) {
    list.push_back(output.step);
    list.push_back(output.time);
  }
  return list;
}

/* ---------------------------------------------------------------------- */

int MapSeries::unpack(const double *list)
{
  outputs_.resize(static_cast<std::size_t>(list[0]));
  for (std::size_t n = 0; n < outputs_.size(); n++)
    outputs_[n] = Output{list[1 + 2 * n], list[2 + 2 * n]};
  return 1 + 2 * static_cast<int>(outputs_.size());
}
