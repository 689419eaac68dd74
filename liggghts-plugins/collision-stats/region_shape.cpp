/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "collision-stats/region_shape.h"

#include "host/expose_member.h"

#include "domain.h"
#include "region_cylinder.h"
#include "region_intersect.h"
#include "region_sphere.h"
#include "region_union.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

using namespace grainjet;
using namespace LAMMPS_NS;

namespace grainjet {

struct UnionCount { using type = int RegUnion::*; friend type member(UnionCount); };
struct UnionNames { using type = char **RegUnion::*; friend type member(UnionNames); };
struct IntersectCount { using type = int RegIntersect::*; friend type member(IntersectCount); };
struct IntersectNames { using type = char **RegIntersect::*; friend type member(IntersectNames); };
struct SphereRadius { using type = double RegSphere::*; friend type member(SphereRadius); };
struct CylinderRadius { using type = double RegCylinder::*; friend type member(CylinderRadius); };
struct CylinderAxis { using type = char RegCylinder::*; friend type member(CylinderAxis); };
struct ForwardTransform {
  using type = void (Region::*)(double &, double &, double &);
  friend type member(ForwardTransform);
};

}

template struct grainjet::Expose<grainjet::UnionCount, &RegUnion::nregion>;
template struct grainjet::Expose<grainjet::UnionNames, &RegUnion::idsub>;
template struct grainjet::Expose<grainjet::IntersectCount, &RegIntersect::nregion>;
template struct grainjet::Expose<grainjet::IntersectNames, &RegIntersect::idsub>;
template struct grainjet::Expose<grainjet::SphereRadius, &RegSphere::radius>;
template struct grainjet::Expose<grainjet::CylinderRadius, &RegCylinder::radius>;
template struct grainjet::Expose<grainjet::CylinderAxis, &RegCylinder::axis>;
template struct grainjet::Expose<grainjet::ForwardTransform, &Region::forward_transform>;

/* ---------------------------------------------------------------------- */

static bool is(const Region *region, const char *style) { return strcmp(region->style, style) == 0; }

std::vector<Region *> RegionShape::members(const Domain &domain, Region *region)
{
  int count = 0;
  char **names = nullptr;
  if (is(region, "union")) {
    RegUnion *r = static_cast<RegUnion *>(region);
    count = r->*member(UnionCount());
    names = r->*member(UnionNames());
  } else if (is(region, "intersect")) {
    RegIntersect *r = static_cast<RegIntersect *>(region);
    count = r->*member(IntersectCount());
    names = r->*member(IntersectNames());
  }
  std::vector<Region *> list;
  for (int n = 0; n < count; n++)
    for (int m = 0; m < domain.nregion; m++)
      if (strcmp(domain.regions[m]->id, names[n]) == 0) list.push_back(domain.regions[m]);
  return list;
}

/* ---------------------------------------------------------------------- */

std::vector<Region *> RegionShape::parts(const Domain &domain, Region *region)
{
  if (!is(region, "union") || !region->interior) return {region};
  std::vector<Region *> list;
  for (Region *r : members(domain, region))
    for (Region *part : parts(domain, r)) list.push_back(part);
  return list;
}

/* ---------------------------------------------------------------------- */

Region *RegionShape::of_style(const Domain &domain, Region *region, const char *style)
{
  if (is(region, style)) return region;
  for (Region *r : members(domain, region))
    if (Region *found = of_style(domain, r, style)) return found;
  return nullptr;
}

/* ----------------------------------------------------------------------
   After forward_transform() the region takes its place as known for this step, and match() on some ranks only does
   not evaluate variables
------------------------------------------------------------------------- */

void RegionShape::settle(const Domain &domain, Region *region)
{
  const std::vector<Region *> list = members(domain, region);
  for (Region *r : list) settle(domain, r);
  if (!list.empty()) return;
  region->prematch();
  double x[3] = {0.0, 0.0, 0.0};
  (region->*member(ForwardTransform()))(x[0], x[1], x[2]);
}

