/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_OUTPUT_FILE_H
#define GRAINJET_OUTPUT_FILE_H

#include <cstdio>
#include <string>

namespace grainjet {

/* Rules for a file that is known by its first line: what exists and is something else is
   never overwritten. For one process; all functions return an empty string, or what is
   wrong, and change nothing unless they say so.                                      */
namespace OutputFile {

  // there is nothing at this path, or a regular file
  std::string check_kind(const std::string &path);

  // There is nothing at this path, or a file that begins with this line. owner: the style of the
  // fix that writes it. cut: the line may be cut off, as a killed run leaves it. A table of the same
  // fix may have columns of temperature or not: grains have got one since, or none any more.
  std::string check_own(const std::string &path, const std::string &line, const std::string &owner,
    bool cut = false);

  // No file of this process but `except` is open there: the input script, the log, what
  // another command writes
  std::string check_open(const std::string &path, FILE *except = nullptr);

  // a file could be created there
  std::string check_folder(const std::string &path);

  // Both are the same file, however they are written, or would be. A star stands for the digits of
  // any step, in either.
  bool same(const std::string &, const std::string &);

  // where replace() keeps the text until it is whole
  std::string temporary(const std::string &path);

  // The text takes the place of the file in one piece, so a reader never sees half of it. If
  // that has become a file of somebody else it stays, and the text is left beside it; `left`
  // says so.
  std::string replace(const std::string &path, const std::string &line, const std::string &owner,
    const std::string &text, bool &left);

}

}

#endif
