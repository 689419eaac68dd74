/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_FIX_ARGUMENTS_H
#define GRAINJET_FIX_ARGUMENTS_H

#include "error.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace grainjet {

/* Reads the arguments of a fix from left to right. Anything missing or malformed ends
   the run with one message that names the style, the fix ID and the keyword. LIGGGHTS'
   own Force::numeric takes "1e" or "-" for a number and names neither.               */
class FixArguments {
 public:

  // the arguments from position `next` on
  FixArguments(LAMMPS_NS::Error *error, int narg, char **arg, int next = 3)
    : error_(error), narg_(narg), arg_(arg), next_(next) {}

  bool more() const { return next_ < narg_; }

  // the next word as it stands; `what` says what is expected there
  std::string word(const std::string &what)
  {
    if (!more()) fail("missing " + what);
    return arg_[next_++];
  }

  double number(const std::string &what)
  {
    const std::string text = word(what);
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value))
      fail("'" + text + "' is not a number; expected " + what);
    return value;
  }

  double positive(const std::string &what)
  {
    const double value = number(what);
    if (!(value > 0.0)) fail(what + " must be > 0, not " + arg_[next_ - 1]);
    return value;
  }

  double nonNegative(const std::string &what)
  {
    const double value = number(what);
    if (!(value >= 0.0)) fail(what + " must be >= 0, not " + arg_[next_ - 1]);
    return value;
  }

  // a whole number >= 1
  int count(const std::string &what)
  {
    const double value = number(what);
    if (value < 1.0 || value > 1e9 || value != std::floor(value))
      fail(what + " must be a whole number >= 1, not " + arg_[next_ - 1]);
    return static_cast<int>(value);
  }

  bool yesNo(const std::string &what)
  {
    const std::string text = word(what + " yes or no");
    if (text != "yes" && text != "no") fail(what + " must be yes or no, not '" + text + "'");
    return text == "yes";
  }

  // every rank reads the same script and so comes here together
  [[noreturn]] void fail(const std::string &message) const
  {
    const std::string full =
      std::string("Fix ") + arg_[2] + " (ID " + arg_[0] + "): " + message;
    error_->all(FLERR, full.c_str());
    std::abort();    // never reached: Error::all ends the program
  }

 private:

  LAMMPS_NS::Error *error_;
  int narg_;
  char **arg_;
  int next_;
};

}

#endif