/* ----------------------------------------------------------------------
   The extent that LIGGGHTS keeps is that at rest, with the radius of the start
------------------------------------------------------------------------- */

static void at_rest(Region *region, double *low, double *high)
{
  const double least[3] = {region->extent_xlo, region->extent_ylo, region->extent_zlo};
  const double most[3] = {region->extent_xhi, region->extent_yhi, region->extent_zhi};
  std::copy(least, least + 3, low);
  std::copy(most, most + 3, high);
}

static bool moved(Region *region, double *low, double *high)
{
  if (!region->bboxflag) return false;
  double from[3], to[3];
  at_rest(region, from, to);
  if (region->varshape) {
    const bool sphere = is(region, "sphere");
    if (!sphere && !is(region, "cylinder")) return false;
    const double radius = sphere ? static_cast<RegSphere *>(region)->*member(SphereRadius())
      : static_cast<RegCylinder *>(region)->*member(CylinderRadius());
    const int along = sphere ? -1 : static_cast<RegCylinder *>(region)->*member(CylinderAxis()) - 'x';
    for (int d = 0; d < 3; d++) {
      if (d == along) continue;
      const double middle = 0.5 * (from[d] + to[d]);
      from[d] = middle - radius;
      to[d] = middle + radius;
    }
  }
  if (!region->dynamic_check()) {
    std::copy(from, from + 3, low);
    std::copy(to, to + 3, high);
    return true;
  }
  std::fill(low, low + 3, HUGE_VAL);
  std::fill(high, high + 3, -HUGE_VAL);
  for (int corner = 0; corner < 8; corner++) {
    double x[3];
    for (int d = 0; d < 3; d++) x[d] = corner >> d & 1 ? to[d] : from[d];
    (region->*member(ForwardTransform()))(x[0], x[1], x[2]);
    for (int d = 0; d < 3; d++) {
      low[d] = std::min(low[d], x[d]);
      high[d] = std::max(high[d], x[d]);
    }
  }
  return true;
}

/* ---------------------------------------------------------------------- */

bool RegionShape::extent(const Domain &domain, Region *region, double *low, double *high)
{
  const std::vector<Region *> list = members(domain, region);
  if (list.empty()) return moved(region, low, high);
  if (!region->interior) return false;
  const bool all = is(region, "union");
  bool bounded = false;
  for (Region *r : list) {
    double from[3], to[3];
    const bool found = extent(domain, r, from, to);
    if (!found && all) return false;
    if (!found) continue;
    for (int d = 0; d < 3; d++) {
      low[d] = !bounded ? from[d] : all ? std::min(low[d], from[d]) : std::max(low[d], from[d]);
      high[d] = !bounded ? to[d] : all ? std::max(high[d], to[d]) : std::min(high[d], to[d]);
    }
    bounded = true;
  }
  return bounded;
}

/* ----------------------------------------------------------------------
   Of a radius that varies the start depends on the step at which the script defines the region
------------------------------------------------------------------------- */

std::string RegionShape::description(const Domain &domain, Region *region)
{
  std::string text = region->style;
  if (!region->interior) text += " side out";
  const std::vector<Region *> list = members(domain, region);
  for (std::size_t n = 0; n < list.size(); n++) text += (n == 0 ? " of " : ", ") + description(domain, list[n]);
  if (!list.empty() || !region->bboxflag) return text;
  double low[3], high[3];
  at_rest(region, low, high);
  for (int d = 0; d < 3; d++) {
    char range[80];
    if (region->varshape) snprintf(range, sizeof(range), " about %.10g", 0.5 * (low[d] + high[d]));
    else snprintf(range, sizeof(range), " %.10g %.10g", low[d], high[d]);
    text += range;
  }
  return region->dynamic_check() ? text + " moving" : text;
}
