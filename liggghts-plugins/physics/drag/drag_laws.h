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

/* All drag laws with the names by which users select them: as written in an input script
   of LIGGGHTS and as written in a dictionary of OpenFOAM. A new law is one header beside
   this one and one line here.                                                        */
struct NamedLaw {
  const char *script;      // gidaspow
  const char *dictionary;  // Gidaspow
  Law law;
};

constexpr NamedLaw LAWS[] = {
  {"gidaspow", "Gidaspow", gidaspow},
  {"wenYu", "WenYu", wenYu},
  {"ergun", "Ergun", ergun},
  {"schillerNaumann", "SchillerNaumann", schillerNaumann},
  {"stokes", "Stokes", stokes},
  {"diFelice", "DiFelice", diFelice},
  {"kochHill", "KochHill", kochHill},
  {"beetstra", "Beetstra", beetstra}
};

// the spelling to look up or to list
typedef const char *NamedLaw::*Spelling;

// The law of that name, or nullptr.  findLaw("Gidaspow", &NamedLaw::dictionary)
inline Law findLaw(const std::string &name, Spelling spelling)
{
  for (const NamedLaw &entry : LAWS)
    if (name == entry.*spelling) return entry.law;
  return nullptr;
}

// "gidaspow, wenYu, ..." for messages and help
inline std::string lawNames(Spelling spelling)
{
  std::string names;
  for (const NamedLaw &entry : LAWS)
    names += (names.empty() ? "" : ", ") + std::string(entry.*spelling);
  return names;
}

}
}

#endif
