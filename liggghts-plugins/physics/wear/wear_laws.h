/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WEAR_LAWS_H
#define GRAINJET_WEAR_LAWS_H

#include "physics/wear/archard.h"
#include "physics/wear/dnv.h"
#include "physics/wear/ecrc.h"
#include "physics/wear/finnie.h"
#include "physics/wear/oka.h"

#include <memory>

namespace grainjet {
namespace wear {

/* All laws of wear with the names and coefficients by which scripts select them: the law's name, then pairs of keyword and
   value, as in `oka abrasive SiO2 hardness 1.8e9`. A new law is one header beside this one and one line here.

   coefficientWords: how many of the words behind a law's name belong to it. makeWearLaw: the law, or a
   std::invalid_argument that says what is wrong with name or coefficients.                            */
struct NamedWearLaw {
  const char *name;
  CoefficientList (*coefficients)();
  std::unique_ptr<WearLaw> (*make)(const Coefficients &);
};

template<class LAW>
std::unique_ptr<WearLaw> makeLaw(const Coefficients &coefficients)
{
  return std::make_unique<LAW>(coefficients);
}

constexpr NamedWearLaw WEAR_LAWS[] = {
  {"finnie", Finnie::coefficients, makeLaw<Finnie>},
  {"oka", Oka::coefficients, makeLaw<Oka>},
  {"dnv", Dnv::coefficients, makeLaw<Dnv>},
  {"ecrc", Ecrc::coefficients, makeLaw<Ecrc>},
  {"archard", Archard::coefficients, makeLaw<Archard>}
};

// "finnie, oka, ..." for messages and help
inline std::string wearLawNames()
{
  std::string names;
  for (const NamedWearLaw &law : WEAR_LAWS)
    names += (names.empty() ? "" : ", ") + std::string(law.name);
  return names;
}

inline const NamedWearLaw &findWearLaw(const std::string &name)
{
  for (const NamedWearLaw &law : WEAR_LAWS)
    if (name == law.name) return law;
  throw std::invalid_argument("unknown law of wear '" + name + "'; there are: " + wearLawNames());
}

// Words from `first` on that are coefficients of the law with their values: up to a keyword that is none of them
inline size_t coefficientWords(const std::string &law, const std::vector<std::string> &words, size_t first = 0)
{
  const CoefficientList known = findWearLaw(law).coefficients();
  size_t end = first;
  while (end < words.size() && findCoefficient(known, words[end])) end += 2;
  return std::min(end, words.size()) - first;
}

inline std::unique_ptr<WearLaw> makeWearLaw(const std::string &name, const std::vector<std::string> &words)
{
  const NamedWearLaw &law = findWearLaw(name);
  return law.make(Coefficients(name, law.coefficients(), words));
}

}
}

#endif
