/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_DRAG_LAWS_H
#define GRAINJET_DRAG_LAWS_H

#include "physics/drag/beetstra.h"
#include "physics/drag/di_felice.h"
#include "physics/drag/drag_state.h"
#include "physics/drag/ergun.h"
#include "physics/drag/gidaspow.h"
#include "physics/drag/koch_hill.h"
#include "physics/drag/schiller_naumann.h"
#include "physics/drag/stokes.h"
#include "physics/drag/wen_yu.h"

#include <string>

namespace grainjet {
namespace drag {

/* All drag laws with the names by which scripts of LIGGGHTS select them. A new law is one
   header beside this one and one line here. For the coupling, one line more in
   openfoam-libs/liggghtsCoupling/forces/standardDragLaws.C.                          */
struct NamedLaw {
  const char *name;
  Law law;
};

constexpr NamedLaw LAWS[] = {
  {"gidaspow", gidaspow},
  {"wenYu", wenYu},
  {"ergun", ergun},
  {"schillerNaumann", schillerNaumann},
  {"stokes", stokes},
  {"diFelice", diFelice},
  {"kochHill", kochHill},
  {"beetstra", beetstra}
};

// The law of that name, or nullptr
inline Law findLaw(const std::string &name)
{
  for (const NamedLaw &entry : LAWS)
    if (name == entry.name) return entry.law;
  return nullptr;
}

// "gidaspow, wenYu, ..." for messages and help
inline std::string lawNames()
{
  std::string names;
  for (const NamedLaw &entry : LAWS)
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  return names;
}

}
}

#endif
