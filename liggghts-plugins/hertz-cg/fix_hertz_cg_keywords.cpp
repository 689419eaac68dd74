/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix hertz/cg: its keywords, first of all those of the stock `pair_style gran model hertz` */

#include "hertz-cg/fix_hertz_cg.h"
#include "host/fix_arguments.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace LAMMPS_NS;
using namespace grainjet::contact;

namespace {

// one of several words, by its place among them
int choice(grainjet::FixArguments &in, const std::string &keyword, const std::vector<std::string> &words)
{
  std::string list;
  for (std::size_t n = 0; n < words.size(); ++n)
    list += (n ? (n + 1 < words.size() ? ", " : " or ") : "") + words[n];
  const std::string word = in.word("value after '" + keyword + "': " + list);
  for (std::size_t n = 0; n < words.size(); ++n)
    if (word == words[n]) return static_cast<int>(n);
  in.fail(keyword + " must be " + list + ", not '" + word + "'");
}

bool on(grainjet::FixArguments &in, const std::string &keyword)
{
  return choice(in, keyword, {"off", "on"}) == 1;
}

}

/* ---------------------------------------------------------------------- */

void FixHertzCg::parse_law(grainjet::FixArguments &in, const std::string &keyword)
{
  if (keyword == "model") choice(in, keyword, {"hertz"});
  else if (keyword == "surface") choice(in, keyword, {"default"});
  else if (keyword == "tangential")
    law_.tangential = std::vector<Tangential>{Tangential::HISTORY, Tangential::NO_HISTORY, Tangential::OFF}
      [choice(in, keyword, {"history", "no_history", "off"})];
  else if (keyword == "rolling" || keyword == "rolling_friction")
    law_.rolling = std::vector<Rolling>{Rolling::OFF, Rolling::CDT, Rolling::EPSD, Rolling::EPSD2}
      [choice(in, keyword, {"off", "cdt", "epsd", "epsd2"})];
  else if (keyword == "cohesion")
    law_.cohesion = std::vector<Cohesion>{Cohesion::OFF, Cohesion::SJKR, Cohesion::SJKR2}
      [choice(in, keyword, {"off", "sjkr", "sjkr2"})];
  else if (keyword == "torsionTorque") law_.torsion = on(in, keyword);
  else if (keyword == "limitForce") law_.limitForce = on(in, keyword);
  else if (keyword == "tangential_damping") law_.tangentialDamping = on(in, keyword);
  else if (keyword == "tangential_reduce") law_.tangentialReduce = on(in, keyword);
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::parse(int narg, char **arg)
{
  grainjet::FixArguments in(error, narg, arg);
  std::vector<std::string> given;
  while (in.more()) {
    const std::string keyword = in.keyword({"model", "surface", "tangential", "rolling", "rolling_friction", "torsionTorque",
      "limitForce", "tangential_damping", "cohesion", "tangential_reduce", "timestep_check", "overlap_check"});
    given.push_back(keyword);
    if (keyword == "timestep_check") {
      nevery = in.count("number of steps after 'timestep_check'");
      timestep_fraction_ = in.positive("fraction after 'timestep_check'", 1e-12, 1e12);
      timestep_error_ = choice(in, "timestep_check N fraction", {"warn", "error"}) == 1;
    } else if (keyword == "overlap_check") {
      overlap_fraction_ = in.positive("fraction after 'overlap_check'", 1e-12, 1e12);
    } else {
      parse_law(in, keyword);
    }
  }
  const auto stated = [&](const char *keyword) { return std::find(given.begin(), given.end(), keyword) != given.end(); };
  if (stated("rolling") && stated("rolling_friction"))
    in.fail("rolling and rolling_friction are the same keyword; state one of them");
  if (stated("model") && !stated("tangential"))
    in.fail("needs `tangential` after `model hertz`: left out it means off in pair_style gran, and history here");
  if (law_.torsion && law_.rolling == Rolling::OFF)
    in.fail("torsionTorque has a meaning only with rolling cdt, epsd or epsd2");
  if (law_.tangentialReduce && (law_.cohesion == Cohesion::OFF || law_.tangential == Tangential::OFF))
    in.fail("tangential_reduce has a meaning only with cohesion and with friction");
  if (!law_.tangentialDamping && law_.tangential == Tangential::OFF)
    in.fail("tangential_damping has a meaning only with friction");
}
