/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_FIX_ARGUMENTS_H
#define GRAINJET_FIX_ARGUMENTS_H

#include "error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

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

  // the words that are not read yet
  std::vector<std::string> rest() const { return std::vector<std::string>(arg_ + next_, arg_ + narg_); }

  // The next word, which has to be one of the keywords, each of which may come once.
  std::string keyword(const std::vector<std::string> &valid)
  {
    const std::string text = word("keyword");
    if (std::find(valid.begin(), valid.end(), text) == valid.end()) {
      std::string list;
      for (const std::string &name : valid) list += (list.empty() ? "" : ", ") + name;
      fail("unknown keyword '" + text + "'; valid keywords are " + list);
    }
    if (std::find(given_.begin(), given_.end(), text) != given_.end())
      fail("keyword " + text + " is given twice; state it once");
    given_.push_back(text);
    return text;
  }

  // A number between the limits. The widest ones leave room for products of some numbers
  // before they overflow and make forces that are no numbers.
  double number(const std::string &what, double least = -LARGEST, double most = LARGEST)
  {
    if (!more()) fail("missing " + after("number", what));
    const std::string text = word(what);
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || std::isnan(value))
      fail("'" + text + "' is not a number; expected " + what);
    if (!(value >= least && value <= most))
      fail(what + " must be a number from " + print(least) + " to " + print(most) + ", not " + text);
    return value;
  }

  double positive(const std::string &what, double least = 1.0 / LARGEST, double most = LARGEST)
  {
    const double value = number(what, -HUGE_VAL, HUGE_VAL);
    if (!(value > 0.0))
      fail(what + " must be > 0" + (least > 0.0 ? ", from " + print(least) + " to " : " and at most ") + print(most)
        + ", not " + arg_[next_ - 1]);
    if (!(value >= least && value <= most))
      fail(what + " must be from " + print(least) + " to " + print(most) + ", not " + arg_[next_ - 1]);
    return value;
  }

  double nonNegative(const std::string &what, double most = LARGEST)
  {
    const double value = number(what, -HUGE_VAL, HUGE_VAL);
    if (!(value >= 0.0 && value <= most))
      fail(what + " must be >= 0 and at most " + print(most) + ", not " + arg_[next_ - 1]);
    return value;
  }

  // a whole number >= 1; `most` keeps a slip of the pen from taking all memory or time
  int count(const std::string &what, int most = 1000000000)
  {
    const double value = number(what, -HUGE_VAL, HUGE_VAL);
    if (!(value >= 1.0 && value <= most) || value != std::floor(value))
      fail(what + " must be a whole number >= 1 and at most " + std::to_string(most) + ", not " + arg_[next_ - 1]);
    return static_cast<int>(value);
  }

  bool yesNo(const std::string &what)
  {
    if (!more()) fail("missing " + after("word yes or no", what));
    const std::string text = word(what);
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

  static constexpr double LARGEST = 1e30;

  LAMMPS_NS::Error *error_;
  int narg_;
  char **arg_;
  int next_;
  std::vector<std::string> given_;

  // what is expected: if `what` is the keyword that was read last, a value of a kind after it
  std::string after(const std::string &kind, const std::string &what) const
  {
    return next_ > 0 && what == arg_[next_ - 1] ? "the " + kind + " after " + what : what;
  }

  static std::string print(double value)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%g", value);
    return text;
  }
};

}

#endif
