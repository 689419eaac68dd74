/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_WEAR_COEFFICIENTS_H
#define GRAINJET_WEAR_COEFFICIENTS_H

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace grainjet {
namespace wear {

// A coefficient of a law: its keyword in scripts, what it is, its unit
struct Coefficient {
  const char *name;
  const char *meaning;
};

typedef std::vector<Coefficient> CoefficientList;

inline const Coefficient *findCoefficient(const CoefficientList &known, const std::string &name)
{
  const auto found = std::find_if(known.begin(), known.end(), [&](const Coefficient &c) { return name == c.name; });
  return found == known.end() ? nullptr : &*found;
}

// "hardness (Vickers, of the target, Pa), density (of the target, kg/m3)" for messages
inline std::string describe(const CoefficientList &known)
{
  std::string text;
  for (const Coefficient &c : known)
    text += (text.empty() ? "" : ", ") + std::string(c.name) + " (" + c.meaning + ")";
  return text;
}

/* Coefficients of one law as pairs of keyword and value. Whatever is wrong with them is a std::invalid_argument whose text
   names law, keyword and what belongs there.                                                       */
class Coefficients {
 public:

  Coefficients(const std::string &law, const CoefficientList &known, const std::vector<std::string> &words)
    : law_(law), known_(known)
  {
    for (size_t i = 0; i < words.size(); i += 2) {
      if (!findCoefficient(known_, words[i])) fail("unknown coefficient '" + words[i] + "'; it has " + describe(known_));
      if (i + 1 == words.size()) fail("coefficient '" + words[i] + "' has no value");
      if (!values_.emplace(words[i], words[i + 1]).second) fail("coefficient '" + words[i] + "' given twice");
    }
  }

  bool has(const std::string &name) const { return values_.count(name) > 0; }

  // A number above 0, which must be given
  double number(const std::string &name) const
  {
    if (!has(name)) fail("coefficient '" + name + "' missing: " + findCoefficient(known_, name)->meaning);
    const std::string &value = values_.at(name);
    char *end;
    const double number = std::strtod(value.c_str(), &end);
    if (value.empty() || *end || !std::isfinite(number) || number <= 0.0)
      fail("coefficient '" + name + "' must be a number above 0, not '" + value + "': " + findCoefficient(known_, name)->meaning);
    return number;
  }

  double number(const std::string &name, double standard) const { return has(name) ? number(name) : standard; }

  // A number between two bounds, whose violation is most often a wrong unit
  double between(const std::string &name, double least, double most) const
  {
    const double value = number(name);
    if (value < least || value > most)
      fail("coefficient '" + name + "' is " + values_.at(name) + ", outside of what the law is for: "
        + findCoefficient(known_, name)->meaning);
    return value;
  }

  // One of the names in a table, or nullptr if the coefficient is not given. ENTRY has a member `name`
  template<class ENTRY, size_t N>
  const ENTRY *preset(const std::string &name, const ENTRY (&table)[N]) const
  {
    if (!has(name)) return nullptr;
    std::string names;
    for (const ENTRY &entry : table) {
      if (values_.at(name) == entry.name) return &entry;
      names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    fail("'" + name + ' ' + values_.at(name) + "' is unknown; there are: " + names);
  }

  [[noreturn]] void fail(const std::string &what) const { throw std::invalid_argument("wear " + law_ + ": " + what); }

 private:

  std::string law_;
  CoefficientList known_;
  std::map<std::string, std::string> values_;
};

}
}

#endif
